// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NodePlaces_h
#define hachure_NodePlaces_h

#include "Span.h"
#include "SurfaceCells.h"
#include "TriangleMesh.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// Where the nodes of a surface's cells lie on its triangles.
namespace hachure
{

struct NodePlace
{
  std::int32_t triangle = -1; // of the mesh
  glm::vec2 weights{ 0.0f };  // of its second and third corner
};

// Of every node of every level, in the order of the cells' nodes. A node on which no triangle lies,
// as the surface ends before, has the closest place in its chart; -1 where no triangle reaches the
// chart. Throws std::invalid_argument for a wrong mesh and cells of another one.
std::vector<NodePlace> nodePlaces(const TriangleMesh& mesh, const SurfaceCells& cells);

// Of the nodes of a level of 2^subdivisions segments, as Kernels/ViewCells.glsl numbers them: the
// weights of the chart's second and third corner there.
std::vector<glm::vec2> nodeCoordinates(int subdivisions);

namespace detail
{
// A triangle as the chart sees it, also one of another chart that reaches over its rim.
struct ChartTriangle
{
  std::int32_t chart;
  std::int32_t triangle;
  std::array<glm::vec2, 3> places;
};

// By chart: own triangles first, then those of other charts; both ascend.
struct ChartTriangles
{
  std::vector<std::size_t> first; // of every chart, and the number of all
  std::vector<ChartTriangle> triangles;

  Span<const ChartTriangle> of(std::size_t chart) const
  {
    return Span<const ChartTriangle>(this->triangles)
      .subspan(this->first[chart], this->first[chart + 1] - this->first[chart]);
  }
};

ChartTriangles chartTriangles(const SurfaceCells& cells);
} // namespace detail

} // namespace hachure

#endif

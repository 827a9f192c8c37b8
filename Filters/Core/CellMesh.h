// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_CellMesh_h
#define hachure_CellMesh_h

#include "CellLayers.h"
#include "NodePlaces.h"
#include "Span.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

// The cells of a level as triangles whose corners lie on the surface (the id meshes of Grimm and
// Kowalski 2002, section 4.1), and the lines between some of them.
namespace hachure
{

struct CellMesh
{
  std::vector<glm::dvec3> points;
  // Of every cell of the layer, turning as its chart does; -1: no triangle of the surface reaches
  // the chart.
  std::vector<glm::ivec3> triangles;
};

// places: nodePlaces() of the mesh and the layer's cells. Corners in one place of a chart are one
// point, and those of charts next to each other too; but where cells of one side are larger, only
// every other corner of the smaller ones is. Throws std::invalid_argument for another number of
// places.
CellMesh cellMesh(const TriangleMesh& mesh, const CellLayer& layer, Span<const NodePlace> places);

// An edge, or the half of one that has two smaller cells on its other side.
struct CellBorder
{
  std::array<std::int32_t, 2> points; // of the cell mesh
  std::array<std::int32_t, 2> cells;  // on both sides, ascending
};

// All edges between cells of different labels. Throws std::invalid_argument where there is not one
// label for every cell of the mesh.
std::vector<CellBorder> cellBorders(
  const CellLayer& layer, const CellMesh& mesh, Span<const std::int32_t> labels);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleEdges_h
#define hachure_StippleEdges_h

#include "Span.h"
#include "StippleHierarchy.h"
#include "StippleShape.h"
#include "StippleThresholds.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// Classic stipples with the edges to their relevant neighbours, where the surface is now; all by
// rank.
class StippleEdges
{
public:
  StippleEdges() = default;
  // Points of stippleSurface(reference) in the order Classic. The mesh is copied. Throws
  // std::invalid_argument for a bad mesh, points that are not on it, and neighbours that are none.
  StippleEdges(const TriangleMesh& reference, StippleHierarchy classic);

  // Moves the mesh: as many points as the reference has. Throws std::invalid_argument for another
  // number of points, and numbers that are not finite.
  void setPositions(Span<const glm::dvec3> points);

  std::size_t size() const { return this->allPlaces.size(); }
  Span<const glm::dvec3> places() const { return this->allPlaces; }
  Span<const glm::vec3> normals() const { return this->allNormals; } // of unit length, or 0
  // Area of the reference over that now; infinite where there is none now.
  Span<const float> areaRatios() const { return this->ratios; }
  Span<const std::int32_t> neighbours(std::size_t rank) const
  {
    const std::size_t first = this->hierarchy.firstNeighbour[rank];
    return { this->hierarchy.neighbours.data() + first,
      this->hierarchy.firstNeighbour[rank + 1] - first };
  }
  const StippleEdgeLengths& lengths() const { return this->edgeLengths; }
  std::size_t memory() const; // bytes held

private:
  void place();

  StippleShape shape{ TriangleMesh{} };
  StippleHierarchy hierarchy; // without the triangles
  StippleEdgeLengths edgeLengths;
  std::vector<glm::dvec3> allPlaces;
  std::vector<glm::vec3> allNormals;
  std::vector<float> ratios;
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleShape_h
#define hachure_StippleShape_h

#include "Span.h"
#include "StippleNode.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// What the points of a tree are on, a mesh or given points: where it was at first, and is now.
class StippleShape
{
public:
  explicit StippleShape(const TriangleMesh& mesh);
  StippleShape(Span<const glm::dvec3> points, Span<const glm::dvec3> normals);

  bool hasMesh() const { return this->isMesh; }
  bool isMoved() const { return !this->present.empty(); }
  std::size_t pointCount() const { return this->reference.size(); }
  Span<const glm::dvec3> referencePoints() const { return this->reference; }
  // Number of triangles, or of points without a mesh.
  std::size_t size() const
  {
    return this->isMesh ? this->triangles.size() : this->reference.size();
  }
  TriangleMesh referenceMesh() const { return { this->reference, this->triangles, {} }; }

  void move(Span<const glm::dvec3> points, Span<const glm::dvec3> someNormals);

  glm::dvec3 referencePlace(const StipplePlace& place) const
  {
    return this->placeIn(this->reference, place);
  }
  glm::dvec3 presentPlace(const StipplePlace& place) const
  {
    return this->placeIn(this->isMoved() ? this->present : this->reference, place);
  }
  // Of unit length, or 0.
  glm::vec3 referenceNormal(std::int32_t triangle) const; // of a mesh
  glm::vec3 presentNormal(std::int32_t triangle) const;
  // Reference area / present area; infinite where there is no present area.
  double densityRatio(std::int32_t triangle) const;

  std::size_t memory() const;

private:
  glm::dvec3 placeIn(const std::vector<glm::dvec3>& points, const StipplePlace& place) const
  {
    if (!this->isMesh)
    {
      return points[static_cast<std::size_t>(place.triangle)];
    }
    const glm::ivec3 ids = this->triangles[static_cast<std::size_t>(place.triangle)];
    const glm::dvec3& first = points[static_cast<std::size_t>(ids.x)];
    return first + place.second() * (points[static_cast<std::size_t>(ids.y)] - first) +
      place.third() * (points[static_cast<std::size_t>(ids.z)] - first);
  }
  glm::dvec3 areaVector(const std::vector<glm::dvec3>& points, std::int32_t triangle) const;

  bool isMesh;
  std::vector<glm::dvec3> reference, present; // present: empty as long as nothing moved
  std::vector<glm::dvec3> normals;            // of points without a mesh, or empty
  std::vector<glm::ivec3> triangles;
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleParticles_h
#define hachure_StippleParticles_h

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// A triangle mesh that changes: the particle mesh of the paper. Triangles may meet in any number at
// an edge.
class StippleParticles
{
public:
  StippleParticles(std::vector<glm::dvec3> places, std::vector<glm::ivec3> triangles);

  std::vector<glm::dvec3> places;
  std::vector<glm::ivec3> triangles; // first corner -1: none any more

  // Calls visit(triangle) for those around a vertex.
  template <class Visit>
  void visitTriangles(std::int32_t vertex, Visit&& visit) const
  {
    std::int32_t corner = this->first[static_cast<std::size_t>(vertex)];
    while (corner >= 0)
    {
      const std::int32_t following = this->next[static_cast<std::size_t>(corner)];
      visit(corner / 3);
      corner = following;
    }
  }
  const glm::ivec3& triangle(std::int32_t index) const
  {
    return this->triangles[static_cast<std::size_t>(index)];
  }
  const glm::dvec3& place(std::int32_t vertex) const
  {
    return this->places[static_cast<std::size_t>(vertex)];
  }
  double length(std::int32_t a, std::int32_t b) const
  {
    return glm::length(this->place(a) - this->place(b));
  }
  glm::dvec3 areaVector(std::int32_t index) const
  {
    const glm::ivec3& corners = this->triangle(index);
    return glm::cross(this->place(corners.y) - this->place(corners.x),
      this->place(corners.z) - this->place(corners.x));
  }
  // The vertices around a vertex, ascending.
  void neighbours(std::int32_t vertex, std::vector<std::int32_t>& result) const;
  // The triangles at an edge.
  void trianglesAt(std::int32_t a, std::int32_t b, std::vector<std::int32_t>& result) const;

  // Splits all triangles at the edge in two by a new vertex, and returns it.
  std::int32_t split(std::int32_t a, std::int32_t b, const glm::dvec3& place);
  // `gone` becomes `kept`; triangles that have both are no more.
  void collapse(std::int32_t gone, std::int32_t kept);

private:
  void link(std::int32_t triangle, int corner);
  void unlink(std::int32_t triangle, int corner);

  std::vector<std::int32_t> first; // per vertex: a corner there
  std::vector<std::int32_t> next;  // per corner: the next at the same vertex, or -1
  std::vector<std::int32_t> found;
};

// The third corner of a triangle.
inline std::int32_t oppositeCorner(const glm::ivec3& triangle, std::int32_t a, std::int32_t b)
{
  return triangle.x != a && triangle.x != b ? triangle.x
    : triangle.y != a && triangle.y != b    ? triangle.y
                                            : triangle.z;
}

} // namespace hachure

#endif

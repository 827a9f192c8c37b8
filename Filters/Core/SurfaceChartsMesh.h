// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsMesh_h
#define hachure_SurfaceChartsMesh_h

#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

// Internal: the mesh that surfaceCells() simplifies.
namespace hachure
{

// Triangles with the same orientation on both sides of every edge, whose vertices each have one fan
// of triangles around them. Where a surface is not like that it is cut open. A corner is
// 3 * triangle + (0, 1, 2).
struct CornerMesh
{
  static constexpr std::int32_t border = -1;
  static constexpr std::int32_t cut = -2; // of three triangles, or of two that are oriented unlike

  std::vector<glm::dvec3> positions;   // of vertices
  std::vector<std::int32_t> points;    // of vertices: equal where the surface was cut apart
  std::vector<char> isBorder;          // vertices at a border or a cut
  std::vector<char> isFrozen;          // vertices at a cut
  std::vector<std::int32_t> cornerAt;  // of vertices: one of theirs, the first one at borders
  std::vector<std::int32_t> vertices;  // of corners; -1: the triangle is gone
  std::vector<std::int32_t> opposites; // of corners: that across the edge, or border or cut

  // All triangles, oriented alike, as they were at first.
  std::vector<glm::ivec3> fine;
  // Of the triangles that it was made from: their corners' vertices, as they were given; -1 for
  // degenerate ones. Copies of a triangle share its vertices.
  std::vector<glm::ivec3> sources;

  static std::int32_t next(std::int32_t corner)
  {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  static std::int32_t previous(std::int32_t corner)
  {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }
  std::int32_t vertex(std::int32_t corner) const
  {
    return this->vertices[static_cast<std::size_t>(corner)];
  }
  std::int32_t opposite(std::int32_t corner) const
  {
    return this->opposites[static_cast<std::size_t>(corner)];
  }
  const glm::dvec3& position(std::int32_t vertex) const
  {
    return this->positions[static_cast<std::size_t>(vertex)];
  }
  // The next corner around a vertex, counter-clockwise and clockwise; negative at a border.
  std::int32_t after(std::int32_t corner) const
  {
    const std::int32_t across = this->opposite(next(corner));
    return across < 0 ? across : next(across);
  }
  std::int32_t before(std::int32_t corner) const
  {
    const std::int32_t across = this->opposite(previous(corner));
    return across < 0 ? across : previous(across);
  }
  // The first one around a vertex: at the border, else the given one.
  std::int32_t firstCorner(std::int32_t corner) const;
  std::size_t triangleCount() const { return this->vertices.size() / 3; }
};

// The triangles with the first one of all points that are in the same place, up to a billionth of
// the mesh's size.
std::vector<glm::ivec3> joinedTriangles(const TriangleMesh& mesh);

CornerMesh makeCornerMesh(const TriangleMesh& mesh);

// The triangles around a vertex, counter-clockwise: `ends` are the vertices that edges lead to, one
// more than triangles at a border.
struct VertexRing
{
  std::vector<std::int32_t> corners;
  std::vector<std::int32_t> ends;
  bool isClosed = false;

  // Of a vertex that has triangles.
  void find(const CornerMesh& mesh, std::int32_t vertex);
};

} // namespace hachure

#endif

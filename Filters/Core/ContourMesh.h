// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ContourMesh_h
#define hachure_ContourMesh_h

#include "Span.h"
#include "TriangleMesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// One side of a mesh edge: that of a triangle. Corners and the half-edges that run from them to the
// next corner have the number 3 * triangle + 0, 1 or 2.
struct ContourHalfEdge
{
  std::int32_t low = 0, high = 0; // vertices
  std::int32_t corner = 0;

  bool operator<(const ContourHalfEdge& other) const
  {
    return this->low != other.low ? this->low < other.low
      : this->high != other.high  ? this->high < other.high
                                  : this->corner < other.corner;
  }
};

// A surface in view space, with points of one place joined, without repeated triangles and such
// that have no area or a corner that is not finite. Seams whose two sides differ by rounding alone
// are closed.
class ContourMesh
{
public:
  using Edge = Span<const ContourHalfEdge>; // all half-edges between two vertices

  ContourMesh(const TriangleMesh& mesh, const glm::dmat4& modelToView);

  static std::int32_t nextCorner(std::int32_t corner)
  {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }

  std::size_t vertexCount() const { return this->positions.size(); }
  std::size_t cornerCount() const { return 3 * this->triangles.size(); }
  std::int32_t vertexOf(std::int32_t corner) const
  {
    return this->triangles[corner / 3][corner % 3];
  }
  const glm::dvec3& position(std::int32_t vertex) const { return this->positions[vertex]; }
  const glm::dvec3& placeOf(std::int32_t corner) const
  {
    return this->positions[this->vertexOf(corner)];
  }
  // Of unit length; neighbours across edges of two triangles agree on the outer side where they can
  // be made to. The first triangle of a connected piece keeps the side that it came with.
  const glm::dvec3& faceNormal(std::int32_t corner) const { return this->faceNormals[corner / 3]; }
  double angleAt(std::int32_t corner) const;

  // Two half-edges of one edge whose triangles do not agree on the outer side.
  bool isTwisted(const ContourHalfEdge& a, const ContourHalfEdge& b) const
  {
    const bool sameWay = this->vertexOf(a.corner) == this->vertexOf(b.corner);
    return sameWay != (this->isTurned[a.corner / 3] != this->isTurned[b.corner / 3]);
  }

  // The corner of a half-edge's triangle at one of its ends.
  std::int32_t lowCorner(const ContourHalfEdge& half) const
  {
    return this->vertexOf(half.corner) == half.low ? half.corner : nextCorner(half.corner);
  }
  std::int32_t highCorner(const ContourHalfEdge& half) const
  {
    return this->vertexOf(half.corner) == half.low ? nextCorner(half.corner) : half.corner;
  }

  template <class Body>
  void eachEdge(Body&& body) const
  {
    for (std::size_t begin = 0; begin < this->halfEdges.size();)
    {
      std::size_t end = begin + 1;
      while (end < this->halfEdges.size() &&
        this->halfEdges[end].low == this->halfEdges[begin].low &&
        this->halfEdges[end].high == this->halfEdges[begin].high)
      {
        ++end;
      }
      body(Edge(this->halfEdges).subspan(begin, end - begin));
      begin = end;
    }
  }

private:
  void addTriangles(const TriangleMesh& mesh, const std::vector<std::int32_t>& vertices);
  void removeRepeated();
  void closeSeams(double width);
  std::vector<std::int32_t> borderVertices() const;
  void renameVertices(const std::vector<std::int32_t>& names);
  void addHalfEdges();
  void turnTriangles();
  void addFaceNormals();

  std::vector<glm::dvec3> positions; // per vertex
  std::vector<glm::ivec3> triangles;
  std::vector<glm::dvec3> faceNormals;
  std::vector<char> isTurned; // per triangle: its normal is not that of its corners' order
  std::vector<ContourHalfEdge> halfEdges; // sorted
};

} // namespace hachure

#endif

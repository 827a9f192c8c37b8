// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_VertexGraph_h
#define hachure_VertexGraph_h

#include "Span.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

// A surface as its vertices see it, for fields of which every vertex has a value.
namespace hachure
{
/// The vertex at the other end of an edge.
struct VertexNeighbour
{
  std::int32_t vertex = 0;
  float weight = 0.0f; ///< cotangent weight, above 0
  float bend = 0.0f;   ///< angle between the normals of the two sides, above 0 on a convex edge
};

/// Vertices, at which points of one position are joined, and the triangles between them. Lengths
/// are in units of `size`, so that neither tiny nor huge surfaces leave the range of a number.
struct VertexGraph
{
  double size = 1.0;                 ///< of the longest side of the bounds, units of the mesh
  double meanEdge = 0.0;             ///< mean length of a triangle's side
  double area = 0.0;                 ///< of all triangles
  std::vector<glm::dvec3> positions; ///< per vertex, from the middle of the bounds
  std::vector<glm::dvec3> normals;   ///< per vertex, of unit length; 0: no triangle, no tangents
  std::vector<double> areas;         ///< per vertex, a third of the triangles around it
  /// All with an area, each set of three vertices once; neighbours are oriented alike where they
  /// can be, most of them as they came.
  std::vector<glm::ivec3> triangles;
  std::vector<std::int32_t> sources;       ///< per triangle: its number in the mesh
  std::vector<glm::dvec3> triangleNormals; ///< of unit length
  std::vector<std::size_t> cornerOffsets;  ///< triangles around a vertex, in corners
  std::vector<std::int32_t> corners;       ///< triangles, ascending around each vertex
  std::vector<std::size_t> neighbourOffsets;
  std::vector<VertexNeighbour> neighbours; ///< ascending around each vertex

  std::size_t vertexCount() const { return this->positions.size(); }
  Span<const std::int32_t> trianglesAt(std::size_t vertex) const
  {
    const std::size_t begin = this->cornerOffsets[vertex];
    return Span<const std::int32_t>(this->corners)
      .subspan(begin, this->cornerOffsets[vertex + 1] - begin);
  }
  Span<const VertexNeighbour> neighboursOf(std::size_t vertex) const
  {
    const std::size_t begin = this->neighbourOffsets[vertex];
    return Span<const VertexNeighbour>(this->neighbours)
      .subspan(begin, this->neighbourOffsets[vertex + 1] - begin);
  }
};

/// `vertices`: the vertex of every point, as from joinPoints. Throws std::invalid_argument as
/// checkFaceSurface does.
VertexGraph makeVertexGraph(const TriangleMesh& mesh, Span<const std::int32_t> vertices);
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfacePatchesMesh_h
#define hachure_SurfacePatchesMesh_h

#include "Span.h"
#include "TriangleMesh.h"

#include <cstdint>
#include <vector>

// What patches are made of: faces, which polygons were cut into triangles from, and vertices, at
// which points that lie in one place are joined.
namespace hachure
{
/// A triangle surface with faces and vertices; it owns nothing. Triangles without area belong to
/// their face like all others, so that what they hold together stays together.
struct FaceSurface
{
  TriangleMesh mesh;
  /// Face of every triangle: from 0 on, ascending without a gap. Empty: every triangle is a face.
  Span<const std::int32_t> faces;
  /// Vertex of every point, from 0 on. Empty: every point is a vertex.
  Span<const std::int32_t> vertices;

  std::int32_t faceOf(std::size_t triangle) const
  {
    return faces.empty() ? static_cast<std::int32_t>(triangle) : faces[triangle];
  }
  glm::ivec3 verticesOf(std::size_t triangle) const
  {
    const glm::ivec3 corners = mesh.triangles[triangle];
    return vertices.empty()
      ? corners
      : glm::ivec3(vertices[corners.x], vertices[corners.y], vertices[corners.z]);
  }
  std::int32_t faceCount() const
  {
    return mesh.triangles.empty() ? 0 : faceOf(mesh.triangles.size() - 1) + 1;
  }
  std::int32_t vertexCount() const;
};

/// Throws std::invalid_argument as checkTriangleMesh does, and on faces or vertices of another
/// number than the triangles or points, faces with gaps and negative vertices.
void checkFaceSurface(const FaceSurface& surface);

/// The vertex of every point: equal coordinates in the same group are one vertex, numbered by first
/// appearance. Groups keep apart what must not be joined; empty: all one group.
std::vector<std::int32_t> joinPoints(
  Span<const glm::dvec3> points, Span<const std::int32_t> groups = {});

/// An edge between two faces.
struct FaceNeighbour
{
  std::int32_t face = 0;
  bool turned = false; ///< the two faces run the same way along the edge: one is turned over
};

/// The faces across the edges of every face. Where more than two faces meet in an edge, all are
/// neighbours of each other. Edges within a face are left out.
class FaceGraph
{
public:
  explicit FaceGraph(const FaceSurface& surface);

  Span<const FaceNeighbour> neighbours(std::int32_t face) const
  {
    const std::size_t begin = this->offsets[face];
    return Span<const FaceNeighbour>(this->entries).subspan(begin, this->offsets[face + 1] - begin);
  }

private:
  std::vector<std::size_t> offsets;
  std::vector<FaceNeighbour> entries;
};

/// Size and place of a face.
struct FaceShape
{
  glm::dvec3 centroid{ 0.0 }; ///< of its corners where it has no area
  glm::dvec3 normal{ 0.0 };   ///< unit length; 0 where it has no area
  double area = 0.0;
};

std::vector<FaceShape> faceShapes(const FaceSurface& surface);

/// Disjoint sets of the numbers from 0 on. The lowest number of a set stands for it.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count);
  std::int32_t find(std::int32_t item);
  void join(std::int32_t first, std::int32_t second);

private:
  std::vector<std::int32_t> parents;
};
} // namespace hachure

#endif

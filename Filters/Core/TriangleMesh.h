// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TriangleMesh_h
#define hachure_TriangleMesh_h

#include "Span.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure
{
/// A view of an indexed triangle surface; it owns nothing. Nothing is asked of its connectivity:
/// borders, non-manifold edges, repeated and zero-area triangles are all allowed.
struct TriangleMesh
{
  Span<const glm::dvec3> points;
  Span<const glm::ivec3> triangles;
  /// Patch id per triangle; empty means that all triangles are in patch 0. A triangle with a
  /// negative id belongs to no patch.
  Span<const std::int32_t> patches;
};

/// Throws std::invalid_argument naming the first bad argument and its value: a triangle corner that
/// is not a point, a non-finite corner, or a patch array of another length than the triangles.
void checkTriangleMesh(const TriangleMesh& mesh);

/// Twice the area times the unit normal, (b - a) x (c - a).
glm::dvec3 triangleAreaVector(const TriangleMesh& mesh, std::int64_t triangle);

/// True when the triangle has no area, up to rounding: it has no normal and takes no samples.
bool isDegenerateTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Signed volume enclosed by the triangles, positive when the normals of a closed surface point
/// outward. For an open surface it is taken about the centre of its bounding box.
double signedVolume(const TriangleMesh& mesh);

/// Whether the surface is nearly closed and its triangles face inward. Only a closed surface tells
/// outside from inside: a relief keeps its normals, whatever its shape.
bool isInsideOut(const TriangleMesh& mesh);
} // namespace hachure

#endif

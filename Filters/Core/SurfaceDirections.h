// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceDirections_h
#define hachure_SurfaceDirections_h

#include "Span.h"
#include "SurfaceCurvature.h"
#include "SurfaceSampling.h"
#include "VertexGraph.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// Tangents for strokes all over a surface. They are lines: a direction and its opposite are the
// same. Estimates are line vectors (TangentFrame.h) in the frame of each vertex, with the
// reliability, 0 to 1, as length; lines across them are their negatives. Smoothing carries them
// from one tangent plane to the next.
namespace hachure
{
/// Which principal direction. By magnitude, a bulge and a groove have the same lines, and nothing
/// depends on what side of the surface is outside.
enum class CurvatureLine
{
  LargestMagnitude,
  SmallestMagnitude,
  Largest, ///< signed
  Smallest
};

/// Reliable where the two curvatures (or, by magnitude, their magnitudes) differ by about as much
/// as the surface bends in the disc: not on spheres, planes and noise.
std::vector<glm::dvec2> curvatureLines(
  const VertexGraph& graph, Span<const VertexCurvature> curvatures, CurvatureLine which);

/// Lines along the gradient of a number at every point of the mesh. Triangles with a value that is
/// not finite are left out. Reliable where the gradients of the triangles around agree and are not
/// much smaller than the range of values by the size.
std::vector<glm::dvec2> gradientLines(
  const VertexGraph& graph, const TriangleMesh& mesh, Span<const double> scalars);

/// Lines along the tangential parts of vectors, of the points, joined to vertices, or of the
/// triangles of the mesh, by their areas. Lengths do not count; vectors that are 0 or not finite
/// are left out. Reliable where vectors lie in the surface and agree.
std::vector<glm::dvec2> pointVectorLines(
  const VertexGraph& graph, Span<const std::int32_t> vertices, Span<const glm::dvec3> vectors);
std::vector<glm::dvec2> triangleVectorLines(
  const VertexGraph& graph, Span<const glm::dvec3> vectors);

struct SmoothingOptions
{
  /// How often the line vector of a vertex becomes the mean of itself and its neighbours, by their
  /// cotangent weights; 0 or more. As lengths are reliabilities, reliable lines reach into places
  /// of none.
  int iterations = 20;
  /// Lines where nothing is known at all: the axis projected to the surface. 0: that coordinate
  /// axis along which the surface is longest.
  glm::dvec3 axis{ 0.0 };
  ProgressFn progress;
};

struct DirectionField
{
  /// Unit tangents; 0 at vertices without triangles. Of both signs that one which agrees with most
  /// neighbours: the sign jumps only where it must.
  std::vector<glm::dvec3> directions;
  /// 0 where a direction was only taken over from others or from the axis.
  std::vector<double> reliabilities;
};

/// Smooths, then fills what is still without a direction from around, ring by ring; pieces of a
/// surface where nothing is known take the axis. Returns empty arrays when `progress` stopped the
/// work. Throws std::invalid_argument for another number of lines than vertices, a negative number
/// of iterations and an axis that is not finite.
DirectionField smoothDirections(
  const VertexGraph& graph, Span<const glm::dvec2> lines, const SmoothingOptions& options);

/// The field at the points of the mesh. With normals per point (empty: none), directions are turned
/// into the plane across each, so that points of a seam have a tangent each. 0 at points that are
/// no corner of a triangle.
DirectionField directionsAtPoints(const VertexGraph& graph, const TriangleMesh& mesh,
  Span<const std::int32_t> vertices, const DirectionField& field,
  Span<const glm::dvec3> normals = {});
} // namespace hachure

#endif

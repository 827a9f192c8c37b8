// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceCurvature_h
#define hachure_SurfaceCurvature_h

#include "SurfaceSampling.h"
#include "VertexGraph.h"

#include <glm/vec3.hpp>

#include <vector>

// Principal curvatures of triangle surfaces that may be noisy and irregular.
//
// The curvature tensor is a measure on the edges (Cohen-Steiner and Morvan, Restricted Delaunay
// triangulations and normal cycle, 2003): an edge of direction e and length l whose two sides meet
// at the angle b contributes b l e e^T; the tensor of a region is the sum over its edges by its
// area. The sum telescopes: noise of a vertex inside the region adds bends that cancel, so that
// only noise near its border remains, and no derivative of a normal is ever taken. Of its three
// eigenvectors one is the normal; the other two are the principal directions, each with the
// curvature of the other one.
namespace hachure
{
struct VertexCurvature
{
  double largest = 0.0;  ///< signed; above 0 where the surface bends away from its normal
  double smallest = 0.0; ///< signed, at most the largest
  /// Direction of the largest, a tangent of unit length without sign; 0 where there is none.
  glm::dvec3 direction{ 0.0 };
  /// Mean curvature, over the vertices of the disc, without sign: far above the difference of the
  /// two where the directions in the disc disagree.
  double bending = 0.0;
};

struct CurvatureOptions
{
  /// Of the disc over which curvature is averaged, units of the mesh, 0 or more. 0: as far as the
  /// edges around a vertex reach. The disc is what hangs together within a ball, weighted by
  /// 1 - (distance / radius)^2. It is made larger at vertices whose edges reach farther.
  double radius = 0.0;
  ProgressFn progress;
};

/// The radius of a disc of a few rings of triangles of mean size, units of the mesh.
double defaultCurvatureRadius(const VertexGraph& graph);

/// Curvatures of all vertices, in units of 1 / mesh unit; 0 at vertices without triangles. The time
/// grows with the number of vertices in a disc. Returns an empty result when `progress` stopped the
/// work. Throws std::invalid_argument for a radius that is negative or not finite.
std::vector<VertexCurvature> vertexCurvatures(
  const VertexGraph& graph, const CurvatureOptions& options);
} // namespace hachure

#endif

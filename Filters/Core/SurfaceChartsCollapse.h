// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsCollapse_h
#define hachure_SurfaceChartsCollapse_h

#include "SurfaceChartsMesh.h"
#include "SurfaceSampling.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

// Internal: surfaceCells() simplifies a mesh to triangles of about equal areas and follows where
// its vertices lie on them, as Lee et al. 1998 (MAPS: multiresolution adaptive parameterization of
// surfaces) do. Half an edge is collapsed at a time: one end becomes the other, and the hole around
// it is a fan of triangles from there. The old and the new triangles are laid over each other in
// the plane, where the angles around the vertex are scaled to a full turn.
namespace hachure
{

// Of a vertex that is gone: where it is on the triangles that are left.
struct VertexHome
{
  std::int32_t triangle = -1; // -1: it is one of their corners
  glm::dvec2 weights{ 0.0 };  // of the triangle's second and third corner
};

struct BaseMesh
{
  CornerMesh mesh;               // only triangles that are left have vertices
  std::vector<VertexHome> homes; // of vertices
  std::vector<double> areas;     // of triangles: of the surface that belongs to them, roughly
  bool isStopped = false;        // by the progress function
};

struct CollapseOptions
{
  std::int64_t triangles = 144; // wanted
  double area = 1.0;            // wanted, of each of them
  ProgressFn progress;
};

BaseMesh collapseToBase(CornerMesh mesh, const CollapseOptions& options);

} // namespace hachure

#endif

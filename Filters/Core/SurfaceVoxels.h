// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceVoxels_h
#define hachure_SurfaceVoxels_h

// Cuts triangles along the planes of a voxel grid. The pieces, in the order of a space-filling
// curve through the voxels, say how much surface there is where, whatever the triangulation.

#include "Span.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace hachure
{
/// The convex part of one triangle in one voxel, or a triangle of its fan.
struct SurfaceFragment
{
  std::uint64_t voxel;   ///< Morton code of the voxel
  std::int32_t triangle; ///< index into the triangles given
  std::int32_t corners;  ///< index into VoxelisedSurface::corners, or -1 for the whole triangle
  double area;
};

struct VoxelisedSurface
{
  std::vector<SurfaceFragment> fragments;         ///< sorted by voxel, then by triangle
  std::vector<std::array<glm::dvec3, 3>> corners; ///< barycentric coordinates in the triangle
};

using TriangleCorners = std::array<glm::dvec3, 3>;

/// Number of voxels along an axis that a Morton code can tell apart.
constexpr double maximumVoxelsPerAxis = 1 << 21;

/// Cuts the triangles by the grid of cubes of the given side, one corner of which is the origin.
/// All corners must be at or above the origin and within maximumVoxelsPerAxis voxels of it.
VoxelisedSurface voxeliseSurface(
  Span<const TriangleCorners> triangles, const glm::dvec3& origin, double side);
} // namespace hachure

#endif

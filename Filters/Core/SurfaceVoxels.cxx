// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceVoxels.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

namespace hachure
{
namespace
{
/// A convex polygon inside a triangle, as barycentric coordinates. Two planes per axis cut off at
/// most one corner each: 3 + 6 corners.
struct ClippedPolygon
{
  std::array<glm::dvec3, 9> corners;
  int count = 0;

  void append(const glm::dvec3& corner)
  {
    assert(count < static_cast<int>(corners.size()));
    corners[count++] = corner;
  }
};

/// Keeps the part where sign * (coordinate - level) >= 0; the coordinate is linear in the
/// barycentric ones, with the values given at the three corners.
ClippedPolygon clipPolygon(
  const ClippedPolygon& polygon, const glm::dvec3& values, double level, double sign)
{
  ClippedPolygon result;
  for (int i = 0; i < polygon.count; ++i)
  {
    const glm::dvec3& here = polygon.corners[i];
    const glm::dvec3& next = polygon.corners[(i + 1) % polygon.count];
    const double heightHere = sign * (glm::dot(values, here) - level);
    const double heightNext = sign * (glm::dot(values, next) - level);
    if (heightHere >= 0.0)
    {
      result.append(here);
    }
    if ((heightHere >= 0.0) != (heightNext >= 0.0))
    {
      result.append(glm::mix(here, next, heightHere / (heightHere - heightNext)));
    }
  }
  return result;
}

/// Spreads the low 21 bits so that two zero bits follow each of them.
std::uint64_t spreadBits(std::uint64_t value)
{
  value &= 0x1fffffull;
  value = (value | value << 32) & 0x001f00000000ffffull;
  value = (value | value << 16) & 0x001f0000ff0000ffull;
  value = (value | value << 8) & 0x100f00f00f00f00full;
  value = (value | value << 4) & 0x10c30c30c30c30c3ull;
  value = (value | value << 2) & 0x1249249249249249ull;
  return value;
}

/// Cuts one triangle after the other, axis by axis.
class TriangleVoxeliser
{
public:
  TriangleVoxeliser(VoxelisedSurface& target, const glm::dvec3& gridOrigin, double voxelSide)
    : result(target)
    , origin(gridOrigin)
    , side(voxelSide)
  {
  }

  void add(std::int32_t index, const TriangleCorners& corners)
  {
    triangle = index;
    area = 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    if (!(area > 0.0))
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 3; ++i)
      {
        values[axis][i] = (corners[i][axis] - origin[axis]) / side;
      }
    }
    ClippedPolygon whole;
    whole.append(glm::dvec3(1.0, 0.0, 0.0));
    whole.append(glm::dvec3(0.0, 1.0, 0.0));
    whole.append(glm::dvec3(0.0, 0.0, 1.0));
    cut(whole, 0, 0, true);
  }

private:
  void cut(const ClippedPolygon& polygon, int axis, std::uint64_t code, bool isWhole)
  {
    if (axis == 3)
    {
      emit(polygon, code, isWhole);
      return;
    }
    double low = glm::dot(values[axis], polygon.corners[0]);
    double high = low;
    for (int i = 1; i < polygon.count; ++i)
    {
      const double value = glm::dot(values[axis], polygon.corners[i]);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    const std::int64_t first = voxelIndex(low);
    const std::int64_t last = voxelIndex(high);
    for (std::int64_t index = first; index <= last; ++index)
    {
      const std::uint64_t next = code | spreadBits(static_cast<std::uint64_t>(index)) << axis;
      if (first == last)
      {
        cut(polygon, axis + 1, next, isWhole);
        continue;
      }
      const double level = static_cast<double>(index);
      ClippedPolygon slab =
        index > first ? clipPolygon(polygon, values[axis], level, 1.0) : polygon;
      slab = index < last ? clipPolygon(slab, values[axis], level + 1.0, -1.0) : slab;
      if (slab.count >= 3)
      {
        cut(slab, axis + 1, next, false);
      }
    }
  }

  static std::int64_t voxelIndex(double value)
  {
    const double clamped = std::min(std::max(value, 0.0), maximumVoxelsPerAxis - 1.0);
    return static_cast<std::int64_t>(clamped);
  }

  void emit(const ClippedPolygon& polygon, std::uint64_t voxel, bool isWhole)
  {
    if (isWhole)
    {
      result.fragments.push_back({ voxel, triangle, -1, area });
      return;
    }
    for (int i = 2; i < polygon.count; ++i)
    {
      const std::array<glm::dvec3, 3> corners{ polygon.corners[0], polygon.corners[i - 1],
        polygon.corners[i] };
      // The determinant of three barycentric corners is their share of the triangle's area.
      const double share = glm::dot(corners[0], glm::cross(corners[1], corners[2]));
      if (share > 0.0)
      {
        const std::int32_t slot = static_cast<std::int32_t>(result.corners.size());
        result.corners.push_back(corners);
        result.fragments.push_back({ voxel, triangle, slot, area * share });
      }
    }
  }

  VoxelisedSurface& result;
  const glm::dvec3 origin;
  const double side;
  std::int32_t triangle = 0;
  double area = 0.0;
  std::array<glm::dvec3, 3> values; // in voxels, per axis: the coordinate at the three corners
};
} // namespace

VoxelisedSurface voxeliseSurface(
  Span<const TriangleCorners> triangles, const glm::dvec3& origin, double side)
{
  if (!(side > 0.0) || !std::isfinite(side))
  {
    throw std::invalid_argument("side: " + std::to_string(side) + " is not a positive length");
  }
  VoxelisedSurface result;
  result.fragments.reserve(triangles.size());
  TriangleVoxeliser voxeliser(result, origin, side);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(triangles.size()); ++i)
  {
    voxeliser.add(i, triangles[i]);
  }
  std::sort(result.fragments.begin(), result.fragments.end(),
    [](const SurfaceFragment& a, const SurfaceFragment& b) {
      return std::tie(a.voxel, a.triangle, a.corners) < std::tie(b.voxel, b.triangle, b.corners);
    });
  return result;
}
} // namespace hachure

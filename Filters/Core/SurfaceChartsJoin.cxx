// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsMesh.h"

#include "SurfacePatchesMesh.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}
} // namespace

std::vector<glm::ivec3> joinedTriangles(const TriangleMesh& mesh)
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-std::numeric_limits<double>::max());
  for (const glm::ivec3& corners : mesh.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      low = glm::min(low, mesh.points[indexOf(corners[corner])]);
      high = glm::max(high, mesh.points[indexOf(corners[corner])]);
    }
  }
  constexpr double steps = 1e9; // along the longest side of the bounds
  const glm::dvec3 size = high - low;
  const double longest = std::max(std::max(size.x, size.y), size.z);
  const double scale = longest > 0.0 ? steps / longest : 1.0;
  std::vector<glm::dvec3> rounded(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), rounded.begin(),
    [&](const glm::dvec3& point) { return glm::round(scale * (point - low)); });
  const std::vector<std::int32_t> vertices = joinPoints(rounded);
  std::vector<std::int32_t> first; // of every vertex
  first.reserve(vertices.size());
  for (std::size_t point = 0; point < vertices.size(); ++point)
  {
    if (indexOf(vertices[point]) == first.size())
    {
      first.push_back(static_cast<std::int32_t>(point));
    }
  }
  const auto firstAt = [&](std::int32_t point) { return first[indexOf(vertices[indexOf(point)])]; };
  std::vector<glm::ivec3> triangles(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), triangles.begin(),
    [&](const glm::ivec3& corners)
    { return glm::ivec3(firstAt(corners.x), firstAt(corners.y), firstAt(corners.z)); });
  return triangles;
}

} // namespace hachure

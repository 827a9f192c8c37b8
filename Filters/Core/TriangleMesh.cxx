// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleMesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
bool isFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}
} // namespace

void checkTriangleMesh(const TriangleMesh& mesh)
{
  const std::int64_t triangleCount = static_cast<std::int64_t>(mesh.triangles.size());
  const std::int64_t pointCount = static_cast<std::int64_t>(mesh.points.size());
  if (!mesh.patches.empty() && mesh.patches.size() != mesh.triangles.size())
  {
    throw std::invalid_argument("mesh.patches: " + std::to_string(mesh.patches.size()) +
      " values for " + std::to_string(triangleCount) + " triangles");
  }
  for (std::int64_t i = 0; i < triangleCount; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int id = mesh.triangles[i][corner];
      if (id < 0 || id >= pointCount)
      {
        throw std::invalid_argument("mesh.triangles[" + std::to_string(i) + "]: corner " +
          std::to_string(id) + " is not one of the " + std::to_string(pointCount) + " points");
      }
      if (!isFinite(mesh.points[id]))
      {
        throw std::invalid_argument(
          "mesh.points[" + std::to_string(id) + "]: a coordinate is not finite");
      }
    }
  }
}

glm::dvec3 triangleAreaVector(const TriangleMesh& mesh, std::int64_t triangle)
{
  const glm::ivec3 corners = mesh.triangles[triangle];
  const glm::dvec3 a = mesh.points[corners.x];
  return glm::cross(mesh.points[corners.y] - a, mesh.points[corners.z] - a);
}

bool isDegenerateTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  // Below this height to length ratio the normal is rounding noise.
  const double smallestRatio = 1e-12;
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 bc = c - b;
  const glm::dvec3 size = glm::max(glm::abs(ab), glm::max(glm::abs(ac), glm::abs(bc)));
  const double scale = glm::max(size.x, glm::max(size.y, size.z));
  // Scaled, so that neither very small nor very large coordinates leave the range of a double.
  return !(scale > 0.0) || !std::isfinite(scale) ||
    !(glm::length(glm::cross(ab / scale, ac / scale)) > smallestRatio);
}

double signedVolume(const TriangleMesh& mesh)
{
  if (mesh.triangles.empty())
  {
    return 0.0;
  }
  glm::dvec3 low = mesh.points[mesh.triangles[0].x];
  glm::dvec3 high = low;
  for (const glm::ivec3& corners : mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      low = glm::min(low, mesh.points[corners[i]]);
      high = glm::max(high, mesh.points[corners[i]]);
    }
  }
  const glm::dvec3 centre = 0.5 * (low + high);
  double sixVolumes = 0.0;
  for (const glm::ivec3& corners : mesh.triangles)
  {
    const glm::dvec3 a = mesh.points[corners.x] - centre;
    sixVolumes +=
      glm::dot(a, glm::cross(mesh.points[corners.y] - centre, mesh.points[corners.z] - centre));
  }
  return sixVolumes / 6.0;
}

bool isInsideOut(const TriangleMesh& mesh)
{
  // The area vectors of a closed surface add up to zero. A scan cut off at the border of its volume
  // misses a few per cent of its area.
  const double largestOpening = 0.1;
  glm::dvec3 sum(0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const glm::dvec3 vector = triangleAreaVector(mesh, static_cast<std::int64_t>(i));
    sum += vector;
    area += glm::length(vector);
  }
  return glm::length(sum) < largestOpening * area && signedVolume(mesh) < 0.0;
}
} // namespace hachure

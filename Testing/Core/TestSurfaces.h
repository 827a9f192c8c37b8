// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TestSurfaces_h
#define hachure_TestSurfaces_h

// Small surfaces for the tests of surface algorithms.

#include "SurfaceSampling.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace hachure
{
struct Surface
{
  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;
  std::vector<std::int32_t> patches;

  TriangleMesh mesh() const { return { points, triangles, patches }; }
  glm::dvec3 position(const SurfaceSamples& samples, std::size_t i) const
  {
    const glm::ivec3 corners = triangles[samples.triangles[i]];
    const glm::dvec3 weights = samples.barycentrics[i];
    return weights.x * points[corners.x] + weights.y * points[corners.y] +
      weights.z * points[corners.z];
  }
};

/// Appends a parallelogram of n x n quads. With an exponent other than 1 the rows get denser
/// towards one side, so that the triangulation says nothing about the area.
inline void addGrid(Surface& surface, glm::dvec3 origin, glm::dvec3 u, glm::dvec3 v, int n,
  double exponent = 1.0, int patch = 0)
{
  const int first = static_cast<int>(surface.points.size());
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const double s = std::pow(static_cast<double>(i) / n, exponent);
      surface.points.push_back(origin + s * u + static_cast<double>(j) / n * v);
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int a = first + i * (n + 1) + j;
      surface.triangles.push_back({ a, a + n + 1, a + n + 2 });
      surface.triangles.push_back({ a, a + n + 2, a + 1 });
      surface.patches.insert(surface.patches.end(), 2, patch);
    }
  }
}
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TestSurfaces_h
#define hachure_TestSurfaces_h

// Small surfaces for the tests of surface algorithms.

#include "Random.h"
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

/// Appends a grid of rows x columns quads that is closed where it is asked to be; place(s, t) of
/// [0,1]^2 tells its points.
template <class Place>
void addSheet(
  Surface& surface, int rows, int columns, bool closesRows, bool closesColumns, Place&& place)
{
  const int first = static_cast<int>(surface.points.size());
  const int height = closesRows ? rows : rows + 1;
  const int width = closesColumns ? columns : columns + 1;
  for (int i = 0; i < height; ++i)
  {
    for (int j = 0; j < width; ++j)
    {
      surface.points.push_back(
        place(static_cast<double>(i) / rows, static_cast<double>(j) / columns));
    }
  }
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const int above = first + i * width;
      const int below = first + (i + 1) % height * width;
      const int right = (j + 1) % width;
      surface.triangles.push_back({ above + j, below + j, below + right });
      surface.triangles.push_back({ above + j, below + right, above + right });
    }
  }
}

/// Appends a sphere of rings x 2 rings quads, its axis z; the poles are points that fall together.
/// noise: of the radius, to each side.
inline void addSphere(
  Surface& surface, const glm::dvec3& centre, double radius, int rings, double noise = 0.0)
{
  constexpr double pi = 3.14159265358979323846;
  addSheet(surface, rings, 2 * rings, false, true,
    [&](double s, double t)
    {
      const bool isPole = s == 0.0 || s == 1.0;
      const double side = isPole ? 0.0 : std::sin(pi * s);
      const double wave = isPole ? 0.0 : unitRandom(1, surface.points.size(), 0) - 0.5;
      const glm::dvec3 direction(
        side * std::cos(2.0 * pi * t), side * std::sin(2.0 * pi * t), std::cos(pi * s));
      return centre + radius * (1.0 + 2.0 * noise * wave) * direction;
    });
}

/// Appends a torus around the z axis of rings x 2 rings quads.
inline void addTorus(Surface& surface, double radius, double tube, int rings)
{
  constexpr double twoPi = 6.28318530717958647692;
  addSheet(surface, rings, 2 * rings, true, true,
    [&](double s, double t)
    {
      const double distance = radius + tube * std::cos(twoPi * s);
      return glm::dvec3(distance * std::cos(twoPi * t), distance * std::sin(twoPi * t),
        -tube * std::sin(twoPi * s));
    });
}
} // namespace hachure

#endif

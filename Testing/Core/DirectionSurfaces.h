// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_DirectionSurfaces_h
#define hachure_DirectionSurfaces_h

// Surfaces with known principal directions, and how far a field is from them.

#include "Random.h"
#include "SurfaceDirections.h"
#include "SurfacePatchesMesh.h"
#include "TestSurfaces.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace hachure
{
constexpr double pi = 3.14159265358979323846;

/// A grid over (u, v) in the unit square, mapped by `shape`. Irregular: parameters are moved by up
/// to 0.24 cells and every quad is cut along either diagonal. Directions that are closed run from 0
/// to 1 and have their first points in place of the last.
struct ParameterGrid
{
  int columns = 60;
  int rows = 60;
  bool isClosed[2] = { true, true };
  bool isIrregular = false;
  double noise = 0.0; // standard deviation along the normal, as a share of the mean edge
};

struct ParameterSurface
{
  Surface surface;
  std::vector<glm::dvec2> parameters; // per point

  std::size_t size() const { return this->parameters.size(); }
};

inline double gaussian(std::uint64_t id)
{
  const double u = 1.0 - unitRandom(7, id, 4);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * pi * unitRandom(7, id, 5));
}

inline void addNoise(Surface& surface, double share)
{
  std::vector<glm::dvec3> normals(surface.points.size(), glm::dvec3(0.0));
  double edges = 0.0;
  for (const glm::ivec3& c : surface.triangles)
  {
    const glm::dvec3 a = surface.points[c.x], b = surface.points[c.y], d = surface.points[c.z];
    for (int k = 0; k < 3; ++k)
    {
      normals[c[k]] += glm::cross(b - a, d - a);
    }
    edges += glm::distance(a, b) + glm::distance(b, d) + glm::distance(d, a);
  }
  const double deviation = share * edges / (3.0 * static_cast<double>(surface.triangles.size()));
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    surface.points[i] += deviation * gaussian(i) * glm::normalize(normals[i]);
  }
}

inline ParameterSurface makeGrid(
  const ParameterGrid& grid, const std::function<glm::dvec3(glm::dvec2)>& shape)
{
  ParameterSurface result;
  const int columns = grid.columns + (grid.isClosed[0] ? 0 : 1);
  const int rows = grid.rows + (grid.isClosed[1] ? 0 : 1);
  const auto move = [&](int i, int last, bool isClosed, std::uint64_t id, std::uint32_t axis)
  {
    const bool isEnd = !isClosed && (i == 0 || i == last);
    return grid.isIrregular && !isEnd ? 0.48 * (unitRandom(7, id, axis) - 0.5) : 0.0;
  };
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      const std::uint64_t id = result.parameters.size();
      result.parameters.push_back(
        { (i + move(i, columns - 1, grid.isClosed[0], id, 0)) / grid.columns,
          (j + move(j, rows - 1, grid.isClosed[1], id, 1)) / grid.rows });
      result.surface.points.push_back(shape(result.parameters.back()));
    }
  }
  for (int i = 0; i < grid.columns; ++i)
  {
    for (int j = 0; j < grid.rows; ++j)
    {
      const int a = i * rows + j;
      const int b = (i + 1) % columns * rows + j;
      const int c = (i + 1) % columns * rows + (j + 1) % rows;
      const int d = i * rows + (j + 1) % rows;
      const bool turned = grid.isIrregular && unitRandom(7, static_cast<std::uint64_t>(a), 2) < 0.5;
      result.surface.triangles.push_back(turned ? glm::ivec3(a, b, d) : glm::ivec3(a, b, c));
      result.surface.triangles.push_back(turned ? glm::ivec3(b, c, d) : glm::ivec3(a, c, d));
    }
  }
  if (grid.noise > 0.0)
  {
    addNoise(result.surface, grid.noise);
  }
  return result;
}

/// A torus about z, of this radius of its tube and 1 of its centre line.
inline ParameterSurface makeTorus(const ParameterGrid& grid, double tube = 0.4)
{
  return makeGrid(grid,
    [tube](glm::dvec2 p)
    {
      const double u = 2.0 * pi * p.x, v = 2.0 * pi * p.y;
      const double r = 1.0 + tube * std::cos(v);
      return glm::dvec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    });
}

/// The tangent along v of the torus: across it is the direction of smaller curvature.
inline glm::dvec3 torusTube(glm::dvec2 p)
{
  const double u = 2.0 * pi * p.x, v = 2.0 * pi * p.y;
  return { -std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v) };
}

/// Degrees between two lines.
inline double lineAngle(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b))) * 180.0 / pi;
}

inline double quantile(std::vector<double> values, double share)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleSurface.h"

#include "ParallelSort.h"
#include "Random.h"
#include "StippleCells.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace hachure
{

namespace
{

// A hash, and what has it.
struct Hashed
{
  std::uint64_t hash;
  std::int64_t item;

  bool operator<(const Hashed& other) const
  {
    return this->hash != other.hash ? this->hash < other.hash : this->item < other.item;
  }
};

std::uint64_t bitsOf(double value)
{
  const double positive = value + 0.0; // -0 and 0 are one place
  std::uint64_t bits = 0;
  std::memcpy(&bits, &positive, sizeof(bits));
  return bits;
}

// Points in one place are one, whatever their numbers.
std::uint64_t placeHash(const glm::dvec3& place)
{
  return hashPair(bitsOf(place.x), hashPair(bitsOf(place.y), bitsOf(place.z)));
}

std::array<std::uint64_t, 3> cornerHashes(const TriangleMesh& mesh, std::int32_t triangle)
{
  const glm::ivec3 ids = mesh.triangles[static_cast<std::size_t>(triangle)];
  return { placeHash(mesh.points[static_cast<std::size_t>(ids.x)]),
    placeHash(mesh.points[static_cast<std::size_t>(ids.y)]),
    placeHash(mesh.points[static_cast<std::size_t>(ids.z)]) };
}

// The same whichever corner is the first, another one for the back.
std::uint64_t triangleHash(const TriangleMesh& mesh, std::int32_t triangle)
{
  const std::array<std::uint64_t, 3> corners = cornerHashes(mesh, triangle);
  return hashPair(corners[0], corners[1]) + hashPair(corners[1], corners[2]) +
    hashPair(corners[2], corners[0]);
}

bool hasArea(const TriangleMesh& mesh, std::size_t triangle)
{
  const glm::ivec3 ids = mesh.triangles[triangle];
  return !isDegenerateTriangle(mesh.points[static_cast<std::size_t>(ids.x)],
    mesh.points[static_cast<std::size_t>(ids.y)], mesh.points[static_cast<std::size_t>(ids.z)]);
}

StippleFrame frameOf(const glm::dvec3& low, const glm::dvec3& high)
{
  StippleFrame frame;
  const double size = glm::length(0.5 * high - 0.5 * low) * 2.0;
  if (size > 0.0 && std::isfinite(size))
  {
    frame.middle = 0.5 * low + 0.5 * high;
    frame.size = size;
  }
  return frame;
}

StippleFrame frameOf(const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles)
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-std::numeric_limits<double>::max());
  for (const std::int32_t triangle : triangles)
  {
    const glm::ivec3 ids = mesh.triangles[static_cast<std::size_t>(triangle)];
    for (int corner = 0; corner < 3; ++corner)
    {
      low = glm::min(low, mesh.points[static_cast<std::size_t>(ids[corner])]);
      high = glm::max(high, mesh.points[static_cast<std::size_t>(ids[corner])]);
    }
  }
  return triangles.empty() ? StippleFrame() : frameOf(low, high);
}

// Along a curve through cells so small that neighbours on it are neighbours in space.
void sortAlongCurve(StippleSurface& surface)
{
  const StippleGrid grid(1.0 / 4096.0);
  std::vector<Hashed> sorted(surface.triangles.size());
  parallelFor(static_cast<std::int64_t>(sorted.size()),
    [&](std::int64_t i)
    {
      const std::int32_t triangle = surface.triangles[static_cast<std::size_t>(i)];
      const std::array<glm::dvec3, 3> corners = surface.corners(triangle);
      const glm::vec3 middle((corners[0] + corners[1] + corners[2]) / 3.0);
      sorted[static_cast<std::size_t>(i)] = { grid.nameOf(middle), triangle };
    });
  parallelSort(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    surface.triangles[i] = static_cast<std::int32_t>(sorted[i].item);
  }
}

void sumAreas(StippleSurface& surface)
{
  surface.areaBefore.assign(surface.triangles.size() + 1, 0.0);
  parallelFor(static_cast<std::int64_t>(surface.triangles.size()),
    [&surface](std::int64_t i)
    {
      const auto index = static_cast<std::size_t>(i);
      const std::array<glm::dvec3, 3> corners = surface.corners(surface.triangles[index]);
      surface.areaBefore[index + 1] =
        0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    });
  std::partial_sum(
    surface.areaBefore.begin(), surface.areaBefore.end(), surface.areaBefore.begin());
}

StippleBorder borderOf(const StippleSurface& surface, std::int64_t side)
{
  const auto triangle = static_cast<std::int32_t>(side / 3);
  const std::array<glm::dvec3, 3> corners = surface.corners(triangle);
  StippleBorder border;
  border.ends[0] = glm::vec3(corners[static_cast<std::size_t>(side % 3)]);
  border.ends[1] = glm::vec3(corners[static_cast<std::size_t>((side + 1) % 3)]);
  border.normal =
    glm::vec3(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
  return border;
}

void findBorders(StippleSurface& surface)
{
  std::vector<Hashed> sides(3 * surface.triangles.size());
  parallelFor(static_cast<std::int64_t>(surface.triangles.size()),
    [&](std::int64_t i)
    {
      const std::int32_t triangle = surface.triangles[static_cast<std::size_t>(i)];
      const std::array<std::uint64_t, 3> corners = cornerHashes(surface.mesh, triangle);
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        const std::uint64_t both = corners[corner] + corners[(corner + 1) % 3];
        sides[3 * static_cast<std::size_t>(i) + corner] = { hashMix(both),
          3 * static_cast<std::int64_t>(triangle) + static_cast<std::int64_t>(corner) };
      }
    });
  parallelSort(sides);
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const bool isShared = (i > 0 && sides[i - 1].hash == sides[i].hash) ||
      (i + 1 < sides.size() && sides[i + 1].hash == sides[i].hash);
    if (!isShared)
    {
      surface.borders.push_back(borderOf(surface, sides[i].item));
      surface.openSides.push_back(sides[i].item);
    }
  }
}

} // namespace

std::vector<std::int32_t> distinctTriangles(const TriangleMesh& mesh)
{
  std::vector<Hashed> sorted(mesh.triangles.size());
  std::vector<char> isKept(mesh.triangles.size());
  parallelFor(static_cast<std::int64_t>(sorted.size()),
    [&](std::int64_t i)
    {
      const auto index = static_cast<std::size_t>(i);
      sorted[index] = { triangleHash(mesh, static_cast<std::int32_t>(i)), i };
      isKept[index] = hasArea(mesh, index) ? 1 : 0;
    });
  parallelSort(sorted);
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i].hash == sorted[i - 1].hash)
    {
      isKept[static_cast<std::size_t>(sorted[i].item)] = 0;
    }
  }
  std::vector<std::int32_t> result;
  result.reserve(isKept.size());
  for (std::size_t i = 0; i < isKept.size(); ++i)
  {
    if (isKept[i] != 0)
    {
      result.push_back(static_cast<std::int32_t>(i));
    }
  }
  return result;
}

StippleFrame stippleFrame(Span<const glm::dvec3> points)
{
  if (points.empty())
  {
    return StippleFrame();
  }
  glm::dvec3 low = points.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& point : points)
  {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return frameOf(low, high);
}

StippleSurface makeStippleSurface(const TriangleMesh& mesh)
{
  StippleSurface surface;
  surface.mesh = mesh;
  surface.triangles = distinctTriangles(mesh);
  surface.frame = frameOf(mesh, surface.triangles);
  if (surface.frame.size == 0.0)
  {
    surface.triangles.clear();
  }
  sortAlongCurve(surface);
  sumAreas(surface);
  findBorders(surface);
  return surface;
}

} // namespace hachure

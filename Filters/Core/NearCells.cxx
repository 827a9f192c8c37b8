// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearCells.h"

#include "Random.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace hachure
{
namespace
{
void check(Span<const glm::dvec3> points, const PolygonCells& cells, Span<const std::uint8_t> owned,
  double distance)
{
  if (static_cast<std::int64_t>(owned.size()) != cells.count())
  {
    throw std::invalid_argument("owned: " + std::to_string(owned.size()) + " cells, expected " +
      std::to_string(cells.count()));
  }
  if (!(distance >= 0.0) || !std::isfinite(distance))
  {
    throw std::invalid_argument(
      "distance: " + std::to_string(distance) + ", expected a finite number of at least 0");
  }
  for (const std::int64_t corner : cells.corners)
  {
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= points.size())
    {
      throw std::invalid_argument("cells: corner " + std::to_string(corner) + ", expected one of " +
        std::to_string(points.size()) + " points");
    }
  }
}

std::uint64_t hashOf(const glm::dvec3& place)
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &place[axis], sizeof(bits));
    hash = hashPair(hash, bits);
  }
  return hash;
}

template <class Body>
void forEachCorner(const PolygonCells& cells, const Body& body)
{
  for (std::int64_t cell = 0; cell < cells.count(); ++cell)
  {
    const auto index = static_cast<std::size_t>(cell);
    for (std::int64_t i = cells.offsets[index]; i < cells.offsets[index + 1]; ++i)
    {
      body(index, static_cast<std::size_t>(cells.corners[static_cast<std::size_t>(i)]));
    }
  }
}

// Places where cells of the part and others meet.
std::vector<glm::dvec3> bordersOf(
  Span<const glm::dvec3> points, const PolygonCells& cells, Span<const std::uint8_t> owned)
{
  constexpr unsigned ofPart = 1;
  constexpr unsigned ofOthers = 2;
  constexpr unsigned known = 4;
  std::unordered_map<std::uint64_t, unsigned> users;
  std::vector<glm::dvec3> borders;
  forEachCorner(cells,
    [&](std::size_t cell, std::size_t corner)
    {
      unsigned& user = users[hashOf(points[corner])];
      user |= owned[cell] != 0 ? ofPart : ofOthers;
      if (user == (ofPart | ofOthers))
      {
        user |= known;
        borders.push_back(points[corner]);
      }
    });
  return borders;
}

// Places by cubes as large as the distance.
class Cubes
{
public:
  Cubes(const std::vector<glm::dvec3>& places, double reach)
    : distance(reach)
  {
    for (const glm::dvec3& place : places)
    {
      this->cubes[this->keyOf(this->cubeOf(place))].push_back(place);
    }
  }

  bool isNear(const glm::dvec3& point) const
  {
    const glm::dvec3 middle = this->cubeOf(point);
    for (int i = 0; i < 27; ++i)
    {
      const glm::dvec3 cube = middle + glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const auto found = this->cubes.find(this->keyOf(cube));
      if (found != this->cubes.end() && this->isAnyNear(found->second, point))
      {
        return true;
      }
    }
    return false;
  }

private:
  glm::dvec3 cubeOf(const glm::dvec3& place) const
  {
    return this->distance > 0.0 ? glm::floor(place / this->distance) : place;
  }
  std::uint64_t keyOf(const glm::dvec3& cube) const { return hashOf(cube + glm::dvec3(0.0)); }
  bool isAnyNear(const std::vector<glm::dvec3>& places, const glm::dvec3& point) const
  {
    for (const glm::dvec3& place : places)
    {
      if (glm::distance(place, point) <= this->distance)
      {
        return true;
      }
    }
    return false;
  }

  double distance;
  std::unordered_map<std::uint64_t, std::vector<glm::dvec3>> cubes;
};
} // namespace

std::vector<std::int64_t> nearCells(Span<const glm::dvec3> points, const PolygonCells& cells,
  Span<const std::uint8_t> owned, double distance)
{
  check(points, cells, owned, distance);
  const Cubes cubes(bordersOf(points, cells, owned), distance);
  std::vector<std::int8_t> tried(points.size(), -1); // 1: near
  std::vector<std::int64_t> found;
  forEachCorner(cells,
    [&](std::size_t cell, std::size_t corner)
    {
      const bool open =
        owned[cell] == 0 && (found.empty() || found.back() != static_cast<std::int64_t>(cell));
      if (open && tried[corner] < 0)
      {
        tried[corner] = cubes.isNear(points[corner]) ? 1 : 0;
      }
      if (open && tried[corner] == 1)
      {
        found.push_back(static_cast<std::int64_t>(cell));
      }
    });
  return found;
}

} // namespace hachure

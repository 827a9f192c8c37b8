// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleTriangles.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hachure
{

namespace
{

// Triangles in a box, and boxes in the next: neighbours along a curve through space.
constexpr std::int32_t fanOut = 4;

std::size_t at(std::int64_t index)
{
  return static_cast<std::size_t>(index);
}

glm::vec3 roundedDown(const glm::dvec3& place)
{
  constexpr float lowest = -std::numeric_limits<float>::infinity();
  glm::vec3 result(place);
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = std::nextafter(result[axis], lowest);
  }
  return result;
}

// The smallest cube around both of a level.
StippleCube commonCube(StippleCube first, StippleCube second)
{
  while (first.cell != second.cell)
  {
    first = first.parent();
    second = second.parent();
  }
  return first;
}

// The cubes of a level within the given one that the polygon, which is in it, meets. Cubes around
// all of it are passed over.
void addCubes(const StipplePolygon& polygon, const StippleCube& within, std::int32_t level,
  std::vector<std::uint64_t>& codes)
{
  const StippleCube around = commonCube(
    StippleCube::around(polygon.low(), level), StippleCube::around(polygon.high(), level));
  const StippleCube cube = around.level > within.level ? around : within;
  if (cube.level == level)
  {
    codes.push_back(cube.code());
    return;
  }
  for (int i = 0; i < 8; ++i)
  {
    const StippleCube child = cube.child(i);
    StipplePolygon part = polygon;
    part.clip(child.low(), child.low() + child.side());
    if (!part.isEmpty())
    {
      addCubes(part, child, level, codes);
    }
  }
}

void makeUnique(std::vector<std::uint64_t>& codes)
{
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
}

} // namespace

StippleTriangles::StippleTriangles(StippleSurface someSurface)
  : theSurface(std::move(someSurface))
{
  std::vector<std::uint8_t> byTriangle(this->theSurface.mesh.triangles.size());
  for (const std::int64_t side : this->theSurface.openSides)
  {
    byTriangle[at(side / 3)] |= static_cast<std::uint8_t>(1u << (side % 3));
  }
  this->borders.reserve(this->theSurface.triangles.size());
  for (const std::int32_t triangle : this->theSurface.triangles)
  {
    this->borders.push_back(byTriangle[at(triangle)]);
  }
  this->makeBoxes();
}

StippleTriangles::Box StippleTriangles::boxOf(std::int32_t number) const
{
  const std::array<glm::dvec3, 3> c = this->corners(number);
  return { roundedDown(glm::min(c[0], glm::min(c[1], c[2]))),
    -roundedDown(-glm::max(c[0], glm::max(c[1], c[2]))) };
}

void StippleTriangles::makeBoxes()
{
  std::int64_t below = static_cast<std::int64_t>(this->theSurface.triangles.size());
  while (below > 1 || this->boxes.empty())
  {
    std::vector<Box> next(at((below + fanOut - 1) / fanOut));
    const bool isFirst = this->boxes.empty();
    parallelFor(static_cast<std::int64_t>(next.size()),
      [&](std::int64_t i)
      {
        const std::int64_t end = std::min(below, (i + 1) * fanOut);
        for (std::int64_t k = i * fanOut; k < end; ++k)
        {
          const Box box =
            isFirst ? this->boxOf(static_cast<std::int32_t>(k)) : this->boxes.back()[at(k)];
          Box& around = next[at(i)];
          around.low = k == i * fanOut ? box.low : glm::min(around.low, box.low);
          around.high = k == i * fanOut ? box.high : glm::max(around.high, box.high);
        }
      });
    below = static_cast<std::int64_t>(next.size());
    this->boxes.push_back(std::move(next));
  }
}

std::vector<std::int32_t> StippleTriangles::find(
  const glm::dvec3& low, const glm::dvec3& high) const
{
  const glm::vec3 least = roundedDown(low);
  const glm::vec3 most = -roundedDown(-high);
  const auto meets = [&](const Box& box)
  {
    return glm::all(glm::lessThanEqual(box.low, most)) &&
      glm::all(glm::greaterThanEqual(box.high, least));
  };
  std::vector<std::int32_t> found;
  std::vector<std::pair<std::size_t, std::int32_t>> open; // level of boxes, box
  if (!this->boxes.back().empty())
  {
    open.emplace_back(this->boxes.size() - 1, 0);
  }
  while (!open.empty())
  {
    const auto [level, box] = open.back();
    open.pop_back();
    if (!meets(this->boxes[level][at(box)]))
    {
      continue;
    }
    const auto below = static_cast<std::int32_t>(
      level > 0 ? this->boxes[level - 1].size() : this->theSurface.triangles.size());
    const std::int32_t begin = box * fanOut;
    const std::int32_t end = std::min(below, begin + fanOut);
    for (std::int32_t i = end - 1; i >= begin && level > 0; --i)
    {
      open.emplace_back(level - 1, i);
    }
    for (std::int32_t i = begin; i < end && level == 0; ++i)
    {
      if (meets(this->boxOf(i)))
      {
        found.push_back(i);
      }
    }
  }
  return found;
}

std::vector<std::uint64_t> StippleTriangles::cubes(std::int32_t level) const
{
  constexpr std::int64_t grain = 4096;
  const auto count = static_cast<std::int64_t>(this->theSurface.triangles.size());
  std::vector<std::vector<std::uint64_t>> parts(at(count / grain + 1));
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::uint64_t>& part = parts[at(begin / grain)];
      for (std::int64_t i = begin; i < end; ++i)
      {
        addCubes(
          StipplePolygon(this->corners(static_cast<std::int32_t>(i))), StippleCube(), level, part);
      }
      makeUnique(part);
    });
  std::vector<std::uint64_t> codes;
  for (const std::vector<std::uint64_t>& part : parts)
  {
    codes.insert(codes.end(), part.begin(), part.end());
  }
  makeUnique(codes);
  return codes;
}

unsigned StippleTriangles::findChildren(const StippleCube& cube) const
{
  unsigned met = 0;
  for (const std::int32_t number : this->find(cube.low(), cube.low() + cube.side()))
  {
    StipplePolygon polygon(this->corners(number));
    polygon.clip(cube.low(), cube.low() + cube.side());
    for (int i = 0; i < 8 && !polygon.isEmpty() && met != 0xffu; ++i)
    {
      if ((met >> i & 1u) == 0)
      {
        const StippleCube child = cube.child(i);
        StipplePolygon part = polygon;
        part.clip(child.low(), child.low() + child.side());
        met |= part.isEmpty() ? 0u : 1u << i;
      }
    }
  }
  return met;
}

unsigned StippleTriangles::children(const StippleCube& cube)
{
  const std::uint64_t code = cube.code();
  const auto known = this->knownChildren.find(code);
  if (known != this->knownChildren.end())
  {
    return known->second;
  }
  const unsigned met = this->findChildren(cube);
  this->knownChildren.emplace(code, static_cast<std::uint8_t>(met));
  return met;
}

std::size_t StippleTriangles::memory() const
{
  constexpr std::size_t perEntry = 32; // of a hash table
  std::size_t bytes = this->borders.capacity() + this->knownChildren.size() * perEntry +
    this->theSurface.triangles.capacity() * sizeof(std::int32_t) +
    this->theSurface.areaBefore.capacity() * sizeof(double);
  for (const std::vector<Box>& level : this->boxes)
  {
    bytes += level.capacity() * sizeof(Box);
  }
  return bytes;
}

} // namespace hachure

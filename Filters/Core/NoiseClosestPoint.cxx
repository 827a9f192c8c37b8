// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseClosestPoint.h"

#include "FloatLanes.h"
#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hachure
{

namespace
{

constexpr double leastCosine = -0.5; // 120 degrees
// Of boxes, in radii of the surface: more than the rounding of numbers of that size.
constexpr float slack = 1e-6f;
constexpr float nowhere = 1e15f;        // its square is a number
constexpr std::int64_t boxGrain = 4096; // a multiple of those in a node
// The facets of the tree are sorted by cells, which may hold many; these are sorted further.
constexpr std::int64_t sortingRange = 4096;
constexpr double cellsPerAxis = 1 << 21;

// The lowest 21 bits, two places apart.
std::uint64_t spreadBits(std::uint64_t value)
{
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffff;
  value = (value | value << 16) & 0x1f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  return (value | value << 2) & 0x1249249249249249;
}

} // namespace

// The regions of a triangle's plane, after Ericson (Real-Time Collision Detection, 5.1.5).
glm::dvec2 closestInTriangle(
  const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 ab = b - a, ac = c - a;
  const glm::dvec3 ap = point - a, bp = point - b, cp = point - c;
  const double abA = glm::dot(ab, ap), acA = glm::dot(ac, ap);
  const double abB = glm::dot(ab, bp), acB = glm::dot(ac, bp);
  const double abC = glm::dot(ab, cp), acC = glm::dot(ac, cp);
  if (abA <= 0.0 && acA <= 0.0)
  {
    return { 0.0, 0.0 };
  }
  if (abB >= 0.0 && acB <= abB)
  {
    return { 1.0, 0.0 };
  }
  if (acC >= 0.0 && abC <= acC)
  {
    return { 0.0, 1.0 };
  }
  const double ofC = abA * acB - abB * acA;
  if (ofC <= 0.0 && abA >= 0.0 && abB <= 0.0)
  {
    return { abA / (abA - abB), 0.0 };
  }
  const double ofB = abC * acA - abA * acC;
  if (ofB <= 0.0 && acA >= 0.0 && acC <= 0.0)
  {
    return { 0.0, acA / (acA - acC) };
  }
  const double ofA = abB * acC - abC * acB;
  const double towardsC = acB - abB, towardsB = abC - acC;
  if (ofA <= 0.0 && towardsC >= 0.0 && towardsB >= 0.0)
  {
    const double share = towardsC / (towardsC + towardsB);
    return { 1.0 - share, share };
  }
  const double sum = ofA + ofB + ofC;
  return { ofB / sum, ofC / sum };
}

static_assert(floatLanes == 8, "a node has as many boxes");

struct NoiseClosestPoint::Search
{
  glm::dvec3 point;
  glm::dvec3 normal;
  NoiseFoot best;
  double square;  // of the distance that limits the search
  float place[3]; // as boxes have it
  float limit;    // and the square
};

NoiseClosestPoint::NoiseClosestPoint(
  const NoiseSurfaceTree& surfaceTree, Span<const glm::dvec3> places)
  : tree(surfaceTree)
  , positions(places)
{
  if (!this->tree.nodes.empty() && this->tree.nodes.back().sphere.radius > 0.0)
  {
    this->center = this->tree.nodes.back().sphere.center;
    this->radius = this->tree.nodes.back().sphere.radius;
  }
  this->sortFacets();
  this->makeNodes();
}

std::uint64_t NoiseClosestPoint::placeOnCurve(const glm::dvec3& point) const
{
  const glm::dvec3 place = 0.5 + 0.5 * (point - this->center) / this->radius;
  const glm::dvec3 cell =
    glm::clamp(place * cellsPerAxis, glm::dvec3(0.0), glm::dvec3(cellsPerAxis - 1.0));
  return spreadBits(static_cast<std::uint64_t>(cell.x)) |
    spreadBits(static_cast<std::uint64_t>(cell.y)) << 1 |
    spreadBits(static_cast<std::uint64_t>(cell.z)) << 2;
}

void NoiseClosestPoint::sortFacets()
{
  const auto count = static_cast<std::int64_t>(this->tree.facets.size());
  this->order.resize(static_cast<std::size_t>(count));
  parallelForRanges(count, sortingRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::pair<std::uint64_t, std::int32_t>> codes;
      codes.reserve(static_cast<std::size_t>(end - begin));
      for (std::int64_t i = begin; i < end; ++i)
      {
        const glm::ivec3& corners = this->tree.facets[i].corners;
        const glm::dvec3 middle =
          (this->positions[corners.x] + this->positions[corners.y] + this->positions[corners.z]) /
          3.0;
        codes.emplace_back(this->placeOnCurve(middle), static_cast<std::int32_t>(i));
      }
      std::sort(codes.begin(), codes.end());
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->order[i] = codes[i - begin].second;
      }
    });
}

void NoiseClosestPoint::makeNodes()
{
  auto children = static_cast<std::int64_t>(this->order.size());
  for (std::size_t level = 0; level == 0 || children > 1; ++level)
  {
    Node empty;
    std::fill_n(&empty.low[0][0], 3 * width, nowhere);
    std::fill_n(&empty.high[0][0], 3 * width, -nowhere);
    this->levels.emplace_back(static_cast<std::size_t>((children + width - 1) / width), empty);
    parallelForRanges(children, boxGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          this->setBox(level, i);
        }
      });
    children = static_cast<std::int64_t>(this->levels.back().size());
  }
}

// Around a triangle, where it has area, or a node below.
void NoiseClosestPoint::setBox(std::size_t level, std::int64_t child)
{
  Node& node = this->levels[level][child / width];
  const auto lane = static_cast<int>(child % width);
  for (int axis = 0; axis < 3; ++axis)
  {
    float& low = node.low[axis][lane];
    float& high = node.high[axis][lane];
    if (level > 0)
    {
      const Node& below = this->levels[level - 1][child];
      low = *std::min_element(below.low[axis], below.low[axis] + width);
      high = *std::max_element(below.high[axis], below.high[axis] + width);
      continue;
    }
    const NoiseFacet& facet = this->tree.facets[this->order[child]];
    for (int corner = 0; corner < 3 && facet.area > 0.0; ++corner)
    {
      const double place = this->positions[facet.corners[corner]][axis] - this->center[axis];
      low = std::min(low, static_cast<float>(place / this->radius) - slack);
      high = std::max(high, static_cast<float>(place / this->radius) + slack);
    }
  }
}

void NoiseClosestPoint::searchFacet(std::int32_t index, Search& search) const
{
  const NoiseFacet& facet = this->tree.facets[index];
  const glm::dvec3& a = this->positions[facet.corners.x];
  const glm::dvec3& b = this->positions[facet.corners.y];
  const glm::dvec3& c = this->positions[facet.corners.z];
  const glm::dvec2 weights = closestInTriangle(search.point, a, b, c);
  const glm::dvec3 position = a + weights.x * (b - a) + weights.y * (c - a);
  const glm::dvec3 arm = search.point - position;
  const double square = glm::dot(arm, arm);
  if (!(square < search.square) || !(facet.area > 0.0))
  {
    return;
  }
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  // The area now may be 0, where the triangle has no place for a point.
  const double length = glm::length(normal);
  if (length > 0.0 && glm::dot(normal, search.normal) >= leastCosine * length)
  {
    search.square = square;
    search.limit = this->limitOf(square);
    search.best = { index, weights, position, std::sqrt(square) };
  }
}

// Above the square of a distance by more than rounding.
float NoiseClosestPoint::limitOf(double square) const
{
  return 1.00001f * static_cast<float>(square / (this->radius * this->radius));
}

void NoiseClosestPoint::searchNode(std::size_t level, std::int64_t index, Search& search) const
{
  const Node& node = this->levels[level][index];
  FloatLanes sum{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const FloatLanes place = fillLanes(search.place[axis]);
    const FloatLanes beyond =
      higherLanes(loadLanes(node.low[axis]) - place, place - loadLanes(node.high[axis]));
    const FloatLanes distance = keepWhere(beyond, beyond);
    sum = sum + distance * distance;
  }
  float squares[width];
  storeLanes(sum, squares);
  // Those that are near enough, the nearest first.
  int near[width];
  int count = 0;
  for (int lane = 0; lane < width; ++lane)
  {
    if (squares[lane] < search.limit)
    {
      int slot = count++;
      for (; slot > 0 && squares[lane] < squares[near[slot - 1]]; --slot)
      {
        near[slot] = near[slot - 1];
      }
      near[slot] = lane;
    }
  }
  for (int i = 0; i < count && squares[near[i]] < search.limit; ++i)
  {
    const std::int64_t child = index * width + near[i];
    if (level == 0)
    {
      this->searchFacet(this->order[child], search);
    }
    else
    {
      this->searchNode(level - 1, child, search);
    }
  }
}

NoiseFoot NoiseClosestPoint::find(
  const glm::dvec3& point, const glm::dvec3& normal, double farthest, std::int32_t guess) const
{
  const glm::dvec3 place = (point - this->center) / this->radius;
  Search search{ point, normal, {}, farthest * farthest,
    { static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z) },
    this->limitOf(farthest * farthest) };
  if (guess >= 0)
  {
    this->searchFacet(guess, search);
  }
  if (!this->order.empty())
  {
    this->searchNode(this->levels.size() - 1, 0, search);
  }
  return search.best;
}

} // namespace hachure

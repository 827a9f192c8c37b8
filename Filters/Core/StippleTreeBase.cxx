// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleTreeBase.h"

#include "Parallel.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

std::size_t at(std::int64_t index)
{
  return static_cast<std::size_t>(index);
}

double densityOf(const StippleHierarchy& base, bool hasMesh, std::size_t rank)
{
  if (hasEvenRanks(base, hasMesh))
  {
    return static_cast<double>(rank + 1) / base.area;
  }
  const auto spacing = static_cast<double>(base.points[rank].spacing);
  const double density = stippleSquareSpacing / (spacing * spacing);
  return std::min(density, static_cast<double>(std::numeric_limits<float>::max()));
}

// A point and the cube it is in.
struct Member
{
  std::uint64_t code;
  std::uint32_t rank;
  float density;

  bool operator<(const Member& other) const
  {
    if (this->code != other.code)
    {
      return this->code < other.code;
    }
    return this->density != other.density ? this->density < other.density : this->rank < other.rank;
  }
};

StipplePlace placeOf(const StipplePoint& point)
{
  return { point.triangle, static_cast<double>(point.weights[0]),
    static_cast<double>(point.weights[1]) };
}

std::int32_t levelOf(const StippleLevels& levels, double scaledDensity)
{
  std::int32_t level = levels.firstRefined - 1;
  for (double least = levels.leastDensity(level); level > 0 && scaledDensity <= least;
       least *= 0.25)
  {
    --level;
  }
  return level;
}

std::vector<Member> sortIntoCubes(
  const StippleHierarchy& base, const StippleShape& shape, const StippleLevels& levels)
{
  std::vector<Member> members(base.points.size());
  const double area = levels.frame.size * levels.frame.size;
  parallelFor(static_cast<std::int64_t>(members.size()),
    [&](std::int64_t i)
    {
      const double density = densityOf(base, shape.hasMesh(), at(i));
      const glm::dvec3 place =
        levels.frame.place(shape.referencePlace(placeOf(base.points[at(i)])));
      const StippleCube cube = StippleCube::around(place, levelOf(levels, density * area));
      members[at(i)] = { cube.code(), static_cast<std::uint32_t>(i), static_cast<float>(density) };
    });
  parallelSort(members);
  return members;
}

// Those with points, the given ones, and all around them, each once and in ascending order.
std::vector<std::uint64_t> codesOf(
  const std::vector<Member>& members, const std::vector<std::uint64_t>& cubes)
{
  std::vector<std::uint64_t> codes = cubes;
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    if (i == 0 || members[i].code != members[i - 1].code)
    {
      codes.push_back(members[i].code);
    }
  }
  for (std::size_t i = 0; i < codes.size(); ++i) // grows by the parents of the last of a row
  {
    if (codes[i] > 1 && (i == 0 || codes[i] >> 3 != codes[i - 1] >> 3))
    {
      codes.push_back(codes[i] >> 3);
    }
  }
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

void takePoints(StippleNode& node, const StippleHierarchy& base, const std::vector<Member>& members)
{
  const auto first = std::lower_bound(members.begin(), members.end(), node.code,
    [](const Member& member, std::uint64_t code) { return member.code < code; });
  auto last = first;
  while (last != members.end() && last->code == node.code)
  {
    ++last;
  }
  node.count = static_cast<std::int32_t>(last - first);
  node.places.reserve(at(node.count));
  node.referenceDensities.reserve(at(node.count));
  node.ranks.reserve(at(node.count));
  for (auto member = first; member != last; ++member)
  {
    node.places.push_back(placeOf(base.points[member->rank]));
    node.referenceDensities.push_back(member->density);
    node.ranks.push_back(member->rank);
  }
}

} // namespace

bool hasEvenRanks(const StippleHierarchy& base, bool hasMesh)
{
  return hasMesh && base.area > 0.0 && base.firstNeighbour.empty();
}

void checkBase(const StippleHierarchy& base, const StippleShape& shape)
{
  if (base.points.size() > std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument(
      "base.points: " + std::to_string(base.points.size()) + ", expected less than 2^32");
  }
  if (!(base.area >= 0.0 && std::isfinite(base.area)))
  {
    throw std::invalid_argument("base.area: " + std::to_string(base.area) + ", expected 0 or more");
  }
  for (std::size_t i = 0; i < base.points.size(); ++i)
  {
    const StipplePoint& point = base.points[i];
    const bool isOn = point.triangle >= 0 && at(point.triangle) < shape.size();
    const bool isWithin = point.weights[0] >= 0.0f && point.weights[1] >= 0.0f &&
      point.weights[0] + point.weights[1] <= 1.0f + 1e-6f;
    if (!isOn || !isWithin || !(point.spacing >= 0.0f))
    {
      throw std::invalid_argument("base.points[" + std::to_string(i) + "]: triangle " +
        std::to_string(point.triangle) + " of " + std::to_string(shape.size()) + ", weights " +
        std::to_string(point.weights[0]) + " and " + std::to_string(point.weights[1]) +
        ", spacing " + std::to_string(point.spacing));
    }
  }
}

void setDensities(StippleLevels& levels, const StippleHierarchy& base, bool hasMesh)
{
  const double area = levels.frame.size * levels.frame.size;
  const auto count = static_cast<double>(base.points.size());
  const double density =
    base.area > 0.0 ? count / base.area : densityOf(base, hasMesh, base.points.size() - 1);
  levels.baseDensity = std::max(1.0, std::min(density * area, 1e12));
  if (hasEvenRanks(base, hasMesh))
  {
    levels.baseDensity = density * area;
  }
  levels.firstRefined = 1;
  while (levels.firstRefined < StippleCube::mostLevel / 2 &&
    std::ldexp(levels.baseDensity, -2 * (levels.firstRefined + 1)) >= leastPointsPerSquare)
  {
    ++levels.firstRefined;
  }
}

std::vector<StippleNode> makeBaseNodes(const StippleHierarchy& base, const StippleShape& shape,
  const StippleLevels& levels, const std::vector<std::uint64_t>& cubes)
{
  const std::vector<Member> members = sortIntoCubes(base, shape, levels);
  const std::vector<std::uint64_t> codes = codesOf(members, cubes);
  std::vector<StippleNode> nodes(codes.size());
  parallelFor(static_cast<std::int64_t>(nodes.size()),
    [&](std::int64_t i)
    {
      StippleNode& node = nodes[at(i)];
      node.code = codes[at(i)];
      node.level = StippleCube::fromCode(node.code).level;
      if (node.code > 1)
      {
        node.parent = static_cast<std::int32_t>(
          std::lower_bound(codes.begin(), codes.end(), node.code >> 3) - codes.begin());
      }
      takePoints(node, base, members);
    });
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    linkChild(nodes, static_cast<std::int32_t>(i));
  }
  return nodes;
}

void linkChild(std::vector<StippleNode>& nodes, std::int32_t child)
{
  StippleNode& parent = nodes[at(nodes[at(child)].parent)];
  parent.children[at(parent.childCount++)] = child;
}

} // namespace hachure

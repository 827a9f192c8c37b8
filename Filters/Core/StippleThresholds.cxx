// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleThresholds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace hachure
{

namespace
{

// Points in a group are alike to this.
constexpr double groupRatio = 1.005;
// From one threshold to the next.
constexpr double thresholdRatio = 1.03;
// Of the longest edges between all points: where edges are split one after the other, the longest
// first, stipples with longer edges than this are there in all places.
constexpr double leastShareOfLongest = 0.35;
// The longest of the edges, but for those in this share of the area, which may be an odd triangle.
constexpr double oddShare = 0.02;

// Shortest edges, the longest first.
std::vector<double> sortedEdges(const StippleHierarchy& hierarchy)
{
  std::vector<double> lengths;
  lengths.reserve(hierarchy.points.size());
  for (std::size_t i = 0; i < hierarchy.points.size(); ++i)
  {
    const auto length = static_cast<double>(hierarchy.points[i].spacing);
    if (hierarchy.firstNeighbour[i] < hierarchy.firstNeighbour[i + 1] && length > 0.0)
    {
      lengths.push_back(length);
    }
  }
  std::sort(lengths.begin(), lengths.end(), std::greater<>());
  return lengths;
}

// The longest edge of the triangles between all points.
double longestEdge(const TriangleMesh& reference, const StippleHierarchy& hierarchy)
{
  std::vector<std::pair<double, double>> edges; // and areas
  edges.reserve(hierarchy.particleTriangles.size());
  double area = 0.0;
  for (const glm::ivec3& corners : hierarchy.particleTriangles)
  {
    const auto place = [&](int corner) {
      return stipplePosition(
        reference, hierarchy.points[static_cast<std::size_t>(corners[corner])]);
    };
    const glm::dvec3 a = place(0), b = place(1), c = place(2);
    edges.emplace_back(std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) }),
      glm::length(glm::cross(b - a, c - a)));
    area += edges.back().second;
  }
  std::sort(edges.begin(), edges.end(), std::greater<>());
  double passed = 0.0;
  for (const auto& [length, part] : edges)
  {
    passed += part;
    if (passed > oddShare * area)
    {
      return length;
    }
  }
  return 0.0;
}

} // namespace

StippleEdgeLengths::StippleEdgeLengths(
  const TriangleMesh& reference, const StippleHierarchy& hierarchy)
  : wholeArea(hierarchy.area)
{
  const std::vector<double> sorted = sortedEdges(hierarchy);
  this->without = static_cast<double>(hierarchy.points.size() - sorted.size());
  for (std::size_t i = 0; i < sorted.size();)
  {
    const double least = sorted[i] / groupRatio;
    const std::size_t first = i;
    while (i < sorted.size() && sorted[i] >= least)
    {
      ++i;
    }
    const auto count = static_cast<double>(i - first);
    this->all.push_back({ sorted[first + (i - first) / 2], count });
  }
  this->leastLength = leastShareOfLongest * longestEdge(reference, hierarchy);
  if (!sorted.empty())
  {
    this->leastLength = std::clamp(this->leastLength, sorted.back(), sorted.front());
  }
}

StippleThresholds::StippleThresholds(const StippleEdgeLengths& edges, double growth)
  : ownGrowth(growth)
{
  const std::vector<StippleEdgeLengths::Group>& groups = edges.groups();
  if (!(edges.area() > 0.0) || groups.empty())
  {
    return;
  }
  const double longest = groups.front().length;
  const double least = edges.least();
  const auto steps =
    static_cast<std::size_t>(std::ceil(std::log(longest / least) / std::log(thresholdRatio)));
  this->densities.reserve(steps + 1);
  this->lengths.reserve(steps + 1);
  for (std::size_t step = 0; step <= steps; ++step)
  {
    const double length =
      std::max(least, longest * std::pow(thresholdRatio, -static_cast<double>(step)));
    double sum = edges.alwaysDrawn();
    for (const StippleEdgeLengths::Group& group : groups)
    {
      if (!(group.length > length))
      {
        break;
      }
      const double size =
        growth > 0.0 ? std::min(1.0, (group.length / length - 1.0) / growth) : 1.0;
      sum += size * size * group.count;
    }
    if (sum > 0.0 && (this->densities.empty() || sum / edges.area() > this->densities.back()))
    {
      this->densities.push_back(sum / edges.area());
      this->lengths.push_back(length);
    }
  }
}

double StippleThresholds::threshold(double density) const
{
  if (this->densities.empty())
  {
    return 0.0;
  }
  const auto above = std::upper_bound(this->densities.begin(), this->densities.end(), density);
  if (above == this->densities.begin())
  {
    return this->lengths.front() * std::sqrt(this->densities.front() / density);
  }
  const auto next = static_cast<std::size_t>(above - this->densities.begin());
  if (next == this->densities.size())
  {
    return this->lengths.back();
  }
  const double share =
    (density - this->densities[next - 1]) / (this->densities[next] - this->densities[next - 1]);
  return this->lengths[next - 1] + share * (this->lengths[next] - this->lengths[next - 1]);
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleRuns.h"

#include <algorithm>

namespace hachure
{
namespace
{
// Calls body(point, triangle) for every record, in any order of the points but an ascending one of
// each point's triangles.
template <class Body>
void forRecords(Span<const glm::ivec3> triangles, Span<const std::int32_t> facets, const Body& body)
{
  std::vector<std::int32_t> corners;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < triangles.size(); begin = end)
  {
    end = begin + 1;
    while (!facets.empty() && end < triangles.size() && facets[end] == facets[begin])
    {
      ++end;
    }
    if (end == begin + 1)
    {
      body(triangles[begin].z, begin);
      continue;
    }
    corners.clear();
    for (std::size_t i = begin; i < end; ++i)
    {
      corners.insert(corners.end(), &triangles[i].x, &triangles[i].x + 3);
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const std::int32_t corner : corners)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        body(corner, i);
      }
    }
  }
}
} // namespace

TriangleRuns triangleRuns(
  std::size_t pointCount, Span<const glm::ivec3> triangles, Span<const std::int32_t> facets)
{
  std::vector<std::int32_t> ends(pointCount + 1, 0);
  forRecords(triangles, facets,
    [&](std::int32_t point, std::size_t) { ++ends[static_cast<std::size_t>(point) + 1]; });
  for (std::size_t point = 0; point < pointCount; ++point)
  {
    ends[point + 1] += ends[point];
  }
  TriangleRuns runs;
  runs.firstOfPoint.reserve(pointCount);
  for (std::size_t point = 0; point < pointCount; ++point)
  {
    runs.firstOfPoint.push_back(ends[point] < ends[point + 1] ? ends[point] : -1);
  }
  const auto count = static_cast<std::size_t>(ends.back());
  runs.triangles.resize(count);
  runs.goesOn.resize(count);
  std::vector<std::int32_t> next(ends.begin(), ends.end() - 1);
  forRecords(triangles, facets,
    [&](std::int32_t point, std::size_t triangle)
    {
      const auto index = static_cast<std::size_t>(point);
      const auto record = static_cast<std::size_t>(next[index]++);
      runs.triangles[record] = static_cast<std::int32_t>(triangle);
      runs.goesOn[record] = next[index] < ends[index + 1] ? 1 : 0;
    });
  return runs;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NodePlaces.h"

#include "Kernels.h"
#include "Parallel.h"

#include <algorithm>
#include <numeric>

namespace hachure
{
namespace
{
// A triangle that reaches over the rim of its chart, on its way through the next ones.
class Overlaps
{
public:
  explicit Overlaps(const SurfaceCells& someCells)
    : cells(someCells)
  {
  }

  void add(std::int32_t triangle, std::vector<detail::ChartTriangle>& found)
  {
    const auto own = static_cast<std::size_t>(triangle);
    const std::size_t begin = found.size();
    found.push_back({ this->cells.chartOfTriangle[own], triangle, this->cells.places[own] });
    // Around a corner of many charts it would go on and on.
    constexpr std::size_t most = 32;
    for (std::size_t step = begin; step < found.size() && found.size() - begin < most; ++step)
    {
      const detail::ChartTriangle from = found[step];
      for (int edge = 0; edge < 3; ++edge)
      {
        this->addAcross(from, edge, begin, found);
      }
    }
  }

private:
  static glm::vec3 weightsOf(const glm::vec2& place)
  {
    return { 1.0f - place.x - place.y, place.x, place.y };
  }

  void addAcross(const detail::ChartTriangle& from, int edge, std::size_t begin,
    std::vector<detail::ChartTriangle>& found) const
  {
    const std::int32_t code = this->cells.charts[static_cast<std::size_t>(from.chart)]
                                .neighbours[static_cast<std::size_t>(edge)];
    constexpr float slack = 1e-6f; // of the chart
    const bool reaches = std::any_of(from.places.begin(), from.places.end(),
      [&](const glm::vec2& place) { return weightsOf(place)[edge] < -slack; });
    if (code < 0 || !reaches)
    {
      return;
    }
    const bool isKnown = std::any_of(found.begin() + static_cast<std::ptrdiff_t>(begin),
      found.end(), [&](const detail::ChartTriangle& other) { return other.chart == code / 6; });
    detail::ChartTriangle across = { code / 6, from.triangle, {} };
    glm::vec3 largest(0.0f);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const glm::vec3 weights =
        glsl::weightsAcross(weightsOf(from.places[corner]), edge, code % 6 / 2, code % 2 == 1);
      across.places[corner] = glm::vec2(weights.y, weights.z);
      largest = glm::max(largest, weights);
    }
    if (!isKnown && std::min(std::min(largest.x, largest.y), largest.z) > slack)
    {
      found.push_back(across);
    }
  }

  const SurfaceCells& cells;
};

// Ascending by triangle.
std::vector<detail::ChartTriangle> overlapsOfAll(const SurfaceCells& cells)
{
  constexpr std::int64_t grain = 4096;
  const auto count = static_cast<std::int64_t>(cells.chartOfTriangle.size());
  std::vector<std::vector<detail::ChartTriangle>> parts(
    static_cast<std::size_t>((count + grain - 1) / grain));
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<detail::ChartTriangle>& part = parts[static_cast<std::size_t>(begin / grain)];
      part.reserve(static_cast<std::size_t>(end - begin));
      for (std::int64_t triangle = begin; triangle < end; ++triangle)
      {
        if (cells.chartOfTriangle[static_cast<std::size_t>(triangle)] >= 0)
        {
          Overlaps(cells).add(static_cast<std::int32_t>(triangle), part);
        }
      }
    });
  std::vector<detail::ChartTriangle> all;
  all.reserve(static_cast<std::size_t>(count));
  for (const std::vector<detail::ChartTriangle>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
} // namespace

namespace detail
{
ChartTriangles chartTriangles(const SurfaceCells& cells)
{
  const std::vector<ChartTriangle> all = overlapsOfAll(cells);
  ChartTriangles sorted;
  sorted.first.assign(cells.charts.size() + 1, 0);
  for (const ChartTriangle& triangle : all)
  {
    ++sorted.first[static_cast<std::size_t>(triangle.chart) + 1];
  }
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  std::vector<std::size_t> next = sorted.first;
  sorted.triangles.resize(all.size());
  for (const bool isOwn : { true, false })
  {
    for (const ChartTriangle& triangle : all)
    {
      if ((cells.chartOfTriangle[static_cast<std::size_t>(triangle.triangle)] == triangle.chart) ==
        isOwn)
      {
        sorted.triangles[next[static_cast<std::size_t>(triangle.chart)]++] = triangle;
      }
    }
  }
  return sorted;
}
} // namespace detail

} // namespace hachure

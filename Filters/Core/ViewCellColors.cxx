// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCellColors.h"

#include "Parallel.h"
#include "SrgbColor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure
{
namespace
{
glm::vec4 meanOf(
  Span<const CoveredPixel> pixels, Span<const glm::u8vec4> image, const glm::vec4* color)
{
  glm::vec4 sum(0.0f);
  float weight = 0.0f;
  for (const CoveredPixel& covered : pixels)
  {
    const auto quarters = static_cast<float>(covered.quarters());
    const glm::u8vec4& pixel = image[covered.pixel];
    sum += quarters *
      (color != nullptr ? *color * (static_cast<float>(pixel.a) / 255.0f) : linearOf(pixel));
    weight += quarters;
  }
  return weight > 0.0f ? glm::min(sum / weight, glm::vec4(1.0f)) : glm::vec4(0.0f);
}

// Of the first level: the same for cells of all.
void findMiddle(const ViewTextureSurface& surface, ViewCellColors& view)
{
  if (view.levels.empty())
  {
    return;
  }
  const int level = view.levels.front().number;
  const CellColors& seen = view.levels.front().seen;
  double weight = 0.0;
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < seen.cells.size(); ++i)
  {
    const double mask = seen.colors[i].a;
    sum += mask * surface.placeOfCell(level, seen.cells[i]);
    weight += mask;
  }
  if (!(weight > 0.0))
  {
    return;
  }
  view.middle = sum / weight;
  for (std::size_t i = 0; i < seen.cells.size(); ++i)
  {
    if (seen.colors[i].a > 0.0f)
    {
      view.reach =
        std::max(view.reach, glm::distance(view.middle, surface.placeOfCell(level, seen.cells[i])));
    }
  }
}

// Neighbours without a colour that may get one, each once.
std::vector<std::int32_t> openAround(const CellLayer& layer, Span<const std::int32_t> cells,
  const std::vector<std::uint8_t>& closed, const std::vector<std::int32_t>& numbers)
{
  std::vector<std::int32_t> open;
  std::vector<std::int32_t> neighbours;
  open.reserve(cells.size());
  for (const std::int32_t cell : cells)
  {
    neighbours.clear();
    layer.appendNeighbours(cell, neighbours);
    for (const std::int32_t other : neighbours)
    {
      const auto index = static_cast<std::size_t>(other);
      if (closed[index] == 0 && numbers[index] < 0)
      {
        open.push_back(other);
      }
    }
  }
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}
} // namespace

float ViewCellColors::fromMiddle(const glm::dvec3& place) const
{
  const double distance = glm::distance(place, this->middle);
  return static_cast<float>(this->reach > 0.0 ? std::min(distance / this->reach, 1.0) : 0.0);
}

ViewCellColors viewCellColors(const ViewTextureSurface& surface, const ViewCoverage& coverage,
  Span<const glm::u8vec4> image, const glm::u8vec4* color)
{
  const glm::vec4 given = color != nullptr ? linearOf(*color) : glm::vec4(0.0f);
  ViewCellColors view;
  view.levels.resize(coverage.levels.size());
  for (std::size_t i = 0; i < view.levels.size(); ++i)
  {
    const ViewCoverage::Level& covered = coverage.levels[i];
    ViewCellColors::Level& level = view.levels[i];
    level.number = covered.number;
    level.share = static_cast<float>(covered.share);
    level.seen.cells = covered.cells;
    level.seen.colors.resize(covered.cells.size());
    parallelFor(static_cast<std::int64_t>(covered.cells.size()),
      [&](std::int64_t cell)
      {
        const auto index = static_cast<std::size_t>(cell);
        const std::size_t first = covered.first[index];
        const auto pixels =
          Span<const CoveredPixel>(covered.pixels).subspan(first, covered.first[index + 1] - first);
        level.seen.colors[index] = meanOf(pixels, image, color != nullptr ? &given : nullptr);
      });
  }
  findMiddle(surface, view);
  return view;
}

void weighByFacing(
  const ViewTextureSurface& surface, const TextureView& view, ViewCellColors& colors)
{
  constexpr float leastCosine = 0.03f; // where no other view sees it, it counts all the same
  const glm::dvec3 along = view.eye - view.focus;
  for (ViewCellColors::Level& level : colors.levels)
  {
    level.weights.resize(level.seen.cells.size());
    parallelFor(static_cast<std::int64_t>(level.weights.size()),
      [&](std::int64_t i)
      {
        const std::int32_t cell = level.seen.cells[static_cast<std::size_t>(i)];
        const glm::dvec3 toEye =
          view.parallel ? along : view.eye - surface.placeOfCell(level.number, cell);
        const glm::vec3 normal =
          surface.turnOfCell(level.number, cell) * glm::vec3(0.0f, 1.0f, 0.0f);
        const double length = glm::length(toEye);
        const float cosine = length > 0.0 ? glm::dot(normal, glm::vec3(toEye / length)) : 1.0f;
        const float facing = std::max(std::abs(cosine), leastCosine);
        level.weights[static_cast<std::size_t>(i)] = facing * facing;
      });
  }
}

CellColors spreadColors(const CellLayer& layer, const CellColors& from,
  const std::vector<std::uint8_t>& closed, int rings)
{
  CellColors all = from;
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(layer.size()), -1);
  for (std::size_t i = 0; i < from.cells.size(); ++i)
  {
    numbers[static_cast<std::size_t>(from.cells[i])] = static_cast<std::int32_t>(i);
  }
  std::size_t begin = 0;
  std::vector<std::int32_t> neighbours;
  for (int ring = 0; ring < rings && begin < all.cells.size(); ++ring)
  {
    const std::vector<std::int32_t> open = openAround(layer,
      Span<const std::int32_t>(all.cells).subspan(begin, all.cells.size() - begin), closed,
      numbers);
    begin = all.cells.size();
    all.colors.reserve(begin + open.size());
    for (const std::int32_t cell : open)
    {
      neighbours.clear();
      layer.appendNeighbours(cell, neighbours);
      glm::vec4 sum(0.0f);
      float count = 0.0f;
      for (const std::int32_t other : neighbours)
      {
        const std::int32_t number = numbers[static_cast<std::size_t>(other)];
        if (number >= 0)
        {
          sum += all.colors[static_cast<std::size_t>(number)];
          count += 1.0f;
        }
      }
      all.colors.push_back(sum / std::max(count, 1.0f));
    }
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      numbers[static_cast<std::size_t>(open[i])] = static_cast<std::int32_t>(begin + i);
    }
    all.cells.insert(all.cells.end(), open.begin(), open.end());
  }
  const auto given = static_cast<std::ptrdiff_t>(from.cells.size());
  return { { all.cells.begin() + given, all.cells.end() },
    { all.colors.begin() + given, all.colors.end() } };
}

} // namespace hachure

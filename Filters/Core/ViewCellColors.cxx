// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCellColors.h"

#include "Parallel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure
{
namespace
{
// IEC 61966-2-1.
double linearOfSrgb(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double srgbOfLinear(double value)
{
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

std::array<float, 256> makeLinear()
{
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    table[i] = static_cast<float>(linearOfSrgb(static_cast<double>(i) / 255.0));
  }
  return table;
}

constexpr int srgbSteps = 1 << 14; // four for the smallest byte, where the curve is steepest

std::vector<std::uint8_t> makeSrgb()
{
  std::vector<std::uint8_t> table(srgbSteps + 1);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    table[i] = static_cast<std::uint8_t>(
      std::lround(255.0 * srgbOfLinear(static_cast<double>(i) / srgbSteps)));
  }
  return table;
}

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
  for (const std::int32_t cell : cells)
  {
    neighbours.clear();
    layer.appendNeighbours(cell, neighbours);
    for (const std::int32_t other : neighbours)
    {
      const auto index = static_cast<std::size_t>(other);
      if (closed[index] == 0 && numbers[index] < 0)
      {
        open.push_back(other); // NOLINT(performance-inefficient-vector-operation)
      }
    }
  }
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}
} // namespace

glm::vec4 linearOf(const glm::u8vec4& color)
{
  static const std::array<float, 256> table = makeLinear();
  const float alpha = static_cast<float>(color.a) / 255.0f;
  return { alpha * table[color.r], alpha * table[color.g], alpha * table[color.b], alpha };
}

std::uint8_t srgbByteOf(float linear)
{
  static const std::vector<std::uint8_t> table = makeSrgb();
  const float place = std::clamp(linear, 0.0f, 1.0f) * static_cast<float>(srgbSteps) + 0.5f;
  return table[static_cast<std::size_t>(place)];
}

std::uint8_t byteOf(float share)
{
  return static_cast<std::uint8_t>(std::clamp(share, 0.0f, 1.0f) * 255.0f + 0.5f);
}

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

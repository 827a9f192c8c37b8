// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCoverage.h"

#include "Kernels.h"
#include "Parallel.h"
#include "SurfaceRaster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hachure
{
namespace
{
double depthOf(const SurfaceRaster& raster, const SurfaceCells& cells)
{
  constexpr double pixelsInOne = 4.0; // of the raster in the image's
  const double pixels = static_cast<double>(raster.pixels) / pixelsInOne;
  const double ofCell = pixels * cells.cellArea / std::max(raster.area, 1e-300);
  if (!std::isfinite(ofCell)) // sizes beyond numbers
  {
    return 0.0;
  }
  const double depth = 0.5 * std::log2(std::clamp(ofCell, 1e-12, 1e30));
  return std::clamp(depth, 0.0, static_cast<double>(cells.finestLevel));
}

std::vector<ViewCoverage::Level> levelsOf(double depth)
{
  const int below = static_cast<int>(std::floor(depth));
  const double above = depth - below;
  std::vector<ViewCoverage::Level> levels(above > 0.0 ? 2 : 1);
  levels[0].number = below;
  levels[0].share = 1.0 - above;
  if (above > 0.0)
  {
    levels[1].number = below + 1;
    levels[1].share = above;
  }
  return levels;
}

// Where a pixel of a raster lies on the charts.
ChartPlace placeOf(const SurfaceRaster& raster, const SurfaceCells& cells, std::size_t pixel)
{
  const auto triangle = static_cast<std::size_t>(raster.triangles[pixel]);
  const std::array<glm::vec2, 3>& corners = cells.places[triangle];
  const glm::vec2& weights = raster.weights[pixel];
  return placeInside(cells,
    { cells.chartOfTriangle[triangle],
      (1.0f - weights.x - weights.y) * corners[0] + weights.x * corners[1] +
        weights.y * corners[2] });
}

// The cells in the quarters of a pixel; -1: none.
using Quarters = std::array<std::int32_t, 4>;

Quarters quartersOf(const SurfaceRaster& raster, const CellLayer& layer, std::size_t pixel)
{
  const std::size_t rasterWidth = static_cast<std::size_t>(raster.width);
  const std::size_t column = pixel % (rasterWidth / 2);
  const std::size_t row = pixel / (rasterWidth / 2);
  Quarters quarters{};
  for (std::size_t quarter = 0; quarter < 4; ++quarter)
  {
    const std::size_t part = (2 * row + quarter / 2) * rasterWidth + 2 * column + quarter % 2;
    quarters[quarter] =
      raster.triangles[part] < 0 ? -1 : layer.cellAt(placeOf(raster, layer.surface(), part));
  }
  return quarters;
}

// Calls body(cell, times) for each cell once.
template <class Body>
void forCells(const Quarters& quarters, Body&& body)
{
  for (std::size_t i = 0; i < quarters.size(); ++i)
  {
    const auto* const here = quarters.begin() + i;
    if (*here >= 0 && std::find(quarters.begin(), here, *here) == here)
    {
      body(static_cast<std::size_t>(*here),
        static_cast<std::uint32_t>(std::count(here, quarters.end(), *here)));
    }
  }
}

// Where the pixels of each cell begin, from how many there are.
void beginLists(std::vector<std::uint32_t>& counts, ViewCoverage::Level& level)
{
  level.cells.reserve(counts.size());
  level.first.reserve(counts.size() + 1);
  std::uint32_t end = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
  {
    const std::uint32_t count = counts[cell];
    counts[cell] = end;
    if (count > 0)
    {
      level.cells.push_back(static_cast<std::int32_t>(cell));
      level.first.push_back(end);
    }
    end += count;
  }
  level.first.push_back(end);
  level.pixels.resize(end);
}

void listPixels(const SurfaceRaster& raster, const CellLayer& layer, ViewCoverage::Level& level)
{
  std::vector<Quarters> all(raster.triangles.size() / 4);
  parallelFor(static_cast<std::int64_t>(all.size()),
    [&](std::int64_t i)
    {
      const auto pixel = static_cast<std::size_t>(i);
      all[pixel] = quartersOf(raster, layer, pixel);
    });
  std::vector<std::uint32_t> place(static_cast<std::size_t>(layer.size()), 0);
  for (const Quarters& quarters : all)
  {
    forCells(quarters, [&](std::size_t cell, std::uint32_t) { ++place[cell]; });
  }
  beginLists(place, level);
  for (std::size_t pixel = 0; pixel < all.size(); ++pixel)
  {
    forCells(all[pixel],
      [&](std::size_t cell, std::uint32_t times)
      {
        CoveredPixel& covered = level.pixels[place[cell]++];
        covered.pixel = static_cast<std::uint32_t>(pixel) & ((1u << 30) - 1u);
        covered.quartersLessOne = (times - 1u) & 3u;
      });
  }
}

// Of a cell without a pixel the neighbours that have some, by their number in the lists: where
// there are two it lies between pixels of the raster, else beyond what is seen.
std::vector<std::int32_t> seenAround(
  const CellLayer& layer, std::int32_t cell, const std::vector<std::int32_t>& numbers)
{
  std::vector<std::int32_t> seen;
  layer.appendNeighbours(cell, seen);
  const auto end = std::remove_if(seen.begin(), seen.end(),
    [&](std::int32_t other) { return numbers[static_cast<std::size_t>(other)] < 0; });
  seen.erase(end, seen.end());
  for (std::int32_t& other : seen)
  {
    other = numbers[static_cast<std::size_t>(other)];
  }
  return seen;
}

// Cells between pixels take those of the cells around: else views with fewer pixels would be
// missing in some of the cells that they share with others.
void closeGaps(const CellLayer& layer, ViewCoverage::Level& level)
{
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(layer.size()), -1);
  for (std::size_t i = 0; i < level.cells.size(); ++i)
  {
    numbers[static_cast<std::size_t>(level.cells[i])] = static_cast<std::int32_t>(i);
  }
  ViewCoverage::Level closed;
  closed.cells.reserve(2 * level.cells.size());
  closed.first.reserve(2 * level.cells.size());
  closed.pixels.reserve(2 * level.pixels.size());
  for (std::int32_t cell = 0; cell < layer.size(); ++cell)
  {
    std::vector<std::int32_t> from = { numbers[static_cast<std::size_t>(cell)] };
    if (from.front() < 0)
    {
      from = seenAround(layer, cell, numbers);
      if (from.size() < 2)
      {
        continue;
      }
    }
    closed.cells.push_back(cell);
    closed.first.push_back(static_cast<std::uint32_t>(closed.pixels.size()));
    for (const std::int32_t number : from)
    {
      const auto index = static_cast<std::size_t>(number);
      closed.pixels.insert(closed.pixels.end(), level.pixels.begin() + level.first[index],
        level.pixels.begin() + level.first[index + 1]);
    }
  }
  closed.first.push_back(static_cast<std::uint32_t>(closed.pixels.size()));
  level.cells = std::move(closed.cells);
  level.first = std::move(closed.first);
  level.pixels = std::move(closed.pixels);
}
} // namespace

ViewCoverage viewCoverage(
  const TriangleMesh& mesh, Span<const CellLayer> layers, const TextureView& view)
{
  ViewCoverage coverage;
  if (layers.empty() || layers.front().size() == 0)
  {
    return coverage;
  }
  const SurfaceCells& cells = layers.front().surface();
  const SurfaceRaster raster =
    rasterOf(mesh, cells.chartOfTriangle, view.modelToClip, 2 * view.width, 2 * view.height);
  if (raster.pixels == 0)
  {
    return coverage;
  }
  coverage.depth = depthOf(raster, cells);
  coverage.levels = levelsOf(coverage.depth);
  for (ViewCoverage::Level& level : coverage.levels)
  {
    const CellLayer& layer = layers[static_cast<std::size_t>(level.number)];
    listPixels(raster, layer, level);
    closeGaps(layer, level);
  }
  return coverage;
}

} // namespace hachure

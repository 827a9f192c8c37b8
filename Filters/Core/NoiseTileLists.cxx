// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseTileLists.h"

#include "Kernels.h"
#include "NoiseFieldTiles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr int leastTile = 16;
constexpr int largestTile = 64;
// Pixels by which discs count as larger: shaders round in another way.
constexpr float slack = 1e-2f;

struct Grid
{
  glm::vec2 corner{ 0.0f }; // of the rectangle
  float tile;
  int columns, rows;
};

float reachOf(const NoiseKernel& kernel)
{
  return glsl::kernelRadius(kernel.bandwidth) + slack;
}

// Between one and two tiles are as wide as the mean kernel.
int tileSizeFor(Span<const NoiseKernel> kernels)
{
  double sum = 0.0;
  double count = 0.0;
  for (const NoiseKernel& kernel : kernels)
  {
    if (noise::isDrawable(kernel))
    {
      sum += static_cast<double>(glsl::kernelRadius(kernel.bandwidth));
      count += 1.0;
    }
  }
  int size = leastTile;
  while (size < largestTile && size * count < sum)
  {
    size *= 2;
  }
  return size;
}

// First and last tile of a line of tiles that pixels from `low` to `high` lie in.
std::array<int, 2> tilesBetween(float low, float high, float tile, int count)
{
  const auto most = static_cast<float>(count);
  return { static_cast<int>(std::clamp(std::floor(low / tile), 0.0f, most)),
    static_cast<int>(std::clamp(std::floor(high / tile), -1.0f, most - 1.0f)) };
}

// Calls visit(tile) for the tiles that a kernel's disc meets.
template <class Visit>
void forTilesOf(const NoiseKernel& kernel, const Grid& grid, Visit&& visit)
{
  if (!noise::isDrawable(kernel))
  {
    return;
  }
  const float reach = reachOf(kernel);
  const glm::vec2 center = kernel.center - grid.corner;
  const auto rows = tilesBetween(center.y - reach, center.y + reach, grid.tile, grid.rows);
  for (int row = rows[0]; row <= rows[1]; ++row)
  {
    const float bottom = static_cast<float>(row) * grid.tile;
    const float y = center.y - std::clamp(center.y, bottom, bottom + grid.tile);
    const float half = std::sqrt(std::max(reach * reach - y * y, 0.0f));
    const auto columns = tilesBetween(center.x - half, center.x + half, grid.tile, grid.columns);
    for (int column = columns[0]; column <= columns[1]; ++column)
    {
      visit(static_cast<std::size_t>(row) * grid.columns + column);
    }
  }
}

void checkSize(const std::array<int, 4>& rectangle)
{
  if (rectangle[2] < 0 || rectangle[3] < 0)
  {
    throw std::invalid_argument(std::string("noise tiles: rectangle is ")
                                  .append(std::to_string(rectangle[2]))
                                  .append(" x ")
                                  .append(std::to_string(rectangle[3])));
  }
}

} // namespace

NoiseTileLists noiseTileLists(Span<const NoiseKernel> kernels, const std::array<int, 4>& rectangle)
{
  checkSize(rectangle);
  NoiseTileLists result;
  result.tileSize = tileSizeFor(kernels);
  const auto tilesIn = [&](int pixels) { return (pixels + result.tileSize - 1) / result.tileSize; };
  result.columns = tilesIn(rectangle[2]);
  result.rows = tilesIn(rectangle[3]);
  const Grid grid = { { rectangle[0], rectangle[1] }, static_cast<float>(result.tileSize),
    result.columns, result.rows };
  // Counts first, from which every tile knows where its kernels begin.
  std::vector<std::uint32_t>& starts = result.starts;
  starts.assign(static_cast<std::size_t>(result.columns) * result.rows + 1, 0);
  for (const NoiseKernel& kernel : kernels)
  {
    forTilesOf(kernel, grid, [&](std::size_t tile) { ++starts[tile + 1]; });
  }
  for (std::size_t i = 1; i < starts.size(); ++i)
  {
    starts[i] += starts[i - 1];
  }
  result.kernels.resize(starts.back());
  std::vector<std::uint32_t> next = starts;
  for (std::size_t i = 0; i < kernels.size(); ++i)
  {
    forTilesOf(kernels[i], grid,
      [&](std::size_t tile) { result.kernels[next[tile]++] = static_cast<std::uint32_t>(i); });
  }
  return result;
}

} // namespace hachure

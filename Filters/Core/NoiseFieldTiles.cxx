// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseFieldTiles.h"

#include "Kernels.h"
#include "NoiseVisibility.h"
#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace hachure::noise
{

namespace
{

// Kernels that one thread prepares at a time.
constexpr std::int64_t kernelsPerChunk = 1024;

std::int64_t divideUp(std::int64_t value, std::int64_t divisor)
{
  return (value + divisor - 1) / divisor;
}

// The grid of all tiles of a rectangle.
struct Grid
{
  int left, bottom, width, height, margin;
  int columns, rows;

  Grid(const NoiseSurroundings& surroundings, int pixelsMore)
    : left(surroundings.rectangle[0])
    , bottom(surroundings.rectangle[1])
    , width(surroundings.rectangle[2])
    , height(surroundings.rectangle[3])
    , margin(pixelsMore)
    , columns(static_cast<int>(divideUp(width, tileWidth)))
    , rows(static_cast<int>(divideUp(height, tileHeight)))
  {
  }
  std::int64_t size() const { return static_cast<std::int64_t>(this->columns) * this->rows; }
  Tile at(std::int64_t index) const
  {
    const int column = static_cast<int>(index % this->columns) * tileWidth;
    const int row = static_cast<int>(index / this->columns) * tileHeight;
    Tile tile;
    tile.left = this->left + column;
    tile.right = this->left + std::min(column + tileWidth, this->width);
    tile.bottom = this->bottom + row;
    tile.top = this->bottom + std::min(row + tileHeight, this->height);
    return tile;
  }
};

// The least depth of every column of a tile.
using ColumnDepths = std::array<float, tileWidth>;

ColumnDepths leastDepths(const float* depth, std::size_t stride, int width, int height)
{
  ColumnDepths least;
  least.fill(1.0f);
  for (int row = 0; row < height; ++row)
  {
    const float* line = depth + row * stride;
    for (int column = 0; column < width; ++column)
    {
      least[column] = line[column] < least[column] ? line[column] : least[column];
    }
  }
  return least;
}

// Cuts a tile down to the pixels in which something is seen; whether there are any.
bool cutToSeen(const NoiseSurroundings& surroundings, const Grid& grid, Tile& tile)
{
  if (surroundings.depth.empty())
  {
    return true;
  }
  const std::size_t stride = grid.width;
  const float* depth =
    &surroundings.depth[(tile.bottom - grid.bottom) * stride + (tile.left - grid.left)];
  const int width = tile.right - tile.left;
  const int height = tile.top - tile.bottom;
  const ColumnDepths least = leastDepths(depth, stride, width, height);
  const auto there = [](float value) { return value < 1.0f; };
  const float* first = std::find_if(least.data(), least.data() + width, there);
  if (first == least.data() + width)
  {
    return false;
  }
  const auto empty = [&](int row)
  { return std::none_of(depth + row * stride, depth + row * stride + width, there); };
  int below = 0, above = height;
  while (empty(below))
  {
    ++below;
  }
  while (empty(above - 1))
  {
    --above;
  }
  int last = width;
  while (!there(least[last - 1]))
  {
    --last;
  }
  tile = { tile.left + static_cast<int>(first - least.data()), tile.left + last,
    tile.bottom + below, tile.bottom + above, 0, 0, false, 0 };
  return true;
}

// Whether all that is seen in the tile and its margin belongs to one object, and to which.
void findObject(const NoiseSurroundings& surroundings, const Grid& grid, Tile& tile)
{
  std::optional<std::int32_t> found;
  const int left = std::max(tile.left - grid.margin, grid.left);
  const int right = std::min(tile.right + grid.margin, grid.left + grid.width);
  const int top = std::min(tile.top + grid.margin, grid.bottom + grid.height);
  for (int row = std::max(tile.bottom - grid.margin, grid.bottom); row < top; ++row)
  {
    const std::size_t line = static_cast<std::size_t>(row - grid.bottom) * grid.width;
    for (int column = left; column < right; ++column)
    {
      const std::size_t pixel = line + (column - grid.left);
      const std::int32_t object = surroundings.objects[pixel];
      if (!surroundings.depth.empty() && !(surroundings.depth[pixel] < 1.0f))
      {
        continue;
      }
      if (found && *found != object)
      {
        return;
      }
      found = object;
    }
  }
  tile.oneObject = found.has_value();
  tile.object = found.value_or(0);
}

// First pixel at or behind a place, as far as it lies in a range of pixels or just behind it.
int firstPixel(float place, int begin, int count)
{
  const float inside =
    std::clamp(place - 0.5f - static_cast<float>(begin), 0.0f, static_cast<float>(count));
  const auto whole = static_cast<int>(inside);
  return begin + whole + (static_cast<float>(whole) < inside ? 1 : 0);
}

// Sets the pixels of the rectangle in a kernel's disc, maybe a few more; whether there are any.
bool setPixels(const NoiseKernel& kernel, float radius, const Grid& grid, TileKernel& result)
{
  constexpr float slack = 1e-2f;
  const float reach = radius + slack;
  result.left = firstPixel(kernel.center.x - reach, grid.left, grid.width);
  result.right = firstPixel(kernel.center.x + reach, grid.left, grid.width);
  result.bottom = firstPixel(kernel.center.y - reach, grid.bottom, grid.height);
  result.top = firstPixel(kernel.center.y + reach, grid.bottom, grid.height);
  return result.left < result.right && result.bottom < result.top;
}

TileKernel prepare(const NoiseKernel& kernel, const NoiseVisibility& visibility,
  const NoiseSurroundings& surroundings, const Grid& grid)
{
  TileKernel result;
  const float radius = isDrawable(kernel) ? glsl::kernelRadius(kernel.bandwidth) : 0.0f;
  if (!(radius > 0.0f) || !setPixels(kernel, radius, grid, result))
  {
    return result;
  }
  const NoiseShare share = visibility.share(kernel, radius);
  if (!(share.seen > 0.0f))
  {
    return result;
  }
  result.x = kernel.center.x;
  result.y = kernel.center.y;
  result.radius = radius;
  result.decay = glsl::screenPi * kernel.bandwidth * kernel.bandwidth;
  result.directionX = std::cos(kernel.orientation);
  result.directionY = std::sin(kernel.orientation);
  result.turnX = kernel.frequency * result.directionX;
  result.turnY = kernel.frequency * result.directionY;
  result.turn = kernel.phase * (0.5f / glsl::screenPi);
  result.weight = kernel.weight * (surroundings.partialVisibility ? share.seen : 1.0f);
  result.depth = kernel.depth;
  result.slopeX = kernel.depthSlope.x;
  result.slopeY = kernel.depthSlope.y;
  result.onPlane = share.complete || surroundings.depth.empty() || !surroundings.depthTest;
  result.triangle = kernel.triangle;
  result.object = kernel.object;
  return result;
}

// Calls visit(tile) for the tiles of the grid that a kernel's pixels lie in, margins included.
template <class Visit>
void forReachedTiles(const TileKernel& kernel, const Grid& grid, Visit&& visit)
{
  if (!(kernel.weight > 0.0f))
  {
    return;
  }
  const int left = std::max(kernel.left - grid.left - grid.margin, 0) / tileWidth;
  const int right =
    std::min((kernel.right - 1 - grid.left + grid.margin) / tileWidth, grid.columns - 1);
  const int bottom = std::max(kernel.bottom - grid.bottom - grid.margin, 0) / tileHeight;
  const int top =
    std::min((kernel.top - 1 - grid.bottom + grid.margin) / tileHeight, grid.rows - 1);
  for (int row = bottom; row <= top; ++row)
  {
    for (int column = left; column <= right; ++column)
    {
      visit(static_cast<std::size_t>(row) * grid.columns + column);
    }
  }
}

bool meets(const TileKernel& kernel, const Tile& tile, int margin)
{
  return kernel.left < tile.right + margin && kernel.right > tile.left - margin &&
    kernel.bottom < tile.top + margin && kernel.top > tile.bottom - margin &&
    (!tile.oneObject || tile.object == kernel.object);
}

// Seen tiles of the grid, and for every tile of the grid its index among them or -1.
std::vector<std::int32_t> findTiles(
  const NoiseSurroundings& surroundings, const Grid& grid, std::vector<Tile>& tiles)
{
  std::vector<Tile> all(static_cast<std::size_t>(grid.size()));
  std::vector<std::int32_t> index(all.size(), -1);
  parallelForRanges(grid.size(), 4,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        all[i] = grid.at(i);
        index[i] = cutToSeen(surroundings, grid, all[i]) ? 0 : -1;
        if (index[i] == 0 && !surroundings.objects.empty())
        {
          findObject(surroundings, grid, all[i]);
        }
      }
    });
  tiles.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (index[i] == 0)
    {
      index[i] = static_cast<std::int32_t>(tiles.size());
      tiles.push_back(all[i]);
    }
  }
  return index;
}

// Turns counts per chunk and tile into the places where each chunk writes, and sets the tiles'
// ranges: a tile's kernels keep their order. Returns the number of all entries.
std::int64_t placeEntries(
  std::vector<std::int64_t>& counts, std::int64_t chunks, std::vector<Tile>& tiles)
{
  std::int64_t sum = 0;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
  {
    tiles[tile].begin = sum;
    for (std::int64_t chunk = 0; chunk < chunks; ++chunk)
    {
      std::int64_t& count = counts[chunk * tiles.size() + tile];
      const std::int64_t place = sum;
      sum += count;
      count = place;
    }
    tiles[tile].end = sum;
  }
  return sum;
}

} // namespace

bool isDrawable(const NoiseKernel& kernel)
{
  const float sum = kernel.center.x + kernel.center.y + kernel.weight + kernel.phase +
    kernel.frequency + kernel.bandwidth + kernel.orientation + kernel.depth + kernel.depthSlope.x +
    kernel.depthSlope.y;
  return std::isfinite(sum) && kernel.weight > 0.0f && kernel.bandwidth > 0.0f;
}

TiledKernels tileKernels(
  Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings, int margin)
{
  const Grid grid(surroundings, margin);
  TiledKernels result;
  const std::vector<std::int32_t> index = findTiles(surroundings, grid, result.tiles);
  const NoiseVisibility visibility(surroundings, kernels);
  const auto total = static_cast<std::int64_t>(kernels.size());
  const std::int64_t chunks = divideUp(total, kernelsPerChunk);
  std::vector<std::int64_t> counts(static_cast<std::size_t>(chunks) * result.tiles.size(), 0);
  result.kernels.resize(kernels.size());
  const auto forEntries = [&](std::int64_t i, auto&& visit)
  {
    const TileKernel& kernel = result.kernels[i];
    const std::size_t line = i / kernelsPerChunk * result.tiles.size();
    forReachedTiles(kernel, grid,
      [&](std::size_t tile)
      {
        if (index[tile] >= 0 && meets(kernel, result.tiles[index[tile]], margin))
        {
          visit(counts[line + index[tile]]);
        }
      });
  };
  parallelForRanges(total, kernelsPerChunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        result.kernels[i] = prepare(kernels[i], visibility, surroundings, grid);
        forEntries(i, [](std::int64_t& count) { ++count; });
      }
    });
  result.order.resize(placeEntries(counts, chunks, result.tiles));
  parallelForRanges(total, kernelsPerChunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        forEntries(
          i, [&](std::int64_t& place) { result.order[place++] = static_cast<std::uint32_t>(i); });
      }
    });
  return result;
}

void forTiles(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, int margin,
  const std::function<void(const Tile&, TileSums&)>& finish)
{
  const TiledKernels tiled = tileKernels(kernels, surroundings, margin);
  std::optional<SpotTexels> spot;
  if (options.kind == NoiseKind::spot)
  {
    spot.emplace(*options.spot);
  }
  const TileTask task = { &surroundings, &tiled, &options, spot ? &*spot : nullptr };
  // Whoever is free takes the next tile: some have many kernels and most have few.
  const auto total = static_cast<std::int64_t>(tiled.tiles.size());
  std::atomic<std::int64_t> next{ 0 };
  parallelForRanges(std::min<std::int64_t>(maximumThreads(), total), 1,
    [&](std::int64_t, std::int64_t)
    {
      TileSums sums;
      for (std::int64_t i = next++; i < total; i = next++)
      {
        sumTile(task, tiled.tiles[i], margin, sums);
        finish(tiled.tiles[i], sums);
      }
    });
}

} // namespace hachure::noise

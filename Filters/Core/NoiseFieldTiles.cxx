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

// First and last tile in one direction whose pixels, margins included, a kernel reaches. False if
// there are none.
template <int size>
bool findTiles(float center, float radius, int begin, int margin, int pixels, int count,
  std::uint16_t& first, std::uint16_t& last)
{
  const float place = center - static_cast<float>(begin);
  const auto grown = static_cast<float>(margin);
  if (!(place + radius > 0.0f && place - radius < static_cast<float>(pixels)))
  {
    return false;
  }
  const float most = static_cast<float>(pixels) + grown;
  const int low = static_cast<int>(std::max(place - radius - grown - 1.0f, 0.0f)) / size;
  const int high = static_cast<int>(std::min(place + radius + grown, most)) / size;
  first = static_cast<std::uint16_t>(low);
  last = static_cast<std::uint16_t>(std::min(high, count - 1));
  return true;
}

bool findTiles(const Grid& grid, const NoiseKernel& kernel, TileKernel& result)
{
  return findTiles<tileWidth>(kernel.center.x, result.radius, grid.left, grid.margin, grid.width,
           grid.columns, result.left, result.right) &&
    findTiles<tileHeight>(kernel.center.y, result.radius, grid.bottom, grid.margin, grid.height,
      grid.rows, result.bottom, result.top);
}

// What both passes need to know.
struct Binning
{
  const NoiseVisibility& visibility;
  const NoiseSurroundings& surroundings;
  const Grid& grid;
  bool spots;
};

void prepare(const NoiseKernel& kernel, const Binning& binning, TileKernel& result)
{
  result.weight = 0.0f;
  result.radius = isDrawable(kernel) ? glsl::kernelRadius(kernel.bandwidth) : 0.0f;
  if (!(result.radius > 0.0f) || !findTiles(binning.grid, kernel, result))
  {
    return;
  }
  const NoiseSurroundings& surroundings = binning.surroundings;
  const NoiseShare share = binning.visibility.share(kernel, result.radius);
  result.weight =
    kernel.weight * (surroundings.partialVisibility || share.seen == 0.0f ? share.seen : 1.0f);
  result.x = kernel.center.x;
  result.y = kernel.center.y;
  result.decay = glsl::screenPi * kernel.bandwidth * kernel.bandwidth;
  const float cycles = binning.spots ? 1.0f : kernel.frequency;
  result.turnX = cycles * std::cos(kernel.orientation);
  result.turnY = cycles * std::sin(kernel.orientation);
  result.turn = kernel.phase * (0.5f / glsl::screenPi);
  result.depth = kernel.depth;
  result.slopeX = kernel.depthSlope.x;
  result.slopeY = kernel.depthSlope.y;
  result.onPlane = share.complete || surroundings.depth.empty() || !surroundings.depthTest ? 1 : 0;
  result.triangle = kernel.triangle;
  result.object = kernel.object;
}

// Calls visit(tile) for the tiles of the grid that a kernel may reach.
template <class Visit>
void forReachedTiles(const TileKernel& kernel, const Grid& grid, Visit&& visit)
{
  if (!(kernel.weight > 0.0f))
  {
    return;
  }
  for (int row = kernel.bottom; row <= kernel.top; ++row)
  {
    for (int column = kernel.left; column <= kernel.right; ++column)
    {
      visit(static_cast<std::size_t>(row) * grid.columns + column);
    }
  }
}

// Whether the box around a kernel's disc meets the tile.
bool meets(const TileKernel& kernel, const Tile& tile, int margin)
{
  const auto near = [&](float center, int begin, int end)
  {
    return center + kernel.radius > static_cast<float>(begin - margin) &&
      center - kernel.radius < static_cast<float>(end + margin);
  };
  return near(kernel.x, tile.left, tile.right) && near(kernel.y, tile.bottom, tile.top) &&
    (!tile.oneObject || tile.object == kernel.object);
}

// Seen tiles of the grid, and for every tile of the grid its index among them or -1.
std::vector<std::int32_t> seenTiles(
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

// Prepares kernels [begin, end) and counts them for their tiles.
void fillEntries(Span<const NoiseKernel> from, std::int64_t begin, std::int64_t end,
  const Binning& binning, Span<const std::int32_t> index, TiledKernels& tiled, std::int64_t* counts,
  TileEntries& entries)
{
  entries.tiles.clear();
  entries.kernels.clear();
  entries.tiles.reserve(2 * kernelsPerChunk);
  entries.kernels.reserve(2 * kernelsPerChunk);
  for (std::int64_t i = begin; i < end; ++i)
  {
    TileKernel& kernel = tiled.kernels[i];
    prepare(from[i], binning, kernel);
    forReachedTiles(kernel, binning.grid,
      [&](std::size_t place)
      {
        const std::int32_t tile = index[place];
        if (tile >= 0 && meets(kernel, tiled.tiles[tile], binning.grid.margin))
        {
          entries.tiles.push_back(static_cast<std::uint32_t>(tile));
          entries.kernels.push_back(static_cast<std::uint32_t>(i));
          ++counts[tile];
        }
      });
  }
}

} // namespace

bool isDrawable(const NoiseKernel& kernel)
{
  const float sum = kernel.center.x + kernel.center.y + kernel.weight + kernel.phase +
    kernel.frequency + kernel.bandwidth + kernel.orientation + kernel.depth + kernel.depthSlope.x +
    kernel.depthSlope.y;
  return std::isfinite(sum) && kernel.weight > 0.0f && kernel.bandwidth > 0.0f;
}

void tileKernels(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, int margin, TiledKernels& result)
{
  const Grid grid(surroundings, margin);
  result.tiles.clear();
  const std::vector<std::int32_t> index = seenTiles(surroundings, grid, result.tiles);
  const NoiseVisibility visibility(surroundings, kernels);
  const Binning binning = { visibility, surroundings, grid, options.kind == NoiseKind::spot };
  const auto total = static_cast<std::int64_t>(kernels.size());
  const std::int64_t chunks = divideUp(total, kernelsPerChunk);
  result.counts.assign(static_cast<std::size_t>(chunks) * result.tiles.size(), 0);
  if (result.entries.size() < static_cast<std::size_t>(chunks))
  {
    result.entries.resize(static_cast<std::size_t>(chunks));
  }
  if (result.capacity < kernels.size())
  {
    result.capacity = kernels.size() + kernels.size() / 4;
    result.kernels.reset(new TileKernel[result.capacity]);
  }
  const auto countsOf = [&](std::int64_t chunk)
  { return result.counts.data() + static_cast<std::size_t>(chunk) * result.tiles.size(); };
  parallelForRanges(total, kernelsPerChunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      const std::int64_t chunk = begin / kernelsPerChunk;
      fillEntries(
        kernels, begin, end, binning, index, result, countsOf(chunk), result.entries[chunk]);
    });
  result.order.resize(placeEntries(result.counts, chunks, result.tiles));
  parallelForRanges(chunks, 1,
    [&](std::int64_t chunk, std::int64_t)
    {
      std::int64_t* const places = countsOf(chunk);
      const TileEntries& entries = result.entries[chunk];
      for (std::size_t i = 0; i < entries.tiles.size(); ++i)
      {
        result.order[places[entries.tiles[i]]++] = entries.kernels[i];
      }
    });
}

void forTiles(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, int margin, NoiseFieldMemory::Data& memory,
  const std::function<void(const Tile&, TileSums&)>& finish)
{
  const TiledKernels& tiled = memory.tiled;
  tileKernels(kernels, surroundings, options, margin, memory.tiled);
  std::optional<SpotTexels> spot;
  if (options.kind == NoiseKind::spot)
  {
    spot.emplace(*options.spot);
  }
  const TileTask task = { &surroundings, &tiled, &options, spot ? &*spot : nullptr };
  // Whoever is free takes the next tile: some have many kernels and most have few.
  const auto total = static_cast<std::int64_t>(tiled.tiles.size());
  std::atomic<std::int64_t> next{ 0 };
  const std::int64_t threads = std::min<std::int64_t>(maximumThreads(), total);
  memory.sums.resize(std::max(memory.sums.size(), static_cast<std::size_t>(threads)));
  parallelForRanges(threads, 1,
    [&](std::int64_t thread, std::int64_t)
    {
      TileSums& sums = memory.sums[thread];
      for (std::int64_t i = next++; i < total; i = next++)
      {
        sumTile(task, tiled.tiles[i], margin, sums);
        finish(tiled.tiles[i], sums);
      }
    });
}

} // namespace hachure::noise

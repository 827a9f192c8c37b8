// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseFieldTiles_h
#define hachure_NoiseFieldTiles_h

#include "NoiseField.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

// How the sums of a noise are made: the rectangle is cut into tiles, which stay in the fastest
// cache, and every tile sums up the kernels that meet it. A pixel's sum has the order of the
// kernels, and each of its terms is a function of kernel and pixel alone.
namespace hachure::noise
{

// Pixels of a tile; it is cut down to what is seen in it.
constexpr int tileWidth = 64;
constexpr int tileHeight = 64;

// A kernel that is drawn, as the loops over pixels want it: one line of the cache, since a tile's
// kernels lie anywhere. Nothing but the weight is set where that is 0.
struct alignas(64) TileKernel
{
  float x, y;
  float radius;
  float decay;        // pi a^2
  float turnX, turnY; // turns per pixel; of spots the direction
  float turn;         // phase
  float weight;       // 0: not drawn
  float depth, slopeX, slopeY;
  std::int32_t onPlane; // whether all pixels of the disc are
  std::int32_t triangle, object;
  std::uint16_t left, right, bottom, top; // first and last tiles of the grid, in both directions
};

// The columns [left, right) and rows [bottom, top) of the framebuffer, and its kernels.
struct Tile
{
  int left = 0, right = 0, bottom = 0, top = 0;
  std::int64_t begin = 0, end = 0; // in TiledKernels::order
  bool oneObject = false;          // all that is seen here
  std::int32_t object = 0;
};

// The tiles that some kernels meet, one kernel after the other.
struct TileEntries
{
  std::vector<std::uint32_t> tiles;
  std::vector<std::uint32_t> kernels; // of each entry
};

struct TiledKernels
{
  std::unique_ptr<TileKernel[]> kernels;
  std::size_t capacity = 0;
  std::vector<Tile> tiles; // those with something seen in them
  std::vector<std::uint32_t> order;
  // To make them: entries of every chunk of kernels, and how many of each tile.
  std::vector<TileEntries> entries;
  std::vector<std::int64_t> counts;
};

// A spot ready to be sampled: mean 0, with one more texel on every side.
struct SpotTexels
{
  int width = 0, height = 0; // without those
  float square = 0.0f;       // mean of the squares
  std::vector<float> values;
  explicit SpotTexels(const NoiseSpot& spot);
};

// The sums of a tile's pixels and of `margin` more on every side, as far as the rectangle goes;
// around them one line of pixels that nobody has summed up, and at the end of every line room for
// sixteen more. A line of first sums (sums or real parts) is followed by its line of second sums
// (variances or imaginary parts), so that both are in one stream; the other arrays have their lines
// at the same places.
struct TileSums
{
  static constexpr int toSecond = tileWidth + 24;
  static constexpr int stride = 2 * toSecond;
  int left = 0, bottom = 0, width = 0, height = 0;
  std::vector<float> sums;
  // What is known of the pixels, once a kernel needs it.
  bool isKnown = false;
  std::vector<float> depth;
  std::vector<std::int32_t> objects, triangles;
  std::vector<std::int32_t> seen; // all bits where something is, none elsewhere

  // Makes room for a tile, with sums of 0.
  void prepare(const NoiseSurroundings& surroundings, const Tile& tile, int margin);
  void copyKnown(const NoiseSurroundings& surroundings);

  std::size_t place(int column, int row) const // in the framebuffer
  {
    return static_cast<std::size_t>(row - this->bottom + 1) * stride + (column - this->left + 1);
  }
};

// What all tiles have in common.
struct TileTask
{
  const NoiseSurroundings* surroundings;
  const TiledKernels* tiled;
  const NoiseFieldOptions* options;
  const SpotTexels* spot; // of spot noise only
};

// Throws std::invalid_argument for what does not fit together.
void checkNoiseInput(const NoiseSurroundings& surroundings, const NoiseFieldOptions& options);

// Whether a kernel has finite parameters, a weight and an extent.
bool isDrawable(const NoiseKernel& kernel);

// Variance that is hardly any; of phasors it has no meaning.
float lowestVariance(const NoiseFieldOptions& options);

// Kernels of the rectangle's tiles, grown by `margin` pixels, into memory of a frame before.
void tileKernels(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, int margin, TiledKernels& result);

// Sums of one tile. `sums` is reused from tile to tile.
void sumTile(const TileTask& task, const Tile& tile, int margin, TileSums& sums);

// Calls finish(tile, sums) for all tiles, in parallel.
void forTiles(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, int margin, NoiseFieldMemory::Data& memory,
  const std::function<void(const Tile&, TileSums&)>& finish);

} // namespace hachure::noise

namespace hachure
{

struct NoiseFieldMemory::Data
{
  noise::TiledKernels tiled;
  std::vector<noise::TileSums> sums; // of every thread
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternTile.h"

#include "Parallel.h"
#include "TileChecks.h"
#include "TileNoise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace hachure
{
namespace
{

// Order among equal values: a two-dimensional golden-ratio sequence (Roberts' R2), so that every
// small neighbourhood receives early and late ranks alike and an edge shows neither drift nor
// clumps.
std::uint32_t tieKey(int x, int y)
{
  constexpr std::uint32_t stepX = 3242174889u; // 2^32 / 1.32472
  constexpr std::uint32_t stepY = 2447445414u; // 2^32 / 1.32472^2
  return static_cast<std::uint32_t>(x) * stepX + static_cast<std::uint32_t>(y) * stepY;
}

struct Rank
{
  float value;
  std::uint32_t key;
  std::int32_t texel;
};

// Values by rank, with ties sharing their mean rank, and the range of ranks that a tie covers.
struct RankedField
{
  std::vector<float> middle;
  std::vector<float> span;
};

std::vector<Rank> sortedTexels(const std::vector<float>& field, int width)
{
  std::vector<Rank> order(field.size());
  parallelFor(static_cast<std::int64_t>(field.size()),
    [&](std::int64_t i)
    {
      const int texel = static_cast<int>(i);
      order[i] = { field[i], tieKey(texel % width, texel / width), texel };
    });
  std::sort(order.begin(), order.end(),
    [](const Rank& a, const Rank& b)
    {
      if (a.value != b.value)
      {
        return a.value < b.value;
      }
      return a.key != b.key ? a.key < b.key : a.texel < b.texel;
    });
  return order;
}

// Fills screen and levels; returns what the gradient is made from.
RankedField rankTexels(const std::vector<float>& field, PatternTile& tile)
{
  const std::vector<Rank> order = sortedTexels(field, tile.width);
  const std::size_t count = order.size();
  const double share = 1.0 / static_cast<double>(count);
  RankedField ranked{ std::vector<float>(count), std::vector<float>(count) };
  tile.screen.resize(count);
  tile.levels = 0;
  for (std::size_t begin = 0; begin < count;)
  {
    std::size_t end = begin;
    while (end < count && order[end].value == order[begin].value)
    {
      ++end;
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::int32_t texel = order[i].texel;
      tile.screen[texel] = static_cast<float>((static_cast<double>(i) + 0.5) * share);
      ranked.middle[texel] = static_cast<float>(0.5 * static_cast<double>(begin + end) * share);
      ranked.span[texel] = static_cast<float>(static_cast<double>(end - begin) * share);
    }
    ++tile.levels;
    begin = end;
  }
  return ranked;
}

// The steeper of the two one-sided differences: at a ridge the central one would vanish.
float steeperSide(float before, float here, float after)
{
  return std::max(std::abs(after - here), std::abs(here - before));
}

void fillGradientAndTies(const RankedField& ranked, PatternTile& tile)
{
  const int width = tile.width;
  const int height = tile.height;
  // A screen that crosses its whole range once in four tile widths: no pattern is flatter on
  // purpose.
  const float flattest = 0.25f / static_cast<float>(std::max(width, height));
  const float perBaseTexel = static_cast<float>(1.0 / tile.texelSize);
  tile.gradient.resize(ranked.middle.size());
  parallelFor(height,
    [&](std::int64_t y)
    {
      const float* row = &ranked.middle[static_cast<std::size_t>(y) * width];
      const float* below =
        &ranked.middle[static_cast<std::size_t>((y + height - 1) % height) * width];
      const float* above = &ranked.middle[static_cast<std::size_t>((y + 1) % height) * width];
      for (int x = 0; x < width; ++x)
      {
        const std::size_t texel = static_cast<std::size_t>(y) * width + x;
        const float alongX =
          steeperSide(row[(x + width - 1) % width], row[x], row[(x + 1) % width]);
        const float alongY = steeperSide(below[x], row[x], above[x]);
        const float slope = std::sqrt(alongX * alongX + alongY * alongY);
        tile.gradient[texel] = std::max({ slope, ranked.span[texel], flattest }) * perBaseTexel;
        // Where the field goes on to other values, filtering between texels spreads a tie evenly,
        // and exactly along the field's own lines; only flat areas need their texels told apart.
        if (slope >= 0.5f * ranked.span[texel])
        {
          tile.screen[texel] = ranked.middle[texel];
        }
      }
    });
}

PatternTile equalisedTile(
  const std::vector<float>& field, int width, int height, int periods, double texelSize)
{
  PatternTile tile;
  tile.width = width;
  tile.height = height;
  tile.periods = periods;
  tile.texelSize = texelSize;
  fillGradientAndTies(rankTexels(field, tile), tile);
  return tile;
}

// Mean over the area that a texel of the smaller image covers; along one line of `count` values.
void halveLine(const float* from, std::size_t stride, int count, float* to, std::size_t toStride)
{
  const int half = std::max(1, count / 2);
  const double scale = static_cast<double>(count) / half;
  for (int i = 0; i < half; ++i)
  {
    double sum = 0.0;
    const double begin = i * scale;
    const double end = begin + scale;
    for (int j = static_cast<int>(begin); j < count && j < end; ++j)
    {
      const double overlap = std::min<double>(end, j + 1) - std::max<double>(begin, j);
      sum += overlap * from[j * stride];
    }
    to[i * toStride] = static_cast<float>(sum / scale);
  }
}

std::vector<float> halvedField(const PatternTile& tile)
{
  const int halfWidth = std::max(1, tile.width / 2);
  const int halfHeight = std::max(1, tile.height / 2);
  std::vector<float> narrow(static_cast<std::size_t>(halfWidth) * tile.height);
  std::vector<float> half(static_cast<std::size_t>(halfWidth) * halfHeight);
  parallelFor(tile.height,
    [&](std::int64_t y)
    { halveLine(&tile.screen[y * tile.width], 1, tile.width, &narrow[y * halfWidth], 1); });
  parallelFor(halfWidth,
    [&](std::int64_t x) { halveLine(&narrow[x], halfWidth, tile.height, &half[x], halfWidth); });
  return half;
}

// cos(2 pi periods (texel + .5) / size), folded so that mirror images are equal to the last bit.
std::vector<double> foldedCosine(int size, int periods)
{
  std::vector<double> cosine(size);
  const std::int64_t turn = 2 * static_cast<std::int64_t>(size);
  for (int i = 0; i < size; ++i)
  {
    const std::int64_t phase = (2 * static_cast<std::int64_t>(i) + 1) * periods % turn;
    cosine[i] = std::cos(pi * static_cast<double>(std::min(phase, turn - phase)) / size);
  }
  return cosine;
}

} // namespace

PatternTile imageTile(Span<const float> grey, int width, int height, int periods)
{
  check::atLeast("imageTile", "width", width, 1);
  check::atLeast("imageTile", "height", height, 1);
  check::atLeast("imageTile", "periods", periods, 1);
  const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (texels > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()) ||
    grey.size() != texels)
  {
    check::fail("imageTile", "grey",
      std::to_string(grey.size()) + " values for " + std::to_string(width) + " x " +
        std::to_string(height) + " texels");
  }
  std::vector<float> field(grey.begin(), grey.end());
  const auto bad =
    std::find_if(field.begin(), field.end(), [](float value) { return !std::isfinite(value); });
  if (bad != field.end())
  {
    check::fail("imageTile", "grey",
      "value " + std::to_string(*bad) + " at texel " + std::to_string(bad - field.begin()) +
        ", expected finite values");
  }
  return equalisedTile(field, width, height, periods, 1.0);
}

PatternTile halftoneTile(const HatchOptions& options)
{
  check::hatchOptions("halftoneTile", options);
  const int size = options.size;
  const std::vector<double> cosine = foldedCosine(size, options.periods);
  // Largest displacement of a dot in periods, and largest change of the tone at which it appears.
  const double displacement = 0.22 * options.irregularity;
  const double unevenness = 0.16 * options.irregularity;
  const double cell = static_cast<double>(options.periods) / size;
  std::vector<float> field(static_cast<std::size_t>(size) * size);
  const auto ruled = [&](int x, int y) { return 0.5 - 0.25 * (cosine[x] + cosine[y]); };
  const auto drawn = [&](int x, int y)
  {
    const double u = (x + 0.5) * cell;
    const double v = (y + 0.5) * cell;
    const auto noise = [&](std::uint32_t dimension)
    { return cellNoise(u, v, options.periods, options.seed, dimension); };
    const double warpedU = u + displacement * noise(0);
    const double warpedV = v + displacement * noise(1);
    return 0.5 - 0.25 * (std::cos(2.0 * pi * warpedU) + std::cos(2.0 * pi * warpedV)) +
      unevenness * noise(2);
  };
  parallelFor(size,
    [&](std::int64_t y)
    {
      for (int x = 0; x < size; ++x)
      {
        const int row = static_cast<int>(y);
        const double value = options.irregularity > 0.0 ? drawn(x, row) : ruled(x, row);
        field[static_cast<std::size_t>(y) * size + x] = static_cast<float>(value);
      }
    });
  return equalisedTile(field, size, size, options.periods, 1.0);
}

std::vector<PatternTile> mipChain(const PatternTile& tile)
{
  check::tile("mipChain", tile);
  std::vector<PatternTile> chain{ tile };
  while (chain.back().width > 1 || chain.back().height > 1)
  {
    const PatternTile& last = chain.back();
    PatternTile next = equalisedTile(halvedField(last), std::max(1, last.width / 2),
      std::max(1, last.height / 2), tile.periods, 2.0 * last.texelSize);
    next.levels = tile.levels;
    chain.push_back(std::move(next));
  }
  return chain;
}

} // namespace hachure

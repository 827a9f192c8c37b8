// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseField.h"

#include "NoiseFieldLanes.h"
#include "NoiseFieldTiles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Width where nothing is drawn, and the least.
constexpr float leastWidth = 1e-6f;
// Mean of envelope^2 / 2 over a kernel's disc: (1 - .05^2) / (4 * 2.9957).
constexpr float meanKernelVariance = 0.0832f;

[[noreturn]] void refuse(const std::string& name, const std::string& found)
{
  throw std::invalid_argument(std::string("noise field: ").append(name).append(" ").append(found));
}

template <class T>
void checkLength(const char* name, Span<const T> values, std::size_t expected)
{
  if (!values.empty() && values.size() != expected)
  {
    refuse(name,
      "has " + std::to_string(values.size()) + " elements, expected " + std::to_string(expected) +
        " as in the rectangle, or none");
  }
}

void checkSurroundings(const NoiseSurroundings& surroundings)
{
  const auto [left, bottom, width, height] = surroundings.rectangle;
  // Coordinates of pixels are exact in single precision.
  constexpr int most = 1 << 20;
  for (const int value : { left, bottom, width, height })
  {
    if (value < -most || value > most)
    {
      refuse("rectangle", "has the number " + std::to_string(value) + ", expected at most 2^20");
    }
  }
  if (width < 0 || height < 0)
  {
    refuse("rectangle", "is " + std::to_string(width) + " x " + std::to_string(height));
  }
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  checkLength("depth", surroundings.depth, pixels);
  checkLength("objects", surroundings.objects, pixels);
  checkLength("triangles", surroundings.triangles, pixels);
  if (!(surroundings.depthTolerance > 0.0f && std::isfinite(surroundings.depthTolerance)))
  {
    refuse("depthTolerance",
      "is " + std::to_string(surroundings.depthTolerance) + ", expected a finite depth above 0");
  }
}

void checkSpot(const NoiseSpot* spot)
{
  if (!spot)
  {
    refuse("spot", "is missing, which spot noise is made of");
  }
  if (spot->width < 1 || spot->height < 1 ||
    spot->values.size() != static_cast<std::size_t>(spot->width) * spot->height)
  {
    refuse("spot",
      "has " + std::to_string(spot->values.size()) + " values for " + std::to_string(spot->width) +
        " x " + std::to_string(spot->height));
  }
  for (const float value : spot->values)
  {
    if (!std::isfinite(value))
    {
      refuse("spot", "has the value " + std::to_string(value));
    }
  }
}

// From normalised sums to their share, what counts as no variance, and the least width.
struct ValueTable
{
  const float* share;
  float range, steps;
  float lowest;
  float leastWidth;
};

// Values of eight sums, by linear interpolation.
HACHURE_INLINED FloatLanes valueLanes(
  const ValueTable& table, const FloatLanes& sum, const FloatLanes& variance)
{
  const FloatLanes scaled = sum / rootLanes(variance + table.lowest) * (0.5f / table.range) + 0.5f;
  const FloatLanes position = limitLanes(scaled, 1.0f) * table.steps;
  FloatLanes result{};
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    const auto step = static_cast<int>(position[lane]);
    const float* share = table.share + step; // one more at the end
    result[lane] = share[0] + (position[lane] - static_cast<float>(step)) * (share[1] - share[0]);
  }
  return result;
}

// Makes the sums values, in place.
HACHURE_WIDE_CLONES
void makeValues(const ValueTable& table, noise::TileSums& sums)
{
  for (int row = 0; row < sums.height; ++row)
  {
    const std::size_t line = sums.place(sums.left, sums.bottom + row);
    for (int column = 0; column < sums.width; column += floatLanes)
    {
      float* sum = &sums.sums[line + column];
      const FloatLanes variance = loadLanes(sum + noise::TileSums::toSecond);
      storeLanes(valueLanes(table, loadLanes(sum), variance), sum);
    }
  }
}

// Goes on for one pixel around the summed ones, with the same slope: differences at the border of
// the rectangle are one-sided.
void extend(noise::TileSums& sums, std::size_t offset)
{
  float* const values = sums.sums.data() + offset;
  const auto goOn = [values](std::size_t place, std::ptrdiff_t inwards, int size)
  {
    const std::ptrdiff_t second = size > 1 ? 2 * inwards : inwards;
    values[place] = 2.0f * values[static_cast<std::ptrdiff_t>(place) + inwards] -
      values[static_cast<std::ptrdiff_t>(place) + second];
  };
  for (int row = 0; row < sums.height; ++row)
  {
    const std::size_t first = sums.place(sums.left - 1, sums.bottom + row);
    goOn(first, 1, sums.width);
    goOn(first + sums.width + 1, -1, sums.width);
  }
  for (int column = 0; column < sums.width; ++column)
  {
    goOn(sums.place(sums.left + column, sums.bottom - 1), noise::TileSums::stride, sums.height);
    goOn(sums.place(sums.left + column, sums.bottom + sums.height), -noise::TileSums::stride,
      sums.height);
  }
}

HACHURE_INLINED FloatLanes differenceLanes(const float* value, int step)
{
  return (loadLanes(value + step) - loadLanes(value - step)) * 0.5f;
}

HACHURE_INLINED FloatLanes widthLanes(
  const FloatLanes& x, const FloatLanes& y, const FloatLanes& flat)
{
  const FloatLanes length = rootLanes(x * x + y * y);
  return lowerLanes(higherLanes(length, flat + leastWidth), fillLanes(1.0f));
}

// A line of values and widths from values and variances.
HACHURE_WIDE_CLONES
void finishLine(const ValueTable& table, const noise::TileSums& sums, std::size_t line, int count,
  float* value, float* width)
{
  for (int i = 0; i < count; i += floatLanes)
  {
    const float* from = &sums.sums[line + i];
    const FloatLanes x = differenceLanes(from, 1);
    const FloatLanes y = differenceLanes(from, noise::TileSums::stride);
    const FloatLanes flat =
      table.lowest / (loadLanes(from + noise::TileSums::toSecond) + table.lowest);
    storeLanes(loadLanes(from), value + i);
    storeLanes(widthLanes(x, y, flat), width + i);
  }
}

// As phasorChange.
HACHURE_INLINED FloatLanes phasorChangeLanes(const FloatLanes& real, const FloatLanes& imaginary,
  const FloatLanes& inverse, const FloatLanes& realChange, const FloatLanes& imaginaryChange)
{
  const FloatLanes sine = (real * imaginaryChange - imaginary * realChange) * inverse;
  const FloatLanes x = limitLanes(sine + 2.0f, 4.0f) - 2.0f;
  const FloatLanes square = x * x;
  return x * (1.0f + square * (1.0f / 6.0f + square * 0.075f)) * (1.0f / glsl::screenPi);
}

// A line of values and widths from real and imaginary parts.
HACHURE_WIDE_CLONES
void finishPhasorLine(
  const noise::TileSums& sums, std::size_t line, int count, float* value, float* width)
{
  for (int i = 0; i < count; i += floatLanes)
  {
    const float* from = &sums.sums[line + i];
    const float* other = from + noise::TileSums::toSecond;
    const FloatLanes real = loadLanes(from);
    const FloatLanes imaginary = loadLanes(other);
    const FloatLanes inverse = 1.0f / (real * real + imaginary * imaginary + glsl::phasorFloor);
    const FloatLanes flat = inverse * glsl::phasorFloor;
    const FloatLanes turn = turnShareLanes(real, imaginary);
    const FloatLanes x = phasorChangeLanes(
      real, imaginary, inverse, differenceLanes(from, 1), differenceLanes(other, 1));
    const FloatLanes y =
      phasorChangeLanes(real, imaginary, inverse, differenceLanes(from, noise::TileSums::stride),
        differenceLanes(other, noise::TileSums::stride));
    storeLanes(turn + flat * (0.5f - turn), value + i);
    storeLanes(widthLanes(x, y, flat), width + i);
  }
}

// The pixels of a tile, one line after the other: write(pixel of the rectangle, column of the tile)
// for those in which something is seen.
template <class Line, class Write>
void forSeen(
  const NoiseSurroundings& surroundings, const noise::Tile& tile, Line&& line, Write&& write)
{
  const auto [left, bottom, width, height] = surroundings.rectangle;
  for (int row = tile.bottom; row < tile.top; ++row)
  {
    line(row);
    const std::size_t pixel = static_cast<std::size_t>(row - bottom) * width + (tile.left - left);
    for (int i = 0; i < tile.right - tile.left; ++i)
    {
      if (surroundings.depth.empty() || surroundings.depth[pixel + i] < 1.0f)
      {
        write(pixel + i, i);
      }
    }
  }
}

void finishTile(const NoiseSurroundings& surroundings, const ValueTable& table, bool phasor,
  const noise::Tile& tile, noise::TileSums& sums, NoiseField& field)
{
  if (!phasor)
  {
    makeValues(table, sums);
  }
  extend(sums, 0);
  if (phasor)
  {
    extend(sums, noise::TileSums::toSecond);
  }
  const int count = tile.right - tile.left;
  alignas(32) float value[noise::tileWidth + floatLanes];
  alignas(32) float width[noise::tileWidth + floatLanes];
  const auto line = [&](int row)
  {
    const std::size_t place = sums.place(tile.left, row);
    if (phasor)
    {
      finishPhasorLine(sums, place, count, value, width);
    }
    else
    {
      finishLine(table, sums, place, count, value, width);
    }
  };
  forSeen(surroundings, tile, line,
    [&](std::size_t pixel, int column)
    {
      field.value[pixel] = value[column];
      field.width[pixel] = std::max(width[column], table.leastWidth);
    });
}

std::size_t pixelCount(const NoiseSurroundings& surroundings)
{
  return static_cast<std::size_t>(surroundings.rectangle[2]) * surroundings.rectangle[3];
}

} // namespace

float noise::lowestVariance(const NoiseFieldOptions& options)
{
  const float scale =
    options.kind == NoiseKind::spot ? SpotTexels(*options.spot).square / meanKernelVariance : 1.0f;
  return std::max(glsl::noiseVarianceFloor * scale, 1e-30f);
}

void noise::checkNoiseInput(const NoiseSurroundings& surroundings, const NoiseFieldOptions& options)
{
  checkSurroundings(surroundings);
  if (!(options.overlap > 0.0 && std::isfinite(options.overlap)))
  {
    refuse("overlap", "is " + std::to_string(options.overlap) + ", expected a number above 0");
  }
  if (!(options.smoothness >= 0.0 && options.smoothness <= 1.0))
  {
    refuse("smoothness", "is " + std::to_string(options.smoothness) + ", expected 0 to 1");
  }
  if (options.kind == NoiseKind::spot)
  {
    checkSpot(options.spot);
  }
}

NoiseFieldMemory::NoiseFieldMemory()
  : data(std::make_unique<Data>())
{
}

NoiseFieldMemory::~NoiseFieldMemory() = default;
NoiseFieldMemory::NoiseFieldMemory(NoiseFieldMemory&&) noexcept = default;
NoiseFieldMemory& NoiseFieldMemory::operator=(NoiseFieldMemory&&) noexcept = default;

NoiseField noiseField(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options)
{
  NoiseField result;
  NoiseFieldMemory memory;
  noiseField(kernels, surroundings, options, result, memory);
  return result;
}

void noiseField(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, NoiseField& result, NoiseFieldMemory& memory)
{
  noise::checkNoiseInput(surroundings, options);
  result.value.assign(pixelCount(surroundings), 0.0f);
  result.width.assign(pixelCount(surroundings), leastWidth);
  const bool phasor = options.kind == NoiseKind::phasor;
  const auto distribution = phasor ? nullptr : noiseDistribution(options.overlap);
  ValueTable table{};
  std::vector<float> shares;
  if (distribution)
  {
    shares = distribution->share;
    shares.push_back(shares.back());
    table = { shares.data(), static_cast<float>(distribution->range),
      static_cast<float>(distribution->share.size() - 1), noise::lowestVariance(options), 0.0f };
  }
  table.leastWidth = static_cast<float>(options.smoothness);
  noise::forTiles(kernels, surroundings, options, 1, *memory.data,
    [&](const noise::Tile& tile, noise::TileSums& sums)
    { finishTile(surroundings, table, phasor, tile, sums, result); });
}

NoiseSums noiseSums(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options)
{
  noise::checkNoiseInput(surroundings, options);
  NoiseSums result;
  const bool phasor = options.kind == NoiseKind::phasor;
  result.x.assign(pixelCount(surroundings), 0.0f);
  std::vector<float>& second = phasor ? result.y : result.z;
  second.assign(pixelCount(surroundings), 0.0f);
  NoiseFieldMemory memory;
  noise::forTiles(kernels, surroundings, options, 0, *memory.data,
    [&](const noise::Tile& tile, noise::TileSums& sums)
    {
      std::size_t place = 0;
      forSeen(
        surroundings, tile, [&](int row) { place = sums.place(tile.left, row); },
        [&](std::size_t pixel, int column)
        {
          result.x[pixel] = sums.sums[place + column];
          second[pixel] = sums.sums[place + column + noise::TileSums::toSecond];
        });
    });
  return result;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseVisibility.h"

#include "FloatLanes.h"
#include "Kernels.h"
#include "NoiseFieldLanes.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

constexpr float unknownDepth = 2.0f;
// Of larger kernels only a part of the disc is looked at.
constexpr float largestStep = 512.0f;
// Columns of unknown pixels on both sides: the samples of a disc that meets the rectangle begin and
// end there.
constexpr int border = floatLanes + 2;

int divideDown(int value, int divisor)
{
  return value >= 0 ? value / divisor : -((divisor - 1 - value) / divisor);
}

NoiseVisibility::Samples gather(const NoiseSurroundings& surroundings, int step)
{
  const auto [left, bottom, width, height] = surroundings.rectangle;
  NoiseVisibility::Samples result;
  result.step = step;
  const int first = divideDown(left + step - 1, step);
  const int inside = divideDown(left + width - 1, step) - first + 1;
  result.firstColumn = first - border;
  result.columns = inside + 2 * border;
  result.firstRow = divideDown(bottom + step - 1, step);
  result.rows = std::max(divideDown(bottom + height - 1, step) - result.firstRow + 1, 0);
  const std::size_t size = static_cast<std::size_t>(result.columns) * result.rows;
  result.depth.assign(size, unknownDepth);
  result.objects.assign(surroundings.objects.empty() ? 0 : size, 0);
  parallelForRanges(result.rows, 16,
    [&, left = left, bottom = bottom, width = width](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        const std::size_t from = ((result.firstRow + row) * step - bottom) * width;
        const std::size_t to = row * result.columns + border;
        for (int i = 0; i < inside; ++i)
        {
          const std::size_t pixel = from + (first + i) * step - left;
          result.depth[to + i] = surroundings.depth.empty() ? 0.0f : surroundings.depth[pixel];
          if (!surroundings.objects.empty())
          {
            result.objects[to + i] = surroundings.objects[pixel];
          }
        }
      }
    });
  return result;
}

struct SampleSums
{
  float known, seen, missing;
};

// A disc of this radius over samples of one step: rows [beginRow, endRow), and groups of eight
// columns that begin before lastColumn. All are indices of samples.
struct Disc
{
  const NoiseVisibility::Samples* samples;
  const NoiseKernel* kernel;
  float radius, reach, tolerance;
  float growth; // of the tolerance with the squared distance
  int firstColumn, lastColumn, beginRow, endRow;
};

HACHURE_INLINED float sumOf(const FloatLanes& x)
{
  return ((x[0] + x[4]) + (x[1] + x[5])) + ((x[2] + x[6]) + (x[3] + x[7]));
}

// Sums over eight samples of every row.
struct LaneSums
{
  FloatLanes known, seen, missing;
};

HACHURE_INLINED void addColumns(const Disc& disc, int column, LaneSums& sums)
{
  const NoiseVisibility::Samples& samples = *disc.samples;
  const NoiseKernel& kernel = *disc.kernel;
  const auto step = static_cast<float>(samples.step);
  const auto first = static_cast<float>(samples.firstColumn + column);
  const FloatLanes x = laneNumbers() * step + (first * step + 0.5f) - kernel.center.x;
  const FloatLanes planeX = x * kernel.depthSlope.x;
  const float inverseSquare = 1.0f / (disc.radius * disc.radius);
  for (int row = disc.beginRow; row < disc.endRow; ++row)
  {
    const std::size_t place = static_cast<std::size_t>(row) * samples.columns + column;
    const float y =
      static_cast<float>((samples.firstRow + row) * samples.step) + 0.5f - kernel.center.y;
    const FloatLanes square = x * x + y * y;
    const FloatLanes depth = loadLanes(&samples.depth[place]);
    FloatLanes excess =
      depthExcessLanes((depth - kernel.depth) - (planeX + y * kernel.depthSlope.y),
        square * disc.growth + disc.tolerance);
    if (!samples.objects.empty())
    {
      excess = 1.0f - keepEqual(&samples.objects[place], kernel.object, 1.0f - excess);
    }
    const FloatLanes there = seenLanes(depth);
    const FloatLanes weight = keepWhere(there, excessWeightLanes(excess));
    FloatLanes share = 1.0f - square * inverseSquare;
    share = keepWhere(eitherNegative(1.0f - depth, share), share * share);
    sums.known = sums.known + share;
    sums.seen = sums.seen + share * weight;
    const FloatLanes near = eitherNegative(there, disc.reach * disc.reach - square);
    sums.missing = sums.missing + keepWhere(near, excess);
  }
}

HACHURE_WIDE_CLONES
void sumSamples(const Disc& disc, SampleSums& result)
{
  LaneSums sums{};
  int column = disc.firstColumn;
  do
  {
    addColumns(disc, column, sums);
    column += floatLanes;
  } while (column < disc.lastColumn);
  result = { sumOf(sums.known), sumOf(sums.seen), sumOf(sums.missing) };
}

// Whole steps at or above a place, counted from the first sample.
int samplesFrom(float place, float inverseStep, int first, int count)
{
  const float steps = (place - 0.5f) * inverseStep - static_cast<float>(first);
  const float inside = std::min(std::max(steps, 0.0f), static_cast<float>(count));
  const auto whole = static_cast<int>(inside);
  return whole + (static_cast<float>(whole) < inside ? 1 : 0);
}

} // namespace

NoiseVisibility::NoiseVisibility(
  const NoiseSurroundings& surroundings, Span<const NoiseKernel> kernels)
{
  const bool depthCounts =
    !surroundings.depth.empty() && (surroundings.depthTest || surroundings.partialVisibility);
  this->active = depthCounts || (!surroundings.objects.empty() && surroundings.partialVisibility);
  this->everyPixel = surroundings.everyPixel;
  // Without depths everything is on every plane.
  this->tolerance = surroundings.depth.empty() ? 1e30f : surroundings.depthTolerance;
  this->samples.resize(static_cast<std::size_t>(largestStep) + 1);
  float last = 0.0f;
  for (const NoiseKernel& kernel : kernels)
  {
    if (this->active && kernel.bandwidth != last && kernel.bandwidth > 0.0f)
    {
      last = kernel.bandwidth;
      const int step = this->stepOf(glsl::kernelRadius(last));
      Samples& wanted = this->samples[static_cast<std::size_t>(step)];
      if (wanted.step == 0)
      {
        wanted = gather(surroundings, step);
      }
    }
  }
}

int NoiseVisibility::stepOf(float radius) const
{
  return this->everyPixel ? 1
                          : static_cast<int>(std::min(glsl::noiseSampleStep(radius), largestStep));
}

NoiseShare NoiseVisibility::share(const NoiseKernel& kernel, float radius) const
{
  if (!this->active)
  {
    return {};
  }
  const Samples& wanted = this->samples[static_cast<std::size_t>(this->stepOf(radius))];
  const auto step = static_cast<float>(wanted.step);
  const float inverse = 1.0f / step;
  // Disturbances are known before they reach the disc.
  const float reach = radius + 0.5f * step;
  const glm::vec2 slope = kernel.depthSlope;
  // Eight columns hold the samples of a disc, unless every pixel is one. Beyond the last eight
  // nothing is known.
  const int lastGroup = wanted.columns - floatLanes;
  const Disc disc = { &wanted, &kernel, radius, reach, this->tolerance,
    glsl::noiseSlopeTolerance * std::sqrt(slope.x * slope.x + slope.y * slope.y) / radius,
    samplesFrom(kernel.center.x - reach, inverse, wanted.firstColumn, lastGroup),
    std::min(samplesFrom(kernel.center.x + reach, inverse, wanted.firstColumn, wanted.columns),
      lastGroup + 1),
    samplesFrom(kernel.center.y - reach, inverse, wanted.firstRow, wanted.rows),
    samplesFrom(kernel.center.y + reach, inverse, wanted.firstRow, wanted.rows) };
  SampleSums sums{};
  sumSamples(disc, sums);
  if (!(sums.known > 0.0f))
  {
    return { 1.0f, false };
  }
  return { glsl::noiseShownShare(sums.seen / sums.known), sums.missing == 0.0f };
}

float noiseDepthToleranceFor(float radius, float depthPerPixel)
{
  // radius^2 / (2 * 4 radius)
  return std::max(0.125f * radius * depthPerPixel, 1e-7f);
}

} // namespace hachure

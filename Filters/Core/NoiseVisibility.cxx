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

// A disc of this radius over samples of one step: rows [beginRow, endRow), eight columns.
struct Disc
{
  const NoiseVisibility::Samples* samples;
  const NoiseKernel* kernel;
  float radius, reach, tolerance, slope;
  int column, beginRow, endRow; // indices of samples
};

HACHURE_INLINED float sumOf(const FloatLanes& x)
{
  return ((x[0] + x[4]) + (x[1] + x[5])) + ((x[2] + x[6]) + (x[3] + x[7]));
}

// Eight samples of one row.
struct SampleRow
{
  FloatLanes square; // of their distances from the centre
  FloatLanes depth, deviation;
  std::size_t place;
  float y;
};

HACHURE_INLINED FloatLanes columnsOf(const Disc& disc)
{
  const auto step = static_cast<float>(disc.samples->step);
  const auto first = static_cast<float>(disc.samples->firstColumn + disc.column);
  return laneNumbers() * step + (first * step + 0.5f) - disc.kernel->center.x;
}

HACHURE_INLINED void fillRow(const Disc& disc, const FloatLanes& x, int row, SampleRow& result)
{
  const NoiseVisibility::Samples& samples = *disc.samples;
  const NoiseKernel& kernel = *disc.kernel;
  const float y =
    static_cast<float>((samples.firstRow + row) * samples.step) + 0.5f - kernel.center.y;
  result.y = y;
  result.place = static_cast<std::size_t>(row) * samples.columns + disc.column;
  result.square = x * x + y * y;
  result.depth = loadLanes(&samples.depth[result.place]);
  result.deviation =
    (result.depth - kernel.depth) - (x * kernel.depthSlope.x + y * kernel.depthSlope.y);
}

// Whether all samples are known and on the plane for certain: a quick test that most kernels pass,
// with tolerances that are a little too small, |x| + |y| being at most 1.42 times the distance.
HACHURE_WIDE_CLONES
bool isComplete(const Disc& disc)
{
  const FloatLanes x = columnsOf(disc);
  const float slope = 0.7f * glsl::noiseSlopeTolerance * disc.slope;
  const FloatLanes along = magnitudeLanes(x) * slope + disc.tolerance;
  FloatLanes worst{};
  for (int row = disc.beginRow; row < disc.endRow; ++row)
  {
    SampleRow line;
    fillRow(disc, x, row, line);
    const FloatLanes spare = along + std::abs(line.y) * slope - magnitudeLanes(line.deviation);
    FloatLanes test = eitherNegative(spare, seenLanes(line.depth));
    if (!disc.samples->objects.empty())
    {
      test =
        eitherNegative(test, equalLanes(&disc.samples->objects[line.place], disc.kernel->object));
    }
    worst = eitherNegative(worst, keepWhere(disc.reach * disc.reach - line.square, test));
  }
  return !anyNegative(worst);
}

HACHURE_WIDE_CLONES
void sumSamples(const Disc& disc, SampleSums& result)
{
  const FloatLanes x = columnsOf(disc);
  const float inverseSquare = 1.0f / (disc.radius * disc.radius);
  FloatLanes known{}, seen{}, missing{};
  for (int row = disc.beginRow; row < disc.endRow; ++row)
  {
    SampleRow line;
    fillRow(disc, x, row, line);
    FloatLanes weight = depthWeightLanes(
      line.deviation, depthToleranceLanes(line.square, disc.slope, disc.tolerance));
    weight = keepWhere(seenLanes(line.depth), weight);
    if (!disc.samples->objects.empty())
    {
      weight = keepEqual(&disc.samples->objects[line.place], disc.kernel->object, weight);
    }
    FloatLanes share = 1.0f - line.square * inverseSquare;
    share = keepWhere(1.0f - line.depth, keepWhere(share, share * share));
    const FloatLanes near = keepWhere(disc.reach * disc.reach - line.square, 1.0f - weight);
    known = known + share;
    seen = seen + share * weight;
    missing = missing + keepWhere(1.0f - line.depth, near);
  }
  result = { sumOf(known), sumOf(seen), sumOf(missing) };
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
  // Disturbances are known before they reach the disc.
  const float reach = radius + 0.5f * step;
  // Whole steps at or above a place, counted from the first sample.
  const auto from = [&](float place, int first, int count)
  {
    const float steps = (place - 0.5f) / step - static_cast<float>(first);
    const float inside = std::clamp(steps, 0.0f, static_cast<float>(count));
    const auto whole = static_cast<int>(inside);
    return whole + (static_cast<float>(whole) < inside ? 1 : 0);
  };
  const glm::vec2 slope = kernel.depthSlope;
  Disc disc = { &wanted, &kernel, radius, reach, this->tolerance,
    std::sqrt(slope.x * slope.x + slope.y * slope.y),
    from(kernel.center.x - reach, wanted.firstColumn, wanted.columns - floatLanes),
    from(kernel.center.y - reach, wanted.firstRow, wanted.rows),
    from(kernel.center.y + reach, wanted.firstRow, wanted.rows) };
  // Eight columns hold the samples of a disc, unless every pixel is one. Beyond the last eight
  // nothing is known.
  const int first = disc.column;
  const int last = std::min(from(kernel.center.x + reach, wanted.firstColumn, wanted.columns),
    wanted.columns - floatLanes + 1);
  const auto next = [&] { return (disc.column += floatLanes) < last; };
  bool complete = isComplete(disc);
  while (complete && next())
  {
    complete = isComplete(disc);
  }
  if (complete)
  {
    return { 1.0f, true };
  }
  disc.column = first;
  SampleSums sums{};
  do
  {
    SampleSums part{};
    sumSamples(disc, part);
    sums = { sums.known + part.known, sums.seen + part.seen, sums.missing + part.missing };
  } while (next());
  if (!(sums.known > 0.0f))
  {
    return { 1.0f, false };
  }
  return { std::min(sums.seen / sums.known, 1.0f), sums.missing == 0.0f };
}

float noiseDepthToleranceFor(float radius, float depthPerPixel)
{
  // radius^2 / (2 * 4 radius)
  return std::max(0.125f * radius * depthPerPixel, 1e-7f);
}

} // namespace hachure

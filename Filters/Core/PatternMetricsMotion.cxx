// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsMotion.h"

#include "Parallel.h"
#include "PatternMetricsImage.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

// How the slide of a block is found
//
// 1. NCC on a lattice of slides below half a wavelength, with every second pixel where the
// wavelength
//    allows it. Larger slides cannot be told from slides the other way in a regular pattern.
// 2. From the best one on, paraboloids through 3 x 3 slides, half, a quarter and an eighth of a
// pixel
//    apart; each leads to the centre of the next. A step goes along the axes of the paraboloid and
//    leaves out those without curvature: along a hatch all slides are equally good.
//
// A pixel takes part only if all that its comparison can touch is usable, so that neither the
// background nor an occluding object is mistaken for the pattern.
namespace hachure
{

namespace
{

constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();
// Ink deviations below this are rounding of pictures with 256 grey levels, not a pattern.
constexpr double leastDeviation = 0.004;
constexpr int reach = 3; // pixels around that a look-up or a derivative reads

struct Pixel
{
  glm::dvec2 target; // of the surface point in the next frame
  double ink;
};

struct Block
{
  std::vector<Pixel> pixels;
  glm::dvec2 motion{ 0.0 }; // mean
  glm::dvec2 normal{ 1.0, 0.0 };
  glm::dvec2 slide{ 0.0 };
  double coherence = 0.0;
  double best = 0.0; // NCC at slide
  bool contrast = false;
};

struct StepImages
{
  MetricImage now;                  // smoothed
  MetricImage next;                 // spline of the smoothed next frame
  std::vector<std::uint8_t> usable; // far enough from what is not
};

double correlation(const Block& block, const MetricImage& next, glm::dvec2 slide, int stride)
{
  double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0, count = 0.0;
  for (std::size_t i = 0; i < block.pixels.size(); i += static_cast<std::size_t>(stride))
  {
    const Pixel& pixel = block.pixels[i];
    const double x = pixel.ink;
    const double y = sampleSpline(next, pixel.target.x + slide.x, pixel.target.y + slide.y);
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
    count += 1.0;
  }
  const double varianceA = aa / count - a * a / (count * count);
  const double varianceB = bb / count - b * b / (count * count);
  const double least = leastDeviation * leastDeviation;
  if (varianceA < least || varianceB < least)
  {
    return 0.0; // a pattern that is gone is not similar
  }
  return (ab / count - a * b / (count * count)) / std::sqrt(varianceA * varianceB);
}

glm::dvec2 coarseSlide(const Block& block, const MetricImage& next, double wavelength)
{
  const double spacing = std::clamp(wavelength / 8.0, 0.5, 4.0);
  const double radius = 0.5 * wavelength;
  const int steps = static_cast<int>(radius / spacing);
  const int stride = wavelength >= 8.0 ? 3 : 1; // no divisor of even widths: pixels of all columns
  glm::dvec2 best(0.0);
  double bestScore = -2.0;
  for (int j = -steps; j <= steps; ++j)
  {
    for (int i = -steps; i <= steps; ++i)
    {
      const glm::dvec2 slide(i * spacing, j * spacing);
      const double length = glm::length(slide);
      if (length >= radius)
      {
        continue;
      }
      // Of equally good slides the shortest, whatever the rounding.
      const double score = correlation(block, next, slide, stride) - 1e-6 * length;
      if (score > bestScore)
      {
        bestScore = score;
        best = slide;
      }
    }
  }
  return best;
}

// The top of the paraboloid z = g.x + x.H.x / 2, from the origin, at most 1 along each axis.
glm::dvec2 paraboloidTop(glm::dvec2 gradient, double hxx, double hxy, double hyy)
{
  const double middle = 0.5 * (hxx + hyy);
  const double spread = std::hypot(0.5 * (hxx - hyy), hxy);
  const double steepest = std::max(std::abs(middle - spread), std::abs(middle + spread));
  const double angle = 0.5 * std::atan2(2.0 * hxy, hxx - hyy); // of the axis with middle + spread
  const glm::dvec2 axes[2] = { { std::cos(angle), std::sin(angle) },
    { -std::sin(angle), std::cos(angle) } };
  const double curvatures[2] = { middle + spread, middle - spread };
  glm::dvec2 top(0.0);
  for (int k = 0; k < 2; ++k)
  {
    constexpr double flat = 0.01; // of the steepest curvature: noise of a valley along strokes
    if (curvatures[k] < -flat * steepest)
    {
      top += axes[k] * std::clamp(-glm::dot(gradient, axes[k]) / curvatures[k], -1.0, 1.0);
    }
  }
  return top;
}

glm::dvec2 refinedSlide(const Block& block, const MetricImage& next, glm::dvec2 slide)
{
  for (const double spacing : { 0.5, 0.25, 0.125 })
  {
    double z[3][3];
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        z[j][i] = correlation(block, next, slide + spacing * glm::dvec2(i - 1, j - 1), 1);
      }
    }
    double left = 0.0, right = 0.0, below = 0.0, above = 0.0, column = 0.0, row = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      left += z[k][0];
      column += z[k][1];
      right += z[k][2];
      below += z[0][k];
      row += z[1][k];
      above += z[2][k];
    }
    slide += spacing *
      paraboloidTop({ (right - left) / 6.0, (above - below) / 6.0 },
        (left + right - 2.0 * column) / 3.0, (z[2][2] + z[0][0] - z[0][2] - z[2][0]) / 4.0,
        (below + above - 2.0 * row) / 3.0);
  }
  return slide;
}

// Along `stride`, times 60, to sixth order: of lower order, short waves would seem to run in other
// directions than they do.
double derivative(const float* ink, int stride)
{
  return 45.0 * (ink[stride] - ink[-stride]) - 9.0 * (ink[2 * stride] - ink[-2 * stride]) +
    (ink[3 * stride] - ink[-3 * stride]);
}

// Direction in which the ink changes most: the leading axis of the structure tensor.
glm::dvec2 strokeNormal(double xx, double xy, double yy)
{
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  return { std::cos(angle), std::sin(angle) };
}

Block readBlock(const StepImages& images, const MotionView& motion, int left, int bottom, int size)
{
  Block block;
  double xx = 0.0, xy = 0.0, yy = 0.0, sum = 0.0, squares = 0.0;
  for (int y = bottom; y < bottom + size; ++y)
  {
    for (int x = left; x < left + size; ++x)
    {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(motion.width) +
        static_cast<std::size_t>(x);
      if (images.usable[i] == 0)
      {
        continue;
      }
      const float* ink = images.now.values.data() + i;
      const double dx = derivative(ink, 1);
      const double dy = derivative(ink, motion.width);
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
      sum += *ink;
      squares += static_cast<double>(*ink) * *ink;
      const glm::dvec2 step(motion.u[i], motion.v[i]);
      block.motion += step;
      block.pixels.push_back({ glm::dvec2(x, y) + step, *ink });
    }
  }
  const double count = std::max<double>(1.0, static_cast<double>(block.pixels.size()));
  block.motion /= count;
  block.normal = strokeNormal(xx, xy, yy);
  block.contrast = squares / count - sum * sum / (count * count) >= leastDeviation * leastDeviation;
  return block;
}

StepImages prepareStep(const PatternClip& clip, std::size_t t, const MotionMetricsOptions& options)
{
  const MotionView& motion = clip.motions[t];
  StepImages images;
  images.now = smoothed(clip.frames[t], options.smoothing);
  images.next = splineCoefficients(smoothed(clip.frames[t + 1], options.smoothing));
  const double search = 0.5 * options.wavelength;
  const double blur = 3.0 * options.smoothing; // what lies further weighs less than 0.3 %
  const int radius = static_cast<int>(std::ceil(search + blur)) + reach;
  images.usable =
    eroded(usablePixels(motion, options.minimumFacing), motion.width, motion.height, radius);
  // The motion may lead out of the picture.
  const double margin = search + reach;
  for (std::size_t i = 0; i < images.usable.size(); ++i)
  {
    if (images.usable[i] != 0)
    {
      const auto columns = static_cast<std::size_t>(motion.width);
      const std::size_t column = i % columns;
      const std::size_t row = i / columns;
      const double x = static_cast<double>(column) + motion.u[i];
      const double y = static_cast<double>(row) + motion.v[i];
      images.usable[i] = x >= margin && y >= margin && x <= motion.width - 1 - margin &&
          y <= motion.height - 1 - margin
        ? 1
        : 0;
    }
  }
  return images;
}

void compareBlock(Block& block, const MetricImage& next, double wavelength)
{
  block.coherence = correlation(block, next, glm::dvec2(0.0), 1);
  block.slide = refinedSlide(block, next, coarseSlide(block, next, wavelength));
  block.best = correlation(block, next, block.slide, 1);
  if (block.best < block.coherence) // a maximum that the paraboloid missed
  {
    block.slide = glm::dvec2(0.0);
    block.best = block.coherence;
  }
}

std::vector<Block> compareStep(
  const PatternClip& clip, std::size_t t, const MotionMetricsOptions& options)
{
  const StepImages images = prepareStep(clip, t, options);
  const MotionView& motion = clip.motions[t];
  const int size = static_cast<int>(std::ceil(2.0 * options.wavelength));
  const int columns = motion.width / size;
  const int rows = motion.height / size;
  std::vector<Block> blocks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  // What does not divide into blocks is left out on all sides alike.
  const int left = (motion.width - columns * size) / 2;
  const int bottom = (motion.height - rows * size) / 2;
  parallelForRanges(static_cast<std::int64_t>(blocks.size()), 1,
    [&](std::int64_t begin, std::int64_t)
    {
      const int column = static_cast<int>(begin) % columns;
      const int row = static_cast<int>(begin) / columns;
      Block block = readBlock(images, motion, left + column * size, bottom + row * size, size);
      if (static_cast<double>(block.pixels.size()) < options.minimumShare * size * size)
      {
        return;
      }
      if (block.contrast)
      {
        compareBlock(block, images.next, options.wavelength);
      }
      blocks[static_cast<std::size_t>(begin)] = std::move(block);
    });
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](const Block& block) { return block.pixels.empty(); }),
    blocks.end());
  return blocks;
}

StepMetrics meanOfBlocks(const std::vector<Block>& blocks)
{
  StepMetrics mean{ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0 };
  for (const Block& block : blocks)
  {
    if (block.contrast)
    {
      mean.coherence += block.coherence;
      mean.boil += std::max(0.0, 1.0 - block.best);
      mean.slide += glm::length(block.slide);
      mean.motion += glm::length(block.motion);
      mean.normalSlide += std::abs(glm::dot(block.slide, block.normal));
      mean.normalMotion += std::abs(glm::dot(block.motion, block.normal));
      ++mean.blocks;
    }
  }
  const double scale = mean.blocks > 0 ? 1.0 / mean.blocks : notKnown;
  for (double* value : { &mean.coherence, &mean.boil, &mean.slide, &mean.motion, &mean.normalSlide,
         &mean.normalMotion })
  {
    *value *= scale;
  }
  return mean;
}

double ratio(double slide, double motion)
{
  constexpr double still = 1e-6; // pixels: rounding of equal matrices
  return motion > still ? slide / motion : notKnown;
}

void summarise(MotionMetrics& metrics)
{
  StepMetrics sum{ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0 };
  std::vector<double> boils;
  for (const StepMetrics& step : metrics.steps)
  {
    if (step.blocks > 0)
    {
      // Blocks count alike, in whichever step they lie.
      sum.coherence += step.blocks * step.coherence;
      sum.slide += step.blocks * step.slide;
      sum.motion += step.blocks * step.motion;
      sum.normalSlide += step.blocks * step.normalSlide;
      sum.normalMotion += step.blocks * step.normalMotion;
      sum.blocks += step.blocks;
      boils.push_back(step.boil);
    }
  }
  const double scale = sum.blocks > 0 ? 1.0 / sum.blocks : notKnown;
  metrics.coherence = sum.coherence * scale;
  metrics.meanSlide = sum.slide * scale;
  metrics.meanMotion = sum.motion * scale;
  metrics.slideRatio = ratio(metrics.meanSlide, metrics.meanMotion);
  metrics.normalSlideRatio = ratio(sum.normalSlide * scale, sum.normalMotion * scale);
  metrics.medianBoil = medianOf(boils);
  metrics.largestBoil = boils.empty() ? notKnown : *std::max_element(boils.begin(), boils.end());
  metrics.pop = metrics.largestBoil / std::max(metrics.medianBoil, 0.001);
}

void checkOption(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
  {
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(value) + ", expected " +
      std::to_string(low) + " to " + std::to_string(high));
  }
}

} // namespace

MotionMetrics measureMotion(const PatternClip& clip, const MotionMetricsOptions& options)
{
  checkClip(clip);
  checkOption("wavelength", options.wavelength, 3.0, 1000.0);
  checkOption("minimumFacing", options.minimumFacing, 0.0, 1.0);
  checkOption("smoothing", options.smoothing, 0.0, 10.0);
  checkOption("minimumShare", options.minimumShare, 1e-3, 1.0);
  MotionMetrics metrics{};
  std::size_t found = 0;
  for (std::size_t t = 0; t + 1 < clip.frames.size(); ++t)
  {
    const std::vector<Block> blocks = compareStep(clip, t, options);
    found += blocks.size();
    for (const Block& block : blocks)
    {
      metrics.largestMotion = std::max(metrics.largestMotion, glm::length(block.motion));
    }
    metrics.steps.push_back(meanOfBlocks(blocks));
  }
  if (found == 0)
  {
    const auto size = std::to_string(static_cast<int>(std::ceil(2.0 * options.wavelength)));
    throw std::invalid_argument("motions: the visible area, without its rim, holds no block of " +
      size + " x " + size + " pixels, two wavelengths wide");
  }
  summarise(metrics);
  return metrics;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsFlatness.h"

#include "Parallel.h"
#include "PatternMetricsImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();
using Spectrum = std::vector<std::complex<double>>;

// Least squares line through points: its slope, or NaN where x hardly varies.
struct SlopeSums
{
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;

  void add(double valueX, double valueY)
  {
    this->count += 1.0;
    this->x += valueX;
    this->y += valueY;
    this->xx += valueX * valueX;
    this->xy += valueX * valueY;
  }
  double slope() const
  {
    const double spread = this->xx - this->x * this->x / this->count;
    constexpr double least = 0.02; // deviation of x in octaves: below it noise decides
    if (this->count < 2.0 || spread < least * least * this->count)
    {
      return notKnown;
    }
    return (this->xy - this->x * this->y / this->count) / spread;
  }
};

struct Window
{
  double logFrequency = notKnown;
  double logFacing = 0.0;   // log2 1/(n.v)
  double logDistance = 0.0; // mean
};

std::vector<double> hannWeights(int size)
{
  const double pi = std::acos(-1.0);
  std::vector<double> weights(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i)
  {
    weights[static_cast<std::size_t>(i)] = 0.5 - 0.5 * std::cos(2.0 * pi * (i + 0.5) / size);
  }
  return weights;
}

// The tapered image without its mean, which would leak into the lowest frequencies.
Spectrum taperedImage(const ImageView& image, const std::vector<double>& taper)
{
  const std::size_t size = taper.size();
  double sum = 0.0, weightSum = 0.0;
  for (std::size_t i = 0; i < image.values.size(); ++i)
  {
    const double weight = taper[i % size] * taper[i / size];
    sum += weight * image.values[i];
    weightSum += weight;
  }
  Spectrum tapered(image.values.size());
  for (std::size_t i = 0; i < tapered.size(); ++i)
  {
    tapered[i] = taper[i % size] * taper[i / size] * (image.values[i] - sum / weightSum);
  }
  return tapered;
}

void transformRowsAndTranspose(
  Spectrum& values, std::size_t size, const FourierTransform& transform)
{
  Spectrum turned(values.size());
  Spectrum line(size);
  for (std::size_t row = 0; row < size; ++row)
  {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row * size), size, line.begin());
    transform(line);
    for (std::size_t column = 0; column < size; ++column)
    {
      turned[column * size + row] = line[column];
    }
  }
  values.swap(turned);
}

double meanOver(const Span<const float>& values, int width, int left, int bottom, int size)
{
  double sum = 0.0;
  for (int y = bottom; y < bottom + size; ++y)
  {
    for (int x = left; x < left + size; ++x)
    {
      sum += values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(x)];
    }
  }
  return sum / (static_cast<double>(size) * size);
}

Window measureWindow(const ImageView& frame, const MotionView& motion, int left, int bottom,
  int size, const FourierTransform& transform)
{
  std::vector<float> ink;
  for (int y = bottom; y < bottom + size; ++y)
  {
    const float* row = frame.values.data() + static_cast<std::ptrdiff_t>(y) * frame.width + left;
    ink.insert(ink.end(), row, row + size);
  }
  Window window;
  window.logFrequency = std::log2(spectralCentroid({ size, size, ink }, transform));
  if (!motion.facing.empty())
  {
    window.logFacing = -std::log2(meanOver(motion.facing, motion.width, left, bottom, size));
  }
  if (!motion.distance.empty())
  {
    window.logDistance = std::log2(meanOver(motion.distance, motion.width, left, bottom, size));
  }
  return window;
}

std::vector<Window> measureFrame(const ImageView& frame, const MotionView& motion,
  const FourierTransform& transform, const FlatnessOptions& options)
{
  // The eroded mask is 1 where a window of 2 radius + 1 >= size pixels is inside.
  const int radius = options.window / 2;
  const std::vector<std::uint8_t> inside =
    eroded(usablePixels(motion, options.minimumFacing), motion.width, motion.height, radius);
  std::vector<std::size_t> centres;
  for (int y = radius; y < frame.height; y += radius)
  {
    for (int x = radius; x < frame.width; x += radius)
    {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
        static_cast<std::size_t>(x);
      if (inside[i] != 0)
      {
        centres.push_back(i);
      }
    }
  }
  std::vector<Window> windows(centres.size());
  parallelForRanges(static_cast<std::int64_t>(centres.size()), 1,
    [&](std::int64_t begin, std::int64_t)
    {
      const auto k = static_cast<std::size_t>(begin);
      const auto columns = static_cast<std::size_t>(frame.width);
      windows[k] = measureWindow(frame, motion, static_cast<int>(centres[k] % columns) - radius,
        static_cast<int>(centres[k] / columns) - radius, options.window, transform);
    });
  windows.erase(std::remove_if(windows.begin(), windows.end(),
                  [](const Window& window) { return std::isnan(window.logFrequency); }),
    windows.end());
  return windows;
}

} // namespace

double spectralCentroid(const ImageView& image, const FourierTransform& transform)
{
  if (image.width < 2 || image.width != image.height)
  {
    throw std::invalid_argument("image: " + std::to_string(image.width) + " x " +
      std::to_string(image.height) + " pixels, expected a square of at least 2 x 2");
  }
  const auto size = static_cast<std::size_t>(image.width);
  Spectrum values = taperedImage(image, hannWeights(image.width));
  transformRowsAndTranspose(values, size, transform);
  transformRowsAndTranspose(values, size, transform);
  double power = 0.0, weight = 0.0, moment = 0.0;
  const double half = 0.5 * image.width;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t column = i % size;
    const std::size_t row = i / size;
    const auto x = static_cast<double>(column);
    const auto y = static_cast<double>(row);
    const double frequency =
      std::hypot(x > half ? x - image.width : x, y > half ? y - image.width : y) / image.width;
    if (frequency <= 0.5) // the same in all directions
    {
      const double strength = std::norm(values[i]);
      power += strength;
      weight += strength * strength;
      moment += frequency * strength * strength;
    }
  }
  // Less than a grey level of 256 is no pattern; the mean square of the taper is (3/8)^2.
  const double pixels = static_cast<double>(values.size());
  const double least = pixels * pixels * (9.0 / 64.0) / (256.0 * 256.0);
  return power > least ? moment / weight : notKnown;
}

FlatnessMetrics measureFlatness(
  const PatternClip& clip, const FourierTransform& transform, const FlatnessOptions& options)
{
  checkClip(clip);
  if (options.window < 16 || options.window > 1024)
  {
    throw std::invalid_argument(
      "window: " + std::to_string(options.window) + ", expected 16 to 1024 pixels");
  }
  if (!(options.minimumFacing > 0.0 && options.minimumFacing <= 1.0))
  {
    throw std::invalid_argument("minimumFacing: " + std::to_string(options.minimumFacing) +
      ", expected a number above 0, up to 1");
  }
  FlatnessMetrics metrics{ notKnown, notKnown, {}, 0 };
  SlopeSums facing, distance;
  for (std::size_t t = 0; t < clip.motions.size(); ++t)
  {
    const MotionView& motion = clip.motions[t];
    const auto windows = measureFrame(clip.frames[t], motion, transform, options);
    double logFrequency = 0.0, logDistance = 0.0;
    for (const Window& window : windows)
    {
      facing.add(window.logFacing, window.logFrequency);
      logFrequency += window.logFrequency;
      logDistance += window.logDistance;
    }
    const double count = static_cast<double>(windows.size());
    if (!windows.empty() && !motion.distance.empty())
    {
      distance.add(logDistance / count, logFrequency / count);
    }
    metrics.frequencies.push_back(windows.empty() ? notKnown : std::exp2(logFrequency / count));
    metrics.windows += static_cast<int>(windows.size());
  }
  metrics.facingSlope = facing.slope();
  metrics.distanceSlope = distance.slope();
  return metrics;
}

} // namespace hachure

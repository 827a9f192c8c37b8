// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsCooccurrence.h"

#include "Parallel.h"
#include "PatternMetricsImage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr int levels = 8; // of ink
// Over half a turn; pairs count both ways. With 8, straight strokes show which way they lie.
constexpr int directions = 16;
constexpr int distances = 4; // equal steps up to one wavelength
constexpr std::int64_t rowsPerRange = 16;
constexpr int splineReach = 3; // pixels around a place that its interpolated ink depends on

using Matrix = std::array<double, levels * levels>;
using Matrices = std::array<Matrix, distances>;

struct Offset
{
  double x;
  double y;
  std::size_t distance; // index
};

// An image, ready to look up pairs of pixels.
struct PairImage
{
  MetricImage ink;                  // smoothed
  MetricImage spline;               // of the same
  std::vector<std::uint8_t> usable; // far enough from what is not
};

// A value of ink between two levels.
struct Level
{
  std::size_t lower;
  double upperPart;

  explicit Level(double ink)
  {
    const double place = std::clamp(ink, 0.0, 1.0) * (levels - 1);
    this->lower = std::min<std::size_t>(static_cast<std::size_t>(place), levels - 2);
    this->upperPart = place - static_cast<double>(this->lower);
  }
};

void checkOption(const char* name, double value, double least, double most)
{
  if (!(value >= least && value <= most))
  {
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(value) + ", expected " +
      std::to_string(least) + " to " + std::to_string(most));
  }
}

// Pixels around a place that its smoothed and interpolated ink depends on; what lies further weighs
// less than 0.3 %.
int borderOf(const CooccurrenceOptions& options)
{
  return static_cast<int>(std::ceil(3.0 * options.smoothing)) + splineReach;
}

void checkReference(const ImageView& reference, const CooccurrenceOptions& options)
{
  const int least = static_cast<int>(std::ceil(3.0 * options.wavelength)) + 2 * borderOf(options);
  if (reference.width < least || reference.height < least)
  {
    throw std::invalid_argument("reference: " + std::to_string(reference.width) + " x " +
      std::to_string(reference.height) + " pixels, expected at least " + std::to_string(least) +
      " x " + std::to_string(least) + ", three wavelengths and a border");
  }
  checkInk(reference, "reference");
}

std::vector<Offset> offsetsOf(double wavelength)
{
  const double step = std::acos(-1.0) / directions;
  std::vector<Offset> offsets;
  for (int distance = 0; distance < distances; ++distance)
  {
    const double length = wavelength * (distance + 1) / distances;
    for (int direction = 0; direction < directions; ++direction)
    {
      offsets.push_back({ length * std::cos(step * direction), length * std::sin(step * direction),
        static_cast<std::size_t>(distance) });
    }
  }
  return offsets;
}

PairImage prepare(const ImageView& image, const std::vector<std::uint8_t>& usable,
  const CooccurrenceOptions& options)
{
  PairImage result;
  result.ink = smoothed(image, options.smoothing);
  result.spline = splineCoefficients(result.ink);
  result.usable = eroded(usable, image.width, image.height, borderOf(options));
  return result;
}

void addPair(Matrix& matrix, const Level& one, const Level& other)
{
  double* cell = matrix.data() + one.lower * levels + other.lower;
  const double both = one.upperPart * other.upperPart;
  cell[0] += 1.0 - one.upperPart - other.upperPart + both;
  cell[1] += other.upperPart - both;
  cell[levels] += one.upperPart - both;
  cell[levels + 1] += both;
}

void addRow(
  const PairImage& image, int y, const Offset& offset, std::vector<float>& shifted, Matrix& matrix)
{
  const int width = image.ink.width;
  const int columns = static_cast<int>(std::lround(offset.x));
  const int row = y + static_cast<int>(std::lround(offset.y));
  if (row < 0 || row >= image.ink.height)
  {
    return;
  }
  sampleSplineRow(image.spline, y, offset.x, offset.y, shifted);
  const auto start = [width](int line) { return static_cast<std::ptrdiff_t>(line) * width; };
  const float* ink = image.ink.values.data() + start(y);
  const std::uint8_t* here = image.usable.data() + start(y);
  const std::uint8_t* there = image.usable.data() + start(row) + columns;
  for (int x = std::max(0, -columns); x < std::min(width, width - columns); ++x)
  {
    if (here[x] != 0 && there[x] != 0)
    {
      addPair(matrix, Level(ink[x]), Level(shifted[static_cast<std::size_t>(x)]));
    }
  }
}

void add(Matrices& sum, const Matrices& other)
{
  for (std::size_t distance = 0; distance < sum.size(); ++distance)
  {
    std::transform(sum[distance].begin(), sum[distance].end(), other[distance].begin(),
      sum[distance].begin(), [](double a, double b) { return a + b; });
  }
}

// How many pairs of each kind there are. Every range of rows has sums of its own, which are added
// in their order.
Matrices countPairs(const PairImage& image, const std::vector<Offset>& offsets)
{
  const std::int64_t rows = image.ink.height;
  std::vector<Matrices> parts(static_cast<std::size_t>((rows - 1) / rowsPerRange + 1), Matrices{});
  parallelForRanges(rows, rowsPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      Matrices& part = parts[static_cast<std::size_t>(begin / rowsPerRange)];
      std::vector<float> shifted(static_cast<std::size_t>(image.ink.width));
      for (std::int64_t y = begin; y < end; ++y)
      {
        for (const Offset& offset : offsets)
        {
          addRow(image, static_cast<int>(y), offset, shifted, part[offset.distance]);
        }
      }
    });
  Matrices sum{};
  for (const Matrices& part : parts)
  {
    add(sum, part);
  }
  return sum;
}

// Shares of the pairs, counted both ways; NaN without any.
Matrix normalised(const Matrix& counts)
{
  double total = 0.0;
  for (const double count : counts)
  {
    total += count;
  }
  Matrix shares{};
  for (std::size_t i = 0; i < levels; ++i)
  {
    for (std::size_t j = 0; j < levels; ++j)
    {
      shares[i * levels + j] = total > 0.0
        ? (counts[i * levels + j] + counts[j * levels + i]) / (2.0 * total)
        : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return shares;
}

double distanceBetween(const Matrices& one, const Matrices& other)
{
  double sum = 0.0;
  for (std::size_t distance = 0; distance < one.size(); ++distance)
  {
    const Matrix a = normalised(one[distance]);
    const Matrix b = normalised(other[distance]);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      sum += 0.5 * std::abs(a[i] - b[i]);
    }
  }
  return sum / distances;
}

} // namespace

CooccurrenceMetrics measureCooccurrence(
  const PatternClip& clip, const ImageView& reference, const CooccurrenceOptions& options)
{
  checkClip(clip);
  checkOption("wavelength", options.wavelength, 3.0, 1000.0);
  checkOption("minimumFacing", options.minimumFacing, 0.0, 1.0);
  checkOption("smoothing", options.smoothing, 0.0, 10.0);
  checkReference(reference, options);
  const std::vector<Offset> offsets = offsetsOf(options.wavelength);
  const std::vector<std::uint8_t> everywhere(reference.values.size(), 1);
  const Matrices expected = countPairs(prepare(reference, everywhere, options), offsets);
  CooccurrenceMetrics metrics{};
  Matrices together{};
  for (std::size_t t = 0; t < clip.motions.size(); ++t)
  {
    const auto usable = usablePixels(clip.motions[t], options.minimumFacing);
    const Matrices found = countPairs(prepare(clip.frames[t], usable, options), offsets);
    metrics.frames.push_back(distanceBetween(found, expected));
    add(together, found);
  }
  metrics.error = distanceBetween(together, expected);
  return metrics;
}

} // namespace hachure

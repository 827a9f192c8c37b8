// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsTone.h"

#include "Parallel.h"
#include "PatternMetricsImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Sums for a mean and a deviation; shifted by half the ink so that constant ink has none at all.
struct InkSums
{
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;

  void add(double value)
  {
    const double shifted = value - 0.5;
    this->count += 1.0;
    this->sum += shifted;
    this->squares += shifted * shifted;
  }
  double mean() const { return 0.5 + this->sum / this->count; }
  double deviation() const
  {
    if (this->count < 1.0)
    {
      return 0.0;
    }
    const double mean = this->sum / this->count;
    return std::sqrt(std::max(0.0, this->squares / this->count - mean * mean));
  }
};

double deviationOf(const std::vector<double>& values)
{
  double mean = 0.0;
  for (const double value : values)
  {
    mean += value - values.front(); // exactly 0 for equal values
  }
  mean /= static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - values.front() - mean) * (value - values.front() - mean);
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

std::map<std::int32_t, InkSums> inkOfCells(const ImageView& frame, const LabelView& labels)
{
  std::map<std::int32_t, InkSums> cells;
  for (std::size_t i = 0; i < labels.values.size(); ++i)
  {
    if (labels.values[i] > 0)
    {
      cells[labels.values[i]].add(frame.values[i]);
    }
  }
  return cells;
}

void checkLabels(Span<const ImageView> frames, Span<const LabelView> labels)
{
  if (frames.size() < 2 || labels.size() != frames.size())
  {
    throw std::invalid_argument("labels: " + std::to_string(labels.size()) + " images for " +
      std::to_string(frames.size()) + " frames, expected one for each of at least 2 frames");
  }
  for (std::size_t t = 0; t < frames.size(); ++t)
  {
    checkInk(frames[t], "frame " + std::to_string(t));
    checkSameSize(
      labels[t].width, labels[t].height, frames[t], "labels of frame " + std::to_string(t));
    if (labels[t].values.size() != frames[t].values.size())
    {
      throw std::invalid_argument("labels of frame " + std::to_string(t) + ": " +
        std::to_string(labels[t].values.size()) + " values, expected " +
        std::to_string(frames[t].values.size()));
    }
  }
}

// The largest fall of mean ink along the tones, in steps of 1/32.
double largestDrop(const std::vector<InkSums>& steps)
{
  double drop = 0.0;
  double highest = -1.0;
  for (const InkSums& step : steps)
  {
    if (step.count > 0.0)
    {
      drop = std::max(drop, highest - step.mean());
      highest = std::max(highest, step.mean());
    }
  }
  return std::max(0.0, drop);
}

} // namespace

std::vector<double> inkDeviations(const PatternClip& clip, double minimumFacing)
{
  checkClip(clip);
  std::vector<double> deviations(clip.motions.size());
  parallelForRanges(static_cast<std::int64_t>(deviations.size()), 1,
    [&](std::int64_t begin, std::int64_t)
    {
      const auto t = static_cast<std::size_t>(begin);
      const std::vector<std::uint8_t> usable = usablePixels(clip.motions[t], minimumFacing);
      InkSums sums;
      for (std::size_t i = 0; i < usable.size(); ++i)
      {
        if (usable[i] != 0)
        {
          sums.add(clip.frames[t].values[i]);
        }
      }
      deviations[t] = sums.deviation();
    });
  return deviations;
}

double inkDeviation(const ImageView& image)
{
  checkInk(image, "reference");
  InkSums sums;
  for (const float value : image.values)
  {
    sums.add(value);
  }
  return sums.deviation();
}

double toneFlicker(Span<const ImageView> frames, Span<const LabelView> labels, int minimumPixels)
{
  checkLabels(frames, labels);
  std::vector<std::map<std::int32_t, InkSums>> cells(frames.size());
  parallelForRanges(static_cast<std::int64_t>(frames.size()), 1,
    [&](std::int64_t begin, std::int64_t)
    {
      const auto t = static_cast<std::size_t>(begin);
      cells[t] = inkOfCells(frames[t], labels[t]);
    });
  std::map<std::int32_t, std::vector<double>> means;
  for (const auto& frame : cells)
  {
    for (const auto& [label, sums] : frame)
    {
      if (sums.count >= minimumPixels)
      {
        means[label].push_back(sums.mean());
      }
    }
  }
  double sum = 0.0, count = 0.0;
  for (const auto& entry : means)
  {
    if (entry.second.size() >= 2)
    {
      sum += deviationOf(entry.second);
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

ToneError measureTone(const ImageView& ink, const ImageView& tone, double wavelength)
{
  if (!(wavelength >= 1.0 && wavelength <= 1000.0))
  {
    throw std::invalid_argument(
      "wavelength: " + std::to_string(wavelength) + ", expected 1 to 1000");
  }
  checkSameSize(tone.width, tone.height, ink, "tone");
  checkInk(ink, "ink");
  std::vector<std::uint8_t> inside(tone.values.size());
  std::transform(tone.values.begin(), tone.values.end(), inside.begin(),
    [](float value) { return static_cast<std::uint8_t>(value >= 0.0f ? 1 : 0); });
  const double sigma = 1.5 * wavelength;
  MetricImage support;
  const MetricImage meanInk = smoothedInside(ink, inside, sigma, support);
  const MetricImage meanTone = smoothedInside(tone, inside, sigma, support);

  constexpr int stepCount = 32;
  std::vector<InkSums> steps(stepCount + 1);
  ToneError error{ -1.0, 0.0 };
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    if (inside[i] != 0 && support.values[i] >= 0.99f)
    {
      const double wanted = meanTone.values[i];
      error.largest = std::max(error.largest, std::abs(meanInk.values[i] - wanted));
      const double step = std::clamp(std::round(wanted * stepCount), 0.0, double(stepCount));
      steps[static_cast<std::size_t>(step)].add(meanInk.values[i]);
    }
  }
  if (error.largest < 0.0)
  {
    throw std::invalid_argument("tone: no Gaussian window of deviation " + std::to_string(sigma) +
      " pixels lies inside the area that has a tone");
  }
  error.drop = largestDrop(steps);
  return error;
}

} // namespace hachure

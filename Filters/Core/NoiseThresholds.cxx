// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseField.h"

#include "Kernels.h"
#include "Random.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>

// Thresholds by measuring: a flat surface of noise is drawn, and its ink added up for a fine scale
// of thresholds at once.
namespace hachure
{

namespace
{

constexpr int side = 512; // pixels of a picture
constexpr int tones = 256;
// Of spots, whose field is uniform only as far as their sums are Gaussian, more pictures are drawn.
constexpr int spotPictures = 4;
// Thresholds that print nothing and everything: widths are 1 at most.
constexpr double lowest = -0.5;
constexpr double highest = 1.5;
constexpr int stepsPerUnit = 2048;
constexpr int steps = static_cast<int>((highest - lowest) * stepsPerUnit);
constexpr std::size_t mostTables = 256; // that are kept

[[noreturn]] void refuse(const char* name, double value, const char* expected)
{
  throw std::invalid_argument(std::string("noiseThresholds: ")
                                .append(name)
                                .append(" is ")
                                .append(std::to_string(value))
                                .append(", expected ")
                                .append(expected));
}

void check(const NoiseThresholdOptions& options)
{
  if (!(options.frequency >= 0.0 && std::isfinite(options.frequency)))
  {
    refuse("frequency", options.frequency, "a finite number of 0 or more");
  }
  if (!(options.radius > 0.0 && std::isfinite(options.radius)))
  {
    refuse("radius", options.radius, "a finite number above 0");
  }
  if (!(options.spread >= 0.0 && std::isfinite(options.spread)))
  {
    refuse("spread", options.spread, "a finite number of 0 or more");
  }
  if (!(options.field.overlap > 0.0 && std::isfinite(options.field.overlap)))
  {
    refuse("overlap", options.field.overlap, "a finite number above 0");
  }
}

// Kernels of a flat surface, as many as their overlap asks for.
std::vector<NoiseKernel> flatKernels(const NoiseThresholdOptions& options, std::uint32_t picture)
{
  const double extent = side + 2.0 * options.radius;
  const double density = options.field.overlap / (glsl::screenPi * options.radius * options.radius);
  const auto count = static_cast<std::uint64_t>(std::llround(density * extent * extent));
  const std::uint32_t seed = hashCombine(options.seed, picture);
  std::vector<NoiseKernel> kernels(count);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    NoiseKernel& kernel = kernels[i];
    const auto place = [&](std::uint32_t dimension)
    { return static_cast<float>(extent * unitRandom(seed, i, dimension) - options.radius); };
    kernel.center = { place(0), place(1) };
    kernel.phase = static_cast<float>(2.0 * glsl::screenPi * unitRandom(seed, i, 2));
    kernel.frequency = static_cast<float>(options.frequency);
    kernel.bandwidth = glsl::kernelBandwidth(static_cast<float>(options.radius));
    kernel.orientation = static_cast<float>(options.spread * (2.0 * unitRandom(seed, i, 3) - 1.0));
  }
  return kernels;
}

// Means over pixels that rise from 0 to 1 on a range of thresholds each, added up as changes of
// slope.
class Ramps
{
public:
  Ramps()
    : change(steps + 3, 0.0)
  {
  }
  void add(double begin, double end, double share)
  {
    const double slope = share / (end - begin);
    this->put(begin, slope);
    this->put(end, -slope);
  }
  // At all thresholds.
  std::vector<double> sums() const
  {
    std::vector<double> result;
    result.reserve(this->change.size());
    double value = 0.0, slope = 0.0;
    for (const double each : this->change)
    {
      result.push_back(value);
      slope += each;
      value += slope / stepsPerUnit;
    }
    return result;
  }

private:
  void put(double threshold, double slope)
  {
    const double place = std::clamp((threshold - lowest) * stepsPerUnit, 0.0, double{ steps });
    const auto step = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(step);
    this->change[step] += (1.0 - part) * slope;
    this->change[step + 1] += part * slope;
  }
  std::vector<double> change;
};

// Mean ink at all thresholds.
std::vector<double> measureInk(const NoiseThresholdOptions& options)
{
  const bool spot = options.field.kind == NoiseKind::spot;
  const int pictures = spot ? spotPictures : 1;
  NoiseSurroundings flat;
  flat.rectangle = { 0, 0, side, side };
  Ramps soft, hard;
  const double share = 1.0 / (static_cast<double>(side) * side * pictures);
  for (int picture = 0; picture < pictures; ++picture)
  {
    const auto kernels = flatKernels(options, static_cast<std::uint32_t>(picture));
    const NoiseField field = noiseField(kernels, flat, options.field);
    for (std::size_t i = 0; i < field.value.size(); ++i)
    {
      const double value = field.value[i];
      const double half = 0.5 * std::max(static_cast<double>(field.width[i]), 1e-3);
      soft.add(value - half, value + half, share);
      hard.add(value - 0.5 / stepsPerUnit, value + 0.5 / stepsPerUnit, share);
    }
  }
  std::vector<double> ink = soft.sums();
  if (!spot)
  {
    // Values are uniform on the whole, if not in one picture: only what widths change is measured.
    const std::vector<double> below = hard.sums();
    for (std::size_t i = 0; i < ink.size(); ++i)
    {
      const double threshold = lowest + static_cast<double>(i) / stepsPerUnit;
      ink[i] += std::clamp(threshold, 0.0, 1.0) - below[i];
    }
  }
  return ink;
}

std::vector<float> invert(std::vector<double> ink)
{
  for (std::size_t i = 1; i < ink.size(); ++i)
  {
    ink[i] = std::max(ink[i], ink[i - 1]);
  }
  std::vector<float> result(tones);
  for (int tone = 1; tone + 1 < tones; ++tone)
  {
    const double wanted = static_cast<double>(tone) / (tones - 1);
    const auto above = std::upper_bound(ink.begin() + 1, ink.end() - 1, wanted);
    const double step = *above - *(above - 1);
    const double part = step > 0.0 ? (wanted - *(above - 1)) / step : 0.0;
    const double place = static_cast<double>(above - ink.begin()) - 1.0 + part;
    result[tone] = static_cast<float>(std::clamp(lowest + place / stepsPerUnit, lowest, highest));
  }
  result.front() = static_cast<float>(lowest);
  result.back() = static_cast<float>(highest);
  return result;
}

using Key = std::tuple<NoiseKind, double, double, double, double, double, std::uint32_t, int,
  std::vector<float>>;

Key keyOf(const NoiseThresholdOptions& options)
{
  const NoiseSpot* spot = options.field.kind == NoiseKind::spot ? options.field.spot : nullptr;
  return { options.field.kind, options.field.overlap, options.field.smoothness, options.frequency,
    options.radius, options.spread, options.seed, spot ? spot->width : 0,
    spot ? spot->values : std::vector<float>() };
}

} // namespace

std::vector<float> noiseThresholds(const NoiseThresholdOptions& options)
{
  check(options);
  static std::mutex mutex;
  static std::map<Key, std::vector<float>> tables;
  const std::lock_guard<std::mutex> lock(mutex);
  const Key key = keyOf(options);
  const auto found = tables.find(key);
  if (found != tables.end())
  {
    return found->second;
  }
  if (tables.size() >= mostTables)
  {
    tables.clear();
  }
  return tables.emplace(key, invert(measureInk(options))).first->second;
}

} // namespace hachure

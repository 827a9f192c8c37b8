// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseField.h"

#include "Kernels.h"
#include "Parallel.h"
#include "Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

// A pixel of the noise is the real part of a sum of phasors whose number is Poisson distributed and
// whose lengths are those of the envelope at places that are uniform in the disc. All phases being
// equally likely, so is that of the sum: given the sum's magnitude the real part has the
// distribution of a cosine. Only the magnitudes are simulated, and only where the kernels are few.
namespace hachure
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr std::int64_t simulations = 1 << 18; // for .001
constexpr std::int64_t simulationsPerRange = 1 << 12;
constexpr double range = 6.0; // deviations
constexpr int stepsPerDeviation = 64;
constexpr int magnitudeBins = 512;
// From so many kernels on the sum is Gaussian but for its kurtosis.
constexpr double manyKernels = 48.0;
constexpr int mostKernels = 255;        // of a simulated pixel
constexpr std::size_t mostTables = 256; // that are kept

using Histogram = std::array<std::uint32_t, magnitudeBins>;

// Equally likely phasors, envelopes, and numbers of kernels, by 10 or 20 random bits.
struct Draws
{
  static constexpr int size = 1024;
  std::array<float, size> cosine, sine, envelope;
  std::vector<std::uint8_t> counts; // at the quantiles of 2^14

  explicit Draws(double overlap)
  {
    for (int i = 0; i < size; ++i)
    {
      const double turn = 2.0 * pi * (i + 0.5) / size;
      this->cosine[i] = static_cast<float>(std::cos(turn));
      this->sine[i] = static_cast<float>(std::sin(turn));
      // The share of the disc within a distance is that distance squared.
      const float exponent = glsl::noiseRimExponent * (static_cast<float>(i) + 0.5f) / size;
      this->envelope[i] = std::exp(-exponent);
    }
    this->fillCounts(overlap);
  }

private:
  void fillCounts(double overlap)
  {
    constexpr int quantiles = 1 << 14;
    this->counts.reserve(quantiles);
    int count = 0;
    double below = std::exp(-overlap); // cumulative up to count
    double term = below;
    for (int i = 0; i < quantiles; ++i)
    {
      while (below < (i + 0.5) / quantiles && count < mostKernels)
      {
        ++count;
        term *= overlap / count;
        below += term;
      }
      this->counts.push_back(static_cast<std::uint8_t>(count));
    }
  }
};

// Magnitude of one sum over its expected deviation.
float simulate(const Draws& draws, std::int64_t index)
{
  // Every number of kernels comes as often as it should.
  const int count = draws.counts[static_cast<std::size_t>(index) % draws.counts.size()];
  float x = 0.0f, y = 0.0f, variance = 0.0f;
  const std::uint64_t seed = hashPair(0x6e6f697365ull, static_cast<std::uint64_t>(index));
  std::uint64_t bits = 0;
  for (int i = 0; i < count; ++i)
  {
    bits = i % 3 == 0 ? hashPair(seed, static_cast<std::uint64_t>(i)) : bits >> 20;
    const float envelope = draws.envelope[bits % Draws::size];
    const std::size_t phase = bits / Draws::size % Draws::size;
    x += envelope * draws.cosine[phase];
    y += envelope * draws.sine[phase];
    variance += 0.5f * envelope * envelope;
  }
  return glsl::normalisedNoise(std::sqrt(x * x + y * y), variance, glsl::noiseVarianceFloor);
}

Histogram simulateMagnitudes(double overlap)
{
  const Draws draws(overlap);
  std::vector<Histogram> parts(simulations / simulationsPerRange);
  parallelForRanges(simulations, simulationsPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      Histogram& part = parts[begin / simulationsPerRange];
      part.fill(0);
      for (std::int64_t i = begin; i < end; ++i)
      {
        const auto bin = static_cast<int>(simulate(draws, i) * (magnitudeBins / range));
        ++part[std::min(bin, magnitudeBins - 1)];
      }
    });
  Histogram sum{};
  for (const Histogram& part : parts)
  {
    for (int bin = 0; bin < magnitudeBins; ++bin)
    {
      sum[bin] += part[bin];
    }
  }
  return sum;
}

// Share of the real parts that lie above a value of 0 or more.
double shareAbove(const Histogram& magnitudes, double value)
{
  double sum = 0.0;
  for (int bin = 0; bin < magnitudeBins; ++bin)
  {
    const double magnitude = (bin + 0.5) * (range / magnitudeBins);
    if (magnitudes[bin] > 0 && magnitude > value)
    {
      sum += magnitudes[bin] * std::acos(value / magnitude);
    }
  }
  return sum / (pi * simulations);
}

// The same for many kernels (Edgeworth's series). The fourth cumulant of a sum of cosines of
// amplitudes e over its deviation is -3/8 sum e^4 / (sum e^2 / 2)^2.
double gaussianShareAbove(double overlap, double value)
{
  const double rim = std::exp(-2.0 * glsl::noiseRimExponent);
  const double meanSquare = (1.0 - rim) / (2.0 * glsl::noiseRimExponent);
  const double meanFourth = (1.0 - rim * rim) / (4.0 * glsl::noiseRimExponent);
  const double cumulant = -1.5 * meanFourth / (meanSquare * meanSquare * overlap);
  const double density = std::exp(-0.5 * value * value) / std::sqrt(2.0 * pi);
  const double above = 0.5 * std::erfc(value / std::sqrt(2.0)) +
    cumulant / 24.0 * (value * value * value - 3.0 * value) * density;
  return std::max(above, 0.0);
}

std::shared_ptr<const NoiseDistribution> tabulate(double overlap)
{
  const bool many = overlap >= manyKernels;
  const Histogram magnitudes = many ? Histogram{} : simulateMagnitudes(overlap);
  constexpr int half = static_cast<int>(range * stepsPerDeviation);
  auto result = std::make_shared<NoiseDistribution>();
  result->range = range;
  result->share.assign(2 * half + 1, 0.5f);
  // What is 0 with certainty counts half to either side.
  double above = 0.5;
  for (int i = 1; i <= half; ++i)
  {
    const double value = static_cast<double>(i) / stepsPerDeviation;
    const double next = many ? gaussianShareAbove(overlap, value) : shareAbove(magnitudes, value);
    above = i < half ? std::min(above, next) : 0.0;
    result->share[half + i] = static_cast<float>(1.0 - above);
    result->share[half - i] = static_cast<float>(above);
  }
  return result;
}

} // namespace

std::shared_ptr<const NoiseDistribution> noiseDistribution(double overlap)
{
  if (!(overlap > 0.0 && std::isfinite(overlap)))
  {
    throw std::invalid_argument(
      "noiseDistribution: overlap is " + std::to_string(overlap) + ", expected a number above 0");
  }
  static std::mutex mutex;
  static std::map<double, std::shared_ptr<const NoiseDistribution>> tables;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = tables.find(overlap);
  if (found != tables.end())
  {
    return found->second;
  }
  if (tables.size() >= mostTables)
  {
    tables.clear();
  }
  auto table = tabulate(overlap);
  tables.emplace(overlap, table);
  return table;
}

} // namespace hachure

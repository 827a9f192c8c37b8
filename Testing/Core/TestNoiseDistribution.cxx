// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoiseScenes.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace hachure;
using namespace hachure::testing;

namespace
{

double normalShare(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

double shareBelow(const NoiseDistribution& distribution, double value)
{
  const double steps = static_cast<double>(distribution.share.size() - 1);
  const double place = (0.5 + 0.5 * value / distribution.range) * steps;
  const auto step = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(step);
  return (1.0 - part) * distribution.share[step] + part * distribution.share[step + 1];
}

FlatNoise pictureOf(double overlap, double radius, double frequency, std::uint32_t seed)
{
  FlatNoise noise;
  noise.rectangle = { 0, 0, 640, 480 };
  noise.overlap = overlap;
  noise.radius = radius;
  noise.frequency = frequency;
  noise.seed = seed;
  return noise;
}

// Largest distance of the shares of values below thresholds from these.
double unevenness(const std::vector<NoiseField>& fields)
{
  double most = 0.0;
  for (int step = 1; step < 20; ++step)
  {
    const double threshold = 0.05 * step;
    double below = 0.0, all = 0.0;
    for (const NoiseField& field : fields)
    {
      below += static_cast<double>(std::count_if(field.value.begin(), field.value.end(),
        [threshold](float value) { return value < threshold; }));
      all += static_cast<double>(field.value.size());
    }
    most = std::max(most, std::abs(below / all - threshold));
  }
  return most;
}

double meanInk(const std::vector<NoiseField>& fields, float threshold)
{
  double sum = 0.0, all = 0.0;
  for (const NoiseField& field : fields)
  {
    for (std::size_t i = 0; i < field.value.size(); ++i)
    {
      sum += glsl::inkCoverage(field.value[i], threshold, field.width[i]);
    }
    all += static_cast<double>(field.value.size());
  }
  return sum / all;
}

// Pictures that are not the measured ones, with the thresholds of these parameters.
void expectInkEqualsTone(const NoiseThresholdOptions& options, const std::string& what)
{
  const std::vector<float> thresholds = noiseThresholds(options);
  std::vector<NoiseField> fields;
  for (std::uint32_t seed = 11; seed < 13; ++seed)
  {
    FlatNoise noise = pictureOf(options.field.overlap, options.radius, options.frequency, seed);
    noise.orientation = 0.4;
    noise.spread = options.spread;
    fields.push_back(noiseField(noise.kernels(), noise.surroundings(), options.field));
  }
  ASSERT_EQ(thresholds.size(), 256u);
  EXPECT_TRUE(std::is_sorted(thresholds.begin(), thresholds.end())) << what;
  for (int tone = 13; tone <= 243; tone += 23)
  {
    EXPECT_NEAR(meanInk(fields, thresholds[tone]), tone / 255.0, 0.01) << what << " tone " << tone;
  }
  EXPECT_EQ(meanInk(fields, thresholds.front()), 0.0) << what;
  EXPECT_EQ(meanInk(fields, thresholds.back()), 1.0) << what;
}

} // namespace

TEST(NoiseDistribution, GrowsFromZeroToOneSymmetrically)
{
  for (const double overlap : { 0.2, 1.0, 4.0, 32.0, 1e4 })
  {
    const auto distribution = noiseDistribution(overlap);
    const std::vector<float>& share = distribution->share;
    EXPECT_EQ(share.front(), 0.0f);
    EXPECT_EQ(share.back(), 1.0f);
    EXPECT_TRUE(std::is_sorted(share.begin(), share.end())) << overlap;
    for (std::size_t i = 0; i < share.size(); ++i)
    {
      EXPECT_NEAR(share[i] + share[share.size() - 1 - i], 1.0, 1e-6);
    }
    EXPECT_EQ(noiseDistribution(overlap), distribution); // kept
  }
  EXPECT_THROW(noiseDistribution(0.0), std::invalid_argument);
}

TEST(NoiseDistribution, KnownLimits)
{
  const auto many = noiseDistribution(1000.0);
  for (const double x : { -2.0, -0.7, 0.3, 1.0, 2.5 })
  {
    EXPECT_NEAR(shareBelow(*many, x), normalShare(x), 1e-3) << x;
  }
  // Simulated below, by a series above.
  const auto below = noiseDistribution(47.9);
  const auto above = noiseDistribution(48.1);
  for (std::size_t i = 0; i < below->share.size(); ++i)
  {
    EXPECT_NEAR(below->share[i], above->share[i], 7e-4);
  }
  // Few kernels: none with probability exp(-N'), one alone is a cosine.
  const double overlap = 0.01;
  const auto few = noiseDistribution(overlap);
  const double some = 1.0 - std::exp(-overlap);
  EXPECT_NEAR(shareBelow(*few, 0.8), 1.0 - some * std::acos(0.8 / std::sqrt(2.0)) / pi, 1e-3);
}

TEST(NoiseDistribution, ValuesAreUniform)
{
  for (const double overlap : { 16.0, 32.0, 64.0, 128.0 })
  {
    std::vector<NoiseField> fields;
    for (std::uint32_t seed = 1; seed < 3; ++seed)
    {
      const FlatNoise noise = pictureOf(overlap, 7.0, 0.14, seed);
      fields.push_back(
        noiseField(noise.kernels(), noise.surroundings(), { NoiseKind::gabor, overlap, nullptr }));
    }
    EXPECT_LT(unevenness(fields), 0.01) << overlap;
  }
  const FlatNoise noise = pictureOf(16.0, 8.0, 0.125, 1);
  EXPECT_LT(unevenness({ noiseField(
              noise.kernels(), noise.surroundings(), { NoiseKind::phasor, 16.0, nullptr }) }),
    0.01);
}

TEST(NoiseThresholds, InkEqualsTone)
{
  for (const double frequency : { 1.0 / 6.0, 1.0 / 16.0 })
  {
    for (const double spread : { 0.0, 0.5 * pi })
    {
      for (const NoiseKind kind : { NoiseKind::gabor, NoiseKind::phasor })
      {
        NoiseThresholdOptions options;
        options.field.kind = kind;
        options.field.overlap = spread > 0.0 ? 16.0 : 32.0;
        options.frequency = frequency;
        options.radius = 1.2 / frequency;
        options.spread = spread;
        expectInkEqualsTone(options,
          "frequency " + std::to_string(frequency) + " spread " + std::to_string(spread) +
            " kind " + std::to_string(static_cast<int>(kind)));
      }
    }
  }
}

TEST(NoiseThresholds, InkEqualsToneForSpots)
{
  const NoiseSpot spot = { 3, 3, { 0, 1, 0, 1, 4, 1, 0, 1, 0 } };
  NoiseThresholdOptions options;
  options.field = { NoiseKind::spot, 16.0, &spot };
  options.radius = 5.0;
  expectInkEqualsTone(options, "spot");
}

TEST(NoiseThresholds, WrongInputIsRefused)
{
  NoiseThresholdOptions options;
  options.radius = 0.0;
  EXPECT_THROW(noiseThresholds(options), std::invalid_argument);
  options.radius = 5.0;
  options.field.overlap = -1.0;
  EXPECT_THROW(noiseThresholds(options), std::invalid_argument);
}

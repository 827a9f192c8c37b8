// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PatternMetricsFlatness.h"
#include "MetricClips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace hachure;
using namespace hachure::test;

namespace
{

constexpr int size = 160;

// By the definition: slow, and independent of any library.
void slowTransform(std::vector<std::complex<double>>& values)
{
  const std::size_t count = values.size();
  const double turn = 2.0 * std::acos(-1.0) / static_cast<double>(count);
  std::vector<std::complex<double>> factors, result(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    factors.push_back(std::polar(1.0, -turn * static_cast<double>(k)));
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      result[k] += values[i] * factors[i * k % count];
    }
  }
  values.swap(result);
}

// Frames at distances 1, 1.25, ...; the ink is drawn for each distance.
Clip stillClip(const std::function<std::vector<float>(double)>& draw)
{
  Clip clip;
  clip.size = size;
  for (int t = 0; t < 3; ++t)
  {
    const double distance = 1.0 + 0.25 * t;
    clip.inks.push_back(draw(distance));
    Clip::Motion motion;
    motion.u.assign(size * size, 0.0f);
    motion.v = motion.u;
    motion.visible.assign(size * size, 1.0f);
    motion.distance.assign(size * size, static_cast<float>(distance));
    clip.motions.push_back(motion);
  }
  return clip;
}

// A pattern whose wavelength is 8 / distance^slope.
Clip recedingClip(double slope)
{
  return stillClip(
    [slope](double distance)
    {
      return drawInk(
        size, noiseInk(8.0 / std::pow(distance, slope), 2), [](glm::dvec2 p) { return p; });
    });
}

// n.v falls from the left to the right, and a hatch across is compressed by (n.v)^slope.
Clip turnedClip(double slope)
{
  const auto facing = [](double x) { return std::exp2(-1.2 * x / size); };
  const double rate = 1.2 * std::log(2.0) * slope / size;
  const auto compressed = [=](glm::dvec2 p)
  { return glm::dvec2(rate > 0.0 ? (std::exp(rate * p.x) - 1.0) / rate : p.x, p.y); };
  Clip clip = stillClip([&](double) { return drawInk(size, hatchInk(9.0, 0.0), compressed); });
  for (Clip::Motion& motion : clip.motions)
  {
    for (int i = 0; i < size * size; ++i)
    {
      motion.facing.push_back(static_cast<float>(facing(i % size)));
    }
  }
  return clip;
}

} // namespace

TEST(PatternMetricsFlatness, CentroidOfAWaveIsItsFrequency)
{
  std::vector<float> wave;
  for (int i = 0; i < 64 * 64; ++i)
  {
    const int column = i % 64;
    const int row = i / 64;
    const double phase = 2.0 * std::acos(-1.0) * (8.0 * column + 6.0 * row) / 64.0;
    wave.push_back(static_cast<float>(0.5 + 0.4 * std::cos(phase)));
  }
  EXPECT_NEAR(spectralCentroid({ 64, 64, wave }, slowTransform), 10.0 / 64.0, 1e-3);
  const std::vector<float> blank(64 * 64, 0.3f);
  EXPECT_TRUE(std::isnan(spectralCentroid({ 64, 64, blank }, slowTransform)));
}

TEST(PatternMetricsFlatness, DistanceSlope)
{
  const Clip flat = recedingClip(0.0);
  const FlatnessMetrics zero = measureFlatness(flat.view(), slowTransform);
  EXPECT_NEAR(zero.distanceSlope, 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(zero.facingSlope)); // nothing is known of n.v
  EXPECT_EQ(zero.windows, 3 * 9);
  const Clip shrinking = recedingClip(1.0);
  const FlatnessMetrics one = measureFlatness(shrinking.view(), slowTransform);
  EXPECT_NEAR(one.distanceSlope, 1.0, 0.1);
  ASSERT_EQ(one.frequencies.size(), 3u);
  EXPECT_GT(one.frequencies[2], 1.4 * one.frequencies[0]);
}

TEST(PatternMetricsFlatness, FacingSlope)
{
  const Clip flat = turnedClip(0.0);
  EXPECT_NEAR(measureFlatness(flat.view(), slowTransform).facingSlope, 0.0, 0.05);
  const Clip compressed = turnedClip(1.0);
  EXPECT_NEAR(measureFlatness(compressed.view(), slowTransform).facingSlope, 1.0, 0.15);
}

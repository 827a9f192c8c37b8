// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PatternMetricsStipples.h"
#include "Core/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace hachure;

namespace
{

constexpr std::size_t pointCount = 570;
using Points = std::vector<glm::dvec2>;

glm::dvec2 randomPoint(std::uint32_t seed, std::uint64_t id)
{
  return { unitRandom(seed, id, 0), unitRandom(seed, id, 1) };
}

Points whiteNoise(std::uint32_t seed, std::size_t count = pointCount)
{
  Points points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(randomPoint(seed, i));
  }
  return points;
}

// Darts on a torus, thrown until about pointCount stick and hardly any more find a gap.
Points poissonDisk(std::uint32_t seed)
{
  const double radius = 0.82 / std::sqrt(static_cast<double>(pointCount));
  Points points;
  for (std::uint64_t id = 0; id < 60000; ++id)
  {
    const glm::dvec2 dart = randomPoint(seed, id);
    const bool free = std::none_of(points.begin(), points.end(),
      [&](glm::dvec2 other)
      {
        glm::dvec2 offset = dart - other;
        offset -= glm::round(offset);
        return glm::dot(offset, offset) < radius * radius;
      });
    if (free)
    {
      points.push_back(dart);
    }
  }
  return points;
}

template <class Generator>
StippleMetrics meanOf(Generator generate, std::uint32_t seeds, const StippleWindow& window = {})
{
  std::vector<StippleMetrics> sets;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed)
  {
    sets.push_back(measureStipples(generate(seed), window));
  }
  return meanOfStipples(sets);
}

std::string messageOf(const Points& points, const StippleWindow& window = {})
{
  try
  {
    measureStipples(points, window);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST(PatternMetricsStipples, WhiteNoise)
{
  const StippleMetrics mean = meanOf([](std::uint32_t seed) { return whiteNoise(seed); }, 10);
  EXPECT_NEAR(mean.meanPower, 1.0, 0.02);
  EXPECT_NEAR(mean.lowFrequencyPower, 1.0, 0.07); // 1100 frequencies: 2 deviations
  EXPECT_NEAR(mean.clarkEvans, 1.0, 0.03);
  EXPECT_NEAR(mean.relativeRadius, 0.03, 0.02);
  EXPECT_NEAR(mean.anisotropy, 0.0, 0.2);
}

TEST(PatternMetricsStipples, WhiteNoiseIsFlatInEveryRing)
{
  const StippleMetrics mean = meanOf([](std::uint32_t seed) { return whiteNoise(seed, 200); }, 120);
  for (const SpectrumRing& ring : mean.rings)
  {
    const double deviation = 1.0 / std::sqrt(120.0 * ring.count);
    EXPECT_NEAR(ring.power, 1.0, std::max(0.02, 4.0 * deviation)) << ring.frequency;
  }
}

TEST(PatternMetricsStipples, PoissonDisk)
{
  const StippleMetrics mean = meanOf(poissonDisk, 10);
  EXPECT_NEAR(mean.clarkEvans, 1.74, 0.03);
  EXPECT_NEAR(mean.relativeRadius, 0.76, 0.02);
  EXPECT_NEAR(mean.lowFrequencyPower, 0.075, 0.02);
  EXPECT_NEAR(mean.anisotropy, 0.0, 0.3);
}

TEST(PatternMetricsStipples, LinesAreAnisotropic)
{
  const auto columns = [](std::uint32_t seed)
  {
    Points points = whiteNoise(seed);
    for (glm::dvec2& point : points)
    {
      point.x = (std::floor(24.0 * point.x) + 0.5 + 0.2 * (point.x - 0.5)) / 24.0;
    }
    return points;
  };
  EXPECT_GT(meanOf(columns, 4).anisotropy, 10.0);
}

TEST(PatternMetricsStipples, LatticeHasTheLargestRadius)
{
  Points points;
  const StippleWindow window{ { 5.0, -2.0 }, { 20.0, 12.0 * std::sqrt(3.0) }, true };
  for (int i = 0; i < 20 * 24; ++i)
  {
    const int row = i / 20;
    points.emplace_back(5.0 + i % 20 + (row % 2 == 0 ? 0.0 : 0.5), -2.0 + row * std::sqrt(0.75));
  }
  const StippleMetrics metrics = measureStipples(points, window);
  EXPECT_NEAR(metrics.relativeRadius, 1.0, 1e-9);
  EXPECT_NEAR(metrics.clarkEvans, 2.149, 0.001); // Clark and Evans' largest value
}

TEST(PatternMetricsStipples, TheEdgeOfAWindowIsCorrected)
{
  const StippleWindow open{ { 0.0, 0.0 }, { 1.0, 1.0 }, false };
  const auto noise = [](std::uint32_t seed) { return whiteNoise(seed, 150); };
  EXPECT_NEAR(meanOf(noise, 60, open).clarkEvans, 1.0, 0.015);
}

TEST(PatternMetricsStipples, OppositeEdgesMeetIfPeriodic)
{
  Points points;
  for (int i = 0; i < 16; ++i)
  {
    const int column = i % 4;
    const int row = i / 4;
    points.emplace_back(0.125 + 0.25 * column, 0.125 + 0.25 * row);
  }
  points.emplace_back(0.001, 0.5);
  points.emplace_back(0.999, 0.5);
  StippleWindow window;
  const double lattice = std::sqrt(2.0 / (std::sqrt(3.0) * 18.0));
  EXPECT_NEAR(measureStipples(points, window).relativeRadius, 0.002 / lattice, 1e-9);
  window.periodic = false;
  EXPECT_NEAR(
    measureStipples(points, window).relativeRadius, std::hypot(0.124, 0.125) / lattice, 1e-9);
}

TEST(PatternMetricsStipples, Nesting)
{
  const Points all = whiteNoise(7);
  const Points half(all.begin(), all.begin() + 285);
  EXPECT_EQ(nesting(half, all), 1.0);
  EXPECT_EQ(nesting(all, whiteNoise(8)), 0.0);
  Points mixed(all.begin() + 200, all.begin() + 400);
  EXPECT_NEAR(nesting(half, mixed), 85.0 / 200.0, 1e-12);
  EXPECT_EQ(nesting(Points(), all), 1.0);
}

TEST(PatternMetricsStipples, WrongInput)
{
  EXPECT_NE(messageOf(whiteNoise(1, 15)).find("points: 15, expected 16"), std::string::npos);
  Points points = whiteNoise(1, 20);
  points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(messageOf(points).find("point 3 is ("), std::string::npos);
  points[3].y = 1.5;
  EXPECT_NE(messageOf(points).find("expected one inside the window"), std::string::npos);
  StippleWindow window;
  window.size.x = 0.0;
  EXPECT_NE(messageOf(points, window).find("window: 0.0"), std::string::npos);
}

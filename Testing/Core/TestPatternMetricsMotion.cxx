// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PatternMetricsMotion.h"
#include "MetricClips.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hachure;
using namespace hachure::test;

namespace
{

constexpr int size = 128;
constexpr double wavelength = 10.0;
const PlaneMotion still;

std::vector<PlaneMotion> motions()
{
  PlaneMotion translate, zoom, roll;
  translate.shift = { 1.37, -0.82 };
  zoom.zoom = 1.04;
  roll.roll = 0.04;
  return { translate, zoom, roll };
}

Ink noise(int)
{
  return noiseInk(wavelength, 3);
}

MotionMetrics measure(const Clip& clip, double length = wavelength)
{
  MotionMetricsOptions options;
  options.wavelength = length;
  return measureMotion(clip.view(), options);
}

} // namespace

TEST(PatternMetricsMotion, PatternFixedInTheImageSlidesByAllOfTheMotion)
{
  for (const PlaneMotion& motion : motions())
  {
    const MotionMetrics metrics = measure(planeClip(size, 3, motion, noise, still));
    EXPECT_NEAR(metrics.slideRatio, 1.0, 0.01);
    EXPECT_NEAR(metrics.normalSlideRatio, 1.0, 0.01);
    EXPECT_LT(metrics.coherence, 0.97);
    EXPECT_LT(metrics.medianBoil, 0.03); // the same picture, but for the turn within a block
  }
}

TEST(PatternMetricsMotion, PatternFixedToTheSurfaceDoesNotSlide)
{
  for (const PlaneMotion& motion : motions())
  {
    const MotionMetrics metrics = measure(planeClip(size, 3, motion, noise, motion));
    EXPECT_LT(metrics.slideRatio, 0.005);
    EXPECT_GE(metrics.coherence, 1.0 - 0.0005);
    EXPECT_LE(metrics.largestBoil, 0.0005);
    EXPECT_NEAR(metrics.pop, metrics.largestBoil / 0.001, 1e-12);
    EXPECT_GT(metrics.meanMotion, 1.0);
  }
}

TEST(PatternMetricsMotion, FindsATwentiethOfAPixel)
{
  for (const double angle : { 0.0, 0.7, 2.0 })
  {
    const glm::dvec2 slide = 0.05 * glm::dvec2(std::cos(angle), std::sin(angle));
    PlaneMotion surface = motions()[0];
    PlaneMotion pattern = surface;
    pattern.shift += slide;
    const MotionMetrics metrics = measure(planeClip(size, 3, surface, noise, pattern));
    EXPECT_NEAR(metrics.meanSlide, 0.05, 0.01);
    EXPECT_NEAR(metrics.slideRatio, 0.05 / glm::length(surface.shift), 0.005);
  }
}

TEST(PatternMetricsMotion, APopShowsInExactlyItsStep)
{
  const PlaneMotion motion = motions()[0];
  const auto pattern = [](int t) { return noiseInk(wavelength, t < 3 ? 3 : 4); };
  const MotionMetrics metrics = measure(planeClip(size, 6, motion, pattern, motion));
  ASSERT_EQ(metrics.steps.size(), 5u);
  for (std::size_t t = 0; t < 5; ++t)
  {
    if (t == 2)
    {
      EXPECT_NEAR(metrics.steps[t].boil, 0.6, 0.2);
    }
    else
    {
      EXPECT_LT(metrics.steps[t].boil, 0.0005);
    }
  }
  EXPECT_NEAR(metrics.pop, metrics.steps[2].boil / 0.001, 1e-9);
}

TEST(PatternMetricsMotion, StrokesCountAcrossAlone)
{
  const double angle = 0.6;
  const glm::dvec2 along(-std::sin(angle), std::cos(angle));
  const auto hatch = [=](int) { return hatchInk(wavelength, angle); };
  for (const PlaneMotion& motion : motions())
  {
    const MotionMetrics fixed = measure(planeClip(size, 3, motion, hatch, motion));
    EXPECT_LT(fixed.normalSlideRatio, 0.005);
    EXPECT_LT(fixed.largestBoil, 0.0005);
  }
  const PlaneMotion surface = motions()[0];
  PlaneMotion pattern = surface;
  pattern.shift += 1.0 * along; // nobody can see this
  for (const double length : { wavelength, 5.0 })
  {
    const auto strokes = [=](int) { return hatchInk(length, angle); };
    const MotionMetrics fixed = measure(planeClip(size, 3, surface, strokes, pattern), length);
    EXPECT_LT(fixed.normalSlideRatio, 0.005) << length;
    const MotionMetrics door = measure(planeClip(size, 3, surface, strokes, still), length);
    EXPECT_NEAR(door.normalSlideRatio, 1.0, 0.01) << length;
  }
}

TEST(PatternMetricsMotion, BackgroundAndHiddenSurfaceDoNotCount)
{
  const PlaneMotion motion = motions()[0];
  Clip clip = planeClip(size, 2, motion, noise, motion);
  for (std::size_t i = 0; i < clip.motions[0].visible.size(); ++i)
  {
    const auto x = i % size;
    if (x < 30) // background
    {
      clip.motions[0].visible[i] = 0.0f;
      clip.motions[0].u[i] = NAN; // anything may stand there
    }
    if (x < 31) // pixels that lead on are at 31.37 and above
    {
      clip.inks[1][i] = 1.0f;
    }
    clip.motions[0].facing.push_back(x > 100 ? 0.2f : 0.9f);
    if (x > 102)
    {
      clip.inks[1][i] = 0.0f;
    }
  }
  const MotionMetrics metrics = measure(clip);
  EXPECT_LT(metrics.slideRatio, 0.005);
  EXPECT_LE(metrics.largestBoil, 0.0005);
}

TEST(PatternMetricsMotion, WithoutContrastOrMotionNothingIsKnown)
{
  const auto blank = [](int) { return [](glm::dvec2) { return 0.0; }; };
  const MotionMetrics empty = measure(planeClip(size, 3, motions()[0], blank, still));
  EXPECT_TRUE(std::isnan(empty.slideRatio) && std::isnan(empty.coherence));
  EXPECT_EQ(empty.steps[0].blocks, 0);
  const MotionMetrics constant = measure(planeClip(size, 3, still, noise, still));
  EXPECT_TRUE(std::isnan(constant.slideRatio));
  EXPECT_LT(constant.meanSlide, 1e-4);
  EXPECT_NEAR(constant.coherence, 1.0, 1e-6);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "Core/PatternMetricsCooccurrence.h"
#include "Core/PatternMetricsImage.h"
#include "MetricClips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

using namespace hachure;
using namespace hachure::test;

namespace
{

constexpr int size = 160;
constexpr double wavelength = 8.0;

// Two equal frames of a still plane.
Clip stillClip(const std::vector<float>& ink)
{
  Clip clip;
  clip.size = size;
  clip.inks.assign(2, ink);
  Clip::Motion motion;
  motion.u.assign(ink.size(), 0.0f);
  motion.v = motion.u;
  motion.visible.assign(ink.size(), 1.0f);
  clip.motions.assign(1, motion);
  return clip;
}

std::vector<float> draw(
  const Ink& ink, const Move& toPlane = [](glm::dvec2 p) { return p; })
{
  return drawInk(size, ink, toPlane);
}

double errorOf(const std::vector<float>& frame, const std::vector<float>& reference)
{
  const Clip clip = stillClip(frame);
  return measureCooccurrence(clip.view(), { size, size, reference }, { wavelength, 0.3, 1.0 })
    .error;
}

// Turned by an angle and scaled along x, about nothing in particular.
Move turned(double degrees, double stretch = 1.0, double scale = 1.0)
{
  const double angle = degrees * std::acos(-1.0) / 180.0;
  const glm::dvec2 z(std::cos(angle), std::sin(angle));
  return [=](glm::dvec2 p)
  {
    p = glm::dvec2(p.x / (scale * stretch), p.y / scale);
    return glm::dvec2(z.x * p.x - z.y * p.y + 31.3, z.y * p.x + z.x * p.y - 17.8);
  };
}

} // namespace

TEST(PatternMetricsCooccurrence, RowsOfTheSplineAreTheSpline)
{
  const std::vector<float> ink = draw(noiseInk(wavelength, 1));
  const MetricImage spline = splineCoefficients({ size, size, ink });
  std::vector<float> row;
  sampleSplineRow(spline, 20, -3.3, 5.6, row);
  EXPECT_EQ(row[3], 0.0f); // at -0.3
  EXPECT_EQ(row[4], 0.0f); // between the first two
  for (int x = 5; x < size; ++x)
  {
    ASSERT_NEAR(row[static_cast<std::size_t>(x)], sampleSpline(spline, x - 3.3, 25.6), 1e-6) << x;
  }
  sampleSplineRow(spline, size - 3, 0.0, 1.5, row);
  EXPECT_EQ(*std::max_element(row.begin(), row.end()), 0.0f);
}

TEST(PatternMetricsCooccurrence, TheSamePatternShiftedAndTurned)
{
  for (const Ink& ink : { noiseInk(wavelength, 1), hatchInk(wavelength, 0.4) })
  {
    const std::vector<float> reference = draw(ink);
    EXPECT_EQ(errorOf(reference, reference), 0.0);
    for (const double degrees : { 0.0, 11.25, 30.0, 77.0 })
    {
      EXPECT_LT(errorOf(draw(ink, turned(degrees)), reference), 0.05) << degrees;
    }
  }
  const std::vector<float> noise = draw(noiseInk(wavelength, 1));
  EXPECT_LT(errorOf(draw(noiseInk(wavelength, 2)), noise), 0.05) << "another piece of it";
}

TEST(PatternMetricsCooccurrence, GrowsWithStretchAndScale)
{
  for (const Ink& ink : { noiseInk(wavelength, 1), hatchInk(wavelength, 0.4) })
  {
    const std::vector<float> reference = draw(ink);
    double previous = 0.05;
    for (const double stretch : { 1.25, 1.5, 2.0, 3.0 })
    {
      const double error = errorOf(draw(ink, turned(0.0, stretch)), reference);
      EXPECT_GT(error, previous) << stretch;
      previous = error;
    }
    const double larger = errorOf(draw(ink, turned(0.0, 1.0, 1.4)), reference);
    EXPECT_GT(larger, 0.2);
    EXPECT_GT(errorOf(draw(ink, turned(0.0, 1.0, 2.0)), reference), larger + 0.1);
    EXPECT_GT(errorOf(draw(ink, turned(0.0, 1.0, 0.7)), reference), 0.2);
  }
}

TEST(PatternMetricsCooccurrence, OtherPatternsAndFadedOnes)
{
  const std::vector<float> noise = draw(noiseInk(wavelength, 1));
  EXPECT_GT(errorOf(draw(hatchInk(wavelength, 0.4)), noise), 0.2);
  double previous = 0.0;
  for (const float contrast : { 0.9f, 0.7f, 0.4f, 0.0f })
  {
    std::vector<float> faded = noise;
    for (float& ink : faded)
    {
      ink = 0.5f + contrast * (ink - 0.5f);
    }
    const double error = errorOf(faded, noise);
    EXPECT_GT(error, previous + 0.1) << contrast;
    EXPECT_LE(error, 1.0);
    previous = error;
  }
}

// What is not in sight does not count, and neither do pairs across it.
TEST(PatternMetricsCooccurrence, UsablePixelsAlone)
{
  const std::vector<float> reference = draw(noiseInk(wavelength, 1));
  Clip clip = stillClip(reference);
  std::vector<float>& ink = clip.inks[0];
  clip.motions[0].facing.assign(ink.size(), 1.0f);
  for (std::size_t i = 0; i < ink.size(); ++i)
  {
    const std::size_t x = i % size;
    if (x % 52 >= 30)
    {
      ink[i] = 1.0f;
      clip.motions[0].visible[i] = 0.0f;
    }
    if (x >= 130)
    {
      ink[i] = 0.0f;
      clip.motions[0].facing[i] = 0.2f;
    }
  }
  clip.motions.push_back(clip.motions[0]);
  clip.motions[1].visible.assign(ink.size(), 0.0f);
  clip.motions[1].visible[0] = 1.0f;
  const ImageView whole{ size, size, reference };
  const CooccurrenceMetrics metrics =
    measureCooccurrence(clip.view(), whole, { 2.0 * wavelength, 0.3, 1.0 });
  ASSERT_EQ(metrics.frames.size(), 2u);
  EXPECT_LT(metrics.frames[0], 0.03);
  EXPECT_TRUE(std::isnan(metrics.frames[1])) << "no pair in sight";
  EXPECT_EQ(metrics.error, metrics.frames[0]);
}

TEST(PatternMetricsCooccurrence, WrongInput)
{
  const std::vector<float> ink = draw(hatchInk(wavelength, 0.4));
  const Clip clip = stillClip(ink);
  const auto expect = [&](const ImageView& reference, CooccurrenceOptions options, const char* part)
  {
    const std::string message =
      messageOf([&] { measureCooccurrence(clip.view(), reference, options); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const ImageView good{ size, size, ink };
  // Three wavelengths of 8 pixels and twice 3 pixels of smoothing and 3 of interpolation.
  expect({}, {}, "reference: 0 x 0 pixels, expected at least 36 x 36");
  expect({ 35, 40, good.values.subspan(0, 35 * 40) }, {}, "reference: 35 x 40 pixels");
  expect({ size, 100, ink }, {}, "reference: 25600 values, expected 16000");
  std::vector<float> broken = ink;
  broken[2 * size + 1] = std::numeric_limits<float>::quiet_NaN();
  expect({ size, size, broken }, {}, "reference: ink nan at pixel (1, 2)");
  expect(good, { 2.0, 0.3, 1.0 }, "wavelength: 2.0");
  expect(good, { 8.0, 1.5, 1.0 }, "minimumFacing: 1.5");
  expect(good, { 8.0, 0.3, -1.0 }, "smoothing: -1.0");
  PatternClip none = clip.view();
  none.motions.clear();
  EXPECT_NE(
    messageOf([&] { measureCooccurrence(none, good); }).find("motions: none"), std::string::npos);
}

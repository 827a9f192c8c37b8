// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/PatternPlacement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace hachure;

namespace
{

constexpr double quarterTurn = 1.57079632679489662;

PlacementOptions fading(LodTransition transition = LodTransition::crossFade)
{
  PlacementOptions options;
  options.tileSize = { 64.0, 32.0 };
  options.table.transition = transition;
  return options;
}

PatternFrame scaled(double scale, glm::dvec2 origin = { 0.0, 0.0 })
{
  return { origin, { scale, 0.0 }, { 0.0, scale } };
}

double wrapped(double value)
{
  return value - std::floor(value);
}

glm::dvec2 tileAt(const PatternPlacement& placement, double x, double y)
{
  const glm::vec3 position(x, y, 1.0);
  return { glm::dot(placement.right, position), glm::dot(placement.up, position) };
}

} // namespace

TEST(PatternPlacement, OriginAndAxesOfTheFrameAreThoseOfTheTile)
{
  PlacementOptions options = fading();
  options.angle = quarterTurn;
  const PatternFrame frame{ { 1000.0, 50.0 }, { 1.25, 0.0 }, { 0.0, 1.25 } };
  const PatternPlacement placement = placePattern(frame, options);
  const glm::dvec2 origin = tileAt(placement, 1000.0, 50.0);
  EXPECT_NEAR(origin.x - std::round(origin.x), 0.0, 1e-4);
  EXPECT_NEAR(origin.y - std::round(origin.y), 0.0, 1e-4);
  // One tile further along the turned axes.
  const glm::dvec2 along = tileAt(placement, 1000.0, 50.0 + 1.25 * 64.0) - origin;
  EXPECT_NEAR(along.x, 1.0, 1e-5);
  EXPECT_NEAR(along.y, 0.0, 1e-5);
  const glm::dvec2 across = tileAt(placement, 1000.0 - 1.25 * 32.0, 50.0) - origin;
  EXPECT_NEAR(across.x, 0.0, 1e-5);
  EXPECT_NEAR(across.y, 1.0, 1e-5);
  EXPECT_NEAR(placement.texelsPerPixel, 4.0 / 1.25, 1e-6);
}

// What the second octave is before the scale wraps, the first one is after it; growing and
// shrinking alike.
TEST(PatternPlacement, OctavesMeet)
{
  for (const LodTransition transition : { LodTransition::crossFade, LodTransition::blendScreens })
  {
    for (const double octave : { 0.25, 1.0, 8.0 })
    {
      const glm::dvec2 origin(20.0, 30.0);
      const double e = 1e-6;
      const auto before = placePattern(scaled(octave * (2.0 - e), origin), fading(transition));
      const auto after = placePattern(scaled(octave * 2.0 * (1.0 + e), origin), fading(transition));
      EXPECT_EQ(before.blend, 1.0f);
      EXPECT_EQ(after.blend, 0.0f);
      EXPECT_NEAR(2.0f * before.texelsPerPixel, after.texelsPerPixel, 1e-4f);
      // A period of ten texels turns into flat tone here.
      EXPECT_NEAR(glsl::flatShare(1.0f, 1.0f, 10.0f / before.texelsPerPixel),
        glsl::flatShare(1.0f, 0.0f, 10.0f / after.texelsPerPixel), 1e-4f);
      const double lastRow =
        transition == LodTransition::blendScreens ? glsl::tableSteps - 1.0 : 0.0;
      EXPECT_NEAR(before.row.y - lastRow, after.row.x, 1e-3f);
      const glm::dvec2 old = tileAt(before, 321.0, 123.0);
      const glm::dvec2 now = tileAt(after, 321.0, 123.0);
      EXPECT_NEAR(wrapped(2.0 * old.x - now.x + 0.5), 0.5, 1e-4);
      EXPECT_NEAR(wrapped(2.0 * old.y - now.y + 0.5), 0.5, 1e-4);
    }
  }
}

TEST(PatternPlacement, BlendGoesFromStartToEnd)
{
  PlacementOptions options = fading();
  const double middle = std::sqrt(1.3 * 1.7);
  EXPECT_EQ(placePattern(scaled(1.3), options).blend, 0.0f);
  EXPECT_NEAR(placePattern(scaled(middle), options).blend, 0.5f, 1e-5f);
  EXPECT_NEAR(placePattern(scaled(0.5 * middle), options).blend, 0.5f, 1e-5f);
  EXPECT_EQ(placePattern(scaled(1.71), options).blend, 1.0f);
  options.contrast = 0.0f; // the classic pace
  EXPECT_NEAR(placePattern(scaled(1.5), options).blend, 0.5f, 1e-5f);
}

TEST(PatternPlacement, TimedTransitionsGoByTheirShare)
{
  PlacementOptions options = fading();
  options.contrast = 0.8f;
  TimedOctave timed{ true, 3, 0.25, 1 };
  for (const double size : { 1.01, 1.5, 1.99 })
  {
    const PatternPlacement placement = placePattern(scaled(8.0 * size), options, &timed);
    EXPECT_NEAR(placement.blend, glsl::evenBlend(0.25f, 0.8f), 1e-6f);
    EXPECT_NEAR(placement.texelsPerPixel, options.table.texelsPerPixelAtScale1 / size, 1e-4f);
  }
  timed.octave = 4; // drawn alone, smaller than at scale 1
  timed.share = 0.0;
  timed.direction = 0;
  EXPECT_EQ(placePattern(scaled(8.0 * 1.4), options, &timed).blend, 1.0f);
  options.table.transition = LodTransition::none;
  EXPECT_EQ(placePattern(scaled(8.0 * 1.4), options, &timed).blend, 0.0f);
}

TEST(PatternPlacement, EachOctaveHasItsOwnRow)
{
  PlacementOptions options = fading();
  const PatternPlacement fade = placePattern(scaled(1.5), options);
  EXPECT_NEAR(fade.row.x, (glsl::octaveSteps - 1.0) * (1.0 + std::log2(1.5)) / 2.0 + 0.5, 1e-3);
  EXPECT_NEAR(fade.row.x - fade.row.y, (glsl::octaveSteps - 1.0) / 2.0, 1e-3);
  options.table.transition = LodTransition::blendScreens;
  const PatternPlacement blend = placePattern(scaled(1.5), options);
  EXPECT_EQ(blend.row.x, blend.row.y);
}

TEST(PatternPlacement, FixedInTheImageWhateverTheFrame)
{
  const PlacementOptions options = fading(LodTransition::none);
  const PatternPlacement moved = placePattern(scaled(1.6, { 5.0, 6.0 }), options);
  const PatternPlacement still = placePattern(scaled(1.0), options);
  EXPECT_EQ(moved.right, still.right);
  EXPECT_EQ(moved.up, still.up);
  EXPECT_EQ(moved.blend, 0.0f);
  EXPECT_EQ(moved.row, still.row);
}

TEST(PatternPlacement, WrongSizesAreNamed)
{
  PlacementOptions options = fading();
  options.tileSize.y = 0.0;
  try
  {
    placePattern({}, options);
    FAIL() << "no error";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("tileSize.y: 0"), std::string::npos) << error.what();
  }
  options = fading();
  options.tileSize.y = NAN;
  EXPECT_THROW(placePattern({}, options), std::invalid_argument);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace hachure;

namespace
{

// Area of a disc inside the unit square about its centre, by integrating its chords.
double discArea(double radius)
{
  constexpr int slices = 200000;
  double sum = 0.0;
  for (int i = 0; i < slices; ++i)
  {
    const double x = 0.5 * (i + 0.5) / slices;
    const double square = radius * radius - x * x;
    sum += square > 0.0 ? std::min(0.5, std::sqrt(square)) : 0.0;
  }
  return 4.0 * sum * 0.5 / slices;
}

// Share of a period where the screen is below the tone.
template <class Screen>
double coverage(Screen&& screen, float tone)
{
  constexpr int side = 1500;
  int inked = 0;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      inked += screen(glm::vec2((x + 0.5f) / side, (y + 0.5f) / side)) < tone ? 1 : 0;
    }
  }
  return static_cast<double>(inked) / (side * side);
}

// Mean ink of a ruled hatch, drawn with edges of width w at this threshold.
double hatchInk(float threshold, float w)
{
  constexpr int places = 40000;
  double sum = 0.0;
  for (int i = 0; i < places; ++i)
  {
    const float screen = glsl::hatchScreen(glm::vec2(0.0f, (i + 0.5f) / places));
    sum += glsl::inkCoverage(screen, threshold, w);
  }
  return sum / places;
}

} // namespace

// The dot screen of a point is the area of the disc through that point: then coverage is the tone.
TEST(Kernels, DotScreenIsTheAreaOfTheDot)
{
  for (float radius = 0.02f; radius < 0.71f; radius += 0.03f)
  {
    EXPECT_NEAR(glsl::discInSquare(radius), discArea(radius), 2e-5) << radius;
    if (radius < 0.5f)
    {
      EXPECT_NEAR(glsl::dotScreen(glm::vec2(3.0f + radius, -1.0f)), discArea(radius), 2e-5);
    }
  }
  EXPECT_FLOAT_EQ(glsl::discInSquare(0.0f), 0.0f);
  EXPECT_FLOAT_EQ(glsl::discInSquare(0.8f), 1.0f);
}

TEST(Kernels, ScreensAreUniform)
{
  for (const float tone : { 0.05f, 0.3f, 0.5f, 0.8f, 0.95f })
  {
    EXPECT_NEAR(coverage([](glm::vec2 p) { return glsl::hatchScreen(p); }, tone), tone, 7e-4);
    EXPECT_NEAR(coverage([](glm::vec2 p) { return glsl::dotScreen(p); }, tone), tone, 7e-4);
    for (const float delay : { 0.0f, 0.4f })
    {
      const auto screen = [delay](glm::vec2 p) { return glsl::crossHatchScreen(p, delay); };
      EXPECT_NEAR(coverage(screen, tone), tone, 1.5e-3) << delay;
    }
  }
}

TEST(Kernels, ExactThresholdMakesInkEqualTone)
{
  for (const float w : { 1e-4f, 0.1f, 0.25f, 0.5f, 1.0f })
  {
    for (float tone = 0.0f; tone <= 1.0f; tone += 0.0625f)
    {
      EXPECT_NEAR(hatchInk(glsl::exactThreshold(tone, w), w), tone, 1e-4) << w;
    }
    EXPECT_EQ(hatchInk(glsl::exactThreshold(0.0f, w), w), 0.0);
    EXPECT_EQ(hatchInk(glsl::exactThreshold(1.0f, w), w), 1.0);
  }
  // Why it is needed: the plain threshold prints ink where there is no tone.
  EXPECT_GT(hatchInk(0.0f, 0.25f), 0.03);
}

TEST(Kernels, ScaleWrapsByOctaves)
{
  for (const float scale : { 1.0f, 1.37f, 1.999f })
  {
    for (int octave = -20; octave <= 20; ++octave)
    {
      EXPECT_NEAR(glsl::wrapScale(std::ldexp(scale, octave)), scale, 1e-6f);
    }
  }
  EXPECT_EQ(glsl::wrapScale(0.0f), 1.0f);
  EXPECT_EQ(glsl::wrapScale(-3.0f), 1.0f);
}

TEST(Kernels, HalfSizeCopyTakesOverBetweenTwoScales)
{
  for (const float contrast : { 0.0f, 0.6f, 1.0f })
  {
    EXPECT_EQ(glsl::lodBlend(1.2f, 1.3f, 1.7f, contrast), 0.0f);
    EXPECT_EQ(glsl::lodBlend(1.3f, 1.3f, 1.7f, contrast), 0.0f);
    EXPECT_EQ(glsl::lodBlend(1.7f, 1.3f, 1.7f, contrast), 1.0f);
    EXPECT_EQ(glsl::lodBlend(1.8f, 1.3f, 1.7f, contrast), 1.0f);
    EXPECT_NEAR(glsl::lodBlend(1.30001f, 1.3f, 1.7f, contrast), 0.0f, 1e-4f);
    EXPECT_NEAR(glsl::lodBlend(1.69999f, 1.3f, 1.7f, contrast), 1.0f, 1e-4f);
    EXPECT_EQ(glsl::lodBlend(1.5f, 1.5f, 1.5f, contrast), 1.0f);
    EXPECT_EQ(glsl::lodBlend(1.49f, 1.5f, 1.5f, contrast), 0.0f);
    for (const float blend : { 0.0f, 0.1f, 0.5f, 0.8f, 1.0f })
    {
      const float scale = glsl::lodScale(blend, 1.3f, 1.7f, contrast);
      EXPECT_NEAR(glsl::lodBlend(scale, 1.3f, 1.7f, contrast), blend, 1e-5f);
    }
  }
  EXPECT_NEAR(glsl::lodBlend(1.5f, 1.3f, 1.7f, 0.0f), 0.5f, 1e-6f);
  EXPECT_NEAR(glsl::lodBlend(std::sqrt(1.3f * 1.7f), 1.3f, 1.7f, 1.0f), 0.5f, 1e-6f);
}

TEST(Kernels, EvenPaceTurnsThePictureEquallyFarWithEqualGrowth)
{
  // Mixed from pictures at right angles, the picture is the vector (1 - t, contrast t).
  constexpr int steps = 12;
  for (const float contrast : { 0.6f, 1.0f })
  {
    const auto picture = [&](int step)
    {
      const float scale = 1.3f * std::pow(1.7f / 1.3f, static_cast<float>(step) / steps);
      const float t = glsl::lodBlend(scale, 1.3f, 1.7f, contrast);
      return glm::normalize(glm::vec2(1.0f - t, contrast * t));
    };
    for (int step = 0; step < steps; ++step)
    {
      const glm::vec2 from = picture(step);
      const glm::vec2 to = picture(step + 1);
      const float angle = std::asin(from.x * to.y - from.y * to.x);
      EXPECT_NEAR(angle, glsl::quarterTurn / steps, 2e-6f) << contrast << " " << step;
    }
  }
}

TEST(Kernels, TableRowAndScaleAreInverse)
{
  for (const float contrast : { 0.0f, 0.6f, 1.0f })
  {
    for (const glm::vec2 lod : { glm::vec2(1.3f, 1.7f), glm::vec2(1.01f, 1.99f) })
    {
      for (int row = 0; row < static_cast<int>(glsl::tableSteps); ++row)
      {
        const float scale = glsl::tableScale(static_cast<float>(row), lod.x, lod.y, contrast);
        EXPECT_NEAR(
          glsl::tableRow(scale, lod.x, lod.y, contrast) * glsl::tableSteps - 0.5f, row, 1e-3f);
      }
    }
    EXPECT_FLOAT_EQ(glsl::tableScale(0.0f, 1.3f, 1.7f, contrast), 1.0f);
    EXPECT_FLOAT_EQ(glsl::tableScale(glsl::tableSteps - 1.0f, 1.3f, 1.7f, contrast), 2.0f);
  }
}

TEST(Kernels, MixingInLinearLight)
{
  const glm::vec3 paper(0.9f, 0.8f, 0.7f);
  const glm::vec3 ink(0.1f, 0.2f, 0.6f);
  EXPECT_LT(glm::length(glsl::fromLinear(glsl::toLinear(paper)) - paper), 1e-5f);
  for (const auto blend :
    { glsl::blendOver, glsl::blendMultiply, glsl::blendScreen, glsl::blendOverlay })
  {
    if (blend != glsl::blendScreen)
    {
      EXPECT_LT(blend(paper, ink, 1.0f).y, paper.y);
    }
    EXPECT_LT(glm::length(blend(paper, ink, 0.0f) - paper), 1e-6f);
  }
  EXPECT_LT(glm::length(glsl::blendOver(paper, ink, 1.0f) - ink), 1e-6f);
  EXPECT_LT(glm::length(glsl::blendMultiply(paper, ink, 1.0f) - paper * ink), 1e-6f);
  EXPECT_GT(glsl::blendScreen(ink, paper, 1.0f).x, paper.x);
}

TEST(Kernels, HashSpreadsNeighbours)
{
  std::set<unsigned int> seen;
  double sum = 0.0;
  for (unsigned int i = 0; i < 10000u; ++i)
  {
    const unsigned int bits = glsl::hashPair(i % 100u, i / 100u);
    seen.insert(bits);
    sum += glsl::hashToUnit(bits);
  }
  EXPECT_GT(seen.size(), 9995u);
  EXPECT_NEAR(sum / 10000.0, 0.5, 0.01);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "Core/ViewFade.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hachure;

namespace
{
glm::dvec3 direction(double angle, double around)
{
  return { std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
    std::cos(angle) };
}

glm::vec3 towards(const glm::dvec3& from, const glm::dvec3& to)
{
  return glm::vec3(glm::normalize(to - from));
}

float shareOf(const TextureView& view, const glm::dvec3& cell, const glm::dvec3& camera,
  float fromMiddle = 0.0f)
{
  const std::vector<glm::vec3> directions = { towards(cell, camera) };
  std::vector<float> shares(1, -1.0f);
  ViewFade(view).shares(cell, fromMiddle, directions, shares);
  return shares[0];
}

TextureView fadingView(FadeMode mode, int extremes)
{
  TextureView view = viewFrom({ 0, 0, 5 }, glm::dvec3(0.0), 10, 10);
  view.dependent = true;
  view.fadeMode = mode;
  view.fadeCurve = { { 0.0, 1.0 }, { 1.0, 0.0 } };
  view.extremes = extremesAround(view, extremes, 0.6);
  return view;
}

// On the view's sphere about its focus.
glm::dvec3 cameraAt(double angle, double around)
{
  return 5.0 * direction(angle, around);
}

const std::vector<glm::dvec3> cellPlaces = { { 0, 0, 0 }, { 0.6, 0.3, 0.2 }, { -0.4, 0.7, -0.3 } };
} // namespace

TEST(ViewFade, BorderGoesThroughExtremeDirections)
{
  // Neither convex nor around the centre evenly.
  const std::vector<glm::dvec3> extremes = { direction(0.9, 0.3), direction(0.3, 2.0),
    2.0 * direction(1.2, 2.9), direction(0.5, -1.7) };
  const FadeRegion region({ 0, 0, 1 }, extremes);
  for (const glm::dvec3& extreme : extremes)
  {
    EXPECT_NEAR(region.relativeAngle(glm::vec3(glm::normalize(extreme))), 1.0f, 1e-4f);
  }
  EXPECT_EQ(region.relativeAngle({ 0, 0, 1 }), 0.0f);
  // Between two of them on their great circle.
  for (std::size_t i = 0; i < extremes.size(); ++i)
  {
    const glm::dvec3 a = glm::normalize(extremes[i]);
    const glm::dvec3 b = glm::normalize(extremes[(i + 1) % extremes.size()]);
    for (const double share : { 0.1, 0.5, 0.8 })
    {
      const glm::dvec3 between = glm::normalize((1.0 - share) * a + share * b);
      EXPECT_NEAR(region.relativeAngle(glm::vec3(between)), 1.0f, 1e-4f) << i;
    }
  }
}

TEST(ViewFade, AngleIsRelativeAlongEveryRay)
{
  const std::vector<glm::dvec3> extremes = { direction(0.9, 0.3), direction(0.3, 2.0),
    direction(0.5, -1.7) };
  const FadeRegion region({ 0, 0, 1 }, extremes);
  for (int i = 0; i < 50; ++i)
  {
    const double around = 0.126 * i;
    const float at = region.relativeAngle(glm::vec3(direction(0.1, around)));
    EXPECT_NEAR(region.relativeAngle(glm::vec3(direction(0.05, around))), 0.5f * at, 1e-4f);
    EXPECT_GT(at, 0.0f);
    // Around it is continuous.
    EXPECT_NEAR(region.relativeAngle(glm::vec3(direction(0.1, around + 1e-4))), at, 1e-3f);
  }
}

// Over more than half a turn the angle runs from one extreme's to the next one's.
TEST(ViewFade, WideGapsAreInterpolated)
{
  const std::vector<glm::dvec3> extremes = { direction(0.4, 0.0), direction(0.8, 1.0) };
  const FadeRegion region({ 0, 0, 1 }, extremes);
  const double gap = 2.0 * 3.14159265358979 - 1.0;
  for (const double share : { 0.0, 0.25, 0.5, 1.0 })
  {
    const double around = 1.0 + share * gap;
    const double border = 0.8 - 0.4 * share;
    EXPECT_NEAR(region.relativeAngle(glm::vec3(direction(border, around))), 1.0f, 1e-3f);
  }
}

TEST(ViewFade, OneExtremeIsAConeAndNoneEverything)
{
  const std::vector<glm::dvec3> one = { direction(0.5, 1.0) };
  const FadeRegion cone({ 0, 0, 2 }, one);
  const FadeRegion all({ 0, 0, 2 }, {});
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_NEAR(cone.relativeAngle(glm::vec3(direction(0.25, 0.4 * i))), 0.5f, 1e-4f);
    EXPECT_EQ(all.relativeAngle(glm::vec3(direction(0.15 * i, 0.4 * i))), 0.0f);
  }
}

TEST(ViewFade, DegenerateExtremesAreFinite)
{
  const glm::dvec3 c(0, 0, 1);
  const std::vector<std::vector<glm::dvec3>> sets = { { c }, { c, c, c }, { -c }, { -c, c },
    { direction(0.3, 0), direction(0.3, 0) }, { direction(0.3, 0), direction(0.6, 0) },
    { direction(0.3, 0), direction(0.3, 3.14159265358979) },
    { direction(0.3, 1), -direction(0.3, 1) }, { glm::dvec3(0.0) }, { c, direction(0.2, 1) } };
  for (const std::vector<glm::dvec3>& extremes : sets)
  {
    const FadeRegion region(c, extremes);
    for (int i = 0; i <= 20; ++i)
    {
      for (int j = 0; j < 20; ++j)
      {
        const float angle = region.relativeAngle(glm::vec3(direction(0.157 * i, 0.31 * j)));
        EXPECT_TRUE(std::isfinite(angle));
        EXPECT_GE(angle, 0.0f);
      }
    }
    EXPECT_EQ(region.relativeAngle(glm::vec3(c)), 0.0f);
  }
  const FadeRegion none(glm::dvec3(0.0), sets[4]);
  EXPECT_TRUE(std::isfinite(none.relativeAngle({ 1, 0, 0 })));
}

TEST(ViewFade, CurveIsLinearBetweenItsPoints)
{
  const std::vector<glm::dvec2> curve = { { 0.2, 0.8 }, { 0.4, 0.4 }, { 0.4, 0.6 }, { 0.8, 0.2 } };
  EXPECT_FLOAT_EQ(fadeCurveAt(curve, 0.0f), 0.8f);
  EXPECT_FLOAT_EQ(fadeCurveAt(curve, 0.3f), 0.6f);
  EXPECT_FLOAT_EQ(fadeCurveAt(curve, 0.6f), 0.4f);
  EXPECT_FLOAT_EQ(fadeCurveAt(curve, 1.0f), 0.2f);
  EXPECT_EQ(fadeCurveAt(curve, 1.01f), 0.0f);
}

// In every mode a view is whole from its own camera, gone from its extremes, and between.
TEST(ViewFade, IsWholeFromItsCameraAndGoneAtItsExtremes)
{
  for (const FadeMode mode : { FadeMode::Curve, FadeMode::Middle, FadeMode::Even })
  {
    for (const int count : { 1, 2, 3, 4, 7 })
    {
      const TextureView view = fadingView(mode, count);
      for (const glm::dvec3& cell : cellPlaces)
      {
        EXPECT_NEAR(shareOf(view, cell, view.eye), 1.0f, 1e-3f);
        for (const glm::dvec3& extreme : view.extremes)
        {
          // One extreme's cone is another one from each cell.
          EXPECT_NEAR(shareOf(view, cell, extreme), 0.0f, 1e-3f);
          const glm::dvec3 beyond = view.eye + 1.2 * (extreme - view.eye);
          EXPECT_NEAR(shareOf(view, cell, beyond), 0.0f, 1e-3f);
        }
      }
    }
  }
}

TEST(ViewFade, EvenlyAllCellsHaveTheSameShare)
{
  const TextureView even = fadingView(FadeMode::Even, 5);
  const TextureView curve = fadingView(FadeMode::Curve, 5);
  float difference = 0.0f;
  for (int i = 0; i < 30; ++i)
  {
    const glm::dvec3 camera = cameraAt(0.02 * i, 0.7 * i);
    const float share = shareOf(even, cellPlaces[0], camera);
    for (const glm::dvec3& cell : cellPlaces)
    {
      EXPECT_NEAR(shareOf(even, cell, camera), share, 1e-4f);
      difference = std::max(difference, std::abs(shareOf(curve, cell, camera) - share));
    }
  }
  EXPECT_GT(difference, 0.005f); // the paper's way they differ
}

TEST(ViewFade, MiddleComesFirst)
{
  const TextureView view = fadingView(FadeMode::Middle, 6);
  for (int i = 1; i <= 20; ++i)
  {
    const glm::dvec3 camera = cameraAt(0.03 * i, 0.9);
    float last = 2.0f;
    for (const float fromMiddle : { 0.0f, 0.3f, 0.7f, 1.0f })
    {
      const float share = shareOf(view, cellPlaces[1], camera, fromMiddle);
      EXPECT_LE(share, last);
      last = share;
    }
  }
  // With a straight curve the share is clamp(2 (1 - r) - m, 0, 1).
  const glm::dvec3 centre(0.0);
  const TextureView curve = fadingView(FadeMode::Curve, 6);
  for (const double angle : { 0.1, 0.2, 0.3, 0.4, 0.5 })
  {
    const float r = 1.0f - shareOf(curve, centre, cameraAt(angle, 1.3));
    const float expected = std::clamp(2.0f * (1.0f - r) - 0.4f, 0.0f, 1.0f);
    EXPECT_NEAR(shareOf(view, centre, cameraAt(angle, 1.3), 0.4f), expected, 1e-3f);
  }
}

TEST(ViewFade, ParallelViewsHaveDirectionsOnly)
{
  TextureView view = fadingView(FadeMode::Curve, 4);
  view.parallel = true;
  const std::vector<glm::vec3> directions = { glm::vec3(direction(0.3, 0.5)) };
  std::vector<float> first(1), other(1);
  for (const FadeMode mode : { FadeMode::Curve, FadeMode::Even })
  {
    view.fadeMode = mode;
    ViewFade(view).shares(cellPlaces[0], 0.0f, directions, first);
    ViewFade(view).shares(cellPlaces[1], 0.0f, directions, other);
    EXPECT_EQ(first, other);
    EXPECT_GT(first[0], 0.0f);
    EXPECT_LT(first[0], 1.0f);
  }
}

// A cell beyond the view's sphere, whose rays miss it.
TEST(ViewFade, EvenlyIsFiniteEverywhere)
{
  const TextureView view = fadingView(FadeMode::Even, 4);
  std::vector<glm::vec3> directions;
  directions.reserve(100);
  for (int i = 0; i < 100; ++i)
  {
    directions.emplace_back(direction(0.0314 * i, 0.7 * i));
  }
  std::vector<float> shares(directions.size());
  for (const glm::dvec3& cell : { glm::dvec3(9, 3, 0), glm::dvec3(0, 0, 5), glm::dvec3(0, 0, 7) })
  {
    ViewFade(view).shares(cell, 0.0f, directions, shares);
    for (const float share : shares)
    {
      EXPECT_TRUE(share >= 0.0f && share <= 1.0f);
    }
  }
}

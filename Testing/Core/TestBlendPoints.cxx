// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"

#include "Core/BlendPoints.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace hachure;

namespace
{
const glm::dvec3 centre(0.0);

// Looking at the centre from there.
BlendPoint pointAt(const glm::dvec3& position, double share)
{
  return { position, -3.0 * position, share };
}
} // namespace

TEST(BlendPoints, ClipValuesAreMeansOfTheSmallest)
{
  // Angles of 90 (first and second), 90 and 180 degrees; distances of sqrt 2 and 2.
  const std::vector<BlendPoint> points = { pointAt({ 1, 0, 0 }, 0.0), pointAt({ 0, 1, 0 }, 1.0),
    pointAt({ -1, 0, 0 }, 0.5) };
  const BlendFunction blend(points, centre);
  EXPECT_NEAR(blend.directionClip(), (-1.0 + 0.0 - 1.0) / 3.0, 1e-12);
  EXPECT_NEAR(blend.distanceClip(), std::sqrt(2.0), 1e-12);
}

TEST(BlendPoints, IsTheShareOfAPointWhereOthersHaveNoWeight)
{
  const std::vector<BlendPoint> points = { pointAt({ 4, 0, 0 }, 0.3), pointAt({ 0, 4, 0 }, 0.9) };
  const BlendFunction blend(points, centre);
  EXPECT_NEAR(blend.at(points[0].position, points[0].direction), 0.3, 1e-12);
  EXPECT_NEAR(blend.at(points[1].position, 0.1 * points[1].direction), 0.9, 1e-12);
  // By symmetry the mean of both.
  EXPECT_NEAR(blend.at({ 2, 2, 0 }, { -1, -1, 0 }), 0.6, 1e-12);
  EXPECT_EQ(blend.at({ 40, 0, 0 }, { -1, 0, 0 }), 0.0); // too far
  EXPECT_EQ(blend.at({ 4, 0, 0 }, { 1, 0, 0 }), 0.0);   // looking away
  EXPECT_EQ(blend.at({ 4, 0, 0 }, { 0, 0, 0 }), 0.0);
}

TEST(BlendPoints, FollowsTheFormula)
{
  const std::vector<BlendPoint> points = { pointAt({ 4, 0, 0 }, 0.3), pointAt({ 3, 2, 1 }, 0.9),
    pointAt({ 1, 4, 1 }, 0.1) };
  const BlendFunction blend(points, centre);
  const glm::dvec3 position(3.2, 1.5, 0.2);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(-1.0, -0.4, 0.1));
  double sum = 0.0, weights = 0.0;
  for (const BlendPoint& point : points)
  {
    const double c = blend.directionClip();
    const double s =
      std::max(0.0, (glm::dot(direction, glm::normalize(point.direction)) - c) / (1.0 - c)) *
      std::max(0.0, 1.0 - glm::distance(position, point.position) / blend.distanceClip());
    sum += point.share * s;
    weights += s;
  }
  EXPECT_GT(weights, 0.1);
  EXPECT_NEAR(blend.at(position, 7.0 * direction), sum / weights, 1e-12);
}

// Whatever the points: in [0, 1], and near one point that point's share counts.
TEST(BlendPoints, DegeneratePoints)
{
  EXPECT_EQ(BlendFunction({}, centre).at({ 1, 2, 3 }, { 0, 0, 1 }), 0.0);
  const BlendPoint one = pointAt({ 0, 0, 4 }, 0.8);
  const BlendPoint other = pointAt({ 0, 0, 2 }, 0.4); // the same direction
  BlendPoint there = one;                             // another one
  there.direction = { 1, 0, 0 };
  const BlendPoint inCentre{ centre, { 0, 0, -1 }, 0.8 };
  for (const std::vector<BlendPoint>& points : std::vector<std::vector<BlendPoint>>{
         { one }, { one, one }, { one, one, one }, { one, other }, { one, there }, { inCentre } })
  {
    const BlendFunction blend(points, centre);
    EXPECT_TRUE(std::isfinite(blend.directionClip()));
    EXPECT_LT(blend.directionClip(), 1.0);
    EXPECT_GT(blend.distanceClip(), 0.0);
    EXPECT_NEAR(blend.at(points[0].position, points[0].direction), 0.8, 0.21);
    for (int i = 0; i < 100; ++i)
    {
      const glm::dvec3 position(3.0 * std::sin(i), 3.0 * std::cos(1.7 * i), 0.1 * i - 4.0);
      const double share = blend.at(position, { std::sin(2.0 * i), std::cos(3.0 * i), -0.5 });
      EXPECT_TRUE(share >= 0.0 && share <= 1.0) << share;
    }
  }
  const BlendFunction single(std::vector<BlendPoint>{ one }, centre);
  EXPECT_EQ(single.directionClip(), 0.0);
  EXPECT_EQ(single.distanceClip(), 4.0);
  EXPECT_NEAR(single.at({ 0, 0, 3 }, { 0, 0, -1 }), 0.8, 1e-12);
}

TEST(BlendPoints, RefusesWrongPoints)
{
  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<BlendPoint> points(2);
  const auto message = [&] { return messageOf([&] { BlendFunction(points, centre); }); };
  EXPECT_EQ(message(), "no error");
  points[1].share = 1.25;
  EXPECT_EQ(message(), "points[1].share is 1.250000; expected 0 to 1");
  points[1].share = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message().find("points[1].share"), std::string::npos);
  points[1] = points[0];
  points[0].direction = glm::dvec3(0.0);
  EXPECT_EQ(message(), "points[0].direction is 0; expected a direction");
  points[0].direction = { infinite, 0, 0 };
  EXPECT_NE(message().find("points[0] has"), std::string::npos);
  points[0] = points[1];
  EXPECT_NE(messageOf([&] { BlendFunction(points, glm::dvec3(infinite)); }).find("centre"),
    std::string::npos);
}

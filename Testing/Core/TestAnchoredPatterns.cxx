// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/AnchoredPatterns.h"
#include "TrackerScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using namespace hachure;
using hachure::testing::Camera;
using hachure::testing::degree;
using hachure::testing::Spheres;

// Three spheres in a row along x: the principal axis is x.
Spheres row()
{
  return Spheres({ { -1.5, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.5, 0.0, 0.0 } }, 200, false);
}

TEST(AnchoredPatterns, FollowsPositionSizeAndAxis)
{
  const Spheres scene = row();
  Camera camera;
  const PatternFrame first = anchoredFrames(scene.samples(), camera.view())[0];
  EXPECT_LT(glm::length(first.origin - glm::dvec2(400.0, 300.0)), 0.5);
  EXPECT_NEAR(std::atan2(first.u.y, first.u.x) / degree, 0.0, 0.5);
  EXPECT_NEAR(glm::dot(first.u, first.v), 0.0, 1e-12);
  // 5 units across at a distance of 10 in an image of 600 pixels and 30 degrees.
  const double pixelsPerUnit = 300.0 / std::tan(15.0 * degree) / 10.0;
  EXPECT_NEAR(glm::length(first.u), 5.0 * pixelsPerUnit / 512.0, 0.01);

  camera.roll = 25.0;
  const PatternFrame rolled = anchoredFrames(scene.samples(), camera.view())[0];
  EXPECT_NEAR(
    std::atan2(rolled.u.y, rolled.u.x) - std::atan2(first.u.y, first.u.x), 25.0 * degree, 1e-9);
  camera.distance = 5.0;
  const PatternFrame near = anchoredFrames(scene.samples(), camera.view())[0];
  EXPECT_NEAR(glm::length(near.u) / glm::length(first.u), 2.0, 0.01);
}

TEST(AnchoredPatterns, FindsAxesInAnyDirection)
{
  for (const glm::dvec3 axis : { glm::dvec3(0.8, 0.6, 0.0), { 0.6, -0.8, 0.0 }, { 0.7, 0.3, 0.6 } })
  {
    const Spheres scene({ -1.5 * axis, glm::dvec3(0.0), 1.5 * axis }, 200, false);
    ViewProjection view = Camera().view();
    view.viewToClip = glm::ortho(-4.0, 4.0, -3.0, 3.0, 0.1, 100.0);
    const PatternFrame frame = anchoredFrames(scene.samples(), view)[0];
    // The axis has no sense of its own.
    EXPECT_NEAR(frame.u.y / frame.u.x, axis.y / axis.x, 0.02);
  }
}

TEST(AnchoredPatterns, IsContinuousInTheCamera)
{
  const Spheres scene = row();
  Camera camera;
  camera.roll = 10.0;
  PatternFrame before;
  for (int k = 0; k <= 800; ++k)
  {
    camera.azimuth = -70.0 + 0.15 * k;
    camera.pan = 0.005 * k; // out of the picture in the end
    const PatternFrame frame = anchoredFrames(scene.samples(), camera.view())[0];
    if (k > 0)
    {
      ASSERT_LT(glm::length(frame.origin - before.origin), 2.0) << k;
      ASSERT_LT(glm::length(frame.u - before.u), 0.05) << k;
    }
    before = frame;
  }
}

TEST(AnchoredPatterns, AxisAtTheCameraAndBehindIt)
{
  std::vector<glm::dvec3> line, normals;
  for (int i = -10; i <= 10; ++i)
  {
    line.emplace_back(0.0, 0.0, 0.1 * i); // towards the camera
    line.emplace_back(0.05 * i, 0.0, 0.0);
  }
  normals.assign(line.size(), { 0.0, 0.0, 1.0 });
  const std::vector<double> spacing{ 0.1 };
  const TrackedSamples samples{ line, normals, {}, spacing };
  const PatternFrame frame = anchoredFrames(samples, Camera().view())[0];
  EXPECT_NEAR(frame.u.x, 0.0, 1e-12); // the second axis, x, turned by -90 degrees
  EXPECT_LT(frame.u.y, 0.0);
  Camera behind;
  behind.distance = -10.0;
  EXPECT_EQ(anchoredFrames(samples, behind.view())[0], PatternFrame());
}

TEST(AnchoredPatterns, ReplayIsTheSameInAnyOrder)
{
  const Spheres scene({ { 0.0, 0.0, 0.0 } }, 300, false);
  const ScenePath path = [&](double time)
  {
    Camera camera;
    camera.azimuth = 30.0 * time;
    camera.roll = 10.0 * time;
    return TrackedScene{ scene.samples(), camera.view() };
  };
  const std::vector<double> keys{ 2.0, 0.0 };
  std::vector<PatternFrame> forward, backward;
  for (int k = 0; k <= 30; ++k)
  {
    forward.push_back(replayFrames(path, keys, 0.1 * k, 0.04)[0]);
    backward.push_back(replayFrames(path, keys, 0.1 * (30 - k), 0.04)[0]);
  }
  std::reverse(backward.begin(), backward.end());
  EXPECT_EQ(forward, backward);
  // Upright at both keys, turned with the camera in between.
  EXPECT_EQ(forward[0].u, glm::dvec2(1.0, 0.0));
  EXPECT_EQ(forward[20].u, glm::dvec2(1.0, 0.0));
  EXPECT_GT(std::atan2(forward[19].u.y, forward[19].u.x) / degree, 10.0);
}

TEST(AnchoredPatterns, WrongTimesAreRefused)
{
  const Spheres scene = row();
  const ScenePath path = [&](double) { return TrackedScene{ scene.samples(), Camera().view() }; };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> keys{ 0.0 }, badKeys{ nan };
  EXPECT_THROW(replayFrames(path, keys, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(replayFrames(path, keys, nan, 0.1), std::invalid_argument);
  EXPECT_THROW(replayFrames(path, badKeys, 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(replayFrames(path, keys, 1.0, 1e-12), std::invalid_argument);
  EXPECT_THROW(replayFrames(ScenePath(), keys, 1.0, 0.1), std::invalid_argument);
}

} // namespace

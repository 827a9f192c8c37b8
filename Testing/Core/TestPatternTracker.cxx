// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrackerScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace hachure;
using hachure::testing::Camera;
using hachure::testing::Spheres;

double scaleOf(const PatternFrame& frame)
{
  return glm::length(frame.u);
}

double turnOf(const PatternFrame& frame)
{
  return std::atan2(frame.u.y, frame.u.x) / hachure::testing::degree;
}

void drawFrame(PatternTracker& tracker, const Spheres& scene, const Camera& camera)
{
  tracker.advance(scene.samples(), camera.view());
  tracker.setVisibility(scene.visibility(camera.view()));
}

// Two spheres that hide each other in turn.
Spheres occludingSpheres()
{
  return Spheres({ { -0.9, 0.0, 0.9 }, { 0.9, 0.0, -0.9 } }, 400, false);
}

// Ten times 60 degrees there and back with a pan; the committed frame, and how far off any
// predicted frame was.
PatternFrame cycles(WeightScheme scheme, PatternFrame& anchor, double& prediction)
{
  const Spheres scene = occludingSpheres();
  PatternTracker tracker;
  TrackerOptions options;
  options.scheme = scheme;
  tracker.setOptions(options);
  constexpr int steps = 30;
  Camera camera;
  drawFrame(tracker, scene, camera);
  anchor = tracker.committed()[0];
  prediction = 0.0;
  for (int frame = 1; frame <= 10 * 2 * steps; ++frame)
  {
    const int phase = frame % (2 * steps);
    const double t = (phase <= steps ? phase : 2 * steps - phase) / double(steps);
    camera.azimuth = 60.0 * t;
    camera.pan = 0.8 * t;
    drawFrame(tracker, scene, camera);
    prediction =
      std::max(prediction, glm::length(tracker.drawn()[0].origin - tracker.committed()[0].origin));
  }
  return tracker.committed()[0];
}

TEST(PatternTracker, ThereAndBackIsExact)
{
  PatternFrame anchor;
  double prediction = 0.0;
  const PatternFrame end = cycles(WeightScheme::Symmetric, anchor, prediction);
  EXPECT_NEAR(scaleOf(end), 1.0, 1e-6);
  EXPECT_NEAR(turnOf(end), 0.0, 1e-6);
  EXPECT_LT(glm::length(end.origin - anchor.origin), 0.01);
  EXPECT_GT(prediction, 0.0); // the visibility did change
  EXPECT_LT(prediction, 2.0);
  RecordProperty("prediction", std::to_string(prediction));
}

// Frames that were drawn with another scheme count as if they had been drawn with the new one.
TEST(PatternTracker, SchemesChangeBetweenFrames)
{
  const Spheres scene = occludingSpheres();
  TrackerOptions unweighted;
  unweighted.scheme = WeightScheme::Unweighted;
  PatternTracker tracker, steady;
  steady.setOptions(unweighted);
  Camera camera;
  drawFrame(tracker, scene, camera);
  drawFrame(steady, scene, camera);
  tracker.setOptions(unweighted);
  for (const double azimuth : { 5.0, 10.0 })
  {
    camera.azimuth = azimuth;
    drawFrame(tracker, scene, camera);
    drawFrame(steady, scene, camera);
    EXPECT_EQ(tracker.drawn()[0], steady.drawn()[0]);
    EXPECT_EQ(tracker.committed()[0], steady.committed()[0]);
  }
}

TEST(PatternTracker, ClassicWeightsDrift)
{
  PatternFrame anchor;
  double prediction = 0.0;
  const PatternFrame end = cycles(WeightScheme::Classic, anchor, prediction);
  EXPECT_GT(std::abs(scaleOf(end) - 1.0) + glm::length(end.origin - anchor.origin), 1.0);
  RecordProperty("scale", std::to_string(scaleOf(end)));
}

// The pattern's mean slide over the visible surface, as a part of the surface's mean motion, over
// 20 frames from one camera to the other.
double slide(const Spheres& scene, const Camera& first, const Camera& last)
{
  PatternTracker tracker;
  constexpr int steps = 20;
  double slid = 0.0, moved = 0.0;
  ProjectedSamples before;
  PatternFrame frameBefore;
  for (int k = 0; k <= steps; ++k)
  {
    const double t = k / double(steps);
    Camera camera = first;
    camera.roll += t * (last.roll - first.roll);
    camera.pan += t * (last.pan - first.pan);
    camera.distance += t * (last.distance - first.distance);
    drawFrame(tracker, scene, camera);
    const ProjectedSamples after =
      projectSamples(scene.samples(), camera.view(), FacingRule::FrontOnly);
    const PatternFrame frame = tracker.drawn()[0];
    for (std::size_t i = 0; k > 0 && i < after.size(); ++i)
    {
      if (after[i].weight > 0.0)
      {
        const glm::dvec2 arm = before[i].position - frameBefore.origin;
        const glm::dvec2 u0 = frameBefore.u;
        const glm::dvec2 ratio = complexProduct(frame.u, { u0.x, -u0.y }) / glm::dot(u0, u0);
        const glm::dvec2 pattern = frame.origin + complexProduct(ratio, arm);
        slid += glm::length(pattern - after[i].position);
        moved += glm::length(before[i].position - after[i].position);
      }
    }
    before = after;
    frameBefore = frame;
  }
  return slid / moved;
}

TEST(PatternTracker, RollIsFollowedExactly)
{
  const Spheres scene({ { 0.0, 0.0, 0.0 } }, 500, false);
  PatternTracker tracker;
  Camera camera;
  camera.pan = 0.6;
  drawFrame(tracker, scene, camera);
  const PatternFrame start = tracker.drawn()[0];
  for (int k = 1; k <= 36; ++k)
  {
    camera.roll = 5.0 * k;
    drawFrame(tracker, scene, camera);
    const glm::dvec2 centre(400.0, 300.0);
    const double angle = camera.roll * hachure::testing::degree;
    const glm::dvec2 turned =
      centre + complexProduct({ std::cos(angle), std::sin(angle) }, start.origin - centre);
    ASSERT_LT(glm::length(tracker.drawn()[0].origin - turned), 0.01) << camera.roll;
    ASSERT_NEAR(scaleOf(tracker.drawn()[0]), 1.0, 1e-9);
  }
}

TEST(PatternTracker, PanAndZoomSlideLittle)
{
  const Spheres scene({ { 0.0, 0.0, 0.0 } }, 500, false);
  Camera first, panned, zoomed;
  first.pan = -1.0;
  panned.pan = 1.0;
  EXPECT_LT(slide(scene, first, panned), 0.08);
  zoomed.distance = 5.0;
  EXPECT_LT(slide(scene, Camera(), zoomed), 0.08);
}

TEST(PatternTracker, StillViewsKeepTheBits)
{
  const Spheres scene = occludingSpheres();
  PatternTracker tracker;
  Camera camera;
  drawFrame(tracker, scene, camera);
  camera.azimuth = 5.0;
  EXPECT_TRUE(tracker.advance(scene.samples(), camera.view()));
  const PatternFrame drawn = tracker.drawn()[0];
  tracker.setVisibility(scene.visibility(camera.view()));
  const PatternFrame committed = tracker.committed()[0];
  EXPECT_NE(drawn, committed);
  for (int repeat = 0; repeat < 3; ++repeat)
  {
    EXPECT_FALSE(tracker.advance(scene.samples(), camera.view()));
    tracker.setVisibility(scene.visibility(camera.view()));
    EXPECT_EQ(tracker.drawn()[0], drawn);
    EXPECT_EQ(tracker.committed()[0], committed);
  }
}

TEST(PatternTracker, PreviewsChangeNothing)
{
  const Spheres scene = occludingSpheres();
  PatternTracker tracker;
  Camera camera;
  EXPECT_EQ(scaleOf(tracker.preview(scene.samples(), camera.view())[0]), 1.0);
  drawFrame(tracker, scene, camera);
  camera.azimuth = 5.0;
  drawFrame(tracker, scene, camera);
  EXPECT_EQ(tracker.preview(scene.samples(), camera.view())[0], tracker.drawn()[0]);

  Camera next = camera, far = camera;
  next.azimuth = 8.0;
  far.azimuth = 30.0;
  const PatternFrame drawn = tracker.drawn()[0];
  Camera right = camera;
  right.azimuth += 1.0;
  const PatternFrame rightEye = tracker.previewFromDrawn(scene.samples(), right.view())[0];
  EXPECT_GT(glm::length(rightEye.origin - drawn.origin), 0.1);
  tracker.preview(scene.samples(), far.view());
  const PatternFrame expected = tracker.preview(scene.samples(), next.view())[0];
  EXPECT_EQ(tracker.drawn()[0], drawn);
  EXPECT_EQ(tracker.previewFromDrawn(scene.samples(), camera.view())[0], drawn);
  tracker.advance(scene.samples(), next.view());
  EXPECT_EQ(tracker.drawn()[0], expected);
}

// Visibility that arrives late, or for every third frame only, must not lose the surface.
TEST(PatternTracker, MissingVisibilityIsBridged)
{
  const Spheres scene = occludingSpheres();
  PatternTracker every, third, never;
  Camera camera;
  for (int frame = 0; frame <= 60; ++frame)
  {
    camera.azimuth = 1.0 * frame;
    drawFrame(every, scene, camera);
    third.advance(scene.samples(), camera.view());
    never.advance(scene.samples(), camera.view());
    if (frame % 3 == 0)
    {
      third.setVisibility(scene.visibility(camera.view()));
    }
    ASSERT_EQ(third.anchored()[0], frame == 0 ? 1 : 0);
  }
  EXPECT_LT(glm::length(third.committed()[0].origin - every.committed()[0].origin), 5.0);
  EXPECT_NEAR(scaleOf(third.committed()[0]), scaleOf(every.committed()[0]), 0.05);

  // Once measured and then never again.
  drawFrame(never, scene, camera);
  for (int frame = 1; frame <= 150; ++frame)
  {
    camera.azimuth = 60.0 + frame;
    never.advance(scene.samples(), camera.view());
    ASSERT_EQ(never.anchored()[0], 0) << frame;
  }
  EXPECT_NEAR(scaleOf(never.drawn()[0]), 1.0, 0.9);
}

TEST(PatternTracker, ResizeKeepsUpright)
{
  const Spheres scene({ { 0.3, 0.2, 0.0 } }, 500, false);
  PatternTracker tracker;
  Camera camera;
  drawFrame(tracker, scene, camera);
  camera.size = { 1500.0, 900.0 };
  drawFrame(tracker, scene, camera);
  EXPECT_NEAR(turnOf(tracker.drawn()[0]), 0.0, 1e-9);
  EXPECT_NEAR(scaleOf(tracker.drawn()[0]), 1.5, 1e-9);
  EXPECT_EQ(tracker.anchored()[0], 0);
}

TEST(PatternTracker, LocksHold)
{
  const Spheres scene({ { 0.3, 0.2, 0.0 } }, 500, false);
  PatternTracker tracker;
  TrackerOptions options;
  options.lockRotation = true;
  options.lockScale = true;
  tracker.setOptions(options);
  Camera camera;
  drawFrame(tracker, scene, camera);
  const glm::dvec2 origin = tracker.drawn()[0].origin;
  camera.roll = 10.0;
  camera.distance = 9.0;
  drawFrame(tracker, scene, camera);
  EXPECT_LT(glm::length(tracker.drawn()[0].u - glm::dvec2(1.0, 0.0)), 1e-12);
  EXPECT_GT(glm::length(tracker.drawn()[0].origin - origin), 1.0);
}

TEST(PatternTracker, CutsAnchorAnew)
{
  const Spheres scene = occludingSpheres();
  Camera camera;
  camera.azimuth = 40.0;
  PatternTracker fresh;
  fresh.advance(scene.samples(), camera.view());
  const PatternFrame anchor = fresh.drawn()[0];

  PatternTracker tracker;
  Camera other = camera;
  other.azimuth = 220.0; // nothing seen before is seen after
  drawFrame(tracker, scene, other);
  drawFrame(tracker, scene, camera);
  EXPECT_EQ(tracker.drawn()[0], anchor);
  EXPECT_EQ(tracker.committed()[0], anchor);
  EXPECT_EQ(tracker.anchored()[0], 1);

  other = camera;
  other.azimuth = 35.0;
  tracker.advance(scene.samples(), other.view());
  EXPECT_EQ(tracker.anchored()[0], 0);
  tracker.reanchor();
  tracker.advance(scene.samples(), camera.view());
  EXPECT_EQ(tracker.drawn()[0], anchor);

  const Spheres fewer({ { 0.0, 0.0, 0.0 } }, 100, false);
  EXPECT_TRUE(tracker.advance(fewer.samples(), camera.view()));
  EXPECT_EQ(tracker.anchored()[0], 1);
}

TEST(PatternTracker, HiddenPatchesWait)
{
  // Patch 1 is behind the camera at first, seen later, then hidden behind patch 0.
  Spheres scene({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 30.0 } }, 300, true);
  PatternTracker tracker;
  Camera camera;
  drawFrame(tracker, scene, camera);
  EXPECT_EQ(tracker.status()[1], FitStatus::NoSamples);
  const auto moveSecond = [&](glm::dvec3 by)
  {
    for (std::size_t i = 300; i < 600; ++i)
    {
      scene.positions[i] += by;
    }
    scene.centres[1] += by;
  };
  moveSecond({ 1.5, 0.0, -30.0 });
  drawFrame(tracker, scene, camera);
  EXPECT_EQ(tracker.anchored()[1], 1);
  EXPECT_EQ(tracker.drawn()[1], tracker.drawn()[0]) << "it begins with the pattern in sight";

  moveSecond({ -1.5, 0.0, -4.0 });
  drawFrame(tracker, scene, camera);
  const PatternFrame hidden = tracker.committed()[1];
  moveSecond({ 0.0, 0.1, 0.0 });
  drawFrame(tracker, scene, camera);
  EXPECT_EQ(tracker.committed()[1], hidden);
  EXPECT_EQ(tracker.drawn()[1], hidden);
  EXPECT_EQ(tracker.anchored()[1], 0);
}

// No border shows between patches before they have moved differently.
TEST(PatternTracker, PatchesBeginTogether)
{
  Spheres scene({ { -0.5, 0.0, 0.0 }, { 0.5, 0.0, 0.0 } }, 300, true);
  PatternTracker tracker;
  Camera camera;
  drawFrame(tracker, scene, camera);
  EXPECT_EQ(tracker.drawn()[0], tracker.drawn()[1]);
  camera.pan = 0.3;
  drawFrame(tracker, scene, camera);
  for (std::size_t i = 300; i < 600; ++i)
  {
    scene.positions[i] += glm::dvec3(0.0, 0.1, 0.0);
  }
  drawFrame(tracker, scene, camera);
  EXPECT_GT(glm::length(tracker.drawn()[0].origin - tracker.drawn()[1].origin), 1.0);
}

// A surface meshed anew has other samples; its pattern neither jumps nor stops to follow.
TEST(PatternTracker, OtherSamplesCarryThePatternOn)
{
  const Spheres first({ { 0.0, 0.0, 0.0 } }, 500, false);
  const Spheres second({ { 0.0, 0.0, 0.0 } }, 731, false);
  PatternTracker tracker;
  PatternTracker steady;
  Camera camera;
  camera.pan = 0.6;
  drawFrame(tracker, first, camera);
  drawFrame(steady, first, camera);
  for (int k = 1; k <= 12; ++k)
  {
    camera.roll = 5.0 * k;
    if (k == 6)
    {
      const PatternFrame before = tracker.drawn()[0];
      tracker.replaceSamples(second.samples());
      EXPECT_EQ(tracker.drawn()[0], before);
    }
    drawFrame(tracker, k < 6 ? first : second, camera);
    drawFrame(steady, first, camera);
    ASSERT_LT(glm::length(tracker.drawn()[0].origin - steady.drawn()[0].origin), 0.02);
    ASSERT_EQ(tracker.anchored()[0], 0);
  }
}

TEST(PatternTracker, WrongInputIsNamed)
{
  Spheres scene = occludingSpheres();
  PatternTracker tracker;
  const auto message = [&]() -> std::string
  {
    try
    {
      drawFrame(tracker, scene, Camera());
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_THROW(tracker.setVisibility({}), std::invalid_argument);
  scene.positions[7].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(), "projectSamples: positions[7] is not finite");
  scene.positions[7].y = 0.0;
  scene.patches[5] = -2;
  EXPECT_EQ(message(), "projectSamples: patches[5] is -2, expected 0 or more");
  scene.patches[5] = 1;
  EXPECT_EQ(
    message(), "projectSamples: patchSpacing has 1 elements, expected 2 or more, one per patch");
  scene.patches[5] = 0;
  scene.normals.pop_back();
  EXPECT_NE(message().find("normals has 799 elements"), std::string::npos);

  TrackerOptions options;
  options.minimumCommonWeight = 1.5;
  EXPECT_THROW(tracker.setOptions(options), std::invalid_argument);
}

} // namespace

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// How far patterns slide over the part of the surface that is turned to the eye.

#include "CallTests.h"
#include "TrackerScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace hachure;
using hachure::testing::Camera;
using hachure::testing::Spheres;

Spheres twoSpheres()
{
  return Spheres({ { -1.2, 0.0, 0.9 }, { 1.2, 0.0, -0.9 } }, 500, true);
}

// n.v of a sample of the spheres, from the places of the eye and of the sample alone.
double facingOf(const Spheres& scene, std::size_t sample, const ViewProjection& view)
{
  const glm::dvec3 eye(glm::inverse(view.modelToView)[3]);
  return glm::dot(glm::normalize(eye - scene.positions[sample]), scene.normals[sample]);
}

// The mean slide in the step from one view to the next, by the definition.
PatchResidual slideOf(const Spheres& scene, const ProjectedSamples& before,
  const ViewProjection& afterView, std::int32_t patch, double minimumFacing)
{
  const auto after = projectSamples(scene.samples(), afterView, FacingRule::FrontOnly);
  std::vector<glm::dvec2> p, c;
  std::vector<double> weights;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    p.push_back(before[i].position);
    c.push_back(after[i].position);
    const bool own = scene.patches[i] == patch;
    weights.push_back(own ? std::sqrt(before[i].weight * after[i].weight) : 0.0);
  }
  const Similarity step = fitSimilarity(p, c, weights).transform;
  PatchResidual result{ 0.0, 0.0 };
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    if (facingOf(scene, i, afterView) >= minimumFacing)
    {
      result.residual += weights[i] * residualLength(step, p[i], c[i]);
      result.weight += weights[i];
    }
  }
  result.residual /= result.weight;
  return result;
}

} // namespace

TEST(PatternResidual, FacingIsThatOfTheSurface)
{
  const Spheres scene = twoSpheres();
  Camera camera;
  camera.azimuth = 25.0;
  ViewProjection view = camera.view();
  const std::vector<double> facing = sampleFacing(scene.samples(), view);
  const auto projected = projectSamples(scene.samples(), view, FacingRule::Signed);
  for (std::size_t i = 0; i < facing.size(); ++i)
  {
    ASSERT_NEAR(facing[i], facingOf(scene, i, view), 1e-12);
    ASSERT_EQ(facing[i] > 0.0, projected[i].weight > 0.0);
  }
  // All lines of sight of a parallel view are along z of the view. A flattened model's normals
  // turn towards the direction in which it was flattened.
  view.viewToClip = glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.1, 100.0);
  view.modelToView = glm::scale(
    glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -10.0)), glm::dvec3(1.0, 1.0, 0.25));
  const std::vector<double> flat = sampleFacing(scene.samples(), view);
  for (std::size_t i = 0; i < flat.size(); ++i)
  {
    const glm::dvec3 n = scene.normals[i];
    ASSERT_NEAR(flat[i], glm::normalize(glm::dvec3(n.x, n.y, 4.0 * n.z)).z, 1e-12);
  }
}

TEST(PatternResidual, EqualsTheDefinition)
{
  const Spheres scene = twoSpheres();
  PatternTracker tracker;
  EXPECT_TRUE(tracker.residualOver(scene.samples(), 0.3).empty()) << "before the first frame";
  Camera camera;
  tracker.advance(scene.samples(), camera.view());
  const auto before = projectSamples(scene.samples(), camera.view(), FacingRule::FrontOnly);
  camera.azimuth = 2.0;
  camera.roll = 1.0;
  tracker.advance(scene.samples(), camera.view());
  const auto all = tracker.residualOver(scene.samples(), -1.0);
  const auto front = tracker.residualOver(scene.samples(), 0.3);
  const auto none = tracker.residualOver(scene.samples(), 1.0);
  ASSERT_EQ(front.size(), 2u);
  for (std::size_t patch = 0; patch < 2; ++patch)
  {
    EXPECT_NEAR(all[patch].residual, tracker.residual()[patch], 1e-12);
    const PatchResidual expected =
      slideOf(scene, before, camera.view(), static_cast<std::int32_t>(patch), 0.3);
    EXPECT_NEAR(front[patch].residual, expected.residual, 1e-9);
    EXPECT_NEAR(front[patch].weight, expected.weight, 1e-9 * expected.weight);
    EXPECT_LT(front[patch].residual, 0.9 * all[patch].residual);
    EXPECT_GT(front[patch].residual, 0.3 * all[patch].residual);
    EXPECT_EQ(none[patch].residual, 0.0);
    EXPECT_EQ(none[patch].weight, 0.0);
  }
}

// The visibility of the drawn frame arrives later, and belongs to the next step.
TEST(PatternResidual, IsThatOfTheDrawnStep)
{
  const Spheres scene = twoSpheres();
  PatternTracker tracker;
  Camera camera;
  for (int frame = 0; frame < 4; ++frame)
  {
    camera.azimuth = 15.0 * frame;
    tracker.advance(scene.samples(), camera.view());
    for (int measured = 0; measured < 2; ++measured)
    {
      const auto all = tracker.residualOver(scene.samples(), -1.0);
      EXPECT_NEAR(all[0].residual, tracker.residual()[0], 1e-12) << frame;
      EXPECT_NEAR(all[1].residual, tracker.residual()[1], 1e-12) << frame;
      tracker.setVisibility(scene.visibility(camera.view()));
    }
  }
  EXPECT_GT(tracker.residual()[0], 1.0);
}

TEST(PatternResidual, WrongInput)
{
  const Spheres scene = twoSpheres();
  const Spheres other({ { 0.0, 0.0, 0.0 } }, 30, false);
  PatternTracker tracker;
  tracker.advance(scene.samples(), Camera().view());
  const std::string samples = messageOf([&] { tracker.residualOver(other.samples(), 0.3); });
  EXPECT_NE(samples.find("samples has 30 elements"), std::string::npos) << samples;
  const std::string limit = messageOf([&] { tracker.residualOver(scene.samples(), 1.5); });
  EXPECT_NE(limit.find("minimumFacing is 1.5"), std::string::npos) << limit;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrackerScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace hachure;
using hachure::testing::Camera;
using hachure::testing::degree;

// One sample with the given spacing.
ProjectedSample projectOne(glm::dvec3 position, glm::dvec3 normal, const ViewProjection& view,
  FacingRule facing, double spacing = 0.01)
{
  const std::vector<glm::dvec3> positions{ position }, normals{ normal };
  const std::vector<double> spacings{ spacing };
  return projectSamples({ positions, normals, {}, spacings }, view, facing)[0];
}

// The image area of a tangent disc, as a polygon of its projected border.
double discArea(glm::dvec3 centre, glm::dvec3 normal, double diameter, const ViewProjection& view)
{
  const glm::dvec3 first = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.8)));
  const glm::dvec3 second = glm::cross(normal, first);
  std::vector<glm::dvec2> border;
  constexpr int corners = 720;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 0.5 * i * degree;
    const glm::dvec3 point =
      centre + 0.5 * diameter * (std::cos(angle) * first + std::sin(angle) * second);
    border.push_back(projectOne(point, normal, view, FacingRule::BothSides).position);
  }
  double area = 0.0;
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const glm::dvec2 a = border[i] - border[0];
    const glm::dvec2 b = border[(i + 1) % border.size()] - border[0];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return std::abs(area);
}

TEST(SampleProjection, WeightIsTheAreaOfTheTangentDisc)
{
  Camera camera;
  camera.azimuth = 20.0;
  ViewProjection perspective = camera.view();
  ViewProjection parallel = perspective;
  parallel.viewToClip = glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.1, 100.0);
  const glm::dvec3 position(1.2, -0.7, 0.5);
  for (const ViewProjection& view : { perspective, parallel })
  {
    for (const glm::dvec3 direction : { glm::dvec3(0, 0, 1), { 1, 0.2, 0.3 }, { -0.4, 1, 0.9 } })
    {
      const glm::dvec3 normal = glm::normalize(direction);
      const double weight = projectOne(position, normal, view, FacingRule::BothSides).weight;
      EXPECT_NEAR(weight / discArea(position, normal, 0.01, view), 1.0, 1e-4);
    }
  }
}

TEST(SampleProjection, FacingDecides)
{
  const glm::dvec3 origin(0.0), front(0.0, 0.0, 1.0);
  ViewProjection view = Camera().view();
  ViewProjection mirrored = view;
  mirrored.modelToView = glm::scale(view.modelToView, glm::dvec3(-1.0, 1.0, 1.0));
  for (const ViewProjection& each : { view, mirrored })
  {
    const double weight = projectOne(origin, front, each, FacingRule::FrontOnly).weight;
    EXPECT_GT(weight, 0.0);
    EXPECT_EQ(projectOne(origin, -front, each, FacingRule::FrontOnly).weight, 0.0);
    EXPECT_EQ(projectOne(origin, -front, each, FacingRule::BothSides).weight, weight);
    EXPECT_EQ(projectOne(origin, -front, each, FacingRule::Signed).weight, -weight);
  }
}

TEST(SampleProjection, PositionsCountPixelsFromTheLowerLeft)
{
  const ViewProjection view = Camera().view();
  const glm::dvec3 front(0.0, 0.0, 1.0);
  const double pixelsPerUnit = 300.0 / std::tan(15.0 * degree) / 10.0;
  const glm::dvec2 at = projectOne({ 1.0, -0.5, 0.0 }, front, view, FacingRule::Signed).position;
  EXPECT_NEAR(at.x, 400.0 + pixelsPerUnit, 1e-9);
  EXPECT_NEAR(at.y, 300.0 - 0.5 * pixelsPerUnit, 1e-9);
}

TEST(SampleProjection, SightEndsBehindTheCameraAndBesideThePicture)
{
  const ViewProjection view = Camera().view();
  const glm::dvec3 front(0.0, 0.0, 1.0);
  const double edge = 4.0 / 3.0 * 10.0 * std::tan(15.0 * degree);
  const auto weightAt = [&](glm::dvec3 position, const ViewProjection& in)
  { return projectOne(position, front, in, FacingRule::BothSides).weight; };
  EXPECT_GT(weightAt({ 1.19 * edge, 0.0, 0.0 }, view), 0.0);
  EXPECT_EQ(weightAt({ 1.21 * edge, 0.0, 0.0 }, view), 0.0);
  EXPECT_EQ(weightAt({ 0.0, 0.0, 11.0 }, view), 0.0);
  EXPECT_EQ(weightAt({ 0.0, 0.0, 10.0 }, view), 0.0); // in the eye
  const glm::dvec2 eye = projectOne({ 0.0, 0.0, 10.0 }, front, view, FacingRule::Signed).position;
  EXPECT_TRUE(std::isfinite(eye.x) && std::isfinite(eye.y));
  ViewProjection parallel = view;
  parallel.viewToClip = glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.1, 100.0);
  EXPECT_GT(weightAt({ 0.0, 0.0, 9.0 }, parallel), 0.0);
  EXPECT_EQ(weightAt({ 0.0, 0.0, 11.0 }, parallel), 0.0);
  // Next to the eye no sample exceeds the picture.
  EXPECT_EQ(weightAt({ 0.0, 0.0, 10.0 - 1e-12 }, view), 800.0 * 600.0);
}

} // namespace

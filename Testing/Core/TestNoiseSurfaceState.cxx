// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Kernels do not depend on threads, on memory, or on what was drawn before; their parameters; wrong
// input.

#include "CallTests.h"
#include "NoiseScene.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace hachure;
using namespace hachure::testing;

namespace
{

constexpr double pi = 3.14159265358979323846;

NoiseView viewAt(double distance)
{
  return perspectiveView({ 500, 400 }, { 0.0, 0.3, distance }, { 0, 0, 0 });
}

} // namespace

TEST(NoiseSurfaceState, HistoryMemoryAndThreadsDoNotMatter)
{
  const Surface sphere = makeNoiseSphere(70);
  NoiseSurface fresh(sphere.mesh());
  const std::vector<NoiseKernel> expected = fresh.kernels(viewAt(3.0), {});
  ASSERT_GT(expected.size(), 5000u);

  NoiseSurface used(sphere.mesh());
  NoiseSurface small(sphere.mesh());
  small.setMemoryBudget(30000);
  for (const double distance : { 40.0, 2.0, 1.4, 5.0, 9.0, 2.5 })
  {
    EXPECT_TRUE(
      sameKernels(used.kernels(viewAt(distance), {}), small.kernels(viewAt(distance), {})));
  }
  EXPECT_TRUE(sameKernels(used.kernels(viewAt(3.0), {}), expected));
  EXPECT_TRUE(sameKernels(small.kernels(viewAt(3.0), {}), expected));
  EXPECT_LT(small.memory() + 200000, used.memory());
  used.setMemoryBudget(0);
  EXPECT_NEAR(static_cast<double>(used.memory()), static_cast<double>(small.memory()), 31000.0);
  EXPECT_TRUE(sameKernels(used.kernels(viewAt(3.0), {}), expected));

  const int before = omp_get_max_threads();
  for (const int threads : { 1, 4 })
  {
    omp_set_num_threads(threads);
    NoiseSurface surface(sphere.mesh());
    EXPECT_TRUE(sameKernels(surface.kernels(viewAt(3.0), {}), expected)) << threads;
  }
  omp_set_num_threads(before);
}

TEST(NoiseSurfaceState, PositionsMoveAndComeBack)
{
  const Surface sphere = makeNoiseSphere(30);
  NoiseSurface surface(sphere.mesh());
  const std::vector<NoiseKernel> expected = surface.kernels(viewAt(4.0), {});
  Surface moved = sphere;
  for (glm::dvec3& point : moved.points)
  {
    point = glm::dvec3(50.0, 0.0, 0.0) + 2.0 * point;
  }
  surface.setPositions(moved.points);
  EXPECT_TRUE(surface.kernels(viewAt(4.0), {}).empty());
  const NoiseView follows = perspectiveView({ 500, 400 }, { 50.0, 0.6, 8.0 }, { 50.0, 0.0, 0.0 });
  const std::vector<NoiseKernel> same = surface.kernels(follows, {});
  EXPECT_NEAR(static_cast<double>(same.size()), static_cast<double>(expected.size()), 3.0);
  surface.setPositions(sphere.points);
  EXPECT_TRUE(sameKernels(surface.kernels(viewAt(4.0), {}), expected));
}

TEST(NoiseSurfaceState, DepthIsThatOfTheTriangle)
{
  Surface slope;
  slope.points = { { -3, -2, -1 }, { 3, -2, 0.5 }, { 0, 3, -2 } };
  slope.triangles = { { 0, 1, 2 } };
  NoiseSurface surface(slope.mesh());
  const std::vector<NoiseKernel> kernels = surface.kernels(viewAt(8.0), {});
  ASSERT_GT(kernels.size(), 100u);
  for (const NoiseKernel& kernel : kernels)
  {
    const glm::dvec2 way = glm::dvec2(kernel.center) - glm::dvec2(kernels[0].center);
    const double expected =
      static_cast<double>(kernels[0].depth) + glm::dot(way, glm::dvec2(kernels[0].depthSlope));
    EXPECT_NEAR(kernel.depth, expected, 1e-6);
    EXPECT_NEAR(kernel.depthSlope.x, kernels[0].depthSlope.x, 1e-9);
  }
  EXPECT_GT(glm::length(kernels[0].depthSlope), 1e-6f);
}

TEST(NoiseSurfaceState, ParametersAreAsAsked)
{
  Surface square;
  addGrid(square, { -250, -200, 0 }, { 500, 0, 0 }, { 0, 400, 0 }, 10);
  std::vector<std::int32_t> objects(square.triangles.size(), 7);
  NoiseSurface surface(square.mesh(), {}, objects);
  NoiseKernelOptions options;
  options.orientation = 1.0;
  options.spread = 0.25;
  double sum = 0.0;
  double squares = 0.0;
  double phases = 0.0;
  const auto kernels = surface.kernels(parallelView({ 500, 400 }), options);
  for (const NoiseKernel& kernel : kernels)
  {
    const double turn = (static_cast<double>(kernel.orientation) - 1.0) / 0.25;
    EXPECT_LE(std::abs(turn), 1.000001);
    sum += turn / static_cast<double>(kernels.size());
    squares += turn * turn / static_cast<double>(kernels.size());
    phases += std::cos(static_cast<double>(kernel.phase)) / static_cast<double>(kernels.size());
    EXPECT_NEAR(noiseRadius(kernel.bandwidth), 16.0, 1e-4);
    EXPECT_EQ(kernel.object, 7);
  }
  EXPECT_NEAR(sum, 0.0, 0.03);
  EXPECT_NEAR(squares, 1.0 / 3.0, 0.02);
  EXPECT_NEAR(phases, 0.0, 0.04);
  options.signs = true;
  double signs = 0.0;
  for (const NoiseKernel& kernel : surface.kernels(parallelView({ 500, 400 }), options))
  {
    EXPECT_TRUE(kernel.phase == 0.0f || kernel.phase == static_cast<float>(pi));
    signs += kernel.phase == 0.0f ? 1.0 : -1.0;
  }
  EXPECT_NEAR(signs / static_cast<double>(kernels.size()), 0.0, 0.04);
}

// A view that is rolled by some angle sees every direction turned by it, of faces seen from behind
// by its opposite; without turning directions stay.
TEST(NoiseSurfaceState, DirectionsTurnWithTheSurface)
{
  const Surface sphere = makeNoiseSphere(6);
  NoiseSurface surface(sphere.mesh());
  const double angle = 0.3;
  const auto at = [&](double roll, bool turning)
  {
    NoiseKernelOptions options;
    options.turning = turning;
    options.spread = 0.5 * pi;
    NoiseView view = parallelView({ 400, 400 }, 150.0);
    view.modelToClip = view.modelToClip * glm::rotate(glm::dmat4(1.0), roll, { 0.0, 0.0, 1.0 });
    return surface.kernels(view, options);
  };
  for (const bool turning : { true, false })
  {
    const auto before = at(0.0, turning);
    const auto after = at(angle, turning);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      ASSERT_EQ(before[i].id, after[i].id);
      const double turned = static_cast<double>(after[i].orientation - before[i].orientation);
      const double expected = turning ? angle : 0.0;
      EXPECT_NEAR(std::remainder(turned - expected, 2.0 * pi), 0.0, 1e-5);
    }
  }
}

TEST(NoiseSurfaceState, ControlChangesKernelsAndKeepsTheirOverlap)
{
  Surface square;
  addGrid(square, { -400, -200, 0 }, { 800, 0, 0 }, { 0, 400, 0 }, 10);
  NoiseSurface surface(square.mesh());
  NoiseKernelOptions options;
  options.radius = 8.0;
  options.control = [](const NoisePoint& point)
  {
    NoiseKernelOptions::Control control;
    const bool isLow = point.triangle < 100; // the left half
    control.bandwidth = isLow ? 0.5 : 1.5;
    control.frequency = isLow ? 2.0 : 1.0;
    control.direction = isLow ? glm::dvec3(1.0, 1.0, 3.0) : glm::dvec3(0.0);
    return control;
  };
  const auto kernels = surface.kernels(parallelView({ 800, 400 }), options);
  EXPECT_NEAR(meanOverlap(kernels, { 0, 0 }, { 360, 400 }), 32.0, 1.6);
  EXPECT_NEAR(meanOverlap(kernels, { 440, 0 }, { 800, 400 }), 32.0, 1.6);
  for (const NoiseKernel& kernel : kernels)
  {
    const bool isLow = kernel.triangle < 100;
    EXPECT_NEAR(noiseRadius(kernel.bandwidth), isLow ? 16.0 : 8.0 / 1.5, 1e-4);
    EXPECT_EQ(kernel.frequency, isLow ? 0.25f : 0.125f);
    EXPECT_NEAR(kernel.orientation, isLow ? 0.75 * pi : 0.0, 1e-6);
  }
  // Beyond the range they are clamped.
  options.control = [](const NoisePoint&) { return NoiseKernelOptions::Control{ 1.0, 9.0, {} }; };
  for (const NoiseKernel& kernel : surface.kernels(parallelView({ 80, 40 }), options))
  {
    EXPECT_NEAR(noiseRadius(kernel.bandwidth), 4.0, 1e-4);
  }
}

TEST(NoiseSurfaceState, FadeIsRenormalised)
{
  for (const double fade : { 0.01, 0.5, 1.0, 3.0, 12.0 })
  {
    double sum = 0.0;
    const int steps = 200000;
    for (int i = 0; i < steps; ++i)
    {
      const double weight = noiseFadeWeight(5.0, 5.0 * (i + 0.5) / steps, fade);
      sum += weight * weight / steps;
    }
    EXPECT_NEAR(noiseFadeShare(fade), sum, 1e-5) << fade;
  }
  EXPECT_EQ(noiseFadeWeight(3.0, 3.0, 1.0), 0.0);
  EXPECT_EQ(noiseFadeWeight(3.0, 4.0, 1.0), 0.0);
  EXPECT_EQ(noiseFadeWeight(8.0, 2.0, 2.0), 1.0);
  EXPECT_NEAR(noiseFadeWeight(4.0, 2.0, 2.0), 0.5, 1e-12);
}

TEST(NoiseSurfaceState, RadiusAndBandwidthBelongTogether)
{
  const float bandwidth = noiseBandwidth(16.0f);
  EXPECT_NEAR(std::exp(-pi * std::pow(16.0 * static_cast<double>(bandwidth), 2.0)), 0.05, 1e-6);
  EXPECT_NEAR(noiseRadius(bandwidth), 16.0, 1e-5);
}

TEST(NoiseSurfaceState, WrongInputIsRefused)
{
  Surface square;
  addGrid(square, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2);
  const std::vector<std::uint64_t> ids(3);
  const std::vector<std::int32_t> objects(9);
  const auto none = Span<const std::uint64_t>();
  EXPECT_EQ(messageOf([&] { NoiseSurface(square.mesh(), ids); }), "ids: 3 values for 8 triangles");
  EXPECT_EQ(messageOf([&] { NoiseSurface(square.mesh(), none, objects); }),
    "objects: 9 values for 8 triangles");
  Surface broken = square;
  broken.triangles[5].y = 9;
  EXPECT_EQ(messageOf([&] { NoiseSurface(broken.mesh()); }),
    "mesh.triangles[5]: corner 9 is not one of the 9 points");
  broken = square;
  broken.points[4].z = std::nan("");
  EXPECT_EQ(
    messageOf([&] { NoiseSurface(broken.mesh()); }), "mesh.points[4]: a coordinate is not finite");

  NoiseSurface surface(square.mesh());
  EXPECT_EQ(messageOf([&] { surface.setPositions(broken.points); }),
    "positions[4]: a coordinate is not finite");
  broken.points.pop_back();
  EXPECT_EQ(
    messageOf([&] { surface.setPositions(broken.points); }), "positions: 8 points, expected 9");
  EXPECT_NE(messageOf([&] { surface.points(-1.0); }), "no error");
  EXPECT_NE(messageOf([&] { surface.points(1e12); }), "no error");
  EXPECT_FALSE(surface.points(100.0).empty()) << "still where it was";

  const auto withOptions = [&](auto&& change)
  {
    NoiseKernelOptions options;
    change(options);
    return messageOf([&] { surface.kernels({}, options); });
  };
  EXPECT_EQ(withOptions([](NoiseKernelOptions& o) { o.radius = 0.0; }),
    "options.radius is 0.000000, expected more than 0");
  EXPECT_NE(withOptions([](NoiseKernelOptions& o) { o.overlap = 0.5; }), "no error");
  EXPECT_NE(withOptions([](NoiseKernelOptions& o) { o.spread = 2.0; }), "no error");
  EXPECT_NE(withOptions([](NoiseKernelOptions& o) { o.fade = std::nan(""); }), "no error");
  EXPECT_NE(withOptions([](NoiseKernelOptions& o) { o.bandwidthRange.x = 2.0; }), "no error");
  EXPECT_EQ(withOptions([](NoiseKernelOptions&) {}), "no error");
  NoiseView view;
  view.viewportSize.x = 0.0;
  EXPECT_NE(messageOf([&] { surface.kernels(view, {}); }), "no error");
  view.viewportSize.x = 1.0;
  view.modelToClip[2][1] = std::numeric_limits<double>::infinity();
  EXPECT_NE(messageOf([&] { surface.kernels(view, {}); }), "no error");
}

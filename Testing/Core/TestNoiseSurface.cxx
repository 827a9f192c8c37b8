// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Kernels on a surface: as many overlap as are wanted, whatever the triangles and the view.

#include "NoiseScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using namespace hachure;
using namespace hachure::testing;

namespace
{

constexpr double pi = 3.14159265358979323846;

NoiseKernelOptions smallKernels()
{
  NoiseKernelOptions options;
  options.radius = 8.0;
  return options;
}

// A floor of one triangle, 2 below the eye, that reaches far behind it.
Surface makeFloor()
{
  Surface floor;
  floor.points = { { -3000, -2, 1000 }, { 3000, -2, 1000 }, { 0, -2, -4000 } };
  floor.triangles = { { 0, 1, 2 } };
  return floor;
}

// Tiny triangles, and as many leaves' worth of large ones between them.
Surface makeUnequal()
{
  Surface surface;
  for (int i = 0; i < 60 * 32; ++i)
  {
    const double size = i % 32 == 0 ? 60.0 : 0.2;
    const int row = i / 100;
    const glm::dvec3 corner(0.01 * (i - 100 * row), 0.01 * row, 0.0);
    surface.points.push_back(corner);
    surface.points.push_back(corner + glm::dvec3(size, 0.0, 0.1 * size));
    surface.points.push_back(corner + glm::dvec3(0.0, size, 0.0));
    surface.triangles.push_back(glm::ivec3(0, 1, 2) + 3 * i);
  }
  return surface;
}

glm::dvec2 imageOf(const NoiseView& view, const glm::dvec3& point)
{
  const glm::dvec4 clip = view.modelToClip * glm::dvec4(point, 1.0);
  return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * view.viewportSize;
}

// Compares with the weights of all points, one by one, their densities by differences.
void expectAllKernels(const Surface& surface, const Surface& reference, const NoiseView& view,
  const NoiseKernelOptions& options, double highest)
{
  NoiseSurface noise(reference.mesh());
  noise.setPositions(surface.points);
  std::map<std::uint64_t, float> drawn;
  for (const NoiseKernel& kernel : noise.kernels(view, options))
  {
    drawn[kernel.id] = kernel.weight;
  }
  const double lambda =
    options.overlap / (pi * options.radius * options.radius * noiseFadeShare(options.fade));
  std::size_t expected = 0;
  for (const NoisePoint& point : noise.points(highest))
  {
    const glm::ivec3 corners = surface.triangles[point.triangle];
    const glm::dvec3 a = surface.points[corners.x];
    const glm::dvec3 u = surface.points[corners.y] - a;
    const glm::dvec3 v = surface.points[corners.z] - a;
    const glm::dvec3 place = a + point.weights.x * u + point.weights.y * v;
    const glm::dvec2 center = imageOf(view, place);
    const double step = 1e-6;
    const glm::dvec2 du = (imageOf(view, place + step * u) - center) / step;
    const glm::dvec2 dv = (imageOf(view, place + step * v) - center) / step;
    const double area = 0.5 * glm::length(triangleAreaVector(reference.mesh(), point.triangle));
    const double density = lambda * std::abs(du.x * dv.y - du.y * dv.x) / (2.0 * area);
    const bool isInside = glm::clamp(center, glm::dvec2(0.0), view.viewportSize) == center;
    ASSERT_TRUE(!isInside || density < highest) << density;
    const double weight = noiseFadeWeight(density, point.birth, options.fade);
    if (isInside && weight > 1e-3)
    {
      ASSERT_EQ(drawn.count(point.id), 1u) << "birth " << point.birth << " of " << density;
      EXPECT_NEAR(drawn[point.id], weight, 1e-3);
      ++expected;
    }
  }
  EXPECT_GT(expected, 500u);
  EXPECT_LT(drawn.size(), 2 * expected) << "nothing else";
}

} // namespace

TEST(NoiseSurface, NoPointIsMissed)
{
  const Surface unequal = makeUnequal();
  NoiseKernelOptions options = smallKernels();
  options.overlap = 16.0;
  expectAllKernels(unequal, unequal, parallelView({ 200, 200 }, 3.0, { -30, -30 }), options, 2.0);
  options.overlap = 4.0;
  // From very near, so that densities differ by a lot within a node.
  Surface floor;
  addGrid(floor, { -10, -2, -30 }, { 20, 0, 0 }, { 0, 0, 32 }, 40);
  const NoiseView view = perspectiveView({ 300, 200 }, { 0, 0, 0 }, { 0, -0.8, -1 }, 80.0);
  expectAllKernels(floor, floor, view, options, 500.0);
  Surface single;
  addGrid(single, { -10, -2, -30 }, { 20, 0, 0 }, { 0, 0, 32 }, 1);
  expectAllKernels(single, single, view, options, 500.0);
  // A part of the surface has grown.
  Surface grown = floor;
  for (glm::dvec3& point : grown.points)
  {
    point.x *= point.x > 0.0 ? 4.0 : 0.25;
  }
  expectAllKernels(grown, floor, view, options, 1200.0);
}

TEST(NoiseSurface, OverlapDoesNotDependOnTheTriangles)
{
  const NoiseView view = perspectiveView({ 900, 700 }, { 0.3, 0.4, 4.0 }, { 0, 0, 0 });
  for (const int n : { 5, 20, 80, 300 }) // 300 to 1 million triangles, of 1600 to 1/2 pixels
  {
    const Surface sphere = makeNoiseSphere(n);
    NoiseSurface surface(sphere.mesh());
    const auto kernels = frontKernels(sphere, view, surface.kernels(view, smallKernels()));
    EXPECT_NEAR(meanOverlap(kernels, { 300, 200 }, { 600, 500 }), 32.0, 0.03 * 32.0) << n;
    // Next to the silhouette the triangles are seen at a slant.
    const double middle = meanOverlap(kernels, { 430, 330 }, { 470, 370 });
    const double rim = meanOverlap(kernels, { 160, 300 }, { 200, 400 });
    EXPECT_NEAR(middle, 32.0, 0.2 * 32.0) << n;
    EXPECT_NEAR(rim, 32.0, 0.2 * 32.0) << n;
  }
}

TEST(NoiseSurface, OverlapOnAFloorIsTheSameNearAndFar)
{
  const Surface floor = makeFloor();
  NoiseSurface surface(floor.mesh());
  const NoiseView view = perspectiveView({ 1000, 600 }, { 0, 0, 0 }, { 0, -0.3, -1 }, 60.0);
  const auto kernels = surface.kernels(view, smallKernels());
  // The horizon is 300 + .3 * 300 / tan 30 pixels up.
  const double whole = 32.0;
  EXPECT_NEAR(meanOverlap(kernels, { 0, 0 }, { 1000, 60 }), whole, 0.05 * whole);
  EXPECT_NEAR(meanOverlap(kernels, { 0, 200 }, { 1000, 260 }), whole, 0.05 * whole);
  EXPECT_NEAR(meanOverlap(kernels, { 0, 370 }, { 1000, 430 }), whole, 0.05 * whole);
  EXPECT_LT(meanOverlap(kernels, { 0, 480 }, { 1000, 600 }), 1e-9);
  EXPECT_LT(kernels.size(), 220000u) << "only what is seen";
}

TEST(NoiseSurface, NearPlaneThroughATriangle)
{
  const Surface floor = makeFloor();
  NoiseSurface surface(floor.mesh());
  // Straight down: the near plane, at .1, is far from the floor; then the floor is within it.
  for (const double height : { -1.0, -1.89, -1.95 })
  {
    const NoiseView view =
      perspectiveView({ 300, 300 }, { 0, height, 0 }, { 0, height - 0.5, -1.0 }, 60.0);
    for (const NoiseKernel& kernel : surface.kernels(view, smallKernels()))
    {
      EXPECT_TRUE(std::isfinite(kernel.center.x + kernel.center.y));
      EXPECT_GE(kernel.depth, 0.0f);
      EXPECT_LE(kernel.depth, 1.0f);
      EXPECT_GT(kernel.weight, 0.0f);
    }
  }
  // The floor through the eye is seen as a line.
  NoiseView edge = perspectiveView({ 300, 300 }, { 0, -2, 0 }, { 0, -2, -1 }, 60.0);
  EXPECT_LT(surface.kernels(edge, smallKernels()).size(), 300u);
}

TEST(NoiseSurface, ZoomKeepsTheOverlapWithoutPops)
{
  Surface square;
  addGrid(square, { -100, -100, 0 }, { 200, 0, 0 }, { 0, 200, 0 }, 40, 2.0);
  NoiseSurface surface(square.mesh());
  NoiseKernelOptions options = smallKernels();
  options.overlap = 16.0;
  const double step = 1.01;
  // From 0 to 1 over one octave of density; twice as many octaves as of the zoom.
  const double largest = 2.0 * std::log2(step) / options.fade;
  std::map<std::uint64_t, float> before;
  double highest = 0.0;
  for (double zoom = 2.0; zoom < 16.0; zoom *= step)
  {
    const std::vector<NoiseKernel> kernels =
      surface.kernels(parallelView({ 300, 200 }, zoom), options);
    EXPECT_NEAR(meanOverlap(kernels, { 0, 0 }, { 300, 200 }), 16.0, 0.12 * 16.0) << zoom;
    std::map<std::uint64_t, float> now;
    for (const NoiseKernel& kernel : kernels)
    {
      now[kernel.id] = kernel.weight;
      if (!before.empty())
      {
        const auto last = before.find(kernel.id);
        const float weight = last == before.end() ? 0.0f : last->second;
        highest = std::max(highest, static_cast<double>(std::abs(kernel.weight - weight)));
      }
    }
    before = std::move(now);
  }
  EXPECT_LE(highest, 1.001 * largest);
  EXPECT_GT(highest, 0.9 * largest);
}

TEST(NoiseSurface, StretchedSurfaceHasTheSameOverlap)
{
  Surface square;
  addGrid(square, { -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 60);
  NoiseSurface surface(square.mesh());
  Surface stretched = square;
  for (glm::dvec3& point : stretched.points)
  {
    point = glm::dvec3(600.0 * point.x, 150.0 * point.y, 20.0 * std::sin(9.0 * point.x));
  }
  surface.setPositions(stretched.points);
  const auto kernels = surface.kernels(parallelView({ 1000, 300 }), smallKernels());
  EXPECT_NEAR(meanOverlap(kernels, { 0, 0 }, { 1000, 300 }), 32.0, 0.03 * 32.0);
}

TEST(NoiseSurface, KernelsAreThePointsOfTheDensity)
{
  // Large and tiny triangles side by side, and some in front of others.
  Surface mixed;
  addGrid(mixed, { -150, -100, 0 }, { 300, 0, 0 }, { 0, 200, 0 }, 1);
  addGrid(mixed, { -20, -20, 1 }, { 40, 0, 0 }, { 0, 40, 0 }, 90);
  addGrid(mixed, { -90, -20, 2 }, { 60, 0, 0 }, { 0, 60, 0 }, 9, 3.0);
  NoiseSurface surface(mixed.mesh());
  NoiseKernelOptions options = smallKernels();
  for (const double overlap : { 2.0, 32.0, 800.0 })
  {
    options.overlap = overlap;
    const double density =
      overlap / (pi * 64.0 * noiseFadeShare(options.fade)); // one pixel per unit
    const std::vector<NoisePoint> points = surface.points(density);
    const std::vector<NoiseKernel> kernels = surface.kernels(parallelView({ 400, 300 }), options);
    EXPECT_GT(static_cast<double>(kernels.size()), 200.0 * overlap);
    // Weights of the last points are 0 up to rounding; a few may be on the other side.
    std::vector<std::uint64_t> different;
    const auto ids = sortedIds(points);
    const auto drawn = sortedIds(kernels);
    std::set_symmetric_difference(
      ids.begin(), ids.end(), drawn.begin(), drawn.end(), std::back_inserter(different));
    EXPECT_LE(different.size(), 1u) << overlap;
  }
}

TEST(NoiseSurface, PanningLeavesTheRestAlone)
{
  const Surface sphere = makeNoiseSphere(60);
  NoiseSurface surface(sphere.mesh());
  const NoiseView middle = parallelView({ 400, 400 }, 150.0);
  const NoiseView aside = parallelView({ 400, 400 }, 150.0, { 200.0, 0.0 });
  std::map<std::uint64_t, NoiseKernel> before;
  for (const NoiseKernel& kernel : surface.kernels(middle, smallKernels()))
  {
    before[kernel.id] = kernel;
  }
  std::size_t inside = 0;
  for (const NoiseKernel& kernel : surface.kernels(aside, smallKernels()))
  {
    ASSERT_EQ(before.count(kernel.id), 1u);
    const NoiseKernel& same = before[kernel.id];
    EXPECT_NEAR(kernel.weight, same.weight, 1e-5);
    EXPECT_NEAR(kernel.center.x, same.center.x + 200.0f, 1e-3);
    EXPECT_EQ(kernel.phase, same.phase);
    before.erase(kernel.id);
    ++inside;
  }
  EXPECT_GT(inside, 5000u);
  for (const auto& [id, kernel] : before)
  {
    EXPECT_GT(kernel.center.x, 200.0f + 7.99f) << "a kernel that meets the viewport was left out";
  }
}

// Single precision must be enough wherever the surface lies and whatever its unit is.
TEST(NoiseSurface, FarFromTheOriginAndOfAnySize)
{
  const Surface sphere = makeNoiseSphere(20);
  std::vector<std::uint64_t> ids(sphere.triangles.size());
  std::iota(ids.begin(), ids.end(), 1u);
  const glm::dvec3 eye(0.0, 0.4, 5.0);
  NoiseSurface near(sphere.mesh(), ids);
  std::map<std::uint64_t, NoiseKernel> expected;
  for (const NoiseKernel& kernel :
    near.kernels(perspectiveView({ 500, 400 }, eye, { 0, 0, 0 }), smallKernels()))
  {
    expected[kernel.id] = kernel;
  }
  Surface moved = sphere;
  const glm::dvec3 far(3e6, -7e6, 1e5);
  for (glm::dvec3& point : moved.points)
  {
    point += far;
  }
  NoiseSurface distant(sphere.mesh(), ids);
  distant.setPositions(moved.points);
  std::size_t same = 0;
  for (const NoiseKernel& kernel :
    distant.kernels(perspectiveView({ 500, 400 }, eye + far, far), smallKernels()))
  {
    const auto found = expected.find(kernel.id);
    same += found != expected.end() ? 1 : 0;
    EXPECT_TRUE(
      found == expected.end() || glm::distance(found->second.center, kernel.center) < 0.01f);
  }
  EXPECT_NEAR(static_cast<double>(same), static_cast<double>(expected.size()), 5.0);

  for (const double size : { 1e-9, 1e9, 1e24 })
  {
    Surface scaled = sphere;
    for (glm::dvec3& point : scaled.points)
    {
      point *= size;
    }
    NoiseView view;
    view.viewportSize = { 500, 400 };
    view.modelToClip = perspectiveView({ 500, 400 }, eye, { 0, 0, 0 }).modelToClip *
      glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / size));
    NoiseSurface surface(scaled.mesh());
    const auto kernels = frontKernels(scaled, view, surface.kernels(view, smallKernels()));
    EXPECT_NEAR(meanOverlap(kernels, { 200, 150 }, { 300, 250 }), 32.0, 3.2) << size;
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The kernels of the paper, with its faults.

#include "NoiseScene.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

using namespace hachure;
using namespace hachure::testing;

namespace
{

std::vector<NoiseKernel> classic(
  const Surface& surface, const NoiseView& view, const NoiseKernelOptions& options = {})
{
  return classicNoiseKernels(surface.mesh(), {}, {}, 1, view, options);
}

Surface makeTriangle(double size)
{
  Surface triangle;
  triangle.points = { { -size, -size, 0 }, { size, -size, 0 }, { -size, size, 0 } };
  triangle.triangles = { { 0, 1, 2 } };
  return triangle;
}

} // namespace

// Deviation of the field is the root of the overlap; with weight N, where N < 1, half as much for
// four times as many triangles.
TEST(NoiseClassic, FineTrianglesLoseTheField)
{
  const NoiseView view = perspectiveView({ 450, 350 }, { 0.3, 0.4, 4.0 }, { 0, 0, 0 });
  std::vector<double> deviations;
  for (const int n : { 7, 40, 80, 160 })
  {
    const Surface sphere = makeNoiseSphere(n);
    const auto kernels = frontKernels(sphere, view, classic(sphere, view));
    deviations.push_back(std::sqrt(meanOverlap(kernels, { 130, 90 }, { 320, 260 }) / 32.0));
  }
  EXPECT_NEAR(deviations[0], 1.0, 0.08);
  EXPECT_LT(deviations[2], 0.7);
  EXPECT_NEAR(deviations[3] / deviations[2], 0.5, 0.05);
}

TEST(NoiseClassic, CountsAreThoseOfThePaper)
{
  // 800 square pixels; the kernels are 32 in pi 16^2 pixels.
  const Surface triangle = makeTriangle(20.0);
  const double unit = 800.0 * 32.0 / (3.14159265358979323846 * 256.0); // 31.83
  for (const double zoom : { 0.1, 0.4, 1.0, 1.4 })
  {
    const double expected = unit * zoom * zoom;
    const auto kernels = classic(triangle, parallelView({ 400, 400 }, zoom));
    if (expected < 1.0)
    {
      ASSERT_EQ(kernels.size(), 1u);
      EXPECT_NEAR(kernels[0].weight, expected, 1e-6);
      continue;
    }
    const double half = std::exp2(std::floor(std::log2(expected)));
    ASSERT_EQ(kernels.size(), static_cast<std::size_t>(2.0 * half));
    EXPECT_EQ(kernels[static_cast<std::size_t>(half) - 1].weight, 1.0f);
    EXPECT_NEAR(kernels.back().weight, std::sqrt(expected / half - 1.0), 1e-6);
  }
}

TEST(NoiseClassic, PointsStayWhileTheirNumberDoubles)
{
  const Surface triangle = makeTriangle(20.0);
  std::map<std::uint64_t, NoiseKernel> few;
  for (const NoiseKernel& kernel : classic(triangle, parallelView({ 400, 400 }, 1.0)))
  {
    few[kernel.id] = kernel;
  }
  std::size_t found = 0;
  for (const NoiseKernel& kernel : classic(triangle, parallelView({ 400, 400 }, 3.0)))
  {
    const auto same = few.find(kernel.id);
    if (same != few.end())
    {
      ++found;
      EXPECT_NEAR(kernel.center.x - 200.0, 3.0 * (same->second.center.x - 200.0), 1e-3);
    }
  }
  EXPECT_EQ(found, few.size());
}

// The area is clipped at the near plane only: leaving the viewport does not change the density.
TEST(NoiseClassic, AreaIsClippedAtTheNearPlaneOnly)
{
  Surface square;
  addGrid(square, { -400, -400, 0 }, { 800, 0, 0 }, { 0, 800, 0 }, 1);
  const auto kernels = classic(square, parallelView({ 200, 200 }, 1.0, { 250.0, 0.0 }));
  EXPECT_NEAR(meanOverlap(kernels, { 0, 0 }, { 200, 200 }), 32.0, 3.5);

  Surface floor;
  floor.points = { { -30, -2, 10 }, { 30, -2, 10 }, { 0, -2, -40 } };
  floor.triangles = { { 0, 1, 2 } };
  const NoiseView view = perspectiveView({ 1000, 600 }, { 0, 0, 0 }, { 0, -0.3, -1 }, 60.0);
  const auto some = classic(floor, view);
  EXPECT_GT(some.size(), 100u);
  for (const NoiseKernel& kernel : some)
  {
    EXPECT_GE(kernel.depth, 0.0f);
    EXPECT_TRUE(std::isfinite(kernel.center.x + kernel.center.y));
  }
}

TEST(NoiseClassic, ThreadsDoNotMatterAndWrongInputIsRefused)
{
  const Surface sphere = makeNoiseSphere(40);
  const NoiseView view = perspectiveView({ 300, 200 }, { 0.3, 0.4, 4.0 }, { 0, 0, 0 });
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = classic(sphere, view);
  omp_set_num_threads(4);
  const auto four = classic(sphere, view);
  omp_set_num_threads(before);
  EXPECT_GT(one.size(), 5000u);
  EXPECT_TRUE(sameKernels(one, four));
  const std::vector<std::uint64_t> ids(3);
  EXPECT_THROW(classicNoiseKernels(sphere.mesh(), ids, {}, 1, view, {}), std::invalid_argument);
  EXPECT_TRUE(classic(Surface(), view).empty());
}

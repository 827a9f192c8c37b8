// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestSurfaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace hachure;

namespace
{
/// Six faces, turned so that none lies in the planes of a voxel grid.
Surface makeCube(int n, double exponent = 1.0)
{
  const glm::dvec3 x(2. / 3, -1. / 3, 2. / 3);
  const glm::dvec3 y(2. / 3, 2. / 3, -1. / 3);
  const glm::dvec3 z = glm::cross(x, y);
  Surface cube;
  addGrid(cube, { 0, 0, 0 }, y, x, n, exponent);
  addGrid(cube, z, x, y, n, exponent);
  addGrid(cube, { 0, 0, 0 }, z, y, n, exponent);
  addGrid(cube, x, y, z, n, exponent);
  addGrid(cube, { 0, 0, 0 }, x, z, n, exponent);
  addGrid(cube, y, z, x, n, exponent);
  return cube;
}

/// Mean squared deviation of the counts in 4 x 4 equal squares per face, relative to that of
/// samples placed at random: 1 for white noise, below 1 for an even distribution, above for an
/// uneven one.
double unevenness(const Surface& cube, const SurfaceSamples& samples)
{
  const int trianglesPerFace = static_cast<int>(cube.triangles.size()) / 6;
  const int pointsPerFace = static_cast<int>(cube.points.size()) / 6;
  const int n = static_cast<int>(std::lround(std::sqrt(pointsPerFace))) - 1;
  std::vector<double> counts(6 * 16, 0.0);
  for (std::size_t i = 0; i < samples.triangles.size(); ++i)
  {
    const int face = samples.triangles[i] / trianglesPerFace;
    const glm::dvec3* corner = &cube.points[static_cast<std::size_t>(face) * pointsPerFace];
    const glm::dvec3 offset = cube.position(samples, i) - corner[0];
    const int s = static_cast<int>(3.9999 * glm::dot(offset, corner[n * (n + 1)] - corner[0]));
    const int t = static_cast<int>(3.9999 * glm::dot(offset, corner[n] - corner[0]));
    counts[face * 16 + s * 4 + t] += 1.0;
  }
  const double expected = samples.triangles.size() / 96.0;
  double sum = 0.0;
  for (const double count : counts)
  {
    sum += (count - expected) * (count - expected);
  }
  return sum / (96.0 * expected);
}

/// Smallest distance of two samples, in units of the spacing.
double smallestDistance(const Surface& surface, const SurfaceSamples& samples)
{
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < samples.triangles.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      smallest = std::min(
        smallest, glm::length(surface.position(samples, i) - surface.position(samples, j)));
    }
  }
  return smallest / samples.patchSpacing[0];
}

void expectEqual(const SurfaceSamples& a, const SurfaceSamples& b)
{
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.barycentrics, b.barycentrics);
  EXPECT_EQ(a.patches, b.patches);
  EXPECT_EQ(a.strata, b.strata);
  EXPECT_EQ(a.patchSpacing, b.patchSpacing);
}
} // namespace

TEST(SurfaceSampling, TwoTrianglesGetTheWantedNumberOfSamples)
{
  Surface quad;
  addGrid(quad, { 5, -3, 2 }, { 2, 1, 0 }, { 0, 1, 3 }, 1);
  const SurfaceSamples samples = sampleSurface(quad.mesh());
  EXPECT_NEAR(static_cast<double>(samples.triangles.size()), 500.0, 75.0);
  const double area = glm::length(glm::cross(glm::dvec3(2, 1, 0), glm::dvec3(0, 1, 3)));
  EXPECT_NEAR(samples.patchSpacing[0], std::sqrt(area / 500.0), 1e-12);
}

TEST(SurfaceSampling, DensityDoesNotDependOnTheTriangulation)
{
  SamplingOptions options;
  options.samplesPerPatch = 4800;
  for (const Surface& cube : { makeCube(1), makeCube(7), makeCube(60), makeCube(40, 3.0) })
  {
    const SurfaceSamples samples = sampleSurface(cube.mesh(), options);
    EXPECT_GT(samples.triangles.size(), 4700u);
    EXPECT_LT(unevenness(cube, samples), 0.4) << cube.triangles.size() << " triangles";
  }
}

TEST(SurfaceSampling, SamplesLieInTheirTriangles)
{
  const Surface cube = makeCube(3);
  const SurfaceSamples samples = sampleSurface(cube.mesh());
  for (const glm::dvec3& weights : samples.barycentrics)
  {
    EXPECT_GE(std::min({ weights.x, weights.y, weights.z }), 0.0);
    EXPECT_NEAR(weights.x + weights.y + weights.z, 1.0, 1e-15);
  }
}

TEST(SurfaceSampling, OneSampleIsEquallyLikelyEverywhere)
{
  Surface surface;
  surface.points = { { 0, 0, 0 }, { 3, 0, 1 }, { 1, 2, 0 } };
  surface.triangles = { { 0, 1, 2 } };
  SamplingOptions options;
  options.samplesPerPatch = 1;
  options.regularity = 1;
  const int trials = 10000;
  glm::dvec3 mean(0.0);
  glm::dvec3 meanSquare(0.0);
  for (int i = 0; i < trials; ++i)
  {
    options.seed = static_cast<std::uint32_t>(i);
    const SurfaceSamples samples = sampleSurface(surface.mesh(), options);
    ASSERT_EQ(samples.triangles.size(), 1u);
    mean += samples.barycentrics[0] / static_cast<double>(trials);
    meanSquare += samples.barycentrics[0] * samples.barycentrics[0] / static_cast<double>(trials);
  }
  // Moments of the uniform distribution; the tolerances are four standard errors.
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(mean[i], 1.0 / 3.0, 0.0094);
    EXPECT_NEAR(meanSquare[i], 1.0 / 6.0, 0.0079);
  }
}

TEST(SurfaceSampling, MinimumDistanceIsKept)
{
  Surface quad;
  addGrid(quad, { 0, 0, 0 }, { 2, 1, 0 }, { 0, 1, 3 }, 4);
  SamplingOptions options;
  options.regularity = 1;
  options.minimumDistance = 0.0;
  EXPECT_LT(smallestDistance(quad, sampleSurface(quad.mesh(), options)), 0.2);
  options.minimumDistance = 0.35;
  EXPECT_GE(smallestDistance(quad, sampleSurface(quad.mesh(), options)), 0.35);
  options.regularity = 20;
  EXPECT_GE(smallestDistance(quad, sampleSurface(quad.mesh(), options)), 0.45);
}

TEST(SurfaceSampling, SheetsBackToBackDoNotThinEachOther)
{
  Surface plate;
  addGrid(plate, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  addGrid(plate, { 0, 0, 1e-4 }, { 0, 1, 0 }, { 1, 0, 0 }, 1);
  SamplingOptions options;
  options.minimumDistance = 0.6;
  EXPECT_GT(sampleSurface(plate.mesh(), options).triangles.size(), 480u);
}

TEST(SurfaceSampling, ThreadsDoNotMatter)
{
  Surface surface = makeCube(20);
  for (std::size_t i = 0; i < surface.patches.size(); ++i)
  {
    surface.patches[i] = static_cast<std::int32_t>(i * 7 / 100);
  }
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const SurfaceSamples one = sampleSurface(surface.mesh());
  omp_set_num_threads(8);
  const SurfaceSamples eight = sampleSurface(surface.mesh());
  omp_set_num_threads(before);
  EXPECT_GT(one.triangles.size(), 100000u);
  expectEqual(one, eight);
}

TEST(SurfaceSampling, ScaleDoesNotMatter)
{
  const Surface cube = makeCube(3);
  const SurfaceSamples expected = sampleSurface(cube.mesh());
  for (const int exponent : { -500, 500 }) // powers of two, so that nothing is rounded
  {
    Surface scaled = cube;
    for (glm::dvec3& point : scaled.points)
    {
      point *= std::ldexp(1.0, exponent);
    }
    SurfaceSamples samples = sampleSurface(scaled.mesh());
    samples.patchSpacing[0] = std::ldexp(samples.patchSpacing[0], -exponent);
    expectEqual(samples, expected);
  }
}

TEST(SurfaceSampling, PatchesAreIndependent)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1, 1.0, 3);
  addGrid(surface, { 0, 0, 1 }, { 9, 0, 0 }, { 0, 9, 0 }, 1, 1.0, 1);
  addGrid(surface, { 0, 0, 2 }, { 1, 0, 0 }, { 0, 1, 0 }, 1, 1.0, -1);
  const SurfaceSamples both = sampleSurface(surface.mesh());
  ASSERT_EQ(both.patchSpacing.size(), 4u);
  EXPECT_EQ(both.patchSpacing[0], 0.0);
  EXPECT_NEAR(both.patchSpacing[1], 9.0 * both.patchSpacing[3], 1e-12);
  EXPECT_EQ(std::count(both.patches.begin(), both.patches.end(), -1), 0);
  EXPECT_GT(std::count(both.patches.begin(), both.patches.end(), 1), 480);

  surface.patches[2] = surface.patches[3] = -1; // takes patch 1 away
  const SurfaceSamples alone = sampleSurface(surface.mesh());
  const std::size_t count = alone.triangles.size();
  ASSERT_GT(count, 480u);
  EXPECT_TRUE(std::equal(
    alone.barycentrics.begin(), alone.barycentrics.end(), both.barycentrics.end() - count));
  EXPECT_TRUE(std::equal(alone.strata.begin(), alone.strata.end(), both.strata.end() - count));
}

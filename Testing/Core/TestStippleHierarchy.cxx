// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StippleScene.h"

#include "PatternMetricsStipples.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>

using namespace hachure;

namespace
{

std::vector<glm::dvec2> beginning(
  const Surface& plane, const StippleHierarchy& hierarchy, std::size_t count)
{
  std::vector<glm::dvec2> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    result.emplace_back(stipplePosition(plane.mesh(), hierarchy.points[i]));
  }
  return result;
}

// Hierarchies on a plane, of ten seeds.
std::vector<StippleHierarchy> tenHierarchies(const Surface& plane, std::int64_t count)
{
  std::vector<StippleHierarchy> result;
  result.reserve(10);
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
  {
    StippleOptions options;
    options.count = count;
    options.seed = seed;
    result.push_back(stippleSurface(plane.mesh(), options));
  }
  return result;
}

// Of the first `count` points.
StippleMetrics meanMetrics(
  const Surface& plane, const std::vector<StippleHierarchy>& hierarchies, std::size_t count)
{
  std::vector<StippleMetrics> sets;
  sets.reserve(hierarchies.size());
  for (const StippleHierarchy& hierarchy : hierarchies)
  {
    sets.push_back(
      measureStipples(beginning(plane, hierarchy, count), { { 0.0, 0.0 }, { 1.0, 1.0 }, false }));
  }
  return meanOfStipples(sets);
}

// Smallest distance of the first points that face alike.
double smallestDistance(
  const Surface& surface, const StippleHierarchy& hierarchy, std::size_t count)
{
  double smallest = hierarchy.size;
  for (std::size_t i = 0; i < count; ++i)
  {
    const StipplePoint& first = hierarchy.points[i];
    for (std::size_t j = 0; j < i; ++j)
    {
      const StipplePoint& second = hierarchy.points[j];
      if (glm::dot(normalOf(surface, first), normalOf(surface, second)) > -0.7)
      {
        smallest = std::min(smallest,
          glm::length(
            stipplePosition(surface.mesh(), first) - stipplePosition(surface.mesh(), second)));
      }
    }
  }
  return smallest;
}

} // namespace

TEST(StippleHierarchy, PointsOnAPlaneAreBlueNoise)
{
  const Surface plane = unitPlane(1);
  const StippleMetrics metrics = meanMetrics(plane, tenHierarchies(plane, 570), 570);
  EXPECT_GE(metrics.clarkEvans, 1.75);
  EXPECT_LE(metrics.lowFrequencyPower, 0.08);
  EXPECT_LT(metrics.anisotropy, 1.0);
  EXPECT_GT(metrics.relativeRadius, 0.65);
}

TEST(StippleHierarchy, EveryBeginningIsBlueNoise)
{
  const Surface plane = unitPlane(3);
  const std::vector<StippleHierarchy> hierarchies = tenHierarchies(plane, 2000);
  for (const std::size_t prefix : { 200u, 570u, 900u, 2000u })
  {
    const StippleMetrics metrics = meanMetrics(plane, hierarchies, prefix);
    EXPECT_GE(metrics.clarkEvans, prefix < 500 ? 1.73 : 1.75) << prefix;
    EXPECT_LE(metrics.lowFrequencyPower, prefix < 500 ? 0.1 : 0.085) << prefix;
    EXPECT_LT(metrics.anisotropy, 1.0) << prefix;
  }
}

TEST(StippleHierarchy, TheTriangulationDoesNotMatter)
{
  const Surface plane = unitPlane(60);
  const StippleMetrics metrics = meanMetrics(plane, tenHierarchies(plane, 570), 570);
  EXPECT_GE(metrics.clarkEvans, 1.74);
  EXPECT_LE(metrics.lowFrequencyPower, 0.085);
}

TEST(StippleHierarchy, ABeginningIsAShorterHierarchy)
{
  const Surface plane = unitPlane(4);
  StippleOptions options;
  options.count = 300;
  const StippleHierarchy few = stippleSurface(plane.mesh(), options);
  options.count = 5000;
  const StippleHierarchy many = stippleSurface(plane.mesh(), options);
  ASSERT_EQ(few.points.size(), 300u);
  ASSERT_EQ(many.points.size(), 5000u);
  expectEqual(few, many, 300);
}

// Of the candidates of the last points only those are made that may be needed, by a guess of how
// far gaps shrink: right on a plane, too early on a bar that looks like a line at first.
TEST(StippleHierarchy, WhatTheLastPointsNeedIsMadeInTime)
{
  Surface bar;
  addGrid(bar, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2e-4, 0 }, 1);
  for (const Surface& surface : { unitPlane(3), bar })
  {
    StippleOptions options;
    options.count = 5000;
    const StippleHierarchy many = stippleSurface(surface.mesh(), options);
    ASSERT_EQ(many.points.size(), 5000u);
    for (const std::int64_t count : { 1999, 2700, 3600 })
    {
      options.count = count;
      const StippleHierarchy few = stippleSurface(surface.mesh(), options);
      ASSERT_EQ(few.points.size(), static_cast<std::size_t>(count));
      expectEqual(few, many, few.points.size());
    }
  }
}

TEST(StippleHierarchy, SpacingIsABoundThatFalls)
{
  const Surface sphere = unitSphere(40);
  StippleOptions options;
  options.count = 2000;
  const StippleHierarchy hierarchy = stippleSurface(sphere.mesh(), options);
  EXPECT_NEAR(hierarchy.area, 4.0 * std::acos(-1.0), 0.03);
  for (std::size_t i = 1; i < hierarchy.points.size(); ++i)
  {
    ASSERT_LE(hierarchy.points[i].spacing, hierarchy.points[i - 1].spacing);
  }
  for (const std::size_t count : { 10u, 60u, 570u, 2000u })
  {
    const double smallest = smallestDistance(sphere, hierarchy, count);
    EXPECT_GE(smallest * (1.0 + 1e-5), hierarchy.points[count - 1].spacing) << count;
    // Of a triangular lattice on that area.
    EXPECT_GT(smallest, 0.6 * std::sqrt(2.0 * hierarchy.area / (std::sqrt(3.0) * count))) << count;
  }
}

TEST(StippleHierarchy, PointsLieInTheirTriangles)
{
  const Surface sphere = unitSphere(10);
  StippleOptions options;
  options.count = 20000;
  for (const StipplePoint& point : stippleSurface(sphere.mesh(), options).points)
  {
    ASSERT_GE(point.weights[0], 0.0f);
    ASSERT_GE(point.weights[1], 0.0f);
    ASSERT_LE(point.weights[0] + point.weights[1], 1.0f);
  }
}

TEST(StippleHierarchy, ThreadsDoNotMatter)
{
  const Surface sphere = unitSphere(60);
  StippleOptions options;
  options.count = 20000;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const StippleHierarchy one = stippleSurface(sphere.mesh(), options);
  omp_set_num_threads(8);
  const StippleHierarchy eight = stippleSurface(sphere.mesh(), options);
  omp_set_num_threads(before);
  ASSERT_EQ(one.points.size(), 20000u);
  expectEqual(one, eight, 20000);
}

TEST(StippleHierarchy, ScaleDoesNotMatter)
{
  const Surface sphere = unitSphere(12);
  StippleOptions options;
  options.count = 700;
  const StippleHierarchy expected = stippleSurface(sphere.mesh(), options);
  for (const int exponent : { -60, 60 }) // powers of two, so that nothing is rounded
  {
    Surface scaled = sphere;
    for (glm::dvec3& point : scaled.points)
    {
      point *= std::ldexp(1.0, exponent);
    }
    StippleHierarchy hierarchy = stippleSurface(scaled.mesh(), options);
    for (StipplePoint& point : hierarchy.points)
    {
      point.spacing = std::ldexp(point.spacing, -exponent);
    }
    expectEqual(expected, hierarchy, 700);
  }
}

TEST(StippleHierarchy, TheSidesOfAThinWallDoNotThinEachOther)
{
  Surface plate;
  addGrid(plate, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  addGrid(plate, { 0, 0, 1e-4 }, { 0, 1, 0 }, { 1, 0, 0 }, 1);
  StippleOptions options;
  options.count = 1140;
  const StippleHierarchy hierarchy = stippleSurface(plate.mesh(), options);
  std::vector<glm::dvec2> front;
  for (const StipplePoint& point : hierarchy.points)
  {
    if (point.triangle < 2)
    {
      front.emplace_back(stipplePosition(plate.mesh(), point));
    }
  }
  EXPECT_NEAR(static_cast<double>(front.size()), 570.0, 12.0);
  EXPECT_GT(measureStipples(front, { { 0.0, 0.0 }, { 1.0, 1.0 }, false }).clarkEvans, 1.7);
}

TEST(StippleHierarchy, DensityIsTheSameOnAllComponents)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  addGrid(surface, { 5, 0, 1 }, { 2, 0, 0 }, { 0, 2, 0 }, 9, 2.0);
  StippleOptions options;
  options.count = 2500;
  int small = 0;
  for (const StipplePoint& point : stippleSurface(surface.mesh(), options).points)
  {
    small += point.triangle < 2 ? 1 : 0;
  }
  EXPECT_NEAR(small, 500, 25);
}

TEST(StippleHierarchy, AStippleIsSmall)
{
  StippleOptions options;
  options.count = 10000;
  const StippleHierarchy hierarchy = stippleSurface(unitSphere(20).mesh(), options);
  EXPECT_LE(hierarchy.memory(), 72u * hierarchy.points.size());
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "StippleScene.h"
#include "StippleTransfer.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace hachure;

namespace
{

StippleOptions options(std::int64_t count, std::uint32_t seed = 1)
{
  StippleOptions result;
  result.count = count;
  result.seed = seed;
  return result;
}

Surface sphere(int n, double radius = 1.0)
{
  Surface surface = unitSphere(n);
  for (glm::dvec3& point : surface.points)
  {
    point *= radius;
  }
  return surface;
}

// A lumpy closed surface around the origin, as a level of some waves.
Surface waves(int n, double level)
{
  Surface surface = unitSphere(n);
  for (glm::dvec3& point : surface.points)
  {
    const glm::dvec3 at = 4.0 * point;
    point *= 0.9 + level + 0.08 * (std::sin(at.x) * std::cos(at.y) + std::sin(at.z + 8.0 * level));
  }
  return surface;
}

// A surface and its stipples, and where they come from.
struct Stippled
{
  Surface surface;
  StippleHierarchy hierarchy;
  std::vector<std::int32_t> origins;
};

Stippled stippled(const Surface& surface, std::int64_t count)
{
  return { surface, stippleSurface(surface.mesh(), options(count)), {} };
}

Stippled carry(const Stippled& from, const Surface& to, double reach = 0.0, std::uint32_t seed = 1)
{
  Stippled result{ to, {}, {} };
  const auto count = static_cast<std::int64_t>(from.hierarchy.points.size());
  result.hierarchy = carryStipples(to.mesh(), carriedStipples(from.surface.mesh(), from.hierarchy),
    from.hierarchy.area, options(count, seed), result.origins, reach);
  return result;
}

glm::dvec3 placeOf(const Stippled& on, std::size_t rank)
{
  return stipplePosition(on.surface.mesh(), on.hierarchy.points[rank]);
}

// Share of the points that have an old one's place within a tenth of its spacing; `place` tells
// where old places are expected.
double keptShare(
  const Stippled& from, const Stippled& to,
  const std::function<glm::dvec3(glm::dvec3)>& place = [](glm::dvec3 at) { return at; })
{
  double kept = 0.0;
  for (std::size_t i = 0; i < to.origins.size(); ++i)
  {
    const auto origin = static_cast<std::size_t>(std::max(0, to.origins[i]));
    kept += to.origins[i] >= 0 &&
        glm::length(placeOf(to, i) - place(placeOf(from, origin))) <
          0.1 * static_cast<double>(from.hierarchy.points[origin].spacing)
      ? 1.0
      : 0.0;
  }
  return kept / static_cast<double>(to.origins.size());
}

// Median of what densities (ranks per area) of kept points are multiplied with.
double densityRatio(const Stippled& from, const Stippled& to)
{
  std::vector<double> ratios;
  ratios.reserve(to.origins.size());
  for (std::size_t i = 0; i < to.origins.size(); ++i)
  {
    if (to.origins[i] >= 0)
    {
      ratios.push_back((static_cast<double>(i) + 1.0) / to.hierarchy.area * from.hierarchy.area /
        (static_cast<double>(to.origins[i]) + 1.0));
    }
  }
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return ratios.empty() ? 0.0 : *middle;
}

// R of Clark and Evans of the first points on a closed surface.
double evenness(const Stippled& on, std::size_t count)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < count; ++j)
    {
      nearest = j == i ? nearest : std::min(nearest, glm::length(placeOf(on, i) - placeOf(on, j)));
    }
    sum += nearest;
  }
  const auto points = static_cast<double>(count);
  return sum / points / (0.5 * std::sqrt(on.hierarchy.area / points));
}

void expectEven(const Stippled& on, double least)
{
  for (const std::size_t count : { 200u, 400u, 800u, 1600u, 3000u })
  {
    EXPECT_GE(evenness(on, count), least) << count;
  }
}

void expectSame(const Stippled& first, const Stippled& second)
{
  ASSERT_EQ(first.hierarchy.points.size(), second.hierarchy.points.size());
  expectEqual(first.hierarchy, second.hierarchy, first.hierarchy.points.size());
  EXPECT_EQ(first.origins, second.origins);
}

} // namespace

TEST(StippleTransfer, PointsStayOnASurfaceOfOtherTriangles)
{
  const Stippled before = stippled(sphere(40), 3000);
  const Stippled after = carry(before, sphere(55));
  ASSERT_EQ(after.hierarchy.points.size(), 3000u);
  EXPECT_GE(keptShare(before, after), 0.9);
  EXPECT_NEAR(densityRatio(before, after), 1.0, 0.02);
  expectEven(after, 1.65);
}

TEST(StippleTransfer, TenSurfacesLaterPointsAreAsEven)
{
  Stippled now = stippled(sphere(40), 3000);
  for (int i = 1; i <= 10; ++i)
  {
    const Stippled next = carry(now, sphere(40 + 3 * i), 0.0, 1 + static_cast<std::uint32_t>(i));
    EXPECT_GE(keptShare(now, next), 0.85) << i;
    now = next;
  }
  expectEven(now, 1.65);
}

TEST(StippleTransfer, PointsOfAGrowingSphereGoOutward)
{
  const Stippled before = stippled(sphere(40), 3000);
  const Stippled after = carry(before, sphere(40, 1.05), 0.1);
  EXPECT_GE(keptShare(before, after, [](glm::dvec3 at) { return 1.05 * at; }), 0.7);
  EXPECT_NEAR(densityRatio(before, after), 1.0, 0.1);
  expectEven(after, 1.65);
  // Nearer than a half of their spacing are only those that come early.
  EXPECT_LT(
    keptShare(before, carry(before, sphere(40, 1.05)), [](glm::dvec3 at) { return 1.05 * at; }),
    0.3);
}

TEST(StippleTransfer, PointsFollowALevelOfWaves)
{
  const Stippled first = stippled(waves(40, 0.0), 3000);
  Stippled now = first;
  for (int i = 1; i <= 10; ++i)
  {
    const Stippled next = carry(now, waves(40 + i % 3, 0.002 * i), 0.02);
    const auto fresh = std::count(next.origins.begin(), next.origins.end(), -1);
    EXPECT_LT(fresh, 450) << i;
    EXPECT_NEAR(densityRatio(now, next), 1.0, 0.1) << i;
    if (i == 1 || i == 10)
    {
      expectEven(next, 1.65);
    }
    now = next;
  }
}

TEST(StippleTransfer, OriginsAreOldPointsAndEachContinuesOnce)
{
  const Stippled before = stippled(waves(30, 0.0), 2000);
  const Stippled after = carry(before, waves(31, 0.004), 0.02);
  ASSERT_EQ(after.origins.size(), after.hierarchy.points.size());
  std::vector<int> uses(2000, 0);
  for (std::size_t i = 0; i < after.origins.size(); ++i)
  {
    if (after.origins[i] >= 0)
    {
      ++uses[static_cast<std::size_t>(after.origins[i])];
    }
    if (i > 0)
    {
      ASSERT_LE(after.hierarchy.points[i].spacing, after.hierarchy.points[i - 1].spacing);
    }
  }
  EXPECT_EQ(*std::max_element(uses.begin(), uses.end()), 1);
}

TEST(StippleTransfer, SpacingIsABound)
{
  const Stippled after = carry(stippled(sphere(30), 1500), sphere(33, 1.01), 0.02);
  for (std::size_t i = 1; i < after.hierarchy.points.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const glm::dvec3 first = placeOf(after, i);
      const glm::dvec3 second = placeOf(after, j);
      if (glm::dot(glm::normalize(first), glm::normalize(second)) > -0.6) // not back to back
      {
        ASSERT_GE(glm::length(first - second) * (1.0 + 1e-5), after.hierarchy.points[i].spacing);
      }
    }
  }
}

TEST(StippleTransfer, ABackSideIsAnotherSurface)
{
  Surface front, back;
  addGrid(front, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4);
  addGrid(back, { 0, 0, 1e-3 }, { 0, 1, 0 }, { 1, 0, 0 }, 4);
  const Stippled before = stippled(front, 300);
  const Stippled after = carry(before, back);
  EXPECT_EQ(std::count(after.origins.begin(), after.origins.end(), -1), 300);
}

TEST(StippleTransfer, ThreadsDoNotMatter)
{
  const Stippled before = stippled(waves(40, 0.0), 5000);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Stippled one = carry(before, waves(41, 0.004), 0.02);
  omp_set_num_threads(8);
  const Stippled eight = carry(before, waves(41, 0.004), 0.02);
  omp_set_num_threads(threads);
  expectSame(one, eight);
}

TEST(StippleTransfer, WithoutOldPointsTheyAreNew)
{
  const Surface surface = sphere(20);
  std::vector<std::int32_t> origins{ 7 };
  const StippleHierarchy carried = carryStipples(surface.mesh(), {}, 0.0, options(3000), origins);
  const StippleHierarchy fresh = stippleSurface(surface.mesh(), options(3000));
  expectEqual(carried, fresh, 3000);
  EXPECT_EQ(origins, std::vector<std::int32_t>(3000, -1));
}

TEST(StippleTransfer, ASurfaceWithoutTrianglesTakesNone)
{
  Surface degenerate;
  degenerate.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  degenerate.triangles = { { 0, 1, 2 }, { 0, 1, 2 } };
  const Stippled before = stippled(sphere(10), 100);
  for (const Surface& to : { Surface(), degenerate })
  {
    const Stippled after = carry(before, to);
    EXPECT_TRUE(after.hierarchy.points.empty());
    EXPECT_TRUE(after.origins.empty());
  }
  Surface triangle; // where the old ones are, and twice
  triangle.points = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  triangle.triangles = { { 0, 1, 2 }, { 0, 1, 2 }, { 0, 1, 1 } };
  EXPECT_EQ(carry(before, triangle).hierarchy.points.size(), 100u);
}

TEST(StippleTransfer, WrongInputIsNamed)
{
  const Surface surface = sphere(4);
  const auto message =
    [&](const CarriedStipple& old, double area, double reach, const StippleOptions& with)
  {
    std::vector<std::int32_t> origins;
    try
    {
      carryStipples(surface.mesh(), { &old, 1 }, area, with, origins, reach);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const CarriedStipple good{ { 1, 0, 0 }, { 1, 0, 0 }, 0.5f };
  EXPECT_EQ(message(good, 1.0, 0.0, options(10)), "");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message({ { 1, nan, 0 }, { 1, 0, 0 }, 0.5f }, 1.0, 0.0, options(10))
              .find("old[0]: a coordinate"),
    std::string::npos);
  EXPECT_NE(message({ { 1, 0, 0 }, { 1, 0, 0 }, -1.0f }, 1.0, 0.0, options(10)).find("spacing -1"),
    std::string::npos);
  EXPECT_NE(message(good, 0.0, 0.0, options(10)).find("oldArea: 0"), std::string::npos);
  EXPECT_NE(message(good, 1.0, -1.0, options(10)).find("reach: -1"), std::string::npos);
  EXPECT_NE(message(good, 1.0, 0.0, options(-1)).find("count: -1"), std::string::npos);
  StippleOptions classic = options(10);
  classic.order = StippleOrder::Classic;
  EXPECT_NE(message(good, 1.0, 0.0, classic).find("order: Classic"), std::string::npos);
}

TEST(StippleTransfer, ProgressRisesAndCanStop)
{
  const Stippled before = stippled(sphere(20), 20000);
  StippleOptions with = options(20000);
  StoppingProgress progress{ 8 };
  with.progress = [&](double fraction) { return progress.report(fraction); };
  std::vector<std::int32_t> origins;
  EXPECT_TRUE(carryStipples(before.surface.mesh(),
    carriedStipples(before.surface.mesh(), before.hierarchy), before.hierarchy.area, with, origins)
                .points.empty());
  EXPECT_EQ(progress.calls, 8);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The operators of the paper. Its figure 6 is a flat mesh of 7 vertices: here a hexagon.

#include "CallTests.h"
#include "Random.h"
#include "StippleScene.h"

#include "PatternMetricsStipples.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using namespace hachure;

namespace
{

// Six corners and a point inside; irregular with a seed.
Surface hexagon(std::uint32_t seed)
{
  Surface surface;
  const auto random = [seed](std::uint64_t id, std::uint32_t dimension)
  { return seed > 0 ? 0.5 * (unitRandom(seed, id, dimension) - 0.5) : 0.0; };
  for (int i = 0; i < 6; ++i)
  {
    const double angle = i * std::acos(0.5) + random(static_cast<std::uint64_t>(i), 2);
    surface.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    surface.triangles.emplace_back(i, (i + 1) % 6, 6);
  }
  surface.points.emplace_back(random(9, 0), random(9, 1), 0.0);
  return surface;
}

StippleOptions classic(std::int64_t count, std::uint32_t seed = 1)
{
  StippleOptions options;
  options.order = StippleOrder::Classic;
  options.count = count;
  options.seed = seed;
  return options;
}

// About 570 points in the middle of the hexagon, mean of ten seeds.
StippleMetrics figureSix(bool isRandomised)
{
  std::vector<StippleMetrics> sets;
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
  {
    const Surface surface = hexagon(isRandomised ? 0 : seed);
    StippleOptions options = classic(1481, seed);
    if (!isRandomised)
    {
      options.leastMove = options.mostMove = 0.0;
    }
    std::vector<glm::dvec2> inside;
    for (const StipplePoint& point : stippleSurface(surface.mesh(), options).points)
    {
      const glm::dvec2 place(stipplePosition(surface.mesh(), point));
      if (std::abs(place.x) <= 0.5 && std::abs(place.y) <= 0.5)
      {
        inside.push_back(place);
      }
    }
    sets.push_back(measureStipples(inside, { { -0.5, -0.5 }, { 1.0, 1.0 }, false }));
  }
  return meanOfStipples(sets);
}

double areaOf(const Surface& surface, const StippleHierarchy& hierarchy)
{
  double area = 0.0;
  for (const glm::ivec3& corners : hierarchy.particleTriangles)
  {
    glm::dvec3 places[3];
    for (int i = 0; i < 3; ++i)
    {
      const auto rank = static_cast<std::size_t>(corners[i]);
      places[i] = stipplePosition(surface.mesh(), hierarchy.points[rank]);
    }
    area += 0.5 * glm::length(glm::cross(places[1] - places[0], places[2] - places[0]));
  }
  return area;
}

// How many triangles are at how many of the edges.
std::map<int, int> edgeUses(const StippleHierarchy& hierarchy)
{
  std::map<std::pair<int, int>, int> edges;
  for (const glm::ivec3& corners : hierarchy.particleTriangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = corners[i];
      const int b = corners[(i + 1) % 3];
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  std::map<int, int> uses;
  for (const auto& [edge, count] : edges)
  {
    ++uses[count];
  }
  return uses;
}

void expectSameNeighbours(
  const StippleHierarchy& few, const StippleHierarchy& many, std::size_t count)
{
  ASSERT_EQ(few.firstNeighbour.size(), count + 1);
  EXPECT_TRUE(
    std::equal(few.firstNeighbour.begin(), few.firstNeighbour.end(), many.firstNeighbour.begin()));
  EXPECT_TRUE(std::equal(few.neighbours.begin(), few.neighbours.end(), many.neighbours.begin()));
}

} // namespace

TEST(StippleClassic, SplitsWithTheRandomiseOperatorAreIsotropic)
{
  const StippleMetrics metrics = figureSix(true);
  EXPECT_NEAR(metrics.clarkEvans, 1.40, 0.14);
  EXPECT_NEAR(metrics.relativeRadius, 0.22, 0.022);
  EXPECT_NEAR(metrics.lowFrequencyPower, 0.28, 0.028);
  EXPECT_LT(std::abs(metrics.anisotropy), 1.0);
}

TEST(StippleClassic, SplitsWithoutItMakeLines)
{
  const StippleMetrics metrics = figureSix(false);
  EXPECT_NEAR(metrics.clarkEvans, 1.68, 0.168);
  EXPECT_GT(metrics.anisotropy, 3.3);
}

TEST(StippleClassic, NeighboursHaveLowerRanks)
{
  const Surface sphere = unitSphere(6);
  const StippleHierarchy hierarchy = stippleSurface(sphere.mesh(), classic(3000));
  ASSERT_EQ(hierarchy.points.size(), 3000u);
  ASSERT_EQ(hierarchy.firstNeighbour.size(), 3001u);
  EXPECT_EQ(hierarchy.firstNeighbour.back(), hierarchy.neighbours.size());
  int top = 0;
  for (std::size_t i = 0; i < 3000; ++i)
  {
    const glm::dvec3 place = stipplePosition(sphere.mesh(), hierarchy.points[i]);
    double shortest = hierarchy.size;
    for (std::uint32_t k = hierarchy.firstNeighbour[i]; k < hierarchy.firstNeighbour[i + 1]; ++k)
    {
      const auto other = static_cast<std::size_t>(hierarchy.neighbours[k]);
      ASSERT_LT(other, i);
      shortest = std::min(
        shortest, glm::length(stipplePosition(sphere.mesh(), hierarchy.points[other]) - place));
    }
    ASSERT_NEAR(hierarchy.points[i].spacing, shortest, 1e-5);
    top += hierarchy.firstNeighbour[i] == hierarchy.firstNeighbour[i + 1] ? 1 : 0;
  }
  EXPECT_LE(top, 8); // collapsed until only a few are left
  EXPECT_LE(hierarchy.memory(), 72u * hierarchy.points.size());
}

TEST(StippleClassic, ABeginningIsAShorterHierarchy)
{
  const Surface sphere = unitSphere(8); // 386 vertices
  const StippleHierarchy many = stippleSurface(sphere.mesh(), classic(2000));
  for (const std::size_t count : { 100u, 386u, 900u })
  {
    const StippleHierarchy few =
      stippleSurface(sphere.mesh(), classic(static_cast<std::int64_t>(count)));
    expectEqual(few, many, count);
    expectSameNeighbours(few, many, count);
  }
}

TEST(StippleClassic, TheParticleMeshStaysClosed)
{
  const Surface sphere = unitSphere(8);
  for (const int count : { 100, 386, 1500 })
  {
    const StippleHierarchy hierarchy = stippleSurface(sphere.mesh(), classic(count));
    EXPECT_EQ(hierarchy.particleTriangles.size(), 2u * static_cast<unsigned>(count) - 4u) << count;
    const std::map<int, int> uses = edgeUses(hierarchy);
    ASSERT_EQ(uses.size(), 1u) << count;
    EXPECT_EQ(uses.begin()->first, 2) << count;
    EXPECT_NEAR(areaOf(sphere, hierarchy), 4.0 * std::acos(-1.0), count < 200 ? 1.0 : 0.3);
  }
}

TEST(StippleClassic, BordersStay)
{
  const Surface plane = unitPlane(5);
  for (const int count : { 20, 36, 1000 })
  {
    const StippleHierarchy hierarchy = stippleSurface(plane.mesh(), classic(count));
    ASSERT_EQ(hierarchy.points.size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(areaOf(plane, hierarchy), 1.0, 1e-6) << count;
  }
}

TEST(StippleClassic, ACoarseCubeIsRefined)
{
  Surface cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  }
  cube.triangles = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 },
    { 2, 6, 3 }, { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
  const StippleHierarchy hierarchy = stippleSurface(cube.mesh(), classic(6000));
  ASSERT_EQ(hierarchy.points.size(), 6000u);
  int counts[6] = {};
  for (const StipplePoint& point : hierarchy.points)
  {
    ++counts[point.triangle / 2];
  }
  for (const int count : counts)
  {
    EXPECT_NEAR(count, 1000, 100);
  }
}

TEST(StippleClassic, ThreadsDoNotMatter)
{
  const Surface sphere = unitSphere(30);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const StippleHierarchy one = stippleSurface(sphere.mesh(), classic(8000));
  omp_set_num_threads(8);
  const StippleHierarchy eight = stippleSurface(sphere.mesh(), classic(8000));
  omp_set_num_threads(before);
  expectEqual(one, eight, 8000);
  EXPECT_EQ(one.neighbours, eight.neighbours);
  EXPECT_EQ(one.particleTriangles, eight.particleTriangles);
}

TEST(StippleClassic, OddMeshesAreStippledSilently)
{
  Surface fan; // three sheets at an edge, and repeated and degenerate triangles
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.1 * i;
    addGrid(fan, { 0, 0, 0 }, { std::cos(angle), std::sin(angle), 0 }, { 0, 0, 1 }, 2);
  }
  fan.triangles.push_back(fan.triangles.front());
  fan.triangles.emplace_back(0, 0, 1);
  fan.patches.clear();
  EXPECT_EQ(stippleSurface(fan.mesh(), classic(900)).points.size(), 900u);
  EXPECT_EQ(stippleSurface(fan.mesh(), classic(3)).points.size(), 3u);
  EXPECT_TRUE(stippleSurface(fan.mesh(), classic(0)).points.empty());
  fan.triangles.clear();
  EXPECT_TRUE(stippleSurface(fan.mesh(), classic(10)).points.empty());
}

TEST(StippleClassic, ProgressRisesAndCanStop)
{
  const Surface sphere = unitSphere(40);
  StippleOptions options = classic(60000);
  StoppingProgress progress{ 8 };
  options.progress = [&](double fraction) { return progress.report(fraction); };
  EXPECT_TRUE(stippleSurface(sphere.mesh(), options).points.empty());
  EXPECT_EQ(progress.calls, 8);
}

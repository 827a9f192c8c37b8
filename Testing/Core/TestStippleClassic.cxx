// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The operators of the paper.

#include "CallTests.h"
#include "Random.h"
#include "StippleScene.h"

#include "PatternMetricsStipples.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numeric>
#include <utility>

using namespace hachure;

namespace
{

// The flat mesh of 7 vertices of the paper's figure 6: a regular hexagon, turned, and its middle.
Surface hexagon(double turn)
{
  Surface surface;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = turn + i * std::acos(0.5);
    surface.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    surface.triangles.emplace_back(i, (i + 1) % 6, 6);
  }
  surface.points.emplace_back(0.0, 0.0, 0.0);
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

// The first 570 points in a square around the middle of the hexagon.
std::vector<glm::dvec2> figureSix(
  const Surface& surface, const StippleOptions& options, double side)
{
  constexpr std::size_t wanted = 570;
  std::vector<glm::dvec2> inside;
  inside.reserve(wanted);
  for (const StipplePoint& point : stippleSurface(surface.mesh(), options).points)
  {
    const glm::dvec2 place(stipplePosition(surface.mesh(), point));
    if (std::max(std::abs(place.x), std::abs(place.y)) <= 0.5 * side && inside.size() < wanted)
    {
      inside.push_back(place);
    }
  }
  EXPECT_EQ(inside.size(), wanted);
  return inside;
}

double powerAt(const std::vector<glm::dvec2>& points, const glm::dvec2& frequency)
{
  std::complex<double> sum = 0.0;
  for (const glm::dvec2& point : points)
  {
    sum += std::polar(1.0, 2.0 * std::acos(-1.0) * glm::dot(point, frequency));
  }
  return std::norm(sum) / static_cast<double>(points.size());
}

struct Directions
{
  double strongest = 0.0; // power in a sector of 20 degrees / the mean, in decibels
  double spike = 0.0;     // highest power / mean
};

// Of 0.5 to 2 principal frequencies.
Directions directionsOf(const std::vector<glm::dvec2>& points, double side)
{
  constexpr int sectors = 9; // of half a turn; the rest is the same
  const double principal = std::sqrt(static_cast<double>(points.size()));
  const int most = static_cast<int>(2.0 * principal);
  std::vector<double> sums(sectors, 0.0), counts(sectors, 0.0);
  double highest = 0.0;
  for (int y = 0; y <= most; ++y)
  {
    for (int x = y == 0 ? 1 : -most; x <= most; ++x)
    {
      const double frequency = std::hypot(x, y) / principal;
      if (frequency >= 0.5 && frequency < 2.0)
      {
        const auto sector = static_cast<std::size_t>(std::atan2(y, x) / std::acos(-1.0) * sectors);
        const double power = powerAt(points, glm::dvec2(x, y) / side);
        sums[sector % sectors] += power;
        counts[sector % sectors] += 1.0;
        highest = std::max(highest, power);
      }
    }
  }
  const double mean = std::accumulate(sums.begin(), sums.end(), 0.0) /
    std::accumulate(counts.begin(), counts.end(), 0.0);
  double strongest = 0.0;
  for (std::size_t sector = 0; sector < sectors; ++sector)
  {
    strongest = std::max(strongest, sums[sector] / counts[sector] / mean);
  }
  return { 10.0 * std::log10(strongest), highest / mean };
}

struct FigureSix
{
  StippleMetrics metrics;
  Directions directions;
};

// Mean of ten seeds. Without moves a seed is an orientation: else all are the same.
FigureSix meanOfFigureSix(bool isRandomised, double side)
{
  std::vector<StippleMetrics> sets;
  FigureSix result;
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
  {
    StippleOptions options = classic(1700, seed);
    if (!isRandomised)
    {
      options.leastMove = options.mostMove = 0.0;
    }
    const double turn = isRandomised ? 0.0 : 2.0 * std::acos(-1.0) * unitRandom(seed, 50, 0);
    const std::vector<glm::dvec2> points = figureSix(hexagon(turn), options, side);
    sets.push_back(measureStipples(points, { glm::dvec2(-0.5 * side), glm::dvec2(side), false }));
    const Directions directions = directionsOf(points, side);
    result.directions.strongest += 0.1 * directions.strongest;
    result.directions.spike += 0.1 * directions.spike;
  }
  result.metrics = meanOfStipples(sets);
  return result;
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

// Both sides of figure 6, as known from a prototype: with the randomise operator R = 1.40,
// rho = 0.22, power of 0.28 at low frequencies and 0 dB; without it 1.68, 0.58, 0.22, and lines of
// 3.3 dB with spikes of ten times the mean. What the prototype's window, orientations and seeds
// were is not known. What was tried, 570 points and ten seeds each:
// - the regular hexagon, unturned, window 1:              R 1.54  rho .69  low .31
// - the same, turned at random, window 1:                   1.54      .69      .29
// - the same, window 1.2 (as here):                         1.66      .58      .21
// - the same, window 1.22 (all that fits when turned):      1.69      .57      .20
// - hexagons with corners and middle off by chance, window 1: 1.62 to 1.73, .57 to .67, .08 to .15
// - the unit square and three vertices inside by chance:    1.6 to 1.7, .25 to .34, .19 to .30
// - the same, two of them on sides, or 3 : 4 rectangles:    1.67 to 1.73,  .25, .25 to .34
// - the square and the middles of two sides and of itself:  1.97      .69      .08 to .18
// - seven points at random and their Delaunay triangles:    1.42      .27     1.4
// Splits make a lattice in every triangle, more even when all are split alike, so that the three
// numbers tell the density: about 400 points on the hexagon's radius squared. With 40 turns they
// are 1.66, .58 and .22.
//
// The anisotropy of measureStipples, the variance of the power among frequencies of a ring, is
// 9 to 18 dB for every one of these, as spikes of a lattice are as thin as the window allows. The
// 3.3 dB are those of the power in sectors of 20 degrees, the strongest against the mean: 3.2 here
// whatever the seeds, 0.3 when randomised. (With sectors of 5, 10, 15, 30 degrees: 8.6, 6.0, 4.4,
// 1.8.) A spike is far above ten times the mean in a single set; averaged over ten orientations it
// is 10 to 60 times the mean of its ring.
TEST(StippleClassic, SplitsWithoutTheRandomiseOperatorMakeLines)
{
  const FigureSix left = meanOfFigureSix(false, 1.2);
  EXPECT_NEAR(left.metrics.clarkEvans, 1.68, 0.168);
  EXPECT_NEAR(left.metrics.relativeRadius, 0.58, 0.058);
  EXPECT_NEAR(left.metrics.lowFrequencyPower, 0.22, 0.022);
  EXPECT_NEAR(left.directions.strongest, 3.3, 0.33);
  EXPECT_GT(left.directions.spike, 10.0);
  EXPECT_GT(left.metrics.anisotropy, 3.3);
}

// rho is the least of 570 distances, and differs from seed to seed: the mean of sixty is .20 in
// this window, .19 in that of the test above, where R and the low frequencies are the same.
TEST(StippleClassic, SplitsWithItAreIsotropic)
{
  const FigureSix right = meanOfFigureSix(true, 1.0);
  EXPECT_NEAR(right.metrics.clarkEvans, 1.40, 0.14);
  EXPECT_NEAR(right.metrics.relativeRadius, 0.22, 0.022);
  EXPECT_NEAR(right.metrics.lowFrequencyPower, 0.28, 0.028);
  EXPECT_NEAR(right.metrics.anisotropy, 0.0, 0.33);
  EXPECT_LT(right.directions.strongest, 0.4);
  EXPECT_LT(right.directions.spike, 12.0);
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

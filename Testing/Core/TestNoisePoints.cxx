// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The points of a noise on a surface: a Poisson process that does not follow the triangles, nested
// over densities, the same for the same triangles wherever they are.

#include "NoiseScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

using namespace hachure;
using namespace hachure::testing;

namespace
{

Surface makeSquare(int n, double exponent = 1.0)
{
  Surface square;
  addGrid(square, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, n, exponent);
  return square;
}

glm::dvec3 placeOf(const Surface& surface, const NoisePoint& point)
{
  const glm::ivec3 corners = surface.triangles[point.triangle];
  const glm::dvec3 a = surface.points[corners.x];
  return a + point.weights.x * (surface.points[corners.y] - a) +
    point.weights.y * (surface.points[corners.z] - a);
}

// Variance over mean of the counts in 16 x 16 boxes.
double dispersion(const Surface& square, const std::vector<NoisePoint>& points)
{
  std::vector<double> counts(256, 0.0);
  for (const NoisePoint& point : points)
  {
    const glm::dvec3 place = placeOf(square, point);
    ++counts[static_cast<std::size_t>(place.x * 16.0) * 16 +
      static_cast<std::size_t>(place.y * 16.0)];
  }
  const double mean = static_cast<double>(points.size()) / 256.0;
  double sum = 0.0;
  for (const double count : counts)
  {
    sum += (count - mean) * (count - mean);
  }
  return sum / (255.0 * mean);
}

} // namespace

TEST(NoisePoints, ArePoissonWhateverTheTriangles)
{
  // Triangles of 1500 points to 1/40 of a point, of equal and of very different areas.
  for (const Surface& square : { makeSquare(1), makeSquare(3), makeSquare(16, 2.0), makeSquare(40),
         makeSquare(120, 3.0), makeSquare(250) })
  {
    double sum = 0.0;
    double squares = 0.0;
    double scatter = 0.0;
    const int trials = 24;
    for (int seed = 0; seed < trials; ++seed)
    {
      const NoiseSurface surface(square.mesh(), {}, {}, static_cast<std::uint32_t>(seed));
      const std::vector<NoisePoint> points = surface.points(3000.0);
      const double excess = static_cast<double>(points.size()) - 3000.0;
      sum += excess;
      squares += excess * excess;
      scatter += dispersion(square, points) / trials;
    }
    const std::size_t triangles = square.triangles.size();
    // Four standard errors.
    EXPECT_NEAR(sum / trials, 0.0, 4.0 * std::sqrt(3000.0 / trials)) << triangles;
    EXPECT_NEAR(squares / trials / 3000.0, 1.0, 4.0 * std::sqrt(2.0 / trials)) << triangles;
    EXPECT_NEAR(scatter, 1.0, 4.0 * std::sqrt(2.0 / (255.0 * trials))) << triangles;
  }
}

TEST(NoisePoints, AreUniformInTheirTriangleAndTheirDensities)
{
  const Surface square = makeSquare(1);
  const NoiseSurface surface(square.mesh());
  const std::vector<NoisePoint> points = surface.points(200000.0);
  glm::dvec2 mean(0.0);
  glm::dvec2 meanSquare(0.0);
  double meanBirth = 0.0;
  double mixed = 0.0;
  for (const NoisePoint& point : points)
  {
    EXPECT_GE(std::min(point.weights.x, point.weights.y), 0.0);
    EXPECT_LE(point.weights.x + point.weights.y, 1.0);
    const auto share = 1.0 / static_cast<double>(points.size());
    mean += point.weights * share;
    meanSquare += point.weights * point.weights * share;
    meanBirth += point.birth * share / 200000.0;
    mixed += (point.birth / 200000.0 - 0.5) * (point.weights.x - 1.0 / 3.0) * share;
  }
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(mean[i], 1.0 / 3.0, 0.0022);
    EXPECT_NEAR(meanSquare[i], 1.0 / 6.0, 0.0018);
  }
  EXPECT_NEAR(meanBirth, 0.5, 0.0027);
  EXPECT_NEAR(mixed, 0.0, 0.0007);
}

TEST(NoisePoints, AreNested)
{
  const Surface square = makeSquare(20, 2.0);
  const NoiseSurface surface(square.mesh());
  std::vector<NoisePoint> few = surface.points(700.0);
  const std::vector<NoisePoint> many = surface.points(50000.0);
  std::vector<NoisePoint> low;
  std::copy_if(many.begin(), many.end(), std::back_inserter(low),
    [](const NoisePoint& point) { return point.birth < 700.0; });
  EXPECT_GT(few.size(), 500u);
  EXPECT_EQ(sortedIds(few), sortedIds(low));
  const std::vector<std::uint64_t> ids = sortedIds(many);
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << "ids are unique";
}

TEST(NoisePoints, BelongToTheirTriangleAlone)
{
  const Surface square = makeSquare(60, 2.0);
  std::vector<std::uint64_t> ids(square.triangles.size());
  std::iota(ids.begin(), ids.end(), 1000u);
  Surface shuffled = square;
  std::vector<std::size_t> order(square.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  const std::size_t kept = order.size() / 2; // of the shuffled ones
  std::vector<std::uint64_t> shuffledIds;
  shuffled.triangles.clear();
  for (std::size_t i = 0; i < kept; ++i)
  {
    shuffled.triangles.push_back(square.triangles[order[i]]);
    shuffledIds.push_back(ids[order[i]]);
  }
  shuffled.patches.clear();
  for (const bool given : { true, false })
  {
    const auto none = Span<const std::uint64_t>();
    const NoiseSurface all(square.mesh(), given ? Span<const std::uint64_t>(ids) : none);
    const NoiseSurface part(shuffled.mesh(), given ? Span<const std::uint64_t>(shuffledIds) : none);
    std::vector<std::size_t> placeOfTriangle(order.size(), order.size());
    for (std::size_t i = 0; i < kept; ++i)
    {
      placeOfTriangle[order[i]] = i;
    }
    std::set<std::tuple<std::uint64_t, double, double, std::size_t>> expected, actual;
    for (const NoisePoint& point : all.points(40000.0))
    {
      const std::size_t place = placeOfTriangle[static_cast<std::size_t>(point.triangle)];
      if (place < kept)
      {
        expected.emplace(point.id, point.birth, point.weights.x, place);
      }
    }
    for (const NoisePoint& point : part.points(40000.0))
    {
      actual.emplace(
        point.id, point.birth, point.weights.x, static_cast<std::size_t>(point.triangle));
    }
    EXPECT_GT(actual.size(), 1000u);
    EXPECT_TRUE(actual == expected) << (given ? "ids" : "no ids");
  }
}

TEST(NoisePoints, StayWhereTheSurfaceDeforms)
{
  const Surface square = makeSquare(30);
  NoiseSurface surface(square.mesh());
  const std::vector<NoisePoint> before = surface.points(9000.0);
  Surface bent = square;
  for (glm::dvec3& point : bent.points)
  {
    point = glm::dvec3(3.0 * point.x, point.y * point.y, std::sin(5.0 * point.x));
  }
  surface.setPositions(bent.points);
  const std::vector<NoisePoint> after = surface.points(9000.0);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin(), after.end(),
    [](const NoisePoint& a, const NoisePoint& b)
    { return a.id == b.id && a.triangle == b.triangle && a.weights == b.weights; }));
}

TEST(NoisePoints, OddTrianglesHaveNone)
{
  EXPECT_TRUE(NoiseSurface(Surface().mesh()).points(1e6).empty());
  Surface surface = makeSquare(1);
  surface.points.push_back({ 0.5, 0.5, 0.0 });
  surface.points.push_back({ std::nan(""), 0.0, 0.0 }); // no triangle's
  surface.triangles.push_back({ 0, 0, 1 });
  surface.triangles.push_back({ 0, 4, 3 }); // on the diagonal
  surface.triangles.push_back(surface.triangles[0]);
  surface.patches.clear();
  int twice = 0;
  for (const NoisePoint& point : NoiseSurface(surface.mesh()).points(1000.0))
  {
    EXPECT_TRUE(point.triangle < 2 || point.triangle == 4);
    twice += point.triangle == 4 ? 1 : 0;
  }
  EXPECT_NEAR(twice, 500, 100);
}

TEST(NoisePoints, ScaleDoesNotMatter)
{
  const Surface square = makeSquare(5);
  std::vector<std::uint64_t> ids(square.triangles.size());
  std::iota(ids.begin(), ids.end(), 0u);
  const std::vector<NoisePoint> expected = NoiseSurface(square.mesh(), ids).points(4000.0);
  for (const int exponent : { -100, 100 }) // powers of two, so that nothing is rounded
  {
    Surface scaled = square;
    for (glm::dvec3& point : scaled.points)
    {
      point *= std::ldexp(1.0, exponent);
    }
    const NoiseSurface surface(scaled.mesh(), ids);
    // Octaves are those of the units, so the points are others, but as many.
    const std::vector<NoisePoint> points = surface.points(std::ldexp(4000.0, -2 * exponent));
    EXPECT_NEAR(static_cast<double>(points.size()), static_cast<double>(expected.size()), 360.0);
  }
}

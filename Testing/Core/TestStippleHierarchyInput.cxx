// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "Random.h"
#include "StippleScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

using namespace hachure;

namespace
{

std::string messageFor(const Surface& surface, const StippleOptions& options)
{
  return messageOf([&] { stippleSurface(surface.mesh(), options); });
}

std::vector<glm::dvec3> randomPoints(std::uint64_t count)
{
  std::vector<glm::dvec3> points;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    points.emplace_back(unitRandom(3, i, 0), unitRandom(3, i, 1), 0.0);
  }
  return points;
}

StippleOptions optionsFor(std::int64_t count)
{
  StippleOptions options;
  options.count = count;
  return options;
}

} // namespace

TEST(StippleHierarchyInput, OddMeshesAreStippledSilently)
{
  Surface surface;
  EXPECT_TRUE(stippleSurface(surface.mesh()).points.empty());
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 1e6, 1e-4, 0 } };
  surface.triangles = { { 0, 1, 3 }, { 0, 0, 2 } }; // neither has area
  EXPECT_TRUE(stippleSurface(surface.mesh()).points.empty());
  surface.triangles = { { 0, 1, 2 }, { 0, 1, 3 } };
  const StippleHierarchy one = stippleSurface(surface.mesh(), optionsFor(400));
  ASSERT_EQ(one.points.size(), 400u);
  for (const StipplePoint& point : one.points)
  {
    EXPECT_EQ(point.triangle, 0);
  }
  EXPECT_NEAR(one.area, 0.5, 1e-12);
  surface.triangles = { { 0, 1, 2 }, { 0, 1, 4 } }; // a needle of 50 times the area, 1e6 long
  EXPECT_EQ(stippleSurface(surface.mesh(), optionsFor(400)).points.size(), 400u);
  EXPECT_TRUE(stippleSurface(surface.mesh(), optionsFor(0)).points.empty());
}

TEST(StippleHierarchyInput, RepeatedTrianglesCountOnce)
{
  Surface surface = unitPlane(2);
  const StippleHierarchy expected = stippleSurface(surface.mesh(), optionsFor(500));
  const std::vector<glm::ivec3> once = surface.triangles;
  for (const glm::ivec3& triangle : once)
  {
    surface.triangles.emplace_back(triangle.y, triangle.z, triangle.x);
  }
  surface.patches.clear();
  const StippleHierarchy twice = stippleSurface(surface.mesh(), optionsFor(500));
  expectEqual(expected, twice, 500);
  EXPECT_EQ(expected.area, twice.area);
}

TEST(StippleHierarchyInput, ThreeSheetsAtAnEdgeAreStippledAlike)
{
  Surface fan; // a non-manifold edge along z
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.1 * i;
    addGrid(fan, { 0, 0, 0 }, { std::cos(angle), std::sin(angle), 0 }, { 0, 0, 1 }, 2);
  }
  int counts[3] = { 0, 0, 0 };
  for (const StipplePoint& point : stippleSurface(fan.mesh(), optionsFor(1500)).points)
  {
    ++counts[point.triangle / 8];
  }
  for (const int count : counts)
  {
    EXPECT_NEAR(count, 500, 30);
  }
}

TEST(StippleHierarchyInput, HugeExtentsGiveNoPoints)
{
  Surface surface;
  addGrid(surface, { -1.5e308, 0, 0 }, { 1e307, 0, 0 }, { 0, 1e307, 0 }, 1);
  addGrid(surface, { 1.5e308, 0, 0 }, { 1e307, 0, 0 }, { 0, 1e307, 0 }, 1);
  EXPECT_TRUE(stippleSurface(surface.mesh()).points.empty());
}

TEST(StippleHierarchyInput, WrongInputIsNamed)
{
  Surface quad = unitPlane(1);
  StippleOptions options;
  options.count = -1;
  EXPECT_NE(messageFor(quad, options).find("count: -1, expected 0 to"), std::string::npos);
  options = StippleOptions();
  options.leastMove = std::nan("");
  EXPECT_NE(messageFor(quad, options).find("leastMove: nan, expected 0 to 0.5"), std::string::npos);
  options = StippleOptions();
  options.mostMove = 0.1;
  EXPECT_NE(messageFor(quad, options).find("mostMove: 0.1"), std::string::npos);
  options = StippleOptions();
  quad.triangles[1].y = 4;
  EXPECT_NE(messageFor(quad, options).find("mesh.triangles[1]: corner 4"), std::string::npos);
  quad = unitPlane(1);
  quad.points[2].z = std::numeric_limits<double>::infinity();
  EXPECT_NE(messageFor(quad, options).find("mesh.points[2]"), std::string::npos);
}

TEST(StippleHierarchyInput, PointsWithoutAMeshAreRanked)
{
  const std::vector<glm::dvec3> points = randomPoints(3000);
  const StippleHierarchy all = stipplePoints(points);
  ASSERT_EQ(all.points.size(), 3000u);
  std::set<std::int32_t> ids;
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    ids.insert(all.points[i].triangle);
    ASSERT_LE(all.points[i].spacing, all.points[i == 0 ? 0 : i - 1].spacing);
  }
  EXPECT_EQ(ids.size(), 3000u);
  // The first 100 are far apart, although the points are at random.
  double smallest = 1.0;
  for (std::size_t i = 0; i < 100; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const auto a = static_cast<std::size_t>(all.points[i].triangle);
      const auto b = static_cast<std::size_t>(all.points[j].triangle);
      smallest = std::min(smallest, glm::length(points[a] - points[b]));
    }
  }
  EXPECT_GT(smallest, 0.065); // the widest possible is .107
  expectEqual(all, stipplePoints(points, {}, optionsFor(50)), 50);
}

TEST(StippleHierarchyInput, PointsInOnePlaceAreTakenOnceButOnBothSides)
{
  std::vector<glm::dvec3> points = randomPoints(200);
  const std::vector<glm::dvec3> once = points;
  points.insert(points.end(), once.begin(), once.end());
  EXPECT_EQ(stipplePoints(points).points.size(), 200u);
  std::vector<glm::dvec3> normals(200, { 0.0, 0.0, 1.0 });
  normals.resize(400, { 0.0, 0.0, -2.0 });
  EXPECT_EQ(stipplePoints(points, normals).points.size(), 400u);
  EXPECT_EQ(stipplePoints(std::vector<glm::dvec3>(5, { 1.0, 2.0, 3.0 })).points.size(), 1u);
  EXPECT_TRUE(stipplePoints({}).points.empty());
}

TEST(StippleHierarchyInput, WrongPointsAreNamed)
{
  std::vector<glm::dvec3> points = randomPoints(3);
  const std::vector<glm::dvec3> normals(2, glm::dvec3(1.0));
  EXPECT_NE(messageOf([&] { stipplePoints(points, normals); }).find("normals: 2 for 3 points"),
    std::string::npos);
  StippleOptions options;
  options.order = StippleOrder::Classic;
  EXPECT_NE(messageOf([&] { stipplePoints(points, {}, options); }).find("order: Classic"),
    std::string::npos);
  points[1].y = std::nan("");
  EXPECT_NE(messageOf([&] { stipplePoints(points); }).find("points[1]"), std::string::npos);
}

TEST(StippleHierarchyInput, ProgressRisesAndCanStop)
{
  const Surface plane = unitPlane(1);
  StippleOptions options = optionsFor(20000);
  StoppingProgress progress{ 40 };
  options.progress = [&](double fraction) { return progress.report(fraction); };
  EXPECT_TRUE(stippleSurface(plane.mesh(), options).points.empty());
  EXPECT_EQ(progress.calls, 40);
  EXPECT_GT(progress.last, 0.0);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatternMetricsStipples.h"
#include "StippleTreeScene.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace hachure;

namespace
{

// 12 triangles, the normals outward.
Surface unitCube()
{
  Surface cube;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 u(0.0), v(0.0), side(0.0);
    u[(axis + 1) % 3] = 1.0;
    v[(axis + 2) % 3] = 1.0;
    side[axis] = 1.0;
    addGrid(cube, side, u, v, 1);
    addGrid(cube, { 0, 0, 0 }, v, u, 1);
  }
  return cube;
}

// Of points on a plane z, in a square window.
StippleMetrics metricsOf(const std::vector<glm::dvec3>& points, const Box& window)
{
  std::vector<glm::dvec2> flat;
  flat.reserve(points.size());
  for (const glm::dvec3& point : points)
  {
    flat.emplace_back(point - window.low);
  }
  return measureStipples(flat, { { 0.0, 0.0 }, glm::dvec2(window.high - window.low), false });
}

// That every density in the window is even, and as many as wanted; the window is parallel to the
// plane of x and y and inside the surface.
void expectEven(const StippleTree& tree, const Box& window, double lowest, double highest)
{
  const glm::dvec3 size = window.high - window.low;
  double clarkEvans = 0.0;
  int count = 0;
  for (double density = lowest; density <= highest * 1.0001; density *= std::sqrt(2.0))
  {
    const std::vector<glm::dvec3> points = pointsIn(tree, window, density);
    const double wanted = density * size.x * size.y;
    EXPECT_NEAR(static_cast<double>(points.size()), wanted,
      0.02 * wanted + 1.5 * std::sqrt(std::sqrt(wanted)))
      << density;
    const StippleMetrics metrics = metricsOf(points, window);
    EXPECT_GE(metrics.clarkEvans, 1.69) << density;
    EXPECT_GT(metrics.relativeRadius, 0.64) << density;
    EXPECT_LT(metrics.lowFrequencyPower, 0.115) << density;
    EXPECT_LT(metrics.anisotropy, 1.0) << density;
    clarkEvans += metrics.clarkEvans;
    ++count;
  }
  EXPECT_GE(clarkEvans / count, 1.71);
}

// All nodes, also those that wait for others, by their cubes.
std::map<std::uint64_t, const StippleNode*> nodesByCode(const StippleTree& tree)
{
  std::map<std::uint64_t, const StippleNode*> result;
  for (const StippleNode& node : tree.nodes())
  {
    result[node.code] = &node;
  }
  return result;
}

void expectEqualNodes(const StippleTree& first, const StippleTree& second)
{
  const auto nodes = nodesByCode(first);
  const auto others = nodesByCode(second);
  ASSERT_EQ(nodes.size(), others.size());
  for (const auto& [code, node] : nodes)
  {
    ASSERT_EQ(others.count(code), 1u);
    const StippleNode& other = *others.at(code);
    ASSERT_EQ(node->lanes, other.lanes);
    ASSERT_EQ(node->referenceDensities, other.referenceDensities);
    ASSERT_EQ(node->childCount, other.childCount);
  }
}

const Box left = boxAround({ 0.2, 0.3, 0.0 }, { 0.05, 0.05, 1.0 });
const Box right = boxAround({ 0.27, 0.33, 0.0 }, { 0.06, 0.03, 1.0 });

} // namespace

TEST(StippleRefinement, EveryDensityIsEven)
{
  const Surface plane = unitPlane(1);
  StippleTree tree(plane.mesh(), baseOf(plane, 2000));
  const Box window = boxAround({ 0.41, 0.37, 0.0 }, { 0.2, 0.2, 1.0 });
  ASSERT_TRUE(refineIn(tree, window, 64000.0));
  expectEven(tree, window, 8000.0, 64000.0);
}

TEST(StippleRefinement, FineTriangulationsDoNotMatter)
{
  const Surface plane = unitPlane(150); // 20 triangles for a point of the base
  StippleTree tree(plane.mesh(), baseOf(plane, 2000));
  const Box window = boxAround({ 0.41, 0.37, 0.0 }, { 0.2, 0.2, 1.0 });
  ASSERT_TRUE(refineIn(tree, window, 64000.0));
  expectEven(tree, window, 8000.0, 64000.0);
}

TEST(StippleRefinement, CoarseCubesAreEvenFromNearby)
{
  const Surface cube = unitCube();
  const StippleHierarchy base = baseOf(cube, 1200); // 200 on a face
  for (const double zoom : { 64.0, 1000.0 })
  {
    StippleTree tree(cube.mesh(), base);
    const double highest = 200.0 * zoom * zoom;
    const Box window = boxAround({ 0.3712, 0.62971, 1.0 }, glm::dvec3(std::sqrt(1600.0 / highest)));
    ASSERT_TRUE(refineIn(tree, window, highest));
    expectEven(tree, window, 0.2 * highest, highest);
    // Over the edge, from both faces.
    const Box edge = boxAround({ 1.0, 0.5, 1.0 }, glm::dvec3(std::sqrt(1600.0 / highest)));
    ASSERT_TRUE(refineIn(tree, edge, highest));
    EXPECT_NEAR(pointsIn(tree, edge, highest).size(), 1600.0, 60.0);
  }
}

TEST(StippleRefinement, SpheresAreEven)
{
  const Surface sphere = unitSphere(204); // 500 000 triangles
  StippleTree tree(sphere.mesh(), baseOf(sphere, 3000));
  const Box cap = boxAround({ 0.0, 0.0, 1.0 }, { 2.0, 2.0, 0.02 });
  const double area = 2.0 * std::acos(-1.0) * 0.01;
  ASSERT_TRUE(refineIn(tree, cap, 20000.0));
  for (const double density : { 2000.0, 9000.0, 20000.0 })
  {
    const std::vector<glm::dvec3> points = pointsIn(tree, cap, density);
    EXPECT_NEAR(points.size(), area * density, 0.03 * area * density + 3.0);
    double smallest = 1.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        smallest = std::min(smallest, glm::length(points[i] - points[j]));
      }
    }
    EXPECT_GT(smallest, 0.6 * std::sqrt(2.0 / (std::sqrt(3.0) * density)));
  }
}

TEST(StippleRefinement, OrderDoesNotMatter)
{
  const Surface plane = unitPlane(5);
  const StippleHierarchy base = baseOf(plane, 2000);
  StippleTree forward(plane.mesh(), base), backward(plane.mesh(), base), once(plane.mesh(), base);
  constexpr int strips = 12;
  for (int i = 0; i < strips; ++i)
  {
    const auto strip = [](int k) {
      return boxAround({ (k + 0.5) / strips, 0.5, 0.0 }, { 1e-3, 1.0, 1.0 });
    };
    refineIn(forward, strip(i), 32000.0);
    for (const double density : { 3000.0, 10000.0, 32000.0 }) // in small steps
    {
      refineIn(backward, strip(strips - 1 - i), density);
    }
  }
  const Box everywhere;
  refineIn(forward, everywhere, 32000.0);
  refineIn(backward, everywhere, 32000.0);
  refineIn(once, everywhere, 32000.0);
  EXPECT_GT(namedPoints(once).size(), 30000u);
  expectEqualNodes(forward, backward);
  expectEqualNodes(forward, once);
}

TEST(StippleRefinement, APartIsAsInTheWhole)
{
  const Surface plane = unitPlane(5);
  const StippleHierarchy base = baseOf(plane, 2000);
  StippleTree part(plane.mesh(), base), whole(plane.mesh(), base);
  refineIn(part, left, 100000.0);
  refineIn(whole, right, 100000.0);
  refineIn(whole, { glm::min(left.low, right.low), glm::max(left.high, right.high) }, 100000.0);
  const std::map<std::uint64_t, NamedPoint> all = namedPoints(whole);
  const std::map<std::uint64_t, NamedPoint> points = namedPoints(part);
  EXPECT_GT(points.size(), 10000u);
  for (const auto& [identity, point] : points)
  {
    ASSERT_EQ(all.count(identity), 1u);
    ASSERT_TRUE(all.at(identity) == point);
  }
}

TEST(StippleRefinement, PointsThatAreThereStay)
{
  const Surface sphere = unitSphere(15);
  StippleTree tree(sphere.mesh(), baseOf(sphere, 2000));
  const Box box = boxAround({ 0.6, 0.0, 0.8 }, glm::dvec3(0.1));
  std::map<std::uint64_t, NamedPoint> before = namedPoints(tree);
  for (const double density : { 1e3, 1e4, 1e5 })
  {
    ASSERT_TRUE(refineIn(tree, box, density));
    const std::map<std::uint64_t, NamedPoint> after = namedPoints(tree);
    ASSERT_GT(after.size(), before.size());
    for (const auto& [identity, point] : before)
    {
      ASSERT_EQ(after.count(identity), 1u);
      ASSERT_TRUE(after.at(identity) == point);
    }
    before = after;
  }
}

TEST(StippleRefinement, ThreadsDoNotMatter)
{
  const Surface sphere = unitSphere(15);
  const StippleHierarchy base = baseOf(sphere, 2000);
  StippleTree one(sphere.mesh(), base), eight(sphere.mesh(), base);
  const Box box = boxAround({ 0.6, 0.0, 0.8 }, glm::dvec3(0.2));
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  refineIn(one, box, 20000.0);
  omp_set_num_threads(8);
  refineIn(eight, box, 20000.0);
  omp_set_num_threads(before);
  expectEqualNodes(one, eight);
}

TEST(StippleRefinement, ForgottenPointsComeBack)
{
  const Surface plane = unitPlane(2);
  StippleTree tree(plane.mesh(), baseOf(plane, 2000));
  const std::map<std::uint64_t, NamedPoint> base = namedPoints(tree);
  const std::size_t memory = tree.memory();
  refineIn(tree, left, 30000.0);
  const std::map<std::uint64_t, NamedPoint> refined = namedPoints(tree);
  tree.dropRefinements();
  EXPECT_TRUE(base == namedPoints(tree));
  EXPECT_LT(tree.memory(), memory + 60000u);
  refineIn(tree, left, 30000.0);
  EXPECT_TRUE(refined == namedPoints(tree));
}

TEST(StippleRefinement, TheBudgetIsKept)
{
  const Surface plane = unitPlane(2);
  const StippleHierarchy base = baseOf(plane, 2000);
  StippleTree all(plane.mesh(), base);
  ASSERT_TRUE(refineIn(all, Box(), 30000.0));
  const auto complete = nodesByCode(all);
  StippleTreeOptions options;
  for (const std::size_t budget : { 0u, 200000u, 700000u, 1200000u })
  {
    options.budget = budget;
    StippleTree tree(plane.mesh(), base, options);
    EXPECT_FALSE(refineIn(tree, Box(), 30000.0));
    EXPECT_LE(tree.refinedMemory(), budget + 5000u);
    visitNodes(tree, Box(),
      [&](const StippleNode& node, std::int32_t)
      {
        if (node.childCount > 0)
        {
          ASSERT_EQ(node.childCount, complete.at(node.code)->childCount);
        }
      });
  }
}

TEST(StippleRefinement, AMeshMayMoveMeanwhile)
{
  Surface plane = unitPlane(9);
  const StippleHierarchy base = baseOf(plane, 2000);
  StippleTree still(plane.mesh(), base), moved(plane.mesh(), base);
  refineIn(still, left, 60000.0);
  const Surface reference = plane;
  for (glm::dvec3& point : plane.points)
  {
    point = { 2.0 * point.x, 1.0 * point.y, std::sin(3.0 * point.x) };
  }
  refineIn(moved, left, 10000.0);
  moved.setPositions(plane.points);
  refineIn(moved, boxAround({ 0.4, 0.3, 0.5 }, { 0.1, 0.05, 1.0 }), 30000.0);
  const auto nodes = nodesByCode(still);
  int compared = 0;
  for (const StippleNode& node : moved.nodes())
  {
    if (nodes.count(node.code) == 0)
    {
      continue;
    }
    const StippleNode& other = *nodes.at(node.code);
    ++compared;
    ASSERT_EQ(node.referenceDensities, other.referenceDensities);
    for (std::int32_t i = 0; i < node.count; ++i)
    {
      ASSERT_EQ(node.places[i].triangle, other.places[i].triangle);
      ASSERT_EQ(node.places[i].weights, other.places[i].weights);
      const glm::dvec3 from = placeOf(other, i);
      ASSERT_NEAR(placeOf(node, i).x, 2.0 * from.x, 1e-6);
      ASSERT_NEAR(placeOf(node, i).y, from.y, 1e-6);
      ASSERT_LT(node.density()[i], 0.51 * other.density()[i]);
    }
  }
  EXPECT_GT(compared, 30);
  moved.setPositions(reference.points);
  visitNodes(moved, Box(),
    [&](const StippleNode& node, std::int32_t)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        ASSERT_FLOAT_EQ(node.density()[i], node.referenceDensities[i]);
      }
    });
}

TEST(StippleRefinement, TheSidesOfAThinWallDoNotThinEachOther)
{
  Surface plate;
  addGrid(plate, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  addGrid(plate, { 0, 0, -1e-4 }, { 0, 1, 0 }, { 1, 0, 0 }, 1);
  StippleTree tree(plate.mesh(), baseOf(plate, 2000));
  Box window = boxAround({ 0.41, 0.37, 0.0 }, { 0.3, 0.3, 1e-5 });
  ASSERT_TRUE(refineIn(tree, boxAround({ 0.41, 0.37, 0.0 }, { 0.3, 0.3, 1.0 }), 16000.0));
  expectEven(tree, window, 4000.0, 16000.0);
  window = boxAround({ 0.41, 0.37, -1e-4 }, { 0.3, 0.3, 1e-5 });
  EXPECT_NEAR(pointsIn(tree, window, 16000.0).size(), 1440.0, 40.0);
}

TEST(StippleRefinement, BordersHaveNeitherRowsNorEmptyStrips)
{
  const Surface plane = unitPlane(1);
  StippleTree tree(plane.mesh(), baseOf(plane, 1000));
  const Box corner = boxAround({ 0.0, 0.0, 0.0 }, { 0.4, 0.4, 1.0 });
  ASSERT_TRUE(refineIn(tree, corner, 32000.0));
  const std::vector<glm::dvec3> points = pointsIn(tree, corner, 32000.0);
  const double spacing = std::sqrt(2.0 / (std::sqrt(3.0) * 32000.0));
  EXPECT_NEAR(points.size(), 0.04 * 32000.0, 30.0);
  int near = 0;
  for (const glm::dvec3& point : points)
  {
    ASSERT_GT(point.x, 0.15 * spacing);
    near += point.x < 0.8 * spacing ? 1 : 0;
  }
  EXPECT_NEAR(near, 0.8 * spacing * 0.2 * 32000.0, 12.0);
}

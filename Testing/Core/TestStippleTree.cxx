// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StippleTree.h"

#include "CallTests.h"
#include "StippleTreeScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace hachure;

TEST(StippleTree, HasThePointsOfTheBase)
{
  const Surface sphere = unitSphere(20);
  const StippleHierarchy base = baseOf(sphere, 6000);
  const StippleTree tree(sphere.mesh(), base);
  std::vector<int> seen(base.points.size());
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t index)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        const auto rank = static_cast<std::size_t>(tree.identity(index, i));
        ASSERT_LT(rank, seen.size());
        ++seen[rank];
        const StipplePoint& point = base.points[rank];
        ASSERT_LT(glm::length(placeOf(node, i) - stipplePosition(sphere.mesh(), point)), 1e-7);
        ASSERT_LT(glm::length(directionOf(node, i) - glm::vec3(normalOf(sphere, point))), 1e-6f);
        ASSERT_FLOAT_EQ(node.density()[i], static_cast<float>((rank + 1) / base.area));
      }
    });
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 6000);
}

TEST(StippleTree, BoundsHoldWhatIsBelow)
{
  const Surface sphere = unitSphere(20);
  const StippleTree tree(sphere.mesh(), baseOf(sphere, 6000));
  int nodes = 0, largest = 0;
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t index)
    {
      ++nodes;
      largest = std::max(largest, node.count);
      for (std::int32_t above = index; above >= 0; above = tree.node(above).parent)
      {
        const StippleNode& outer = tree.node(above);
        for (std::int32_t i = 0; i < node.count; ++i)
        {
          ASSERT_LE(glm::length(placeOf(node, i) - outer.bounds.middle()),
            outer.bounds.radius * (1.0 + 1e-6));
          ASSERT_GE(glm::dot(directionOf(node, i), outer.bounds.axis), outer.bounds.cosine);
          ASSERT_GE(node.density()[i], outer.leastDensity);
          ASSERT_GE(node.density()[i], node.leastOfBlocks()[i / 8]);
        }
      }
    });
  EXPECT_LE(largest, 1500); // the root, a quarter of all
  EXPECT_LT(nodes, 200);
}

TEST(StippleTree, NumbersFollowDensity)
{
  const Surface sphere = unitSphere(20);
  const StippleTree tree(sphere.mesh(), baseOf(sphere, 6000));
  const double area = 4.0 * std::acos(-1.0);
  for (const double wanted : { 100.0, 1000.0, 3000.0, 6000.0 })
  {
    EXPECT_NEAR(pointsIn(tree, Box(), wanted / area).size(), wanted, 0.01 * wanted);
  }
}

TEST(StippleTree, PointsAreSmall)
{
  const Surface plane = unitPlane(1);
  const StippleTree tree(plane.mesh(), baseOf(plane, 6000));
  EXPECT_LE(tree.memory(), 52u * 6000u);
}

TEST(StippleTree, AStretchedMeshHasFewerPointsPerArea)
{
  Surface plane = unitPlane(7);
  const StippleHierarchy base = baseOf(plane, 5000);
  StippleTree tree(plane.mesh(), base);
  for (glm::dvec3& point : plane.points)
  {
    point = { 4.0 * point.x, 0.0, -0.5 * point.y };
  }
  tree.setPositions(plane.points);
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t index)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        const auto rank = static_cast<std::size_t>(tree.identity(index, i));
        const glm::dvec3 expected = stipplePosition(plane.mesh(), base.points[rank]);
        ASSERT_LT(glm::length(placeOf(node, i) - expected), 1e-6);
        ASSERT_LT(glm::length(directionOf(node, i) - glm::vec3(0, 1, 0)), 1e-6f);
        ASSERT_NEAR(node.density()[i] / (0.5 * (rank + 1) / base.area), 1.0, 1e-5);
        ASSERT_LE(glm::length(expected - node.bounds.middle()), node.bounds.radius + 1e-6);
      }
    });
  EXPECT_NEAR(tree.node(0).leastDensity, 0.5, 1e-5);
  EXPECT_EQ(pointsIn(tree, Box(), 1000.0).size(), 2000u);
}

TEST(StippleTree, TrianglesWithoutAreaHaveNoPoints)
{
  Surface plane = unitPlane(1);
  StippleTree tree(plane.mesh(), baseOf(plane, 1000));
  plane.points[2] = plane.points[0]; // the first triangle
  tree.setPositions(plane.points);
  int drawn = 0, never = 0;
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        ++(std::isinf(node.density()[i]) ? never : drawn);
        ASSERT_EQ(node.density()[i] < 1e30f, node.places[i].triangle != 0);
      }
    });
  EXPECT_NEAR(never, 500, 50);
  EXPECT_NEAR(drawn, 500, 50);
}

TEST(StippleTree, ClassicPointsAreStored)
{
  const Surface sphere = unitSphere(10);
  const StippleHierarchy base = baseOf(sphere, 3000, StippleOrder::Classic);
  StippleTree tree(sphere.mesh(), base);
  EXPECT_FALSE(tree.canRefine());
  std::size_t count = 0;
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t index)
    {
      for (std::int32_t i = 0; i < node.count; ++i, ++count)
      {
        const double spacing = base.points[tree.identity(index, i)].spacing;
        ASSERT_NEAR(node.density()[i] * spacing * spacing, 0.47, 1e-4);
      }
    });
  EXPECT_EQ(count, base.points.size());
  EXPECT_TRUE(refineIn(tree, Box(), 1e30)); // nothing can be asked for
  const StippleRequest request = { 0, 1e30 };
  tree.refine(Span<const StippleRequest>(&request, 1));
  EXPECT_EQ(namedPoints(tree).size(), base.points.size());
}

TEST(StippleTree, PointsWithoutAMeshAreStored)
{
  const std::vector<glm::dvec3> points = unitSphere(20).points;
  const StippleHierarchy base = stipplePoints(points, points);
  StippleTree tree(points, points, base);
  EXPECT_FALSE(tree.canRefine());
  EXPECT_EQ(namedPoints(tree).size(), base.points.size());
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        ASSERT_LT(glm::length(placeOf(node, i) - points[node.places[i].triangle]), 1e-6);
        ASSERT_NEAR(glm::dot(glm::dvec3(directionOf(node, i)), placeOf(node, i)), 1.0, 1e-5);
      }
    });
  const std::vector<glm::dvec3> place(5, { 1.0, 2.0, 3.0 });
  EXPECT_EQ(namedPoints(StippleTree(place, {}, stipplePoints(place))).size(), 1u);
  EXPECT_TRUE(StippleTree({}, {}, stipplePoints({})).nodes().empty());
}

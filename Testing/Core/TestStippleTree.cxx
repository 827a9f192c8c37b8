// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StippleTree.h"

#include "CallTests.h"
#include "StippleScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace hachure;

namespace
{

StippleHierarchy baseOf(const Surface& surface, std::int64_t count)
{
  StippleOptions options;
  options.count = count;
  return stippleSurface(surface.mesh(), options);
}

glm::dvec3 placeOf(const StippleNode& node, std::int32_t i)
{
  return node.origin + glm::dvec3(node.place(0)[i], node.place(1)[i], node.place(2)[i]);
}

glm::vec3 directionOf(const StippleNode& node, std::int32_t i)
{
  return { node.normal(0)[i], node.normal(1)[i], node.normal(2)[i] };
}

// Calls visit(node, index of the node) for all that are reached from the root.
template <class Visit>
void visitNodes(const StippleTree& tree, Visit&& visit)
{
  std::vector<std::int32_t> open;
  if (!tree.nodes().empty())
  {
    open.push_back(0);
  }
  while (!open.empty())
  {
    const std::int32_t index = open.back();
    const StippleNode& node = tree.node(index);
    open.pop_back();
    visit(node, index);
    open.insert(open.end(), node.children.begin(), node.children.begin() + node.childCount);
  }
}

} // namespace

TEST(StippleTree, HasThePointsOfTheBase)
{
  const Surface sphere = unitSphere(20);
  const StippleHierarchy base = baseOf(sphere, 20000);
  const StippleTree tree(sphere.mesh(), base);
  std::vector<int> seen(base.points.size());
  visitNodes(tree,
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
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 20000);
}

TEST(StippleTree, BoundsHoldWhatIsBelow)
{
  const Surface sphere = unitSphere(20);
  const StippleTree tree(sphere.mesh(), baseOf(sphere, 20000));
  int nodes = 0, largest = 0;
  visitNodes(tree,
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
  EXPECT_LT(largest, 1500);
  EXPECT_LT(nodes, 200);
}

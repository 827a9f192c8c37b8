// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "StippleTreeScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace hachure;

namespace
{

void expectMessage(const std::function<void()>& call, const char* part)
{
  const std::string message = messageOf(call);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

bool refineOne(StippleTree& tree, std::int32_t node, double density)
{
  const StippleRequest request = { node, density };
  return tree.refine(Span<const StippleRequest>(&request, 1));
}

} // namespace

TEST(StippleTreeInput, OddMeshesAreTakenSilently)
{
  Surface surface;
  EXPECT_TRUE(StippleTree(surface.mesh(), baseOf(surface, 100)).nodes().empty());
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 2, 0, 0 } };
  surface.triangles = { { 0, 1, 3 }, { 0, 0, 2 } }; // neither has area
  EXPECT_TRUE(StippleTree(surface.mesh(), baseOf(surface, 100)).nodes().empty());
  surface.triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 0 }, { 0, 1, 2 } };
  StippleTree tree(surface.mesh(), baseOf(surface, 500));
  ASSERT_TRUE(refineIn(tree, Box(), 8000.0));
  EXPECT_NEAR(namedPoints(tree).size(), 0.5 * 16000.0, 300.0); // levels are complete
  EXPECT_NEAR(pointsIn(tree, Box(), 8000.0).size(), 4000.0, 150.0);
}

TEST(StippleTreeInput, FewPointsAreRefined)
{
  const Surface sphere = unitSphere(4);
  for (const std::int64_t count : { 1, 2, 7, 30 })
  {
    const StippleHierarchy base = baseOf(sphere, count);
    StippleTree tree(sphere.mesh(), base);
    ASSERT_TRUE(refineIn(tree, Box(), 300.0)) << count;
    EXPECT_NEAR(pointsIn(tree, Box(), 300.0).size(), 300.0 * base.area, 0.03 * 300.0 * base.area)
      << count;
  }
}

TEST(StippleTreeInput, WrongInputIsNamed)
{
  Surface quad = unitPlane(1);
  StippleHierarchy base = baseOf(quad, 100);
  base.points[7].triangle = 2;
  expectMessage([&] { StippleTree(quad.mesh(), base); }, "base.points[7]: triangle 2 of 2");
  base = baseOf(quad, 100);
  base.points[3].weights[1] = std::nanf("");
  expectMessage([&] { StippleTree(quad.mesh(), base); }, "base.points[3]");
  base = baseOf(quad, 100);
  base.area = -1.0;
  expectMessage([&] { StippleTree(quad.mesh(), base); }, "base.area: -1");
  base = baseOf(quad, 100);
  const std::vector<glm::dvec3> points(2, glm::dvec3(1.0));
  expectMessage([&] { StippleTree(points, quad.points, stipplePoints(points)); }, "normals: 4");
  StippleTree tree(quad.mesh(), base);
  expectMessage([&] { tree.setPositions(points); }, "points: 2, expected 4");
  expectMessage([&] { tree.setPositions(quad.points, quad.points); }, "normals: 4, expected 0");
  expectMessage([&] { refineOne(tree, 1000, 1.0); }, "requests[0]: node 1000");
  expectMessage([&] { refineOne(tree, 0, std::nan("")); }, "requests[0]: node 0");
  quad.points[1].y = std::numeric_limits<double>::infinity();
  expectMessage([&] { tree.setPositions(quad.points); }, "points[1]: a coordinate is not finite");
  expectMessage([&] { StippleTree(quad.mesh(), base); }, "mesh.points[1]");
}

TEST(StippleTreeInput, ProgressCanStop)
{
  const Surface plane = unitPlane(1);
  const StippleHierarchy base = baseOf(plane, 5000);
  StippleTreeOptions options;
  StoppingProgress building{ 2 };
  options.progress = [&](double fraction) { return building.report(fraction); };
  const StippleTree stopped(plane.mesh(), base, options);
  EXPECT_TRUE(stopped.nodes().empty());
  EXPECT_EQ(building.calls, 2);
  StippleTree tree(plane.mesh(), base);
  const std::size_t before = tree.nodes().size();
  std::vector<StippleRequest> requests;
  for (std::size_t i = 0; i < before; ++i)
  {
    requests.push_back({ static_cast<std::int32_t>(i), 1e6 });
  }
  EXPECT_FALSE(tree.refine(requests, [](double) { return false; }));
  EXPECT_EQ(tree.nodes().size(), before);
  StoppingProgress all{ 1000 };
  EXPECT_TRUE(tree.refine(requests, [&](double fraction) { return all.report(fraction); }));
  EXPECT_GT(all.calls, 2);
  EXPECT_GT(tree.nodes().size(), before);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/TriangleRuns.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace hachure;

namespace
{
// The triangles of a point's run.
std::vector<std::int32_t> runOf(const TriangleRuns& runs, std::size_t point)
{
  std::vector<std::int32_t> found;
  std::int32_t record = runs.firstOfPoint[point];
  while (record >= 0)
  {
    found.push_back(runs.triangles[static_cast<std::size_t>(record)]);
    record = runs.goesOn[static_cast<std::size_t>(record)] != 0 ? record + 1 : -1;
  }
  return found;
}
using Numbers = std::vector<std::int32_t>;
} // namespace

TEST(TriangleRuns, EveryTriangleIsFoundByItsLastCorner)
{
  const std::vector<glm::ivec3> triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 3, 1, 2 }, { 4, 0, 3 } };
  const TriangleRuns runs = triangleRuns(6, triangles, {});
  EXPECT_EQ(runs.triangles.size(), triangles.size());
  EXPECT_EQ(runOf(runs, 2), (Numbers{ 0, 2 }));
  EXPECT_EQ(runOf(runs, 3), (Numbers{ 1, 3 }));
  for (const std::size_t point : { 0, 1, 4, 5 })
  {
    EXPECT_EQ(runs.firstOfPoint[point], -1);
  }
}

TEST(TriangleRuns, APolygonIsFoundByAnyCorner)
{
  const std::vector<glm::ivec3> triangles = { { 5, 0, 1 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } };
  const TriangleRuns runs = triangleRuns(6, triangles, Numbers{ 0, 1, 1, 1 });
  EXPECT_EQ(runOf(runs, 1), (Numbers{ 0, 1, 2, 3 }));
  for (const std::size_t point : { 0, 2, 3, 4 })
  {
    EXPECT_EQ(runOf(runs, point), (Numbers{ 1, 2, 3 }));
  }
  EXPECT_EQ(runs.firstOfPoint[5], -1);
}

TEST(TriangleRuns, NothingHasNoRuns)
{
  EXPECT_TRUE(triangleRuns(0, {}, {}).triangles.empty());
  EXPECT_EQ(triangleRuns(2, {}, {}).firstOfPoint, (Numbers{ -1, -1 }));
}

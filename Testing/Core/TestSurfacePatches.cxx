// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatches.h"

#include "TestSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

using namespace hachure;

namespace
{
/// A box of six grids that share no points: every edge is a seam.
Surface makeBox(int n, glm::dvec3 size = glm::dvec3(1.0))
{
  const glm::dvec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  Surface box;
  addGrid(box, {}, y, x, n);
  addGrid(box, {}, x, z, n);
  addGrid(box, {}, z, y, n);
  addGrid(box, z, x, y, n);
  addGrid(box, y, z, x, n);
  addGrid(box, x, y, z, n);
  box.patches.clear();
  return box;
}

std::int32_t countOf(const std::vector<std::int32_t>& patches)
{
  const std::set<std::int32_t> ids(patches.begin(), patches.end());
  // Dense: the numbers from 0 to count - 1.
  EXPECT_TRUE(ids.empty() || (*ids.begin() == 0 && *ids.rbegin() + 1 == int(ids.size())));
  return static_cast<std::int32_t>(ids.size());
}

/// The number of separate pieces, over edges, that the patches consist of.
int countPieces(const FaceSurface& surface, const std::vector<std::int32_t>& patches)
{
  const FaceGraph graph(surface);
  DisjointSets sets(patches.size());
  int pieces = static_cast<int>(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    for (const FaceNeighbour& other : graph.neighbours(static_cast<std::int32_t>(i)))
    {
      const auto a = sets.find(static_cast<std::int32_t>(i));
      if (patches[other.face] == patches[i] && sets.find(other.face) != a)
      {
        sets.join(a, other.face);
        --pieces;
      }
    }
  }
  return pieces;
}
} // namespace

TEST(SurfacePatches, JoinedPointsHoldSeamsTogether)
{
  const Surface box = makeBox(4);
  const auto vertices = joinPoints(box.points);
  EXPECT_EQ(*std::max_element(vertices.begin(), vertices.end()) + 1, 6 * 16 + 2);
  EXPECT_EQ(countOf(connectedPatches({ box.mesh(), {}, vertices })), 1);
  EXPECT_EQ(countOf(connectedPatches({ box.mesh(), {}, {} })), 6);
  const std::vector<std::int32_t> groups(box.points.size(), 0);
  EXPECT_EQ(joinPoints(box.points, groups), vertices);
}

TEST(SurfacePatches, NegativeZeroIsTheSamePlaceAndNotANumberIsNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 points[] = { { 0, 0, 0 }, { -0.0, 0, 0 }, { nan, 0, 0 }, { nan, 0, 0 } };
  EXPECT_EQ(joinPoints(points), (std::vector<std::int32_t>{ 0, 0, 1, 2 }));
}

TEST(SurfacePatches, CreasesBoundTheSidesOfABox)
{
  Surface box = makeBox(3);
  const auto vertices = joinPoints(box.points);
  const FaceSurface surface{ box.mesh(), {}, vertices };
  const auto sides = creasePatches(surface, 30.0);
  EXPECT_EQ(countOf(sides), 6);
  EXPECT_EQ(sides.front(), 0);
  EXPECT_EQ(sides.back(), 5);
  EXPECT_EQ(countOf(creasePatches(surface, 0.0)), 6);
  EXPECT_EQ(countOf(creasePatches(surface, 89.0)), 6);
  EXPECT_EQ(countOf(creasePatches(surface, 91.0)), 1);
  for (std::size_t i = 0; i < box.triangles.size(); i += 2)
  {
    std::swap(box.triangles[i].x, box.triangles[i].y); // turned over
  }
  EXPECT_EQ(creasePatches({ box.mesh(), {}, vertices }, 30.0), sides);
}

TEST(SurfacePatches, NonManifoldAndFlatFacesAreFollowed)
{
  // Three sheets meet in one edge: two continue each other, the third stands upright.
  Surface sheets;
  addGrid(sheets, { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2);
  addGrid(sheets, {}, { 1, 0, 0 }, { 0, 1, 0 }, 2);
  addGrid(sheets, {}, { 0, 0, 1 }, { 0, 1, 0 }, 2);
  sheets.triangles.push_back(sheets.triangles.front()); // a duplicate
  sheets.triangles.push_back({ 0, 1, 1 });              // without area, on the first sheet
  const auto vertices = joinPoints(sheets.points);
  const auto patches =
    creasePatches({ TriangleMesh{ sheets.points, sheets.triangles, {} }, {}, vertices }, 30.0);
  EXPECT_EQ(countOf(patches), 2);
  EXPECT_EQ(patches[0], patches[8]);
  EXPECT_NE(patches[0], patches[16]);
  EXPECT_EQ(patches[24], 0);
  EXPECT_EQ(patches[25], 0);
}

TEST(SurfacePatches, CompactPatchesAreConnectedRoundAndOfEqualSize)
{
  Surface strip; // 4 x 1, its triangles much denser at one end
  addGrid(strip, {}, { 4, 0, 0 }, { 0, 1, 0 }, 60, 2.0);
  strip.patches.clear();
  const FaceSurface surface{ strip.mesh(), {}, {} };
  CompactOptions options;
  options.patches = 4;
  const auto patches = compactPatches(surface, options);
  ASSERT_EQ(countOf(patches), 4);
  EXPECT_EQ(countPieces(surface, patches), 4);
  double areas[4] = {}, low[4] = { 9, 9, 9, 9 }, high[4] = {};
  const auto shapes = faceShapes(surface);
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    areas[patches[i]] += shapes[i].area;
    low[patches[i]] = std::min(low[patches[i]], shapes[i].centroid.x);
    high[patches[i]] = std::max(high[patches[i]], shapes[i].centroid.x);
  }
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(areas[i], 1.0, 0.3) << i;
    EXPECT_LT(high[i] - low[i], 1.6) << i;
  }
}

TEST(SurfacePatches, EveryPieceHasPatchesOfItsOwnWhereTheySuffice)
{
  Surface two;
  addGrid(two, {}, { 1, 0, 0 }, { 0, 1, 0 }, 20);
  addGrid(two, { 9, 0, 0 }, { 0.1, 0, 0 }, { 0, 0.1, 0 }, 2);
  addGrid(two, { 1.05, 0.4, 0 }, { 0.1, 0, 0 }, { 0, 0.1, 0 }, 2);
  two.patches.clear();
  const FaceSurface surface{ two.mesh(), {}, {} };
  CompactOptions options;
  for (const int count : { 3, 5, 50 })
  {
    options.patches = count;
    const auto patches = compactPatches(surface, options);
    EXPECT_EQ(countOf(patches), count);
    EXPECT_EQ(countPieces(surface, patches), count);
  }
  options.patches = 2; // more pieces than patches: the near one joins the large one
  const auto patches = compactPatches(surface, options);
  EXPECT_EQ(countOf(patches), 2);
  EXPECT_EQ(patches.back(), patches.front());
  options.patches = 100000; // more than faces
  EXPECT_EQ(countOf(compactPatches(surface, options)), surface.faceCount());
}

TEST(SurfacePatches, OddInputGivesTheRightResult)
{
  const Surface empty;
  EXPECT_TRUE(compactPatches({ empty.mesh(), {}, {} }, {}).empty());
  EXPECT_TRUE(creasePatches({ empty.mesh(), {}, {} }, 30.0).empty());
  EXPECT_TRUE(connectedPatches({ empty.mesh(), {}, {} }).empty());
  Surface flat; // three faces in one point
  flat.points.assign(3, glm::dvec3(1.0));
  flat.triangles.assign(3, { 0, 1, 2 });
  EXPECT_EQ(countOf(creasePatches({ flat.mesh(), {}, {} }, 30.0)), 1);
  CompactOptions options;
  options.patches = 2;
  EXPECT_EQ(countOf(compactPatches({ flat.mesh(), {}, {} }, options)), 2);
  options.progress = [](double) { return false; };
  EXPECT_TRUE(compactPatches({ flat.mesh(), {}, {} }, options).empty());
}

TEST(SurfacePatches, RanksAreDenseAndNegativeLabelsStayOut)
{
  std::vector<std::int32_t> patches;
  const std::vector<std::int64_t> labels{ 70, -5, 4, 70, 1ll << 40, -1 };
  EXPECT_EQ(rankPatches(labels, patches), 3);
  EXPECT_EQ(patches, (std::vector<std::int32_t>{ 1, -1, 0, 1, 2, -1 }));
}

TEST(SurfacePatches, WrongInputIsNamed)
{
  const Surface box = makeBox(1);
  const auto expectMessage = [](auto&& call, const std::string& expected)
  {
    try
    {
      call();
      ADD_FAILURE() << "expected: " << expected;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
  };
  const std::vector<std::int32_t> gap{ 0, 1, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3 };
  const std::vector<std::int32_t> few(3, 0);
  const FaceSurface surface{ box.mesh(), {}, {} };
  expectMessage(
    [&] {
      connectedPatches({ box.mesh(), gap, {} });
    },
    "surface.faces[3] is 3 after 1");
  expectMessage([&] { connectedPatches({ box.mesh(), few, {} }); }, "surface.faces: 3 values");
  expectMessage([&] { connectedPatches({ box.mesh(), {}, few }); }, "surface.vertices: 3 values");
  expectMessage([&] { creasePatches(surface, -1.0); }, "creaseAngle is -1.0");
  CompactOptions options;
  options.patches = 0;
  expectMessage([&] { compactPatches(surface, options); }, "patches is 0");
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchBlendWeights.h"

#include "TestSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace hachure;

namespace
{
float weightOf(const PatchBlend& blend, int patch)
{
  float weight = 0.0f;
  for (int i = 0; i < maximumBlendPatches; ++i)
  {
    weight += blend.patches[i] == patch ? blend.weights[i] : 0.0f;
  }
  return weight;
}

/// The plane from -1 to 1, patch 1 where x > 0, as two grids with points of their own.
Surface makeHalves(int n, double exponent = 1.0)
{
  Surface plane;
  addGrid(plane, { 0, -1, 0 }, { -1, 0, 0 }, { 0, 2, 0 }, n, exponent, 0);
  addGrid(plane, { 0, -1, 0 }, { 1, 0, 0 }, { 0, 2, 0 }, n, exponent, 1);
  return plane;
}

void expectWhole(const std::vector<PatchBlend>& blends)
{
  for (const PatchBlend& blend : blends)
  {
    double sum = 0.0;
    for (int i = 0; i < maximumBlendPatches; ++i)
    {
      sum += blend.weights[i];
      EXPECT_EQ(blend.patches[i] >= 0, blend.weights[i] > 0.0f);
      EXPECT_TRUE(i == 0 || blend.weights[i] <= blend.weights[i - 1]);
    }
    ASSERT_NEAR(sum, 1.0, 1e-6);
  }
}
} // namespace

TEST(PatchBlendWeights, HalfOnTheBorderAndZeroOutsideTheRings)
{
  const int n = 20;
  const Surface plane = makeHalves(n);
  const auto vertices = joinPoints(plane.points);
  for (const int rings : { 1, 2, 3, 8 })
  {
    for (const BlendStart start : { BlendStart::Equal, BlendStart::Faces })
    {
      BlendOptions options;
      options.rings = rings;
      options.start = start;
      const auto blends = patchBlendWeights({ plane.mesh(), {}, vertices }, options);
      expectWhole(blends);
      for (std::size_t i = 0; i < blends.size(); ++i)
      {
        const double x = plane.points[i].x * n;
        const float weight = weightOf(blends[i], 1);
        const bool isInner = std::abs(plane.points[i].y) < 1.0 - 2.0 * rings / n;
        if (std::abs(x) < 0.5)
        {
          EXPECT_NEAR(weight, 0.5, isInner ? 0.02 : 0.2) << rings << " " << plane.points[i].y;
        }
        else if (std::abs(x) > rings - 0.5)
        {
          EXPECT_EQ(weight, x > 0.0 ? 1.0f : 0.0f) << rings << " " << x;
        }
        else
        {
          EXPECT_TRUE(x > 0.0 ? weight > 0.5f && weight < 1.0f : weight > 0.0f && weight < 0.5f);
        }
      }
    }
  }
}

TEST(PatchBlendWeights, FourPatchesMeetInEqualPartsOrByFaces)
{
  Surface quarters; // 2 + 1 + 2 + 1 triangles meet in the middle
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0);
  addGrid(quarters, {}, x, y, 1, 1.0, 0);
  addGrid(quarters, {}, y, -x, 1, 1.0, 1);
  addGrid(quarters, -x, x, -y, 1, 1.0, 2);
  addGrid(quarters, {}, -y, x, 1, 1.0, 3);
  const auto vertices = joinPoints(quarters.points);
  BlendOptions options;
  PatchBlend middle = patchBlendWeights({ quarters.mesh(), {}, vertices }, options).front();
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(middle.patches[i], i);
    EXPECT_FLOAT_EQ(middle.weights[i], 0.25f);
  }
  options.start = BlendStart::Faces;
  middle = patchBlendWeights({ quarters.mesh(), {}, vertices }, options).front();
  EXPECT_FLOAT_EQ(weightOf(middle, 0), 2.0f / 7.0f);
  EXPECT_FLOAT_EQ(weightOf(middle, 2), 1.0f / 7.0f);
  const std::vector<std::int32_t> quads{ 0, 0, 1, 1, 2, 2, 3, 3 }; // each cut into two triangles
  middle = patchBlendWeights({ quarters.mesh(), quads, vertices }, options).front();
  EXPECT_FLOAT_EQ(weightOf(middle, 2), 0.25f);
}

TEST(PatchBlendWeights, FourOfManyPatchesAreKept)
{
  Surface fan; // seven patches meet in the middle; the last three have two triangles there
  fan.points.push_back({ 0, 0, 0 });
  for (int i = 0; i < 10; ++i)
  {
    fan.points.push_back({ std::cos(0.6283 * i), std::sin(0.6283 * i), 0 });
    fan.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % 10 });
    fan.patches.push_back(i < 4 ? i : 4 + (i - 4) / 2);
  }
  BlendOptions options;
  PatchBlend middle = patchBlendWeights({ fan.mesh(), {}, {} }, options).front();
  EXPECT_EQ(middle.patches, (std::array<std::int32_t, 4>{ 0, 1, 2, 3 }));
  EXPECT_FLOAT_EQ(middle.weights[3], 0.25f);
  options.start = BlendStart::Faces;
  middle = patchBlendWeights({ fan.mesh(), {}, {} }, options).front();
  EXPECT_EQ(middle.patches, (std::array<std::int32_t, 4>{ 4, 5, 6, 0 }));
  EXPECT_FLOAT_EQ(middle.weights[0], 2.0f / 7.0f);
  EXPECT_FLOAT_EQ(middle.weights[3], 1.0f / 7.0f);
}

TEST(PatchBlendWeights, CutsOfPolygonsAreNoNeighbours)
{
  Surface plane = makeHalves(10);
  const auto vertices = joinPoints(plane.points);
  std::vector<std::int32_t> quads;
  for (std::size_t i = 0; i < plane.triangles.size(); ++i)
  {
    quads.push_back(static_cast<std::int32_t>(i / 2));
  }
  BlendOptions options;
  options.rings = 2;
  const auto blends = patchBlendWeights({ plane.mesh(), quads, vertices }, options);
  for (std::size_t i = 0; i < blends.size(); ++i)
  {
    if (std::abs(plane.points[i].y) < 0.9 && std::abs(plane.points[i].x - 0.1) < 0.01)
    {
      EXPECT_FLOAT_EQ(weightOf(blends[i], 0), 0.125f); // (1/2 + 0 + 0 + 0) / 4 neighbours
    }
  }
}

TEST(PatchBlendWeights, DistanceDoesNotFollowTheTriangles)
{
  for (const double exponent : { 1.0, 2.0, 0.5 })
  {
    const Surface plane = makeHalves(40, exponent);
    const auto vertices = joinPoints(plane.points);
    BlendOptions options;
    options.width = BlendWidth::Distance;
    options.distance = 0.3;
    const auto blends = patchBlendWeights({ plane.mesh(), {}, vertices }, options);
    expectWhole(blends);
    for (std::size_t i = 0; i < blends.size(); ++i)
    {
      const double x = std::min(1.0, std::max(0.0, 0.5 + 0.5 * plane.points[i].x / 0.3));
      EXPECT_NEAR(weightOf(blends[i], 1), x * x * (3.0 - 2.0 * x), 1e-5) << plane.points[i].x;
    }
  }
}

TEST(PatchBlendWeights, DistancesAreStraightAcrossTriangles)
{
  // One triangle of patch 1 in the middle of a grid: at a distance the border is nearly a point.
  Surface plane;
  addGrid(plane, { -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 101);
  plane.patches[101 * 101 - 1] = 1;
  BlendOptions options;
  options.width = BlendWidth::Distance;
  options.distance = 0.8;
  const auto blends = patchBlendWeights({ plane.mesh(), {}, {} }, options);
  for (std::size_t i = 0; i < blends.size(); ++i)
  {
    const double distance = std::hypot(plane.points[i].x, plane.points[i].y);
    const double x = std::max(0.0, 0.5 - 0.5 * distance / 0.8);
    const double outside = x * x * (3.0 - 2.0 * x);
    const double inside = 1.0 - outside;
    EXPECT_NEAR(weightOf(blends[i], 1), outside / (outside + inside), 0.04) << distance;
  }
}

TEST(PatchBlendWeights, PointsOfNoPatchHaveNone)
{
  Surface plane = makeHalves(3);
  plane.points.push_back({ 5, 5, 5 });
  for (std::int32_t& patch : plane.patches)
  {
    patch = patch == 0 ? -1 : 7;
  }
  const auto vertices = joinPoints(plane.points);
  BlendOptions options;
  options.rings = 3;
  const auto blends = patchBlendWeights({ plane.mesh(), {}, vertices }, options);
  EXPECT_EQ(blends.back().patches[0], -1);
  EXPECT_EQ(blends.back().weights[0], 0.0f);
  EXPECT_EQ(blends.front().patches[0], 7); // the border with no patch is no border
  EXPECT_EQ(blends.front().weights[0], 1.0f);
  EXPECT_TRUE(patchBlendWeights({}).empty());
}

TEST(PatchBlendWeights, WrongOptionsAreNamed)
{
  BlendOptions options;
  options.rings = 0;
  EXPECT_THROW(patchBlendWeights({}, options), std::invalid_argument);
  options.rings = 1;
  options.distance = 0.0;
  try
  {
    patchBlendWeights({}, options);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("distance is 0"), std::string::npos) << error.what();
  }
}

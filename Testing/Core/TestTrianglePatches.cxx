// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/Random.h"
#include "Core/TrianglePatches.h"

#include <gtest/gtest.h>

using namespace hachure;

namespace
{

CornerPatches corner(std::array<int, 4> patches, glm::vec4 weights)
{
  return { patches, weights };
}

// Weights as the shader computes them from a record.
glm::vec4 weightsAt(const TrianglePatches& all, glm::vec3 point)
{
  const auto& r = all.records;
  return glsl::patchWeights(
    point, glm::vec3(r[0]), glm::vec3(r[1]), glm::vec3(r[2]), r[4], r[5], r[6]);
}

const std::array<glm::dvec3, 3> tilted{ glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(4.0, 2.5, 3.5),
  glm::dvec3(1.5, 5.0, 2.0) };

} // namespace

TEST(TrianglePatches, OnePatchTakesNoRecord)
{
  TrianglePatches all;
  appendTriangle(all, 7);
  const CornerPatches inside = corner({ 3, -1, -1, -1 }, glm::vec4(1, 0, 0, 0));
  appendTriangle(all, tilted, { inside, inside, inside });
  EXPECT_EQ(all.triangles, (std::vector<float>{ 7.0f, 3.0f }));
  EXPECT_TRUE(all.records.empty());
}

TEST(TrianglePatches, WeightsRunLinearlyBetweenTheCorners)
{
  TrianglePatches all;
  appendTriangle(all, tilted,
    { corner({ 5, -1, -1, -1 }, glm::vec4(1, 0, 0, 0)),
      corner({ 5, 9, -1, -1 }, glm::vec4(0.5, 0.5, 0, 0)),
      corner({ 9, 5, -1, -1 }, glm::vec4(0.8, 0.2, 0, 0)) });
  ASSERT_EQ(all.triangles.size(), 1u);
  EXPECT_EQ(all.triangles[0], -1.0f);
  ASSERT_EQ(all.records.size(), patchRecordTexels);
  EXPECT_EQ(all.records[0].w, 5.0f);
  EXPECT_EQ(all.records[1].w, 9.0f);
  for (int i = 0; i <= 10; ++i)
  {
    for (int j = 0; i + j <= 10; ++j)
    {
      const double b = i / 10.0;
      const double c = j / 10.0;
      const glm::vec3 point((1.0 - b - c) * tilted[0] + b * tilted[1] + c * tilted[2]);
      const glm::vec4 weights = weightsAt(all, point);
      EXPECT_NEAR(weights.x, (1.0 - b - c) + 0.5 * b + 0.2 * c, 1e-5);
      EXPECT_NEAR(weights.y, 0.5 * b + 0.8 * c, 1e-5);
    }
  }
}

TEST(TrianglePatches, TheHeaviestFourOfManyAreKept)
{
  TrianglePatches all;
  appendTriangle(all, tilted,
    { corner({ 0, 1, 2, 3 }, glm::vec4(0.4, 0.3, 0.2, 0.1)),
      corner({ 4, 0, 1, -1 }, glm::vec4(0.5, 0.3, 0.2, 0)),
      corner({ 2, 0, -1, -1 }, glm::vec4(0.5, 0.5, 0, 0)) });
  const glm::vec4 numbers(all.records[0].w, all.records[1].w, all.records[2].w, all.records[3].x);
  EXPECT_EQ(numbers, glm::vec4(0, 2, 1, 4)); // 1.2, .7, .5, .5: equal ones by number
  for (int i = 4; i < 7; ++i)
  {
    const glm::vec4 weights = all.records[static_cast<std::size_t>(i)];
    EXPECT_NEAR(weights.x + weights.y + weights.z + weights.w, 1.0f, 1e-6f);
  }
}

TEST(TrianglePatches, TrianglesWithoutAreaStayFinite)
{
  TrianglePatches all;
  const glm::dvec3 same(1.0, 1.0, 1.0);
  appendTriangle(all, { same, same, same },
    { corner({ 1, -1, -1, -1 }, glm::vec4(1, 0, 0, 0)),
      corner({ 2, -1, -1, -1 }, glm::vec4(1, 0, 0, 0)), corner({ -1, -1, -1, -1 }, {}) });
  const glm::vec4 weights = weightsAt(all, glm::vec3(5.0f));
  EXPECT_NEAR(weights.x + weights.y, 1.0f, 1e-6f);
}

TEST(TrianglePatches, MixedScreensAreUniformAfterTheirDistribution)
{
  const glm::vec4 mixes[] = { { 1, 0, 0, 0 }, { 0.5, 0.5, 0, 0 }, { 0.9, 0, 0.1, 0 },
    { 0.6, 0.3, 0.1, 0 }, { 0.25, 0.25, 0.25, 0.25 }, { 0.9, 0.05, 0.03, 0.02 } };
  constexpr int count = 40000;
  constexpr int bins = 20;
  for (const glm::vec4& mix : mixes)
  {
    std::array<int, bins> found{};
    for (int i = 0; i < count; ++i)
    {
      const auto id = static_cast<std::uint64_t>(i);
      float value = 0.0f;
      for (int k = 0; k < 4; ++k)
      {
        value += mix[k] * static_cast<float>(unitRandom(3, id, static_cast<std::uint32_t>(k)));
      }
      const float share = glsl::mixedShare(value, mix);
      ++found[static_cast<std::size_t>(std::min(share * bins, bins - 1.0f))];
    }
    for (const int number : found)
    {
      EXPECT_NEAR(number * bins / double(count), 1.0, 0.1) << mix.x << " " << mix.y;
    }
  }
}

TEST(TrianglePatches, SmallWeightsAreLeftOut)
{
  const glm::vec4 weights = glsl::relevantWeights(glm::vec4(0.6f, 0.39f, 0.01f, 0.0f));
  EXPECT_NEAR(weights.x, 0.6 / 0.99, 1e-6);
  EXPECT_EQ(weights.z, 0.0f);
  EXPECT_NEAR(weights.x + weights.y, 1.0f, 1e-6f);
}

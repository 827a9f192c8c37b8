// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/Random.h"
#include "Core/TrianglePatches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hachure;

namespace
{

CornerPatches corner(std::array<int, 4> patches, glm::vec4 weights)
{
  return { patches, weights };
}

const std::array<glm::dvec3, 3> tilted{ glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(4.0, 2.5, 3.5),
  glm::dvec3(1.5, 5.0, 2.0) };
// Shares an edge and its last corner with the first one.
const std::array<glm::dvec3, 3> beside{ glm::dvec3(-2.0, 3.0, 3.0), glm::dvec3(1.0, 2.0, 3.0),
  glm::dvec3(1.5, 5.0, 2.0) };

CornerPatches within(int patch)
{
  return corner({ patch, -1, -1, -1 }, glm::vec4(1, 0, 0, 0));
}

// In the first record.
glm::vec4 weightsAt(const PatchRecords& all, glm::vec3 point)
{
  const auto& shape = all.shapes;
  const glm::vec3 place =
    glsl::placeInTriangle(point, glm::vec3(shape[0]), glm::vec3(shape[1]), glm::vec3(shape[2]));
  const auto corner = [&](std::size_t i) { return glm::vec4(all.weights[i]) / 255.0f; };
  return glsl::patchWeights(place, corner(0), corner(1), corner(2));
}

// The record that the shader takes for a point of a triangle that ends at this vertex.
const glm::vec4* recordAt(const VertexPatches& all, std::size_t vertex, glm::vec3 point)
{
  auto record = static_cast<std::size_t>(-all.vertices[vertex] - 1.0f);
  const glm::vec4* best = nullptr;
  float bestFit = -1e30f;
  for (bool more = true; more; ++record)
  {
    const glm::vec4* tried = &all.records.shapes[recordShapes * record];
    const float fit =
      glsl::placeInTriangle(point, glm::vec3(tried[0]), glm::vec3(tried[1]), glm::vec3(tried[2])).z;
    best = fit > bestFit ? tried : best;
    bestFit = std::max(fit, bestFit);
    more = tried[0].w > 0.0f;
  }
  return best;
}

glm::vec3 pointOf(const std::array<glm::dvec3, 3>& triangle, double b, double c)
{
  return glm::vec3((1.0 - b - c) * triangle[0] + b * triangle[1] + c * triangle[2]);
}

} // namespace

TEST(TrianglePatches, VerticesOfOnePatchTakeNoRecord)
{
  TrianglePatches all;
  appendTriangle(all, 2, tilted, 7);
  appendTriangle(all, 2, beside, 7);
  appendTriangle(all, 1, beside, { within(3), within(3), within(3) });
  const VertexPatches found = patchesOfVertices(all, 4);
  EXPECT_EQ(found.vertices, (std::vector<float>{ 0.0f, 3.0f, 7.0f, 0.0f }));
  EXPECT_TRUE(found.records.shapes.empty());
}

TEST(TrianglePatches, WeightsRunLinearlyBetweenTheCorners)
{
  TrianglePatches all;
  appendTriangle(all, 0, tilted,
    { within(9), corner({ 9, 5, -1, -1 }, glm::vec4(0.5, 0.5, 0, 0)),
      corner({ 5, 9, -1, -1 }, glm::vec4(0.8, 0.2, 0, 0)) });
  const VertexPatches found = patchesOfVertices(all, 1);
  ASSERT_EQ(found.vertices.size(), 1u);
  EXPECT_EQ(found.vertices[0], -1.0f);
  ASSERT_EQ(found.records.shapes.size(), recordShapes);
  EXPECT_EQ(found.records.shapes[3], glm::vec4(5, 9, 5, 5)); // by number
  for (int i = 0; i <= 10; ++i)
  {
    for (int j = 0; i + j <= 10; ++j)
    {
      const double b = i / 10.0;
      const double c = j / 10.0;
      const glm::vec4 weights = weightsAt(found.records, pointOf(tilted, b, c));
      EXPECT_NEAR(weights.y, (1.0 - b - c) + 0.5 * b + 0.2 * c, 0.003);
      EXPECT_NEAR(weights.x, 0.5 * b + 0.8 * c, 0.003);
    }
  }
}

TEST(TrianglePatches, TheHeaviestFourOfManyAreKept)
{
  TrianglePatches all;
  appendTriangle(all, 0, tilted,
    { corner({ 0, 1, 2, 3 }, glm::vec4(0.4, 0.3, 0.2, 0.1)),
      corner({ 4, 0, 1, -1 }, glm::vec4(0.5, 0.3, 0.2, 0)),
      corner({ 2, 0, -1, -1 }, glm::vec4(0.5, 0.5, 0, 0)) });
  const VertexPatches found = patchesOfVertices(all, 1);
  EXPECT_EQ(found.records.shapes[3], glm::vec4(0, 1, 2, 4)); // 1.2, .5, .7, .5; 3 has .1
  ASSERT_EQ(found.records.weights.size(), recordWeights);
  for (const glm::ivec4 weights : found.records.weights)
  {
    EXPECT_NEAR(weights.x + weights.y + weights.z + weights.w, 255, 2);
  }
}

TEST(TrianglePatches, PointsFindTheirTriangleAmongThoseOfAVertex)
{
  TrianglePatches all;
  appendTriangle(all, 5, beside, 1);
  appendTriangle(all, 5, tilted, { within(2), within(2), within(3) });
  // Folded back over the first one: what lies above its plane belongs to the fold.
  auto folded = tilted;
  folded[1].z += 1.0;
  appendTriangle(all, 5, folded, 4);
  appendTriangle(all, 3, tilted, 8);
  const VertexPatches found = patchesOfVertices(all, 6);
  EXPECT_EQ(found.vertices[3], 8.0f);
  ASSERT_EQ(found.records.shapes.size(), 3 * recordShapes);
  for (int i = 1; i < 10; ++i)
  {
    for (int j = 1; i + j < 10; ++j)
    {
      const double b = i / 10.0;
      const double c = j / 10.0;
      EXPECT_EQ(recordAt(found, 5, pointOf(beside, b, c))[3].x, 1.0f) << b << " " << c;
      EXPECT_EQ(recordAt(found, 5, pointOf(tilted, b, c))[3].x, 2.0f) << b << " " << c;
      EXPECT_EQ(recordAt(found, 5, pointOf(folded, b, c))[3].x, 4.0f) << b << " " << c;
    }
  }
}

TEST(TrianglePatches, TrianglesWithoutAreaAreNotTaken)
{
  TrianglePatches all;
  const glm::dvec3 same(1.0, 1.0, 1.0);
  appendTriangle(all, 0, { same, same, same }, { within(1), within(2), within(1) });
  appendTriangle(all, 0, { same, same, same }, 6);
  appendTriangle(all, 0, tilted, 5);
  const VertexPatches found = patchesOfVertices(all, 1);
  for (const glm::vec3 point : { pointOf(tilted, 0.3, 0.3), pointOf(tilted, 0.9, 0.05) })
  {
    EXPECT_EQ(recordAt(found, 0, point)[3].x, 5.0f);
  }
}

TEST(TrianglePatches, MixedScreensAreUniform)
{
  const std::vector<float> mixes[] = { { 1.0f }, { 0.5f, 0.5f }, { 0.1f, 0.9f },
    { 0.6f, 0.3f, 0.1f }, { 0.25f, 0.25f, 0.25f, 0.25f }, { 0.02f, 0.9f, 0.05f, 0.03f } };
  constexpr int count = 40000;
  constexpr int bins = 20;
  for (const std::vector<float>& mix : mixes)
  {
    std::array<int, bins> found{};
    for (int i = 0; i < count; ++i)
    {
      glm::vec2 mixed(0.0f);
      float sum = 0.0f;
      for (std::size_t k = 0; k < mix.size(); ++k)
      {
        const auto value = static_cast<float>(
          unitRandom(3, static_cast<std::uint64_t>(i), static_cast<std::uint32_t>(k)));
        sum += mix[k];
        mixed = glsl::mixScreens(mixed, glm::vec2(value, 0.0f), mix[k] / sum);
      }
      ++found[static_cast<std::size_t>(std::min(mixed.x * bins, bins - 1.0f))];
    }
    for (const int number : found)
    {
      EXPECT_NEAR(number * bins / double(count), 1.0, 0.1) << mix.size() << " " << mix[0];
    }
  }
}

TEST(TrianglePatches, MixedScreensChangeAsTheirPartsDo)
{
  // Two screens that grow along x and along y: how the mix changes across a pixel.
  constexpr float step = 0.002f;
  for (const float part : { 0.0f, 0.2f, 0.5f, 0.9f, 1.0f })
  {
    const glm::vec2 first(0.37f, 3.0f * step);
    const glm::vec2 second(0.61f, step);
    const glm::vec2 here = glsl::mixScreens(first, second, part);
    const float alongX = glsl::mixScreens(first + glm::vec2(first.y, 0.0f), second, part).x;
    const float alongY = glsl::mixScreens(first, second + glm::vec2(second.y, 0.0f), part).x;
    EXPECT_NEAR(here.y, std::hypot(alongX - here.x, alongY - here.x), 0.05f * here.y) << part;
  }
}

TEST(TrianglePatches, SmallWeightsFadeOut)
{
  const float least = glsl::patchLeastWeight;
  for (const float small : { 0.0f, 0.5f * least, least, 1.01f * least, 2.0f * least })
  {
    const glm::vec4 weights = glsl::relevantWeights(glm::vec4(0.6f, 0.4f - small, small, 0.0f));
    const float rest = std::max(small - least, 0.0f);
    EXPECT_NEAR(weights.z, rest / (1.0f - 2.0f * least - std::min(small, least)), 1e-5f);
    EXPECT_EQ(weights.w, 0.0f);
    EXPECT_NEAR(weights.x + weights.y + weights.z, 1.0f, 1e-6f);
  }
  EXPECT_EQ(glsl::relevantWeights(glm::vec4(0.5f, 0.5f, 0.0f, 0.0f)), glm::vec4(0.5, 0.5, 0, 0));
}

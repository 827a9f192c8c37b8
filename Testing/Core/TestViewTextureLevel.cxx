// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/ViewTextureLevel.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <vector>

using namespace hachure;

namespace
{
const std::vector<glm::dvec3> points = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } };
const std::vector<glm::ivec3> triangles = { { 0, 1, 2 }, { 0, 2, 3 } };

// Of a square of side 2 that fills the picture from distance 1.
double levelFrom(double distance, double cellArea)
{
  const glm::dmat4 projection = glm::perspective(std::atan(1.0) * 2.0, 1.0, 0.01, 100.0);
  const glm::dmat4 view = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -distance));
  return levelOfSurface({ points, triangles, {} }, projection * view, { 64.0, 64.0 }, cellArea);
}
} // namespace

// 64 * 64 pixels on an area of 4: a cell of area 1 has 1024 pixels, which is a quarter five times.
TEST(ViewTextureLevel, CellsOfTheLevelAreOnePixelLarge)
{
  EXPECT_NEAR(levelFrom(1.0, 1.0), 5.0, 1e-5);
  EXPECT_NEAR(levelFrom(1.0, 0.25), 4.0, 1e-5);
  EXPECT_NEAR(levelFrom(2.0, 1.0), 4.0, 1e-5);
  EXPECT_NEAR(levelFrom(1.0, 1.0) - levelFrom(1.01, 1.0), std::log2(1.01), 1e-4);
}

TEST(ViewTextureLevel, NothingInFrontOfTheViewer)
{
  EXPECT_EQ(levelFrom(-1.0, 1.0), 0.0);
  EXPECT_EQ(levelOfSurface({ {}, {}, {} }, glm::dmat4(1.0), { 64.0, 64.0 }, 1.0), 0.0);
}

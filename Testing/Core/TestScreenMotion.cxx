// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScreenMotion.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

constexpr double farDistance = 2.0;

// A triangle far behind a picture of 8 x 8 pixels that it covers, and a nearer one.
struct TwoTriangles
{
  std::vector<glm::dvec3> before{ { -9, -9, -farDistance }, { 9, -9, -farDistance },
    { 0, 18, -farDistance }, { -9, -9, -1 }, { 9, -9, -1 }, { 0, 18, -1 } };
  std::vector<glm::dvec3> after = before;
  std::vector<glm::ivec3> triangles{ { 0, 1, 2 }, { 3, 4, 5 } };
  std::vector<std::int32_t> labels{ 1, 0 };
  std::vector<std::int32_t> seenBefore = std::vector<std::int32_t>(64, 0);
  std::vector<std::int32_t> seenAfter = std::vector<std::int32_t>(64, 0);
  glm::ivec2 size{ 8, 8 };

  std::vector<hachure::PixelMotion> motion() const
  {
    const glm::dmat4 projection = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0);
    hachure::MotionScene scene;
    scene.before = { this->before, projection, this->seenBefore };
    scene.after = { this->after, projection, this->seenAfter };
    scene.triangles = this->triangles;
    scene.labels = this->labels;
    scene.size = this->size;
    return hachure::screenMotion(scene);
  }

  std::string error() const
  {
    try
    {
      this->motion();
    }
    catch (const std::invalid_argument& argument)
    {
      return argument.what();
    }
    return "";
  }
};

TEST(ScreenMotion, ShiftIsTheSameEverywhere)
{
  TwoTriangles scene;
  for (glm::dvec3& point : scene.after)
  {
    point += glm::dvec3(0.25, -0.5, 0.0);
  }
  for (const hachure::PixelMotion& pixel : scene.motion())
  {
    EXPECT_NEAR(pixel.u, 4.0 * 0.25 / farDistance, 1e-6);
    EXPECT_NEAR(pixel.v, -4.0 * 0.5 / farDistance, 1e-6);
    EXPECT_NEAR(pixel.distance, farDistance, 1e-6);
    EXPECT_EQ(pixel.label, 1.0f);
  }
}

TEST(ScreenMotion, SlopeGivesPerspectiveMotion)
{
  // A plane leaning away upwards, z = -2 - y/2, moves by one towards the viewer.
  TwoTriangles scene;
  for (std::size_t i = 0; i < 3; ++i)
  {
    scene.before[i].z = -farDistance - 0.5 * scene.before[i].y;
    scene.after[i] = scene.before[i] + glm::dvec3(0.0, 0.0, 1.0);
  }
  const auto motion = scene.motion();
  for (int y = 0; y < 8; ++y)
  {
    const double slope = (y + 0.5 - 4.0) / 4.0; // y / -z
    const double depth = farDistance / (1.0 - 0.5 * slope);
    EXPECT_NEAR(motion[static_cast<std::size_t>(8 * y + 4)].distance, depth, 1e-5);
    EXPECT_NEAR(motion[static_cast<std::size_t>(8 * y + 4)].v,
      4.0 * slope * (depth / (depth - 1.0) - 1.0), 1e-5);
  }
}

TEST(ScreenMotion, HiddenAfterBehindANearerTriangle)
{
  TwoTriangles scene;
  scene.seenAfter.assign(64, 1);
  for (const hachure::PixelMotion& pixel : scene.motion())
  {
    EXPECT_EQ(pixel.visible, 0.0f);
  }
  scene.seenAfter.assign(64, 0);
  for (const hachure::PixelMotion& pixel : scene.motion())
  {
    EXPECT_EQ(pixel.visible, 1.0f);
  }
}

TEST(ScreenMotion, OccludersAndBackgroundAreZero)
{
  TwoTriangles scene;
  scene.seenBefore.assign(64, 1);
  scene.seenBefore[5] = hachure::nothingSeen;
  for (const hachure::PixelMotion& pixel : scene.motion())
  {
    EXPECT_EQ(pixel.label, 0.0f);
    EXPECT_EQ(pixel.distance, 0.0f);
    EXPECT_EQ(pixel.visible, 0.0f);
  }
}

TEST(ScreenMotion, WrongInputIsNamed)
{
  TwoTriangles scene;
  scene.after.pop_back();
  EXPECT_EQ(scene.error(), "screenMotion: after.points has 5 elements, expected 6");
  scene = TwoTriangles();
  scene.size = { 8, 0 };
  EXPECT_EQ(scene.error(), "screenMotion: size is 8 x 0, expected at least 1 x 1");
  scene = TwoTriangles();
  scene.seenAfter[7] = 2;
  EXPECT_EQ(scene.error(), "screenMotion: after.seen names triangle 2 of 2");
  scene = TwoTriangles();
  scene.triangles[1].z = 6;
  EXPECT_EQ(scene.error(), "screenMotion: triangles[1] names point 6 of 6");
  scene = TwoTriangles();
  scene.before[4].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(scene.error(), "screenMotion: before.points[4] is not finite");
}

} // namespace

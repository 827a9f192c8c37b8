// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "TileTests.h"
#include "ViewTextureScene.h"

#include "Core/HemisphereTable.h"
#include "Core/SrgbColor.h"
#include "Core/ViewTextureSample.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace hachure;

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// A surface with some colours at its nodes.
struct Colored
{
  Surface surface;
  SurfaceCells cells;
  SurfaceFrames frames;
  ViewTextureColors colors;

  Colored(const Surface& ofSurface, HemisphereMap map)
    : surface(ofSurface)
    , cells(trianglesAsCells(surface.mesh()))
    , frames(surfaceFrames(surface.mesh(), cells))
  {
    std::mt19937 random(1);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() >> 24); };
    colors.map = map;
    const auto nodes = static_cast<std::size_t>(cells.firstNode.back());
    colors.independent.resize(nodes);
    colors.dependent.resize(64 * nodes);
    for (std::vector<glm::u8vec4>* list : { &colors.independent, &colors.dependent })
    {
      for (glm::u8vec4& color : *list)
      {
        color = { byte() / 2, byte() / 2, byte() / 2, 128 };
      }
    }
  }
  std::vector<glm::u8vec4> seen(const ViewTextureCamera& camera) const
  {
    return viewTexturePointColors(surface.mesh(), cells, frames, colors, camera);
  }
};

ViewTextureCamera cameraFrom(const glm::dvec3& eye)
{
  ViewTextureCamera camera;
  camera.modelToClip = viewFrom(eye, glm::dvec3(0.0), 200, 200).modelToClip;
  camera.pictureSize = { 200.0, 200.0 };
  return camera;
}

void expectNear(const glm::vec3& found, const glm::vec3& expected, float most)
{
  EXPECT_LE(glm::length(found - expected), most)
    << found.x << " " << found.y << " " << found.z << " instead of " << expected.x << " "
    << expected.y << " " << expected.z;
}
} // namespace

TEST(ViewTextureSample, IsWhatIsStoredAtItsNodes)
{
  for (const HemisphereMap map : { HemisphereMap::Octahedral, HemisphereMap::Disk })
  {
    const Colored scene(sphereOf(1), map);
    const HemisphereTable table(map, scene.colors.hemisphere);
    const std::vector<NodePlace> places = nodePlaces(scene.surface.mesh(), scene.cells);
    const std::size_t chart = 5;
    for (const int level : { 0, 2, 4 })
    {
      const std::int64_t cellCount = std::int64_t{ 1 }
        << (2 * subdivisionsOf(scene.cells.charts[chart], level));
      for (std::int64_t cell = 0; cell < cellCount; ++cell)
      {
        const auto node = static_cast<std::size_t>(firstNodeOf(scene.cells, chart, level) + cell);
        const ViewTexturePlace place = viewTexturePlace(scene.cells, scene.frames, places[node]);
        ASSERT_EQ(place.place.chart, 5);
        const std::size_t direction = 27; // well inside of the square
        const glm::vec4 found = viewTextureColorAt(scene.cells, scene.colors, place,
          2.5f * (place.turn * table.directions()[direction]), static_cast<float>(level));
        const glm::u8vec4 front = scene.colors.dependent[64 * node + direction];
        const glm::u8vec4 behind = scene.colors.independent[node];
        const glm::vec3 expected = glm::vec3(linearOf({ front.r, front.g, front.b, 255 })) +
          127.0f / 255.0f * glm::vec3(linearOf({ behind.r, behind.g, behind.b, 255 }));
        expectNear(glm::vec3(found), expected, 2e-3f);
        EXPECT_NEAR(found.a, 1.0f, 1e-6f);
        const glm::vec4 base = viewTextureColorAt(scene.cells, scene.colors, place,
          place.turn * glm::vec3(0, 1, 0), static_cast<float>(level), 1.0f);
        expectNear(
          glm::vec3(base), glm::vec3(linearOf({ behind.r, behind.g, behind.b, 255 })), 2e-3f);
      }
    }
  }
}

TEST(ViewTextureSample, IsBetweenTwoLevels)
{
  const Colored scene(sphereOf(1), HemisphereMap::Octahedral);
  const ViewTexturePlace place =
    viewTexturePlace(scene.cells, scene.frames, { 7, glm::vec2(0.2f, 0.3f) });
  const auto at = [&](float level)
  {
    return glm::vec3(
      viewTextureColorAt(scene.cells, scene.colors, place, glm::vec3(1, 2, 3), level, 0.25f));
  };
  // All is opaque.
  expectNear(at(1.25f), 0.75f * at(1.0f) + 0.25f * at(2.0f), 0.01f);
  expectNear(at(-3.0f), at(0.0f), 0.0f);
  expectNear(at(9.0f), at(4.0f), 0.0f);
}

TEST(ViewTextureSample, ViewersOfMatrices)
{
  const glm::dvec4 eye = viewerOf(viewFrom({ 3, 4, -5 }, { 1, 1, 1 }, 20, 10).modelToClip);
  EXPECT_LT(glm::distance(eye, glm::dvec4(3, 4, -5, 1)), 1e-9);
  const glm::dvec4 side = viewerOf(glm::ortho(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0) *
    glm::lookAt(glm::dvec3(2, 0, 0), glm::dvec3(0.0), glm::dvec3(0, 1, 0)));
  EXPECT_EQ(side.w, 0.0);
  EXPECT_LT(glm::distance(glm::normalize(glm::dvec3(side)), glm::dvec3(1, 0, 0)), 1e-12);
}

// A plain view colours all points; a dependent one those that it sees, from near its camera.
TEST(ViewTextureSample, PointsHaveTheColoursOfViews)
{
  const Surface sphere = sphereOf(3);
  const SurfaceCells cells = trianglesAsCells(sphere.mesh());
  const SurfaceFrames frames = surfaceFrames(sphere.mesh(), cells);
  ViewTexture texture(sphere.mesh(), cells, frames);
  std::vector<TextureView> views = viewsAround(6, 100);
  TextureView front = viewFrom({ 0, 0, 4 }, glm::dvec3(0.0), 100, 100);
  front.dependent = true;
  front.extremes = extremesAround(front, 4, 1.2);
  views.push_back(front);
  texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const std::vector<glm::u8vec4> pixels =
      paint(views[i], plain(views[i].dependent ? redPixel : bluePixel));
    texture.setImage(i, { 100, 100, pixels });
  }
  const ViewTextureColors& colors = texture.colors();
  const auto seenFrom = [&](const glm::dvec3& eye, double share = 0.0)
  {
    ViewTextureCamera camera = cameraFrom(eye);
    camera.independentShare = share;
    return viewTexturePointColors(sphere.mesh(), cells, frames, colors, camera);
  };
  const std::vector<glm::u8vec4> own = seenFrom({ 0, 0, 4 });
  const std::vector<glm::u8vec4> base = seenFrom({ 0, 0, 4 }, 1.0);
  const std::vector<glm::u8vec4> behind = seenFrom({ 0, 0, -4 });
  ASSERT_EQ(own.size(), sphere.points.size());
  int inFront = 0;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    EXPECT_EQ(base[i], bluePixel);
    if (sphere.points[i].z > 0.8)
    {
      EXPECT_EQ(own[i].r, 255) << i;
      EXPECT_LE(own[i].b, 20) << i; // 0.7 % of the light
      ++inFront;
    }
    if (sphere.points[i].z < -0.3)
    {
      EXPECT_EQ(behind[i], bluePixel) << i;
    }
  }
  EXPECT_GT(inFront, 10);
}

TEST(ViewTextureSample, TheFacingSideOfACreaseCounts)
{
  // Two squares that meet at a right angle, and a point of no triangle.
  Surface roof;
  roof.points = { { -1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 1 }, { -1, 0, 1 }, { 1, -1, 1 }, { -1, -1, 1 },
    { 9, 9, 9 } };
  roof.triangles = { { 0, 3, 2 }, { 0, 2, 1 }, { 3, 5, 4 }, { 3, 4, 2 } };
  Colored scene(roof, HemisphereMap::Octahedral);
  std::fill(scene.colors.dependent.begin(), scene.colors.dependent.end(), glm::u8vec4(0));
  for (std::size_t chart = 0; chart < 4; ++chart)
  {
    for (std::int32_t node = scene.cells.firstNode[chart]; node < scene.cells.firstNode[chart + 1];
         ++node)
    {
      scene.colors.independent[static_cast<std::size_t>(node)] = chart < 2 ? redPixel : bluePixel;
    }
  }
  const std::vector<glm::u8vec4> above = scene.seen(cameraFrom({ 0.1, 5, 1 }));
  const std::vector<glm::u8vec4> front = scene.seen(cameraFrom({ 0.1, 1, 5 }));
  for (const std::size_t edge : { 2u, 3u })
  {
    EXPECT_EQ(above[edge], redPixel);
    EXPECT_EQ(front[edge], bluePixel);
  }
  EXPECT_EQ(above[6], glm::u8vec4(0));
}

TEST(ViewTextureSample, IsTheSameForAnyNumberOfThreads)
{
  const Colored scene(sphereOf(4), HemisphereMap::Disk);
  omp_set_num_threads(1);
  const std::vector<glm::u8vec4> one = scene.seen(cameraFrom({ 1, 2, 3 }));
  omp_set_num_threads(5);
  EXPECT_EQ(scene.seen(cameraFrom({ 1, 2, 3 })), one);
  omp_set_num_threads(omp_get_num_procs());
}

TEST(ViewTextureSample, OddSurfaces)
{
  const ViewTextureCamera camera = cameraFrom({ 0, 0, 4 });
  EXPECT_TRUE(viewTexturePointColors({}, trianglesAsCells({}), {}, {}, camera).empty());
  // Without colours nothing is seen.
  const Surface square = squareOf(1);
  const SurfaceCells cells = trianglesAsCells(square.mesh());
  for (const glm::u8vec4& color :
    viewTexturePointColors(square.mesh(), cells, surfaceFrames(square.mesh(), cells), {}, camera))
  {
    EXPECT_EQ(color, glm::u8vec4(0));
  }
}

TEST(ViewTextureSample, WrongInputIsNamed)
{
  Colored scene(squareOf(2), HemisphereMap::Octahedral);
  ViewTextureCamera camera = cameraFrom({ 0, 0, 4 });
  const auto message = [&] { return messageOf([&] { scene.seen(camera); }); };
  EXPECT_EQ(message(), "no error");
  camera.pictureSize.y = 0.0;
  EXPECT_EQ(message(), "camera.pictureSize is 0.000000; expected pixels, above 0");
  camera.pictureSize.y = 10.0;
  camera.independentShare = notANumber;
  EXPECT_EQ(message().substr(0, 27), "camera.independentShare is ");
  camera.independentShare = 0.0;
  camera.modelToClip[2][2] = notANumber;
  // With either sign.
  EXPECT_EQ(message().find("camera.modelToClip has the determinant "), 0u);
  EXPECT_NE(message().find("nan;"), std::string::npos);
  camera = cameraFrom({ 0, 0, 4 });
  scene.colors.independent.pop_back();
  EXPECT_EQ(message().substr(0, 20), "colors.independent: ");
  scene.colors.independent.clear();
  scene.frames.corners[0].x = 999;
  EXPECT_EQ(message().substr(0, 42), "frames.corners: triangle 0 has one that is");
  scene.frames.corners.pop_back();
  EXPECT_EQ(message(), "frames.corners: 7 for 8 triangles");
}

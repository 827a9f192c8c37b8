// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "CallTests.h"

#include "Core/ViewTexture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace hachure;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();

std::string messageFor(const std::function<void(TextureView&)>& change)
{
  TextureView view = viewFrom({ 0, 0, 4 }, glm::dvec3(0.0), 20, 10);
  change(view);
  return messageOf([&] { checkTextureView(view, "view"); });
}

void expectTexture(const Surface& surface)
{
  Textured scene(surface);
  std::vector<TextureView> views = viewsAround(3, 20);
  views[1].dependent = true;
  scene.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    scene.setImage(i, views[i], plain(redPixel));
  }
  const ViewTextureColors& colors = scene.texture.colors();
  EXPECT_EQ(colors.independent.size(), static_cast<std::size_t>(scene.nodes()));
  EXPECT_EQ(colors.dependent.size(), 64 * colors.independent.size());
  for (const glm::u8vec4& color : colors.independent)
  {
    EXPECT_TRUE(color.a == 0 || (color.r == 255 && color.g == 0 && color.b == 0));
  }
  scene.texture.nodeShares();
  scene.texture.colors(ViewTextureContent::DependentOnly);
}
} // namespace

TEST(ViewTextureInput, OddMeshes)
{
  expectTexture({});
  Surface one;
  one.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  one.triangles = { { 0, 1, 2 } };
  expectTexture(one);
  // The same triangle again, one turned over, ones without an area, and three at an edge.
  one.points.insert(one.points.end(), { { 0.5, 0.5, 1 }, { 0.2, -1, 0 }, { 2, 0, 0 } });
  one.triangles.insert(one.triangles.end(),
    { { 0, 1, 2 }, { 2, 1, 0 }, { 0, 0, 1 }, { 0, 1, 5 }, { 1, 2, 3 }, { 0, 1, 4 } });
  expectTexture(one);
  Surface nothing;
  nothing.points = { { 1, 1, 1 } };
  nothing.triangles = { { 0, 0, 0 } };
  expectTexture(nothing);
}

TEST(ViewTextureInput, RefusesWrongViews)
{
  EXPECT_EQ(messageFor([](TextureView&) {}), "no error");
  EXPECT_NE(messageFor([](TextureView& view) { view.modelToClip[1] = view.modelToClip[0]; })
              .find("view.modelToClip has the determinant"),
    std::string::npos);
  EXPECT_NE(
    messageFor([](TextureView& view) { view.modelToClip[2][1] = notANumber; }).find("modelToClip"),
    std::string::npos);
  EXPECT_NE(messageFor([](TextureView& view) { view.eye.y = notANumber; }).find("view.eye has the"),
    std::string::npos);
  EXPECT_NE(messageFor([](TextureView& view) { view.focus = view.eye; }).find("view.eye is 0"),
    std::string::npos);
  EXPECT_NE(messageFor([](TextureView& view) { view.width = 0; }).find("view.width is 0"),
    std::string::npos);
  EXPECT_NE(
    messageFor([](TextureView& view) { view.height = 100000; }).find("view.height is 100000"),
    std::string::npos);
  EXPECT_NE(messageFor(
              [](TextureView& view) {
                view.extremes = { glm::dvec3(1.0), glm::dvec3(notANumber) };
              })
              .find("view.extremes[1]"),
    std::string::npos);
  for (const std::vector<glm::dvec2>& curve :
    std::vector<std::vector<glm::dvec2>>{ {}, { { 0.5, 1.0 }, { 0.4, 0.0 } }, { { 0.0, 1.5 } },
      { { 1.2, 0.5 } }, { { notANumber, 0.5 } }, { { 0.5, -0.1 } } })
  {
    EXPECT_NE(messageFor([&](TextureView& view) { view.fadeCurve = curve; }).find("view.fadeCurve"),
      std::string::npos);
  }
}

TEST(ViewTextureInput, RefusesWrongImagesAndKeepsWhatItHas)
{
  Textured scene(squareOf(1));
  std::vector<TextureView> views(2, viewFrom({ 0, 0, 4 }, glm::dvec3(0.0), 20, 20));
  scene.texture.setViews(views);
  const std::vector<glm::u8vec4> pixels(400, redPixel);
  EXPECT_EQ(messageOf(
              [&] {
                scene.texture.setImage(2, { 20, 20, pixels });
              }),
    "view is 2; expected one of 2");
  EXPECT_NE(messageOf(
              [&] {
                scene.texture.setImage(0, { 20, 10, pixels });
              })
              .find("20 x 20"),
    std::string::npos);
  EXPECT_NE(messageOf(
              [&] {
                scene.texture.setImage(0, { 20, 20, Span<const glm::u8vec4>(pixels.data(), 399) });
              })
              .find("399"),
    std::string::npos);
  EXPECT_NE(messageOf([&] { scene.texture.depthOf(5); }).find("view is 5"), std::string::npos);
  scene.texture.setImage(0, { 20, 20, pixels });
  views[1].width = -1;
  EXPECT_NE(messageOf([&] { scene.texture.setViews(views); }).find("views[1].width is -1"),
    std::string::npos);
  EXPECT_EQ(scene.texture.viewCount(), 2u);
  const std::vector<glm::u8vec4>& colors = scene.texture.colors().independent;
  EXPECT_NE(std::find(colors.begin(), colors.end(), redPixel), colors.end());
}

TEST(ViewTextureInput, RefusesWrongSurfaces)
{
  Surface square = squareOf(1);
  const SurfaceCells cells = trianglesAsCells(square.mesh());
  const SurfaceFrames frames = surfaceFrames(square.mesh(), cells);
  ViewTextureOptions options;
  options.hemisphere = 5;
  EXPECT_NE(messageOf([&] { ViewTexture(square.mesh(), cells, frames, options); })
              .find("options.hemisphere is 5"),
    std::string::npos);
  const Surface other = squareOf(2);
  EXPECT_NE(messageOf([&] { ViewTexture(other.mesh(), cells, frames); }).find("8 triangles"),
    std::string::npos);
  SurfaceFrames wrong = frames;
  wrong.corners[1].y = 99;
  EXPECT_NE(messageOf([&] { ViewTexture(square.mesh(), cells, wrong); }).find("frame 99"),
    std::string::npos);
  square.points[2].x = notANumber;
  EXPECT_NE(messageOf([&] { ViewTexture(square.mesh(), cells, frames); }), "no error");
}

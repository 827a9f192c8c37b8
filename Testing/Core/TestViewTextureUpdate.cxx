// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "CallTests.h"
#include "TileTests.h"

#include "Core/ViewTexture.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

using namespace hachure;

namespace
{
// Of a clock on the wall, and of all threads together.
std::string secondsOf(const std::function<void()>& call)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t worked = std::clock();
  call();
  std::ostringstream text;
  text << std::setprecision(2)
       << std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() << " s ("
       << static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC << " of work)";
  return text.str();
}

Textured sphereScene()
{
  const Surface sphere = sphereOf(1);
  SurfaceCellOptions options;
  options.baseCells = 32;
  options.finestLevel = 3;
  return Textured(sphere, trianglesAsCells(sphere.mesh(), options));
}
} // namespace

// Prints how long an update takes after one image of many was changed; it fails on no time.
TEST(ViewTextureUpdate, TakesAMoment)
{
  std::vector<TextureView> views = viewsAround(20, 512);
  Textured scene(sphereOf(2));
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    views[i].dependent = i % 4 != 0;
    views[i].extremes = extremesAround(views[i], 4, 0.7);
  }
  scene.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    scene.setImage(i, views[i],
      [&](int column, int row)
      { return glm::u8vec4(column / 2, row / 2, 10 * i, (column / 32 + row / 32) % 2 * 255); });
  }
  const std::string all = secondsOf([&] { scene.texture.colors(); });
  scene.setImage(1, views[1], plain(redPixel));
  const std::string dependent = secondsOf([&] { scene.texture.colors(); });
  scene.setImage(0, views[0], plain(redPixel));
  const std::string independent = secondsOf([&] { scene.texture.colors(); });
  std::cout << scene.nodes() << " nodes, 20 views: all " << all << ", one dependent image "
            << dependent << ", one independent image " << independent << "\n";
  EXPECT_EQ(scene.texture.colors().independent.size(), static_cast<std::size_t>(scene.nodes()));
}

// Views come, go and change; what is kept makes no difference.
TEST(ViewTextureUpdate, GivesWhatANewTextureGives)
{
  std::vector<TextureView> views = viewsAround(4, 40);
  views[1].dependent = views[2].dependent = true;
  views[1].extremes = extremesAround(views[1], 4, 0.6);
  views[2].extremes = extremesAround(views[2], 3, 0.9);
  views[2].fadeMode = FadeMode::Middle;
  std::vector<Paint> paints = { plain(redPixel), plain(bluePixel),
    [](int column, int row) { return glm::u8vec4(4 * column, 3 * row, 80, 5 * column); },
    [](int column, int row) { return glm::u8vec4(3 * row, 4 * column, 80, 255); } };
  Textured scene = sphereScene();
  const auto expectSame = [&]
  {
    Textured fresh = sphereScene();
    fresh.texture.setViews(views);
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      fresh.setImage(i, views[i], paints[i]);
    }
    const ViewTextureColors& colors = scene.texture.colors();
    EXPECT_EQ(colors.independent, fresh.texture.colors().independent);
    EXPECT_EQ(colors.dependent, fresh.texture.colors().dependent);
    return colors.dependent;
  };
  scene.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    scene.setImage(i, views[i], paints[i]);
  }
  const std::vector<glm::u8vec4> before = expectSame();
  paints[2] = plain(redPixel);
  scene.setImage(2, views[2], paints[2]);
  EXPECT_NE(expectSame(), before);
  paints[0] = plain(bluePixel);
  scene.setImage(0, views[0], paints[0]);
  expectSame();
  views[1].extremes = extremesAround(views[1], 4, 0.4);
  scene.texture.setViews(views);
  expectSame();
  views[3].modelToClip = views[0].modelToClip;
  views[2].dependent = false;
  scene.texture.setViews(views);
  expectSame();
  views.pop_back();
  views.pop_back();
  scene.texture.setViews(views);
  expectSame();
}

TEST(ViewTextureUpdate, IsTheSameForAnyNumberOfThreads)
{
  std::vector<TextureView> views = viewsAround(5, 50);
  views[0].dependent = views[3].dependent = true;
  views[0].extremes = extremesAround(views[0], 4, 0.6);
  views[3].fadeMode = FadeMode::Middle;
  const auto both = withOneAndEightThreads(
    [&]
    {
      Textured scene = sphereScene();
      scene.texture.setViews(views);
      for (std::size_t i = 0; i < views.size(); ++i)
      {
        scene.setImage(i, views[i],
          [&](int column, int row)
          { return glm::u8vec4(5 * column, 5 * row, 40 * i, 20 * ((column + row) % 12)); });
      }
      return scene.texture.colors();
    });
  EXPECT_EQ(both.first.independent, both.second.independent);
  EXPECT_EQ(both.first.dependent, both.second.dependent);
}

TEST(ViewTextureUpdate, CanBeStoppedAndGoesOn)
{
  std::vector<TextureView> views = viewsAround(3, 40);
  views[1].dependent = true;
  Textured scene = sphereScene();
  scene.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    scene.setImage(i, views[i], plain(redPixel));
  }
  StoppingProgress all{ 1000 };
  Textured other = sphereScene();
  other.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    other.setImage(i, views[i], plain(redPixel));
  }
  const ViewTextureColors whole = other.texture.colors(
    ViewTextureContent::Combined, [&](double fraction) { return all.report(fraction); });
  EXPECT_EQ(all.last, 1.0);
  for (int most = 1; most < all.calls; most += 3)
  {
    StoppingProgress progress{ most };
    scene.setImage(1, views[1], plain(redPixel));
    scene.setImage(2, views[2], plain(redPixel));
    EXPECT_TRUE(scene.texture
                  .colors(ViewTextureContent::Combined,
                    [&](double fraction) { return progress.report(fraction); })
                  .independent.empty());
  }
  EXPECT_EQ(scene.texture.colors().independent, whole.independent);
  EXPECT_EQ(scene.texture.colors().dependent, whole.dependent);
}

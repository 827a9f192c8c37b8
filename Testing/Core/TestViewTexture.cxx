// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "TileTests.h"

#include "Core/Kernels.h"
#include "Core/NodePlaces.h"
#include "Core/ViewCellColors.h"
#include "Core/ViewTexture.h"
#include "Core/ViewTextureBase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>

using namespace hachure;

namespace
{
using Paint = std::function<glm::u8vec4(int column, int row)>;

std::vector<glm::u8vec4> paint(const TextureView& view, const Paint& color)
{
  std::vector<glm::u8vec4> pixels;
  pixels.reserve(static_cast<std::size_t>(view.width * view.height));
  for (int row = 0; row < view.height; ++row)
  {
    for (int column = 0; column < view.width; ++column)
    {
      pixels.push_back(color(column, row));
    }
  }
  return pixels;
}

struct Textured
{
  Surface surface;
  SurfaceCells cells;
  ViewTexture texture;

  Textured(const Surface& ofSurface, const SurfaceCells& ofCells,
    const ViewTextureOptions& options = {})
    : surface(ofSurface)
    , cells(ofCells)
    , texture(surface.mesh(), cells, surfaceFrames(surface.mesh(), cells), options)
  {
  }
  explicit Textured(const Surface& ofSurface, const ViewTextureOptions& options = {})
    : Textured(ofSurface, trianglesAsCells(ofSurface.mesh()), options)
  {
  }
  void setImage(std::size_t index, const TextureView& view, const Paint& color)
  {
    const std::vector<glm::u8vec4> pixels = paint(view, color);
    this->texture.setImage(index, { view.width, view.height, pixels });
  }
  std::int64_t nodes() const { return this->cells.firstNode.back(); }
};

const glm::u8vec4 red(255, 0, 0, 255);
const glm::u8vec4 blue(0, 0, 255, 255);
const glm::u8vec4 clear(0, 0, 0, 0);

Paint plain(const glm::u8vec4& color)
{
  return [color](int, int) { return color; };
}

// Cameras all around.
std::vector<TextureView> viewsAround(int count, int size)
{
  std::vector<TextureView> views;
  views.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const double height = 1.0 - (2.0 * i + 1.0) / count;
    const double around = 2.39996323 * i;
    const double side = std::sqrt(1.0 - height * height);
    views.push_back(viewFrom((3.2 + 0.1 * (i % 3)) *
        glm::dvec3(side * std::cos(around), height, side * std::sin(around)),
      glm::dvec3(0.0), size, size));
  }
  return views;
}

double secondsOf(const std::function<void()>& call)
{
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace

// Prints how long an update takes after one image of many was changed; it fails on no time.
TEST(ViewTexture, UpdateTakesAMoment)
{
  for (const double extremes : { 0.7, 0.0 })
  {
    std::vector<TextureView> views = viewsAround(20, 512);
    Textured scene(sphereOf(2), trianglesAsCells(sphereOf(2).mesh()));
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      views[i].dependent = i % 4 != 0;
      views[i].extremes = extremesAround(views[i], extremes > 0.0 ? 4 : 0, extremes);
    }
    scene.texture.setViews(views);
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      scene.setImage(i, views[i], [&](int column, int row)
        { return glm::u8vec4(column / 2, row / 2, 10 * i, (column / 32 + row / 32) % 2 * 255); });
    }
    const double all = secondsOf([&] { scene.texture.colors(); });
    scene.setImage(1, views[1], plain(red));
    const double dependent = secondsOf([&] { scene.texture.colors(); });
    scene.setImage(0, views[0], plain(red));
    const double independent = secondsOf([&] { scene.texture.colors(); });
    std::cout << scene.nodes() << " nodes, 20 views" << (extremes > 0.0 ? "" : " without extremes")
              << ": all " << all << " s, one image " << dependent << " s (dependent), "
              << independent << " s (independent)\n";
    EXPECT_EQ(scene.texture.colors().independent.size(), static_cast<std::size_t>(scene.nodes()));
  }
}

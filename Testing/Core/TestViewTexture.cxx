// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "Core/NodePlaces.h"
#include "Core/SrgbColor.h"
#include "Core/ViewCellColors.h"
#include "Core/ViewTexture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hachure;

namespace
{
// A view of the square of 2 from the front, so that it has a depth (level) with 32 cells of level
// 0.
TextureView viewOfDepth(double depth)
{
  constexpr double cells = 32.0;
  TextureView view;
  view.width = view.height = 400;
  view.parallel = true;
  const double scale = std::sqrt(cells * std::pow(4.0, depth)) / view.width;
  view.modelToClip = glm::scale(glm::dmat4(1.0), glm::dvec3(scale, scale, -0.1));
  view.eye = { 0, 0, 5 };
  return view;
}

Textured squareScene(const ViewTextureOptions& options = {})
{
  const Surface square = squareOf(4);
  SurfaceCellOptions cells;
  cells.baseCells = 32;
  return Textured(square, trianglesAsCells(square.mesh(), cells), options);
}

// Calls body(node) for all nodes of a level.
template <class Body>
void forNodes(const SurfaceCells& cells, int level, Body&& body)
{
  const CellLayer layer(cells, level);
  for (std::size_t i = 0; i < cells.charts.size(); ++i)
  {
    const auto chart = static_cast<std::int32_t>(i);
    const std::int64_t count = layer.firstLevelNodeOf(chart + 1) - layer.firstLevelNodeOf(chart);
    for (std::int64_t node = 0; node < count; ++node)
    {
      body(static_cast<std::size_t>(layer.firstNode(chart) + node));
    }
  }
}

glm::dvec3 placeOf(const Surface& surface, const NodePlace& place)
{
  const glm::ivec3& corners = surface.triangles[static_cast<std::size_t>(place.triangle)];
  const glm::dvec2 weights(place.weights);
  return (1.0 - weights.x - weights.y) * surface.points[static_cast<std::size_t>(corners.x)] +
    weights.x * surface.points[static_cast<std::size_t>(corners.y)] +
    weights.y * surface.points[static_cast<std::size_t>(corners.z)];
}

double linear(std::uint8_t byte)
{
  return linearOf({ byte, 0, 0, 255 }).r;
}

bool isClear(const glm::u8vec4& color)
{
  return color == glm::u8vec4(0);
}

// Of the square's points, seen from the front.
glm::vec3 smoothColor(const glm::dvec3& place)
{
  return { 0.5 + 0.3 * std::sin(2.0 * place.x), 0.5 + 0.3 * std::cos(1.5 * place.y),
    0.5 + 0.2 * place.x * place.y };
}
} // namespace

TEST(ViewTexture, SharesOfAllViewsSumToOne)
{
  Textured scene(sphereOf(1));
  std::vector<TextureView> views = viewsAround(7, 60);
  views[2].dependent = views[5].dependent = true;
  scene.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    scene.setImage(i, views[i],
      [&](int column, int row)
      { return glm::u8vec4(9, 9, 9, (column + row) % 7 == 0 ? 0 : 40 * i); });
  }
  const std::vector<std::vector<float>> shares = scene.texture.nodeShares();
  ASSERT_EQ(shares.size(), views.size());
  int mixed = 0;
  for (std::size_t node = 0; node < shares[0].size(); ++node)
  {
    double sum = 0.0;
    float most = 0.0f;
    for (const std::vector<float>& ofView : shares)
    {
      EXPECT_GE(ofView[node], 0.0f);
      sum += ofView[node];
      most = std::max(most, ofView[node]);
    }
    EXPECT_TRUE(std::abs(sum - 1.0) < 1e-5 || sum == 0.0) << sum;
    mixed += most < 0.9f ? 1 : 0;
  }
  EXPECT_GT(mixed, static_cast<int>(shares[0].size()) / 4);
}

// The paper's example: at level 3 views at depths 2.3 and 2.9 have .3/1.2 and .9/1.2.
TEST(ViewTexture, ViewsAtTwoDepthsShareALevel)
{
  Textured scene = squareScene();
  const std::vector<TextureView> views = { viewOfDepth(2.3), viewOfDepth(2.9) };
  scene.texture.setViews(views);
  scene.setImage(0, views[0], plain(redPixel));
  scene.setImage(1, views[1], plain(bluePixel));
  EXPECT_NEAR(scene.texture.depthOf(0), 2.3, 0.01);
  EXPECT_NEAR(scene.texture.depthOf(1), 2.9, 0.01);
  const ViewTextureColors& colors = scene.texture.colors();
  forNodes(scene.cells, 3,
    [&](std::size_t node)
    {
      EXPECT_NEAR(linear(colors.independent[node].r), 0.25, 0.02);
      EXPECT_NEAR(linear(colors.independent[node].b), 0.75, 0.02);
      EXPECT_EQ(colors.independent[node].a, 255);
    });
  forNodes(scene.cells, 2,
    [&](std::size_t node) { EXPECT_NEAR(linear(colors.independent[node].r), 0.7 / 0.8, 0.02); });
  const std::vector<std::vector<float>> shares = scene.texture.nodeShares();
  forNodes(scene.cells, 3, [&](std::size_t node) { EXPECT_NEAR(shares[1][node], 0.75, 0.02); });
}

// By the square of the cosine, 1/4 at 60 degrees; in the paper all count alike.
TEST(ViewTexture, ViewsFromAsideCountLess)
{
  for (const bool classic : { false, true })
  {
    ViewTextureOptions options;
    options.classicShares = classic;
    Textured scene = squareScene(options);
    std::vector<TextureView> views(2, viewOfDepth(2.0));
    views[1].eye = { 5.0 * std::sin(glm::radians(60.0)), 0.0, 2.5 };
    scene.texture.setViews(views);
    scene.setImage(0, views[0], plain(redPixel));
    scene.setImage(1, views[1], plain(bluePixel));
    const std::vector<std::vector<float>> shares = scene.texture.nodeShares();
    forNodes(scene.cells, 2,
      [&](std::size_t node) { EXPECT_NEAR(shares[1][node], classic ? 0.5 : 0.2, 0.002); });
  }
}

TEST(ViewTexture, CellsHaveTheColoursOfTheImage)
{
  Textured scene = squareScene();
  const TextureView view = viewOfDepth(3.4);
  scene.texture.setViews({ view });
  const double toModel = 1.0 / view.modelToClip[0][0];
  scene.setImage(0, view,
    [&](int column, int row)
    {
      const glm::dvec3 place(toModel * (2.0 * (column + 0.5) / view.width - 1.0),
        toModel * (2.0 * (row + 0.5) / view.height - 1.0), 0.0);
      return glm::u8vec4(255.0f * glm::clamp(smoothColor(place), 0.0f, 1.0f) + 0.5f, 255);
    });
  const ViewTextureColors& colors = scene.texture.colors();
  const std::vector<NodePlace> places = nodePlaces(scene.surface.mesh(), scene.cells);
  for (const int level : { 3, 4 })
  {
    forNodes(scene.cells, level,
      [&](std::size_t node)
      {
        const glm::dvec3 place = placeOf(scene.surface, places[node]);
        const glm::vec3 expected = 255.0f * smoothColor(place);
        for (int channel = 0; channel < 3; ++channel)
        {
          EXPECT_NEAR(colors.independent[node][channel], expected[channel], 6.0f);
        }
      });
  }
}

TEST(ViewTexture, NothingKnownIsGray)
{
  Textured scene = squareScene();
  const auto expectGray = [&]
  {
    const ViewTextureColors& colors = scene.texture.colors();
    ASSERT_EQ(colors.independent.size(), static_cast<std::size_t>(scene.nodes()));
    ASSERT_EQ(colors.dependent.size(), 64 * colors.independent.size());
    for (const glm::u8vec4& color : colors.independent)
    {
      EXPECT_EQ(color, glm::u8vec4(128, 128, 128, 0));
    }
    EXPECT_TRUE(std::all_of(colors.dependent.begin(), colors.dependent.end(), isClear));
  };
  expectGray();
  const TextureView view = viewOfDepth(2.0);
  scene.texture.setViews({ view });
  expectGray(); // no image
  scene.setImage(0, view, plain(clearPixel));
  expectGray(); // all masked
}

// What is seen with a mask of 0 stays as it is; what is not seen is filled.
TEST(ViewTexture, OnlyUnseenCellsAreFilled)
{
  ViewTextureOptions options;
  options.propagateUp = false;
  Textured scene = squareScene(options);
  TextureView view = viewOfDepth(3.2);
  scene.texture.setViews({ view });
  // The image ends at x = 0; left half of what is there is masked.
  view.modelToClip = glm::translate(glm::dmat4(1.0), glm::dvec3(1.0, 0.0, 0.0)) *
    glm::scale(view.modelToClip, glm::dvec3(1.0));
  scene.texture.setViews({ view });
  const double toModel = 1.0 / view.modelToClip[0][0];
  const auto modelX = [&](int column)
  { return toModel * (2.0 * (column + 0.5) / view.width - 2.0); };
  scene.setImage(
    0, view, [&](int column, int) { return modelX(column) < -0.5 ? clearPixel : redPixel; });
  const ViewTextureColors& colors = scene.texture.colors();
  const std::vector<NodePlace> places = nodePlaces(scene.surface.mesh(), scene.cells);
  int filled = 0;
  forNodes(scene.cells, 4,
    [&](std::size_t node)
    {
      const double x = placeOf(scene.surface, places[node]).x;
      const bool isKnown = colors.independent[node].a > 0;
      EXPECT_FALSE(isKnown && x < -0.6) << x;
      EXPECT_FALSE(!isKnown && x > -0.4 && x < 0.05) << x;
      filled += isKnown && x > 0.05 ? 1 : 0;
      // Half the size of a cell of level 0, and no more.
      EXPECT_FALSE(isKnown && x > 0.3) << x;
    });
  EXPECT_GT(filled, 100);
}

TEST(ViewTexture, LevelsWithoutViewsTakeThoseNextToThem)
{
  for (const bool propagateUp : { true, false })
  {
    ViewTextureOptions options;
    options.propagateUp = propagateUp;
    Textured scene = squareScene(options);
    TextureView view = viewOfDepth(2.0);
    TextureView dependent = view;
    dependent.dependent = true;
    dependent.extremes = { glm::dvec3(3, 0, 4) };
    scene.texture.setViews({ view, dependent });
    ASSERT_NEAR(scene.texture.depthOf(0), 2.0, 0.02);
    scene.setImage(0, view, plain(redPixel));
    scene.setImage(1, dependent, plain(bluePixel));
    const ViewTextureColors& colors = scene.texture.colors();
    for (int level = 0; level <= 4; ++level)
    {
      const bool isKnown = level <= 3 || propagateUp; // 3: of the depth's rounding
      forNodes(scene.cells, level,
        [&](std::size_t node)
        {
          EXPECT_EQ(colors.independent[node].a, isKnown ? 255 : 0) << level;
          int shares = 0;
          for (std::size_t i = 0; i < 64; ++i)
          {
            shares += colors.dependent[64 * node + i].a;
          }
          EXPECT_EQ(shares > 0, isKnown) << level;
        });
    }
  }
}

// A coarse view of all, and a fine one whose mask leaves only the right half. What is seen from
// everywhere goes on from the coarse one where the fine one says nothing; what is seen from some
// directions does not in those of the fine view, which has no mark there.
TEST(ViewTexture, MasksOfFineViewsOverCoarseOnes)
{
  Textured scene = squareScene();
  std::vector<TextureView> views = { viewOfDepth(1.5), viewOfDepth(3.5), viewOfDepth(1.5),
    viewOfDepth(3.5) };
  views[2].dependent = views[3].dependent = true;
  views[3].extremes = { glm::dvec3(3, 0, 4) };
  scene.texture.setViews(views);
  for (const std::size_t all : { 0, 2 })
  {
    scene.setImage(all, views[all], plain(redPixel));
  }
  for (const std::size_t half : { 1, 3 })
  {
    scene.setImage(half, views[half],
      [&](int column, int) { return column < views[half].width / 2 ? clearPixel : bluePixel; });
  }
  const ViewTextureColors& colors = scene.texture.colors();
  const std::vector<NodePlace> places = nodePlaces(scene.surface.mesh(), scene.cells);
  forNodes(scene.cells, 4,
    [&](std::size_t node)
    {
      const double x = placeOf(scene.surface, places[node]).x;
      if (std::abs(x) < 0.1)
      {
        return;
      }
      EXPECT_EQ(colors.independent[node], x < 0.0 ? redPixel : bluePixel) << x;
      // The middle of the hemisphere is within the fine view's range, its corners are not.
      const glm::u8vec4& middle = colors.dependent[64 * node + 8 * 4 + 4];
      EXPECT_EQ(middle.a, x < 0.0 ? 0 : 255) << x;
      EXPECT_EQ(middle.b > 0, x > 0.0);
      EXPECT_EQ(colors.dependent[64 * node], redPixel);
    });
}

// A rotation has two quaternions.
TEST(ViewTexture, SignsOfFramesDoNotMatter)
{
  const Surface sphere = sphereOf(1);
  const SurfaceCells cells = trianglesAsCells(sphere.mesh());
  SurfaceFrames frames = surfaceFrames(sphere.mesh(), cells);
  TextureView view = viewFrom({ 0, 1, 4 }, glm::dvec3(0.0), 100, 100);
  view.dependent = true;
  view.extremes = extremesAround(view, 4, 0.7);
  const std::vector<glm::u8vec4> pixels(10000, redPixel);
  const auto make = [&]
  {
    ViewTexture texture(sphere.mesh(), cells, frames);
    texture.setViews({ view });
    texture.setImage(0, { 100, 100, pixels });
    return texture.colors().dependent;
  };
  const std::vector<glm::u8vec4> before = make();
  for (std::size_t i = 0; i < frames.turns.size(); i += 2)
  {
    frames.turns[i] = -frames.turns[i];
  }
  const std::vector<glm::u8vec4> after = make();
  int most = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    most = std::max(most, std::abs(before[i].a - after[i].a));
  }
  EXPECT_LE(most, 1);
}

// At its finer level a view's own mask is not blurred by its coarser one.
TEST(ViewTexture, MasksStayWhereTheyAre)
{
  Textured scene = squareScene();
  const TextureView view = viewOfDepth(3.5);
  scene.texture.setViews({ view });
  scene.setImage(
    0, view, [&](int column, int) { return column < view.width / 2 ? clearPixel : bluePixel; });
  const ViewTextureColors& colors = scene.texture.colors();
  const std::vector<NodePlace> places = nodePlaces(scene.surface.mesh(), scene.cells);
  forNodes(scene.cells, 4,
    [&](std::size_t node)
    {
      const double x = placeOf(scene.surface, places[node]).x;
      constexpr double cell = 0.5 / 16.0;
      if (std::abs(x) > cell)
      {
        EXPECT_EQ(colors.independent[node].a, x < 0.0 ? 0 : 255) << x;
      }
    });
}

// Independent views are red, dependent ones blue, at several levels.
TEST(ViewTexture, NothingIndependentIsCopiedToDependent)
{
  Textured scene(sphereOf(2));
  std::vector<TextureView> views = viewsAround(8, 100);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const int size = i < 4 ? 30 : 100;
    views[i].width = views[i].height = size;
    views[i].dependent = i % 2 == 0;
    views[i].extremes = extremesAround(views[i], 5, 0.5);
  }
  scene.texture.setViews(views);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    scene.setImage(i, views[i], plain(views[i].dependent ? bluePixel : redPixel));
  }
  const ViewTextureColors& colors = scene.texture.colors();
  int empty = 0, some = 0;
  for (const glm::u8vec4& color : colors.dependent)
  {
    EXPECT_EQ(color.r, 0);
    // Blue times the share.
    EXPECT_NEAR(linear(color.b), color.a / 255.0, 0.01);
    (isClear(color) ? empty : some) += 1;
  }
  EXPECT_GT(empty, 1000);
  EXPECT_GT(some, 1000);
  for (const glm::u8vec4& color : colors.independent)
  {
    EXPECT_TRUE(color.b == 0 || color.a == 0);
  }
}

// Seen from its own camera a view hides what is behind it; with the paper's shares only as much as
// its depth says.
TEST(ViewTexture, SharesOfTheOwnCamera)
{
  for (const bool classic : { false, true })
  {
    ViewTextureOptions options;
    options.classicShares = classic;
    Textured scene = squareScene(options);
    TextureView view = viewOfDepth(2.3);
    view.dependent = true;
    view.extremes = { glm::dvec3(3, 0, 4) };
    scene.texture.setViews({ view });
    scene.setImage(0, view, plain(bluePixel));
    const ViewTextureColors& colors = scene.texture.colors();
    forNodes(scene.cells, 2,
      [&](std::size_t node)
      {
        int most = 0;
        for (std::size_t i = 0; i < 64; ++i)
        {
          most = std::max<int>(most, colors.dependent[64 * node + i].a);
        }
        EXPECT_NEAR(most, classic ? 0.7 * 255.0 : 255.0, 3.0);
      });
  }
}

TEST(ViewTexture, ContentsCanBeSeenAlone)
{
  Textured scene = squareScene();
  TextureView view = viewOfDepth(2.5);
  TextureView dependent = view;
  dependent.dependent = true;
  scene.texture.setViews({ view, dependent });
  scene.setImage(0, view, plain(redPixel));
  scene.setImage(1, dependent, plain(bluePixel));
  const ViewTextureColors combined = scene.texture.colors();
  const ViewTextureColors first = scene.texture.colors(ViewTextureContent::DependentOnly);
  EXPECT_EQ(first.dependent, combined.dependent);
  EXPECT_EQ(first.independent.front(), glm::u8vec4(128, 128, 128, 0));
  const ViewTextureColors other = scene.texture.colors(ViewTextureContent::IndependentOnly);
  EXPECT_EQ(other.independent, combined.independent);
  EXPECT_TRUE(std::all_of(other.dependent.begin(), other.dependent.end(), isClear));
  const ViewTextureColors coverage = scene.texture.colors(ViewTextureContent::Coverage);
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(coverage.independent.front()[channel], coverageColor(0)[channel], 1);
    EXPECT_NEAR(coverage.dependent.front()[channel], coverageColor(1)[channel], 1);
  }
  const ViewTextureColors& again = scene.texture.colors();
  EXPECT_EQ(again.independent, combined.independent);
  EXPECT_EQ(again.dependent, combined.dependent);
}

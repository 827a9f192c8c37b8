// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "TileTests.h"

#include "Core/Kernels.h"
#include "Core/SurfaceRaster.h"
#include "Core/ViewCoverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace hachure;

namespace
{
// Of a ray through a pixel's centre: its beginning and direction.
std::pair<glm::dvec3, glm::dvec3> rayOf(const TextureView& view, double x, double y)
{
  const glm::dmat4 back = glm::inverse(view.modelToClip);
  const auto unproject = [&](double z)
  {
    const glm::dvec4 place =
      back * glm::dvec4(2.0 * x / view.width - 1.0, 2.0 * y / view.height - 1.0, z, 1.0);
    return glm::dvec3(place) / place.w;
  };
  const glm::dvec3 from = view.parallel ? unproject(-1.0) : view.eye;
  return { from, glm::normalize(unproject(0.0) - from) };
}

// Distance along the ray, infinite where the triangle is missed.
double meet(const Surface& surface, std::size_t triangle, const glm::dvec3& from,
  const glm::dvec3& along, glm::dvec2& weights)
{
  const glm::ivec3 corners = surface.triangles[triangle];
  const auto point = [&](int i) { return surface.points[static_cast<std::size_t>(corners[i])]; };
  const glm::dvec3 u = point(1) - point(0);
  const glm::dvec3 v = point(2) - point(0);
  const glm::dvec3 across = glm::cross(along, v);
  const double scale = glm::dot(u, across);
  const glm::dvec3 offset = from - point(0);
  weights.x = glm::dot(offset, across) / scale;
  const glm::dvec3 other = glm::cross(offset, u);
  weights.y = glm::dot(along, other) / scale;
  const double distance = glm::dot(v, other) / scale;
  const bool hit = weights.x >= 0.0 && weights.y >= 0.0 && weights.x + weights.y <= 1.0;
  return hit && distance > 0.0 ? distance : std::numeric_limits<double>::infinity();
}

// Two spheres of which one is partly behind the other, and a floor that reaches behind the eye.
Surface crowdedScene()
{
  Surface scene = sphereOf(2);
  const int count = static_cast<int>(scene.points.size());
  const std::size_t triangles = scene.triangles.size();
  for (int i = 0; i < count; ++i)
  {
    scene.points.push_back(
      0.7 * scene.points[static_cast<std::size_t>(i)] + glm::dvec3(0.8, 0.1, -1.5));
  }
  for (std::size_t i = 0; i < triangles; ++i)
  {
    scene.triangles.push_back(scene.triangles[i] + count);
  }
  const int floor = static_cast<int>(scene.points.size());
  scene.points.insert(scene.points.end(), { { -30, -1, -30 }, { 30, -1.01, -30 }, { 0, -1, 50 } });
  scene.triangles.push_back({ floor, floor + 1, floor + 2 });
  return scene;
}

TextureView parallelView(int size)
{
  TextureView view;
  view.modelToClip = glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.1, 20.0) *
    glm::lookAt(glm::dvec3(1, 2, 4), glm::dvec3(0.0), glm::dvec3(0, 1, 0));
  view.eye = { 1, 2, 4 };
  view.parallel = true;
  view.width = view.height = size;
  return view;
}

// Whether no pixel is in a cell, where triangles are charts.
bool isGap(const SurfaceRaster& raster, const CellLayer& layer, std::int32_t cell)
{
  for (std::size_t pixel = 0; pixel < raster.triangles.size(); ++pixel)
  {
    const std::int32_t chart = raster.triangles[pixel];
    if (chart == layer.chartOf(cell) && layer.cellAt({ chart, raster.weights[pixel] }) == cell)
    {
      return false;
    }
  }
  return true;
}

double depthAt(const Surface& surface, const std::vector<CellLayer>& layers, double distance)
{
  return viewCoverage(
    surface.mesh(), layers, viewFrom({ 0.0, 0.0, distance }, glm::dvec3(0.0), 200, 200))
    .depth;
}
} // namespace

TEST(ViewCoverage, RasterShowsWhatRaysMeetFirst)
{
  const Surface scene = crowdedScene();
  const std::vector<std::int32_t> shown(scene.triangles.size(), 0);
  for (const TextureView& view :
    { viewFrom({ 0.5, 0.5, 4 }, glm::dvec3(0.3, 0, 0), 61, 47), parallelView(50) })
  {
    const SurfaceRaster raster =
      rasterOf(scene.mesh(), shown, view.modelToClip, view.width, view.height);
    int different = 0;
    for (int pixel = 0; pixel < view.width * view.height; ++pixel)
    {
      const int row = pixel / view.width;
      const auto ray = rayOf(view, pixel % view.width + 0.5, row + 0.5);
      double nearest = std::numeric_limits<double>::infinity();
      std::int32_t triangle = -1;
      glm::dvec2 weights(0.0);
      for (std::size_t i = 0; i < scene.triangles.size(); ++i)
      {
        glm::dvec2 there(0.0);
        const double distance = meet(scene, i, ray.first, ray.second, there);
        if (distance < nearest)
        {
          nearest = distance;
          triangle = static_cast<std::int32_t>(i);
          weights = there;
        }
      }
      const auto at = static_cast<std::size_t>(pixel);
      different += raster.triangles[at] != triangle ? 1 : 0;
      if (triangle >= 0 && raster.triangles[at] == triangle)
      {
        EXPECT_LT(glm::distance(glm::dvec2(raster.weights[at]), weights), 1e-5);
      }
    }
    EXPECT_LE(different, 2); // on edges
  }
}

// A square tilted by 60 degrees, all of it in the picture.
TEST(ViewCoverage, AreaIsThatOfTheSurface)
{
  Surface square;
  addGrid(square, { -0.5, -0.25, -0.433012701892 }, { 1, 0, 0 }, { 0, 0.5, 0.866025403784 }, 5);
  const std::vector<std::int32_t> shown(square.triangles.size(), 0);
  const TextureView view = viewFrom({ 0, 0, 3 }, glm::dvec3(0.0), 400, 300);
  const SurfaceRaster raster =
    rasterOf(square.mesh(), shown, view.modelToClip, view.width, view.height);
  EXPECT_NEAR(raster.area, 1.0, 0.01);
  // And what a pixel shows is what the shaders say.
  const glm::dmat4 rows = glm::transpose(view.modelToClip);
  const glm::vec4 rowW(rows[3]);
  const glm::vec4 rowX(0.5 * view.width * (rows[0] + rows[3]));
  const glm::vec4 rowY(0.5 * view.height * (rows[1] + rows[3]));
  double inverse = 0.0;
  const glm::vec3 normal(0.0f, -0.866025403784f, 0.5f);
  for (std::size_t i = 0; i < raster.triangles.size(); ++i)
  {
    if (raster.triangles[i] >= 0)
    {
      const auto corners = square.triangles[static_cast<std::size_t>(raster.triangles[i])];
      const glm::dvec2 weights(raster.weights[i]);
      const glm::dvec3 point =
        (1.0 - weights.x - weights.y) * square.points[static_cast<std::size_t>(corners.x)] +
        weights.x * square.points[static_cast<std::size_t>(corners.y)] +
        weights.y * square.points[static_cast<std::size_t>(corners.z)];
      inverse += 1.0 / glsl::pictureArea(glm::vec3(point), normal, rowX, rowY, rowW);
    }
  }
  EXPECT_NEAR(raster.area, inverse, 1e-3);
}

TEST(ViewCoverage, DepthIsContinuousAlongADolly)
{
  const Surface sphere = sphereOf(2);
  const SurfaceCells cells = trianglesAsCells(sphere.mesh());
  const std::vector<CellLayer> layers = layersOf(cells);
  double last = depthAt(sphere, layers, 5.0);
  const double first = last;
  for (int i = 1; i <= 60; ++i)
  {
    const double depth = depthAt(sphere, layers, 5.0 * std::exp2(0.05 * i));
    // A step is a twentieth of a level where the sphere looks flat.
    EXPECT_NEAR(depth, last - 0.05, 0.06) << i; // the paper's jumps by 0.25
    last = depth;
  }
  EXPECT_GT(first - last, 2.5);
  EXPECT_LT(first - last, 3.5);
}

// Parallel, so that a square of a given size has as many pixels as wanted.
TEST(ViewCoverage, LevelsShareADepthOf2Point3)
{
  const Surface square = squareOf(4);
  SurfaceCellOptions options;
  options.baseCells = 32;
  const SurfaceCells cells = trianglesAsCells(square.mesh(), options);
  const std::vector<CellLayer> layers = layersOf(cells);
  TextureView view;
  view.width = view.height = 300;
  view.parallel = true;
  const double pixels = std::sqrt(32.0 * std::pow(4.0, 2.3)); // of the square's side
  const double scale = pixels / view.width;
  view.modelToClip = glm::scale(glm::dmat4(1.0), glm::dvec3(scale, scale, -0.1));
  const ViewCoverage coverage = viewCoverage(square.mesh(), layers, view);
  EXPECT_NEAR(coverage.depth, 2.3, 0.01);
  ASSERT_EQ(coverage.levels.size(), 2u);
  EXPECT_EQ(coverage.levels[0].number, 2);
  EXPECT_NEAR(coverage.levels[0].share, 0.7, 0.01);
  EXPECT_EQ(coverage.levels[1].number, 3);
  EXPECT_NEAR(coverage.levels[1].share, 0.3, 0.01);
}

// Every quarter of a pixel is in one cell, the one that its place is in.
TEST(ViewCoverage, ListsAllPixelsOfCells)
{
  const Surface sphere = sphereOf(2);
  const SurfaceCells cells = trianglesAsCells(sphere.mesh());
  const std::vector<CellLayer> layers = layersOf(cells);
  const TextureView view = viewFrom({ 1, 1, 4 }, glm::dvec3(0.0), 90, 80);
  const ViewCoverage coverage = viewCoverage(sphere.mesh(), layers, view);
  const SurfaceRaster raster = rasterOf(
    sphere.mesh(), cells.chartOfTriangle, view.modelToClip, 2 * view.width, 2 * view.height);
  ASSERT_EQ(coverage.levels.size(), 2u);
  for (const ViewCoverage::Level& level : coverage.levels)
  {
    const CellLayer& layer = layers[static_cast<std::size_t>(level.number)];
    std::vector<int> quarters(static_cast<std::size_t>(view.width * view.height), 0);
    ASSERT_EQ(level.first.size(), level.cells.size() + 1);
    for (std::size_t i = 0; i < level.cells.size(); ++i)
    {
      EXPECT_LT(level.first[i], level.first[i + 1]);
      if (isGap(raster, layer, level.cells[i]))
      {
        continue;
      }
      for (std::size_t j = level.first[i]; j < level.first[i + 1]; ++j)
      {
        const CoveredPixel& covered = level.pixels[j];
        quarters[covered.pixel] += static_cast<int>(covered.quarters());
        bool found = false;
        for (int quarter = 0; quarter < 4; ++quarter)
        {
          const int column = 2 * (static_cast<int>(covered.pixel) % view.width) + quarter % 2;
          const int row = 2 * (static_cast<int>(covered.pixel) / view.width) + quarter / 2;
          const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width) +
            static_cast<std::size_t>(column);
          found = found ||
            (raster.triangles[at] >= 0 &&
              layer.cellAt({ raster.triangles[at], raster.weights[at] }) == level.cells[i]);
        }
        EXPECT_TRUE(found);
      }
    }
    std::int64_t sum = 0;
    for (const int count : quarters)
    {
      EXPECT_LE(count, 4);
      sum += count;
    }
    EXPECT_EQ(sum, raster.pixels);
  }
}

TEST(ViewCoverage, IsTheSameForAnyNumberOfThreads)
{
  const Surface scene = crowdedScene();
  const SurfaceCells cells = trianglesAsCells(scene.mesh());
  const std::vector<CellLayer> layers = layersOf(cells);
  const TextureView view = viewFrom({ 0.5, 0.5, 4 }, glm::dvec3(0.3, 0, 0), 200, 170);
  const auto both =
    withOneAndEightThreads([&] { return viewCoverage(scene.mesh(), layers, view); });
  EXPECT_EQ(both.first.depth, both.second.depth);
  ASSERT_EQ(both.first.levels.size(), both.second.levels.size());
  for (std::size_t i = 0; i < both.first.levels.size(); ++i)
  {
    EXPECT_EQ(both.first.levels[i].cells, both.second.levels[i].cells);
    EXPECT_EQ(both.first.levels[i].first, both.second.levels[i].first);
  }
}

TEST(ViewCoverage, OddSurfacesAndCameras)
{
  const TextureView view = viewFrom({ 0, 0, 4 }, glm::dvec3(0.0), 20, 20);
  const SurfaceCells none = trianglesAsCells({ {}, {}, {} });
  EXPECT_TRUE(viewCoverage({ {}, {}, {} }, layersOf(none), view).levels.empty());
  // Looking away, and at triangles from their edge.
  Surface square = squareOf(1);
  square.triangles.push_back({ 0, 0, 1 });
  square.patches.clear();
  const SurfaceCells cells = trianglesAsCells(square.mesh());
  const std::vector<CellLayer> layers = layersOf(cells);
  const TextureView away = viewFrom({ 0, 0, 4 }, glm::dvec3(0, 0, 8), 20, 20);
  EXPECT_TRUE(viewCoverage(square.mesh(), layers, away).levels.empty());
  const TextureView edge = viewFrom({ 4, 0, 0 }, glm::dvec3(0.0), 20, 20);
  EXPECT_TRUE(std::isfinite(viewCoverage(square.mesh(), layers, edge).depth));
  // From behind it is seen as well, and from the middle of it.
  const TextureView behind = viewFrom({ 0, 0, -4 }, glm::dvec3(0.0), 20, 20);
  EXPECT_FALSE(viewCoverage(square.mesh(), layers, behind).levels.empty());
  const TextureView within = viewFrom({ 0, 0, 1e-9 }, glm::dvec3(1, 0, 0), 20, 20);
  EXPECT_TRUE(std::isfinite(viewCoverage(square.mesh(), layers, within).depth));
}

// Every cell has three neighbours on a closed surface, and is one of theirs.
TEST(ViewCoverage, CellsOfTwoSizesAreNeighbours)
{
  Surface square = squareOf(1);
  square.points.insert(square.points.end(), { { 3, -1, 0 }, { 3, 1, 0 }, { 2, 0, 0 } });
  // The right side has smaller triangles.
  square.patches.clear();
  square.triangles.insert(
    square.triangles.end(), { { 2, 3, 6 }, { 2, 6, 4 }, { 4, 6, 5 }, { 5, 6, 3 } });
  SurfaceCellOptions options;
  options.baseCells = 6;
  options.finestLevel = 3;
  SurfaceCells cells = trianglesAsCells(square.mesh(), options);
  cells.charts[2].level = 1;
  for (const CellLayer& layer : layersOf(cells))
  {
    std::vector<std::set<std::int32_t>> neighbours(static_cast<std::size_t>(layer.size()));
    for (std::int32_t cell = 0; cell < layer.size(); ++cell)
    {
      std::vector<std::int32_t> found;
      layer.appendNeighbours(cell, found);
      neighbours[static_cast<std::size_t>(cell)].insert(found.begin(), found.end());
      EXPECT_EQ(neighbours[static_cast<std::size_t>(cell)].size(), found.size());
      EXPECT_EQ(neighbours[static_cast<std::size_t>(cell)].count(cell), 0u);
    }
    for (std::int32_t cell = 0; cell < layer.size(); ++cell)
    {
      for (const std::int32_t other : neighbours[static_cast<std::size_t>(cell)])
      {
        EXPECT_EQ(neighbours[static_cast<std::size_t>(other)].count(cell), 1u);
      }
    }
  }
}

// Each cell of a level is child of one of the level before, and its centre is in that one.
TEST(ViewCoverage, ChildrenDivideTheirCell)
{
  const Surface sphere = sphereOf(1);
  SurfaceCellOptions options;
  options.baseCells = 100;
  const SurfaceCells cells = trianglesAsCells(sphere.mesh(), options);
  const std::vector<CellLayer> layers = layersOf(cells);
  for (std::size_t level = 0; level + 1 < layers.size(); ++level)
  {
    const CellLayer& next = layers[level + 1];
    std::vector<std::int32_t> parent(static_cast<std::size_t>(next.size()), -1);
    for (std::int32_t cell = 0; cell < layers[level].size(); ++cell)
    {
      const CellLayer::Children children = layers[level].childrenOf(cell, next);
      for (int i = 0; i < children.count; ++i)
      {
        const std::int32_t child = children.cells[static_cast<std::size_t>(i)];
        EXPECT_EQ(parent[static_cast<std::size_t>(child)], -1);
        parent[static_cast<std::size_t>(child)] = cell;
      }
    }
    for (std::int32_t child = 0; child < next.size(); ++child)
    {
      const std::int32_t chart = next.chartOf(child);
      const int segments = next.segmentsOf(chart);
      const CellSpot spot = cellSpot(child - next.firstOf(chart), segments);
      const glm::vec2 centre =
        glm::vec2(spot.column, spot.row) + glm::vec2((1.0f + spot.odd) / 3.0f);
      EXPECT_EQ(next.cellAt({ chart, centre / static_cast<float>(segments) }), child);
      EXPECT_EQ(layers[level].cellAt({ chart, centre / static_cast<float>(segments) }),
        parent[static_cast<std::size_t>(child)]);
    }
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTextureScene.h"

#include "Core/HemisphereTable.h"
#include "Core/Kernels.h"
#include "Core/SrgbColor.h"
#include "Core/SurfaceCharts.h"
#include "Core/ViewCellColors.h"
#include "Core/ViewTextureBase.h"
#include "Core/ViewTextureSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hachure;

namespace
{
// Smooth, of directions in model coordinates.
glm::vec4 directionColor(const glm::vec3& direction)
{
  return glm::vec4(0.5f + 0.5f * direction, 1.0f);
}

// What a hemisphere shows in a direction of its frame, as the shaders read it.
glm::vec4 readHemisphere(
  HemisphereMap map, int side, const std::function<glm::vec4(int)>& at, const glm::vec3& local)
{
  const glm::vec2 square =
    map == HemisphereMap::Octahedral ? glsl::hemisphereSquare(local) : glsl::hemisphereDisk(local);
  const glm::vec2 place =
    glm::clamp(static_cast<float>(side) * square - 0.5f, 0.0f, static_cast<float>(side - 1));
  const glm::ivec2 first = glm::min(glm::ivec2(place), glm::ivec2(side - 2));
  const glm::vec2 share = place - glm::vec2(first);
  const int tap = first.y * side + first.x;
  return glm::mix(glm::mix(at(tap), at(tap + 1), share.x),
    glm::mix(at(tap + side), at(tap + side + 1), share.x), share.y);
}

// A sheet that faces +X and waves, so that parts of it face up and others down.
Surface wavySheet(int n)
{
  Surface sheet;
  addGrid(sheet, { 0, -1, -1 }, { 0, 2, 0 }, { 0, 0, 2 }, n);
  for (glm::dvec3& point : sheet.points)
  {
    point.x = 0.12 * std::sin(4.0 * point.y) * std::cos(3.0 * point.z);
  }
  return sheet;
}

// A cell of a given value alone, at a level.
ViewCellColors colorsOf(const CellLayer& layer, const std::function<glm::vec4(std::int32_t)>& color)
{
  ViewCellColors view;
  view.levels.resize(1);
  view.levels[0].number = layer.number();
  view.levels[0].share = 1.0f;
  for (std::int32_t cell = 0; cell < layer.size(); ++cell)
  {
    view.levels[0].seen.cells.push_back(cell);
    view.levels[0].seen.colors.push_back(color(cell));
  }
  return view;
}

// A square of two triangles next to ones of a quarter and a sixteenth of their size.
Surface squareWithSmallSide()
{
  Surface square = squareOf(1);
  square.patches.clear();
  square.points.insert(square.points.end(), { { 3, -1, 0 }, { 3, 1, 0 }, { 1.5, 0, 0 } });
  // The edge from (1, -1) to (1, 1) is that of points 2 and 3.
  square.triangles.insert(
    square.triangles.end(), { { 2, 6, 3 }, { 2, 4, 6 }, { 4, 5, 6 }, { 5, 3, 6 } });
  return square;
}
// The colour of a place, from the nodes of a level.
glm::vec4 colorAt(const CellLayer& layer, const std::vector<glm::vec4>& nodes, std::int32_t chart,
  const glm::vec3& weights)
{
  const glsl::NodeMix mix = glsl::nodesAt(glm::vec2(weights.y, weights.z), layer.segmentsOf(chart));
  const auto at = [&](int node)
  { return nodes[static_cast<std::size_t>(layer.firstNode(chart) + node)]; };
  return mix.weights.x * at(mix.cell) + mix.weights.y * at(mix.corner) +
    mix.weights.z * at(mix.next);
}

// The largest difference between both sides of a chart's rim.
float gapAround(const CellLayer& layer, const std::vector<glm::vec4>& nodes, std::int32_t chart)
{
  float most = 0.0f;
  for (int edge = 0; edge < 3; ++edge)
  {
    const std::int32_t code = layer.surface()
                                .charts[static_cast<std::size_t>(chart)]
                                .neighbours[static_cast<std::size_t>(edge)];
    for (int step = 0; code >= 0 && step <= 64; ++step)
    {
      glm::vec3 weights(0.0f);
      weights[(edge + 1) % 3] = static_cast<float>(step) / 64.0f;
      weights[(edge + 2) % 3] = 1.0f - weights[(edge + 1) % 3];
      const glm::vec3 other = glsl::weightsAcross(weights, edge, code % 6 / 2, code % 2 == 1);
      most = std::max(most,
        glm::distance(
          colorAt(layer, nodes, chart, weights), colorAt(layer, nodes, code / 6, other)));
    }
  }
  return most;
}

// Whatever the colours of cells, the picture is the same on both sides of a rim, also where charts
// of different numbers of cells meet.
void expectContinuous(const Surface& surface, const SurfaceCells& cells)
{
  const ViewTextureSurface all(surface.mesh(), cells, surfaceFrames(surface.mesh(), cells));
  for (int level = 0; level < all.levels(); ++level)
  {
    const CellLayer& layer = all.layer(level);
    const ViewCellColors view = colorsOf(layer,
      [](std::int32_t cell) { return glm::vec4(cell * 37 % 11 / 10.0f, cell % 3 / 2.0f, 0, 1); });
    const std::vector<const ViewCellColors*> views = { &view };
    const std::vector<glm::vec4> nodes = viewTextureBase(all, views, true);
    for (std::size_t chart = 0; chart < cells.charts.size(); ++chart)
    {
      EXPECT_LT(gapAround(layer, nodes, static_cast<std::int32_t>(chart)), 1e-4f)
        << level << " " << chart;
    }
  }
}
} // namespace

TEST(ViewTextureNodes, HemispheresTurn)
{
  for (const HemisphereMap map : { HemisphereMap::Octahedral, HemisphereMap::Disk })
  {
    for (const int side : { 4, 8, 16 })
    {
      const HemisphereTable table(map, side);
      const glm::quat from = glm::angleAxis(0.4f, glm::normalize(glm::vec3(1, 0.3f, -0.2f)));
      const glm::quat to = glm::angleAxis(1.2f, glm::vec3(0, 1, 0)) *
        glm::angleAxis(0.2f, glm::normalize(glm::vec3(0.3f, -1, 0.5f)));
      std::vector<glm::vec4> source(table.size()), found(table.size(), glm::vec4(0.0f));
      std::vector<glm::vec3> directions(table.size());
      table.directionsIn(from, directions);
      std::transform(directions.begin(), directions.end(), source.begin(), directionColor);
      HemisphereTable::Taps taps;
      table.findTaps(to, from, taps);
      EXPECT_FALSE(taps.isSame);
      table.add(taps, 1.0f, source.data(), found.data());
      table.directionsIn(to, directions);
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        const glm::vec3 inSource = glm::conjugate(from) * directions[i];
        if (inSource.y > 0.4f) // else it is at the rim
        {
          EXPECT_LT(glm::distance(found[i], directionColor(directions[i])), 0.9f / side);
        }
      }
      // The same frame, and its other sign.
      for (const glm::quat& same : { from, -from })
      {
        table.findTaps(same, from, taps);
        EXPECT_TRUE(taps.isSame);
      }
    }
  }
}

TEST(ViewTextureNodes, WeightsOfNodesSumToOne)
{
  for (const Surface& surface : { sphereOf(1), squareWithSmallSide(), wavySheet(3) })
  {
    const SurfaceCells cells = trianglesAsCells(surface.mesh());
    for (const CellLayer& layer : layersOf(cells))
    {
      const NodeCells nodes = layer.nodeCells();
      ASSERT_EQ(nodes.first.size(), static_cast<std::size_t>(layer.nodeCount()) + 1);
      for (std::size_t node = 0; node + 1 < nodes.first.size(); ++node)
      {
        double sum = 0.0;
        for (std::int64_t i = nodes.first[node]; i < nodes.first[node + 1]; ++i)
        {
          const NodeCells::Share& share = nodes.shares[static_cast<std::size_t>(i)];
          EXPECT_GT(share.weight, 0.0f);
          EXPECT_LT(share.cell, layer.size());
          sum += share.weight;
        }
        EXPECT_NEAR(sum, 1.0, 1e-5);
      }
    }
  }
}

TEST(ViewTextureNodes, PictureIsContinuousAcrossRims)
{
  const Surface surface = squareWithSmallSide();
  SurfaceCellOptions options;
  options.baseCells = 12;
  options.finestLevel = 3;
  const SurfaceCells cells = trianglesAsCells(surface.mesh(), options);
  ASSERT_NE(cells.charts[1].level, cells.charts[2].level);
  expectContinuous(surface, cells);
}

// Parallel views fade with the direction alone. All of the sheet is seen by each, so that what is
// stored depends on the direction in model coordinates alone; frames do not.
TEST(ViewTextureNodes, DirectionsAgreeOnBothSidesOfRims)
{
  const Surface sheet = wavySheet(5);
  for (const HemisphereMap map : { HemisphereMap::Octahedral, HemisphereMap::Disk })
  {
    SurfaceCellOptions cellOptions;
    cellOptions.baseCells = 50;
    cellOptions.finestLevel = 2;
    ViewTextureOptions options;
    options.hemisphere = 16;
    options.map = map;
    Textured scene(sheet, trianglesAsCells(sheet.mesh(), cellOptions), options);
    std::vector<TextureView> views(5);
    const std::vector<glm::dvec3> eyes = { { 4, 0, 0 }, { 4, 1.5, 0 }, { 4, -1.5, 0 },
      { 4, 0, 1.5 }, { 4, 0, -1.5 } };
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      views[i].eye = eyes[i];
      views[i].modelToClip = glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.1, 9.0) *
        glm::lookAt(eyes[i], glm::dvec3(0.0), glm::dvec3(0, 1, 0));
      views[i].parallel = views[i].dependent = true;
      views[i].width = views[i].height = 120;
      views[i].extremes = extremesAround(views[i], 4, 0.6);
      views[i].fadeCurve = { { 0.0, 1.0 }, { 1.0, 0.0 } };
    }
    scene.texture.setViews(views);
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      scene.setImage(i, views[i], plain(glm::u8vec4(50 * i, 255 - 60 * i, 100, 255)));
    }
    const ViewTextureColors& colors = scene.texture.colors();
    const ViewTextureSurface all(
      sheet.mesh(), scene.cells, surfaceFrames(sheet.mesh(), scene.cells));
    const auto colorAt = [&](std::int64_t node, const glm::vec3& direction)
    {
      const glm::u8vec4* stored = &colors.dependent[static_cast<std::size_t>(256 * node)];
      const auto tap = [&](int i)
      {
        glm::vec4 color = linearOf(glm::u8vec4(stored[i].r, stored[i].g, stored[i].b, 255));
        color.a = stored[i].a / 255.0f;
        return color;
      };
      return readHemisphere(map, 16, tap, glm::conjugate(all.turnOfNode(node)) * direction);
    };
    const CellLayer& layer = all.layer(2);
    float most = 0.0f, sum = 0.0f, count = 0.0f;
    float largestTurn = 0.0f;
    for (std::size_t i = 0; i < scene.cells.charts.size(); ++i)
    {
      const auto chart = static_cast<std::int32_t>(i);
      const int segments = layer.segmentsOf(chart);
      for (int edge = 0; edge < 3; ++edge)
      {
        for (int along = 0; along < segments; ++along)
        {
          const RimPlace other = acrossRim(layer, { chart, edge, along + 0.5 });
          if (other.chart < 0)
          {
            continue;
          }
          const std::int64_t node = layer.firstNode(chart) + glsl::rimNode(edge, along, segments);
          const std::int64_t otherNode = layer.firstNode(other.chart) +
            glsl::rimNode(other.edge, static_cast<int>(other.along), segments);
          largestTurn = std::max(largestTurn,
            1.0f - std::abs(glm::dot(all.turnOfNode(node), all.turnOfNode(otherNode))));
          for (const glm::dvec3& eye : eyes)
          {
            const glm::vec3 direction(glm::normalize(eye + glm::dvec3(0, 0.3, 0.4)));
            const float difference =
              glm::distance(colorAt(node, direction), colorAt(otherNode, direction));
            most = std::max(most, difference);
            sum += difference;
            count += 1.0f;
          }
        }
      }
    }
    EXPECT_GT(largestTurn, 0.1f); // frames of both kinds meet
    // A cone of 0.6 between directions 0.2 apart, read twice.
    EXPECT_LT(most, 0.15f);
    EXPECT_LT(sum / count, 0.03f);
  }
}

// Read in the direction of its camera, a view's image comes back, whatever the frames.
TEST(ViewTextureNodes, ViewsAreSeenFromTheirCameras)
{
  const Surface sphere = sphereOf(4);
  SurfaceCellOptions cellOptions;
  cellOptions.finestLevel = 3;
  const SurfaceCells cells = surfaceCells(sphere.mesh(), cellOptions);
  const ViewTextureSurface surface(sphere.mesh(), cells, surfaceFrames(sphere.mesh(), cells));
  TextureView view = viewFrom({ 1, -2, 3 }, glm::dvec3(0.0), 120, 120);
  view.dependent = true;
  view.extremes = extremesAround(view, 5, 0.8);
  const auto color = [](double x, double y)
  { return glm::vec3(0.3 + 0.6 * x, 0.9 - 0.6 * y, 0.4 + 0.4 * x * y); };
  for (const HemisphereMap map : { HemisphereMap::Octahedral, HemisphereMap::Disk })
  {
    for (const FadeMode mode : { FadeMode::Curve, FadeMode::Middle, FadeMode::Even })
    {
      ViewTextureOptions options;
      options.map = map;
      view.fadeMode = mode;
      Textured scene(sphere, cells, options);
      scene.texture.setViews({ view });
      scene.setImage(0, view,
        [&](int column, int row)
        { return glm::u8vec4(255.0f * color(column / 120.0, row / 120.0), 255); });
      const ViewTextureColors& colors = scene.texture.colors();
      float sum = 0.0f, least = 1.0f, count = 0.0f;
      for (std::int32_t cell = 0; cell < surface.layer(3).size(); ++cell)
      {
        const glm::dvec3& place = surface.placeOfCell(3, cell);
        const glm::dvec3 towards = glm::normalize(view.eye - place);
        if (glm::dot(towards, glm::normalize(place)) < 0.3)
        {
          continue; // away, or too near to the rim of what is seen
        }
        const glm::u8vec4* stored =
          &colors.dependent[static_cast<std::size_t>(64 * surface.layer(3).nodeOf(cell))];
        const glm::vec4 found = readHemisphere(
          map, 8,
          [&](int i)
          {
            glm::vec4 linear = linearOf(glm::u8vec4(stored[i].r, stored[i].g, stored[i].b, 255));
            linear.a = stored[i].a / 255.0f;
            return linear;
          },
          glm::conjugate(surface.turnOfCell(3, cell)) * glm::vec3(towards));
        const glm::dvec4 clip = view.modelToClip * glm::dvec4(place, 1.0);
        const glm::vec3 wanted = color(0.5 + 0.5 * clip.x / clip.w, 0.5 + 0.5 * clip.y / clip.w);
        for (int channel = 0; channel < 3; ++channel)
        {
          EXPECT_NEAR(srgbByteOf(found[channel] / found.a), 255.0f * wanted[channel], 12.0f);
        }
        sum += found.a;
        count += 1.0f;
        least = std::min(least, found.a);
      }
      EXPECT_GT(count, 1000.0f);
      // Directions are about 0.25 apart, and the view begins to fade 0.4 from its own.
      EXPECT_GT(sum / count, mode == FadeMode::Middle ? 0.8f : 0.95f);
      EXPECT_GT(least, mode == FadeMode::Middle ? 0.4f : 0.6f);
    }
  }
}

// Of charts of many triangles, which reach over their rims: the pixels in which a cell is seen show
// places around its own.
TEST(ViewTextureNodes, PixelsShowTheirCellsOnFineMeshes)
{
  const Surface sphere = sphereOf(5);
  SurfaceCellOptions options;
  options.baseCells = 40;
  const SurfaceCells cells = surfaceCells(sphere.mesh(), options);
  ASSERT_LT(cells.charts.size(), 100u);
  const ViewTextureSurface surface(sphere.mesh(), cells, surfaceFrames(sphere.mesh(), cells));
  const TextureView view = viewFrom({ 1, 2, 3 }, glm::dvec3(0.0), 150, 150);
  const ViewCoverage coverage = viewCoverage(sphere.mesh(), surface.allLayers(), view);
  ASSERT_FALSE(coverage.levels.empty());
  const glm::dmat4 back = glm::inverse(view.modelToClip);
  for (const ViewCoverage::Level& level : coverage.levels)
  {
    const double size = std::sqrt(2.3 * cells.cellArea) * std::exp2(-level.number); // a side
    double sum = 0.0, most = 0.0;
    for (std::size_t i = 0; i < level.cells.size(); ++i)
    {
      double nearest = 1e9;
      for (std::size_t j = level.first[i]; j < level.first[i + 1]; ++j)
      {
        const int pixel = static_cast<int>(level.pixels[j].pixel);
        const int row = pixel / 150;
        const glm::dvec4 ray = back *
          glm::dvec4(
            2.0 * (pixel % 150 + 0.5) / 150.0 - 1.0, 2.0 * (row + 0.5) / 150.0 - 1.0, 0.0, 1.0);
        const glm::dvec3 along = glm::normalize(glm::dvec3(ray) / ray.w - view.eye);
        const glm::dvec3 to = surface.placeOfCell(level.number, level.cells[i]) - view.eye;
        nearest = std::min(nearest, glm::length(to - glm::dot(to, along) * along));
      }
      sum += nearest;
      most = std::max(most, nearest);
    }
    const double pixel = 2.0 * 0.37 * glm::length(view.eye) / 150.0;
    EXPECT_LT(sum / static_cast<double>(level.cells.size()), 0.25 * size + 0.5 * pixel);
    EXPECT_LT(most, 1.5 * size + pixel);
  }
}

TEST(ViewTextureNodes, PictureOfAFineMeshIsContinuous)
{
  const Surface sphere = sphereOf(4);
  SurfaceCellOptions options;
  options.baseCells = 30;
  options.finestLevel = 3;
  expectContinuous(sphere, surfaceCells(sphere.mesh(), options));
}

// Ring by ring, over rims, but not into what is closed.
TEST(ViewTextureNodes, ColoursSpreadByRings)
{
  const Surface surface = sphereOf(1);
  const SurfaceCells cells = trianglesAsCells(surface.mesh());
  const CellLayer layer(cells, 2);
  const CellColors from = { { 7 }, { glm::vec4(0.5f, 0.25f, 0.0f, 0.5f) } };
  std::vector<std::uint8_t> closed(static_cast<std::size_t>(layer.size()), 0);
  EXPECT_TRUE(spreadColors(layer, from, closed, 0).cells.empty());
  std::vector<std::int32_t> neighbours;
  layer.appendNeighbours(7, neighbours);
  std::sort(neighbours.begin(), neighbours.end());
  EXPECT_EQ(spreadColors(layer, from, closed, 1).cells, neighbours);
  closed[static_cast<std::size_t>(neighbours[0])] = 1;
  const CellColors found = spreadColors(layer, from, closed, 1000);
  EXPECT_EQ(found.cells.size(), static_cast<std::size_t>(layer.size()) - 2);
  for (const glm::vec4& color : found.colors)
  {
    EXPECT_LT(glm::distance(color, from.colors[0]), 1e-6f);
  }
}

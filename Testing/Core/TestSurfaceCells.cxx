// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/SurfaceCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

using namespace hachure;

namespace
{
const std::vector<glm::dvec3> squarePoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
const std::vector<glm::ivec3> squareTriangles = { { 0, 1, 2 }, { 0, 2, 3 } };

// A value at every node such that cells have those of a function of the place.
template <class Function>
std::vector<double> nodeValues(int segments, Function&& value)
{
  const double step = 1.0 / segments;
  std::vector<double> values(static_cast<std::size_t>(
    segments * segments + (segments + 1) * (segments + 2) / 2 + 3 * segments));
  const auto put = [&](int node, double x, double y)
  { values[static_cast<std::size_t>(node)] = value(step * x, step * y); };
  for (int row = 0; row <= segments; ++row)
  {
    for (int column = 0; column <= segments - row; ++column)
    {
      put(glsl::cornerNode(column, row, segments), column, row);
      if (column + row < segments)
      {
        put(glsl::cellNode(column, row, 0, segments), column + 1.0 / 3.0, row + 1.0 / 3.0);
      }
      if (column + row < segments - 1)
      {
        put(glsl::cellNode(column, row, 1, segments), column + 2.0 / 3.0, row + 2.0 / 3.0);
      }
    }
  }
  for (int along = 0; along < segments; ++along)
  {
    put(glsl::rimNode(0, along, segments), segments - along - 0.5, along + 0.5);
    put(glsl::rimNode(1, along, segments), 0.0, along + 0.5);
    put(glsl::rimNode(2, along, segments), along + 0.5, 0.0);
  }
  return values;
}

double mixed(const std::vector<double>& values, const glm::vec2& place, int segments)
{
  const glsl::NodeMix nodes = glsl::nodesAt(place, segments);
  const auto at = [&](int node) { return values.at(static_cast<std::size_t>(node)); };
  return nodes.weights.x * at(nodes.cell) + nodes.weights.y * at(nodes.corner) +
    nodes.weights.z * at(nodes.next);
}
} // namespace

TEST(SurfaceCells, ListsEveryNodeOnce)
{
  for (int subdivisions = 0; subdivisions <= 4; ++subdivisions)
  {
    const int segments = 1 << subdivisions;
    std::set<int> nodes;
    for (int row = 0; row <= segments; ++row)
    {
      for (int column = 0; column <= segments - row; ++column)
      {
        nodes.insert(glsl::cornerNode(column, row, segments));
        for (int odd = 0; odd < 2; ++odd)
        {
          if (column + row + odd < segments)
          {
            nodes.insert(glsl::cellNode(column, row, odd, segments));
          }
        }
      }
    }
    for (int edge = 0; edge < 3; ++edge)
    {
      for (int along = 0; along < segments; ++along)
      {
        nodes.insert(glsl::rimNode(edge, along, segments));
      }
    }
    EXPECT_EQ(static_cast<int>(nodes.size()), glsl::chartNodes(subdivisions));
    EXPECT_EQ(*nodes.begin(), 0);
    EXPECT_EQ(*nodes.rbegin(), glsl::chartNodes(subdivisions) - 1);
    EXPECT_EQ(glsl::chartNodesBelow(subdivisions + 1) - glsl::chartNodesBelow(subdivisions),
      glsl::chartNodes(subdivisions));
  }
}

// What is linear on the chart is reproduced, so weights sum up to 1 and nodes are where they should
// be.
TEST(SurfaceCells, ReconstructionIsExactForLinearColours)
{
  for (const int segments : { 1, 2, 4, 16 })
  {
    const auto value = [](double x, double y) { return 1.0 + 2.0 * x - 3.0 * y; };
    const std::vector<double> values = nodeValues(segments, value);
    for (int i = 0; i <= 60; ++i)
    {
      for (int j = 0; i + j <= 60; ++j)
      {
        const glm::vec2 place(static_cast<float>(i) / 60.0f, static_cast<float>(j) / 60.0f);
        const glm::vec3 weights = glsl::nodesAt(place, segments).weights;
        EXPECT_NEAR(weights.x + weights.y + weights.z, 1.0, 1e-5);
        EXPECT_GE(std::min(std::min(weights.x, weights.y), weights.z), -1e-5);
        EXPECT_NEAR(mixed(values, place, segments), value(place.x, place.y), 2e-5)
          << i << " " << j << " of " << segments;
      }
    }
  }
}

// Over steps that are small against a cell the picture does not jump, whatever the colours.
TEST(SurfaceCells, ReconstructionIsContinuous)
{
  constexpr int segments = 8;
  // Corners and the rim follow from cells elsewhere; here the rim's edges are between its corners.
  std::vector<double> values = nodeValues(
    segments, [](double x, double y) { return std::sin(40.0 * x) * std::cos(31.0 * y); });
  for (int i = 0; i < 200; ++i)
  {
    for (int j = 0; j < 200; ++j)
    {
      const glm::vec2 place(0.004f * static_cast<float>(i), 0.004f * static_cast<float>(j));
      if (place.x + place.y < 0.99f)
      {
        const double here = mixed(values, place, segments);
        EXPECT_NEAR(mixed(values, place + glm::vec2(1e-5f, 0.0f), segments), here, 2e-3);
        EXPECT_NEAR(mixed(values, place + glm::vec2(0.0f, 1e-5f), segments), here, 2e-3);
      }
    }
  }
}

TEST(SurfaceCells, TrianglesAreChartsThatKnowTheirNeighbours)
{
  SurfaceCellOptions options;
  options.baseCells = 8;
  options.finestLevel = 2;
  const SurfaceCells cells = trianglesAsCells({ squarePoints, squareTriangles, {} }, options);
  ASSERT_EQ(cells.charts.size(), 2u);
  EXPECT_DOUBLE_EQ(cells.cellArea, 1.0 / 8.0);
  EXPECT_EQ(cells.charts[0].level, -1); // four cells of level 0
  // Across the edge 0-2: opposite to the corner 1 of the first, 2 of the second triangle.
  EXPECT_EQ(cells.charts[0].neighbours, (std::array<std::int32_t, 3>{ -1, 6 + 4, -1 }));
  EXPECT_EQ(cells.charts[1].neighbours, (std::array<std::int32_t, 3>{ -1, -1, 2 }));
  EXPECT_EQ(firstNodeOf(cells, 0, 0), 0);
  EXPECT_EQ(firstNodeOf(cells, 0, 1), glsl::chartNodes(1));
  EXPECT_EQ(firstNodeOf(cells, 0, 2), glsl::chartNodes(1) + glsl::chartNodes(2));
  EXPECT_EQ(cells.firstNode[1], firstNodeOf(cells, 0, 2) + glsl::chartNodes(3));
}

// The centre of the second triangle, as the first one sees it beyond its edge.
TEST(SurfaceCells, PlacesContinueAcrossEdges)
{
  for (const bool turned : { false, true })
  {
    std::vector<glm::ivec3> triangles = squareTriangles;
    if (turned)
    {
      std::swap(triangles[1].y, triangles[1].z);
    }
    const SurfaceCells cells = trianglesAsCells({ squarePoints, triangles, {} });
    const std::int32_t code = cells.charts[0].neighbours[1];
    ASSERT_EQ(code / 6, 1);
    EXPECT_EQ(code % 2 == 1, turned);
    // The point 3 is 0 + 2 - 1.
    const glm::vec3 beyond(0.5f, -0.25f, 0.75f);
    const glm::vec3 found = glsl::weightsAcross(beyond, 1, code % 6 / 2, code % 2 == 1);
    glm::dvec3 before(0.0);
    glm::dvec3 after(0.0);
    for (int i = 0; i < 3; ++i)
    {
      before +=
        static_cast<double>(beyond[i]) * squarePoints[static_cast<std::size_t>(triangles[0][i])];
      after +=
        static_cast<double>(found[i]) * squarePoints[static_cast<std::size_t>(triangles[1][i])];
    }
    EXPECT_LT(glm::length(before - after), 1e-6);
  }
}

TEST(SurfaceCells, SmallTrianglesStayOneCellUntilOthersAreAsSmall)
{
  std::vector<glm::dvec3> points = squarePoints;
  points.insert(points.end(), { { 2, 0, 0 }, { 2.25, 0, 0 }, { 2, 0.25, 0 } });
  std::vector<glm::ivec3> triangles = squareTriangles;
  triangles.push_back({ 4, 5, 6 });
  SurfaceCellOptions options;
  options.baseCells = 2;
  options.finestLevel = 3;
  const SurfaceCells cells = trianglesAsCells({ points, triangles, {} }, options);
  EXPECT_EQ(cells.charts[0].level, 0);
  EXPECT_EQ(cells.charts[2].level, 2);
  EXPECT_EQ(subdivisionsOf(cells.charts[2], 1), 0);
  EXPECT_EQ(firstNodeOf(cells, 2, 3) - firstNodeOf(cells, 2, 0), 3 * glsl::chartNodes(0));
  EXPECT_EQ(cells.firstNode[3] - firstNodeOf(cells, 2, 3), glsl::chartNodes(1));
}

TEST(SurfaceCells, HasFewerLevelsWhereThereWouldBeTooManyNodes)
{
  SurfaceCellOptions options;
  options.finestLevel = 8;
  options.mostNodes = 20000;
  const SurfaceCells cells = trianglesAsCells({ squarePoints, squareTriangles, {} }, options);
  EXPECT_LE(cells.firstNode.back(), options.mostNodes);
  EXPECT_EQ(cells.finestLevel, 3);
}

TEST(SurfaceCells, OddMeshes)
{
  EXPECT_TRUE(trianglesAsCells({ {}, {}, {} }).charts.empty());
  const std::vector<glm::ivec3> degenerate = { { 0, 1, 2 }, { 0, 0, 1 } };
  const SurfaceCells cells = trianglesAsCells({ squarePoints, degenerate, {} });
  EXPECT_EQ(cells.chartOfTriangle, (std::vector<std::int32_t>{ 0, -1 }));
  // An edge of three triangles has no neighbour across it.
  std::vector<glm::dvec3> points = squarePoints;
  points.emplace_back(0.5, 0.5, 1.0);
  const std::vector<glm::ivec3> book = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 2, 4 } };
  for (const CellChart& chart : trianglesAsCells({ points, book, {} }).charts)
  {
    EXPECT_EQ(chart.neighbours, (std::array<std::int32_t, 3>{ -1, -1, -1 }));
  }
}

TEST(SurfaceCells, RefusesWrongInput)
{
  SurfaceCellOptions options;
  options.baseCells = 0;
  EXPECT_THROW(
    trianglesAsCells({ squarePoints, squareTriangles, {} }, options), std::invalid_argument);
  options.baseCells = 1;
  options.finestLevel = maximumCellLevel + 1;
  EXPECT_THROW(
    trianglesAsCells({ squarePoints, squareTriangles, {} }, options), std::invalid_argument);
  std::vector<glm::dvec3> points = squarePoints;
  points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(trianglesAsCells({ points, squareTriangles, {} }), std::invalid_argument);
}

TEST(SurfaceCells, DirectionsReturnFromTheSquare)
{
  for (int i = 1; i < 40; ++i)
  {
    for (int j = 0; j < 40; ++j)
    {
      const double height = i / 40.0;
      const double side = std::sqrt(1.0 - height * height);
      const double angle = 0.157 * j;
      const glm::vec3 direction(static_cast<float>(side * std::cos(angle)),
        static_cast<float>(height), static_cast<float>(side * std::sin(angle)));
      EXPECT_LT(
        glm::length(glsl::hemisphereDirection(glsl::hemisphereSquare(direction)) - direction),
        1e-6f);
      EXPECT_LT(
        glm::length(glsl::hemisphereDiskDirection(glsl::hemisphereDisk(direction)) - direction),
        1e-6f);
    }
  }
}

// Seen from above at distance 4, a unit of surface is 100/16 pixels large, and tilted by 60 degrees
// half of that.
TEST(SurfaceCells, AreaInThePicture)
{
  const glm::vec4 rowX(10.0f, 0.0f, 0.0f, 3.0f);
  const glm::vec4 rowY(0.0f, 10.0f, 0.0f, -2.0f);
  const glm::vec4 rowW(0.0f, 0.0f, -1.0f, 4.0f);
  const glm::vec3 point(0.0f);
  EXPECT_NEAR(glsl::pictureArea(point, { 0, 0, 1 }, rowX, rowY, rowW), 6.25f, 1e-4f);
  EXPECT_NEAR(glsl::levelOfArea(16.0f), 2.0f, 1e-6f);
}

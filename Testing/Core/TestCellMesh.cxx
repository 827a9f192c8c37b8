// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "ViewTextureScene.h"

#include "Core/CellMesh.h"
#include "Core/SurfaceCharts.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace hachure;

namespace
{
// The cells of a surface at a level.
struct Cells
{
  Surface surface;
  SurfaceCells cells;
  CellLayer layer;
  CellMesh mesh;

  Cells(const Surface& ofSurface, const SurfaceCells& ofCells, int level)
    : surface(ofSurface)
    , cells(ofCells)
    , layer(this->cells, level)
    , mesh(cellMesh(surface.mesh(), layer, nodePlaces(surface.mesh(), cells)))
  {
  }
  glm::dvec3 cross(std::size_t cell) const
  {
    const glm::ivec3& t = this->mesh.triangles[cell];
    const auto at = [&](int i) { return this->mesh.points[static_cast<std::size_t>(i)]; };
    return glm::cross(at(t.y) - at(t.x), at(t.z) - at(t.x));
  }
  glm::dvec3 centre(std::size_t cell) const
  {
    const glm::ivec3& t = this->mesh.triangles[cell];
    const auto at = [&](int i) { return this->mesh.points[static_cast<std::size_t>(i)]; };
    return (at(t.x) + at(t.y) + at(t.z)) / 3.0;
  }
  double area() const
  {
    double sum = 0.0;
    for (std::size_t cell = 0; cell < this->mesh.triangles.size(); ++cell)
    {
      sum += 0.5 * glm::length(this->cross(cell));
    }
    return sum;
  }
  double lengthOf(const std::vector<CellBorder>& borders) const
  {
    double sum = 0.0;
    for (const CellBorder& border : borders)
    {
      sum += glm::distance(this->mesh.points[static_cast<std::size_t>(border.points[0])],
        this->mesh.points[static_cast<std::size_t>(border.points[1])]);
    }
    return sum;
  }
};

// How often an edge is there, by its ends in their order.
std::map<std::pair<int, int>, int> edgesOf(const CellMesh& mesh)
{
  std::map<std::pair<int, int>, int> edges;
  for (const glm::ivec3& triangle : mesh.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      ++edges[{ triangle[corner], triangle[(corner + 1) % 3] }];
    }
  }
  return edges;
}

void expectClosed(const CellMesh& mesh)
{
  const std::map<std::pair<int, int>, int> edges = edgesOf(mesh);
  for (const auto& edge : edges)
  {
    EXPECT_EQ(edge.second, 1);
    EXPECT_EQ(edges.count({ edge.first.second, edge.first.first }), 1u);
  }
  EXPECT_EQ(mesh.points.size() + mesh.triangles.size(), edges.size() / 2 + 2);
}

// A square of 2 whose triangles are smaller and smaller from the left to the right.
Surface unevenSquare()
{
  Surface square;
  addGrid(square, { 1, -1, 0 }, { -2, 0, 0 }, { 0, 2, 0 }, 8, 2.5);
  return square;
}
} // namespace

TEST(CellMesh, CoversAClosedSurfaceOnce)
{
  const Surface sphere = sphereOf(2);
  for (int level = 0; level <= 3; ++level)
  {
    SurfaceCellOptions options;
    options.baseCells = static_cast<int>(sphere.triangles.size());
    const Cells cells(sphere, trianglesAsCells(sphere.mesh(), options), level);
    ASSERT_EQ(cells.mesh.triangles.size(), static_cast<std::size_t>(cells.layer.size()));
    expectClosed(cells.mesh);
    for (std::size_t cell = 0; cell < cells.mesh.triangles.size(); ++cell)
    {
      EXPECT_GT(glm::dot(cells.cross(cell), cells.centre(cell)), 0.0);
    }
  }
}

TEST(CellMesh, HasTheAreaOfItsSurface)
{
  for (const Surface& surface : { sphereOf(2), unevenSquare() })
  {
    const SurfaceCells cells = trianglesAsCells(surface.mesh());
    double area = 0.0;
    for (const CellChart& chart : cells.charts)
    {
      area += chart.area;
    }
    EXPECT_NEAR(Cells(surface, cells, 2).area(), area, 1e-5 * area);
  }
  // Charts of many triangles: cells cut corners.
  const Surface sphere = sphereOf(5);
  SurfaceCellOptions options;
  options.baseCells = 40;
  const SurfaceCells charts = surfaceCells(sphere.mesh(), options);
  ASSERT_LT(charts.charts.size(), sphere.triangles.size() / 8);
  EXPECT_NEAR(Cells(sphere, charts, 4).area(), 4.0 * 3.14159265, 0.15);
}

TEST(CellMesh, BordersAreAsLongAsTheyShouldBe)
{
  // Between the lower and the upper half, over charts of several levels.
  const Surface square = unevenSquare();
  const SurfaceCells charts = trianglesAsCells(square.mesh());
  std::set<int> levels;
  for (const CellChart& chart : charts.charts)
  {
    levels.insert(chart.level);
  }
  ASSERT_GE(levels.size(), 3u);
  for (const int level : { 0, 2 })
  {
    const Cells cells(square, charts, level);
    std::vector<std::int32_t> labels;
    std::vector<std::int32_t> all;
    for (std::int32_t cell = 0; cell < cells.layer.size(); ++cell)
    {
      labels.push_back(cells.centre(static_cast<std::size_t>(cell)).y > 0.0 ? 7 : -1);
      all.push_back(cell);
    }
    const std::vector<CellBorder> found = cellBorders(cells.layer, cells.mesh, labels);
    EXPECT_NEAR(cells.lengthOf(found), 2.0, 1e-5);
    for (const CellBorder& border : found)
    {
      EXPECT_NE(labels[static_cast<std::size_t>(border.cells[0])],
        labels[static_cast<std::size_t>(border.cells[1])]);
      EXPECT_LT(border.cells[0], border.cells[1]);
      for (const std::int32_t point : border.points)
      {
        EXPECT_NEAR(cells.mesh.points[static_cast<std::size_t>(point)].y, 0.0, 1e-6);
      }
    }
    // Every edge but those of the square: each is there twice as an edge of cells, one of two
    // sizes one and a half times.
    double twice = -8.0;
    for (const auto& edge : edgesOf(cells.mesh))
    {
      twice += edge.second *
        glm::distance(cells.mesh.points[static_cast<std::size_t>(edge.first.first)],
          cells.mesh.points[static_cast<std::size_t>(edge.first.second)]);
    }
    EXPECT_NEAR(cells.lengthOf(cellBorders(cells.layer, cells.mesh, all)), 0.5 * twice, 1e-4);
  }
}

TEST(CellMesh, OddSurfaces)
{
  const Surface nothing;
  const Cells none(nothing, trianglesAsCells(nothing.mesh()), 0);
  EXPECT_TRUE(none.mesh.points.empty() && none.mesh.triangles.empty());
  EXPECT_TRUE(cellBorders(none.layer, none.mesh, {}).empty());

  Surface one;
  one.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  one.triangles = { { 0, 1, 2 }, { 0, 1, 1 } };
  SurfaceCellOptions options;
  options.baseCells = 1;
  const Cells single(one, trianglesAsCells(one.mesh(), options), 1);
  EXPECT_EQ(single.mesh.triangles.size(), 4u);
  EXPECT_EQ(single.mesh.points.size(), 6u);
  EXPECT_EQ(
    cellBorders(single.layer, single.mesh, std::vector<std::int32_t>{ 0, 1, 2, 3 }).size(), 3u);
}

TEST(CellMesh, WrongInputIsNamed)
{
  const Surface square = squareOf(1);
  const Cells cells(square, trianglesAsCells(square.mesh()), 0);
  EXPECT_EQ(messageOf([&] { cellMesh(square.mesh(), cells.layer, {}); }),
    "places: 0 for " + std::to_string(cells.cells.firstNode.back()) + " nodes");
  EXPECT_EQ(messageOf([&] { cellBorders(cells.layer, cells.mesh, {}); }),
    "labels: 0 for " + std::to_string(cells.layer.size()) + " cells");
}

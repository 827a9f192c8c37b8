// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/SurfaceCharts.h"
#include "TestSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

using namespace hachure;

namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

SurfaceCellOptions few(int baseCells)
{
  SurfaceCellOptions options;
  options.baseCells = baseCells;
  return options;
}

double flatArea(const std::array<glm::vec2, 3>& places)
{
  const glm::dvec2 one(places[1] - places[0]);
  const glm::dvec2 other(places[2] - places[0]);
  return 0.5 * (one.x * other.y - one.y * other.x);
}

void expectAllPlaced(const Surface& surface, const SurfaceCells& cells)
{
  ASSERT_EQ(cells.chartOfTriangle.size(), surface.triangles.size());
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const glm::ivec3& corners = surface.triangles[triangle];
    const bool isDegenerate = isDegenerateTriangle(surface.points[indexOf(corners.x)],
      surface.points[indexOf(corners.y)], surface.points[indexOf(corners.z)]);
    EXPECT_EQ(cells.chartOfTriangle[triangle] < 0, isDegenerate);
    for (const glm::vec2& place : cells.places[triangle])
    {
      EXPECT_TRUE(std::isfinite(place.x) && std::isfinite(place.y));
      EXPECT_LT(glm::length(place), 20.0f);
    }
  }
}
} // namespace

TEST(SurfaceChartsInput, CoarseMeshesKeepTheirTriangles)
{
  EXPECT_TRUE(surfaceCells({ {}, {}, {} }).charts.empty());
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 3);
  surface.patches.clear();
  surface.triangles.push_back({ 0, 0, 1 });
  const SurfaceCells cells = surfaceCells(surface.mesh());
  EXPECT_EQ(cells.charts.size(), 18u);
  EXPECT_EQ(cells.charts[0].level, -2);
  expectAllPlaced(surface, cells);
}

TEST(SurfaceChartsInput, PointsInOnePlaceAreJoined)
{
  for (const int n : { 3, 40 })
  {
    Surface surface;
    addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, n);
    Surface parts;
    for (const glm::ivec3& corners : surface.triangles)
    {
      const int first = static_cast<int>(parts.points.size());
      parts.triangles.push_back({ first, first + 1, first + 2 });
      for (int corner = 0; corner < 3; ++corner)
      {
        parts.points.push_back(surface.points[indexOf(corners[corner])]);
      }
    }
    const SurfaceCells cells = surfaceCells(surface.mesh());
    const SurfaceCells joined = surfaceCells(parts.mesh());
    EXPECT_EQ(joined.chartOfTriangle, cells.chartOfTriangle);
    EXPECT_EQ(joined.places, cells.places);
    for (std::size_t chart = 0; chart < cells.charts.size(); ++chart)
    {
      EXPECT_EQ(joined.charts[chart].neighbours, cells.charts[chart].neighbours);
    }
  }
}

// A floor of two triangles below a fine sphere.
TEST(SurfaceChartsInput, LargeTrianglesStayAsTheyAre)
{
  Surface surface;
  addSphere(surface, { 0, 0, 1.2 }, 1.0, 50);
  const std::size_t floor = surface.triangles.size();
  addGrid(surface, { -5, -5, 0 }, { 10, 0, 0 }, { 0, 10, 0 }, 1);
  surface.patches.clear();
  const SurfaceCells cells = surfaceCells(surface.mesh());
  expectAllPlaced(surface, cells);
  for (const std::size_t triangle : { floor, floor + 1 })
  {
    EXPECT_EQ(cells.charts[indexOf(cells.chartOfTriangle[triangle])].level, -3);
    EXPECT_NEAR(flatArea(cells.places[triangle]), 0.5, 1e-6);
  }
  EXPECT_LE(cells.charts.size(), 150u);
}

TEST(SurfaceChartsInput, CrumbsAreOneChartEach)
{
  Surface surface;
  addSphere(surface, { 0, 0, 0 }, 1.0, 50);
  const std::size_t sphere = surface.triangles.size();
  constexpr int crumbs = 30;
  for (int i = 0; i < crumbs; ++i)
  {
    addSphere(surface, { 2.0, 0.1 * i, 0 }, 0.004, 6);
  }
  const std::size_t each = (surface.triangles.size() - sphere) / crumbs;
  surface.patches.clear();
  const SurfaceCells cells = surfaceCells(surface.mesh());
  expectAllPlaced(surface, cells);
  std::set<std::int32_t> found;
  for (std::size_t triangle = sphere; triangle < surface.triangles.size(); ++triangle)
  {
    if (cells.chartOfTriangle[triangle] >= 0)
    {
      const std::int32_t chart = cells.chartOfTriangle[triangle];
      found.insert(chart);
      EXPECT_EQ(cells.chartOfTriangle[sphere + (triangle - sphere) / each * each], chart);
      EXPECT_EQ(cells.places[triangle][0], glm::vec2(1.0f / 3.0f));
      EXPECT_EQ(
        cells.charts[indexOf(chart)].neighbours, (std::array<std::int32_t, 3>{ -1, -1, -1 }));
    }
  }
  EXPECT_EQ(found.size(), static_cast<std::size_t>(crumbs));
}

TEST(SurfaceChartsInput, CopiesOfTrianglesShareTheirPlaces)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 30);
  surface.patches.clear();
  const SurfaceCells cells = surfaceCells(surface.mesh());
  const std::size_t count = surface.triangles.size();
  const glm::ivec3 copied = surface.triangles[700];
  surface.triangles.push_back({ copied.y, copied.z, copied.x });
  surface.triangles.push_back({ copied.x, copied.z, copied.y });
  const SurfaceCells more = surfaceCells(surface.mesh());
  expectAllPlaced(surface, more);
  EXPECT_EQ(more.charts.size(), cells.charts.size());
  for (const std::size_t copy : { count, count + 1 })
  {
    EXPECT_EQ(more.chartOfTriangle[copy], more.chartOfTriangle[700]);
  }
  EXPECT_EQ(more.places[count][0], more.places[700][1]);
  EXPECT_EQ(more.places[count + 1][1], more.places[700][2]);
}

// Charts end where more than two sheets meet.
TEST(SurfaceChartsInput, EdgesOfSeveralSheets)
{
  Surface book;
  for (const glm::dvec3& page : { glm::dvec3(1, 0, 0), { -1, 0, 0.2 }, { 0, 0, 1 } })
  {
    addGrid(book, { 0, 0, 0 }, page, { 0, 1, 0 }, 25);
  }
  book.patches.clear();
  const SurfaceCells cells = surfaceCells(book.mesh(), few(60));
  expectAllPlaced(book, cells);
  std::size_t flipped = 0;
  for (const auto& places : cells.places)
  {
    flipped += flatArea(places) > 0.0 ? 0 : 1;
  }
  EXPECT_LE(flipped, book.triangles.size() / 200);
  // No chart has triangles of two sheets.
  std::vector<int> sheets(cells.charts.size(), -1);
  for (std::size_t triangle = 0; triangle < book.triangles.size(); ++triangle)
  {
    int& sheet = sheets[indexOf(cells.chartOfTriangle[triangle])];
    const int own = static_cast<int>(triangle / (2 * 25 * 25));
    EXPECT_TRUE(sheet == -1 || sheet == own);
    sheet = own;
  }
}

TEST(SurfaceChartsInput, SheetsThatTouchInAPoint)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 20);
  addGrid(surface, { 0, 0, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, 20);
  surface.patches.clear();
  const SurfaceCells cells = surfaceCells(surface.mesh(), few(30));
  expectAllPlaced(surface, cells);
  EXPECT_LE(cells.charts.size(), 45u);
}

TEST(SurfaceChartsInput, TrianglesTurnedOverDoNotSplitCharts)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 40);
  surface.patches.clear();
  const SurfaceCells before = surfaceCells(surface.mesh(), few(40));
  for (std::size_t triangle = 100; triangle < surface.triangles.size(); triangle += 3)
  {
    std::swap(surface.triangles[triangle].y, surface.triangles[triangle].z);
  }
  const SurfaceCells after = surfaceCells(surface.mesh(), few(40));
  expectAllPlaced(surface, after);
  EXPECT_LE(after.charts.size(), before.charts.size() + 3);
  int wrong = 0;
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const bool isTurned = triangle >= 100 && triangle % 3 == 1;
    wrong += (flatArea(after.places[triangle]) < 0.0) == isTurned ? 0 : 1;
  }
  EXPECT_LE(wrong, 10);
}

TEST(SurfaceChartsInput, BandsWithOneSide)
{
  Surface surface;
  constexpr int around = 120;
  constexpr int across = 12;
  constexpr double pi = 3.14159265358979323846;
  addSheet(surface, around, across, false, false,
    [&](double s, double t)
    {
      const double width = 0.6 * (t - 0.5);
      const double radius = 1.0 + width * std::cos(pi * s);
      return glm::dvec3(
        radius * std::cos(2 * pi * s), radius * std::sin(2 * pi * s), width * std::sin(pi * s));
    });
  const SurfaceCells cells = surfaceCells(surface.mesh(), few(60));
  expectAllPlaced(surface, cells);
  // Where the orientation jumps charts continue, turned over.
  int turned = 0;
  for (const CellChart& chart : cells.charts)
  {
    for (const std::int32_t code : chart.neighbours)
    {
      turned += code >= 0 && code % 2 == 1 ? 1 : 0;
    }
  }
  EXPECT_GT(turned, 0);
}

TEST(SurfaceChartsInput, SoupOfTriangles)
{
  Surface surface;
  for (int i = 0; i < 900; ++i)
  {
    const auto random = [&](int dimension)
    { return unitRandom(7, static_cast<std::uint64_t>(i), static_cast<std::uint32_t>(dimension)); };
    const glm::dvec3 place(random(0), random(1), random(2));
    const int first = 3 * i;
    surface.points.push_back(place);
    surface.points.push_back(place + 0.1 * glm::dvec3(random(3), random(4), random(5)));
    surface.points.push_back(place + 0.1 * glm::dvec3(random(6), random(7), random(8)));
    surface.triangles.push_back({ first, first + 1, first + 2 });
  }
  const SurfaceCells cells = surfaceCells(surface.mesh());
  expectAllPlaced(surface, cells);
  EXPECT_EQ(cells.charts.size(), 900u);
  // Of few points, so that edges have dozens of triangles.
  for (glm::ivec3& corners : surface.triangles)
  {
    corners = glm::ivec3(corners.x % 29, corners.y % 30, corners.z % 31);
  }
  expectAllPlaced(surface, surfaceCells(surface.mesh()));
}

TEST(SurfaceChartsInput, RefusesWrongInput)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 20);
  EXPECT_THROW(surfaceCells(surface.mesh(), few(0)), std::invalid_argument);
  SurfaceCellOptions options;
  options.finestLevel = -1;
  EXPECT_THROW(surfaceCells(surface.mesh(), options), std::invalid_argument);
  surface.triangles[5].y = 100000;
  EXPECT_THROW(surfaceCells(surface.mesh()), std::invalid_argument);
  surface.triangles[5].y = 0;
  surface.points[0].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(surfaceCells(surface.mesh()), std::invalid_argument);
}

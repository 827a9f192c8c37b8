// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/NodePlaces.h"
#include "Core/SurfaceCharts.h"
#include "TestSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <omp.h>
#include <stdexcept>
#include <string>

using namespace hachure;

namespace
{
struct NamedSurface
{
  std::string name;
  Surface surface;
  double mostFlipped = 0.001; // share of triangles turned over
};

std::vector<NamedSurface> surfaces()
{
  std::vector<NamedSurface> all(5);
  all[0].name = "sphere";
  addSphere(all[0].surface, { 1, 2, 3 }, 2.0, 60);
  all[1].name = "torus";
  addTorus(all[1].surface, 1.0, 0.4, 60);
  all[2].name = "square";
  addGrid(all[2].surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 70, 1.5);
  all[3].name = "rough sphere";
  addSphere(all[3].surface, { 0, 0, 0 }, 1.0, 60, 0.01);
  all[3].mostFlipped = 0.003;
  all[4].name = "two sides of a bent sheet";
  addSheet(all[4].surface, 60, 60, false, false,
    [](double s, double t)
    { return glm::dvec3(s, t, 0.2 * std::sin(9.0 * s) * std::cos(7.0 * t)); });
  for (NamedSurface& named : all)
  {
    named.surface.patches.clear();
  }
  return all;
}

std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

double areaOf(const Surface& surface, std::size_t triangle)
{
  return 0.5 * glm::length(triangleAreaVector(surface.mesh(), static_cast<std::int64_t>(triangle)));
}

glm::vec3 weightsOf(const glm::vec2& place)
{
  return { 1.0f - place.x - place.y, place.x, place.y };
}

double flatArea(const std::array<glm::vec2, 3>& places)
{
  const glm::dvec2 one(places[1] - places[0]);
  const glm::dvec2 other(places[2] - places[0]);
  return 0.5 * (one.x * other.y - one.y * other.x);
}

// An edge in the charts of both of its triangles: weights of its ends.
struct SharedEdge
{
  std::array<std::int32_t, 2> charts;
  std::array<std::array<glm::vec3, 2>, 2> ends;
};

std::vector<SharedEdge> sharedEdges(const Surface& surface, const SurfaceCells& cells)
{
  std::map<std::pair<int, int>, std::vector<std::pair<std::size_t, int>>> edges;
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const glm::ivec3& corners = surface.triangles[triangle];
    for (int corner = 0; corner < 3 && cells.chartOfTriangle[triangle] >= 0; ++corner)
    {
      const int from = corners[corner];
      const int to = corners[(corner + 1) % 3];
      edges[{ std::min(from, to), std::max(from, to) }].emplace_back(triangle, corner);
    }
  }
  std::vector<SharedEdge> shared;
  for (const auto& edge : edges)
  {
    if (edge.second.size() == 2)
    {
      SharedEdge found{};
      for (std::size_t side = 0; side < 2; ++side)
      {
        const auto [triangle, corner] = edge.second[side];
        found.charts[side] = cells.chartOfTriangle[triangle];
        const bool ascends = surface.triangles[triangle][corner] == edge.first.first;
        const auto first = static_cast<std::size_t>(ascends ? corner : (corner + 1) % 3);
        const auto second = static_cast<std::size_t>(ascends ? (corner + 1) % 3 : corner);
        found.ends[side] = { weightsOf(cells.places[triangle][first]),
          weightsOf(cells.places[triangle][second]) };
      }
      shared.push_back(found);
    }
  }
  return shared;
}

// Whether the edge is in the same place for both, over at most `rims` rims.
bool isContinuous(const SurfaceCells& cells, const SharedEdge& edge, int rims)
{
  constexpr float tolerance = 1e-4f;
  if (edge.charts[0] == edge.charts[1] &&
    glm::length(edge.ends[0][0] - edge.ends[1][0]) < tolerance &&
    glm::length(edge.ends[0][1] - edge.ends[1][1]) < tolerance)
  {
    return true;
  }
  for (int side = 0; side < 3 && rims > 0; ++side)
  {
    const std::int32_t code =
      cells.charts[indexOf(edge.charts[0])].neighbours[static_cast<std::size_t>(side)];
    if (code >= 0)
    {
      SharedEdge next = edge;
      next.charts[0] = code / 6;
      for (glm::vec3& end : next.ends[0])
      {
        end = glsl::weightsAcross(end, side, code % 6 / 2, code % 2 == 1);
      }
      if (isContinuous(cells, next, rims - 1))
      {
        return true;
      }
    }
  }
  return false;
}
} // namespace

// Every triangle with an area has a chart, in which it is not turned over, and charts have the
// areas of their triangles, about as large as was asked for.
TEST(SurfaceCharts, CoverTheSurface)
{
  for (const NamedSurface& named : surfaces())
  {
    SCOPED_TRACE(named.name);
    const SurfaceCells cells = surfaceCells(named.surface.mesh());
    std::vector<double> areas(cells.charts.size(), 0.0);
    double all = 0.0;
    int flipped = 0;
    for (std::size_t triangle = 0; triangle < named.surface.triangles.size(); ++triangle)
    {
      const std::int32_t chart = cells.chartOfTriangle[triangle];
      const double area = areaOf(named.surface, triangle);
      EXPECT_EQ(chart < 0, area < 1e-12);
      if (chart >= 0)
      {
        areas[indexOf(chart)] += area;
        all += area;
        flipped += flatArea(cells.places[triangle]) > 0.0 ? 0 : 1;
      }
    }
    EXPECT_NEAR(cells.cellArea, all / 144.0, 1e-9 * all);
    EXPECT_LE(flipped, named.mostFlipped * static_cast<double>(named.surface.triangles.size()));
    int odd = 0;
    for (std::size_t chart = 0; chart < cells.charts.size(); ++chart)
    {
      EXPECT_NEAR(cells.charts[chart].area, areas[chart], 1e-9 * all);
      odd += std::abs(std::log2(areas[chart] / cells.cellArea)) > 1.6 ? 1 : 0;
    }
    RecordProperty(named.name + " flipped", flipped);
    EXPECT_LE(odd, named.name == "rough sphere" ? 15 : 4);
    EXPECT_GE(cells.charts.size(), 143u);
    EXPECT_LE(cells.charts.size(), 150u);
  }
}

// Nine of ten points of the surface lie in cells that differ by less than a factor of three.
TEST(SurfaceCharts, CellsHaveSimilarAreas)
{
  for (const NamedSurface& named : surfaces())
  {
    SCOPED_TRACE(named.name);
    const SurfaceCells cells = surfaceCells(named.surface.mesh());
    double all = 0.0;
    double fine = 0.0;
    for (std::size_t triangle = 0; triangle < named.surface.triangles.size(); ++triangle)
    {
      if (cells.chartOfTriangle[triangle] >= 0)
      {
        const CellChart& chart = cells.charts[indexOf(cells.chartOfTriangle[triangle])];
        const double area = areaOf(named.surface, triangle);
        // Of a cell at a level that is finer than that of all charts.
        const double cell =
          area / (2.0 * flatArea(cells.places[triangle])) * std::pow(4.0, chart.level);
        all += area;
        fine += cell > 0.5 * cells.cellArea && cell < 2.0 * cells.cellArea ? area : 0.0;
      }
    }
    EXPECT_GT(fine, (named.name == "rough sphere" ? 0.7 : 0.88) * all);
  }
}

TEST(SurfaceCharts, ContinueOverRims)
{
  for (const NamedSurface& named : surfaces())
  {
    SCOPED_TRACE(named.name);
    const SurfaceCells cells = surfaceCells(named.surface.mesh());
    const std::vector<SharedEdge> edges = sharedEdges(named.surface, cells);
    int across = 0;
    int broken = 0;
    for (const SharedEdge& edge : edges)
    {
      across += edge.charts[0] != edge.charts[1] ? 1 : 0;
      broken += isContinuous(cells, edge, 4) ? 0 : 1;
    }
    EXPECT_GT(across, 500);
    EXPECT_LE(broken, 4e-3 * across);
    RecordProperty(named.name + " broken", broken);
  }
}

TEST(SurfaceCharts, NeighboursKnowEachOther)
{
  for (const NamedSurface& named : surfaces())
  {
    SCOPED_TRACE(named.name);
    const SurfaceCells cells = surfaceCells(named.surface.mesh());
    int rims = 0;
    for (std::size_t chart = 0; chart < cells.charts.size(); ++chart)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const std::int32_t code = cells.charts[chart].neighbours[static_cast<std::size_t>(edge)];
        if (code < 0)
        {
          ++rims;
          continue;
        }
        const CellChart& other = cells.charts[indexOf(code / 6)];
        const int across = code % 6 / 2;
        EXPECT_EQ(code % 2, 0);
        EXPECT_EQ(other.neighbours[static_cast<std::size_t>(across)],
          6 * static_cast<std::int32_t>(chart) + 2 * edge);
        EXPECT_EQ(other.corners[(across + 1) % 3], cells.charts[chart].corners[(edge + 2) % 3]);
        EXPECT_EQ(other.corners[(across + 2) % 3], cells.charts[chart].corners[(edge + 1) % 3]);
      }
    }
    const bool isOpen = named.name == "square" || named.name == "two sides of a bent sheet";
    EXPECT_EQ(rims > 0, isOpen);
  }
}

// The border of the surface is that of its charts.
TEST(SurfaceCharts, BordersLieOnRims)
{
  const Surface surface = surfaces()[2].surface;
  const SurfaceCells cells = surfaceCells(surface.mesh());
  const auto side = [](const glm::dvec3& point) {
    return point.x == 0.0 ? 1 : (point.x == 1.0 ? 2 : (point.y == 0.0 ? 3 : 4 * (point.y == 1.0)));
  };
  int edges = 0;
  int off = 0;
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const CellChart& chart = cells.charts[indexOf(cells.chartOfTriangle[triangle])];
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const glm::ivec3& corners = surface.triangles[triangle];
      const auto next = (corner + 1) % 3;
      const int own = side(surface.points[indexOf(corners[static_cast<int>(corner)])]);
      if (own == 0 || own != side(surface.points[indexOf(corners[static_cast<int>(next)])]))
      {
        continue;
      }
      ++edges;
      // One end is in the chart, on a rim without a neighbour, unless the triangle is in the chart
      // of its third corner.
      float nearest = 1.0f;
      for (int edge = 0; edge < 3; ++edge)
      {
        const float from = std::abs(weightsOf(cells.places[triangle][corner])[edge]);
        const float to = std::abs(weightsOf(cells.places[triangle][next])[edge]);
        nearest = chart.neighbours[static_cast<std::size_t>(edge)] < 0
          ? std::min(nearest, std::min(from, to))
          : nearest;
      }
      off += nearest < 1e-4f ? 0 : 1;
    }
  }
  EXPECT_GE(edges, 4 * 70 - 4);
  EXPECT_LE(off, edges / 15);
}

// Nodes lie where the triangle under them has their coordinates.
TEST(SurfaceCharts, NodesHavePlaces)
{
  for (const NamedSurface& named : surfaces())
  {
    SCOPED_TRACE(named.name);
    const SurfaceCells cells = surfaceCells(named.surface.mesh());
    const std::vector<NodePlace> places = nodePlaces(named.surface.mesh(), cells);
    std::size_t own = 0;
    std::size_t wrong = 0;
    for (std::size_t chart = 0; chart < cells.charts.size(); ++chart)
    {
      const int subdivisions = subdivisionsOf(cells.charts[chart], cells.finestLevel);
      const std::vector<glm::vec2> coordinates = nodeCoordinates(subdivisions);
      const auto first = static_cast<std::size_t>(firstNodeOf(cells, chart, cells.finestLevel));
      for (std::size_t node = 0; node < coordinates.size(); ++node)
      {
        const NodePlace& place = places[first + node];
        ASSERT_GE(place.triangle, 0);
        const auto triangle = indexOf(place.triangle);
        if (indexOf(cells.chartOfTriangle[triangle]) == chart)
        {
          const auto& corners = cells.places[triangle];
          const glm::vec3 weights = weightsOf(place.weights);
          const glm::vec2 found =
            weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
          wrong += glm::length(found - coordinates[node]) > 1e-4f ? 1 : 0;
          ++own;
        }
      }
    }
    EXPECT_GT(own, 20000u);
    EXPECT_LE(wrong, own / 1000);
  }
}

TEST(SurfaceCharts, AreTheSameForAnyNumberOfThreads)
{
  const Surface surface = surfaces()[3].surface;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const SurfaceCells one = surfaceCells(surface.mesh());
  omp_set_num_threads(4);
  const SurfaceCells four = surfaceCells(surface.mesh());
  omp_set_num_threads(before);
  EXPECT_EQ(one.chartOfTriangle, four.chartOfTriangle);
  EXPECT_EQ(one.places, four.places);
  EXPECT_EQ(one.firstNode, four.firstNode);
}

TEST(SurfaceCharts, ReportsProgressAndStops)
{
  const Surface surface = surfaces()[0].surface;
  double last = -1.0;
  const SurfaceCells cells = surfaceCells(surface.mesh(), {},
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    });
  EXPECT_FALSE(cells.charts.empty());
  EXPECT_GT(last, 0.7);
  EXPECT_LE(last, 1.0);
  for (const double limit : { 0.0, 0.8 })
  {
    const SurfaceCells stopped =
      surfaceCells(surface.mesh(), {}, [&](double fraction) { return fraction < limit; });
    EXPECT_TRUE(stopped.charts.empty());
    EXPECT_TRUE(stopped.chartOfTriangle.empty());
  }
}

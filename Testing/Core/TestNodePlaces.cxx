// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/NodePlaces.h"
#include "TestSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace hachure;

namespace
{
glm::dvec3 pointUnder(const Surface& surface, const NodePlace& place)
{
  const glm::ivec3& corners = surface.triangles.at(static_cast<std::size_t>(place.triangle));
  const glm::dvec2 weights(place.weights);
  return (1.0 - weights.x - weights.y) * surface.points[static_cast<std::size_t>(corners.x)] +
    weights.x * surface.points[static_cast<std::size_t>(corners.y)] +
    weights.y * surface.points[static_cast<std::size_t>(corners.z)];
}

// Calls visit(chart, level, coordinates, place) for all nodes.
template <class Visit>
void visitPlaces(const SurfaceCells& cells, const std::vector<NodePlace>& places, Visit&& visit)
{
  ASSERT_EQ(places.size(), static_cast<std::size_t>(cells.firstNode.back()));
  for (std::size_t chart = 0; chart < cells.charts.size(); ++chart)
  {
    for (int level = 0; level <= cells.finestLevel; ++level)
    {
      const std::vector<glm::vec2> coordinates =
        nodeCoordinates(subdivisionsOf(cells.charts[chart], level));
      for (std::size_t node = 0; node < coordinates.size(); ++node)
      {
        const auto first = static_cast<std::size_t>(firstNodeOf(cells, chart, level));
        visit(chart, level, coordinates[node], places[first + node]);
      }
    }
  }
}

// The unit square as two charts, on a grid that is turned against it: triangles reach over the rim
// between the two, and over those of the square.
struct TurnedGrid
{
  Surface surface;
  SurfaceCells cells;

  explicit TurnedGrid(int n, bool isMirrored)
  {
    const double turn = 0.3;
    const glm::dvec3 u(1.6 * std::cos(turn), 1.6 * std::sin(turn), 0.0);
    addGrid(this->surface, glm::dvec3(-0.03, -0.5, 0.0), u, glm::dvec3(-u.y, u.x, 0.0), n);
    // The second one's corners: (1,1), then (0,1) and (1,0) in either order.
    this->cells.charts.resize(2);
    this->cells.charts[0].corners = { 0, 1, 2 };
    this->cells.charts[1].corners = isMirrored ? glm::ivec3(3, 1, 2) : glm::ivec3(3, 2, 1);
    for (CellChart& chart : this->cells.charts)
    {
      chart.area = 0.5;
    }
    for (const glm::ivec3& corners : this->surface.triangles)
    {
      glm::dvec3 centre(0.0);
      for (int corner = 0; corner < 3; ++corner)
      {
        centre += this->surface.points[static_cast<std::size_t>(corners[corner])] / 3.0;
      }
      const std::int32_t chart = centre.x + centre.y > 1.0 ? 1 : 0;
      std::array<glm::vec2, 3> places;
      for (int corner = 0; corner < 3; ++corner)
      {
        const glm::vec2 point(this->surface.points[static_cast<std::size_t>(corners[corner])]);
        const glm::vec2 beyond = glm::vec2(1.0f) - point;
        places[static_cast<std::size_t>(corner)] =
          chart == 0 ? point : (isMirrored ? glm::vec2(beyond.y, beyond.x) : beyond);
      }
      this->cells.chartOfTriangle.push_back(chart);
      this->cells.places.push_back(places);
    }
    detail::linkCharts(this->cells.charts);
    SurfaceCellOptions options;
    options.baseCells = 2;
    options.finestLevel = 4;
    detail::numberNodes(this->cells, options);
  }

  glm::dvec3 at(std::size_t chart, const glm::vec2& place) const
  {
    const glm::dvec2 along(place);
    const bool isMirrored = this->cells.charts[1].corners.y == 1;
    return chart == 0 ? glm::dvec3(along, 0.0)
                      : (isMirrored ? glm::dvec3(1.0 - along.y, 1.0 - along.x, 0.0)
                                    : glm::dvec3(1.0 - along.x, 1.0 - along.y, 0.0));
  }
};
} // namespace

TEST(NodePlaces, CoordinatesAreThoseThatTheShaderAsksFor)
{
  for (int subdivisions = 0; subdivisions <= 4; ++subdivisions)
  {
    const std::vector<glm::vec2> coordinates = nodeCoordinates(subdivisions);
    const int segments = 1 << subdivisions;
    // At a corner, a centre or a middle, one node has all of the weight.
    for (std::size_t node = 0; node < coordinates.size(); ++node)
    {
      const glsl::NodeMix mix = glsl::nodesAt(coordinates[node], segments);
      float weight = 0.0f;
      for (int i = 0; i < 3; ++i)
      {
        const int other = i == 0 ? mix.cell : (i == 1 ? mix.corner : mix.next);
        weight += other == static_cast<int>(node) ? mix.weights[i] : 0.0f;
      }
      EXPECT_NEAR(weight, 1.0f, 1e-4f) << node << " of " << segments;
    }
  }
}

TEST(NodePlaces, LieWhereTheirTriangleIsWhenTrianglesAreCharts)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 3, 0, 1 }, { 0, 2, 0.5 }, 3, 2.0);
  SurfaceCellOptions options;
  options.baseCells = 40;
  options.finestLevel = 3;
  const SurfaceCells cells = trianglesAsCells(surface.mesh(), options);
  visitPlaces(cells, nodePlaces(surface.mesh(), cells),
    [&](std::size_t chart, int, const glm::vec2& coordinates, const NodePlace& place)
    {
      EXPECT_EQ(place.triangle, static_cast<std::int32_t>(chart));
      EXPECT_LT(glm::length(place.weights - coordinates), 1e-5f);
    });
}

TEST(NodePlaces, AreFoundUnderTrianglesOfNeighbouringCharts)
{
  for (const bool isMirrored : { false, true })
  {
    for (const int n : { 3, 10, 61 })
    {
      const TurnedGrid grid(n, isMirrored);
      visitPlaces(grid.cells, nodePlaces(grid.surface.mesh(), grid.cells),
        [&](std::size_t chart, int level, const glm::vec2& coordinates, const NodePlace& place)
        {
          ASSERT_GE(place.triangle, 0);
          EXPECT_LT(
            glm::length(pointUnder(grid.surface, place) - grid.at(chart, coordinates)), 1e-5)
            << n << " chart " << chart << " level " << level;
        });
    }
  }
}

// Where the surface ends within its chart, nodes lie on its border, as close as they can.
TEST(NodePlaces, AreTheClosestWhereTheSurfaceEnds)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 5);
  SurfaceCells cells;
  cells.charts.resize(1);
  cells.charts[0].corners = { 0, 1, 2 };
  cells.charts[0].area = 0.16;
  for (const glm::ivec3& corners : surface.triangles)
  {
    cells.chartOfTriangle.push_back(0);
    const auto at = [&](int corner)
    { return glm::vec2(surface.points[static_cast<std::size_t>(corners[corner])]); };
    cells.places.push_back({ at(0), at(1), at(2) });
  }
  SurfaceCellOptions options;
  options.baseCells = 1;
  options.finestLevel = 3;
  detail::numberNodes(cells, options);
  visitPlaces(cells, nodePlaces(surface.mesh(), cells),
    [&](std::size_t, int, const glm::vec2& coordinates, const NodePlace& place)
    {
      const glm::dvec3 closest(glm::min(glm::dvec2(coordinates), glm::dvec2(0.4)), 0.0);
      EXPECT_LT(glm::length(pointUnder(surface, place) - closest), 1e-6);
    });
}

TEST(NodePlaces, OddCells)
{
  EXPECT_TRUE(nodePlaces({ {}, {}, {} }, trianglesAsCells({ {}, {}, {} })).empty());
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  surface.patches.clear();
  surface.triangles.push_back({ 0, 0, 1 });
  SurfaceCells cells = trianglesAsCells(surface.mesh());
  for (const NodePlace& place : nodePlaces(surface.mesh(), cells))
  {
    EXPECT_GE(place.triangle, 0);
    EXPECT_LT(place.triangle, 2);
  }
  // All of a piece of surface in one point of its chart.
  cells.places[0].fill(glm::vec2(1.0f / 3.0f));
  EXPECT_EQ(nodePlaces(surface.mesh(), cells)[0].triangle, 0);
  // A chart without triangles.
  cells.chartOfTriangle[0] = -1;
  EXPECT_EQ(nodePlaces(surface.mesh(), cells)[0].triangle, -1);
}

TEST(NodePlaces, RefusesWrongInput)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2);
  SurfaceCells cells = trianglesAsCells(surface.mesh());
  surface.points[0].x = std::nan("");
  EXPECT_THROW(nodePlaces(surface.mesh(), cells), std::invalid_argument);
  surface.points[0].x = 0.0;
  cells.chartOfTriangle[0] = 1000;
  EXPECT_THROW(nodePlaces(surface.mesh(), cells), std::invalid_argument);
  cells.chartOfTriangle.pop_back();
  EXPECT_THROW(nodePlaces(surface.mesh(), cells), std::invalid_argument);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCells.h"

#include "Kernels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{
namespace
{
// An edge of a chart, which runs from the lower to the higher corner or the other way.
struct ChartEdge
{
  std::int32_t chart;
  int edge;
  bool ascends;
};

std::map<std::pair<int, int>, std::vector<ChartEdge>> edgesOf(const std::vector<CellChart>& charts)
{
  std::map<std::pair<int, int>, std::vector<ChartEdge>> edges;
  for (std::size_t chart = 0; chart < charts.size(); ++chart)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const int from = charts[chart].corners[(edge + 1) % 3];
      const int to = charts[chart].corners[(edge + 2) % 3];
      edges[std::minmax(from, to)].push_back({ static_cast<std::int32_t>(chart), edge, from < to });
    }
  }
  return edges;
}

std::int32_t neighbourCode(const ChartEdge& to, bool alike)
{
  return 6 * to.chart + 2 * to.edge + (alike ? 1 : 0);
}

std::int64_t nodesOfChart(const CellChart& chart, int finestLevel)
{
  std::int64_t nodes = 0;
  for (int level = 0; level <= finestLevel; ++level)
  {
    nodes += glsl::chartNodes(subdivisionsOf(chart, level));
  }
  return nodes;
}

std::int64_t nodesOfAll(const SurfaceCells& cells, int finestLevel)
{
  std::int64_t nodes = 0;
  for (const CellChart& chart : cells.charts)
  {
    nodes += nodesOfChart(chart, finestLevel);
  }
  return nodes;
}

// Of an area: the level whose cells have that area, where cells of level 0 have `cellArea`.
int levelOf(double area, double cellArea)
{
  constexpr double quarters = 4.0;
  const double level = std::round(std::log(cellArea / area) / std::log(quarters));
  return static_cast<int>(
    std::clamp(level, -static_cast<double>(maximumCellLevel), maximumCellLevel + 1.0));
}
} // namespace

namespace detail
{
void checkOptions(const SurfaceCellOptions& options)
{
  if (options.baseCells < 1)
  {
    throw std::invalid_argument(
      "baseCells is " + std::to_string(options.baseCells) + "; expected at least 1");
  }
  if (options.finestLevel < 0 || options.finestLevel > maximumCellLevel)
  {
    throw std::invalid_argument("finestLevel is " + std::to_string(options.finestLevel) +
      "; expected 0 to " + std::to_string(maximumCellLevel));
  }
}

void linkCharts(std::vector<CellChart>& charts)
{
  for (const auto& shared : edgesOf(charts))
  {
    const std::vector<ChartEdge>& edges = shared.second;
    if (edges.size() != 2 || shared.first.first == shared.first.second)
    {
      continue;
    }
    const bool alike = edges[0].ascends == edges[1].ascends;
    for (std::size_t side = 0; side < 2; ++side)
    {
      const ChartEdge& own = edges[side];
      charts[static_cast<std::size_t>(own.chart)].neighbours[static_cast<std::size_t>(own.edge)] =
        neighbourCode(edges[1 - side], alike);
    }
  }
}

void numberNodes(SurfaceCells& cells, const SurfaceCellOptions& options)
{
  double area = 0.0;
  for (const CellChart& chart : cells.charts)
  {
    area += chart.area;
  }
  cells.cellArea = area / options.baseCells;
  for (CellChart& chart : cells.charts)
  {
    chart.level = levelOf(chart.area, cells.cellArea);
  }
  const std::int64_t most =
    std::min<std::int64_t>(options.mostNodes, std::numeric_limits<std::int32_t>::max());
  cells.finestLevel = options.finestLevel;
  while (cells.finestLevel > 0 && nodesOfAll(cells, cells.finestLevel) > most)
  {
    --cells.finestLevel;
  }
  std::int64_t node = 0;
  cells.firstNode.clear();
  cells.firstNode.reserve(cells.charts.size() + 1);
  for (const CellChart& chart : cells.charts)
  {
    cells.firstNode.push_back(static_cast<std::int32_t>(node));
    node += nodesOfChart(chart, cells.finestLevel);
  }
  if (node > std::numeric_limits<std::int32_t>::max())
  {
    throw std::invalid_argument("the mesh has so many charts, " +
      std::to_string(cells.charts.size()) + ", that their nodes cannot be numbered");
  }
  cells.firstNode.push_back(static_cast<std::int32_t>(node));
}
} // namespace detail

std::int64_t firstNodeOf(const SurfaceCells& cells, std::size_t chart, int level)
{
  const int first = cells.charts[chart].level;
  const std::int64_t node = cells.firstNode[chart];
  if (level <= first)
  {
    return node + static_cast<std::int64_t>(level) * glsl::chartNodes(0);
  }
  const std::int64_t below = first >= 0 ? static_cast<std::int64_t>(first) * glsl::chartNodes(0)
                                        : -static_cast<std::int64_t>(glsl::chartNodesBelow(-first));
  return node + below + glsl::chartNodesBelow(level - first);
}

void checkSurfaceCells(const TriangleMesh& mesh, const SurfaceCells& cells)
{
  const std::size_t triangles = mesh.triangles.size();
  if (cells.chartOfTriangle.size() != triangles || cells.places.size() != triangles)
  {
    throw std::invalid_argument(
      "cells.chartOfTriangle: " + std::to_string(cells.chartOfTriangle.size()) + " for " +
      std::to_string(triangles) + " triangles");
  }
  if (!cells.charts.empty() && cells.firstNode.size() != cells.charts.size() + 1)
  {
    throw std::invalid_argument("cells.firstNode: " + std::to_string(cells.firstNode.size()) +
      " for " + std::to_string(cells.charts.size()) + " charts");
  }
  for (const std::int32_t chart : cells.chartOfTriangle)
  {
    if (chart < -1 || chart >= static_cast<std::int64_t>(cells.charts.size()))
    {
      throw std::invalid_argument("cells.chartOfTriangle: " + std::to_string(chart) +
        " is not one of the " + std::to_string(cells.charts.size()) + " charts");
    }
  }
}

SurfaceCells trianglesAsCells(const TriangleMesh& mesh, const SurfaceCellOptions& options)
{
  checkTriangleMesh(mesh);
  detail::checkOptions(options);
  SurfaceCells cells;
  cells.chartOfTriangle.reserve(mesh.triangles.size());
  const std::array<glm::vec2, 3> whole = { glm::vec2(0.0f), glm::vec2(1.0f, 0.0f),
    glm::vec2(0.0f, 1.0f) };
  cells.places.assign(mesh.triangles.size(), whole);
  cells.charts.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const glm::ivec3& corners = mesh.triangles[i];
    const auto point = [&](int corner) -> const glm::dvec3&
    { return mesh.points[static_cast<std::size_t>(corners[corner])]; };
    if (isDegenerateTriangle(point(0), point(1), point(2)))
    {
      cells.chartOfTriangle.push_back(-1);
      continue;
    }
    cells.chartOfTriangle.push_back(static_cast<std::int32_t>(cells.charts.size()));
    CellChart chart;
    chart.corners = corners;
    chart.area = 0.5 * glm::length(triangleAreaVector(mesh, static_cast<std::int64_t>(i)));
    cells.charts.push_back(chart);
  }
  detail::linkCharts(cells.charts);
  detail::numberNodes(cells, options);
  return cells;
}

} // namespace hachure

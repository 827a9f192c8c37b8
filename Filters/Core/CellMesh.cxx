// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh.h"

#include "Kernels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{
namespace
{
// Corners of a cell, in the order of nodesAt()'s weights.
std::array<glm::ivec2, 3> cornersOf(const CellSpot& spot)
{
  const glm::ivec2 here(spot.column, spot.row);
  if (spot.odd != 0)
  {
    return { here + glm::ivec2(1, 1), here + glm::ivec2(0, 1), here + glm::ivec2(1, 0) };
  }
  return { here, here + glm::ivec2(1, 0), here + glm::ivec2(0, 1) };
}

// The corner of the chart that a corner of cells is; -1: none.
int chartCornerAt(const glm::ivec2& corner, int segments)
{
  if (corner == glm::ivec2(0))
  {
    return 0;
  }
  return corner.x == segments ? 1 : (corner.y == segments ? 2 : -1);
}

// The rim on which a corner of cells lies that is no corner of the chart.
RimPlace rimAt(std::int32_t chart, const glm::ivec2& corner, int segments)
{
  if (corner.y == 0)
  {
    return { chart, 2, static_cast<double>(corner.x) };
  }
  if (corner.x == 0)
  {
    return { chart, 1, static_cast<double>(corner.y) };
  }
  const bool isOnSlope = corner.x + corner.y == segments;
  return { isOnSlope ? chart : -1, 0, static_cast<double>(corner.y) };
}

// Finds the points of corners: each is made by the first chart that has it.
class CornerPoints
{
public:
  CornerPoints(const TriangleMesh& ofMesh, const CellLayer& ofLayer, Span<const NodePlace> ofNodes)
    : mesh(ofMesh)
    , layer(ofLayer)
    , places(ofNodes)
  {
    const auto charts = static_cast<std::int32_t>(ofLayer.surface().charts.size());
    this->first.reserve(static_cast<std::size_t>(charts) + 1);
    this->first.push_back(0);
    for (std::int32_t chart = 0; chart < charts; ++chart)
    {
      const std::int64_t segments = ofLayer.segmentsOf(chart);
      this->first.push_back(this->first.back() + (segments + 1) * (segments + 2) / 2);
    }
    this->points.assign(static_cast<std::size_t>(this->first.back()), -1);
    for (std::int32_t chart = 0; chart < charts; ++chart)
    {
      this->find(chart);
    }
  }

  std::int32_t at(std::int32_t chart, const glm::ivec2& corner) const
  {
    return this->points[this->indexOf(chart, corner)];
  }
  std::vector<glm::dvec3> found;

private:
  std::size_t indexOf(std::int32_t chart, const glm::ivec2& corner) const
  {
    const int segments = this->layer.segmentsOf(chart);
    const int before = segments * segments; // nodes of cells
    return static_cast<std::size_t>(this->first[static_cast<std::size_t>(chart)] +
      glsl::cornerNode(corner.x, corner.y, segments) - before);
  }

  void find(std::int32_t chart)
  {
    const int segments = this->layer.segmentsOf(chart);
    for (int row = 0; row <= segments; ++row)
    {
      for (int column = 0; column <= segments - row; ++column)
      {
        const glm::ivec2 corner(column, row);
        std::int32_t& point = this->points[this->indexOf(chart, corner)];
        point = this->sharedPoint(chart, corner, segments);
        point = point >= 0 ? point : this->newPoint(chart, corner, segments);
      }
    }
  }

  // Of a chart before; -1: there is none.
  std::int32_t sharedPoint(std::int32_t chart, const glm::ivec2& corner, int segments)
  {
    const int number = chartCornerAt(corner, segments);
    if (number >= 0)
    {
      const auto known = this->chartCorners.find(this->nameOf(chart, number));
      return known == this->chartCorners.end() ? -1 : known->second;
    }
    const RimPlace own = rimAt(chart, corner, segments);
    const RimPlace other = own.chart < 0 ? own : acrossRim(this->layer, own);
    if (other.chart < 0 || other.chart > chart || other.along != std::floor(other.along))
    {
      return -1;
    }
    return this->at(other.chart,
      rimCorner(other.edge, static_cast<int>(other.along), this->layer.segmentsOf(other.chart)));
  }

  std::int32_t newPoint(std::int32_t chart, const glm::ivec2& corner, int segments)
  {
    const auto node = static_cast<std::size_t>(
      this->layer.firstNode(chart) + glsl::cornerNode(corner.x, corner.y, segments));
    const NodePlace& place = this->places[node];
    if (place.triangle < 0)
    {
      return -1;
    }
    const glm::ivec3& corners = this->mesh.triangles[static_cast<std::size_t>(place.triangle)];
    const auto at = [&](int i) -> const glm::dvec3&
    { return this->mesh.points[static_cast<std::size_t>(corners[i])]; };
    const glm::dvec2 weights(place.weights);
    const auto point = static_cast<std::int32_t>(this->found.size());
    this->found.push_back(
      (1.0 - weights.x - weights.y) * at(0) + weights.x * at(1) + weights.y * at(2));
    const int number = chartCornerAt(corner, segments);
    if (number >= 0)
    {
      this->chartCorners.emplace(this->nameOf(chart, number), point);
    }
    return point;
  }

  int nameOf(std::int32_t chart, int corner) const
  {
    return this->layer.surface().charts[static_cast<std::size_t>(chart)].corners[corner];
  }

  const TriangleMesh& mesh;
  const CellLayer& layer;
  Span<const NodePlace> places;
  std::vector<std::int64_t> first;  // corner of every chart, and the number of all
  std::vector<std::int32_t> points; // of every corner
  std::map<int, std::int32_t> chartCorners;
};

void requireCount(const char* name, std::size_t found, std::size_t expected, const char* of)
{
  if (found != expected)
  {
    throw std::invalid_argument(std::string(name)
                                  .append(": ")
                                  .append(std::to_string(found))
                                  .append(" for ")
                                  .append(std::to_string(expected))
                                  .append(of));
  }
}

CellSpot spotOf(const CellLayer& layer, std::int32_t cell)
{
  const std::int32_t chart = layer.chartOf(cell);
  return cellSpot(cell - layer.firstOf(chart), layer.segmentsOf(chart));
}

// The cell on the other side of an edge, which is the edge's owner: of two cells with the edge in
// common the lower one, of a large and a small one the small one; -1: it is not, or there is none.
std::int32_t ownedNeighbour(const CellLayer& layer, std::int32_t cell, int edge)
{
  const std::int32_t chart = layer.chartOf(cell);
  const int segments = layer.segmentsOf(chart);
  const CellSpot spot = spotOf(layer, cell);
  if (!isOnRim(spot, edge, segments))
  {
    const CellSpot inside = spotAcross(spot, edge);
    const std::int32_t other =
      layer.firstOf(chart) + glsl::cellNode(inside.column, inside.row, inside.odd, segments);
    return cell < other ? other : -1;
  }
  const RimPlace middle =
    acrossRim(layer, { chart, edge, (edge == 2 ? spot.column : spot.row) + 0.5 });
  if (middle.chart < 0 || layer.segmentsOf(middle.chart) > segments)
  {
    return -1;
  }
  const int others = layer.segmentsOf(middle.chart);
  const CellSpot rim = rimCell(middle.edge, static_cast<int>(middle.along), others);
  const std::int32_t other =
    layer.firstOf(middle.chart) + glsl::cellNode(rim.column, rim.row, rim.odd, others);
  return others < segments || cell < other ? other : -1;
}
} // namespace

CellMesh cellMesh(const TriangleMesh& mesh, const CellLayer& layer, Span<const NodePlace> places)
{
  const std::vector<std::int32_t>& nodes = layer.surface().firstNode;
  requireCount(
    "places", places.size(), nodes.empty() ? 0 : static_cast<std::size_t>(nodes.back()), " nodes");
  CornerPoints corners(mesh, layer, places);
  CellMesh result;
  result.triangles.reserve(static_cast<std::size_t>(layer.size()));
  for (std::int32_t cell = 0; cell < layer.size(); ++cell)
  {
    const std::int32_t chart = layer.chartOf(cell);
    glm::ivec3 triangle;
    const std::array<glm::ivec2, 3> spots = cornersOf(spotOf(layer, cell));
    for (int corner = 0; corner < 3; ++corner)
    {
      triangle[corner] = corners.at(chart, spots[static_cast<std::size_t>(corner)]);
    }
    const bool isWhole = triangle.x >= 0 && triangle.y >= 0 && triangle.z >= 0;
    result.triangles.push_back(isWhole ? triangle : glm::ivec3(-1));
  }
  result.points = std::move(corners.found);
  return result;
}

std::vector<CellBorder> cellBorders(
  const CellLayer& layer, const CellMesh& mesh, Span<const std::int32_t> labels)
{
  requireCount("labels", labels.size(), static_cast<std::size_t>(layer.size()), " cells");
  requireCount("mesh.triangles", mesh.triangles.size(), labels.size(), " cells");
  std::vector<CellBorder> borders;
  borders.reserve(labels.size() / 4);
  for (std::int32_t cell = 0; cell < layer.size(); ++cell)
  {
    const glm::ivec3& corners = mesh.triangles[static_cast<std::size_t>(cell)];
    for (int edge = 0; edge < 3 && corners.x >= 0; ++edge)
    {
      const std::int32_t other = ownedNeighbour(layer, cell, edge);
      if (other >= 0 && mesh.triangles[static_cast<std::size_t>(other)].x >= 0 &&
        labels[static_cast<std::size_t>(cell)] != labels[static_cast<std::size_t>(other)])
      {
        borders.push_back({ { corners[(edge + 1) % 3], corners[(edge + 2) % 3] },
          { std::min(cell, other), std::max(cell, other) } });
      }
    }
  }
  return borders;
}

} // namespace hachure

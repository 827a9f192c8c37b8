// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellLayers.h"

#include "Kernels.h"

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
int numberOf(const CellSpot& spot, int segments)
{
  return glsl::cellNode(spot.column, spot.row, spot.odd, segments);
}
} // namespace

ChartPlace placeInside(const SurfaceCells& cells, ChartPlace from)
{
  constexpr int mostSteps = 16; // of a triangle that reaches over several charts
  for (int step = 0; step < mostSteps; ++step)
  {
    const glm::vec3 weights(1.0f - from.place.x - from.place.y, from.place.x, from.place.y);
    const int edge =
      weights.x <= weights.y ? (weights.x <= weights.z ? 0 : 2) : (weights.y <= weights.z ? 1 : 2);
    if (!(weights[edge] < 0.0f))
    {
      break;
    }
    const CellChart& chart = cells.charts[static_cast<std::size_t>(from.chart)];
    const std::int32_t code = chart.neighbours[static_cast<std::size_t>(edge)];
    if (code < 0)
    {
      break;
    }
    const glm::vec3 found = glsl::weightsAcross(weights, edge, code % 6 / 2, code % 2 == 1);
    from = { code / 6, glm::vec2(found.y, found.z) };
  }
  glm::vec3 weights(1.0f - from.place.x - from.place.y, from.place.x, from.place.y);
  weights = glm::max(weights, glm::vec3(0.0f));
  const float sum = weights.x + weights.y + weights.z;
  weights = sum > 0.0f ? weights / sum : glm::vec3(1.0f / 3.0f);
  from.place = glm::vec2(weights.y, weights.z);
  return from;
}

CellSpot cellSpot(int cell, int segments)
{
  // Row r begins at r * (2 * segments - r).
  const double squared = static_cast<double>(segments) * segments - cell;
  int row = segments - static_cast<int>(std::ceil(std::sqrt(squared)));
  row -= row * (2 * segments - row) > cell ? 1 : 0;
  row += (row + 1) * (2 * segments - row - 1) <= cell ? 1 : 0;
  const int along = cell - row * (2 * segments - row);
  return { along / 2, row, along % 2 };
}

CellSpot spotAcross(const CellSpot& spot, int edge)
{
  const int sign = spot.odd != 0 ? 1 : -1;
  return { spot.column + (edge == 1 ? sign : 0), spot.row + (edge == 2 ? sign : 0), 1 - spot.odd };
}

bool isOnRim(const CellSpot& spot, int edge, int segments)
{
  if (spot.odd != 0)
  {
    return false;
  }
  return edge == 0 ? spot.column + spot.row == segments - 1
                   : (edge == 1 ? spot.column == 0 : spot.row == 0);
}

CellSpot rimCell(int edge, int along, int segments)
{
  return edge == 0 ? CellSpot{ segments - 1 - along, along, 0 }
                   : (edge == 1 ? CellSpot{ 0, along, 0 } : CellSpot{ along, 0, 0 });
}

glm::ivec2 rimCorner(int edge, int along, int segments)
{
  return edge == 0 ? glm::ivec2(segments - along, along)
                   : (edge == 1 ? glm::ivec2(0, along) : glm::ivec2(along, 0));
}

RimPlace acrossRim(const CellLayer& layer, const RimPlace& place)
{
  const CellChart& chart = layer.surface().charts[static_cast<std::size_t>(place.chart)];
  const std::int32_t code = chart.neighbours[static_cast<std::size_t>(place.edge)];
  if (code < 0)
  {
    return {};
  }
  RimPlace other{ code / 6, code % 6 / 2, 0.0 };
  const int segments = layer.segmentsOf(place.chart);
  const int otherSegments = layer.segmentsOf(other.chart);
  // Edges have a direction, in which places are counted but on the one opposite to the second
  // corner; both charts turn the same way unless one of them is turned over.
  const bool sameWay = (place.edge == 1) == (other.edge == 1);
  const bool alike = code % 2 == 1;
  const double along = alike == sameWay ? place.along : segments - place.along;
  other.along = along * otherSegments / segments; // powers of 2: exact
  return other;
}

CellLayer::CellLayer(const SurfaceCells& surface, int ofLevel)
  : cells(&surface)
  , level(ofLevel)
{
  const std::size_t count = surface.charts.size();
  this->firstCell.reserve(count + 1);
  this->firstLevelNode.reserve(count + 1);
  std::int32_t cell = 0;
  std::int64_t node = 0;
  for (std::size_t chart = 0; chart < count; ++chart)
  {
    this->firstCell.push_back(cell);
    this->firstLevelNode.push_back(node);
    const int subdivisions = subdivisionsOf(surface.charts[chart], ofLevel);
    cell += 1 << (2 * subdivisions);
    node += glsl::chartNodes(subdivisions);
  }
  this->firstCell.push_back(cell);
  this->firstLevelNode.push_back(node);
  this->charts.resize(static_cast<std::size_t>(cell));
  for (std::size_t chart = 0; chart < count; ++chart)
  {
    std::fill(this->charts.begin() + this->firstCell[chart],
      this->charts.begin() + this->firstCell[chart + 1], static_cast<std::int32_t>(chart));
  }
}

std::int32_t CellLayer::cellAt(const ChartPlace& place) const
{
  return this->firstOf(place.chart) +
    glsl::nodesAt(place.place, this->segmentsOf(place.chart)).cell;
}

std::int64_t CellLayer::nodeOf(std::int32_t cell) const
{
  const std::int32_t chart = this->chartOf(cell);
  return this->firstNode(chart) + (cell - this->firstOf(chart));
}

void CellLayer::appendNeighbours(std::int32_t cell, std::vector<std::int32_t>& found) const
{
  const std::int32_t chart = this->chartOf(cell);
  const int segments = this->segmentsOf(chart);
  const CellSpot spot = cellSpot(cell - this->firstOf(chart), segments);
  for (int edge = 0; edge < 3; ++edge)
  {
    if (!isOnRim(spot, edge, segments))
    {
      found.push_back(this->firstOf(chart) + numberOf(spotAcross(spot, edge), segments));
      continue;
    }
    const double along = edge == 2 ? spot.column : spot.row;
    const RimPlace begin = acrossRim(*this, { chart, edge, along });
    if (begin.chart < 0)
    {
      continue;
    }
    const RimPlace end = acrossRim(*this, { chart, edge, along + 1.0 });
    const int otherSegments = this->segmentsOf(begin.chart);
    const int first = static_cast<int>(std::floor(std::min(begin.along, end.along)));
    const int last = static_cast<int>(std::ceil(std::max(begin.along, end.along)));
    for (int segment = first; segment < last; ++segment)
    {
      found.push_back(this->firstOf(begin.chart) +
        numberOf(rimCell(begin.edge, segment, otherSegments), otherSegments));
    }
  }
}

CellLayer::Children CellLayer::childrenOf(std::int32_t cell, const CellLayer& next) const
{
  const std::int32_t chart = this->chartOf(cell);
  const int segments = this->segmentsOf(chart);
  const int nextSegments = next.segmentsOf(chart);
  const std::int32_t own = cell - this->firstOf(chart);
  if (nextSegments == segments)
  {
    return { { next.firstOf(chart) + own }, 1 };
  }
  const CellSpot spot = cellSpot(own, segments);
  const int column = 2 * spot.column;
  const int row = 2 * spot.row;
  const int odd = spot.odd;
  // Three at its corners, which stand as it does, and one between them.
  const std::array<CellSpot, 4> spots = { { { column + odd, row, odd },
    { column + 1, row + odd, odd }, { column, row + 1, odd },
    { column + odd, row + odd, 1 - odd } } };
  Children children;
  children.count = 4;
  for (std::size_t i = 0; i < spots.size(); ++i)
  {
    children.cells[i] = next.firstOf(chart) + numberOf(spots[i], nextSegments);
  }
  return children;
}

} // namespace hachure

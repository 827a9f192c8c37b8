// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellLayers.h"

#include "Kernels.h"
#include "Parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hachure
{
namespace
{
using Shares = std::vector<NodeCells::Share>;

// Charts by their corners' numbers.
class ChartsAround
{
public:
  struct Corner
  {
    std::int32_t number;
    std::int32_t chart;
    int corner;
  };

  explicit ChartsAround(const std::vector<CellChart>& charts)
  {
    this->corners.reserve(3 * charts.size());
    for (std::size_t chart = 0; chart < charts.size(); ++chart)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->corners.push_back(
          { charts[chart].corners[corner], static_cast<std::int32_t>(chart), corner });
      }
    }
    std::stable_sort(this->corners.begin(), this->corners.end(), comesBefore);
  }

  Span<const Corner> of(std::int32_t number) const
  {
    const auto range = std::equal_range(
      this->corners.begin(), this->corners.end(), Corner{ number, 0, 0 }, comesBefore);
    return Span<const Corner>(this->corners)
      .subspan(static_cast<std::size_t>(range.first - this->corners.begin()),
        static_cast<std::size_t>(range.second - range.first));
  }

private:
  static bool comesBefore(const Corner& a, const Corner& b) { return a.number < b.number; }
  std::vector<Corner> corners;
};

// Lists the cells of a level's nodes.
class NodeLister
{
public:
  explicit NodeLister(const CellLayer& ofLayer)
    : layer(ofLayer)
    , around(ofLayer.surface().charts)
  {
  }

  // Of one chart, in the order of its nodes.
  std::vector<Shares> listsOf(std::int32_t chart) const;

private:
  std::int32_t cellOf(std::int32_t chart, const CellSpot& spot, int segments) const
  {
    return this->layer.firstOf(chart) + glsl::cellNode(spot.column, spot.row, spot.odd, segments);
  }
  void addAround(std::int32_t chart, glm::ivec2 corner, Shares& shares) const;
  Shares chartCorner(std::int32_t chart, int corner) const;
  Shares rimCornerShares(const RimPlace& place) const;
  Shares rimMiddleShares(const RimPlace& place) const;
  Shares rimShares(const RimPlace& place) const;
  bool mustFollow(const RimPlace& place, RimPlace& other) const;

  const CellLayer& layer;
  ChartsAround around;
};

void makeMean(Shares& shares)
{
  for (NodeCells::Share& share : shares)
  {
    share.weight = 1.0f / static_cast<float>(shares.size());
  }
}

void addScaled(const Shares& from, float factor, Shares& to)
{
  for (const NodeCells::Share& share : from)
  {
    to.push_back({ share.cell, factor * share.weight });
  }
}

// The cells of one chart around a corner of cells.
void NodeLister::addAround(std::int32_t chart, glm::ivec2 corner, Shares& shares) const
{
  const int segments = this->layer.segmentsOf(chart);
  for (const CellSpot& spot : { CellSpot{ 0, 0, 0 }, CellSpot{ -1, 0, 0 }, CellSpot{ 0, -1, 0 },
         CellSpot{ -1, 0, 1 }, CellSpot{ 0, -1, 1 }, CellSpot{ -1, -1, 1 } })
  {
    const int column = corner.x + spot.column;
    const int row = corner.y + spot.row;
    if (column >= 0 && row >= 0 && column + row + spot.odd < segments)
    {
      shares.push_back({ this->cellOf(chart, { column, row, spot.odd }, segments), 1.0f });
    }
  }
}

Shares NodeLister::chartCorner(std::int32_t chart, int corner) const
{
  Shares shares;
  const CellChart& own = this->layer.surface().charts[static_cast<std::size_t>(chart)];
  for (const ChartsAround::Corner& other : this->around.of(own.corners[corner]))
  {
    const int segments = this->layer.segmentsOf(other.chart);
    const glm::ivec2 place(other.corner == 1 ? segments : 0, other.corner == 2 ? segments : 0);
    this->addAround(other.chart, place, shares);
  }
  makeMean(shares);
  return shares;
}

// Whether the other side of a rim has larger cells.
bool NodeLister::mustFollow(const RimPlace& place, RimPlace& other) const
{
  other = acrossRim(this->layer, place);
  return other.chart >= 0 &&
    this->layer.segmentsOf(other.chart) < this->layer.segmentsOf(place.chart);
}

Shares NodeLister::rimCornerShares(const RimPlace& place) const
{
  const int segments = this->layer.segmentsOf(place.chart);
  const int along = static_cast<int>(place.along);
  if (along == 0 || along == segments)
  {
    const bool first = along == 0;
    const int corner = place.edge == 0 ? (first ? 1 : 2) : (first ? 0 : 3 - place.edge);
    return this->chartCorner(place.chart, corner);
  }
  Shares shares;
  this->addAround(place.chart, rimCorner(place.edge, along, segments), shares);
  const RimPlace other = acrossRim(this->layer, place);
  if (other.chart >= 0)
  {
    const int otherSegments = this->layer.segmentsOf(other.chart);
    this->addAround(
      other.chart, rimCorner(other.edge, static_cast<int>(other.along), otherSegments), shares);
  }
  makeMean(shares);
  return shares;
}

// Of the cell and those across its edge on the rim.
Shares NodeLister::rimMiddleShares(const RimPlace& place) const
{
  const int segments = this->layer.segmentsOf(place.chart);
  const int along = static_cast<int>(place.along);
  Shares shares = { { this->cellOf(place.chart, rimCell(place.edge, along, segments), segments),
    1.0f } };
  const RimPlace begin = acrossRim(this->layer, { place.chart, place.edge, 1.0 * along });
  if (begin.chart < 0)
  {
    return shares;
  }
  shares.front().weight = 0.5f;
  const RimPlace end = acrossRim(this->layer, { place.chart, place.edge, along + 1.0 });
  const int otherSegments = this->layer.segmentsOf(begin.chart);
  const int first = static_cast<int>(std::min(begin.along, end.along));
  const int count = static_cast<int>(std::max(begin.along, end.along)) - first;
  for (int segment = first; segment < first + count; ++segment)
  {
    shares.push_back(
      { this->cellOf(begin.chart, rimCell(begin.edge, segment, otherSegments), otherSegments),
        0.5f / static_cast<float>(count) });
  }
  return shares;
}

// Corners are at whole numbers, middles between them. Larger cells on the other side have nodes
// half a segment apart.
Shares NodeLister::rimShares(const RimPlace& place) const
{
  const auto atHalf = [this](const RimPlace& on, int half)
  {
    const RimPlace node{ on.chart, on.edge, 0.5 * half };
    return half % 2 == 0 ? this->rimCornerShares(node) : this->rimMiddleShares(node);
  };
  RimPlace other;
  if (!this->mustFollow(place, other))
  {
    return atHalf(place, static_cast<int>(2.0 * place.along));
  }
  const double halves = 2.0 * other.along;
  const int before = static_cast<int>(std::floor(halves));
  const auto share = static_cast<float>(halves - before);
  if (share == 0.0f)
  {
    return atHalf(other, before);
  }
  const Shares from = atHalf(other, before);
  const Shares to = atHalf(other, before + 1);
  Shares shares;
  shares.reserve(from.size() + to.size());
  addScaled(from, 1.0f - share, shares);
  addScaled(to, share, shares);
  return shares;
}

std::vector<Shares> NodeLister::listsOf(std::int32_t chart) const
{
  const int segments = this->layer.segmentsOf(chart);
  const CellChart& own = this->layer.surface().charts[static_cast<std::size_t>(chart)];
  std::vector<Shares> lists(
    static_cast<std::size_t>(glsl::chartNodes(subdivisionsOf(own, this->layer.number()))));
  const auto listOf = [&](int node) -> Shares& { return lists[static_cast<std::size_t>(node)]; };
  for (int cell = 0; cell < segments * segments; ++cell)
  {
    listOf(cell) = { { this->layer.firstOf(chart) + cell, 1.0f } };
  }
  for (int row = 1; row < segments - 1; ++row)
  {
    for (int column = 1; column + row < segments; ++column)
    {
      Shares& shares = listOf(glsl::cornerNode(column, row, segments));
      this->addAround(chart, { column, row }, shares);
      makeMean(shares);
    }
  }
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int along = 0; along <= segments; ++along)
    {
      const glm::ivec2 corner = rimCorner(edge, along, segments);
      listOf(glsl::cornerNode(corner.x, corner.y, segments)) =
        this->rimShares({ chart, edge, 1.0 * along });
      if (along < segments)
      {
        listOf(glsl::rimNode(edge, along, segments)) =
          this->rimShares({ chart, edge, along + 0.5 });
      }
    }
  }
  return lists;
}
} // namespace

NodeCells CellLayer::nodeCells() const
{
  const NodeLister lister(*this);
  const auto count = static_cast<std::int64_t>(this->cells->charts.size());
  std::vector<std::vector<Shares>> lists(static_cast<std::size_t>(count));
  parallelFor(count,
    [&](std::int64_t chart)
    { lists[static_cast<std::size_t>(chart)] = lister.listsOf(static_cast<std::int32_t>(chart)); });
  NodeCells nodes;
  nodes.first.reserve(static_cast<std::size_t>(this->nodeCount()) + 1);
  nodes.first.push_back(0);
  for (const std::vector<Shares>& chart : lists)
  {
    for (const Shares& shares : chart)
    {
      nodes.first.push_back(nodes.first.back() + static_cast<std::int64_t>(shares.size()));
    }
  }
  nodes.shares.reserve(static_cast<std::size_t>(nodes.first.back()));
  for (const std::vector<Shares>& chart : lists)
  {
    for (const Shares& shares : chart)
    {
      nodes.shares.insert(nodes.shares.end(), shares.begin(), shares.end());
    }
  }
  return nodes;
}

} // namespace hachure

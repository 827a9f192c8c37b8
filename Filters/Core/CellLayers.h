// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_CellLayers_h
#define hachure_CellLayers_h

#include "SurfaceCells.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <vector>

// The cells of every level numbered through, chart by chart, in the order of their nodes, and how
// they hang together: with their neighbours, also across rims, with the cells they are divided
// into, and with the cells around corners and rims.
namespace hachure
{

// A place on a chart: weights of its second and third corner.
struct ChartPlace
{
  std::int32_t chart = -1;
  glm::vec2 place{ 0.0f };
};

// Goes on to the next chart as long as a place is outside of its own; where there is none, the
// closest place on the rim.
ChartPlace placeInside(const SurfaceCells& cells, ChartPlace from);

// Of a cell in its chart.
struct CellSpot
{
  int column = 0;
  int row = 0;
  int odd = 0;
};
CellSpot cellSpot(int cell, int segments);
// Whether the edge opposite to a corner of the cell lies on the chart's rim; else the cell across.
bool isOnRim(const CellSpot& spot, int edge, int segments);
CellSpot spotAcross(const CellSpot& spot, int edge);

// Nodes are cells with weights, whose sum is 1: of every node a list.
struct NodeCells
{
  struct Share
  {
    std::int32_t cell = 0;
    float weight = 0.0f;
  };
  std::vector<std::int64_t> first; // of every node, and the number of all
  std::vector<Share> shares;
};

class CellLayer
{
public:
  // The cells must stay as long as the layer is used.
  CellLayer(const SurfaceCells& cells, int level);

  std::int32_t size() const { return this->firstCell.back(); }
  int segmentsOf(std::int32_t chart) const
  {
    return 1 << subdivisionsOf(this->cells->charts[static_cast<std::size_t>(chart)], this->level);
  }
  std::int32_t chartOf(std::int32_t cell) const
  {
    return this->charts[static_cast<std::size_t>(cell)];
  }
  std::int32_t firstOf(std::int32_t chart) const
  {
    return this->firstCell[static_cast<std::size_t>(chart)];
  }
  // Of a place inside of a chart.
  std::int32_t cellAt(const ChartPlace& place) const;
  // Its number among the nodes of all levels.
  std::int64_t nodeOf(std::int32_t cell) const;
  // Appends the cells across its three edges; across a rim there may be none or several.
  void appendNeighbours(std::int32_t cell, std::vector<std::int32_t>& found) const;
  // The cells of the next level that it is divided into: one or four.
  struct Children
  {
    std::array<std::int32_t, 4> cells{};
    int count = 0;
  };
  Children childrenOf(std::int32_t cell, const CellLayer& next) const;

  // Number of a level's first node among all, and which cells all of its nodes in a chart are made
  // of. Corners of cells are the mean of the cells around, over all charts that meet there, and
  // middles of rim edges of those on both sides; but on rims whose other side has larger cells what
  // is linear between the other side's corners and middles, so that there is no gap.
  NodeCells nodeCells() const;
  std::int64_t firstNode(std::int32_t chart) const
  {
    return firstNodeOf(*this->cells, static_cast<std::size_t>(chart), this->level);
  }
  // Nodes of this level.
  std::int64_t nodeCount() const { return this->firstLevelNode.back(); }
  std::int64_t firstLevelNodeOf(std::int32_t chart) const
  {
    return this->firstLevelNode[static_cast<std::size_t>(chart)];
  }

  const SurfaceCells& surface() const { return *this->cells; }
  int number() const { return this->level; }

private:
  const SurfaceCells* cells;
  int level;
  std::vector<std::int32_t> firstCell;      // of every chart, and the number of all
  std::vector<std::int32_t> charts;         // of every cell
  std::vector<std::int64_t> firstLevelNode; // of every chart among this level's, and of all
};

// A place on a chart's rim, in segments along the edge opposite to a corner, as rimNode() counts
// them: from its first corner or, for the edge opposite to that, from its second.
struct RimPlace
{
  std::int32_t chart = -1; // none
  int edge = 0;
  double along = 0.0;
};
// The same place on the other side, in segments of that chart.
RimPlace acrossRim(const CellLayer& layer, const RimPlace& place);

// The cell at a segment of a rim, and the corner of cells at its beginning.
CellSpot rimCell(int edge, int along, int segments);
glm::ivec2 rimCorner(int edge, int along, int segments);

} // namespace hachure

#endif

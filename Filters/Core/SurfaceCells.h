// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceCells_h
#define hachure_SurfaceCells_h

#include "TriangleMesh.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

// The cells of a surface that view-dependent textures are stored on (Grimm and Kowalski 2002,
// section 4.1): several levels that each cover all of it, every cell of which is divided into four
// at the next one. The paper leaves open how triangle meshes get them. Here the surface is divided
// into charts of three corners, each a map of a part of it to a triangle, and charts into cells by
// halving their sides; see Kernels/ViewCells.glsl.
//
// Cells of one level have roughly equal areas. A chart has its own first level, at which it is one
// cell: 1 for one of a quarter of the area of a cell of level 0, and -1 for one of four times that
// area. Below its first level a chart stays one cell.
namespace hachure
{

struct CellChart
{
  // Three numbers; charts that meet at a corner have the same one there.
  glm::ivec3 corners{ 0 };
  // Of the chart across the edge opposite to each corner: 6 * chart + 2 * (its corner opposite to
  // the edge) + (1 where the edge has the same direction in both, as one of them is turned over);
  // -1: none, or several.
  std::array<std::int32_t, 3> neighbours{ -1, -1, -1 };
  int level = 0;     // at which it is one cell
  double area = 0.0; // of its surface
};

struct SurfaceCells
{
  int finestLevel = 0;
  double cellArea = 0.0; // of a cell of level 0, as was asked for; 0: there are none
  std::vector<CellChart> charts;
  // Of every triangle of the mesh its chart, -1 where it has no area, and where its corners are
  // there: weights of the chart's second and third corner. A triangle that reaches over the rim of
  // its chart has places outside [0,1], which continue into the next chart as weightsAcross()
  // says.
  std::vector<std::int32_t> chartOfTriangle;
  std::vector<std::array<glm::vec2, 3>> places;
  // Nodes go by chart, then by level, 0 first, then as in Kernels/ViewCells.glsl.
  std::vector<std::int32_t> firstNode; // of every chart, and the number of all
};

struct SurfaceCellOptions
{
  // Wanted cells of level 0, at least 1: the area of one is that of the surface over this number.
  int baseCells = 144;
  // Levels 0 to this one, 0 to maximumCellLevel; less where there would be more nodes than
  // mostNodes.
  int finestLevel = 4;
  std::int64_t mostNodes = 1 << 22;
};

constexpr int maximumCellLevel = 8;

// Times that the sides of a chart are halved at a level.
inline int subdivisionsOf(const CellChart& chart, int level)
{
  return level > chart.level ? level - chart.level : 0;
}

// First node of a chart at a level.
std::int64_t firstNodeOf(const SurfaceCells& cells, std::size_t chart, int level);

// Throws std::invalid_argument naming the first bad argument and its value: cells of another number
// of triangles, or a chart that does not exist.
void checkSurfaceCells(const TriangleMesh& mesh, const SurfaceCells& cells);

// Every triangle is a chart: for meshes whose triangles are not much smaller than the cells wanted.
// Throws std::invalid_argument naming the first bad argument and its value.
SurfaceCells trianglesAsCells(const TriangleMesh& mesh, const SurfaceCellOptions& options = {});

namespace detail
{
// Throws as trianglesAsCells() does.
void checkOptions(const SurfaceCellOptions& options);
// Of charts with known corners: finds their neighbours.
void linkCharts(std::vector<CellChart>& charts);
// Of charts with known areas: their levels, the finest level and the nodes.
void numberNodes(SurfaceCells& cells, const SurfaceCellOptions& options);
} // namespace detail

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NodePlaces.h"

// Levels nest: corners and centres of cells are corners or centres of the finest level's cells, and
// middles of rim edges are its corners, but for its own. So the triangles of a chart are drawn
// once, over the nodes of its finest level.

#include "Kernels.h"
#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure
{
namespace
{
// Calls visit(node, x, y) for all nodes of a level; thirds of a segment from the chart's first
// corner, doubled, as middles of edges are between them: 6 a segment.
template <class Visit>
void visitNodes(int segments, Visit&& visit)
{
  for (int row = 0; row <= segments; ++row)
  {
    for (int column = 0; column <= segments - row; ++column)
    {
      visit(glsl::cornerNode(column, row, segments), 6 * column, 6 * row);
      for (int odd = 0; odd < 2 && column + row + odd < segments; ++odd)
      {
        visit(glsl::cellNode(column, row, odd, segments), 6 * column + 2 + 2 * odd,
          6 * row + 2 + 2 * odd);
      }
    }
  }
  for (int along = 0; along < segments; ++along)
  {
    const int middle = 6 * along + 3;
    visit(glsl::rimNode(0, along, segments), 6 * segments - middle, middle);
    visit(glsl::rimNode(1, along, segments), 0, middle);
    visit(glsl::rimNode(2, along, segments), middle, 0);
  }
}

// Of a node's place in sixths of a segment: its number.
int nodeAt(int x, int y, int segments)
{
  const int column = x / 6;
  const int row = y / 6;
  const int part = std::max(x % 6, y % 6);
  if (part == 0)
  {
    return glsl::cornerNode(column, row, segments);
  }
  if (part != 3)
  {
    return glsl::cellNode(column, row, part == 4 ? 1 : 0, segments);
  }
  return y == 0 ? glsl::rimNode(2, column, segments) : glsl::rimNode(x == 0 ? 1 : 0, row, segments);
}

glm::dvec2 segmentsOf(const glm::vec2& place, int segments)
{
  return static_cast<double>(segments) * glm::dvec2(place);
}

double cross(const glm::dvec2& one, const glm::dvec2& other)
{
  return one.x * other.y - one.y * other.x;
}

// The nodes of a chart's finest level, over which triangles are drawn.
class ChartNodes
{
public:
  explicit ChartNodes(int subdivisions)
    : segments(1 << subdivisions)
    , places(static_cast<std::size_t>(glsl::chartNodes(subdivisions)))
  {
  }

  // Nodes that have a place keep it.
  void draw(const detail::ChartTriangle& drawn)
  {
    std::array<glm::dvec2, 3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      corners[corner] = segmentsOf(drawn.places[corner], this->segments);
    }
    const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (area == 0.0 || !std::isfinite(area))
    {
      return;
    }
    const Shape shape = { corners, 1.0 / area, drawn.triangle };
    for (int offset = 0; offset < 3; ++offset)
    {
      this->drawLattice(shape, 2 * offset);
    }
    this->drawRims(shape);
  }

  // The closest triangle for nodes without one.
  void fill(Span<const detail::ChartTriangle> triangles)
  {
    visitNodes(this->segments,
      [&](int node, int x, int y)
      {
        NodePlace& place = this->places[static_cast<std::size_t>(node)];
        if (place.triangle < 0)
        {
          place = this->closest(triangles, glm::dvec2(x, y) / 6.0);
        }
      });
  }

  // Of a level of the same chart.
  void copyTo(int subdivisions, NodePlace* nodes) const
  {
    const int times = this->segments >> subdivisions;
    visitNodes(1 << subdivisions,
      [&](int node, int x, int y)
      {
        const int from = nodeAt(times * x, times * y, this->segments);
        nodes[node] = this->places[static_cast<std::size_t>(from)];
      });
  }

private:
  struct Shape
  {
    std::array<glm::dvec2, 3> corners;
    double inverse; // of twice the area, with its sign
    std::int32_t triangle;
  };

  // Corners of cells (0), or the centres of those that are upright (2) or not (4).
  void drawLattice(const Shape& shape, int sixths)
  {
    constexpr double slack = 1e-6; // segments; a triangle's places are no more accurate
    const double shift = sixths / 6.0 + slack;
    const auto [low, high] = boundsOf(shape);
    const int most = this->segments - sixths / 2;
    const auto first = [&](double value)
    { return static_cast<int>(std::ceil(std::clamp(value - shift, 0.0, most + 1.0))); };
    const auto last = [&](double value) {
      return static_cast<int>(
        std::floor(std::clamp(value - shift + 2.0 * slack, -1.0, most + 0.0)));
    };
    for (int row = first(low.y); row <= last(high.y); ++row)
    {
      const int end = std::min(last(high.x), most - row);
      for (int column = first(low.x); column <= end; ++column)
      {
        this->drawNode(shape, 6 * column + sixths, 6 * row + sixths);
      }
    }
  }

  void drawRims(const Shape& shape)
  {
    const auto [low, high] = boundsOf(shape);
    const double size = this->segments;
    const bool isAtBottom = low.y <= 0.0;
    const bool isAtLeft = low.x <= 0.0;
    const bool isAtSlope = high.x + high.y >= size;
    if (!isAtBottom && !isAtLeft && !isAtSlope)
    {
      return;
    }
    const int first = static_cast<int>(std::clamp(std::min(low.x, low.y) - 1.0, 0.0, size));
    const int last = static_cast<int>(std::clamp(std::max(high.x, high.y) + 1.0, 0.0, size));
    for (int along = first; along < last; ++along)
    {
      const int middle = 6 * along + 3;
      if (isAtBottom)
      {
        this->drawNode(shape, middle, 0);
      }
      if (isAtLeft)
      {
        this->drawNode(shape, 0, middle);
      }
      if (isAtSlope)
      {
        this->drawNode(shape, 6 * this->segments - middle, middle);
      }
    }
  }

  static std::array<glm::dvec2, 2> boundsOf(const Shape& shape)
  {
    const auto& corners = shape.corners;
    return { glm::min(glm::min(corners[0], corners[1]), corners[2]),
      glm::max(glm::max(corners[0], corners[1]), corners[2]) };
  }

  void drawNode(const Shape& shape, int x, int y)
  {
    NodePlace& place = this->places[static_cast<std::size_t>(nodeAt(x, y, this->segments))];
    if (place.triangle >= 0)
    {
      return;
    }
    const glm::dvec2 arm = glm::dvec2(x, y) / 6.0 - shape.corners[0];
    const double second = cross(arm, shape.corners[2] - shape.corners[0]) * shape.inverse;
    const double third = cross(shape.corners[1] - shape.corners[0], arm) * shape.inverse;
    constexpr double slack = 1e-9; // rounding
    if (std::min(std::min(second, third), 1.0 - second - third) >= -slack)
    {
      place = { shape.triangle, glm::vec2(glm::max(glm::dvec2(second, third), glm::dvec2(0.0))) };
    }
  }

  // Of a place in segments.
  NodePlace closest(Span<const detail::ChartTriangle> triangles, const glm::dvec2& place) const
  {
    NodePlace found;
    double least = std::numeric_limits<double>::max();
    for (const detail::ChartTriangle& triangle : triangles)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const auto from = static_cast<std::size_t>(corner);
        const glm::dvec2 start = segmentsOf(triangle.places[from], this->segments);
        const glm::dvec2 edge = segmentsOf(triangle.places[(from + 1) % 3], this->segments) - start;
        const double squared = glm::dot(edge, edge);
        const double along =
          squared > 0.0 ? std::clamp(glm::dot(place - start, edge) / squared, 0.0, 1.0) : 0.0;
        const glm::dvec2 arm = place - start - along * edge;
        const double distance = glm::dot(arm, arm);
        if (distance < least)
        {
          least = distance;
          glm::dvec3 weights(0.0);
          weights[corner] = 1.0 - along;
          weights[(corner + 1) % 3] = along;
          found = { triangle.triangle, glm::vec2(weights.y, weights.z) };
        }
      }
    }
    return found;
  }

  int segments;
  std::vector<NodePlace> places;
};

// Of the nodes of all levels of a chart.
void placeNodes(const SurfaceCells& cells, std::size_t chart,
  Span<const detail::ChartTriangle> triangles, std::vector<NodePlace>& places)
{
  ChartNodes nodes(subdivisionsOf(cells.charts[chart], cells.finestLevel));
  for (const detail::ChartTriangle& triangle : triangles)
  {
    nodes.draw(triangle);
  }
  nodes.fill(triangles);
  for (int level = 0; level <= cells.finestLevel; ++level)
  {
    nodes.copyTo(
      subdivisionsOf(cells.charts[chart], level), places.data() + firstNodeOf(cells, chart, level));
  }
}
} // namespace

std::vector<glm::vec2> nodeCoordinates(int subdivisions)
{
  std::vector<glm::vec2> coordinates(static_cast<std::size_t>(glsl::chartNodes(subdivisions)));
  const int segments = 1 << subdivisions;
  const double unit = 1.0 / (6.0 * segments);
  visitNodes(segments,
    [&](int node, int x, int y)
    { coordinates[static_cast<std::size_t>(node)] = glm::vec2(unit * glm::dvec2(x, y)); });
  return coordinates;
}

std::vector<NodePlace> nodePlaces(const TriangleMesh& mesh, const SurfaceCells& cells)
{
  checkTriangleMesh(mesh);
  checkSurfaceCells(mesh, cells);
  const detail::ChartTriangles triangles = detail::chartTriangles(cells);
  std::vector<NodePlace> places(
    static_cast<std::size_t>(cells.firstNode.empty() ? 0 : cells.firstNode.back()));
  parallelFor(static_cast<std::int64_t>(cells.charts.size()),
    [&](std::int64_t i)
    {
      const auto chart = static_cast<std::size_t>(i);
      placeNodes(cells, chart, triangles.of(chart), places);
    });
  return places;
}

} // namespace hachure

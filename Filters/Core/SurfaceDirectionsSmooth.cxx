// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDirections.h"

#include "Parallel.h"
#include "TangentFrame.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{
namespace
{
using Lines = std::vector<glm::dvec2>;

/// Shorter line vectors have no direction.
constexpr double shortestLine = 1e-3;

bool isKnown(const glm::dvec2& line)
{
  return glm::dot(line, line) > shortestLine * shortestLine;
}

void checkOptions(
  const VertexGraph& graph, Span<const glm::dvec2> lines, const SmoothingOptions& options)
{
  if (lines.size() != graph.vertexCount())
  {
    throw std::invalid_argument("lines has " + std::to_string(lines.size()) +
      " elements, expected " + std::to_string(graph.vertexCount()) + ", one per vertex");
  }
  if (options.iterations < 0)
  {
    throw std::invalid_argument(
      "options.iterations is " + std::to_string(options.iterations) + ", expected 0 or more");
  }
  if (!std::isfinite(options.axis.x + options.axis.y + options.axis.z))
  {
    throw std::invalid_argument("options.axis is not finite");
  }
}

/// Line vectors of neighbours, as seen from a vertex.
class Transports
{
public:
  explicit Transports(const VertexGraph& someGraph)
    : graph(someGraph)
    , turns(someGraph.neighbours.size())
  {
    parallelFor(static_cast<std::int64_t>(graph.vertexCount()),
      [&](std::int64_t vertex)
      {
        for (std::size_t i = graph.neighbourOffsets[vertex]; i < graph.neighbourOffsets[vertex + 1];
             ++i)
        {
          turns[i] =
            transportTurn(graph.normals[graph.neighbours[i].vertex], graph.normals[vertex]);
        }
      });
  }

  /// Weighted sum of the lines around.
  glm::dvec2 sumAround(const Lines& lines, std::size_t vertex, double& weight) const
  {
    glm::dvec2 sum(0.0);
    for (std::size_t i = graph.neighbourOffsets[vertex]; i < graph.neighbourOffsets[vertex + 1];
         ++i)
    {
      const VertexNeighbour& next = graph.neighbours[i];
      sum += turned(lines[next.vertex], turns[i]) * static_cast<double>(next.weight);
      weight += next.weight;
    }
    return sum;
  }

private:
  const VertexGraph& graph;
  std::vector<glm::dvec2> turns; // per neighbour: from its frame into that of the vertex
};

/// One round of means; half of each is the vertex itself, without which a field on a mesh of two
/// colours would swing.
void average(const VertexGraph& graph, const Transports& transports, const Lines& from, Lines& to)
{
  parallelFor(static_cast<std::int64_t>(graph.vertexCount()),
    [&](std::int64_t vertex)
    {
      double weight = 0.0;
      const glm::dvec2 sum = transports.sumAround(from, static_cast<std::size_t>(vertex), weight);
      to[vertex] = weight > 0.0 ? 0.5 * (from[vertex] + sum / weight) : from[vertex];
    });
}

/// The vertices without a line that have a neighbour with one.
std::vector<std::int32_t> findFront(const VertexGraph& graph, const Lines& lines)
{
  std::vector<std::int32_t> front;
  for (std::size_t vertex = 0; vertex < lines.size(); ++vertex)
  {
    bool touches = false;
    if (!isKnown(lines[vertex]))
    {
      for (const VertexNeighbour& next : graph.neighboursOf(vertex))
      {
        touches = touches || isKnown(lines[next.vertex]);
      }
    }
    if (touches)
    {
      front.push_back(static_cast<std::int32_t>(vertex));
    }
  }
  return front;
}

/// Lines of the front from the vertices around it; returns those that found one.
std::vector<std::int32_t> fillFront(
  const Transports& transports, const std::vector<std::int32_t>& front, Lines& lines)
{
  std::vector<glm::dvec2> found(front.size());
  parallelFor(static_cast<std::int64_t>(front.size()),
    [&](std::int64_t i)
    {
      double weight = 0.0;
      const glm::dvec2 sum =
        transports.sumAround(lines, static_cast<std::size_t>(front[i]), weight);
      const double length = glm::length(sum);
      found[i] = length > shortestLine * shortestLine ? sum / length : glm::dvec2(0.0);
    });
  std::vector<std::int32_t> filled;
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    if (isKnown(found[i]))
    {
      lines[front[i]] = found[i];
      filled.push_back(front[i]);
    }
  }
  return filled;
}

/// The unknown neighbours of vertices, once each and in order of appearance.
std::vector<std::int32_t> nextFront(const VertexGraph& graph,
  const std::vector<std::int32_t>& filled, const Lines& lines, std::vector<std::uint8_t>& isListed)
{
  std::vector<std::int32_t> front;
  for (const std::int32_t vertex : filled)
  {
    for (const VertexNeighbour& next : graph.neighboursOf(static_cast<std::size_t>(vertex)))
    {
      if (!isKnown(lines[next.vertex]) && !isListed[next.vertex])
      {
        isListed[next.vertex] = 1;
        front.push_back(next.vertex);
      }
    }
  }
  for (const std::int32_t vertex : front)
  {
    isListed[vertex] = 0;
  }
  return front;
}

/// Fills what hangs together with known lines, ring by ring, then evens out the seams where rings
/// met.
void fill(const VertexGraph& graph, const Transports& transports, Lines& lines)
{
  std::vector<std::int32_t> all;
  std::vector<std::uint8_t> isListed(lines.size(), 0);
  std::vector<std::int32_t> front = findFront(graph, lines);
  while (!front.empty())
  {
    const std::vector<std::int32_t> filled = fillFront(transports, front, lines);
    all.insert(all.end(), filled.begin(), filled.end());
    front = nextFront(graph, filled, lines, isListed);
  }
  const int rounds = 20;
  for (int round = 0; round < rounds && !all.empty(); ++round)
  {
    fillFront(transports, all, lines);
  }
}

/// The axis in the tangent planes of all vertices without a line.
void fillFromAxis(const VertexGraph& graph, const glm::dvec3& axis, Lines& lines)
{
  const double smallest = 0.01; // squared sine of the angle between axis and normal
  for (std::size_t vertex = 0; vertex < lines.size(); ++vertex)
  {
    if (graph.normals[vertex] != glm::dvec3(0.0) && !isKnown(lines[vertex]))
    {
      const glm::dvec2 line = TangentFrame(graph.normals[vertex]).lineVector(axis);
      const double length = glm::length(line);
      lines[vertex] = length > smallest ? line / length : glm::dvec2(0.0);
    }
  }
}

glm::dvec3 findAxis(const VertexGraph& graph, const glm::dvec3& wanted)
{
  const double largest =
    std::max(std::abs(wanted.x), std::max(std::abs(wanted.y), std::abs(wanted.z)));
  if (largest > 0.0)
  {
    return glm::normalize(wanted / largest);
  }
  glm::dvec3 low(0.0), high(0.0); // the middle of the bounds is 0
  for (const glm::dvec3& position : graph.positions)
  {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  const glm::dvec3 extent = high - low;
  return extent.x >= extent.y && extent.x >= extent.z ? glm::dvec3(1.0, 0.0, 0.0)
    : extent.y >= extent.z                            ? glm::dvec3(0.0, 1.0, 0.0)
                                                      : glm::dvec3(0.0, 0.0, 1.0);
}

/// Unit tangents with signs handed on from vertex to vertex.
std::vector<glm::dvec3> chooseSigns(
  const VertexGraph& graph, const Lines& lines, const glm::dvec3& axis)
{
  std::vector<glm::dvec3> directions(lines.size(), glm::dvec3(0.0));
  parallelFor(static_cast<std::int64_t>(lines.size()),
    [&](std::int64_t vertex)
    {
      if (isKnown(lines[vertex]))
      {
        directions[vertex] = TangentFrame(graph.normals[vertex]).line(lines[vertex]);
      }
    });
  std::vector<std::uint8_t> isSeen(lines.size(), 0);
  std::vector<std::int32_t> queue;
  queue.reserve(lines.size());
  for (std::size_t seed = 0; seed < lines.size(); ++seed)
  {
    if (isSeen[seed] || directions[seed] == glm::dvec3(0.0))
    {
      continue;
    }
    isSeen[seed] = 1;
    directions[seed] *= glm::dot(directions[seed], axis) < 0.0 ? -1.0 : 1.0;
    queue.assign(1, static_cast<std::int32_t>(seed));
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const auto from = static_cast<std::size_t>(queue[i]);
      for (const VertexNeighbour& next : graph.neighboursOf(from))
      {
        if (!isSeen[next.vertex])
        {
          isSeen[next.vertex] = 1;
          const glm::dvec3 moved =
            transport(directions[from], graph.normals[from], graph.normals[next.vertex]);
          directions[next.vertex] *= glm::dot(moved, directions[next.vertex]) < 0.0 ? -1.0 : 1.0;
          queue.push_back(next.vertex);
        }
      }
    }
  }
  return directions;
}
} // namespace

DirectionField smoothDirections(
  const VertexGraph& graph, Span<const glm::dvec2> given, const SmoothingOptions& options)
{
  checkOptions(graph, given, options);
  const Transports transports(graph);
  Lines lines(given.begin(), given.end());
  Lines next(lines.size());
  for (int i = 0; i < options.iterations; ++i)
  {
    if (options.progress && !options.progress(static_cast<double>(i) / options.iterations))
    {
      return {};
    }
    average(graph, transports, lines, next);
    lines.swap(next);
  }
  DirectionField result;
  result.reliabilities.resize(lines.size());
  for (std::size_t vertex = 0; vertex < lines.size(); ++vertex)
  {
    result.reliabilities[vertex] =
      isKnown(lines[vertex]) ? std::min(1.0, glm::length(lines[vertex])) : 0.0;
  }
  fill(graph, transports, lines);
  const glm::dvec3 axis = findAxis(graph, options.axis);
  // A plane across the axis needs another one.
  for (const glm::dvec3& seed : { axis, TangentFrame(axis).first })
  {
    fillFromAxis(graph, seed, lines);
    fill(graph, transports, lines);
  }
  result.directions = chooseSigns(graph, lines, axis);
  return result;
}
} // namespace hachure

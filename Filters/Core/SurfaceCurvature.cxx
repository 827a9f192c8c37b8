// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCurvature.h"

#include "Parallel.h"
#include "TangentFrame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
/// A symmetric 3 x 3 matrix and the area over which it was summed.
struct CurvatureMeasure
{
  glm::dvec3 diagonal{ 0.0 }; // xx, yy, zz
  glm::dvec3 mixed{ 0.0 };    // yz, zx, xy
  double norm = 0.0;          // Frobenius norm, of the sum or the sum of those
  double area = 0.0;

  glm::dvec3 operator*(const glm::dvec3& v) const
  {
    return { diagonal.x * v.x + mixed.z * v.y + mixed.y * v.z,
      mixed.z * v.x + diagonal.y * v.y + mixed.x * v.z,
      mixed.y * v.x + mixed.x * v.y + diagonal.z * v.z };
  }
  void add(const CurvatureMeasure& other, double weight)
  {
    diagonal += weight * other.diagonal;
    mixed += weight * other.mixed;
    norm += weight * other.norm;
    area += weight * other.area;
  }
};

/// The halves of the edges of a vertex that are its own.
CurvatureMeasure measureVertex(const VertexGraph& graph, std::size_t vertex)
{
  CurvatureMeasure result;
  for (const VertexNeighbour& neighbour : graph.neighboursOf(vertex))
  {
    const glm::dvec3 edge = graph.positions[neighbour.vertex] - graph.positions[vertex];
    const double factor = 0.5 * neighbour.bend / glm::length(edge);
    result.diagonal += factor * edge * edge;
    result.mixed += factor * glm::dvec3(edge.y * edge.z, edge.z * edge.x, edge.x * edge.y);
  }
  result.norm = std::sqrt(
    glm::dot(result.diagonal, result.diagonal) + 2.0 * glm::dot(result.mixed, result.mixed));
  result.area = graph.areas[vertex];
  return result;
}

/// Sums over discs, one after the other.
class DiscSum
{
public:
  DiscSum(const VertexGraph& someGraph, Span<const CurvatureMeasure> someMeasures)
    : graph(someGraph)
    , measures(someMeasures)
    , seenFrom(someGraph.vertexCount(), -1)
  {
  }

  CurvatureMeasure sum(std::size_t centre, double wantedRadius)
  {
    const double radius = std::max(wantedRadius, reach(centre));
    const double square = radius * radius;
    CurvatureMeasure result;
    disc.assign(1, static_cast<std::int32_t>(centre));
    seenFrom[centre] = static_cast<std::int32_t>(centre);
    result.add(measures[centre], 1.0);
    for (std::size_t i = 0; i < disc.size(); ++i)
    {
      for (const VertexNeighbour& next : graph.neighboursOf(static_cast<std::size_t>(disc[i])))
      {
        if (seenFrom[next.vertex] == static_cast<std::int32_t>(centre))
        {
          continue;
        }
        seenFrom[next.vertex] = static_cast<std::int32_t>(centre);
        const glm::dvec3 way = graph.positions[next.vertex] - graph.positions[centre];
        const double distance = glm::dot(way, way);
        if (distance < square)
        {
          disc.push_back(next.vertex);
          result.add(measures[next.vertex], 1.0 - distance / square);
        }
      }
    }
    return result;
  }

private:
  /// A radius with which the neighbours weigh something, too.
  double reach(std::size_t centre) const
  {
    const double share = 1.5; // of the mean edge
    double sum = 0.0;
    const Span<const VertexNeighbour> neighbours = graph.neighboursOf(centre);
    for (const VertexNeighbour& next : neighbours)
    {
      sum += glm::distance(graph.positions[next.vertex], graph.positions[centre]);
    }
    return neighbours.empty() ? 0.0 : share * sum / static_cast<double>(neighbours.size());
  }

  const VertexGraph& graph;
  Span<const CurvatureMeasure> measures;
  std::vector<std::int32_t> seenFrom; // the last centre whose disc met a vertex
  std::vector<std::int32_t> disc;
};

VertexCurvature findCurvature(const CurvatureMeasure& measure, const glm::dvec3& normal)
{
  VertexCurvature result;
  if (!(measure.area > 0.0) || normal == glm::dvec3(0.0))
  {
    return result;
  }
  const TangentFrame frame(normal);
  const glm::dvec3 first = measure * frame.first;
  const double xx = glm::dot(frame.first, first);
  const double xy = glm::dot(frame.second, first);
  const double yy = glm::dot(frame.second, measure * frame.second);
  const glm::dvec2 difference(0.5 * (xx - yy), xy);
  const double half = glm::length(difference) / measure.area;
  const double mean = 0.5 * (xx + yy) / measure.area;
  result.largest = mean + half;
  result.smallest = mean - half;
  result.bending = measure.norm / measure.area;
  // Along the edges that bend most there is least curvature.
  result.direction = half > 0.0 ? frame.line(-difference) : glm::dvec3(0.0);
  return result;
}
} // namespace

double defaultCurvatureRadius(const VertexGraph& graph)
{
  const double edges = 3.0;
  return edges * graph.meanEdge * graph.size;
}

std::vector<VertexCurvature> vertexCurvatures(
  const VertexGraph& graph, const CurvatureOptions& options)
{
  if (!(options.radius >= 0.0) || !std::isfinite(options.radius))
  {
    throw std::invalid_argument("options.radius is " + std::to_string(options.radius) +
      ", expected a finite length of 0 or more");
  }
  const auto count = static_cast<std::int64_t>(graph.vertexCount());
  std::vector<CurvatureMeasure> measures(graph.vertexCount());
  parallelFor(count,
    [&](std::int64_t i) { measures[i] = measureVertex(graph, static_cast<std::size_t>(i)); });
  const double radius = options.radius / graph.size;
  std::vector<VertexCurvature> result(graph.vertexCount());
  const std::int64_t steps = 10; // reports of progress
  for (std::int64_t step = 0; step < steps; ++step)
  {
    if (options.progress && !options.progress(static_cast<double>(step) / steps))
    {
      return {};
    }
    const std::int64_t begin = count * step / steps;
    const std::int64_t size = count * (step + 1) / steps - begin;
    parallelForRanges(size, size / maximumThreads() + 1,
      [&](std::int64_t rangeBegin, std::int64_t rangeEnd)
      {
        DiscSum discs(graph, measures);
        for (std::int64_t i = begin + rangeBegin; i < begin + rangeEnd; ++i)
        {
          const auto vertex = static_cast<std::size_t>(i);
          VertexCurvature& curvature = result[vertex];
          curvature = findCurvature(discs.sum(vertex, radius), graph.normals[vertex]);
          curvature.largest /= graph.size;
          curvature.smallest /= graph.size;
          curvature.bending /= graph.size;
        }
      });
  }
  return result;
}
} // namespace hachure

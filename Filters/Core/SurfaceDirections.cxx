// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDirections.h"

#include "Parallel.h"
#include "TangentFrame.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
bool isFinite(const glm::dvec3& value)
{
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

void checkSize(const char* name, std::size_t size, std::size_t expected)
{
  if (size != expected)
  {
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(size) +
      " elements, expected " + std::to_string(expected));
  }
}

/// A reliability below this comes from the triangulation or from noise as likely as from the
/// surface: 0, and from there on continuous.
double withoutDoubt(double reliability)
{
  const double doubt = 0.05;
  return glm::clamp((reliability - doubt) / (1.0 - doubt), 0.0, 1.0);
}

/// A line of this length.
glm::dvec2 scaled(const glm::dvec2& line, double length)
{
  const double old = glm::length(line);
  return old > 0.0 ? line * (length / old) : glm::dvec2(0.0);
}

template <class Body>
std::vector<glm::dvec2> linesOfVertices(const VertexGraph& graph, Body&& body)
{
  std::vector<glm::dvec2> lines(graph.vertexCount(), glm::dvec2(0.0));
  parallelFor(static_cast<std::int64_t>(lines.size()),
    [&](std::int64_t vertex)
    {
      if (graph.normals[vertex] != glm::dvec3(0.0))
      {
        lines[vertex] = body(static_cast<std::size_t>(vertex));
      }
    });
  return lines;
}

/// A vector's line, of a length by how far it lies in the tangent plane.
glm::dvec2 tangentialLine(const TangentFrame& frame, const glm::dvec3& vector)
{
  const double largest =
    std::max(std::abs(vector.x), std::max(std::abs(vector.y), std::abs(vector.z)));
  if (!isFinite(vector) || !(largest > 0.0))
  {
    return glm::dvec2(0.0);
  }
  const glm::dvec2 line = frame.lineVector(glm::normalize(vector / largest));
  return scaled(line, std::sqrt(glm::length(line)));
}

/// Gradient on a triangle of values at its corners, in units of the graph.
glm::dvec3 triangleGradient(const TriangleMesh& mesh, const VertexGraph& graph,
  std::size_t triangle, Span<const double> scalars)
{
  const glm::ivec3 c = mesh.triangles[graph.sources[triangle]];
  const glm::dvec3 ab = (mesh.points[c.y] - mesh.points[c.x]) / graph.size;
  const glm::dvec3 ac = (mesh.points[c.z] - mesh.points[c.x]) / graph.size;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double toB = scalars[c.y] - scalars[c.x];
  const double toC = scalars[c.z] - scalars[c.x];
  return glm::cross(normal, toC * ab - toB * ac) / glm::dot(normal, normal);
}

struct WeightedVector
{
  glm::dvec3 value{ 0.0 };
  double area = 0.0;
};

/// Factor that makes the finite values span 1 and so keeps them from overflow; 0 without a span.
double rangeFactor(const TriangleMesh& mesh, Span<const double> scalars)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const glm::ivec3& corners : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double value = scalars[corners[k]];
      low = std::isfinite(value) ? std::min(low, value) : low;
      high = std::isfinite(value) ? std::max(high, value) : high;
    }
  }
  const double factor = 1.0 / (high - low);
  return high > low && std::isfinite(factor) ? factor : 0.0;
}
} // namespace

std::vector<glm::dvec2> curvatureLines(
  const VertexGraph& graph, Span<const VertexCurvature> curvatures, CurvatureLine which)
{
  checkSize("curvatures", curvatures.size(), graph.vertexCount());
  // A surface that hardly bends: a radius of a hundred times its size.
  const double floor = graph.area > 0.0 ? 0.01 / (std::sqrt(graph.area) * graph.size) : 0.0;
  const bool byMagnitude =
    which == CurvatureLine::LargestMagnitude || which == CurvatureLine::SmallestMagnitude;
  return linesOfVertices(graph,
    [&](std::size_t vertex)
    {
      const VertexCurvature& curvature = curvatures[vertex];
      const double sum = curvature.largest + curvature.smallest;
      const double difference = curvature.largest - curvature.smallest;
      const double anisotropy = byMagnitude ? std::min(std::abs(sum), difference) : difference;
      const bool along = which == CurvatureLine::Largest ||
        (byMagnitude && (which == CurvatureLine::LargestMagnitude) == (sum >= 0.0));
      const double total = curvature.bending + floor;
      const glm::dvec2 line = TangentFrame(graph.normals[vertex]).lineVector(curvature.direction);
      const double reliability = total > 0.0 ? withoutDoubt(anisotropy / total) : 0.0;
      return scaled(along ? line : -line, reliability);
    });
}

std::vector<glm::dvec2> gradientLines(
  const VertexGraph& graph, const TriangleMesh& mesh, Span<const double> scalars)
{
  checkSize("scalars", scalars.size(), mesh.points.size());
  const double factor = rangeFactor(mesh, scalars);
  std::vector<WeightedVector> gradients(graph.triangles.size());
  parallelFor(static_cast<std::int64_t>(gradients.size()),
    [&](std::int64_t i)
    {
      const glm::ivec3 c = graph.triangles[i];
      const glm::dvec3 a = graph.positions[c.x];
      const glm::dvec3 gradient =
        factor * triangleGradient(mesh, graph, static_cast<std::size_t>(i), scalars);
      if (isFinite(gradient))
      {
        gradients[i].area =
          0.5 * glm::length(glm::cross(graph.positions[c.y] - a, graph.positions[c.z] - a));
        gradients[i].value = gradient;
      }
    });
  // Slower change than this share of the range over the whole surface is no direction.
  const double floor = graph.area > 0.0 ? 1e-3 / std::sqrt(graph.area) : 0.0;
  return linesOfVertices(graph,
    [&](std::size_t vertex)
    {
      glm::dvec3 sum(0.0);
      double total = 0.0;
      for (const std::int32_t triangle : graph.trianglesAt(vertex))
      {
        const WeightedVector& gradient = gradients[triangle];
        sum += gradient.area * gradient.value;
        total += gradient.area * (glm::length(gradient.value) + floor);
      }
      const glm::dvec2 line = TangentFrame(graph.normals[vertex]).lineVector(sum);
      const double reliability =
        total > 0.0 ? std::min(1.0, std::sqrt(glm::length(line)) / total) : 0.0;
      return scaled(line, reliability);
    });
}

std::vector<glm::dvec2> pointVectorLines(
  const VertexGraph& graph, Span<const std::int32_t> vertices, Span<const glm::dvec3> vectors)
{
  checkSize("vectors", vectors.size(), vertices.size());
  std::vector<glm::dvec2> lines(graph.vertexCount(), glm::dvec2(0.0));
  std::vector<double> counts(lines.size(), 0.0);
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    const std::int32_t vertex = vertices[i];
    if (graph.normals[vertex] != glm::dvec3(0.0) && isFinite(vectors[i]))
    {
      lines[vertex] += tangentialLine(TangentFrame(graph.normals[vertex]), vectors[i]);
      counts[vertex] += vectors[i] == glm::dvec3(0.0) ? 0.0 : 1.0;
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    lines[i] /= std::max(1.0, counts[i]);
  }
  return lines;
}

std::vector<glm::dvec2> triangleVectorLines(
  const VertexGraph& graph, Span<const glm::dvec3> vectors)
{
  for (const std::int32_t source : graph.sources)
  {
    if (source >= static_cast<std::int64_t>(vectors.size()))
    {
      throw std::invalid_argument("vectors has " + std::to_string(vectors.size()) +
        " elements, expected one per triangle of the mesh");
    }
  }
  return linesOfVertices(graph,
    [&](std::size_t vertex)
    {
      const TangentFrame frame(graph.normals[vertex]);
      glm::dvec2 sum(0.0);
      double total = 0.0;
      for (const std::int32_t triangle : graph.trianglesAt(vertex))
      {
        const glm::dvec3 vector = vectors[graph.sources[triangle]];
        const glm::ivec3 c = graph.triangles[triangle];
        const glm::dvec3 a = graph.positions[c.x];
        const double area =
          glm::length(glm::cross(graph.positions[c.y] - a, graph.positions[c.z] - a));
        // Turned with the triangle, so that a vector in its plane stays one.
        const glm::dvec3 moved =
          transport(vector, graph.triangleNormals[triangle], graph.normals[vertex]);
        sum += area * tangentialLine(frame, moved);
        total += isFinite(vector) && vector != glm::dvec3(0.0) ? area : 0.0;
      }
      return total > 0.0 ? sum / total : glm::dvec2(0.0);
    });
}

DirectionField directionsAtPoints(const VertexGraph& graph, const TriangleMesh& mesh,
  Span<const std::int32_t> vertices, const DirectionField& field, Span<const glm::dvec3> normals)
{
  checkSize("vertices", vertices.size(), mesh.points.size());
  checkSize("field.directions", field.directions.size(), graph.vertexCount());
  if (!normals.empty())
  {
    checkSize("normals", normals.size(), mesh.points.size());
  }
  DirectionField result;
  result.directions.assign(mesh.points.size(), glm::dvec3(0.0));
  result.reliabilities.assign(mesh.points.size(), 0.0);
  std::vector<std::uint8_t> isCorner(mesh.points.size(), 0);
  for (const glm::ivec3& corners : mesh.triangles)
  {
    isCorner[corners.x] = isCorner[corners.y] = isCorner[corners.z] = 1;
  }
  parallelFor(static_cast<std::int64_t>(mesh.points.size()),
    [&](std::int64_t i)
    {
      const std::int32_t vertex = vertices[i];
      const glm::dvec3 direction = field.directions[vertex];
      if (!isCorner[i] || direction == glm::dvec3(0.0))
      {
        return;
      }
      result.directions[i] = direction;
      result.reliabilities[i] = field.reliabilities[vertex];
      const double length = normals.empty() ? 0.0 : glm::length(normals[i]);
      if (length > 0.0 && std::isfinite(length))
      {
        const glm::dvec3 from = graph.normals[vertex];
        const glm::dvec3 to = normals[i] / (glm::dot(normals[i], from) < 0.0 ? -length : length);
        const glm::dvec3 moved = transport(direction, from, to);
        result.directions[i] = glm::normalize(moved - glm::dot(moved, to) * to);
      }
    });
  return result;
}
} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexGraph.h"

#include "Parallel.h"
#include "SurfacePatchesMesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace hachure
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr std::int64_t verticesPerRange = 1024; // enough to share scratch memory

/// Positions of the vertices that triangles use, and the triangles with an area.
void addGeometry(VertexGraph& graph, const FaceSurface& surface)
{
  const TriangleMesh& mesh = surface.mesh;
  graph.positions.assign(static_cast<std::size_t>(surface.vertexCount()), glm::dvec3(0.0));
  if (mesh.triangles.empty())
  {
    return;
  }
  glm::dvec3 low = mesh.points[mesh.triangles[0].x];
  glm::dvec3 high = low;
  for (const glm::ivec3& corners : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      low = glm::min(low, mesh.points[corners[k]]);
      high = glm::max(high, mesh.points[corners[k]]);
    }
  }
  const glm::dvec3 middle = 0.5 * low + 0.5 * high;
  const glm::dvec3 half = high - middle;
  graph.size = 2.0 * std::max(half.x, std::max(half.y, half.z));
  graph.size = graph.size > 0.0 && std::isfinite(graph.size) ? graph.size : 1.0;
  graph.triangles.reserve(mesh.triangles.size());
  graph.sources.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const glm::ivec3 points = mesh.triangles[i];
    const glm::ivec3 corners = surface.verticesOf(i);
    for (int k = 0; k < 3; ++k)
    {
      graph.positions[corners[k]] = (mesh.points[points[k]] - middle) / graph.size;
    }
    if (!isDegenerateTriangle(
          graph.positions[corners.x], graph.positions[corners.y], graph.positions[corners.z]))
    {
      graph.triangles.push_back(corners);
      graph.sources.push_back(static_cast<std::int32_t>(i));
    }
  }
}

void addCorners(VertexGraph& graph)
{
  graph.cornerOffsets.assign(graph.vertexCount() + 1, 0);
  for (const glm::ivec3& corners : graph.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++graph.cornerOffsets[corners[k] + 1];
    }
  }
  std::partial_sum(
    graph.cornerOffsets.begin(), graph.cornerOffsets.end(), graph.cornerOffsets.begin());
  graph.corners.resize(graph.cornerOffsets.back());
  std::vector<std::size_t> next(graph.cornerOffsets.begin(), graph.cornerOffsets.end() - 1);
  for (std::size_t i = 0; i < graph.triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      graph.corners[next[graph.triangles[i][k]]++] = static_cast<std::int32_t>(i);
    }
  }
}

/// Marks triangles around their lowest vertex whose vertices are those of a triangle before;
/// whether there are any. `others` is scratch memory: the other two vertices and the triangle.
bool markRepeated(const VertexGraph& graph, std::int32_t vertex,
  std::vector<std::array<std::int32_t, 3>>& others, std::vector<std::uint8_t>& isRepeated)
{
  others.clear();
  for (const std::int32_t triangle : graph.trianglesAt(static_cast<std::size_t>(vertex)))
  {
    const glm::ivec3 c = graph.triangles[triangle];
    if (vertex == std::min(c.x, std::min(c.y, c.z)))
    {
      const std::int32_t last = std::max(c.x, std::max(c.y, c.z));
      others.push_back({ c.x + c.y + c.z - vertex - last, last, triangle });
    }
  }
  std::sort(others.begin(), others.end());
  bool found = false;
  for (std::size_t i = 1; i < others.size(); ++i)
  {
    if (others[i][0] == others[i - 1][0] && others[i][1] == others[i - 1][1])
    {
      isRepeated[others[i][2]] = 1;
      found = true;
    }
  }
  return found;
}

bool findRepeated(const VertexGraph& graph, std::vector<std::uint8_t>& isRepeated)
{
  isRepeated.assign(graph.triangles.size(), 0);
  std::atomic<bool> found{ false };
  parallelForRanges(static_cast<std::int64_t>(graph.vertexCount()), verticesPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::array<std::int32_t, 3>> others;
      for (std::int64_t vertex = begin; vertex < end; ++vertex)
      {
        if (markRepeated(graph, static_cast<std::int32_t>(vertex), others, isRepeated))
        {
          found = true;
        }
      }
    });
  return found;
}

void removeRepeated(VertexGraph& graph)
{
  std::vector<std::uint8_t> isRepeated;
  if (!findRepeated(graph, isRepeated))
  {
    return;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < graph.triangles.size(); ++i)
  {
    if (!isRepeated[i])
    {
      graph.triangles[kept] = graph.triangles[i];
      graph.sources[kept++] = graph.sources[i];
    }
  }
  graph.triangles.resize(kept);
  graph.sources.resize(kept);
  addCorners(graph);
}

/// A side of a triangle at one of its ends.
struct Side
{
  std::int32_t other = 0; // vertex at the other end
  std::int32_t triangle = 0;
  bool leaves = false; // the triangle runs from this end to the other

  bool operator<(const Side& right) const
  {
    return other != right.other    ? other < right.other
      : triangle != right.triangle ? triangle < right.triangle
                                   : leaves < right.leaves;
  }
};

void findSides(const VertexGraph& graph, std::size_t vertex, std::vector<Side>& sides)
{
  sides.clear();
  for (const std::int32_t triangle : graph.trianglesAt(vertex))
  {
    const glm::ivec3 c = graph.triangles[triangle];
    const int k = c.x == static_cast<int>(vertex) ? 0 : c.y == static_cast<int>(vertex) ? 1 : 2;
    sides.push_back({ c[(k + 1) % 3], triangle, true });
    sides.push_back({ c[(k + 2) % 3], triangle, false });
  }
  std::sort(sides.begin(), sides.end());
}

/// Calls body(vertex, sides) for every vertex, on several threads.
template <class Body>
void forEachVertex(const VertexGraph& graph, Body&& body)
{
  parallelForRanges(static_cast<std::int64_t>(graph.vertexCount()), verticesPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<Side> sides;
      for (std::int64_t vertex = begin; vertex < end; ++vertex)
      {
        findSides(graph, static_cast<std::size_t>(vertex), sides);
        body(static_cast<std::size_t>(vertex), sides);
      }
    });
}

/// Turns triangles over until neighbours agree, the fewer ones of every connected piece. Not across
/// edges where more than two meet: there the pieces need not agree.
void orient(VertexGraph& graph)
{
  const FaceSurface surface{ { graph.positions, graph.triangles, {} }, {}, {} };
  const FaceGraph faces(surface);
  enum : std::int8_t
  {
    Unseen = -1,
    Kept = 0,
    Turned = 1
  };
  std::vector<std::int8_t> states(graph.triangles.size(), Unseen);
  std::vector<std::int32_t> piece;
  for (std::size_t seed = 0; seed < states.size(); ++seed)
  {
    if (states[seed] != Unseen)
    {
      continue;
    }
    piece.assign(1, static_cast<std::int32_t>(seed));
    states[seed] = Kept;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      const std::int32_t face = piece[i];
      turned += states[face] == Turned ? 1 : 0;
      const Span<const FaceNeighbour> around = faces.neighbours(face);
      for (const FaceNeighbour& next : around)
      {
        if (around.size() <= 3 && faces.neighbours(next.face).size() <= 3 &&
          states[next.face] == Unseen)
        {
          const bool turn = (states[face] == Turned) != next.turned;
          states[next.face] = turn ? Turned : Kept;
          piece.push_back(next.face);
        }
      }
    }
    const std::int8_t wrong = 2 * turned > piece.size() ? Kept : Turned;
    for (const std::int32_t face : piece)
    {
      if (states[face] == wrong)
      {
        std::swap(graph.triangles[face].y, graph.triangles[face].z);
      }
    }
  }
}

/// Normals and areas of triangles and vertices. A vertex normal is the mean of those around it by
/// their angles (Thuermer and Wuethrich 1998), which depends on no triangulation of flat faces.
void addNormals(VertexGraph& graph)
{
  const std::size_t count = graph.triangles.size();
  graph.triangleNormals.resize(count);
  std::vector<double> areas(count);
  std::vector<glm::dvec3> angles(count);
  parallelFor(static_cast<std::int64_t>(count),
    [&](std::int64_t i)
    {
      const glm::ivec3 c = graph.triangles[i];
      const glm::dvec3 a = graph.positions[c.x];
      const glm::dvec3 ab = graph.positions[c.y] - a;
      const glm::dvec3 ac = graph.positions[c.z] - a;
      const glm::dvec3 normal = glm::cross(ab, ac);
      const double length = glm::length(normal);
      graph.triangleNormals[i] = length > 0.0 ? normal / length : glm::dvec3(0.0);
      areas[i] = 0.5 * length;
      const double first = std::atan2(length, glm::dot(ab, ac));
      const double second = std::atan2(length, glm::dot(-ab, ac - ab));
      angles[i] = glm::dvec3(first, second, std::max(0.0, pi - first - second));
    });
  graph.area = std::accumulate(areas.begin(), areas.end(), 0.0);
  graph.normals.resize(graph.vertexCount());
  graph.areas.resize(graph.vertexCount());
  parallelFor(static_cast<std::int64_t>(graph.vertexCount()),
    [&](std::int64_t vertex)
    {
      glm::dvec3 sum(0.0);
      double area = 0.0;
      for (const std::int32_t triangle : graph.trianglesAt(vertex))
      {
        const glm::ivec3 c = graph.triangles[triangle];
        const int k = c.x == vertex ? 0 : c.y == vertex ? 1 : 2;
        sum += angles[triangle][k] * graph.triangleNormals[triangle];
        area += areas[triangle] / 3.0;
      }
      const double length = glm::length(sum);
      // Where two sides cancel each other, either is as good.
      const glm::dvec3 any =
        area > 0.0 ? graph.triangleNormals[graph.trianglesAt(vertex).front()] : glm::dvec3(0.0);
      graph.normals[vertex] = length > 1e-9 ? sum / length : any;
      graph.areas[vertex] = area;
    });
}

/// The cotangent of the angle opposite of a side.
double cotangent(const VertexGraph& graph, std::size_t vertex, const Side& side)
{
  const glm::ivec3 c = graph.triangles[side.triangle];
  const int far = c.x + c.y + c.z - static_cast<int>(vertex) - side.other;
  const glm::dvec3 a = graph.positions[vertex] - graph.positions[far];
  const glm::dvec3 b = graph.positions[side.other] - graph.positions[far];
  return glm::dot(a, b) / std::max(glm::length(glm::cross(a, b)), 1e-300);
}

/// An edge from its sides. Of several triangles on one side the mean normal counts.
VertexNeighbour makeNeighbour(const VertexGraph& graph, std::size_t vertex, Span<const Side> sides)
{
  // Obtuse pairs have weights below 0 and slivers very large ones: both unbalance a mean.
  const double smallestWeight = 0.05;
  const double largestWeight = 5.0;
  double weight = 0.0;
  glm::dvec3 left(0.0), right(0.0);
  for (const Side& side : sides)
  {
    weight += 0.5 * cotangent(graph, vertex, side);
    (side.leaves ? left : right) += graph.triangleNormals[side.triangle];
  }
  VertexNeighbour result;
  result.vertex = sides.front().other;
  result.weight = static_cast<float>(glm::clamp(weight, smallestWeight, largestWeight));
  if (left != glm::dvec3(0.0) && right != glm::dvec3(0.0))
  {
    const glm::dvec3 edge =
      glm::normalize(graph.positions[result.vertex] - graph.positions[vertex]);
    result.bend = static_cast<float>(
      std::atan2(glm::dot(glm::cross(left, right), edge), glm::dot(left, right)));
  }
  return result;
}

/// Calls body(sides of one edge) for the edges of a vertex, by ascending neighbour.
template <class Body>
void forEachEdge(const std::vector<Side>& sides, Body&& body)
{
  for (std::size_t begin = 0; begin < sides.size();)
  {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].other == sides[begin].other)
    {
      ++end;
    }
    body(Span<const Side>(sides).subspan(begin, end - begin));
    begin = end;
  }
}

/// Counts the neighbours of all vertices; whether two triangles run the same way along an edge.
bool countNeighbours(VertexGraph& graph)
{
  graph.neighbourOffsets.assign(graph.vertexCount() + 1, 0);
  std::atomic<bool> hasTurned{ false };
  forEachVertex(graph,
    [&](std::size_t vertex, const std::vector<Side>& sides)
    {
      std::size_t count = 0;
      forEachEdge(sides,
        [&](Span<const Side> edge)
        {
          ++count;
          const auto leaving =
            std::count_if(edge.begin(), edge.end(), [](const Side& side) { return side.leaves; });
          if (leaving > 1)
          {
            hasTurned = true;
          }
        });
      graph.neighbourOffsets[vertex + 1] = count;
    });
  std::partial_sum(
    graph.neighbourOffsets.begin(), graph.neighbourOffsets.end(), graph.neighbourOffsets.begin());
  return hasTurned;
}

void addNeighbours(VertexGraph& graph)
{
  graph.neighbours.resize(graph.neighbourOffsets.back());
  forEachVertex(graph,
    [&](std::size_t vertex, const std::vector<Side>& sides)
    {
      std::size_t next = graph.neighbourOffsets[vertex];
      forEachEdge(sides,
        [&](Span<const Side> edge)
        { graph.neighbours[next++] = makeNeighbour(graph, vertex, edge); });
    });
}

void measureEdges(VertexGraph& graph)
{
  double sum = 0.0;
  for (std::size_t vertex = 0; vertex < graph.vertexCount(); ++vertex)
  {
    for (const VertexNeighbour& neighbour : graph.neighboursOf(vertex))
    {
      sum += glm::distance(graph.positions[vertex], graph.positions[neighbour.vertex]);
    }
  }
  graph.meanEdge =
    graph.neighbours.empty() ? 0.0 : sum / static_cast<double>(graph.neighbours.size());
}
} // namespace

VertexGraph makeVertexGraph(const TriangleMesh& mesh, Span<const std::int32_t> vertices)
{
  const FaceSurface surface{ mesh, {}, vertices };
  checkFaceSurface(surface);
  VertexGraph graph;
  addGeometry(graph, surface);
  addCorners(graph);
  removeRepeated(graph);
  if (countNeighbours(graph))
  {
    orient(graph);
  }
  addNormals(graph);
  addNeighbours(graph);
  measureEdges(graph);
  return graph;
}
} // namespace hachure

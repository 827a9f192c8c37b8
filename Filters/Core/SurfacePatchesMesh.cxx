// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatchesMesh.h"

#include "Parallel.h"
#include "Random.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace hachure
{
namespace
{
struct PlaceHash
{
  std::size_t operator()(const glm::dvec4& place) const
  {
    std::uint64_t hash = 0;
    for (int i = 0; i < 4; ++i)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &place[i], sizeof(bits));
      hash = hashPair(hash, bits);
    }
    return static_cast<std::size_t>(hash);
  }
};

/// One side of a triangle.
struct HalfEdge
{
  std::int32_t low = 0;
  std::int32_t high = 0;
  std::int32_t face = 0;
  bool upward = false; // from the low vertex to the high one

  bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// All sides between different vertices, sorted by edge and then by face.
std::vector<HalfEdge> sortedEdges(const FaceSurface& surface)
{
  const std::size_t vertexCount = static_cast<std::size_t>(surface.vertexCount());
  const std::size_t triangleCount = surface.mesh.triangles.size();
  std::vector<std::size_t> offsets(vertexCount + 1, 0);
  const auto forEachSide = [&](auto&& body)
  {
    for (std::size_t i = 0; i < triangleCount; ++i)
    {
      const glm::ivec3 corners = surface.verticesOf(i);
      for (int k = 0; k < 3; ++k)
      {
        const std::int32_t a = corners[k];
        const std::int32_t b = corners[(k + 1) % 3];
        if (a != b)
        {
          body(HalfEdge{ std::min(a, b), std::max(a, b), surface.faceOf(i), a < b });
        }
      }
    }
  };
  forEachSide([&](const HalfEdge& edge) { ++offsets[edge.low + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<HalfEdge> edges(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  forEachSide([&](const HalfEdge& edge) { edges[next[edge.low]++] = edge; });
  parallelFor(static_cast<std::int64_t>(vertexCount),
    [&](std::int64_t vertex)
    {
      std::sort(edges.begin() + static_cast<std::ptrdiff_t>(offsets[vertex]),
        edges.begin() + static_cast<std::ptrdiff_t>(offsets[vertex + 1]),
        [](const HalfEdge& a, const HalfEdge& b)
        {
          return a.high != b.high ? a.high < b.high
            : a.face != b.face    ? a.face < b.face
                                  : a.upward < b.upward;
        });
    });
  return edges;
}

/// Calls body(first, second) for every ordered pair of different faces that share an edge.
template <class Body>
void forEachPair(const std::vector<HalfEdge>& edges, Body&& body)
{
  // Meeting in one edge, more faces than these are linked in a chain: linear, and still connected.
  const std::size_t mostInPairs = 16;
  for (std::size_t begin = 0; begin < edges.size();)
  {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].sameEdge(edges[begin]))
    {
      ++end;
    }
    const std::size_t reach = end - begin > mostInPairs ? 1 : end - begin;
    for (std::size_t i = begin; i < end; ++i)
    {
      for (std::size_t j = i + 1; j < end && j <= i + reach; ++j)
      {
        if (edges[i].face != edges[j].face)
        {
          body(edges[i], edges[j]);
          body(edges[j], edges[i]);
        }
      }
    }
    begin = end;
  }
}
} // namespace

std::int32_t FaceSurface::vertexCount() const
{
  if (this->vertices.empty())
  {
    return static_cast<std::int32_t>(this->mesh.points.size());
  }
  return *std::max_element(this->vertices.begin(), this->vertices.end()) + 1;
}

void checkFaceSurface(const FaceSurface& surface)
{
  checkTriangleMesh(surface.mesh);
  const auto checkSize = [](const char* name, std::size_t size, std::size_t expected)
  {
    if (size != 0 && size != expected)
    {
      throw std::invalid_argument(std::string("surface.") + name + ": " + std::to_string(size) +
        " values, expected " + std::to_string(expected));
    }
  };
  checkSize("faces", surface.faces.size(), surface.mesh.triangles.size());
  checkSize("vertices", surface.vertices.size(), surface.mesh.points.size());
  std::int32_t previous = -1;
  for (std::size_t i = 0; i < surface.faces.size(); ++i)
  {
    if (surface.faces[i] < std::max(previous, 0) || surface.faces[i] > previous + 1)
    {
      throw std::invalid_argument("surface.faces[" + std::to_string(i) + "] is " +
        std::to_string(surface.faces[i]) + " after " + std::to_string(previous) +
        "; expected faces in order from 0 on");
    }
    previous = surface.faces[i];
  }
  for (std::size_t i = 0; i < surface.vertices.size(); ++i)
  {
    if (surface.vertices[i] < 0)
    {
      throw std::invalid_argument("surface.vertices[" + std::to_string(i) + "] is " +
        std::to_string(surface.vertices[i]) + ", expected 0 or more");
    }
  }
}

std::vector<std::int32_t> joinPoints(Span<const glm::dvec3> points, Span<const std::int32_t> groups)
{
  if (!groups.empty() && groups.size() != points.size())
  {
    throw std::invalid_argument("groups: " + std::to_string(groups.size()) + " values for " +
      std::to_string(points.size()) + " points");
  }
  std::unordered_map<glm::dvec4, std::int32_t, PlaceHash> known;
  known.reserve(points.size());
  std::vector<std::int32_t> vertices(points.size());
  std::int32_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // Adding 0 turns -0 into 0; a coordinate that is not a number equals nothing, so stays alone.
    const glm::dvec4 place(points[i] + 0.0, groups.empty() ? 0.0 : groups[i]);
    const auto found = known.emplace(place, count);
    vertices[i] = found.first->second;
    count += found.second ? 1 : 0;
  }
  return vertices;
}

FaceGraph::FaceGraph(const FaceSurface& surface)
  : offsets(static_cast<std::size_t>(surface.faceCount()) + 1, 0)
{
  const std::vector<HalfEdge> edges = sortedEdges(surface);
  forEachPair(
    edges, [this](const HalfEdge& from, const HalfEdge&) { ++this->offsets[from.face + 1]; });
  std::partial_sum(this->offsets.begin(), this->offsets.end(), this->offsets.begin());
  this->entries.resize(this->offsets.back());
  std::vector<std::size_t> next(this->offsets.begin(), this->offsets.end() - 1);
  forEachPair(edges,
    [&](const HalfEdge& from, const HalfEdge& to) {
      this->entries[next[from.face]++] = { to.face, from.upward == to.upward };
    });
}

std::vector<FaceShape> faceShapes(const FaceSurface& surface)
{
  const std::size_t triangleCount = surface.mesh.triangles.size();
  std::vector<FaceShape> shapes(static_cast<std::size_t>(surface.faceCount()));
  std::vector<glm::dvec3> middles(shapes.size(), glm::dvec3(0.0));
  std::vector<int> counts(shapes.size(), 0);
  for (std::size_t i = 0; i < triangleCount; ++i)
  {
    const glm::ivec3 corners = surface.mesh.triangles[i];
    const glm::dvec3 a = surface.mesh.points[corners.x];
    const glm::dvec3 b = surface.mesh.points[corners.y];
    const glm::dvec3 c = surface.mesh.points[corners.z];
    const glm::dvec3 middle = (a + b + c) / 3.0;
    const glm::dvec3 vector =
      isDegenerateTriangle(a, b, c) ? glm::dvec3(0.0) : glm::cross(b - a, c - a);
    FaceShape& shape = shapes[surface.faceOf(i)];
    const double area = 0.5 * glm::length(vector);
    shape.centroid += area * middle;
    shape.normal += vector;
    shape.area += area;
    middles[surface.faceOf(i)] += middle;
    ++counts[surface.faceOf(i)];
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const double length = glm::length(shapes[i].normal);
    const bool hasArea = shapes[i].area > 0.0 && std::isfinite(1.0 / shapes[i].area);
    shapes[i].centroid =
      hasArea ? shapes[i].centroid / shapes[i].area : middles[i] / static_cast<double>(counts[i]);
    // A strip folded flat has area but no direction.
    shapes[i].normal =
      hasArea && length > 1e-12 * shapes[i].area ? shapes[i].normal / length : glm::dvec3(0.0);
  }
  return shapes;
}

DisjointSets::DisjointSets(std::size_t count)
  : parents(count)
{
  std::iota(this->parents.begin(), this->parents.end(), 0);
}

std::int32_t DisjointSets::find(std::int32_t item)
{
  while (this->parents[item] != item)
  {
    this->parents[item] = this->parents[this->parents[item]];
    item = this->parents[item];
  }
  return item;
}

void DisjointSets::join(std::int32_t first, std::int32_t second)
{
  first = this->find(first);
  second = this->find(second);
  this->parents[std::max(first, second)] = std::min(first, second);
}
} // namespace hachure

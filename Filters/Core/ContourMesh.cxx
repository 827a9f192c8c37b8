// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourMesh.h"

#include "Parallel.h"
#include "ParallelSort.h"
#include "SurfacePatchesMesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace hachure
{
namespace
{

bool isFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

// Along a direction across which few vertices of a grid have others at the same height.
double seamOrder(const glm::dvec3& place)
{
  return glm::dot(place, glm::dvec3(0.4822, 0.7351, 0.4766));
}

// How far points may be apart, in view space, by the rounding of equal coordinates.
double seamWidth(Span<const glm::dvec3> points, const glm::dmat4& modelToView)
{
  constexpr double roundings = 1e-6; // a few, of a number with 24 bits
  double largest = 0.0;
  for (const glm::dvec3& point : points)
  {
    if (isFinite(point))
    {
      const glm::dvec3 size = glm::abs(point);
      largest = std::max(largest, std::max(size.x, std::max(size.y, size.z)));
    }
  }
  const double scale = std::max(glm::length(glm::dvec3(modelToView[0])),
    std::max(glm::length(glm::dvec3(modelToView[1])), glm::length(glm::dvec3(modelToView[2]))));
  return roundings * scale * largest;
}

} // namespace

ContourMesh::ContourMesh(const TriangleMesh& mesh, const glm::dmat4& modelToView)
{
  const std::vector<std::int32_t> vertices = joinPoints(mesh.points);
  this->positions.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    this->positions[vertices[i]] = glm::dvec3(modelToView * glm::dvec4(mesh.points[i], 1.0));
  }
  this->addTriangles(mesh, vertices);
  this->removeRepeated();
  this->addHalfEdges();
  this->closeSeams(seamWidth(mesh.points, modelToView));
  this->turnTriangles();
  this->addFaceNormals();
}

void ContourMesh::addTriangles(const TriangleMesh& mesh, const std::vector<std::int32_t>& vertices)
{
  this->triangles.reserve(mesh.triangles.size());
  for (const glm::ivec3& points : mesh.triangles)
  {
    const glm::ivec3 corners(vertices[points.x], vertices[points.y], vertices[points.z]);
    const glm::dvec3& a = this->positions[corners.x];
    const glm::dvec3& b = this->positions[corners.y];
    const glm::dvec3& c = this->positions[corners.z];
    if (isFinite(a) && isFinite(b) && isFinite(c) && !isDegenerateTriangle(a, b, c))
    {
      this->triangles.push_back(corners);
    }
  }
}

void ContourMesh::removeRepeated()
{
  std::vector<std::array<std::int32_t, 4>> keys(this->triangles.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const glm::ivec3& corners = this->triangles[i];
    keys[i] = { corners.x, corners.y, corners.z, static_cast<std::int32_t>(i) };
    std::sort(keys[i].begin(), keys[i].begin() + 3);
  }
  parallelSort(keys);
  std::vector<char> isRepeated(this->triangles.size(), 0);
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    isRepeated[keys[i][3]] = std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin());
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->triangles.size(); ++i)
  {
    if (!isRepeated[i])
    {
      this->triangles[kept++] = this->triangles[i];
    }
  }
  this->triangles.resize(kept);
}

void ContourMesh::addHalfEdges()
{
  this->halfEdges.resize(this->cornerCount());
  parallelFor(static_cast<std::int64_t>(this->halfEdges.size()),
    [this](std::int64_t i)
    {
      const auto corner = static_cast<std::int32_t>(i);
      const std::int32_t from = this->vertexOf(corner);
      const std::int32_t to = this->vertexOf(nextCorner(corner));
      this->halfEdges[i] = { std::min(from, to), std::max(from, to), corner };
    });
  parallelSort(this->halfEdges);
}

// Vertices on borders that lie within this distance become the first of them.
void ContourMesh::closeSeams(double width)
{
  const std::vector<std::int32_t> vertices = this->borderVertices();
  std::vector<std::int32_t> names(this->positions.size());
  std::iota(names.begin(), names.end(), 0);
  bool found = false;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const glm::dvec3& place = this->positions[vertices[i]];
    const double last = seamOrder(place) + width;
    for (std::size_t k = i + 1; k < vertices.size() && names[vertices[i]] == vertices[i] &&
         seamOrder(this->positions[vertices[k]]) <= last;
         ++k)
    {
      if (glm::distance(this->positions[vertices[k]], place) <= width)
      {
        names[vertices[k]] = vertices[i];
        found = true;
      }
    }
  }
  if (found)
  {
    this->renameVertices(names);
  }
}

// In seamOrder.
std::vector<std::int32_t> ContourMesh::borderVertices() const
{
  std::vector<std::int32_t> vertices;
  this->eachEdge(
    [&vertices](Edge edge)
    {
      if (edge.size() == 1)
      {
        vertices.insert(vertices.end(), { edge[0].low, edge[0].high });
      }
    });
  std::sort(vertices.begin(), vertices.end(),
    [this](std::int32_t a, std::int32_t b)
    {
      const double first = seamOrder(this->positions[a]);
      const double second = seamOrder(this->positions[b]);
      return first != second ? first < second : a < b;
    });
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void ContourMesh::renameVertices(const std::vector<std::int32_t>& names)
{
  std::vector<glm::ivec3> kept;
  kept.reserve(this->triangles.size());
  for (const glm::ivec3& corners : this->triangles)
  {
    const glm::ivec3 renamed(names[corners.x], names[corners.y], names[corners.z]);
    if (renamed.x != renamed.y && renamed.y != renamed.z && renamed.z != renamed.x)
    {
      kept.push_back(renamed);
    }
  }
  this->triangles = std::move(kept);
  this->removeRepeated();
  this->addHalfEdges();
}

// From the first triangle of every piece on, neighbour by neighbour.
void ContourMesh::turnTriangles()
{
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> across(this->cornerCount(), none);
  this->eachEdge(
    [&across](Edge edge)
    {
      if (edge.size() == 2)
      {
        across[edge[0].corner] = edge[1].corner;
        across[edge[1].corner] = edge[0].corner;
      }
    });
  this->isTurned.assign(this->triangles.size(), 0);
  std::vector<char> isKnown(this->triangles.size(), 0);
  std::vector<std::int32_t> piece;
  for (std::int32_t first = 0; first < static_cast<std::int32_t>(isKnown.size()); ++first)
  {
    piece.assign(isKnown[first] ? 0 : 1, first);
    isKnown[first] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      for (std::int32_t corner = 3 * piece[i]; corner < 3 * piece[i] + 3; ++corner)
      {
        const std::int32_t other = across[corner];
        if (other != none && !isKnown[other / 3])
        {
          const bool sameWay = this->vertexOf(corner) == this->vertexOf(other);
          this->isTurned[other / 3] = sameWay != (this->isTurned[corner / 3] != 0) ? 1 : 0;
          isKnown[other / 3] = 1;
          piece.push_back(other / 3);
        }
      }
    }
  }
}

void ContourMesh::addFaceNormals()
{
  this->faceNormals.resize(this->triangles.size());
  parallelFor(static_cast<std::int64_t>(this->triangles.size()),
    [this](std::int64_t i)
    {
      const auto first = static_cast<std::int32_t>(3 * i);
      const glm::dvec3& a = this->placeOf(first);
      const glm::dvec3 normal =
        glm::cross(this->placeOf(first + 1) - a, this->placeOf(first + 2) - a);
      const double length = glm::length(normal) * (this->isTurned[i] ? -1.0 : 1.0);
      this->faceNormals[i] = length != 0.0 ? normal / length : glm::dvec3(0.0);
    });
}

double ContourMesh::angleAt(std::int32_t corner) const
{
  const std::int32_t next = nextCorner(corner);
  const glm::dvec3 a = this->placeOf(next) - this->placeOf(corner);
  const glm::dvec3 b = this->placeOf(nextCorner(next)) - this->placeOf(corner);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace hachure

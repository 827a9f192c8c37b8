// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleEdges.h"

#include "Parallel.h"
#include "StippleTreeBase.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

void checkFirstNeighbours(const StippleHierarchy& classic)
{
  const std::vector<std::uint32_t>& first = classic.firstNeighbour;
  const std::size_t expected = classic.points.empty() ? first.size() : classic.points.size() + 1;
  if (first.size() != expected)
  {
    throw std::invalid_argument("classic.firstNeighbour: " + std::to_string(first.size()) +
      ", expected " + std::to_string(expected));
  }
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const std::uint32_t before = i > 0 ? first[i - 1] : 0;
    if (first[i] < before || first[i] > classic.neighbours.size())
    {
      throw std::invalid_argument(
        "classic.firstNeighbour[" + std::to_string(i) + "]: " + std::to_string(first[i]));
    }
  }
}

void checkRanks(const char* name, Span<const std::int32_t> ranks, std::size_t count)
{
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    if (ranks[i] < 0 || static_cast<std::size_t>(ranks[i]) >= count)
    {
      throw std::invalid_argument(std::string(name).append("[") + std::to_string(i) +
        "]: " + std::to_string(ranks[i]) + " of " + std::to_string(count));
    }
  }
}

void checkClassic(const StippleHierarchy& classic, const StippleShape& shape)
{
  checkBase(classic, shape);
  checkFirstNeighbours(classic);
  checkRanks("classic.neighbours", classic.neighbours, classic.points.size());
  std::vector<std::int32_t> corners;
  corners.reserve(3 * classic.particleTriangles.size());
  for (const glm::ivec3& triangle : classic.particleTriangles)
  {
    corners.insert(corners.end(), { triangle.x, triangle.y, triangle.z });
  }
  checkRanks("classic.particleTriangles", corners, classic.points.size());
}

} // namespace

StippleEdges::StippleEdges(const TriangleMesh& reference, StippleHierarchy classic)
  : hierarchy(std::move(classic))
{
  checkTriangleMesh(reference);
  this->shape = StippleShape(reference);
  checkClassic(this->hierarchy, this->shape);
  this->edgeLengths = StippleEdgeLengths(reference, this->hierarchy);
  this->hierarchy.particleTriangles = {};
  this->place();
}

void StippleEdges::setPositions(Span<const glm::dvec3> points)
{
  if (points.size() != this->shape.pointCount())
  {
    throw std::invalid_argument("points: " + std::to_string(points.size()) + ", expected " +
      std::to_string(this->shape.pointCount()));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!std::isfinite(points[i].x + points[i].y + points[i].z))
    {
      throw std::invalid_argument("points[" + std::to_string(i) + "]: a coordinate is not finite");
    }
  }
  this->shape.move(points, {});
  this->place();
}

void StippleEdges::place()
{
  const std::size_t count = this->hierarchy.points.size();
  this->allPlaces.resize(count);
  this->allNormals.resize(count);
  this->ratios.resize(count);
  parallelFor(static_cast<std::int64_t>(count),
    [this](std::int64_t i)
    {
      const auto rank = static_cast<std::size_t>(i);
      const StipplePoint& point = this->hierarchy.points[rank];
      this->allPlaces[rank] = this->shape.presentPlace({ point.triangle,
        static_cast<double>(point.weights[0]), static_cast<double>(point.weights[1]) });
      this->allNormals[rank] = this->shape.presentNormal(point.triangle);
      this->ratios[rank] = static_cast<float>(this->shape.densityRatio(point.triangle));
    });
}

std::size_t StippleEdges::memory() const
{
  return this->shape.memory() + this->hierarchy.memory() +
    this->edgeLengths.groups().capacity() * sizeof(StippleEdgeLengths::Group) +
    this->allPlaces.capacity() * sizeof(glm::dvec3) +
    this->allNormals.capacity() * sizeof(glm::vec3) + this->ratios.capacity() * sizeof(float);
}

} // namespace hachure

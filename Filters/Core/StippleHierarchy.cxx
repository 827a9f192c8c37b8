// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleHierarchy.h"

#include "Parallel.h"
#include "StippleClassic.h"
#include "StippleProgressive.h"
#include "StippleSurface.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr std::int64_t mostPoints = std::int64_t{ 1 } << 27;

bool isFinite(const glm::dvec3& value)
{
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

void checkFinite(const char* name, Span<const glm::dvec3> values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!isFinite(values[i]))
    {
      throw std::invalid_argument(
        std::string(name).append("[") + std::to_string(i) + "]: a coordinate is not finite");
    }
  }
}

void checkPoints(Span<const glm::dvec3> points, Span<const glm::dvec3> normals)
{
  if (!normals.empty() && normals.size() != points.size())
  {
    throw std::invalid_argument("normals: " + std::to_string(normals.size()) + " for " +
      std::to_string(points.size()) + " points");
  }
  checkFinite("points", points);
  checkFinite("normals", normals);
}

std::vector<StipplePoint> inUnitsOfMesh(const std::vector<StippleCandidate>& found, double size)
{
  std::vector<StipplePoint> points(found.size());
  parallelFor(static_cast<std::int64_t>(found.size()),
    [&](std::int64_t i)
    {
      const StippleCandidate& from = found[static_cast<std::size_t>(i)];
      points[static_cast<std::size_t>(i)] = { from.triangle, { from.weights[0], from.weights[1] },
        static_cast<float>(size * from.crowding) };
    });
  return points;
}

} // namespace

void checkStippleOptions(const StippleOptions& options)
{
  if (options.count < 0 || options.count > mostPoints)
  {
    throw std::invalid_argument(
      "count: " + std::to_string(options.count) + ", expected 0 to " + std::to_string(mostPoints));
  }
  if (!(options.leastMove >= 0.0 && options.leastMove <= 0.5))
  {
    throw std::invalid_argument(
      "leastMove: " + std::to_string(options.leastMove) + ", expected 0 to 0.5");
  }
  if (!(options.mostMove >= options.leastMove && options.mostMove <= 0.5))
  {
    throw std::invalid_argument("mostMove: " + std::to_string(options.mostMove) +
      ", expected leastMove (" + std::to_string(options.leastMove) + ") to 0.5");
  }
}

std::size_t StippleHierarchy::memory() const
{
  return this->points.capacity() * sizeof(StipplePoint) +
    this->firstNeighbour.capacity() * sizeof(std::uint32_t) +
    this->neighbours.capacity() * sizeof(std::int32_t) +
    this->particleTriangles.capacity() * sizeof(glm::ivec3);
}

StippleHierarchy stippleSurface(const TriangleMesh& mesh, const StippleOptions& options)
{
  checkStippleOptions(options);
  checkTriangleMesh(mesh);
  const StippleSurface surface = makeStippleSurface(mesh);
  StippleHierarchy result;
  if (options.order == StippleOrder::Classic && options.count > 0 && !surface.triangles.empty())
  {
    result = classicStipples(surface, options);
  }
  result.size = surface.frame.size;
  result.area = surface.area() * surface.frame.size * surface.frame.size;
  if (options.order == StippleOrder::Classic || options.count == 0 || surface.triangles.empty())
  {
    return result;
  }
  StippleSurfaceSource source(surface, options.seed);
  result.points = inUnitsOfMesh(
    fillGaps(source, surface.area(), surface.borders, options.count, options.progress),
    surface.frame.size);
  return result;
}

StippleHierarchy stipplePoints(
  Span<const glm::dvec3> points, Span<const glm::dvec3> normals, const StippleOptions& options)
{
  checkStippleOptions(options);
  checkPoints(points, normals);
  if (options.order == StippleOrder::Classic)
  {
    throw std::invalid_argument("order: Classic, expected Progressive for points without a mesh");
  }
  const StippleFrame frame = stippleFrame(points);
  StippleHierarchy result;
  result.size = frame.size;
  if (options.count == 0 || points.empty())
  {
    return result;
  }
  if (frame.size == 0.0) // all in one place
  {
    result.points.push_back(StipplePoint());
    return result;
  }
  StipplePointSource source(points, normals, frame, options.seed);
  result.points =
    inUnitsOfMesh(fillGaps(source, 0.0, {}, options.count, options.progress), frame.size);
  return result;
}

glm::dvec3 stipplePosition(const TriangleMesh& mesh, const StipplePoint& point)
{
  const glm::ivec3 ids = mesh.triangles[static_cast<std::size_t>(point.triangle)];
  const glm::dvec3& first = mesh.points[static_cast<std::size_t>(ids.x)];
  return first +
    static_cast<double>(point.weights[0]) * (mesh.points[static_cast<std::size_t>(ids.y)] - first) +
    static_cast<double>(point.weights[1]) * (mesh.points[static_cast<std::size_t>(ids.z)] - first);
}

} // namespace hachure

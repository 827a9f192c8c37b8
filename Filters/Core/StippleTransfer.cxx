// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleTransfer.h"

#include "NoiseClosestPoint.h"
#include "Parallel.h"
#include "StippleProgressive.h"
#include "StippleSurface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

constexpr double farthestMove = 0.5; // of the spacing
constexpr std::int64_t moveGrain = 256;

bool isFinite(const glm::dvec3& value)
{
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

void checkOld(Span<const CarriedStipple> old, double oldArea)
{
  for (std::size_t i = 0; i < old.size(); ++i)
  {
    const std::string name = "old[" + std::to_string(i) + "]: ";
    if (!isFinite(old[i].place) || !isFinite(old[i].normal))
    {
      throw std::invalid_argument(name + "a coordinate is not finite");
    }
    if (!(old[i].spacing >= 0.0f && std::isfinite(old[i].spacing)))
    {
      throw std::invalid_argument(
        name + "spacing " + std::to_string(old[i].spacing) + ", expected 0 or more");
    }
  }
  if (!old.empty() && !(oldArea > 0.0 && std::isfinite(oldArea)))
  {
    throw std::invalid_argument("oldArea: " + std::to_string(oldArea) + ", expected above 0");
  }
}

// Where old points are on the new surface, in its frame.
class StippleMover
{
public:
  StippleMover(const StippleSurface& someSurface, double aReach)
    : surface(someSurface)
    , reach(aReach)
    , places(placesOf(someSurface))
    , tree(buildNoiseSurfaceTree({ this->places, someSurface.mesh.triangles, {} }, {}, 0))
    , closest(this->tree, this->places)
  {
  }

  std::vector<StippleCandidate> move(Span<const CarriedStipple> old) const
  {
    // Along the curve the last facet found is a good guess for the next.
    std::vector<std::pair<std::uint64_t, std::size_t>> order(old.size());
    parallelFor(static_cast<std::int64_t>(old.size()),
      [&](std::int64_t i)
      {
        const auto index = static_cast<std::size_t>(i);
        order[index] = { this->closest.placeOnCurve(this->surface.frame.place(old[index].place)),
          index };
      });
    std::sort(order.begin(), order.end());
    std::vector<StippleCandidate> moved(old.size());
    parallelForRanges(static_cast<std::int64_t>(old.size()), moveGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        std::int32_t guess = -1;
        for (std::int64_t i = begin; i < end; ++i)
        {
          const std::size_t index = order[static_cast<std::size_t>(i)].second;
          moved[index] = this->moveOne(old[index], guess);
        }
      });
    return moved;
  }

private:
  static std::vector<glm::dvec3> placesOf(const StippleSurface& surface)
  {
    std::vector<glm::dvec3> result(surface.mesh.points.size());
    parallelFor(static_cast<std::int64_t>(result.size()),
      [&](std::int64_t i)
      {
        const auto index = static_cast<std::size_t>(i);
        result[index] = surface.frame.place(surface.mesh.points[index]);
      });
    return result;
  }

  StippleCandidate moveOne(const CarriedStipple& old, std::int32_t& guess) const
  {
    StippleCandidate result;
    const double farthest = std::max(this->reach, farthestMove * static_cast<double>(old.spacing));
    const double length = glm::length(old.normal);
    const glm::dvec3 normal = length > 0.0 ? old.normal / length : glm::dvec3(0.0);
    const NoiseFoot foot = this->closest.find(
      this->surface.frame.place(old.place), normal, farthest / this->surface.frame.size, guess);
    result.triangle = -1;
    if (foot.facet >= 0)
    {
      guess = foot.facet;
      result.triangle = this->tree.facets[static_cast<std::size_t>(foot.facet)].index;
      result.weights[0] = static_cast<float>(foot.weights.x);
      result.weights[1] = std::min(static_cast<float>(foot.weights.y), 1.0f - result.weights[0]);
      result.place = glm::vec3(foot.position);
      const std::array<glm::dvec3, 3> corners = this->surface.corners(result.triangle);
      result.normal =
        glm::vec3(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
    }
    return result;
  }

  const StippleSurface& surface;
  double reach;
  std::vector<glm::dvec3> places;
  NoiseSurfaceTree tree;
  NoiseClosestPoint closest;
};

} // namespace

StippleHierarchy carryStipples(const TriangleMesh& mesh, Span<const CarriedStipple> old,
  double oldArea, const StippleOptions& options, std::vector<std::int32_t>& origins, double reach,
  std::vector<StipplePoint>* moved)
{
  checkStippleOptions(options);
  checkTriangleMesh(mesh);
  checkOld(old, oldArea);
  if (!(reach >= 0.0 && std::isfinite(reach)))
  {
    throw std::invalid_argument("reach: " + std::to_string(reach) + ", expected 0 or more");
  }
  if (options.order == StippleOrder::Classic)
  {
    throw std::invalid_argument("order: Classic, expected Progressive for stipples to be carried");
  }
  const StippleSurface surface = makeStippleSurface(mesh);
  StippleHierarchy result;
  origins.clear();
  if (moved)
  {
    moved->assign(old.size(), StipplePoint{ -1, { 0.0f, 0.0f }, 0.0f });
  }
  result.size = surface.frame.size;
  result.area = surface.area() * surface.frame.size * surface.frame.size;
  if (options.count == 0 || surface.triangles.empty())
  {
    return result;
  }
  CarriedCandidates carried;
  if (!old.empty())
  {
    carried.points = StippleMover(surface, reach).move(old);
    carried.growth = result.area / oldArea;
    for (std::size_t i = 0; moved && i < old.size(); ++i)
    {
      const StippleCandidate& on = carried.points[i];
      (*moved)[i] = { on.triangle, { on.weights[0], on.weights[1] }, old[i].spacing };
    }
  }
  StippleSurfaceSource source(surface, options.seed);
  const std::vector<StippleCandidate> found =
    fillGaps(source, surface.area(), surface.borders, options.count, options.progress, carried);
  result.points.reserve(found.size());
  origins.reserve(found.size());
  float spacing = static_cast<float>(surface.frame.size);
  for (const StippleCandidate& point : found)
  {
    const std::int32_t origin = carriedIndex(point);
    const StippleCandidate& on =
      origin < 0 ? point : carried.points[static_cast<std::size_t>(origin)];
    spacing = std::min(spacing, static_cast<float>(surface.frame.size * point.crowding));
    result.points.push_back({ on.triangle, { on.weights[0], on.weights[1] }, spacing });
    origins.push_back(origin);
  }
  return result;
}

std::vector<CarriedStipple> carriedStipples(
  const TriangleMesh& mesh, const StippleHierarchy& hierarchy)
{
  std::vector<CarriedStipple> result(hierarchy.points.size());
  parallelFor(static_cast<std::int64_t>(result.size()),
    [&](std::int64_t i)
    {
      const StipplePoint& point = hierarchy.points[static_cast<std::size_t>(i)];
      result[static_cast<std::size_t>(i)] = { stipplePosition(mesh, point),
        triangleAreaVector(mesh, point.triangle), point.spacing };
    });
  return result;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Blending over a distance: fast marching over triangles (Kimmel and Sethian 1998) from all borders
// at once, with one distance per vertex and patch that it is near to.

#include "PatchBlendWeights.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace hachure
{
namespace detail
{
namespace
{
/// Distance of a vertex to the border of a patch.
struct BorderDistance
{
  std::int32_t patch = 0;
  double distance = std::numeric_limits<double>::max();
  bool final = false;
};

struct Arrival
{
  double distance = 0.0;
  std::int32_t vertex = 0;
  std::int32_t patch = 0;

  bool operator<(const Arrival& other) const
  {
    return distance != other.distance ? distance > other.distance
      : vertex != other.vertex        ? vertex > other.vertex
                                      : patch > other.patch;
  }
};

/// The distance at c when it is u at a and v at b and linear between them: the least of
/// u + s (v - u) + |c - a - s (b - a)| for s from 0 to 1.
double distanceAcross(
  const glm::dvec3& a, double u, const glm::dvec3& b, double v, const glm::dvec3& c)
{
  const glm::dvec3 side = b - a;
  const double length = glm::length(side);
  double best = std::min(u + glm::length(c - a), v + glm::length(c - b));
  const double slope = length > 0.0 ? (v - u) / length : 1.0;
  if (std::abs(slope) < 1.0)
  {
    const double along = glm::dot(c - a, side) / length;
    const double height = glm::length(c - a - side * (along / length));
    const double s = (along - height * slope / std::sqrt(1.0 - slope * slope)) / length;
    if (s > 0.0 && s < 1.0)
    {
      best = std::min(best, u + s * (v - u) + glm::length(c - a - s * side));
    }
  }
  return best;
}

class BorderMarch
{
public:
  BorderMarch(const PatchBorders& someBorders, double someLimit)
    : borders(someBorders)
    , limit(someLimit)
    , slots(someBorders.patches.size(), -1)
    , pointOfVertex(someBorders.patches.size(), -1)
  {
    const FaceSurface& surface = borders.surface;
    for (std::size_t i = 0; i < surface.mesh.points.size(); ++i)
    {
      pointOfVertex[surface.vertices.empty() ? i : surface.vertices[i]] =
        static_cast<std::int32_t>(i);
    }
  }

  bool run(const ProgressFn& progress)
  {
    for (const std::int32_t vertex : borders.borders)
    {
      for (const std::int32_t triangle : borders.trianglesAt(vertex))
      {
        offer(vertex, borders.surface.mesh.patches[triangle], 0.0);
      }
    }
    const std::size_t arrivalsPerReport = 1 << 16;
    for (std::size_t count = 0; !queue.empty(); ++count)
    {
      if (progress && count % arrivalsPerReport == 0 && !progress(queue.top().distance / limit))
      {
        return false;
      }
      const Arrival next = queue.top();
      queue.pop();
      BorderDistance& known = distanceOf(next.vertex, next.patch);
      if (!known.final && known.distance == next.distance)
      {
        known.final = true;
        spread(next);
      }
    }
    return true;
  }

  template <class Body>
  void forEachVertex(Body&& body) const
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      body(vertices[i], distances[i]);
    }
  }

private:
  const glm::dvec3& position(std::int32_t vertex) const
  {
    return borders.surface.mesh.points[pointOfVertex[vertex]];
  }

  BorderDistance& distanceOf(std::int32_t vertex, std::int32_t patch)
  {
    if (slots[vertex] < 0)
    {
      slots[vertex] = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(vertex);
      distances.emplace_back();
    }
    std::vector<BorderDistance>& list = distances[slots[vertex]];
    const auto found = std::find_if(list.begin(), list.end(),
      [patch](const BorderDistance& known) { return known.patch == patch; });
    if (found != list.end())
    {
      return *found;
    }
    list.push_back({ patch });
    return list.back();
  }

  void offer(std::int32_t vertex, std::int32_t patch, double distance)
  {
    if (distance >= limit)
    {
      return;
    }
    BorderDistance& known = distanceOf(vertex, patch);
    if (!known.final && distance < known.distance)
    {
      known.distance = distance;
      queue.push({ distance, vertex, patch });
    }
  }

  /// A distance that is final, or the largest number.
  double finalDistance(std::int32_t vertex, std::int32_t patch) const
  {
    if (slots[vertex] >= 0)
    {
      for (const BorderDistance& known : distances[slots[vertex]])
      {
        if (known.patch == patch && known.final)
        {
          return known.distance;
        }
      }
    }
    return std::numeric_limits<double>::max();
  }

  void spread(const Arrival& from)
  {
    for (const std::int32_t triangle : borders.trianglesAt(from.vertex))
    {
      const glm::ivec3 corners = borders.surface.verticesOf(static_cast<std::size_t>(triangle));
      const int k = corners.x == from.vertex ? 0 : corners.y == from.vertex ? 1 : 2;
      reach(from, corners[(k + 1) % 3], corners[(k + 2) % 3]);
      reach(from, corners[(k + 2) % 3], corners[(k + 1) % 3]);
    }
  }

  void reach(const Arrival& from, std::int32_t target, std::int32_t third)
  {
    const glm::dvec3& a = position(from.vertex);
    const glm::dvec3& c = position(target);
    const double other = finalDistance(third, from.patch);
    offer(target, from.patch,
      other < std::numeric_limits<double>::max()
        ? distanceAcross(a, from.distance, position(third), other, c)
        : from.distance + glm::length(c - a));
  }

  const PatchBorders& borders;
  double limit;
  std::vector<std::int32_t> slots;                    // per vertex, -1 = none yet
  std::vector<std::int32_t> pointOfVertex;            // any of its points
  std::vector<std::int32_t> vertices;                 // per slot
  std::vector<std::vector<BorderDistance>> distances; // per slot
  std::priority_queue<Arrival> queue;
};
} // namespace

bool blendOverDistance(
  const PatchBorders& borders, const BlendOptions& options, VertexBlends& blends)
{
  BorderMarch march(borders, options.distance);
  if (!march.run(options.progress))
  {
    return false;
  }
  march.forEachVertex(
    [&](std::int32_t vertex, const std::vector<BorderDistance>& distances)
    {
      PatchWeights weights;
      bool hasOwn = false;
      for (const BorderDistance& border : distances)
      {
        // On a border the distance is 0, and inside or outside makes no difference.
        const bool isOwn = border.patch == borders.patches[vertex];
        hasOwn = hasOwn || isOwn;
        const double x = 0.5 + (isOwn ? 0.5 : -0.5) * border.distance / options.distance;
        weights.push_back({ border.patch, x * x * (3.0 - 2.0 * x) });
      }
      if (!hasOwn) // its border is too far away
      {
        weights.push_back({ borders.patches[vertex], 1.0 });
      }
      normalise(weights);
      blends.weights[blends.slotOf(vertex, borders)] = weights;
    });
  return true;
}
} // namespace detail
} // namespace hachure

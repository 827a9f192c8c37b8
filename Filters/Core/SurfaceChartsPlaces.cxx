// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsPlaces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

// The rims between two places on base triangles, by their corners on the side of the first one.
class RouteFinder
{
public:
  RouteFinder(const BaseMesh& aBase, std::int32_t aGoal, const glm::dvec3& someGoalWeights)
    : base(aBase)
    , goal(aGoal)
    , goalWeights(someGoalWeights)
  {
  }

  std::optional<glm::dvec3> find(std::int32_t start, const glm::dvec3& weights)
  {
    constexpr std::size_t mostForBetter = 4;
    constexpr std::size_t mostForAny = 8;
    for (this->mostRims = 1;
         this->leastMissed > slack && this->mostRims <= (this->found ? mostForBetter : mostForAny);
         ++this->mostRims)
    {
      this->route.clear();
      this->visit(start, weights);
    }
    return this->found;
  }

private:
  static constexpr double slack = 1e-6; // of a rim

  // All routes of so many rims.
  void visit(std::int32_t triangle, const glm::dvec3& weights)
  {
    if (triangle == this->goal)
    {
      this->judge(weights);
      return;
    }
    if (this->route.size() == this->mostRims)
    {
      return;
    }
    for (std::int32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
    {
      const std::int32_t other = this->base.mesh.opposite(corner);
      if (other >= 0 &&
        (this->route.empty() || corner != this->base.mesh.opposite(this->route.back())))
      {
        this->route.push_back(corner);
        this->visit(other / 3, weightsBeyond(this->base, weights, corner));
        this->route.pop_back();
      }
    }
  }

  // Keeps the route if the line misses its rims less than those of others do.
  void judge(const glm::dvec3& weights)
  {
    double missed = 0.0;
    glm::dvec3 one = weights; // of the start
    glm::dvec3 other = this->goalWeights;
    for (std::size_t i = this->route.size(); i-- > 0;)
    {
      const std::int32_t rim = this->base.mesh.opposite(this->route[i]);
      const int edge = rim % 3;
      const double height = other[edge] - one[edge];
      const glm::dvec3 crossing =
        height > 0.0 ? (other[edge] * one - one[edge] * other) / height : one;
      missed = std::max(missed, -std::min(crossing[(edge + 1) % 3], crossing[(edge + 2) % 3]));
      one = weightsBeyond(this->base, one, rim);
      other = weightsBeyond(this->base, other, rim);
    }
    if (missed < this->leastMissed)
    {
      this->leastMissed = missed;
      this->found = weights;
    }
  }

  const BaseMesh& base;
  std::int32_t goal;
  glm::dvec3 goalWeights;
  std::vector<std::int32_t> route;
  std::size_t mostRims = 0;
  double leastMissed = std::numeric_limits<double>::max();
  std::optional<glm::dvec3> found;
};

glm::dvec3 cornerWeights(int corner)
{
  glm::dvec3 weights(0.0);
  weights[corner] = 1.0;
  return weights;
}

// Which corner of a triangle a vertex is; -1: none.
int cornerOf(const CornerMesh& mesh, std::int32_t triangle, std::int32_t vertex)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    if (mesh.vertex(3 * triangle + corner) == vertex)
    {
      return corner;
    }
  }
  return -1;
}

class TrianglePlacer
{
public:
  explicit TrianglePlacer(const BaseMesh& aBase)
    : base(aBase)
  {
  }

  TrianglePlace place(const glm::ivec3& vertices) const
  {
    TrianglePlace best;
    double bestScore = 0.0;
    for (const std::int32_t triangle : this->candidates(vertices))
    {
      const TrianglePlace found = this->placeIn(triangle, vertices);
      const double score = scoreOf(found);
      if (best.triangle < 0 || score > bestScore)
      {
        best = found;
        bestScore = score;
      }
    }
    return best;
  }

private:
  // Base triangles in which a corner lies.
  std::vector<std::int32_t> candidates(const glm::ivec3& vertices) const
  {
    std::vector<std::int32_t> found;
    const auto add = [&](std::int32_t triangle)
    {
      if (std::find(found.begin(), found.end(), triangle) == found.end())
      {
        found.push_back(triangle);
      }
    };
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::int32_t home = this->base.homes[indexOf(vertices[corner])].triangle;
      if (home >= 0)
      {
        add(home);
      }
    }
    if (found.empty())
    {
      VertexRing ring;
      ring.find(this->base.mesh, vertices.x);
      for (const std::int32_t corner : ring.corners)
      {
        add(corner / 3);
      }
    }
    return found;
  }

  // Best where all of it is inside, worst where it is turned over or clamped.
  static double scoreOf(const TrianglePlace& place)
  {
    const auto& corners = place.corners;
    const glm::vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
    const glm::vec2 one = corners[1] - corners[0];
    const glm::vec2 other = corners[2] - corners[0];
    const double inside = std::min(std::min(middle.x, middle.y), 1.0f - middle.x - middle.y);
    const double turned = one.x * other.y - one.y * other.x > 0.0f ? 0.0 : -100.0;
    return inside + turned - (place.isClamped ? 1000.0 : 0.0);
  }

  TrianglePlace placeIn(std::int32_t triangle, const glm::ivec3& vertices) const
  {
    TrianglePlace found;
    found.triangle = triangle;
    const glm::dvec3 own = this->ownWeights(triangle, vertices);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::optional<glm::dvec3> weights =
        vertexWeightsIn(this->base, vertices[static_cast<int>(corner)], triangle, own);
      found.isClamped = found.isClamped || !weights;
      const glm::dvec3 place = weights.value_or(own);
      found.corners[corner] = glm::vec2(place.y, place.z);
    }
    return found;
  }

  // Of the first of three vertices that is in the base triangle.
  glm::dvec3 ownWeights(std::int32_t triangle, const glm::ivec3& vertices) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const VertexHome& home = this->base.homes[indexOf(vertices[corner])];
      if (home.triangle == triangle)
      {
        return { 1.0 - home.weights.x - home.weights.y, home.weights };
      }
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      const int own = cornerOf(this->base.mesh, triangle, vertices[corner]);
      if (own >= 0)
      {
        return cornerWeights(own);
      }
    }
    return glm::dvec3(1.0 / 3.0);
  }

  const BaseMesh& base;
};
} // namespace

glm::dvec3 weightsBeyond(const BaseMesh& base, const glm::dvec3& weights, std::int32_t corner)
{
  const int edge = corner % 3;
  const int other = base.mesh.opposite(corner) % 3;
  glm::dvec3 found;
  found[other] = -weights[edge];
  found[(other + 1) % 3] = weights[(edge + 2) % 3] + weights[edge];
  found[(other + 2) % 3] = weights[(edge + 1) % 3] + weights[edge];
  return found;
}

std::optional<glm::dvec3> weightsUnfolded(const BaseMesh& base, const glm::dvec3& weights,
  std::int32_t from, std::int32_t to, const glm::dvec3& seenFrom)
{
  return from == to ? weights : RouteFinder(base, to, seenFrom).find(from, weights);
}

std::optional<glm::dvec3> vertexWeightsIn(
  const BaseMesh& base, std::int32_t vertex, std::int32_t triangle, const glm::dvec3& seenFrom)
{
  const VertexHome& home = base.homes[indexOf(vertex)];
  if (home.triangle >= 0)
  {
    const glm::dvec3 weights(1.0 - home.weights.x - home.weights.y, home.weights);
    return weightsUnfolded(base, weights, home.triangle, triangle, seenFrom);
  }
  const int own = cornerOf(base.mesh, triangle, vertex);
  if (own >= 0)
  {
    return cornerWeights(own);
  }
  // It is a corner of all triangles around: the nearest one will do.
  VertexRing ring;
  ring.find(base.mesh, vertex);
  std::optional<glm::dvec3> nearest;
  double least = std::numeric_limits<double>::max();
  for (const std::int32_t corner : ring.corners)
  {
    const std::optional<glm::dvec3> found =
      weightsUnfolded(base, cornerWeights(corner % 3), corner / 3, triangle, seenFrom);
    if (found && glm::length(*found - seenFrom) < least)
    {
      nearest = found;
      least = glm::length(*found - seenFrom);
    }
  }
  return nearest;
}

TrianglePlace placeTriangle(const BaseMesh& base, const glm::ivec3& vertices)
{
  return vertices.x < 0 ? TrianglePlace() : TrianglePlacer(base).place(vertices);
}

} // namespace hachure

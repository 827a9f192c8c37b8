// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsPlaces.h"

#include <algorithm>
#include <vector>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

// A base triangle that was reached, and how.
struct Step
{
  std::int32_t triangle;
  std::int32_t corner; // of the triangle before, opposite to the rim; -1: the start
  std::size_t before;
};

// The rims on the way, by their corners on the side of the start, the last one first; empty: it is
// too far.
std::vector<std::int32_t> pathBetween(const CornerMesh& mesh, std::int32_t from, std::int32_t to)
{
  constexpr std::size_t mostSteps = 64; // about five rims away
  std::vector<Step> steps(1, { from, -1, 0 });
  for (std::size_t step = 0; step < steps.size() && steps.size() < mostSteps; ++step)
  {
    const std::int32_t first = 3 * steps[step].triangle;
    for (std::int32_t corner = first; corner < first + 3; ++corner)
    {
      const std::int32_t other = mesh.opposite(corner);
      if (other >= 0 && other / 3 == to)
      {
        std::vector<std::int32_t> path(1, corner);
        for (std::size_t at = step; steps[at].corner >= 0; at = steps[at].before)
        {
          path.push_back(steps[at].corner);
        }
        return path;
      }
      const bool isNew = other >= 0 &&
        std::none_of(steps.begin(), steps.end(),
          [&](const Step& known) { return known.triangle == other / 3; });
      if (isNew)
      {
        steps.push_back({ other / 3, corner, step });
      }
    }
  }
  return {};
}

// The corner of a triangle that another one is opposite to over its only common rim; -1: none.
std::int32_t cornerTowards(const CornerMesh& mesh, std::int32_t from, std::int32_t to)
{
  std::int32_t found = -1;
  for (std::int32_t corner = 3 * from; corner < 3 * from + 3; ++corner)
  {
    const std::int32_t other = mesh.opposite(corner);
    if (other >= 0 && other / 3 == to)
    {
      if (found >= 0)
      {
        return -1;
      }
      found = corner;
    }
  }
  return found;
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
    std::array<bool, 3> isKnown{};
    glm::vec2 known(1.0f / 3.0f);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::optional<glm::dvec3> weights =
        vertexWeightsIn(this->base, triangle, vertices[static_cast<int>(corner)]);
      isKnown[corner] = weights.has_value();
      if (weights)
      {
        found.corners[corner] = glm::vec2(weights->y, weights->z);
        known = found.corners[corner];
      }
    }
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      if (!isKnown[corner])
      {
        found.corners[corner] = known;
        found.isClamped = true;
      }
    }
    return found;
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

std::optional<glm::dvec3> weightsUnfolded(
  const BaseMesh& base, const glm::dvec3& weights, std::int32_t from, std::int32_t to)
{
  if (from == to)
  {
    return weights;
  }
  const std::int32_t towards = cornerTowards(base.mesh, from, to);
  if (towards >= 0)
  {
    return weightsBeyond(base, weights, towards);
  }
  std::vector<std::int32_t> path = pathBetween(base.mesh, std::min(from, to), std::max(from, to));
  if (path.empty())
  {
    return std::nullopt;
  }
  if (from > to)
  {
    std::transform(path.begin(), path.end(), path.begin(),
      [&](std::int32_t corner) { return base.mesh.opposite(corner); });
  }
  else
  {
    std::reverse(path.begin(), path.end());
  }
  glm::dvec3 found = weights;
  for (const std::int32_t corner : path)
  {
    found = weightsBeyond(base, found, corner);
  }
  return found;
}

std::optional<glm::dvec3> vertexWeightsIn(
  const BaseMesh& base, std::int32_t triangle, std::int32_t vertex)
{
  const VertexHome& home = base.homes[indexOf(vertex)];
  if (home.triangle >= 0)
  {
    return weightsUnfolded(base, glm::dvec3(1.0 - home.weights.x - home.weights.y, home.weights),
      home.triangle, triangle);
  }
  for (int corner = 0; corner < 3; ++corner)
  {
    if (base.mesh.vertex(3 * triangle + corner) == vertex)
    {
      glm::dvec3 weights(0.0);
      weights[corner] = 1.0;
      return weights;
    }
  }
  VertexRing ring;
  ring.find(base.mesh, vertex);
  for (const std::int32_t corner : ring.corners)
  {
    glm::dvec3 weights(0.0);
    weights[corner % 3] = 1.0;
    const std::optional<glm::dvec3> found = weightsUnfolded(base, weights, corner / 3, triangle);
    if (found)
    {
      return found;
    }
  }
  return std::nullopt;
}

TrianglePlace placeTriangle(const BaseMesh& base, const glm::ivec3& vertices)
{
  return vertices.x < 0 ? TrianglePlace() : TrianglePlacer(base).place(vertices);
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsPlaces.h"

#include "Kernels.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

glm::vec3 across(const glm::vec3& weights, std::int32_t corner, std::int32_t other)
{
  return glsl::weightsAcross(weights, corner % 3, other % 3, false);
}

// A base triangle that was reached, and how.
struct Step
{
  std::int32_t triangle;
  std::int32_t corner; // of the triangle before, opposite to the rim; -1: the start
  std::size_t before;
};

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
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto index = static_cast<std::size_t>(corner);
      const std::optional<glm::vec3> weights = this->weightsIn(triangle, vertices[corner]);
      isKnown[index] = weights.has_value();
      if (weights)
      {
        found.corners[index] = glm::vec2(weights->y, weights->z);
        known = found.corners[index];
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

  // Of a vertex, in the coordinates of a base triangle.
  std::optional<glm::vec3> weightsIn(std::int32_t triangle, std::int32_t vertex) const
  {
    const VertexHome& home = this->base.homes[indexOf(vertex)];
    if (home.triangle >= 0)
    {
      const glm::vec3 weights(glm::dvec3(1.0 - home.weights.x - home.weights.y, home.weights));
      return this->unfold(weights, home.triangle, triangle);
    }
    VertexRing ring;
    ring.find(this->base.mesh, vertex);
    const auto own = std::find_if(ring.corners.begin(), ring.corners.end(),
      [&](std::int32_t corner) { return corner / 3 == triangle; });
    for (auto corner = own != ring.corners.end() ? own : ring.corners.begin();
         corner != ring.corners.end(); ++corner)
    {
      glm::vec3 weights(0.0f);
      weights[*corner % 3] = 1.0f;
      const std::optional<glm::vec3> found = this->unfold(weights, *corner / 3, triangle);
      if (found)
      {
        return found;
      }
    }
    return std::nullopt;
  }

  std::optional<glm::vec3> unfold(glm::vec3 weights, std::int32_t from, std::int32_t to) const
  {
    if (from == to)
    {
      return weights;
    }
    std::vector<std::int32_t> path = this->pathBetween(std::min(from, to), std::max(from, to));
    if (path.empty())
    {
      return std::nullopt;
    }
    if (from > to)
    {
      std::transform(path.begin(), path.end(), path.begin(),
        [&](std::int32_t corner) { return this->base.mesh.opposite(corner); });
    }
    else
    {
      std::reverse(path.begin(), path.end());
    }
    for (const std::int32_t corner : path)
    {
      weights = across(weights, corner, this->base.mesh.opposite(corner));
    }
    return weights;
  }

  // The rims on the way, by their corners on the side of the start, the last one first; empty: it
  // is too far.
  std::vector<std::int32_t> pathBetween(std::int32_t from, std::int32_t to) const
  {
    constexpr std::size_t mostSteps = 64; // about five rims away
    std::vector<Step> steps(1, { from, -1, 0 });
    for (std::size_t step = 0; step < steps.size() && steps.size() < mostSteps; ++step)
    {
      for (std::int32_t corner = 3 * steps[step].triangle; corner < 3 * steps[step].triangle + 3;
           ++corner)
      {
        const std::int32_t other = this->base.mesh.opposite(corner);
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

  const BaseMesh& base;
};
} // namespace

TrianglePlace placeTriangle(const BaseMesh& base, const glm::ivec3& vertices)
{
  return vertices.x < 0 ? TrianglePlace() : TrianglePlacer(base).place(vertices);
}

} // namespace hachure

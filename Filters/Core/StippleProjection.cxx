// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleProjection.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

constexpr std::size_t leafSize = 4; // triangles

glm::dvec3 nearestOnSide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& place)
{
  const glm::dvec3 side = b - a;
  const double square = glm::dot(side, side);
  return square > 0.0 ? a + glm::clamp(glm::dot(place - a, side) / square, 0.0, 1.0) * side : a;
}

// Weights in the plane of the triangle, of any sign; NaN for one without area.
glm::dvec2 planeWeights(const StippleTree::Triangle& triangle, const glm::dvec3& place)
{
  const glm::dvec3 ab = triangle[1] - triangle[0];
  const glm::dvec3 ac = triangle[2] - triangle[0];
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double square = glm::dot(normal, normal);
  const glm::dvec3 offset = place - triangle[0];
  return glm::dvec2(
           glm::dot(glm::cross(offset, ac), normal), glm::dot(glm::cross(ab, offset), normal)) /
    square;
}

} // namespace

glm::dvec3 nearestOnTriangle(const StippleTree::Triangle& triangle, const glm::dvec3& place)
{
  const glm::dvec2 weights = planeWeights(triangle, place);
  if (weights.x >= 0.0 && weights.y >= 0.0 && weights.x + weights.y <= 1.0)
  {
    return triangle[0] + weights.x * (triangle[1] - triangle[0]) +
      weights.y * (triangle[2] - triangle[0]);
  }
  glm::dvec3 nearest = triangle[0];
  for (std::size_t side = 0; side < 3; ++side)
  {
    const glm::dvec3 other = nearestOnSide(triangle[side], triangle[(side + 1) % 3], place);
    if (glm::length(other - place) < glm::length(nearest - place))
    {
      nearest = other;
    }
  }
  return nearest;
}

glm::dvec2 stippleWeights(const StippleTree::Triangle& triangle, const glm::dvec3& place)
{
  const glm::dvec2 weights = glm::clamp(planeWeights(triangle, place), 0.0, 1.0);
  return { weights.x, std::min(weights.y, 1.0 - weights.x) };
}

StippleTree::StippleTree(std::vector<Triangle> someTriangles)
  : triangles(std::move(someTriangles))
{
  while (this->leafCount * leafSize < this->triangles.size())
  {
    this->leafCount *= 2;
  }
  this->makeBoxes();
}

void StippleTree::makeBoxes()
{
  this->boxes.resize(2 * this->leafCount - 1);
  parallelFor(static_cast<std::int64_t>(this->leafCount),
    [this](std::int64_t leaf)
    {
      const std::size_t first = static_cast<std::size_t>(leaf) * leafSize;
      Box& box = this->boxes[this->leafCount - 1 + static_cast<std::size_t>(leaf)];
      for (std::size_t i = first; i < std::min(first + leafSize, this->triangles.size()); ++i)
      {
        for (const glm::dvec3& corner : this->triangles[i])
        {
          box.low = glm::min(box.low, corner);
          box.high = glm::max(box.high, corner);
        }
      }
    });
  for (std::size_t node = this->leafCount - 1; node-- > 0;)
  {
    const Box& left = this->boxes[2 * node + 1];
    const Box& right = this->boxes[2 * node + 2];
    this->boxes[node] = { glm::min(left.low, right.low), glm::max(left.high, right.high) };
  }
}

double StippleTree::squareTo(const Box& box, const glm::dvec3& place) const
{
  const glm::dvec3 offset = glm::max(glm::max(box.low - place, place - box.high), 0.0);
  return glm::dot(offset, offset);
}

// Calls visit(triangle) in all leaves that, with all above them, enters(box) is true for; enters
// gives a number, and the child of the smaller one comes first; below 0: not entered.
template <class Enters, class Visit>
void StippleTree::descend(Enters&& enters, Visit&& visit) const
{
  std::array<std::size_t, 128> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0)
  {
    const std::size_t node = stack[--depth];
    if (enters(this->boxes[node]) < 0.0)
    {
      continue;
    }
    if (node >= this->leafCount - 1)
    {
      const std::size_t first = (node - (this->leafCount - 1)) * leafSize;
      for (std::size_t i = first; i < std::min(first + leafSize, this->triangles.size()); ++i)
      {
        visit(static_cast<std::int32_t>(i));
      }
      continue;
    }
    const double left = enters(this->boxes[2 * node + 1]);
    const double right = enters(this->boxes[2 * node + 2]);
    const std::size_t isRightFirst = right >= 0.0 && (left < 0.0 || right < left) ? 1 : 0;
    stack[depth++] = 2 * node + 2 - isRightFirst;
    stack[depth++] = 2 * node + 1 + isRightFirst;
  }
}

StippleSpot StippleTree::nearest(const glm::dvec3& place, const StippleSpot& known) const
{
  StippleSpot best = known;
  this->descend(
    [&](const Box& box)
    {
      const double square = this->squareTo(box, place);
      return square < best.distance * best.distance ? square : -1.0;
    },
    [&](std::int32_t item)
    {
      const glm::dvec3 other = nearestOnTriangle(this->triangle(item), place);
      const double distance = glm::length(other - place);
      if (distance < best.distance)
      {
        best = { item, other, distance };
      }
    });
  return best;
}

StippleSpot StippleTree::alongLine(
  const glm::dvec3& place, const glm::dvec3& unitDirection, double reach) const
{
  StippleSpot best;
  best.distance = reach;
  const glm::dvec3 inverse = 1.0 / unitDirection;
  this->descend(
    [&](const Box& box)
    {
      const glm::dvec3 a = (box.low - place) * inverse;
      const glm::dvec3 b = (box.high - place) * inverse;
      double enter = -best.distance;
      double leave = best.distance;
      for (int axis = 0; axis < 3; ++axis)
      {
        // A line in the plane of a side gives NaN, which these comparisons let pass.
        enter = std::max(enter, std::min(a[axis], b[axis]));
        leave = std::min(leave, std::max(a[axis], b[axis]));
      }
      constexpr double rounding = 1e-12; // flat boxes
      return leave + rounding < enter ? -1.0 : std::max({ 0.0, enter, -leave });
    },
    [&](std::int32_t item)
    {
      const Triangle& triangle = this->triangle(item);
      const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
      const double across = glm::dot(normal, unitDirection);
      const double along = glm::dot(triangle[0] - place, normal) / across;
      if (!(std::abs(along) < best.distance))
      {
        return;
      }
      const glm::dvec3 hit = place + along * unitDirection;
      const glm::dvec2 weights = planeWeights(triangle, hit);
      if (weights.x >= 0.0 && weights.y >= 0.0 && weights.x + weights.y <= 1.0)
      {
        best = { item, hit, std::abs(along) };
      }
    });
  return best;
}

} // namespace hachure

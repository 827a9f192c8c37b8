// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendPoints.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
bool isFinite(const glm::dvec3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

// Of unit length, also where the square of the length is no number; 0 of 0.
glm::dvec3 unitOf(const glm::dvec3& vector)
{
  const double size = std::max({ std::abs(vector.x), std::abs(vector.y), std::abs(vector.z) });
  return size > 0.0 ? glm::normalize(vector / size) : glm::dvec3(0.0);
}

void check(const BlendPoint& point, std::size_t number)
{
  const std::string name = "points[" + std::to_string(number) + "]";
  if (!isFinite(point.position) || !isFinite(point.direction))
  {
    throw std::invalid_argument(name + " has a position or direction that is not finite");
  }
  if (point.direction == glm::dvec3(0.0))
  {
    throw std::invalid_argument(name + ".direction is 0; expected a direction");
  }
  if (!(point.share >= 0.0 && point.share <= 1.0))
  {
    throw std::invalid_argument(
      name + ".share is " + std::to_string(point.share) + "; expected 0 to 1");
  }
}

// The mean over all points of the smallest value of a function of two of them.
template <class Function>
double meanOfSmallest(const std::vector<BlendPoint>& points, Function&& value)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      if (j != i)
      {
        smallest = std::min(smallest, value(points[i], points[j]));
      }
    }
    sum += smallest / static_cast<double>(points.size());
  }
  return sum;
}
} // namespace

BlendFunction::BlendFunction(Span<const BlendPoint> given, const glm::dvec3& centre)
  : points(given.begin(), given.end())
{
  for (std::size_t i = 0; i < this->points.size(); ++i)
  {
    check(this->points[i], i);
    this->points[i].direction = unitOf(this->points[i].direction);
  }
  if (!isFinite(centre))
  {
    throw std::invalid_argument("centre is not finite");
  }
  if (this->points.empty())
  {
    return;
  }
  constexpr double same = 1e-9; // of cosines
  this->leastCosine = meanOfSmallest(this->points,
    [](const BlendPoint& a, const BlendPoint& b) { return glm::dot(a.direction, b.direction); });
  if (!(this->leastCosine < 1.0 - same)) // also of one point, whose mean is infinite
  {
    this->leastCosine = 0.0;
  }
  this->leastCosine = std::max(this->leastCosine, -1.0);
  this->mostDistance = meanOfSmallest(this->points,
    [](const BlendPoint& a, const BlendPoint& b) { return glm::distance(a.position, b.position); });
  if (!std::isfinite(this->mostDistance) || !(this->mostDistance > 0.0))
  {
    this->mostDistance = 0.0;
    for (const BlendPoint& point : this->points)
    {
      this->mostDistance +=
        glm::distance(point.position, centre) / static_cast<double>(this->points.size());
    }
  }
  if (!(this->mostDistance > 0.0))
  {
    this->mostDistance = std::numeric_limits<double>::infinity();
  }
}

double BlendFunction::at(const glm::dvec3& position, const glm::dvec3& direction) const
{
  const glm::dvec3 along = unitOf(direction);
  double sum = 0.0;
  double weights = 0.0;
  for (const BlendPoint& point : this->points)
  {
    const double cosine = along == glm::dvec3(0.0) ? -1.0 : glm::dot(along, point.direction);
    const double near =
      std::max(0.0, 1.0 - glm::distance(position, point.position) / this->mostDistance);
    const double alike = std::max(0.0, (cosine - this->leastCosine) / (1.0 - this->leastCosine));
    sum += alike * near * point.share;
    weights += alike * near;
  }
  return weights > 0.0 ? std::clamp(sum / weights, 0.0, 1.0) : 0.0;
}

} // namespace hachure

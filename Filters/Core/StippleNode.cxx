// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleNode.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

std::uint32_t inUnits(double weight, double most)
{
  const double units = std::floor(std::clamp(weight / StipplePlace::weightUnit, 0.0, most));
  return static_cast<std::uint32_t>(units);
}

// Of a cone around all cones.
float coneCosine(Span<const StippleBounds> parts, const glm::vec3& axis)
{
  double widest = 0.0;
  for (const StippleBounds& part : parts)
  {
    if (!part.isEmpty())
    {
      const auto between = static_cast<double>(glm::clamp(glm::dot(axis, part.axis), -1.0f, 1.0f));
      widest = std::max(widest, std::acos(between) + std::acos(static_cast<double>(part.cosine)));
    }
  }
  const double halfTurn = std::acos(-1.0);
  constexpr float rounding = 1e-6f;
  return widest < halfTurn ? std::max(-1.0f, static_cast<float>(std::cos(widest)) - rounding)
                           : -1.0f;
}

} // namespace

StippleBounds StippleBounds::around(Span<const StippleBounds> parts)
{
  StippleBounds result;
  glm::vec3 sum(0.0f);
  for (const StippleBounds& part : parts)
  {
    if (!part.isEmpty())
    {
      result.low = result.isEmpty() ? part.low : glm::min(result.low, part.low);
      result.high = result.isEmpty() ? part.high : glm::max(result.high, part.high);
      result.radius = 0.0; // not empty
      sum += part.axis;
    }
  }
  if (result.isEmpty())
  {
    return result;
  }
  double fromSpheres = 0.0;
  for (const StippleBounds& part : parts)
  {
    if (!part.isEmpty())
    {
      fromSpheres =
        std::max(fromSpheres, glm::length(part.middle() - result.middle()) + part.radius);
    }
  }
  result.radius = std::min(fromSpheres, 0.5 * glm::length(result.high - result.low));
  const float length = glm::length(sum);
  if (length > 0.0f)
  {
    result.axis = sum / length;
    result.cosine = coneCosine(parts, result.axis);
  }
  return result;
}

StipplePlace::StipplePlace(std::int32_t aTriangle, double second, double third)
  : triangle(aTriangle)
{
  constexpr double most = 4294967295.0;
  this->weights[0] = inUnits(second, most);
  this->weights[1] = inUnits(third, most - static_cast<double>(this->weights[0]));
}

std::size_t StippleNode::memory() const
{
  return sizeof(*this) + this->places.capacity() * sizeof(StipplePlace) +
    this->referenceDensities.capacity() * sizeof(float) +
    this->ranks.capacity() * sizeof(std::uint32_t) + this->lanes.capacity() * sizeof(float);
}

} // namespace hachure

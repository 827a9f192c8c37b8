// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StipplePolygon.h"

#include <glm/common.hpp>

namespace hachure
{

glm::dvec3 StipplePolygon::low() const
{
  glm::dvec3 result = this->corners[0].place;
  for (int i = 1; i < this->count; ++i)
  {
    result = glm::min(result, this->corner(i).place);
  }
  return result;
}

glm::dvec3 StipplePolygon::high() const
{
  glm::dvec3 result = this->corners[0].place;
  for (int i = 1; i < this->count; ++i)
  {
    result = glm::max(result, this->corner(i).place);
  }
  return result;
}

// Keeps what is above the bound (sign 1) or below it (-1): Sutherland and Hodgman 1974.
void StipplePolygon::clip(int axis, double bound, double sign)
{
  const auto depth = [&](const Corner& corner) { return sign * (corner.place[axis] - bound); };
  std::array<Corner, 9> kept;
  std::size_t keptCount = 0;
  for (int i = 0; i < this->count; ++i)
  {
    const Corner& from = this->corner(i);
    const Corner& to = this->corner((i + 1) % this->count);
    const double before = depth(from);
    const double after = depth(to);
    if (before >= 0.0 && keptCount < kept.size())
    {
      kept[keptCount++] = from;
    }
    if ((before < 0.0) != (after < 0.0) && before != 0.0 && after != 0.0 && keptCount < kept.size())
    {
      const double share = before / (before - after);
      Corner cut = { from.place + share * (to.place - from.place),
        from.weights + share * (to.weights - from.weights) };
      cut.place[axis] = bound;
      kept[keptCount++] = cut;
    }
  }
  this->corners = kept;
  this->count = static_cast<int>(keptCount);
}

bool StipplePolygon::hasArea() const
{
  double twice = 0.0;
  for (int i = 1; i + 1 < this->count; ++i)
  {
    const glm::dvec2 a = this->corner(i).weights - this->corners[0].weights;
    const glm::dvec2 b = this->corner(i + 1).weights - this->corners[0].weights;
    twice += a.x * b.y - a.y * b.x;
  }
  return twice > 0.0;
}

void StipplePolygon::clip(const glm::dvec3& boxLow, const glm::dvec3& boxHigh)
{
  for (int axis = 0; axis < 3 && this->count >= 3; ++axis)
  {
    this->clip(axis, boxLow[axis], 1.0);
    if (this->count >= 3)
    {
      this->clip(axis, boxHigh[axis], -1.0);
    }
  }
  if (this->count >= 3)
  {
    const glm::dvec3 least = this->low();
    const bool isWithin = least.x < boxHigh.x && least.y < boxHigh.y && least.z < boxHigh.z;
    this->count = isWithin && this->hasArea() ? this->count : 0;
  }
}

} // namespace hachure

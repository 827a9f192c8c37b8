// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HemisphereTable.h"

#include "Kernels.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

HemisphereTable::HemisphereTable(HemisphereMap ofMap, int ofSide)
  : map(ofMap)
  , side(ofSide)
{
  this->localDirections.reserve(
    static_cast<std::size_t>(ofSide) * static_cast<std::size_t>(ofSide));
  for (int row = 0; row < ofSide; ++row)
  {
    for (int column = 0; column < ofSide; ++column)
    {
      const glm::vec2 square = (glm::vec2(column, row) + 0.5f) / static_cast<float>(ofSide);
      this->localDirections.push_back(ofMap == HemisphereMap::Octahedral
          ? glsl::hemisphereDirection(square)
          : glsl::hemisphereDiskDirection(square));
    }
  }
}

glm::vec2 HemisphereTable::squareOf(const glm::vec3& direction) const
{
  return this->map == HemisphereMap::Octahedral ? glsl::hemisphereSquare(direction)
                                                : glsl::hemisphereDisk(direction);
}

void HemisphereTable::directionsIn(const glm::quat& turn, Span<glm::vec3> found) const
{
  const glm::mat3 matrix = glm::mat3_cast(turn);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    found[i] = matrix * this->localDirections[i];
  }
}

void HemisphereTable::findTaps(const glm::quat& turn, const glm::quat& sourceTurn, Taps& taps) const
{
  constexpr float sameCosine = 1.0f - 1e-6f; // of half the angle: 0.16 degrees
  const glm::quat between = glm::conjugate(sourceTurn) * turn;
  taps.isSame = std::abs(between.w) > sameCosine;
  if (taps.isSame)
  {
    return;
  }
  const glm::mat3 matrix = glm::mat3_cast(between);
  const auto size = static_cast<float>(this->side);
  taps.taps.resize(this->size());
  for (std::size_t i = 0; i < taps.taps.size(); ++i)
  {
    const glm::vec2 place = size * this->squareOf(matrix * this->localDirections[i]) - 0.5f;
    const float x = std::clamp(place.x, 0.0f, size - 1.0f);
    const float y = std::clamp(place.y, 0.0f, size - 1.0f);
    const int column = std::min(static_cast<int>(x), this->side - 2);
    const int row = std::min(static_cast<int>(y), this->side - 2);
    taps.taps[i].first = static_cast<std::uint16_t>(row * this->side + column);
    taps.taps[i].share = glm::vec2(x - static_cast<float>(column), y - static_cast<float>(row));
  }
}

void HemisphereTable::add(
  const Taps& taps, float weight, const glm::vec4* source, glm::vec4* sums) const
{
  if (taps.isSame)
  {
    for (std::size_t i = 0; i < this->size(); ++i)
    {
      sums[i] += weight * source[i];
    }
    return;
  }
  for (std::size_t i = 0; i < this->size(); ++i)
  {
    const Taps::Tap& tap = taps.taps[i];
    const glm::vec4* from = source + tap.first;
    const float up = weight * tap.share.y;
    const float down = weight - up;
    const float right = tap.share.x;
    sums[i] += down * (1.0f - right) * from[0] + down * right * from[1] +
      up * (1.0f - right) * from[this->side] + up * right * from[this->side + 1];
  }
}

void HemisphereTable::join(const Taps& taps, const std::uint8_t* source, std::uint8_t* flags) const
{
  for (std::size_t i = 0; i < this->size(); ++i)
  {
    std::size_t nearest = i;
    if (!taps.isSame)
    {
      const Taps::Tap& tap = taps.taps[i];
      nearest = tap.first + (tap.share.x > 0.5f ? 1u : 0u) +
        (tap.share.y > 0.5f ? static_cast<std::size_t>(this->side) : 0u);
    }
    flags[i] = static_cast<std::uint8_t>(flags[i] | source[nearest]);
  }
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SrgbColor.h"

#include "Kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hachure
{
namespace
{
constexpr float whole = 255.0f;

std::array<float, 256> makeLinear()
{
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    table[i] = glsl::decodedSrgb(glm::vec3(static_cast<float>(i) / whole)).r;
  }
  return table;
}

constexpr int srgbSteps = 1 << 14; // four for the smallest byte, where the curve is steepest

std::vector<std::uint8_t> makeSrgb()
{
  std::vector<std::uint8_t> table(srgbSteps + 1);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const float value = static_cast<float>(i) / static_cast<float>(srgbSteps);
    table[i] =
      static_cast<std::uint8_t>(std::lround(whole * glsl::encodedSrgb(glm::vec3(value)).r));
  }
  return table;
}
} // namespace

glm::vec3 linearColorOf(const glm::u8vec4& color)
{
  static const std::array<float, 256> table = makeLinear();
  return { table[color.r], table[color.g], table[color.b] };
}

glm::vec4 linearOf(const glm::u8vec4& color)
{
  const float alpha = static_cast<float>(color.a) / whole;
  return { alpha * linearColorOf(color), alpha };
}

std::uint8_t srgbByteOf(float linear)
{
  static const std::vector<std::uint8_t> table = makeSrgb();
  const float place = std::clamp(linear, 0.0f, 1.0f) * static_cast<float>(srgbSteps) + 0.5f;
  return table[static_cast<std::size_t>(place)];
}

std::uint8_t byteOf(float share)
{
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * whole));
}

} // namespace hachure

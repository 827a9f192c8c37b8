// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureColors.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace hachure
{
namespace
{
constexpr float whole = 255.0f;

// Of sRGB bytes, and the other way in steps that are finer than bytes.
struct SrgbTables
{
  static constexpr int steps = 1 << 14;
  std::array<float, 256> linear{};
  std::array<std::uint8_t, steps + 1> bytes{};

  SrgbTables()
  {
    for (std::size_t i = 0; i < this->linear.size(); ++i)
    {
      const double value = static_cast<double>(i) / 255.0;
      this->linear[i] = static_cast<float>(
        value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
    }
    for (std::size_t i = 0; i < this->bytes.size(); ++i)
    {
      const double value = static_cast<double>(i) / steps;
      const double encoded =
        value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
      this->bytes[i] = static_cast<std::uint8_t>(std::lround(255.0 * encoded));
    }
  }

  glm::vec3 decoded(const glm::u8vec4& color) const
  {
    return { this->linear[color.r], this->linear[color.g], this->linear[color.b] };
  }
  std::uint8_t encoded(float value) const
  {
    return this->bytes[static_cast<std::size_t>(
      glm::clamp(value, 0.0f, 1.0f) * static_cast<float>(steps) + 0.5f)];
  }
  glm::u8vec4 encoded(const glm::vec3& color) const
  {
    return { this->encoded(color.r), this->encoded(color.g), this->encoded(color.b),
      static_cast<std::uint8_t>(whole) };
  }
};

const SrgbTables& srgbTables()
{
  static const SrgbTables tables;
  return tables;
}
} // namespace

void paintUnknown(ViewTextureColors& colors)
{
  const SrgbTables& tables = srgbTables();
  constexpr glm::u8vec4 grey(128, 128, 128, 255);
  parallelFor(static_cast<std::int64_t>(colors.independent.size()),
    [&](std::int64_t node)
    {
      glm::u8vec4& color = colors.independent[static_cast<std::size_t>(node)];
      if (color.a < 255)
      {
        const float known = static_cast<float>(color.a) / whole;
        color = tables.encoded(glm::mix(tables.decoded(grey), tables.decoded(color), known));
      }
    });
}

void paintBelow(ViewTextureColors& colors)
{
  const SrgbTables& tables = srgbTables();
  const std::size_t squares =
    static_cast<std::size_t>(colors.hemisphere) * static_cast<std::size_t>(colors.hemisphere);
  parallelFor(static_cast<std::int64_t>(colors.independent.size()),
    [&](std::int64_t number)
    {
      const auto node = static_cast<std::size_t>(number);
      const glm::u8vec4 base = colors.independent[node];
      const glm::vec3 below = tables.decoded(base);
      for (std::size_t i = squares * node; i < squares * (node + 1); ++i)
      {
        glm::u8vec4& color = colors.dependent[i];
        const float share = static_cast<float>(color.a) / whole;
        color =
          color.a == 0 ? base : tables.encoded(tables.decoded(color) + (1.0f - share) * below);
      }
    });
  colors.independent.clear();
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureColors.h"

#include "Parallel.h"
#include "SrgbColor.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure
{
namespace
{
constexpr float whole = 255.0f;
} // namespace

void paintUnknown(ViewTextureColors& colors)
{
  constexpr glm::u8vec4 grey(128, 128, 128, 255);
  parallelFor(static_cast<std::int64_t>(colors.independent.size()),
    [&](std::int64_t node)
    {
      glm::u8vec4& color = colors.independent[static_cast<std::size_t>(node)];
      if (color.a < 255)
      {
        const float known = static_cast<float>(color.a) / whole;
        color = srgbOf({ glm::mix(linearColorOf(grey), linearColorOf(color), known), 1.0f });
      }
    });
}

void paintBelow(ViewTextureColors& colors)
{
  const std::size_t squares =
    static_cast<std::size_t>(colors.hemisphere) * static_cast<std::size_t>(colors.hemisphere);
  parallelFor(static_cast<std::int64_t>(colors.independent.size()),
    [&](std::int64_t number)
    {
      const auto node = static_cast<std::size_t>(number);
      const glm::u8vec4 base = colors.independent[node];
      const glm::vec3 below = linearColorOf(base);
      for (std::size_t i = squares * node; i < squares * (node + 1); ++i)
      {
        glm::u8vec4& color = colors.dependent[i];
        const float left = 1.0f - static_cast<float>(color.a) / whole;
        color = color.a == 0 ? base : srgbOf({ linearColorOf(color) + left * below, 1.0f });
      }
    });
  colors.independent.clear();
}

} // namespace hachure

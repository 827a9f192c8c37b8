// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SrgbColor_h
#define hachure_SrgbColor_h

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

// Bytes of sRGB (IEC 61966-2-1), and linear light from 0 to 1. By tables: as fast as a look-up.
namespace hachure
{

// Without regard to alpha.
glm::vec3 linearColorOf(const glm::u8vec4& color);
// Of straight alpha: linear light times alpha, and alpha.
glm::vec4 linearOf(const glm::u8vec4& color);

// Values are clamped.
std::uint8_t srgbByteOf(float linear);
std::uint8_t byteOf(float share);

inline glm::u8vec4 srgbOf(const glm::vec4& linear)
{
  return { srgbByteOf(linear.r), srgbByteOf(linear.g), srgbByteOf(linear.b), byteOf(linear.a) };
}

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TileNoise_h
#define hachure_TileNoise_h

// Smooth noise for tiles.

#include "Random.h"

#include <cmath>
#include <cstdint>

namespace hachure
{

inline double smoothRamp(double low, double high, double x)
{
  const double t = x <= low ? 0.0 : x >= high ? 1.0 : (x - low) / (high - low);
  return t * t * (3.0 - 2.0 * t);
}

// Smooth noise in [-1, 1] that repeats after `periods` cells in both directions.
inline double cellNoise(
  double x, double y, int periods, std::uint32_t seed, std::uint32_t dimension)
{
  const int cellX = static_cast<int>(std::floor(x));
  const int cellY = static_cast<int>(std::floor(y));
  const double fx = x - cellX;
  const double fy = y - cellY;
  const double sx = fx * fx * (3.0 - 2.0 * fx);
  const double sy = fy * fy * (3.0 - 2.0 * fy);
  const auto corner = [&](int i, int j)
  {
    const std::uint64_t column = static_cast<std::uint64_t>((cellX + i + periods) % periods);
    const std::uint64_t row = static_cast<std::uint64_t>((cellY + j + periods) % periods);
    return 2.0 * unitRandom(seed, row * static_cast<std::uint64_t>(periods) + column, dimension) -
      1.0;
  };
  const double low = corner(0, 0) * (1.0 - sx) + corner(1, 0) * sx;
  const double high = corner(0, 1) * (1.0 - sx) + corner(1, 1) * sx;
  return low * (1.0 - sy) + high * sy;
}

// Smooth noise in [-1, 1] along a line, without a period.
inline double lineNoise(double x, std::uint32_t seed, std::uint32_t dimension)
{
  const double cell = std::floor(x);
  const auto at = [&](double place)
  {
    const auto id = static_cast<std::uint64_t>(static_cast<std::int64_t>(place));
    return 2.0 * unitRandom(seed, id, dimension) - 1.0;
  };
  const double low = at(cell);
  return low + (at(cell + 1.0) - low) * smoothRamp(0.0, 1.0, x - cell);
}

} // namespace hachure

#endif

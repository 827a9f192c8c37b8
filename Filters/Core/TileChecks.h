// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TileChecks_h
#define hachure_TileChecks_h

// Argument checks shared by the makers of tiles and tone tables.

#include "PatternTile.h"

#include <stdexcept>
#include <string>

namespace hachure
{

constexpr double pi = 3.14159265358979323846;

namespace check
{

[[noreturn]] inline void fail(
  const std::string& function, const std::string& argument, const std::string& what)
{
  throw std::invalid_argument(function + ": " + argument + ": " + what);
}

// Refuses NaN as well.
inline void inRange(
  const std::string& function, const std::string& argument, double value, double low, double high)
{
  if (!(value >= low && value <= high))
  {
    fail(function, argument,
      std::to_string(value) + " is outside " + std::to_string(low) + " to " + std::to_string(high));
  }
}

inline void atLeast(const std::string& function, const std::string& argument, int value, int low)
{
  if (value < low)
  {
    fail(function, argument, std::to_string(value) + ", expected at least " + std::to_string(low));
  }
}

inline void hatchOptions(const std::string& function, const HatchOptions& options)
{
  inRange(function, "size", options.size, 8, 4096);
  // A period narrower than four texels has no edge left to draw.
  const int most = options.size / 4;
  inRange(function, "periods", options.periods, 1, most);
  inRange(function, "irregularity", options.irregularity, 0.0, 1.0);
}

inline void densities(const std::string& function, const HatchOptions& options)
{
  inRange(function, "densities", options.densities, 1, 4);
  const int lines = options.periods << (options.densities - 1);
  if (lines > options.size / 4)
  {
    fail(function, "densities",
      std::to_string(options.densities) + " make " + std::to_string(lines) + " lines of " +
        std::to_string(options.periods) +
        " periods, expected at most size / 4 = " + std::to_string(options.size / 4));
  }
}

inline void tile(const std::string& function, const PatternTile& tile)
{
  const std::size_t texels =
    static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
  if (tile.width < 1 || tile.height < 1 || tile.screen.size() != texels ||
    tile.gradient.size() != texels)
  {
    fail(function, "tile",
      std::to_string(tile.width) + " x " + std::to_string(tile.height) + " with " +
        std::to_string(tile.screen.size()) + " screen and " + std::to_string(tile.gradient.size()) +
        " gradient values");
  }
}

} // namespace check
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the parts of a legend lie, in whole logical pixels from the lower left corner of its box.
 */
#ifndef hachure_PatternLegendLayout_h
#define hachure_PatternLegendLayout_h

#include <array>
#include <vector>

namespace hachure
{

struct LegendLayoutOptions
{
  std::array<int, 2> size = { 0, 0 }; // of the box
  bool vertical = true;
  int thickness = 32; // of the swatches, across their row
  int swatches = 1;
  bool apart = false; // with gaps, and no longer than they are thick, or than their names need
  bool nan = false;   // another swatch, apart
  int titleHeight = 0;
  int labelHeight = 0;
  int longest = 0; // length that a swatch which is apart needs at least
};

/// x, y, width, height.
using LegendRectangle = std::array<int, 4>;

struct LegendLayout
{
  std::vector<LegendRectangle> swatches; // by their values, that for no number last
  LegendRectangle row{};                 // around all but that one
  std::array<int, 2> title{};            // its upper left corner
};

/// Without swatches where there is no room for any.
LegendLayout legendLayout(const LegendLayoutOptions& options);

/// Distances, logical pixels.
constexpr int legendGap = 6;  // between parts
constexpr int legendTick = 4; // length

} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: PatternLegendLayout.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternLegendLayout.h"

#include <algorithm>

namespace hachure
{
namespace
{
// Less of a pattern says nothing.
constexpr int least = 4;

// Begin and length of every swatch along a row that has this much room.
std::vector<std::array<int, 2>> alongRow(const LegendLayoutOptions& options, int room)
{
  std::vector<std::array<int, 2>> spans;
  const int gap = options.apart ? legendGap : 0;
  int length = room - (options.swatches - 1) * gap;
  if (options.apart)
  {
    length = std::min(length, options.swatches * std::max(options.thickness, options.longest));
  }
  if (length < least * options.swatches)
  {
    return spans;
  }
  for (int i = 0; i < options.swatches; ++i)
  {
    const int begin = length * i / options.swatches;
    const int end = length * (i + 1) / options.swatches;
    spans.push_back({ begin + i * gap, end - begin });
  }
  return spans;
}
} // namespace

LegendLayout legendLayout(const LegendLayoutOptions& options)
{
  LegendLayout layout;
  const int across = options.vertical ? 0 : 1;
  const int along = 1 - across;
  const int titleRoom = options.titleHeight > 0 ? options.titleHeight + legendGap : 0;
  const int top = options.size[1] - titleRoom;
  layout.title = { 0, options.size[1] };
  const int ends = options.apart || !options.vertical ? 0 : options.labelHeight / 2;
  const int nanRoom = options.nan ? options.thickness + 2 * legendGap : 0;
  const int room = (options.vertical ? top : options.size[0]) - nanRoom - 2 * ends;
  const int thickness = std::min(options.thickness, options.vertical ? options.size[0] : top);
  const auto spans = alongRow(options, room);
  if (spans.empty() || thickness < least)
  {
    return layout;
  }
  // Values grow upwards, or to the right. Categories read downwards.
  const int length = spans.back()[0] + spans.back()[1];
  const auto place = [&](int begin, int extent)
  {
    LegendRectangle rectangle{};
    rectangle[across] = options.vertical ? 0 : top - thickness;
    rectangle[across + 2] = thickness;
    rectangle[along] = options.vertical ? top - ends - length + begin : begin;
    rectangle[along + 2] = extent;
    return rectangle;
  };
  const bool downwards = options.vertical && options.apart;
  for (const std::array<int, 2>& span : spans)
  {
    layout.swatches.push_back(place(downwards ? length - span[0] - span[1] : span[0], span[1]));
  }
  layout.row = place(0, length);
  if (options.nan)
  {
    const int before = -2 * legendGap - options.thickness;
    layout.swatches.push_back(
      place(options.vertical ? before : length + 2 * legendGap, options.thickness));
  }
  return layout;
}

} // namespace hachure

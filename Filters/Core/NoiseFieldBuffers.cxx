// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseFieldTiles.h"

#include <algorithm>

namespace hachure::noise
{

namespace
{

// Copies a tile's part of an array of the rectangle; empty stays empty.
template <class T>
void copyPart(Span<const T> from, const std::array<int, 4>& rectangle, T outside,
  const TileSums& sums, std::vector<T>& to)
{
  to.clear();
  if (from.empty())
  {
    return;
  }
  to.assign(sums.sums.size(), outside);
  for (int row = 0; row < sums.height; ++row)
  {
    const std::size_t line =
      static_cast<std::size_t>(sums.bottom + row - rectangle[1]) * rectangle[2];
    std::copy_n(from.data() + line + (sums.left - rectangle[0]), sums.width,
      to.data() + sums.place(sums.left, sums.bottom + row));
  }
}

} // namespace

SpotTexels::SpotTexels(const NoiseSpot& spot)
  : width(spot.width)
  , height(spot.height)
{
  double mean = 0.0;
  for (const float value : spot.values)
  {
    mean += value / static_cast<double>(spot.values.size());
  }
  this->values.reserve(static_cast<std::size_t>(width + 2) * (height + 2));
  double squares = 0.0;
  for (int row = -1; row <= height; ++row)
  {
    for (int column = -1; column <= width; ++column)
    {
      const int i = std::clamp(column, 0, width - 1);
      const int j = std::clamp(row, 0, height - 1);
      const double value = spot.values[static_cast<std::size_t>(j) * width + i] - mean;
      squares += i == column && j == row ? value * value : 0.0;
      this->values.push_back(static_cast<float>(value));
    }
  }
  this->square = static_cast<float>(squares / static_cast<double>(spot.values.size()));
}

void TileSums::copyKnown(const NoiseSurroundings& surroundings)
{
  copyPart(surroundings.depth, surroundings.rectangle, 1.0f, *this, this->depth);
  copyPart(surroundings.objects, surroundings.rectangle, 0, *this, this->objects);
  copyPart(surroundings.triangles, surroundings.rectangle, 0, *this, this->triangles);
  this->seen.resize(this->depth.size());
  std::transform(this->depth.begin(), this->depth.end(), this->seen.begin(),
    [](float value) { return value < 1.0f ? -1 : 0; });
  this->isKnown = true;
}

void TileSums::prepare(const NoiseSurroundings& surroundings, const Tile& tile, int margin)
{
  const std::array<int, 4>& rectangle = surroundings.rectangle;
  this->left = std::max(tile.left - margin, rectangle[0]);
  this->width = std::min(tile.right + margin, rectangle[0] + rectangle[2]) - this->left;
  this->bottom = std::max(tile.bottom - margin, rectangle[1]);
  this->height = std::min(tile.top + margin, rectangle[1] + rectangle[3]) - this->bottom;
  this->sums.assign(static_cast<std::size_t>(this->height + 2) * stride, 0.0f);
  this->isKnown = false;
}

} // namespace hachure::noise

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleTone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure
{

namespace
{

constexpr std::size_t toneCount = 17;
constexpr float tones[toneCount] = { 0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f,
  0.85f, 0.9f, 0.94f, 0.97f, 0.99f, 0.999f, 1.0f };
constexpr std::size_t facingCount = 8;
constexpr float facings[facingCount] = { 1.0f, 0.8f, 0.6f, 0.45f, 0.3f, 0.2f, 0.1f, 0.05f };

// Of every facing, for all tones: means of four sets of 6000 stipples, squeezed in four directions.
// As long as discs do not overlap, their area is their ink.
constexpr float discAreas[facingCount][toneCount] = { { 0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f,
                                                        0.6f, 0.707f, 0.831f, 0.907f, 1.003f,
                                                        1.105f, 1.221f, 1.368f, 1.605f, 2.1f },
  { 0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.603f, 0.713f, 0.842f, 0.921f, 1.019f, 1.128f,
    1.253f, 1.416f, 1.674f, 2.2f },
  { 0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.4f, 0.503f, 0.614f, 0.737f, 0.885f, 0.976f, 1.089f, 1.216f,
    1.369f, 1.571f, 1.887f, 2.5f },
  { 0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.403f, 0.513f, 0.635f, 0.776f, 0.95f, 1.059f, 1.195f, 1.344f,
    1.522f, 1.756f, 2.136f, 2.8f },
  { 0.0f, 0.05f, 0.1f, 0.2f, 0.303f, 0.413f, 0.535f, 0.675f, 0.839f, 1.046f, 1.179f, 1.349f, 1.542f,
    1.775f, 2.089f, 2.615f, 3.4f },
  { 0.0f, 0.05f, 0.1f, 0.201f, 0.309f, 0.428f, 0.56f, 0.713f, 0.895f, 1.133f, 1.29f, 1.499f, 1.741f,
    2.043f, 2.471f, 3.213f, 4.2f },
  { 0.0f, 0.05f, 0.1f, 0.206f, 0.322f, 0.45f, 0.595f, 0.766f, 0.976f, 1.259f, 1.451f, 1.713f,
    2.029f, 2.438f, 3.043f, 4.216f, 5.5f },
  { 0.0f, 0.05f, 0.102f, 0.211f, 0.331f, 0.467f, 0.622f, 0.808f, 1.04f, 1.358f, 1.577f, 1.88f,
    2.25f, 2.736f, 3.47f, 4.991f, 6.5f } };

// A place between two entries of a table.
struct Between
{
  std::size_t first;
  float share; // of the entry after it
};

Between placeOf(float value, const float* entries, std::size_t count)
{
  const bool rising = entries[0] < entries[count - 1];
  std::size_t first = 0;
  while (first + 2 < count && (entries[first + 1] < value) == rising)
  {
    ++first;
  }
  const float share = (value - entries[first]) / (entries[first + 1] - entries[first]);
  return { first, std::clamp(share, 0.0f, 1.0f) };
}

} // namespace

float stippleDiscArea(float tone, float facing)
{
  const Between column = placeOf(tone, tones, toneCount);
  const Between row = placeOf(facing, facings, facingCount);
  const auto at = [&](std::size_t index)
  {
    const float* const areas = discAreas[index] + column.first;
    return areas[0] + column.share * (areas[1] - areas[0]);
  };
  return at(row.first) + row.share * (at(row.first + 1) - at(row.first));
}

float stippleGrowth(float wanted, float growth)
{
  return std::clamp((std::sqrt(std::max(wanted, 0.0f)) - 1.0f) / growth, 0.0f, 1.0f);
}

// The mean of stippleGrowth(1 / share, growth)^2 over all shares of the density from 0 to 1.
float stippleMeanArea(float growth)
{
  const double grown = 1.0 / ((1.0 + growth) * (1.0 + growth)); // share of the stipples
  const double growing = -3.0 - (std::log(grown) - 4.0 * std::sqrt(grown) + grown);
  return static_cast<float>(grown + growing / (static_cast<double>(growth) * growth));
}

float stippleCrowd(float tone, float facing, float growth)
{
  constexpr float discOfSquare = 0.785398163f; // area of a disc over that of its square
  return stippleDiscArea(tone, facing) / (discOfSquare * stippleMeanArea(growth));
}

} // namespace hachure

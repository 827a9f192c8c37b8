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

// Classic ones have the same tones without that before the last.
constexpr std::size_t classicToneCount = 16;
constexpr float classicTones[classicToneCount] = { 0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f,
  0.7f, 0.8f, 0.85f, 0.9f, 0.94f, 0.97f, 0.99f, 1.0f };

// Of every facing, for all tones: means of twelve hierarchies of 20000 stipples, of a regular and
// of irregular hexagons, of a grid of 20 x 20 squares, and of ones with its points moved at random,
// each squeezed in another direction; of stipples with edges longer than 1.25 of those that all
// of them have on average. Tone 1 is that which leaves holes of .007, the last of which many more
// stipples would close: nobody gains from them.
constexpr float classicDiscAreas[facingCount][classicToneCount] = {
  { 0.0f, 0.05f, 0.1f, 0.201f, 0.301f, 0.402f, 0.511f, 0.634f, 0.779f, 0.969f, 1.095f, 1.264f,
    1.466f, 1.731f, 2.167f, 3.0f },
  { 0.0f, 0.05f, 0.1f, 0.201f, 0.301f, 0.403f, 0.512f, 0.635f, 0.781f, 0.972f, 1.098f, 1.268f,
    1.472f, 1.74f, 2.179f, 3.012f },
  { 0.0f, 0.05f, 0.1f, 0.201f, 0.301f, 0.403f, 0.514f, 0.64f, 0.791f, 0.988f, 1.12f, 1.297f, 1.511f,
    1.79f, 2.245f, 3.078f },
  { 0.0f, 0.05f, 0.1f, 0.201f, 0.302f, 0.405f, 0.517f, 0.646f, 0.802f, 1.008f, 1.146f, 1.331f,
    1.556f, 1.848f, 2.307f, 3.14f },
  { 0.0f, 0.05f, 0.1f, 0.201f, 0.303f, 0.408f, 0.523f, 0.656f, 0.817f, 1.033f, 1.178f, 1.377f,
    1.618f, 1.931f, 2.411f, 3.244f },
  { 0.0f, 0.05f, 0.1f, 0.202f, 0.306f, 0.415f, 0.534f, 0.671f, 0.838f, 1.061f, 1.212f, 1.417f,
    1.668f, 1.999f, 2.513f, 3.346f },
  { 0.0f, 0.05f, 0.101f, 0.204f, 0.314f, 0.432f, 0.562f, 0.712f, 0.896f, 1.143f, 1.311f, 1.541f,
    1.818f, 2.179f, 2.742f, 3.575f },
  { 0.0f, 0.05f, 0.101f, 0.207f, 0.321f, 0.446f, 0.587f, 0.75f, 0.951f, 1.221f, 1.406f, 1.662f,
    1.974f, 2.384f, 3.025f, 3.858f }
};

// From the same: the number of these stipples per area times the square of the least edge.
constexpr float edgeCrowds[facingCount] = { 0.427f, 0.423f, 0.413f, 0.405f, 0.416f, 0.463f, 0.616f,
  0.804f };

// From ten of these with all stipples of any use; the same for used shares above .75.
constexpr float edgeLacks[facingCount] = { 0.0f, 0.005f, 0.03f, 0.05f, 0.1f, 0.155f, 0.19f, 0.15f };
constexpr float leastUsed = 0.45f, mostUsed = 0.75f;

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

template <std::size_t count>
float valueAt(const float (&areas)[facingCount][count], const Between& column, float facing)
{
  const Between row = placeOf(facing, facings, facingCount);
  const auto at = [&](std::size_t index)
  {
    const float* const entries = areas[index] + column.first;
    return entries[0] + column.share * (entries[1] - entries[0]);
  };
  return at(row.first) + row.share * (at(row.first + 1) - at(row.first));
}

float valueAt(const float (&values)[facingCount], float facing)
{
  const Between row = placeOf(facing, facings, facingCount);
  const float* const entries = values + row.first;
  return entries[0] + row.share * (entries[1] - entries[0]);
}

} // namespace

float stippleDiscArea(float tone, float facing)
{
  return valueAt(discAreas, placeOf(tone, tones, toneCount), facing);
}

float stippleClassicDiscArea(float tone, float facing, float growth)
{
  const float area =
    valueAt(classicDiscAreas, placeOf(tone, classicTones, classicToneCount), facing);
  // Measured with growths of .25 and 1.
  const float less = 0.32f * std::min(growth, 1.0f);
  return area - less * (area - tone);
}

float stippleEdgeCrowd(float facing)
{
  return valueAt(edgeCrowds, facing);
}

float stippleEdgeLack(float facing, float used)
{
  const float share = (used - leastUsed) / (mostUsed - leastUsed);
  return std::clamp(share, 0.0f, 1.0f) * valueAt(edgeLacks, facing);
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

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stippling as a field of costs: a dot grows from nothing to the size of the pen's point within a
// short range of tones and hardly further. When the tile is full of dots side by side, as many
// again overlap them in the widest gaps; then all grow alike, and the last specks of white close.

#include "NestedPoints.h"
#include "Parallel.h"
#include "TileChecks.h"
#include "TileNoise.h"

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{

// All lengths in mean spacings of the dots.
constexpr double sideBySideTone = 0.42; // periods * periods dots, which hardly overlap
constexpr int overlapping = 2;          // dots in all over dots side by side
constexpr double allDotsTone = overlapping * sideBySideTone;
constexpr double entry = 0.03;    // range of tones in which a dot grows to its size
constexpr double swelling = 1.08; // of all dots by the time the last one is there

struct Dot
{
  double onset;
  double radius;
  double stretch, cosine, sine; // an ellipse: the pen is set down with a little slide
};

std::vector<Dot> drawnDots(int count, double hand, std::uint32_t seed)
{
  const double radius = std::sqrt(sideBySideTone / pi);
  std::vector<Dot> dots(count);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * unitRandom(seed, i, 41);
    Dot& dot = dots[i];
    dot.onset = (allDotsTone - entry) * i / count;
    dot.radius = radius * (1.0 + 0.28 * hand * (2.0 * unitRandom(seed, i, 40) - 1.0));
    dot.stretch = 1.0 + 0.35 * hand * unitRandom(seed, i, 42);
    dot.cosine = std::cos(angle);
    dot.sine = std::sin(angle);
  }
  return dots;
}

// Tone at which the dot reaches a point that lies (dx, dy) spacings away.
double dotCost(const Dot& dot, double dx, double dy)
{
  const double along = (dx * dot.cosine + dy * dot.sine) / dot.stretch;
  const double across = (dy * dot.cosine - dx * dot.sine) * dot.stretch;
  const double distance = std::sqrt(along * along + across * across);
  const double full = dot.onset + entry;
  if (distance < dot.radius)
  {
    return dot.onset + entry * distance * distance / (dot.radius * dot.radius);
  }
  const double swollen = dot.radius * swelling;
  if (distance < swollen)
  {
    return full + (allDotsTone - full) * (distance - dot.radius) / (swollen - dot.radius);
  }
  return allDotsTone + distance - swollen;
}

} // namespace

PatternTile stippleTile(const HatchOptions& options)
{
  check::hatchOptions("stippleTile", options);
  check::inRange("stippleTile", "periods", options.periods, 1, 256);
  const int size = options.size;
  const int periods = options.periods;
  const int count = overlapping * periods * periods;
  TorusGrid grid(periods);
  for (const TorusPoint& point : nestedPoints(count, options.seed))
  {
    grid.add(point);
  }
  const std::vector<Dot> dots = drawnDots(count, options.irregularity, options.seed);
  // No gap is as wide as two spacings.
  constexpr int rings = 2;
  std::vector<float> field(static_cast<std::size_t>(size) * size);
  parallelFor(size,
    [&](std::int64_t y)
    {
      for (int x = 0; x < size; ++x)
      {
        double lowest = 4.0;
        grid.visitNear((x + 0.5) / size, (static_cast<double>(y) + 0.5) / size, rings,
          [&](int i, double dx, double dy)
          { lowest = std::min(lowest, dotCost(dots[i], dx * periods, dy * periods)); });
        field[y * size + x] = static_cast<float>(lowest);
      }
    });
  return imageTile(field, size, size, periods);
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTile.h"

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

// All lengths in grains.
struct Fibre
{
  double cosine, sine;
  double halfLength, halfWidth;
  double bow; // sideways, at the ends
  double height;
};

struct Sheet
{
  PaperOptions options;
  TorusGrid grains;
  std::vector<double> grainHeight;
  std::vector<double> grainRadius;
  TorusGrid fibrePlaces;
  std::vector<Fibre> fibres;
};

Sheet makeSheet(const PaperOptions& options)
{
  const int count = options.periods * options.periods;
  Sheet sheet = { options, TorusGrid(options.periods), {}, {},
    TorusGrid(std::max(1, options.periods / 2)), {} };
  const std::vector<TorusPoint> places = nestedPoints(count, options.seed);
  for (int i = 0; i < count; ++i)
  {
    sheet.grains.add(places[i]);
    sheet.grainHeight.push_back(0.55 + 0.45 * unitRandom(options.seed, i, 50));
    sheet.grainRadius.push_back(0.5 + 0.24 * unitRandom(options.seed, i, 51));
  }
  for (int i = 0; i < (count + 1) / 2 && options.fibres > 0.0; ++i)
  {
    const double angle = pi * unitRandom(options.seed, i, 52);
    Fibre fibre;
    fibre.cosine = std::cos(angle);
    fibre.sine = std::sin(angle);
    fibre.halfLength = 1.0 + 1.6 * unitRandom(options.seed, i, 53);
    fibre.halfWidth = 0.08 + 0.05 * unitRandom(options.seed, i, 54);
    fibre.bow = 0.5 * (2.0 * unitRandom(options.seed, i, 55) - 1.0);
    fibre.height = 0.5 + 0.5 * unitRandom(options.seed, i, 56);
    sheet.fibrePlaces.add(places[i]);
    sheet.fibres.push_back(fibre);
  }
  return sheet;
}

// Rounded bumps that flow into each other, and a finer roughness.
double grainHeight(const Sheet& sheet, double x, double y)
{
  const int periods = sheet.options.periods;
  double sum = 0.0;
  sheet.grains.visitNear(x, y, 2,
    [&](int i, double dx, double dy)
    {
      const double ratio = periods / sheet.grainRadius[i];
      sum += sheet.grainHeight[i] * std::exp(-1.6 * (dx * dx + dy * dy) * ratio * ratio);
    });
  const double fine =
    cellNoise(x * 2 * periods, y * 2 * periods, 2 * periods, sheet.options.seed, 57);
  return sum + 0.22 * fine;
}

double fibreHeight(const Sheet& sheet, double x, double y)
{
  const int periods = sheet.options.periods;
  double highest = 0.0;
  sheet.fibrePlaces.visitNear(x, y, 2,
    [&](int i, double dx, double dy)
    {
      const Fibre& fibre = sheet.fibres[i];
      const double u = -(dx * fibre.cosine + dy * fibre.sine) * periods / fibre.halfLength;
      const double v = (dx * fibre.sine - dy * fibre.cosine) * periods - fibre.bow * u * u;
      const double end = 1.0 - smoothRamp(0.7, 1.0, std::abs(u));
      const double profile = std::exp(-v * v / (fibre.halfWidth * fibre.halfWidth));
      highest = std::max(highest, fibre.height * end * profile);
    });
  return highest;
}

// Ribs at whole periods, a little uneven, and chain lines about 16 ribs apart.
double laidHeight(const Sheet& sheet, double x, double y)
{
  const int periods = sheet.options.periods;
  const double uneven = cellNoise(x * periods, y * periods, periods, sheet.options.seed, 58);
  const double rib = std::cos(2.0 * pi * (y * periods + 0.06 * uneven));
  const int chains = std::max(1, periods / 16);
  const double across = x * chains - std::round(x * chains);
  const double chainWidth = 0.7 * chains / periods;
  const double chain = std::exp(-across * across / (chainWidth * chainWidth));
  return 0.5 + 0.3 * rib * (1.0 + 0.25 * uneven) + 0.18 * chain;
}

// Plain weave: at every crossing one thread lies on top, in turn. An even number of threads, so
// that the turns close on the tile.
double weaveHeight(const Sheet& sheet, double x, double y)
{
  const int threads = 2 * std::max(1, sheet.options.periods / 2);
  const double u = x * threads;
  const double v = y * threads;
  const double wave = std::cos(pi * u) * std::cos(pi * v); // > 0: the thread along x is on top
  const double alongX = std::sqrt(std::max(0.0, 1.0 - 4.0 * std::pow(v - std::round(v), 2.0)));
  const double alongY = std::sqrt(std::max(0.0, 1.0 - 4.0 * std::pow(u - std::round(u), 2.0)));
  return std::max(alongX * (0.6 + 0.4 * wave), alongY * (0.6 - 0.4 * wave));
}

} // namespace

PatternTile paperTile(const PaperOptions& options)
{
  const char* const name = "paperTile";
  check::inRange(name, "size", options.size, 8, 4096);
  check::inRange(name, "periods", options.periods, 1, std::min(256, options.size / 4));
  check::inRange(name, "grain", options.grain, 0.0, 1.0);
  check::inRange(name, "fibres", options.fibres, 0.0, 1.0);
  check::inRange(name, "laid", options.laid, 0.0, 1.0);
  check::inRange(name, "weave", options.weave, 0.0, 1.0);
  if (options.grain + options.fibres + options.laid + options.weave <= 0.0)
  {
    check::fail(name, "grain", "0, and fibres, laid and weave are 0 as well; expected one above 0");
  }
  const Sheet sheet = makeSheet(options);
  const int size = options.size;
  std::vector<float> field(static_cast<std::size_t>(size) * size);
  parallelFor(size,
    [&](std::int64_t row)
    {
      const double y = (static_cast<double>(row) + 0.5) / size;
      for (int column = 0; column < size; ++column)
      {
        const double x = (column + 0.5) / size;
        double height = 0.0;
        height += options.grain > 0.0 ? options.grain * grainHeight(sheet, x, y) : 0.0;
        height += options.fibres > 0.0 ? options.fibres * fibreHeight(sheet, x, y) : 0.0;
        height += options.laid > 0.0 ? 2.0 * options.laid * laidHeight(sheet, x, y) : 0.0;
        height += options.weave > 0.0 ? 2.0 * options.weave * weaveHeight(sheet, x, y) : 0.0;
        field[row * size + column] = static_cast<float>(height);
      }
    });
  return imageTile(field, size, size, options.periods);
}

} // namespace hachure

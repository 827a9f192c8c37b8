// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaintTile.h"

// A dab is what a flat bristle brush leaves: it is set down, pulled along u and lifted. Vocabulary.
// (u, v) are coordinates along and across it that reach from -1 to 1 on its *outline*, a rounded
// rectangle. A *streak* is the noise across the bristles, drawn out along the stroke: where it is
// low the brush holds less paint, so that the stroke ends earlier there and runs dry.

#include "NestedPoints.h"
#include "Parallel.h"
#include "TileChecks.h"
#include "TileNoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hachure
{
namespace
{

constexpr double visibleAlpha = 0.02; // under half a step of 8-bit colour, on most pairs of colours
constexpr double solidAlpha = 0.5;
// Range of tones within which a dab spreads from its spine to its outline: short, or rings of it
// would show around it.
constexpr double spreading = 0.03;

struct Dab
{
  double cosine, sine;
  double halfLength, halfWidth; // in tiles
  double bow;
  double onset;
};

struct Palette
{
  PaintOptions options;
  TorusGrid places;
  std::vector<Dab> dabs;
  int rings; // of cells within which a dab can reach
};

// Standard normal number from the sum of uniform ones, within +-3.
double bellRandom(std::uint32_t seed, std::uint64_t id, std::uint32_t dimension)
{
  double sum = -3.0;
  for (std::uint32_t i = 0; i < 12; ++i)
  {
    sum += 0.5 * unitRandom(seed, id, dimension + i);
  }
  return sum;
}

Palette makePalette(const PaintOptions& options)
{
  const int count = options.periods * options.periods;
  Palette palette = { options, TorusGrid(options.periods), {}, 1 };
  const double area = options.density / count;
  double reach = 0.0;
  int id = 0;
  for (const TorusPoint& place : nestedPoints(count, options.seed))
  {
    const double angle =
      std::min(2.0 * pi, options.angleJitter * pi / 180.0) * bellRandom(options.seed, id, 60);
    const double size =
      1.0 + options.sizeVariation * (2.0 * unitRandom(options.seed, id, 75) - 1.0);
    Dab dab;
    dab.cosine = std::cos(angle);
    dab.sine = std::sin(angle);
    dab.halfLength = 0.5 * size * std::sqrt(area * options.aspect);
    dab.halfWidth = 0.5 * size * std::sqrt(area / options.aspect);
    dab.bow = 0.5 * (2.0 * unitRandom(options.seed, id, 76) - 1.0);
    dab.onset = static_cast<double>(id) / count;
    reach = std::max(reach, std::hypot(dab.halfLength, 1.5 * dab.halfWidth));
    palette.places.add(place);
    palette.dabs.push_back(dab);
    ++id;
  }
  palette.rings = static_cast<int>(std::ceil(reach * options.periods));
  return palette;
}

// A dab as it lies over one texel.
struct Touch
{
  int dab = -1;
  double onset = 0.0;
  double dx = 0.0, dy = 0.0;
  double edge = 0.0; // 0 on the spine, 1 on the outline, more outside
  double alpha = 0.0;
  double height = 0.0;
};

// 0 to 1 across the bristles, nearly the same along the stroke.
double streak(const Palette& palette, int dab, double u, double v)
{
  const std::uint32_t seed = hashCombine(palette.options.seed, static_cast<std::uint64_t>(dab));
  const double drift = 0.12 * lineNoise(1.3 * u, seed, 80);
  const double coarse = lineNoise(3.5 * (v + drift), seed, 81);
  const double fine = lineNoise(9.0 * (v + drift) + 0.4 * lineNoise(2.0 * u, seed, 83), seed, 82);
  return std::clamp(0.5 + 0.32 * coarse + 0.28 * fine, 0.0, 1.0);
}

Touch touchOf(const Palette& palette, int index, double dx, double dy)
{
  const Dab& dab = palette.dabs[index];
  const double bristles = palette.options.bristles;
  // (dx, dy) leads from the texel to the dab.
  const double u = -(dx * dab.cosine + dy * dab.sine) / dab.halfLength;
  const double v =
    (dx * dab.sine - dy * dab.cosine) / dab.halfWidth - dab.bow * (std::min(u * u, 2.0) - 0.35);
  Touch touch;
  touch.dab = index;
  touch.onset = dab.onset;
  touch.dx = dx;
  touch.dy = dy;
  touch.edge = std::max(std::abs(u), std::abs(v));
  if (touch.edge >= 1.0)
  {
    return touch;
  }
  const double paint = streak(palette, index, u, v);
  // The brush lands almost straight and leaves in a ragged edge.
  const double limit =
    u < 0.0 ? 1.0 - 0.12 * bristles * (1.0 - paint) : 1.0 - 0.75 * bristles * (1.0 - paint);
  const double along = std::abs(u) / limit;
  touch.edge = std::pow(std::pow(along, 4.0) + std::pow(std::abs(v), 4.0), 0.25);
  const double soft = 0.30 - 0.16 * bristles;
  const double dry = bristles * smoothRamp(-0.3, 1.0, u) * smoothRamp(0.45, 0.8, 1.0 - paint);
  touch.alpha = (1.0 - smoothRamp(1.0 - soft, 1.0, touch.edge)) * (1.0 - 0.9 * dry);
  // Bristles plough the paint and push it to the sides and to where the brush is lifted.
  const double ridge = smoothRamp(0.55, 0.85, touch.edge);
  const double ploughed = 0.25 + 0.75 * bristles;
  touch.height =
    touch.alpha * std::min(1.0, 0.35 + ploughed * 0.55 * (paint - 0.4) + 0.25 * ridge + 0.1 * u);
  return touch;
}

// The dabs that matter at a texel.
struct Stack
{
  Touch top, below, nearest;
  double cost = std::numeric_limits<double>::max();
};

bool isAbove(const Touch& a, const Touch& b)
{
  return b.dab < 0 || a.onset < b.onset || (a.onset == b.onset && a.dx < b.dx);
}

// The dab below the top one that hides what is further below; without one, the uppermost.
bool isBetterBelow(const Touch& a, const Touch& b)
{
  const bool solidA = a.alpha >= solidAlpha;
  const bool solidB = b.dab >= 0 && b.alpha >= solidAlpha;
  return solidA != solidB ? solidA : isAbove(a, b);
}

Stack stackAt(const Palette& palette, double x, double y)
{
  std::vector<Touch> seen;
  Stack stack;
  stack.nearest.edge = std::numeric_limits<double>::max();
  palette.places.visitNear(x, y, palette.rings,
    [&](int index, double dx, double dy)
    {
      const Touch touch = touchOf(palette, index, dx, dy);
      if (touch.edge < stack.nearest.edge)
      {
        stack.nearest = touch;
      }
      if (touch.alpha < visibleAlpha)
      {
        return;
      }
      seen.push_back(touch);
      // Dry bristles and soft edges fill with rising tone.
      const double cost = touch.onset + spreading * touch.edge + 0.3 * (1.0 - touch.alpha);
      stack.cost = std::min(stack.cost, cost);
      if (isAbove(touch, stack.top))
      {
        stack.top = touch;
      }
    });
  for (const Touch& touch : seen)
  {
    const bool isTop = touch.dab == stack.top.dab && touch.dx == stack.top.dx;
    if (!isTop && isBetterBelow(touch, stack.below))
    {
      stack.below = touch;
    }
  }
  if (stack.top.dab < 0)
  {
    stack.top = stack.nearest;
    stack.cost = 2.0 + stack.nearest.edge; // bare ground is inked last
  }
  if (stack.below.dab < 0)
  {
    stack.below = stack.top;
    stack.below.alpha = 0.0;
    stack.below.height = 0.0;
  }
  return stack;
}

void resize(DabLayer& layer, std::size_t texels)
{
  layer.offset.resize(2 * texels);
  layer.alpha.resize(texels);
  layer.dab.resize(texels);
}

void resize(PaintTile& tile, std::size_t texels)
{
  resize(tile.top, texels);
  resize(tile.below, texels);
  tile.height.resize(texels);
}

void store(DabLayer& layer, std::size_t texel, const Touch& touch)
{
  layer.offset[2 * texel] = static_cast<float>(touch.dx);
  layer.offset[2 * texel + 1] = static_cast<float>(touch.dy);
  layer.alpha[texel] = static_cast<float>(touch.alpha);
  layer.dab[texel] = touch.dab;
}

void checkOptions(const PaintOptions& options)
{
  const char* const name = "paintTile";
  check::inRange(name, "size", options.size, 8, 4096);
  check::inRange(name, "periods", options.periods, 1, std::min(256, options.size / 4));
  check::inRange(name, "density", options.density, 0.5, 8.0);
  check::inRange(name, "aspect", options.aspect, 1.0, 8.0);
  check::inRange(name, "angleJitter", options.angleJitter, 0.0, 180.0);
  check::inRange(name, "sizeVariation", options.sizeVariation, 0.0, 0.8);
  check::inRange(name, "bristles", options.bristles, 0.0, 1.0);
}

// The texels of the finer level whose centres lie in one texel of the coarser level, in one
// direction; at least the one at its centre.
struct Span1D
{
  int begin, end;
};

Span1D finerTexels(int texel, int coarse, int fine)
{
  const double scale = static_cast<double>(fine) / coarse;
  const int begin = static_cast<int>(std::ceil(texel * scale - 0.5));
  const int end = static_cast<int>(std::ceil((texel + 1) * scale - 0.5));
  return { std::clamp(begin, 0, fine - 1), std::clamp(std::max(end, begin + 1), 1, fine) };
}

// One layer of a coarser texel, from the finer texels of this index list.
void mergeTexel(const DabLayer& from, const std::vector<std::size_t>& finer,
  const std::vector<std::array<double, 2>>& shift, DabLayer& to, std::size_t texel)
{
  std::size_t best = 0;
  int bestVotes = 0;
  for (std::size_t i = 0; i < finer.size(); ++i)
  {
    const auto votes = static_cast<int>(std::count_if(finer.begin(), finer.end(),
      [&](std::size_t other) { return from.dab[other] == from.dab[finer[i]]; }));
    if (votes > bestVotes)
    {
      best = i;
      bestVotes = votes;
    }
  }
  const std::size_t chosen = finer[best];
  double alpha = 0.0;
  for (const std::size_t other : finer)
  {
    alpha += from.dab[other] == from.dab[chosen] ? from.alpha[other] : 0.0;
  }
  to.dab[texel] = from.dab[chosen];
  to.alpha[texel] = static_cast<float>(alpha / bestVotes);
  to.offset[2 * texel] = static_cast<float>(from.offset[2 * chosen] + shift[best][0]);
  to.offset[2 * texel + 1] = static_cast<float>(from.offset[2 * chosen + 1] + shift[best][1]);
}

void mergeLevel(const PaintTile& fine, PaintTile& coarse)
{
  const int width = coarse.pattern.width;
  const int height = coarse.pattern.height;
  parallelFor(height,
    [&](std::int64_t y)
    {
      const Span1D rows = finerTexels(static_cast<int>(y), height, fine.pattern.height);
      std::vector<std::size_t> finer;
      std::vector<std::array<double, 2>> shift; // from the coarser centre to the finer one
      for (int x = 0; x < width; ++x)
      {
        const Span1D columns = finerTexels(x, width, fine.pattern.width);
        finer.clear();
        shift.clear();
        double thickness = 0.0;
        for (int j = rows.begin; j < rows.end; ++j)
        {
          for (int i = columns.begin; i < columns.end; ++i)
          {
            finer.push_back(static_cast<std::size_t>(j) * fine.pattern.width + i);
            shift.push_back({ (i + 0.5) / fine.pattern.width - (x + 0.5) / width,
              (j + 0.5) / fine.pattern.height - (static_cast<double>(y) + 0.5) / height });
            thickness += fine.height[finer.back()];
          }
        }
        const std::size_t texel = static_cast<std::size_t>(y) * width + x;
        mergeTexel(fine.top, finer, shift, coarse.top, texel);
        mergeTexel(fine.below, finer, shift, coarse.below, texel);
        coarse.height[texel] = static_cast<float>(thickness / static_cast<double>(finer.size()));
      }
    });
}

} // namespace

PaintTile paintTile(const PaintOptions& options)
{
  checkOptions(options);
  const Palette palette = makePalette(options);
  const int size = options.size;
  const std::size_t texels = static_cast<std::size_t>(size) * size;
  PaintTile tile;
  resize(tile, texels);
  std::vector<float> field(texels);
  parallelFor(size,
    [&](std::int64_t y)
    {
      for (int x = 0; x < size; ++x)
      {
        const std::size_t texel = static_cast<std::size_t>(y) * size + x;
        const Stack stack =
          stackAt(palette, (x + 0.5) / size, (static_cast<double>(y) + 0.5) / size);
        store(tile.top, texel, stack.top);
        store(tile.below, texel, stack.below);
        tile.height[texel] = static_cast<float>(
          std::clamp(stack.top.height + (1.0 - stack.top.alpha) * std::max(0.0, stack.below.height),
            0.0, 1.0));
        field[texel] = static_cast<float>(stack.cost);
      }
    });
  tile.pattern = imageTile(field, size, size, options.periods);
  return tile;
}

std::vector<PaintTile> paintMipChain(const PaintTile& tile)
{
  const std::size_t texels = tile.pattern.screen.size();
  for (const DabLayer* layer : { &tile.top, &tile.below })
  {
    if (layer->dab.size() != texels || layer->alpha.size() != texels ||
      layer->offset.size() != 2 * texels || tile.height.size() != texels)
    {
      check::fail("paintMipChain", "tile",
        std::to_string(layer->dab.size()) + " dabs for " + std::to_string(texels) + " texels");
    }
  }
  std::vector<PaintTile> chain{ tile };
  for (PatternTile& pattern : mipChain(tile.pattern))
  {
    if (pattern.texelSize > 1.0)
    {
      PaintTile next;
      resize(next, pattern.screen.size());
      next.pattern = std::move(pattern);
      mergeLevel(chain.back(), next);
      chain.push_back(std::move(next));
    }
  }
  return chain;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseFieldTiles.h"

#include "NoiseFieldLanes.h"

#include <algorithm>
#include <cmath>

// The loops over the pixels of kernels. A kernel is a product of functions of the column and of the
// row: exp(-c (x^2 + y^2)) cos(b x + d y + p) =
// [G(x) cos(b x)] [G(y) cos(d y + p)] - [G(x) sin(b x)] [G(y) sin(d y + p)].
// So it takes two multiplications a pixel, those of the phasor's other part are the same factors,
// and the variance is one more product. Eight columns at a time keep their factors in registers.
namespace hachure::noise
{

namespace
{

constexpr int mostRows = tileHeight + 16;
// By which the rows of a disc are too many rather than too few, in pixels: the circle is exact.
constexpr float slack = 1e-2f;

// The part of a kernel's disc that lies in a tile, in columns and rows of the framebuffer.
struct Window
{
  int left, right, bottom, top;
};

// Pixels [first, last) of a range that lie within a distance of a place, maybe a few more.
HACHURE_INLINED void clip(float place, float radius, int begin, int count, int& first, int& last)
{
  const float low = place - 0.5f - static_cast<float>(begin);
  first = begin + static_cast<int>(std::ceil(std::max(low - radius, 0.0f)));
  last = begin + std::min(static_cast<int>(std::max(low + radius + 1.0f, 0.0f)), count);
}

HACHURE_INLINED Window windowOf(const TileKernel& kernel, const TileSums& sums)
{
  Window result;
  clip(kernel.x, kernel.radius + slack, sums.left, sums.width, result.left, result.right);
  clip(kernel.y, kernel.radius + slack, sums.bottom, sums.height, result.bottom, result.top);
  return result;
}

// What hides a kernel's pixels.
struct Tests
{
  bool depth, objects, triangles;
  float tolerance;
};

enum class Tested
{
  nothing,
  depth, // alone
  all
};

// Factors of the rows of a window, which include the weight, and what the test of depth adds up
// from rows and columns.
struct Rows
{
  alignas(32) float cosine[mostRows];
  alignas(32) float sine[mostRows];
  alignas(32) float energy[mostRows];
  alignas(32) float square[mostRows]; // of half the chord's length
  alignas(32) float depth[mostRows];
  alignas(32) float tolerance[mostRows];
};

// The tolerance of depth grows with the squared distance.
HACHURE_INLINED float toleranceGrowth(const TileKernel& kernel)
{
  const float slope = std::sqrt(kernel.slopeX * kernel.slopeX + kernel.slopeY * kernel.slopeY);
  return glsl::noiseSlopeTolerance * slope / kernel.radius;
}

template <Tested tested>
HACHURE_INLINED void fillRows(
  const TileKernel& kernel, const Tests& tests, const Window& window, Rows& rows)
{
  const float start = static_cast<float>(window.bottom) + 0.5f;
  const float growth = tested != Tested::nothing ? toleranceGrowth(kernel) : 0.0f;
  for (int row = 0; row < window.top - window.bottom; row += floatLanes)
  {
    const FloatLanes y = (laneNumbers() + (start + static_cast<float>(row))) - kernel.y;
    const FloatLanes square = y * y;
    const FloatLanes envelope = decayLanes(square * kernel.decay) * kernel.weight;
    FloatLanes cosine, sine;
    turnLanes(y * kernel.turnY + kernel.turn, cosine, sine);
    storeLanes(envelope * cosine, rows.cosine + row);
    storeLanes(envelope * sine, rows.sine + row);
    storeLanes(envelope * envelope * 0.5f, rows.energy + row);
    storeLanes(kernel.radius * kernel.radius - square, rows.square + row);
    if (tested != Tested::nothing)
    {
      storeLanes(y * kernel.slopeY, rows.depth + row);
      storeLanes(square * growth + tests.tolerance, rows.tolerance + row);
    }
  }
}

// Factors of eight columns.
struct Columns
{
  FloatLanes square, cosine, sine, energy, depth, tolerance;
};

template <Tested tested>
HACHURE_INLINED void fillColumns(const TileKernel& kernel, int column, Columns& columns)
{
  const FloatLanes x = (laneNumbers() + (static_cast<float>(column) + 0.5f)) - kernel.x;
  columns.square = x * x;
  const FloatLanes envelope = decayLanes(columns.square * kernel.decay);
  FloatLanes cosine, sine;
  turnLanes(x * kernel.turnX, cosine, sine);
  columns.cosine = envelope * cosine;
  columns.sine = envelope * sine;
  columns.energy = envelope * envelope;
  if (tested != Tested::nothing)
  {
    columns.depth = x * kernel.slopeX;
    columns.tolerance = columns.square * toleranceGrowth(kernel);
  }
}

// Rows [first, last) of the window that some columns have in common with the disc.
struct RowRange
{
  int first, last;
};

HACHURE_INLINED RowRange rowsOf(
  const TileKernel& kernel, const Window& window, int column, int count)
{
  const float low = static_cast<float>(column) + 0.5f - kernel.x;
  const float nearest = std::max(std::max(low, -(low + static_cast<float>(count - 1))), 0.0f);
  const float square = kernel.radius * kernel.radius - nearest * nearest;
  const float half = std::sqrt(std::max(square, 0.0f)) + slack;
  RowRange result;
  clip(kernel.y, half, window.bottom, window.top - window.bottom, result.first, result.last);
  return { result.first - window.bottom, result.last - window.bottom };
}

// How much eight pixels count of a kernel. Where nothing is seen all count: there the noise goes
// on, so that differences across a silhouette are those of the noise.
template <Tested tested>
HACHURE_INLINED FloatLanes passLanes(const TileKernel& kernel, const Tests& tests,
  const Columns& columns, float rowDepth, float rowTolerance, const TileSums& sums,
  std::size_t place)
{
  FloatLanes excess{};
  if (tested == Tested::depth || tests.depth)
  {
    // The difference of the depths first, which loses nothing.
    excess =
      depthExcessLanes((loadLanes(&sums.depth[place]) - kernel.depth) - (columns.depth + rowDepth),
        columns.tolerance + rowTolerance);
  }
  if (tested == Tested::all && tests.objects)
  {
    excess = 1.0f - keepEqual(&sums.objects[place], kernel.object, 1.0f - excess);
  }
  if (tested == Tested::all && tests.triangles)
  {
    excess = 1.0f - keepEqual(&sums.triangles[place], kernel.triangle, 1.0f - excess);
  }
  if (tested == Tested::depth || !sums.seen.empty())
  {
    excess = maskLanes(&sums.seen[place], excess);
  }
  return excessWeightLanes(excess);
}

// The kinds of kernels: each adds eight pixels of one row.
struct Gabor
{
  template <Tested tested>
  static HACHURE_INLINED void add(
    const Columns& columns, const Rows& rows, int row, const FloatLanes& pass, float* first)
  {
    const FloatLanes inside = rows.square[row] - columns.square;
    FloatLanes value = columns.cosine * rows.cosine[row] - columns.sine * rows.sine[row];
    FloatLanes variance = columns.energy * rows.energy[row];
    if (tested != Tested::nothing)
    {
      value = value * pass;
      variance = variance * (pass * pass);
    }
    addLanes(keepWhere(inside, value), first);
    addLanes(keepWhere(inside, variance), first + TileSums::toSecond);
  }
};

struct Phasor
{
  template <Tested tested>
  static HACHURE_INLINED void add(
    const Columns& columns, const Rows& rows, int row, const FloatLanes& pass, float* first)
  {
    const FloatLanes inside = rows.square[row] - columns.square;
    FloatLanes real = columns.cosine * rows.cosine[row] - columns.sine * rows.sine[row];
    FloatLanes imaginary = columns.sine * rows.cosine[row] + columns.cosine * rows.sine[row];
    if (tested != Tested::nothing)
    {
      real = real * pass;
      imaginary = imaginary * pass;
    }
    addLanes(keepWhere(inside, real), first);
    addLanes(keepWhere(inside, imaginary), first + TileSums::toSecond);
  }
};

// Some groups of eight columns at a time, which share what is read of the rows.
template <class Kind, Tested tested, int groups>
HACHURE_INLINED void addColumns(const TileKernel& kernel, const Tests& tests, const Window& window,
  const Rows& rows, int column, TileSums& sums)
{
  Columns columns[groups];
  for (int group = 0; group < groups; ++group)
  {
    fillColumns<tested>(kernel, column + group * floatLanes, columns[group]);
  }
  const RowRange range = rowsOf(kernel, window, column, groups * floatLanes);
  float* first = &sums.sums[sums.place(column, window.bottom + range.first)];
  for (int row = range.first; row < range.last; ++row)
  {
    for (int group = 0; group < groups; ++group)
    {
      float* const to = first + group * floatLanes;
      FloatLanes pass{};
      if (tested != Tested::nothing)
      {
        pass = passLanes<tested>(kernel, tests, columns[group], rows.depth[row],
          rows.tolerance[row], sums, to - sums.sums.data());
      }
      Kind::template add<tested>(columns[group], rows, row, pass, to);
    }
    first += TileSums::stride;
  }
}

template <class Kind, Tested tested>
HACHURE_INLINED void addKernel(const TileKernel& kernel, const Tests& tests, TileSums& sums)
{
  const Window window = windowOf(kernel, sums);
  Rows rows;
  fillRows<tested>(kernel, tests, window, rows);
  int column = window.left;
  for (; column + floatLanes < window.right; column += 2 * floatLanes)
  {
    addColumns<Kind, tested, 2>(kernel, tests, window, rows, column, sums);
  }
  if (column < window.right)
  {
    addColumns<Kind, tested, 1>(kernel, tests, window, rows, column, sums);
  }
}

// Eight pixels of a spot, by linear interpolation between texels. These have whole numbers at their
// centres; in the ring around the image it goes on.
HACHURE_INLINED FloatLanes spotLanes(
  const SpotTexels& spot, const FloatLanes& column, const FloatLanes& row)
{
  const float* values = spot.values.data();
  const std::ptrdiff_t stride = spot.width + 2;
  const FloatLanes x = limitLanes(column, spot.width + 0.999f);
  const FloatLanes y = limitLanes(row, spot.height + 0.999f);
  const FloatLanes i = floatsOf(wholeLanes(x));
  const FloatLanes j = floatsOf(wholeLanes(y));
  std::int32_t places[floatLanes];
  const IntLanes whole = wholeLanes(j * static_cast<float>(stride) + i);
  std::memcpy(places, &whole, sizeof(places));
  alignas(32) float corners[4][floatLanes];
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    const float* texel = values + places[lane];
    corners[0][lane] = texel[0];
    corners[1][lane] = texel[1];
    corners[2][lane] = texel[stride];
    corners[3][lane] = texel[stride + 1];
  }
  const FloatLanes s = x - i;
  const FloatLanes left = loadLanes(corners[0]);
  const FloatLanes leftAbove = loadLanes(corners[2]);
  const FloatLanes below = left + s * (loadLanes(corners[1]) - left);
  const FloatLanes above = leftAbove + s * (loadLanes(corners[3]) - leftAbove);
  return below + (y - j) * (above - below);
}

// Rotated and scaled to the kernel's square.
HACHURE_INLINED FloatLanes spotRow(
  const SpotTexels& spot, const TileKernel& kernel, const FloatLanes& x, float y)
{
  const float scaleX = 0.5f * spot.width / kernel.radius;
  const float scaleY = 0.5f * spot.height / kernel.radius;
  const FloatLanes along = x * kernel.turnX + y * kernel.turnY;
  const FloatLanes across = y * kernel.turnX - x * kernel.turnY;
  return spotLanes(spot, along * scaleX + (0.5f * spot.width + 0.5f),
    across * scaleY + (0.5f * spot.height + 0.5f));
}

template <Tested tested>
HACHURE_INLINED void addSpot(
  const TileKernel& kernel, const Tests& tests, const SpotTexels& spot, TileSums& sums)
{
  const Window window = windowOf(kernel, sums);
  const float quarter = kernel.turn - std::floor(kernel.turn);
  const float weight = quarter > 0.25f && quarter < 0.75f ? -kernel.weight : kernel.weight;
  for (int column = window.left; column < window.right; column += floatLanes)
  {
    const FloatLanes x = (laneNumbers() + (static_cast<float>(column) + 0.5f)) - kernel.x;
    Columns columns;
    columns.square = x * x;
    columns.depth = x * kernel.slopeX;
    columns.tolerance = columns.square * toleranceGrowth(kernel);
    const RowRange range = rowsOf(kernel, window, column, floatLanes);
    for (int row = window.bottom + range.first; row < window.bottom + range.last; ++row)
    {
      const std::size_t place = sums.place(column, row);
      const float y = static_cast<float>(row) + 0.5f - kernel.y;
      const FloatLanes inside = (kernel.radius * kernel.radius - y * y) - columns.square;
      FloatLanes value = spotRow(spot, kernel, x, y) * weight;
      if (tested != Tested::nothing)
      {
        value = value *
          passLanes<tested>(kernel, tests, columns, y * kernel.slopeY,
            y * y * toleranceGrowth(kernel) + tests.tolerance, sums, place);
      }
      addLanes(keepWhere(inside, value), &sums.sums[place]);
      addLanes(keepWhere(inside, value * value), &sums.sums[place + TileSums::toSecond]);
    }
  }
}

// The kernels of a tile, in their order.
struct Entries
{
  const TileKernel* kernels;
  const std::uint32_t* order;
  std::int64_t count;
  Tests tests; // those that any kernel can need
  const NoiseSurroundings* surroundings;
};

// Kernels that are on their way from memory.
constexpr std::int64_t ahead = 6;

// Which tests a kernel needs.
HACHURE_INLINED Tested chooseTests(
  const Entries& entries, const TileKernel& kernel, TileSums& sums, Tests& tests)
{
  tests = entries.tests;
  tests.depth = tests.depth && !kernel.onPlane;
  const bool others = tests.objects || tests.triangles;
  if ((tests.depth || others) && !sums.isKnown)
  {
    sums.copyKnown(*entries.surroundings);
  }
  return others ? Tested::all : tests.depth ? Tested::depth : Tested::nothing;
}

template <class Kind>
HACHURE_INLINED void addKernels(const Entries& entries, TileSums& sums)
{
  for (std::int64_t i = 0; i < entries.count; ++i)
  {
    const TileKernel& kernel = entries.kernels[entries.order[i]];
    prefetch(&entries.kernels[entries.order[std::min(i + ahead, entries.count - 1)]]);
    Tests tests;
    switch (chooseTests(entries, kernel, sums, tests))
    {
      case Tested::nothing:
        addKernel<Kind, Tested::nothing>(kernel, tests, sums);
        break;
      case Tested::depth:
        addKernel<Kind, Tested::depth>(kernel, tests, sums);
        break;
      case Tested::all:
        addKernel<Kind, Tested::all>(kernel, tests, sums);
        break;
    }
  }
}

HACHURE_WIDE_CLONES
void sumGabor(const Entries& entries, TileSums& sums)
{
  addKernels<Gabor>(entries, sums);
}

HACHURE_WIDE_CLONES
void sumPhasor(const Entries& entries, TileSums& sums)
{
  addKernels<Phasor>(entries, sums);
}

HACHURE_WIDE_CLONES
void sumSpots(const Entries& entries, const SpotTexels& spot, TileSums& sums)
{
  for (std::int64_t i = 0; i < entries.count; ++i)
  {
    const TileKernel& kernel = entries.kernels[entries.order[i]];
    prefetch(&entries.kernels[entries.order[std::min(i + ahead, entries.count - 1)]]);
    Tests tests;
    if (chooseTests(entries, kernel, sums, tests) == Tested::nothing)
    {
      addSpot<Tested::nothing>(kernel, tests, spot, sums);
    }
    else
    {
      addSpot<Tested::all>(kernel, tests, spot, sums);
    }
  }
}

} // namespace

void sumTile(const TileTask& task, const Tile& tile, int margin, TileSums& sums)
{
  const NoiseSurroundings& surroundings = *task.surroundings;
  sums.prepare(surroundings, tile, margin);
  const Entries entries = { task.tiled->kernels.get(), task.tiled->order.data() + tile.begin,
    tile.end - tile.begin,
    { surroundings.depthTest && !surroundings.depth.empty(),
      !surroundings.objects.empty() && !tile.oneObject, !surroundings.triangles.empty(),
      surroundings.depthTolerance },
    &surroundings };
  switch (task.options->kind)
  {
    case NoiseKind::gabor:
      sumGabor(entries, sums);
      break;
    case NoiseKind::phasor:
      sumPhasor(entries, sums);
      break;
    case NoiseKind::spot:
      sumSpots(entries, *task.spot, sums);
      break;
  }
}

} // namespace hachure::noise

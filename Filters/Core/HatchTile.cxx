// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Hatching as a field of costs: every stroke is a valley whose depth says from which tone on a
// point is inked. Vocabulary. A *family* is a set of parallel lines given by its wave vector, whole
// numbers of lines along x and y, which closes on the tile at any angle. A *loop* is one closed
// line of a family on the tile taken as a torus; strokes follow each other along a loop. The cost
// of a point is the lowest, over all strokes, of
//   onset + 2 (distance to the stroke's spine) / (spacing * pressure) + taper,
// so that with irregularity 0 it is the triangle wave of ruled lines, and with rising tone strokes
// appear, lengthen and thicken until they meet. Ranking the costs makes the screen uniform.
// With several *densities*, lines between the lines of the family (Praun et al. 2001, tonal art
// maps), every stroke instead grows within its density's range of tones to the width of a nib and
// stays nearly there: its half width by tone is a polyline, and the cost is the tone at which it
// reaches the point.

#include "Parallel.h"
#include "Random.h"
#include "TileChecks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hachure
{
namespace
{

struct Point
{
  double x, y;
};

struct Family
{
  int kx, ky;

  double frequency() const { return std::hypot(kx, ky); }
  // Unit vector along the lines; (1, 0) for lines counted along +y.
  Point along() const { return { ky / this->frequency(), -kx / this->frequency() }; }
  Point across() const { return { kx / this->frequency(), ky / this->frequency() }; }
};

// When the densities set in, and how wide their lines are; in line spacings of the family.
struct Nib
{
  int densities;
  std::array<double, 5> tones{};  // at which density k sets in
  std::array<double, 5> halves{}; // half width of all lines that are there by then

  explicit Nib(int densitiesIn)
    : densities(densitiesIn)
  {
    for (int k = 1; k <= densities; ++k)
    {
      this->tones[k] = densityTone(k, densities);
      this->halves[k] = this->tones[k] / (1 << k);
    }
  }

  double range(int density) const { return this->tones[density + 1] - this->tones[density]; }

  // Tone at which a line of this density is `distance` wide to either side. It sets in at `onset`,
  // within `entry` it has most of its width, and it is complete when the next density sets in.
  double tone(int density, double onset, double entry, double distance) const
  {
    const double entryHalf = 0.8 * this->halves[density + 1];
    if (distance <= entryHalf)
    {
      return onset + entry * distance / entryHalf;
    }
    double fromTone = onset + entry;
    double fromHalf = entryHalf;
    for (int k = density + 1; k <= this->densities; ++k)
    {
      if (distance <= this->halves[k])
      {
        return fromTone +
          (this->tones[k] - fromTone) * (distance - fromHalf) / (this->halves[k] - fromHalf);
      }
      fromTone = this->tones[k];
      fromHalf = this->halves[k];
    }
    const double half = 0.5 / (1 << (this->densities - 1)); // between the densest lines
    return fromTone + (1.0 - fromTone) * (distance - fromHalf) / (half - fromHalf);
  }
};

// All lengths but the centre in units of the line spacing.
struct Stroke
{
  Point centre; // in tiles
  double halfLength;
  double entryTaper, exitTaper;
  double onset;
  double entry = 0.0;     // range of tones in which a nib is pressed down
  double pressure, swell; // mean half width, and its change along the stroke
  double tilt, bow;
  double wobble, wobbleFrequency, wobblePhase;
  int density = 0;
};

// Random number in [-1, 1].
double signedRandom(std::uint32_t seed, std::uint64_t id, std::uint32_t dimension)
{
  return 2.0 * unitRandom(seed, id, dimension) - 1.0;
}

// A stroke of the hand: everything but its place, length and onset. `hand` is the irregularity.
void giveCharacter(Stroke& stroke, double hand, std::uint32_t seed, std::uint64_t id)
{
  stroke.entryTaper = 0.5 + 0.5 * unitRandom(seed, id, 10);
  stroke.exitTaper = 1.2 + 1.4 * unitRandom(seed, id, 11);
  stroke.pressure = 1.0 + 0.18 * hand * signedRandom(seed, id, 12);
  stroke.swell = 0.22 * hand * signedRandom(seed, id, 13);
  stroke.tilt = 0.12 * hand * signedRandom(seed, id, 14);
  stroke.bow = 0.10 * hand * signedRandom(seed, id, 15);
  stroke.wobble = hand * (0.01 + 0.03 * unitRandom(seed, id, 16));
  stroke.wobbleFrequency = 1.2 + 1.2 * unitRandom(seed, id, 17);
  stroke.wobblePhase = 2.0 * pi * unitRandom(seed, id, 18);
}

// Where lines lie and where their strokes begin.
struct Ruling
{
  double offset = 0.0;     // of the lines beside the loops of the family, in spacings
  double phase = 0.0;      // of the strokes along the lines, in strokes
  double meanLength = 6.5; // in spacings: two or three strokes in what the eye takes in
};

// Lines of strokes that follow each other, with ends that overlap a little or, for a loose hand,
// leave a gap.
void addLines(std::vector<Stroke>& strokes, const Family& family, double hand, std::uint32_t seed,
  const Ruling& ruling)
{
  constexpr double goldenRatio = 0.6180339887498949;
  const int loops = std::gcd(family.kx, family.ky);
  const double frequency = family.frequency();
  const double loopLength = frequency * frequency / loops;
  const int count = std::max(1, static_cast<int>(std::lround(loopLength / ruling.meanLength)));
  const Point along = family.along();
  const Point across = family.across();
  for (int loop = 0; loop < loops; ++loop)
  {
    for (int i = 0; i < count; ++i)
    {
      const std::uint64_t id = static_cast<std::uint64_t>(loop) * count + i;
      const double step = loopLength / count;
      // Golden-ratio phases keep the ends of neighbouring lines apart.
      const double phase = ruling.phase + loop * goldenRatio + 0.12 * signedRandom(seed, id, 0);
      const double arc = (i + phase) * step / frequency;
      const double beside =
        (loop + ruling.offset + 0.10 * hand * signedRandom(seed, id, 1)) / frequency;
      Stroke stroke;
      stroke.centre = { along.x * arc + across.x * beside, along.y * arc + across.y * beside };
      giveCharacter(stroke, hand, seed, id);
      // At a light touch tapers overlap; at a loose one some ends stay apart.
      const double overlap = 1.6 + hand * (0.9 * unitRandom(seed, id, 2) - 1.5);
      stroke.halfLength = 0.5 * step + 0.5 * overlap;
      stroke.onset = 0.20 * hand * unitRandom(seed, id, 3);
      strokes.push_back(stroke);
    }
  }
}

// Lines of all densities. Strokes of one density appear one by one, and deviate the less the more
// neighbours they will have.
void addDensities(std::vector<Stroke>& strokes, const Family& family, double hand,
  std::uint32_t seed, const Nib& nib)
{
  // Steps of a two-dimensional golden-ratio sequence (Roberts' R2): neighbours along a line and
  // across the lines appear at different tones.
  constexpr double plasticStep = 0.7548776662466927;
  const double fineness = std::min(1.0, 3.0 / (1 << (nib.densities - 1)));
  const double spread = 0.76 * std::min(1.0, 3.0 * hand); // of the density's range of tones
  for (int density = 0; density < nib.densities; ++density)
  {
    const int between = density > 0 ? 1 << (density - 1) : 1;
    const double range = nib.range(density);
    for (int line = 0; line < between; ++line)
    {
      const std::uint32_t lineSeed = hashCombine(seed, 64 + density * 16 + line);
      Ruling ruling;
      ruling.offset = density > 0 ? (line + 0.5) / between : 0.0;
      ruling.phase = unitRandom(lineSeed, 0, 29);
      ruling.meanLength = 5.0; // shorter than single lines: denser ones come close to each other
      const std::size_t first = strokes.size();
      addLines(strokes, family, hand * fineness, lineSeed, ruling);
      const double start = unitRandom(lineSeed, 0, 30);
      for (std::size_t i = first; i < strokes.size(); ++i)
      {
        Stroke& stroke = strokes[i];
        const double turn = start + static_cast<double>(i - first) * plasticStep;
        stroke.density = density;
        stroke.onset = nib.tones[density] + range * spread * (turn - std::floor(turn));
        stroke.entry = 0.22 * range;
        stroke.pressure = 1.0 + 0.15 * hand * signedRandom(lineSeed, i, 31);
        stroke.swell = 0.2 * hand * signedRandom(lineSeed, i, 32);
        // Ends that show: strokes of uneven length with gaps between some of them.
        stroke.halfLength -= 0.8 * hand * unitRandom(lineSeed, i, 33);
      }
    }
  }
}

// Shorter, thinner strokes that a loose hand sets between the lines where it has to get dark.
void addFillers(std::vector<Stroke>& strokes, const Family& family, double hand, std::uint32_t seed)
{
  constexpr std::uint64_t firstId = 1u << 20; // apart from the ids of the lines
  const double frequency = family.frequency();
  const int loops = std::gcd(family.kx, family.ky);
  const double loopLength = frequency * frequency / loops;
  constexpr double pitch = 8.0; // spacings along the line between two fillers
  const int count = std::max(1, static_cast<int>(std::lround(loopLength / pitch)));
  const Point along = family.along();
  const Point across = family.across();
  for (int i = 0; i < loops * count; ++i)
  {
    const std::uint64_t id = firstId + i;
    const double offset = (i % loops + 0.5 + 0.12 * signedRandom(seed, id, 1)) / frequency;
    const int alongLoop = i / loops;
    const double arc = (alongLoop + unitRandom(seed, id, 0)) * loopLength / count / frequency;
    Stroke stroke;
    stroke.centre = { along.x * arc + across.x * offset, along.y * arc + across.y * offset };
    giveCharacter(stroke, hand, seed, id);
    stroke.pressure *= 0.6;
    stroke.halfLength = 1.6 + 1.4 * unitRandom(seed, id, 2);
    // Beyond the reach of any tone when the hand is firm.
    stroke.onset = 1.05 - hand * (0.28 + 0.22 * unitRandom(seed, id, 3));
    strokes.push_back(stroke);
  }
}

// Cost at a point given along (u) and across (v) the stroke, in spacings from its centre.
double strokeCost(const Stroke& stroke, const Nib& nib, double u, double v)
{
  const double s = std::clamp(u / stroke.halfLength, -1.4, 1.4);
  const double spine = stroke.tilt * s + stroke.bow * (s * s - 0.4) +
    stroke.wobble * std::sin(stroke.wobbleFrequency * u + stroke.wobblePhase);
  const double width = stroke.pressure * (1.0 + stroke.swell * s);
  const double past = u < 0.0 ? (stroke.entryTaper - stroke.halfLength - u) / stroke.entryTaper
                              : (u + stroke.exitTaper - stroke.halfLength) / stroke.exitTaper;
  if (nib.densities > 1)
  {
    // A nib that is lifted leaves a point; with the tone the stroke grows past it.
    const double end = std::max(0.0, past);
    const double lens = std::max(1e-6, 1.0 - end * end);
    const double distance = std::abs(v - spine) / width;
    return std::min(nib.tone(stroke.density, stroke.onset, stroke.entry, distance / lens),
      0.35 * end + nib.tone(stroke.density, stroke.onset, stroke.entry, distance));
  }
  // The hand lets go: a lens-shaped end that grows longer with the tone.
  const double taper = past > 0.0 ? 0.35 * past * past : 0.0;
  return stroke.onset + 2.0 * std::abs(v - spine) / width + taper;
}

// Distance across the stroke, in spacings, past which neighbours are always nearer.
constexpr double reachAcross = 1.4;
// Distance past an end, in tapers, up to which it can grow.
constexpr double reachAlong = 2.0;

// A stroke at one of its places on the repeated plane, with the texels that it can reach.
struct PlacedStroke
{
  const Stroke* stroke;
  Point centre;
  int left, right, bottom, top; // the last ones excluded
};

std::vector<PlacedStroke> placeStrokes(
  const std::vector<Stroke>& strokes, const Family& family, int size)
{
  std::vector<PlacedStroke> placed;
  const double spacing = 1.0 / family.frequency();
  const Point along = family.along();
  for (const Stroke& stroke : strokes)
  {
    const double u =
      spacing * (stroke.halfLength + reachAlong * std::max(stroke.entryTaper, stroke.exitTaper));
    const double v = spacing * reachAcross;
    const double extentX = std::abs(along.x) * u + std::abs(along.y) * v;
    const double extentY = std::abs(along.y) * u + std::abs(along.x) * v;
    const Point home = { stroke.centre.x - std::floor(stroke.centre.x),
      stroke.centre.y - std::floor(stroke.centre.y) };
    const int copiesX = static_cast<int>(std::ceil(extentX));
    const int copiesY = static_cast<int>(std::ceil(extentY));
    const auto texel = [size](double position)
    { return std::clamp(static_cast<int>(std::ceil(position * size - 0.5)), 0, size); };
    for (int j = -copiesY; j <= copiesY; ++j)
    {
      for (int i = -copiesX; i <= copiesX; ++i)
      {
        const Point centre = { home.x + i, home.y + j };
        const PlacedStroke copy = { &stroke, centre, texel(centre.x - extentX),
          texel(centre.x + extentX), texel(centre.y - extentY), texel(centre.y + extentY) };
        if (copy.left < copy.right && copy.bottom < copy.top)
        {
          placed.push_back(copy);
        }
      }
    }
  }
  return placed;
}

// Cost of ruled lines, dark at whole phases: a triangle wave, or the nib's polyline around the
// lines of all densities. Whole-number distances, so that mirror images are equal to the last bit.
double ruledCost(const Family& family, const Nib& nib, int size, int x, int y)
{
  const std::int64_t turn = 2 * static_cast<std::int64_t>(size);
  const std::int64_t phase = (2 * static_cast<std::int64_t>(x) + 1) * family.kx +
    (2 * static_cast<std::int64_t>(y) + 1) * family.ky;
  const std::int64_t inTurn = (phase % turn + turn) % turn;
  if (nib.densities == 1)
  {
    return static_cast<double>(size - std::abs(inTurn - size)) / size;
  }
  const auto cost = [&](int density, std::int64_t distance, std::int64_t unit)
  {
    const double onset = nib.tones[density];
    const double entry = 0.5 * nib.range(density);
    return nib.tone(density, onset, entry, static_cast<double>(distance) / unit);
  };
  double lowest = cost(0, size - std::abs(inTurn - size), turn);
  for (int density = 1; density < nib.densities; ++density)
  {
    const int between = 1 << (density - 1);
    const std::int64_t distance = std::abs(inTurn * between % turn - size);
    lowest = std::min(lowest, cost(density, distance, turn * between));
  }
  return lowest;
}

std::vector<float> ruledField(const Family& family, const Nib& nib, int size)
{
  std::vector<float> field(static_cast<std::size_t>(size) * size);
  parallelFor(size,
    [&](std::int64_t y)
    {
      for (int x = 0; x < size; ++x)
      {
        field[y * size + x] =
          static_cast<float>(ruledCost(family, nib, size, x, static_cast<int>(y)));
      }
    });
  return field;
}

std::vector<Stroke> handStrokes(
  const Family& family, const HatchOptions& options, std::uint32_t seed)
{
  std::vector<Stroke> strokes;
  if (options.densities > 1)
  {
    addDensities(strokes, family, options.irregularity, seed, Nib(options.densities));
  }
  else
  {
    addLines(strokes, family, options.irregularity, seed, {});
    addFillers(strokes, family, options.irregularity, seed);
  }
  return strokes;
}

std::vector<float> drawnField(
  const Family& family, const Nib& nib, int size, const std::vector<Stroke>& strokes)
{
  const std::vector<PlacedStroke> placed = placeStrokes(strokes, family, size);
  const double frequency = family.frequency();
  const Point along = family.along();
  const Point across = family.across();
  std::vector<float> field(static_cast<std::size_t>(size) * size);
  parallelFor(size,
    [&](std::int64_t y)
    {
      float* row = &field[y * size];
      for (int x = 0; x < size; ++x)
      {
        // What no stroke reaches is inked last, lines first.
        row[x] = static_cast<float>(2.0 + ruledCost(family, nib, size, x, static_cast<int>(y)));
      }
      for (const PlacedStroke& copy : placed)
      {
        if (y < copy.bottom || y >= copy.top)
        {
          continue;
        }
        const double dy = ((static_cast<double>(y) + 0.5) / size - copy.centre.y) * frequency;
        for (int x = copy.left; x < copy.right; ++x)
        {
          const double dx = ((x + 0.5) / size - copy.centre.x) * frequency;
          const double cost = strokeCost(
            *copy.stroke, nib, dx * along.x + dy * along.y, dx * across.x + dy * across.y);
          row[x] = std::min(row[x], static_cast<float>(cost));
        }
      }
    });
  return field;
}

PatternTile familyTile(const Family& family, const HatchOptions& options, std::uint32_t seed)
{
  const Nib nib(options.densities);
  const std::vector<float> field = options.irregularity > 0.0
    ? drawnField(family, nib, options.size, handStrokes(family, options, seed))
    : ruledField(family, nib, options.size);
  return imageTile(field, options.size, options.size, options.periods);
}

} // namespace

double densityTone(int density, int densities)
{
  check::inRange("densityTone", "densities", densities, 1, 4);
  check::inRange("densityTone", "density", density, 0, densities);
  // Lines grow wider by a sixth from one density to the next: the hand presses a little harder.
  constexpr double step = 2.0 * 7.0 / 6.0;
  constexpr double complete = 0.5;
  return density > 0 ? complete * std::pow(step, density - densities) : 0.0;
}

PatternTile hatchTile(const HatchOptions& options)
{
  check::hatchOptions("hatchTile", options);
  check::densities("hatchTile", options);
  return familyTile({ 0, options.periods }, options, options.seed);
}

PatternTile crossHatchTile(const CrossHatchOptions& options)
{
  check::hatchOptions("crossHatchTile", options);
  check::densities("crossHatchTile", options);
  check::inRange("crossHatchTile", "crossingAngle", options.crossingAngle, 5.0, 175.0);
  check::inRange("crossHatchTile", "delay", options.delay, 0.0, 0.95);
  const double angle = options.crossingAngle * pi / 180.0;
  Family second = { static_cast<int>(std::lround(-std::sin(angle) * options.periods)),
    static_cast<int>(std::lround(std::cos(angle) * options.periods)) };
  if (second.kx == 0)
  {
    second.kx = -1; // the flattest crossing that the tile allows, instead of none
  }
  const PatternTile lower = familyTile({ 0, options.periods }, options, options.seed);
  const PatternTile upper =
    familyTile(second, options, hashCombine(options.seed, 1)); // strokes of another hand movement
  const float delay = static_cast<float>(options.delay);
  std::vector<float> field(lower.screen.size());
  // The second direction grows faster than the tone at first: lines thinner than a pixel, which
  // no edge smoothing draws well, are rare.
  constexpr float growth = 0.7f;
  parallelFor(static_cast<std::int64_t>(field.size()),
    [&](std::int64_t i)
    {
      const float crossing = delay + (1.0f - delay) * std::pow(upper.screen[i], growth);
      field[i] = std::min(lower.screen[i], crossing);
    });
  return imageTile(field, options.size, options.size, options.periods);
}

} // namespace hachure

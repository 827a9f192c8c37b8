// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternTile_h
#define hachure_PatternTile_h

#include "Span.h"

#include <cstdint>
#include <vector>

// Tileable images that say at which tone every point takes ink. The lines and dots of procedural
// tiles lie on whole periods, counted from the lower left corner: there the half-size copy about
// the origin, which takes over when a pattern grows, has marks as well, so that marks stay and new
// ones come in between.
namespace hachure
{

// A screen in [0, 1] whose values are uniformly distributed over the texels; ink goes where screen
// < tone. Texels are stored row by row, row 0 at the bottom, and repeat without a seam in both
// directions.
struct PatternTile
{
  int width = 0;
  int height = 0;

  std::vector<float> screen;

  // Change of the screen across one texel *of level 0*, on every mip level: gradient * (texels of
  // level 0 per pixel) is the width w of inkCoverage, which makes an edge one pixel wide. At ridges
  // and creases it is the steeper side; where many texels share one grey value it is at least the
  // range of tones that they share, so that a flat area prints grey and no noise. Always > 0.
  std::vector<float> gradient;

  // Pattern periods (lines, dots) across the tile's width.
  int periods = 1;

  // Texels of level 0 per texel of this level.
  double texelSize = 1.0;

  // Distinct values before the tile was made uniform; few levels of a user's image mean visible
  // steps.
  int levels = 0;
};

struct HatchOptions
{
  // Texels across the tile, in both directions; 8 to 4096.
  int size = 256;
  // Lines across the tile; 1 to size / 4.
  int periods = 8;
  // 0 = ruled lines, 1 = a loose hand: strokes that overlap, taper, waver and press unevenly.
  double irregularity = 0.0;
  std::uint32_t seed = 1;
  // Of hatching, 1 to 4. With 1 the lines grow wider with the tone. With more they keep nearly one
  // width, and there are more of them: `periods` sparse lines first, then as many between them,
  // then twice as many between those, each density setting in at about twice the tone of the one
  // before. The densest lines cover half of the tile, and grow to full ink from there.
  // periods * 2^(densities - 1) is at most size / 4.
  int densities = 1;
};

struct CrossHatchOptions : HatchOptions
{
  // From the first to the second direction, in degrees counter-clockwise, 5 to 175. Only directions
  // that close on the tile are possible: the nearest one is taken.
  double crossingAngle = 90.0;
  // Tone at which the second direction sets in, 0 to .95.
  double delay = 0.3;
};

// Strokes along +x.
PatternTile hatchTile(const HatchOptions& options = {});

// Strokes along +x, then strokes across them. The darkest tones close to full ink.
PatternTile crossHatchTile(const CrossHatchOptions& options = {});

// Clustered dots on a square lattice along x and y: round dots, a checkerboard at tone .5, round
// holes.
PatternTile halftoneTile(const HatchOptions& options = {});

// Tone at which the lines of a density set in, 0 for the first one, and the one at which the
// densest lines are complete for density = densities.
double densityTone(int density, int densities);

// Dots of one size, one by one in blue-noise order: periods x periods of them side by side up to
// about tone .4, then more that overlap and grow to full ink. Dots come in between those that are
// there already, and where a dot is the half-size copy has one as well. At most 256 periods.
PatternTile stippleTile(const HatchOptions& options = {});

// A user's image (row 0 at the bottom, dark = low = inked first) with `periods` pattern periods
// across. Throws when a value is not finite or the sizes do not match.
PatternTile imageTile(Span<const float> grey, int width, int height, int periods = 1);

// The tile and its copies at half, quarter, ... size, down to one texel; each level is uniform
// again.
std::vector<PatternTile> mipChain(const PatternTile& tile);

} // namespace hachure

#endif

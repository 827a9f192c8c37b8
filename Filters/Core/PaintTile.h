// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PaintTile_h
#define hachure_PaintTile_h

#include "PatternTile.h"

namespace hachure
{

struct PaintOptions
{
  // Texels across the tile, in both directions; 8 to 4096.
  int size = 256;
  // periods * periods dabs on the tile; 1 to size / 4, at most 256.
  int periods = 8;
  std::uint32_t seed = 1;
  // Mean number of dabs over a point, 0.5 to 8; with it the dabs grow. Up to about 2 some ground
  // shows.
  double density = 3.0;
  // Length of a dab over its width, 1 to 8.
  double aspect = 2.6;
  // Standard deviation of a dab's direction from +x, in degrees, 0 to 180.
  double angleJitter = 18.0;
  // Largest relative deviation of a dab's size, 0 to 0.8.
  double sizeVariation = 0.3;
  // 0 = a soft brush, 1 = stiff bristles: streaks, a ragged end that runs dry.
  double bristles = 0.6;
};

// One layer of dabs: for every texel the dab seen there.
struct DabLayer
{
  // From the texel's centre to the dab's centre, in tile widths, x and y in turn: what to add to
  // the texture coordinate to find where the dab takes its colour. May lead out of the tile.
  std::vector<float> offset;
  // Opacity of the dab, 0 to 1: soft at the edge, low between dry bristles. 0 where there is none;
  // the offset then leads to the nearest dab.
  std::vector<float> alpha;
  // The dab's number, for variation from dab to dab.
  std::vector<std::int32_t> dab;
};

// Overlapping brush strokes. The dabs of lower tones lie on top, so that with rising tone dabs come
// in from below, and the dab on top of a texel is the one that inks it first. Colour of the paint
// at a texel: mix(mix(ground, colour of below, below.alpha), colour of top, top.alpha).
struct PaintTile
{
  PatternTile pattern;
  DabLayer top;
  DabLayer below;
  // Thickness of the paint for lighting, 0 to 1: bristle marks and a ridge along the edges.
  std::vector<float> height;
};

// Throws std::invalid_argument naming the option.
PaintTile paintTile(const PaintOptions& options = {});

// As mipChain. A coarser texel shows the dab that most of its texels show, with the offset from its
// own centre: offsets to different dabs are never averaged.
std::vector<PaintTile> paintMipChain(const PaintTile& tile);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ToneTable_h
#define hachure_ToneTable_h

#include "PatternTile.h"

#include <vector>

// The threshold that makes mean ink equal the tone, measured on the pattern as it is drawn:
// filtering, edge width and the LOD transition all change the distribution of a screen (Breslav et
// al. 2007, section 3.3).
namespace hachure
{

struct ToneTableOptions
{
  // Texels of level 0 per drawn pixel at LOD scale 1; > 0. Tile width / (periods * pixels per
  // period).
  double texelsPerPixelAtScale1 = 4.0;
  // LOD scales between which the half-size copy takes over; 1 <= lodStart < lodEnd <= 2.
  double lodStart = 1.3;
  double lodEnd = 1.7;
  // false: only the first octave is drawn, at every scale.
  bool lodBlending = true;
};

// Row-major, row = LOD step, column = tone: threshold[step * tones + tone]. Upload as a texture of
// 256 x 48 texels, one float, linear filter, clamped to edge, and look up with tableColumn and
// tableRow of Kernels/PatternField.glsl. Column i is tone i / 255; the scale of row k is
// tableScale(k, lodStart, lodEnd), row 0 scale 1 and row 31 scale 2. Thresholds grow with the tone
// and may lie outside [0, 1].
struct ToneTable
{
  int tones = 256;
  int steps = 48; // as tableSteps of Kernels/PatternField.glsl
  std::vector<float> threshold;
  ToneTableOptions options;
};

// `mips` = mipChain(tile).
ToneTable buildToneTable(Span<const PatternTile> mips, const ToneTableOptions& options = {});

// Bilinear look-up as the shader does it; scale in [1, 2].
double toneThreshold(const ToneTable& table, double tone, double scale);

// Screen (x) and width (y) of the pattern as drawn at uv and scale: texture filter and LOD blend
// included.
struct DrawnField
{
  float screen;
  float width;
};
DrawnField drawnField(
  Span<const PatternTile> mips, const ToneTableOptions& options, double u, double v, double scale);

// Ink (linear coverage) of the pixel at uv for this tone and scale.
double drawnInk(Span<const PatternTile> mips, const ToneTable& table, double tone, double u,
  double v, double scale);

} // namespace hachure

#endif

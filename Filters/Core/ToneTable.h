// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ToneTable_h
#define hachure_ToneTable_h

#include "OctaveContrast.h"
#include "PatternTile.h"

#include <vector>

// The threshold that makes mean ink equal the tone, measured on the pattern as it is drawn:
// filtering, edge width and the LOD transition all change the distribution of a screen (Breslav et
// al. 2007, section 3.5).
namespace hachure
{

// How the half-size copy takes over while a pattern grows (Breslav et al. 2007, section 3.4).
enum class LodTransition
{
  none,        // it does not
  crossFade,   // inks are mixed: strokes fade in and out and keep their shape
  blendScreens // screens are mixed before the threshold: marks change their shape
};

// How the weight of the half-size copy grows with the scale; see lodBlend in Kernels/Lod.glsl.
enum class LodPace
{
  even,   // the picture changes equally much with every part of the growth
  classic // in proportion to the scale (section 3.4)
};

// Which part of the difference between tone and ink is removed (section 3.5).
enum class ToneCorrection
{
  full,           // all: mean ink equals the tone
  transitionOnly, // what changes with the scale: ink stays what the uncorrected screen gives at 1
  off             // none: the tone is the threshold
};

struct ToneTableOptions
{
  // Texels of level 0 per drawn pixel at LOD scale 1; > 0. Tile width / (periods * pixels per
  // period).
  double texelsPerPixelAtScale1 = 4.0;
  // LOD scales between which the half-size copy takes over; 1 <= lodStart < lodEnd <= 2.
  double lodStart = 1.3;
  double lodEnd = 1.7;
  LodTransition transition = LodTransition::blendScreens;
  LodPace pace = LodPace::even;
  ToneCorrection correction = ToneCorrection::full;
  // Texels per pixel at which transitionOnly looks at the uncorrected screen, where that is not
  // texelsPerPixelAtScale1; 0: it is.
  double referenceTexelsPerPixel = 0.0;
  // Texels per pixel of the eye at LOD scale 1, where those are not the drawn pixels: the pace of a
  // transition must not depend on how finely it is drawn. 0: they are.
  double seenTexelsPerPixel = 0.0;
  // Mip level that both octaves are drawn from, as fixedTileLevel has it; below 0: the levels that
  // fit their footprints.
  double fixedLevel = -1.0;
};

bool operator==(const ToneTableOptions& a, const ToneTableOptions& b);

// Row-major: threshold[row * tones + tone]. Upload as a texture of one float, linear filter,
// clamped to edge, and look up with the functions of Kernels/PatternField.glsl.
// Column i is tone i / 255 (tableColumn). With blendScreens the scale of row k is
// tableScale(k, lodStart, lodEnd, contrast), row 0 scale 1 and the last row, its equal, scale 2
// (tableRow); otherwise the table is that of a single octave, octaveScale(k), from 1/2 to 2
// (octaveRow). Thresholds grow with the tone and may lie outside [0, 1].
struct ToneTable
{
  int tones = 256;
  int steps = 0; // tableSteps with blendScreens, otherwise octaveSteps of PatternField.glsl
  std::vector<float> threshold;
  // Of the octaves, as lodBlend takes it: 0 with the classic pace; octaveContrast() half way where
  // inks cross-fade. Screens have equal variance at every size.
  float contrast = 1.0f;
  ToneTableOptions options;
};

// Rows of a table.
int tableRows(LodTransition transition);

// `mips` = mipChain(tile).
ToneTable buildToneTable(Span<const PatternTile> mips, const ToneTableOptions& options = {});

// Bilinear look-up as the shader does it; scale in [1, 2], of a single octave in [1/2, 2].
double toneThreshold(const ToneTable& table, double tone, double scale);

// Screen (x) and width (y) of the pattern as drawn at uv and scale: texture filter and blended
// screens included. With another transition than blendScreens: of the single octave at this scale.
struct DrawnField
{
  float screen;
  float width;
};
DrawnField drawnField(
  Span<const PatternTile> mips, const ToneTableOptions& options, double u, double v, double scale);

// Ink (linear coverage) of the pixel at uv for this tone and scale, transition included; scale in
// [1, 2].
double drawnInk(Span<const PatternTile> mips, const ToneTable& table, double tone, double u,
  double v, double scale);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// An image pattern drawn at any scale with exact tone. Needs Ink.glsl and Lod.glsl before it.
//
// What a renderer does per pixel, and ToneTable.cxx does when it measures:
//   s      wrapped LOD scale in [1, 2): wrapScale(similarity scale); 1 when fixed in the image
//   tile   RG16 texture: red = screen, green = gradient (per texel of level 0, on every level) over
//          tileGradientRange; mip level k = k-th element of mipChain(), GL_REPEAT, linear filter in
//          and between levels
//   table  R32F texture, 256 tones wide, linear, clamped to edge: the ToneTable of the transition in
//          use
//   level  fixedTileLevel(tpp1); where the period may be any, tileLevel(footprint) of each octave
//   tpp1   texels of level 0 per drawn pixel at s = 1 (the table is built with the same number):
//          tile width / (periods across the tile * pixels per period)
//
//   float tpp = tpp1 / s;
//   float t = lodBlend(s, s0, s1, contrast);
//   vec2 first = tileTexel(textureLod(tile, uv, level).rg);    // may be skipped when t == 1
//   vec2 second = tileTexel(textureLod(tile, 2 uv, level).rg); // may be skipped when t == 0
// The octaves blend as screens, so that marks change their shape,
//   vec2 field = patternField(first, second, t, tpp);
//   float threshold = texture(table, vec2(tableColumn(tone), tableRow(s, s0, s1, contrast))).r;
//   float ink = patternInk(tone, threshold, field, flatShare(s, t, period));
// or they cross-fade as inks, so that marks keep it; each has the tone, and so has their mixture:
//   ink = mix(octaveInk(first, s, 0), octaveInk(second, s / 2, 1), t), where octaveInk(...) is
//   patternInk(tone, texture(table, vec2(tableColumn(tone), octaveRow(scale))).r,
//     patternField(first, second, 0 or 1, tpp), flatShare(s, 0 or 1, period))
//
// uv: 1 per tile width (and 1 per tile height); y up; row 0 of the tile is the bottom.
// period: pixels per period at s = 1. All of s, t, tpp, the rows and flatShare are constant per patch
// and draw: compute them outside the pixel.

// Columns of the tables, and rows of those of blended screens.
const float tableTones = 256.0f;
const float tableSteps = 96.0f;
// Steps before the LOD transition, and from its end to scale 2, where little changes; the 90
// others lie in the transition, with rows exactly where the response bends: at its start and end,
// at a third, where slopes of a ruled hatch cancel, and at its middle.
const float tableStepsBefore = 3.0f;
const float tableStepsAfter = 2.0f;
// Rows of the tables of a single octave, and the octaves of scale that these reach over.
const float octaveSteps = 48.0f;
const float tableOctaves = 2.0f;
// Below this many pixels per period a screen cannot be resolved: ink = tone. Above one pixel more,
// no change.
const float flatPeriod = 2.0f;
// Edges oblique to the pixels' sides cross a square pixel more steeply than one change per pixel; this
// width fits the area coverage of all directions best.
const float edgeSharpness = 0.9f;

// Largest gradient that a tile's texture can hold: no screen changes more from texel to texel.
const float tileGradientRange = 2.0f;

// Screen and gradient from what the texture of a tile holds.
vec2 tileTexel(vec2 stored)
{
  return vec2(stored.x, tileGradientRange * stored.y);
}

// Mip level, may be fractional, for a footprint in texels of level 0 per pixel: up to two texels
// per pixel are skipped, since edges are smoothed analytically, and coarser levels would make thin
// strokes dotted.
float tileLevel(float texelsPerPixel)
{
  return max(0.0f, log2(max(texelsPerPixel, 1.0e-6f)) - 2.0f);
}

// The one level from which a pattern is drawn whose period in the picture stays within an octave, for
// its footprint at scale 1: it has 2.8 to 5.7 texels per pixel there. Finer ones would show no more,
// and take several times the memory that caches must hold.
float fixedTileLevel(float texelsPerPixelAtScale1)
{
  return max(0.0f, floor(log2(max(texelsPerPixelAtScale1, 1.0e-6f)) + 0.5f) - 2.0f);
}

// Screen (x) and its change across a pixel (y) from the texels of both octaves.
vec2 patternField(vec2 first, vec2 second, float t, float texelsPerPixel)
{
  float screen = mix(first.x, second.x, t);
  float width = mix(first.y, 2.0f * second.y, t) * edgeSharpness * texelsPerPixel;
  return vec2(screen, width);
}

// Texture coordinate of a tone in the table.
float tableColumn(float tone)
{
  return (clamp(tone, 0.0f, 1.0f) * (tableTones - 1.0f) + 0.5f) / tableTones;
}

// Texture coordinate of a wrapped scale in the table: row 0 is s = 1, the last row is s = 2. Within
// the transition rows go by the blend, whatever its pace. 1 <= s0 <= s1 <= 2.
float tableRow(float s, float s0, float s1, float contrast)
{
  float last = tableSteps - 1.0f;
  float row = last;
  if (s <= s0)
  {
    row = tableStepsBefore * clamp((s - 1.0f) / max(s0 - 1.0f, 1.0e-6f), 0.0f, 1.0f);
  }
  else if (s < s1)
  {
    row = tableStepsBefore +
      (last - tableStepsBefore - tableStepsAfter) * lodBlend(s, s0, s1, contrast);
  }
  else
  {
    row = last - tableStepsAfter * clamp((2.0f - s) / max(2.0f - s1, 1.0e-6f), 0.0f, 1.0f);
  }
  return (row + 0.5f) / tableSteps;
}

// The wrapped scale of a row number of the table: inverse of tableRow.
float tableScale(float row, float s0, float s1, float contrast)
{
  float last = tableSteps - 1.0f;
  if (row <= tableStepsBefore)
  {
    return mix(1.0f, s0, row / tableStepsBefore);
  }
  if (row >= last - tableStepsAfter)
  {
    return mix(2.0f, s1, (last - row) / tableStepsAfter);
  }
  float blend = (row - tableStepsBefore) / (last - tableStepsBefore - tableStepsAfter);
  return lodScale(blend, s0, s1, contrast);
}

// Texture coordinate of the scale of a single octave, 1/2 to 2, in its table.
float octaveRow(float scale)
{
  float along = clamp((1.0f + log2(max(scale, 1.0e-6f))) / tableOctaves, 0.0f, 1.0f);
  return (along * (octaveSteps - 1.0f) + 0.5f) / octaveSteps;
}

// The scale of a row number of that table: inverse of octaveRow.
float octaveScale(float row)
{
  return exp2(tableOctaves * row / (octaveSteps - 1.0f) - 1.0f);
}

// Share of flat tone (ink = tone) in the drawing: 1 up to 2 pixels per period, 0 from 3 on. t is
// the weight of the half-size copy, whose period is half.
float flatShare(float s, float t, float pixelsPerPeriodAtScale1)
{
  float period = pixelsPerPeriodAtScale1 * s * mix(1.0f, 0.5f, t);
  return 1.0f - clamp(period - flatPeriod, 0.0f, 1.0f);
}

// Ink share of a pixel. field = patternField(), threshold = table value. No tone, no ink; full
// tone, full ink.
float patternInk(float tone, float threshold, vec2 field, float flatWeight)
{
  if (tone <= 0.0f)
  {
    return 0.0f;
  }
  if (tone >= 1.0f)
  {
    return 1.0f;
  }
  return mix(inkCoverage(field.x, threshold, field.y), tone, flatWeight);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetrics_h
#define hachure_PatternMetrics_h

#include "Span.h"

#include <cstdint>
#include <vector>

// What the quality of a moving pattern is measured on. Ink is linear coverage, 1 = full ink. Rows
// run from the bottom to the top, pixel centres have integer coordinates.
//
// Words of all PatternMetrics files: a *clip* is a sequence of frames, a *step* leads from one
// frame to the next, a *block* is a square of pixels, at least two wavelengths of the pattern wide,
// the *slide* of a block is how far its pattern moves against the surface in one step.
namespace hachure
{

struct ImageView
{
  int width = 0;
  int height = 0;
  Span<const float> values; // width * height, row by row
};

// Motion of the surface point seen at each pixel, to the next frame; all of width * height values.
struct MotionView
{
  int width = 0;
  int height = 0;
  Span<const float> u, v;     // pixels, to the right and up
  Span<const float> visible;  // above 0.5: seen in this frame and in the next
  Span<const float> facing;   // n.v, 1 = seen from the front; empty = 1 everywhere
  Span<const float> distance; // from the eye, > 0 where visible; empty = unknown
};

// motions[t] leads from frame t to t + 1; there are as many as frames, or one less.
struct PatternClip
{
  std::vector<ImageView> frames;
  std::vector<MotionView> motions;
};

// Throws std::invalid_argument naming the first thing that is wrong: fewer than two frames, missing
// motion, frames of different sizes, nothing visible, numbers that are not finite, ink beyond
// [0, 1].
void checkClip(const PatternClip& clip);

// 1 at pixels that are visible and turned to the eye by at least minimumFacing, else 0.
std::vector<std::uint8_t> usablePixels(const MotionView& motion, double minimumFacing);

// Middle value; of an even number the mean of the two in the middle; NaN of none. NaN are left out.
double medianOf(std::vector<double> values);

} // namespace hachure

#endif

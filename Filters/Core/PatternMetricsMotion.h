// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetricsMotion_h
#define hachure_PatternMetricsMotion_h

#include "PatternMetrics.h"

// Does the pattern move with the surface, and does it stay the same pattern? Both frames of a step
// are smoothed, the second is looked up where the motion leads, and blocks are compared by their
// normalised cross-correlation (NCC), which is 1 for equal patterns whatever their contrast.
namespace hachure
{

struct MotionMetricsOptions
{
  double wavelength = 8.0;    // of the pattern, pixels; 3 to 1000. Blocks are two of them wide.
  double minimumFacing = 0.3; // n.v, 0 to 1; steeper surface is left out
  double smoothing = 1.0;     // deviation of the Gaussian before any correlation, pixels; 0 to 10
  double minimumShare = 0.6;  // of usable pixels in a block, above 0, up to 1
};

// Means over the blocks of a step. Without a block that has contrast: blocks is 0, the rest NaN.
struct StepMetrics
{
  double coherence;   // NCC without slide
  double boil;        // 1 - NCC at the best slide
  double slide;       // length of the best slide, pixels, below half a wavelength
  double motion;      // length of the mean motion of a block, pixels
  double normalSlide; // slide and motion across the strokes (structure tensor) alone
  double normalMotion;
  int blocks;
};

// NaN where nothing moves (slide ratios) or no block has contrast (all but largestMotion).
struct MotionMetrics
{
  std::vector<StepMetrics> steps;
  double slideRatio;       // mean slide / mean motion: 0 on the surface, 1 fixed in the image
  double normalSlideRatio; // the same across the strokes: the measure for hatching
  double coherence;        // mean
  double meanSlide;        // pixels per frame
  double meanMotion;       // pixels per frame
  double medianBoil;
  double largestBoil;
  double pop;           // largest boil / median boil, which counts as at least 0.001
  double largestMotion; // of a block, pixels; from half a wavelength on slides are ambiguous
};

// Throws std::invalid_argument for wrong clips (checkClip) and options, and where the visible area
// holds no block.
MotionMetrics measureMotion(const PatternClip& clip, const MotionMetricsOptions& options = {});

} // namespace hachure

#endif

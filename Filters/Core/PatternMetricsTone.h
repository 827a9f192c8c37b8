// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetricsTone_h
#define hachure_PatternMetricsTone_h

#include "PatternMetrics.h"

// How much ink there is: what correlations do not see.
namespace hachure
{

// Deviation of the ink over the usable pixels (usablePixels) of every frame that has a motion; 0
// without any.
std::vector<double> inkDeviations(const PatternClip& clip, double minimumFacing);
// Deviation of all pixels of an image.
double inkDeviation(const ImageView& image);

// The cell of the object that is seen at each pixel, the same number in all frames; 0 and below:
// none.
struct LabelView
{
  int width = 0;
  int height = 0;
  Span<const std::int32_t> values;
};

// Deviation over time of the mean ink of a cell, mean over the cells. A cell counts in the frames
// where it covers at least `minimumPixels`, and only if these are at least two. NaN without such a
// cell. Throws std::invalid_argument for wrong images.
double toneFlicker(
  Span<const ImageView> frames, Span<const LabelView> labels, int minimumPixels = 16);

struct ToneError
{
  double largest; // of |ink - tone|, both as means over a Gaussian window
  double drop;    // how much ink falls where tone grows, at most; 0 = monotone
};

// Windows have a deviation of 1.5 wavelengths (pixels, 1 to 1000). Pixels with a negative or NaN
// tone are outside, windows that lie outside by more than 1 % are left out. Throws
// std::invalid_argument for wrong images and where no window is inside.
ToneError measureTone(const ImageView& ink, const ImageView& tone, double wavelength);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetricsFlatness_h
#define hachure_PatternMetricsFlatness_h

#include "PatternMetrics.h"

#include <complex>
#include <functional>

// Does the pattern look flat, as drawn on paper? The frequency of the pattern in square windows is
// compared with how the surface is turned and how far it is away.
namespace hachure
{

// Replaces n values by their discrete Fourier transform, forward and not scaled. Called from
// several threads at a time.
using FourierTransform = std::function<void(std::vector<std::complex<double>>&)>;

struct FlatnessOptions
{
  int window = 64;            // side of the windows, pixels, 16 to 1024; they overlap by half
  double minimumFacing = 0.3; // n.v, 0 to 1; windows that hold steeper surface are left out
};

struct FlatnessMetrics
{
  // Slope of log2 frequency against log2 1/(n.v), over windows: 0 = flat, 1 = compressed like the
  // surface. NaN without `facing` or where all of it is turned alike.
  double facingSlope;
  // Slope of the mean log2 frequency of a frame against log2 distance: 0 = flat, 1 = the pattern
  // shrinks like the surface. NaN without `distance` or where it does not change.
  double distanceSlope;
  std::vector<double> frequencies; // geometric mean per frame, periods per pixel; NaN: no window
  int windows;                     // in all frames together
};

// Frames that have a motion are measured. Throws std::invalid_argument for wrong clips (checkClip)
// and options.
FlatnessMetrics measureFlatness(
  const PatternClip& clip, const FourierTransform& transform, const FlatnessOptions& options = {});

// Mean frequency of an image, periods per pixel; NaN without contrast. The image is square and
// tapered towards its border (Hann). Frequencies are weighted by squared power: with power as the
// weight, the harmonics of hard edges, which the pixels cut off, hide a quarter of every change.
double spectralCentroid(const ImageView& image, const FourierTransform& transform);

} // namespace hachure

#endif

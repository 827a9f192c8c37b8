// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetricsCooccurrence_h
#define hachure_PatternMetricsCooccurrence_h

#include "PatternMetrics.h"

// Is the pattern in the picture the pattern that was drawn on paper? Grey-level co-occurrence
// matrices (Haralick, Shanmugam and Dinstein 1973) say how often two tones of ink stand at a given
// distance; they tell apart stretched, scaled, blurred and different textures, and have been used
// to judge what motion and perspective do to stylised ones (Benard et al. 2009, 2010).
//
// Here ink is smoothed and spread over eight levels; a value between two of them counts for both,
// in parts, so that a small change of ink makes a small change of the matrices. There is one matrix
// for each of the distances 1/4, 1/2, 3/4 and 1 wavelength, over all pairs of pixels that far apart
// in 16 directions, half a turn in equal steps. As directions and places are summed over, a
// pattern that is shifted or turned has the same matrices; one that is stretched or scaled has not.
namespace hachure
{

struct CooccurrenceOptions
{
  double wavelength = 8.0;    // of the pattern, pixels; 3 to 1000
  double minimumFacing = 0.3; // n.v, 0 to 1; steeper surface is left out
  double smoothing = 1.0;     // deviation of the Gaussian before, pixels; 0 to 10
};

// Errors are the mean over the distances of 1/2 sum |P - Q|, the total variation between the
// normalised matrices of the clip and of the reference: 0 for the same pattern, at most 1. What is
// seen of a random pattern never has quite the matrices of all of it, hence an error that falls
// with the root of the number of marks in sight. NaN where no pair of pixels is in sight.
struct CooccurrenceMetrics
{
  double error;               // of all frames that have a motion together
  std::vector<double> frames; // of each of them
};

// The reference is the pattern as drawn flat on paper: same size of marks, same tone, ink on all of
// it. Work is linear in pixels. Throws std::invalid_argument for wrong clips (checkClip), options
// and references, which must be three wavelengths wide and high, apart from a border.
CooccurrenceMetrics measureCooccurrence(
  const PatternClip& clip, const ImageView& reference, const CooccurrenceOptions& options = {});

} // namespace hachure

#endif

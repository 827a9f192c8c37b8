// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetricsStipples_h
#define hachure_PatternMetricsStipples_h

#include "Span.h"

#include <glm/glm.hpp>

#include <vector>

// How evenly points in the plane are spread (Ulichney 1987; Clark and Evans 1954). The principal
// frequency is the square root of the density.
namespace hachure
{

struct StippleWindow
{
  glm::dvec2 origin{ 0.0 };
  glm::dvec2 size{ 1.0 }; // > 0
  bool periodic = true;   // else distances are corrected for the edge (Donnelly 1978)
};

// A ring of frequencies around 0.
struct SpectrumRing
{
  double frequency;  // middle, in principal frequencies
  double power;      // mean, 1 for white noise
  double anisotropy; // decibels: variance / mean^2 within the ring, 0 for isotropic points
  int count;         // frequencies in the ring, those that repeat by symmetry counted once
};

struct StippleMetrics
{
  std::vector<SpectrumRing> rings; // from 0 to two principal frequencies, an eighth of one wide
  double lowFrequencyPower;        // mean power below half the principal frequency
  double meanPower;                // up to two principal frequencies
  double anisotropy;               // decibels, over 0.5 to 2 principal frequencies
  double clarkEvans;               // R: mean distance to the nearest, 1 = white noise
  double relativeRadius;           // rho: smallest distance / that of a triangular lattice
};

// Work and memory grow with the square and with the number of points. Throws std::invalid_argument
// for a wrong window, fewer than 16 or more than 100000 points, and points that are not finite or
// outside the window.
StippleMetrics measureStipples(Span<const glm::dvec2> points, const StippleWindow& window);

// Mean over sets of points of equal kind: powers and distances as means, anisotropy from the mean
// ratio. Not empty.
StippleMetrics meanOfStipples(Span<const StippleMetrics> sets);

// |A and B| / min(|A|, |B|): 1 if the smaller set is part of the larger. The points at exactly
// equal places are shared. 1 if one is empty.
double nesting(Span<const glm::dvec2> first, Span<const glm::dvec2> second);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SampleFeatures_h
#define hachure_SampleFeatures_h

#include "SampleProjection.h"
#include "Span.h"

#include <array>
#include <cstdint>
#include <vector>

// How much the surroundings of each sample draw the eye: sliding of a pattern is noticed on hills
// and edges, hardly on a featureless plain (Breslav et al. 2007, section 4, name weights by such
// features as future work). A strength is any number of 0 or more; only its ratio to the others of
// the patch counts, so that strengths do not change with the size of the model.
namespace hachure
{

// Indices of the nearest samples, -1 where there are fewer.
using SampleNeighbours = std::array<std::int32_t, 8>;

// The nearest samples of the same patch within two spacings, without those of the other side of a
// thin sheet. Throws as projectSamples does.
std::vector<SampleNeighbours> nearestSamples(const TrackedSamples& samples);

// Root mean square distance between the unit normal of a sample and those of its neighbours: for
// small angles the angle in radians, hence curvature times spacing. Throws std::invalid_argument
// where the numbers of elements differ.
std::vector<double> normalVariation(
  Span<const glm::dvec3> normals, Span<const SampleNeighbours> neighbours);

// Root mean square difference between the value of a sample and those of its neighbours.
std::vector<double> localContrast(
  Span<const double> values, Span<const SampleNeighbours> neighbours);

// Factors of the samples' weights (TrackedSamples::features): strength / mean strength of the patch
// + 0.01. The last term lets patches follow where nothing that stands out is in sight. 1 in patches
// whose mean is at most `negligible`. Throws std::invalid_argument on strengths that are negative
// or not finite, and where `patches` (empty = all 0) has another number of elements.
std::vector<double> featureFactors(
  Span<const double> strengths, Span<const std::int32_t> patches, double negligible);

} // namespace hachure

#endif

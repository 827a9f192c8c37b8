// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SampleWeights_h
#define hachure_SampleWeights_h

#include "PatchRuns.h"
#include "SampleProjection.h"
#include "Similarity.h"
#include "Span.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

// How much each sample of a frame counts. The weights of a frame depend on that frame alone.
namespace hachure
{

enum class WeightScheme : std::uint8_t
{
  Symmetric, // geometric mean of both frames' weights (default)
  Classic,   // the paper's: the current frame's weight, 0 where the previous one was 0
  Unweighted // 1 where visible in both frames, 0 elsewhere
};

// By facing alone, of samples projected with FrontOnly or Signed. 0 or 1 where unweighted.
std::vector<double> facingWeights(const ProjectedSamples& samples, WeightScheme scheme);

// By facing and visibility, 0 to 255, of samples projected with Signed. The visibility of a sample
// outside the picture cannot be measured: there the front sides count, as everywhere where
// `visibility` is empty because it is not known. The unweighted scheme counts a sample from half
// visible on. The weights are written into the memory of a frame before.
void weighSamples(const ProjectedSamples& samples, glm::dvec2 viewportSize,
  Span<const std::uint8_t> visibility, WeightScheme scheme, std::vector<double>& weights);

// The sum of those above 0.
double positiveSum(Span<const double> weights);

// Per patch, the weight of the front sides in sight.
std::vector<double> frontWeights(const ProjectedSamples& samples, const PatchRuns& patches);

// Where patterns begin: an upright frame of scale 1 at the weighted centroid of the front sides in
// sight, or of everything where there is none. It is the same for all patches, so that their
// patterns begin as one and no border shows before the patches have moved differently.
PatternFrame anchorPattern(const ProjectedSamples& samples);

} // namespace hachure

#endif

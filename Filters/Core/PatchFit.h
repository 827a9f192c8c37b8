// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatchFit_h
#define hachure_PatchFit_h

#include "SampleProjection.h"
#include "Similarity.h"
#include "Span.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

// The similarity transforms of all patches of a surface between two frames, from the same samples
// in both.
namespace hachure
{

enum class WeightScheme : std::uint8_t
{
  Symmetric, // geometric mean of both frames' weights (default)
  Classic,   // the paper's: the current frame's weight, 0 where the previous one was 0
  Unweighted // 1 where visible in both frames, 0 elsewhere
};

// One frame: positions and weights of the samples. The weights of `samples` themselves are not
// read.
struct WeightedFrame
{
  Span<const ProjectedSample> samples;
  Span<const double> weights;
};

struct PatchFits
{
  std::vector<double> weights;         // per sample, common to both frames
  std::vector<SimilarityFit> fits;     // per patch
  std::vector<double> previousWeights; // per patch, sum over the previous frame
  std::vector<double> currentWeights;  // per patch, sum over the current frame
};

// Throws std::invalid_argument on arrays of different sizes and patches outside [0, patchTotal).
PatchFits fitPatches(const WeightedFrame& previous, const WeightedFrame& current,
  Span<const std::int32_t> patches, std::size_t patchTotal, WeightScheme scheme);

// Fills the residuals of the fits, which need the transforms: a second pass over the samples.
void measureResiduals(PatchFits& fits, const WeightedFrame& previous, const WeightedFrame& current,
  Span<const std::int32_t> patches);

// Weights by facing alone, of samples projected with FrontOnly or Signed. 0 or 1 where unweighted.
std::vector<double> facingWeights(Span<const ProjectedSample> samples, WeightScheme scheme);

// Where patterns begin: an upright frame of scale 1 at the weighted centroid of the front sides in
// sight, or of everything where there is none. It is the same for all patches, so that their
// patterns begin as one and no border shows before the patches have moved differently.
struct PatternAnchors
{
  std::vector<PatternFrame> frames;
  std::vector<double> frontWeights; // per patch, 0 where no front is in sight
};

PatternAnchors anchorPatterns(
  Span<const ProjectedSample> samples, Span<const std::int32_t> patches, std::size_t patchTotal);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatchFit_h
#define hachure_PatchFit_h

#include "PatchRuns.h"
#include "SampleProjection.h"
#include "SampleWeights.h"
#include "Similarity.h"
#include "Span.h"

#include <vector>

// The similarity transforms of all patches of a surface between two frames, from the same samples
// in both.
namespace hachure
{

// One frame: positions and weights of the samples. The weights of `samples` themselves are not
// read.
struct WeightedFrame
{
  const ProjectedSamples& samples;
  Span<const double> weights;
};

struct PatchFits
{
  std::vector<SimilarityFit> fits;     // per patch
  std::vector<double> previousWeights; // per patch, sum over the previous frame
  std::vector<double> currentWeights;  // per patch, sum over the current frame
};

// Throws std::invalid_argument on arrays of different sizes.
PatchFits fitPatches(const WeightedFrame& previous, const WeightedFrame& current,
  const PatchRuns& patches, WeightScheme scheme);

// How far the pattern of a patch slid over some of its samples.
struct PatchResidual
{
  double residual = 0.0; // weighted mean in pixels, 0 where no sample counts
  double weight = 0.0;   // of the samples that count, common to both frames of the step
};

// Per patch. It needs the transforms: a second pass over the samples. Throws as fitPatches does.
std::vector<PatchResidual> measureResiduals(Span<const SimilarityFit> fits,
  const WeightedFrame& previous, const WeightedFrame& current, const PatchRuns& patches,
  WeightScheme scheme);

} // namespace hachure

#endif

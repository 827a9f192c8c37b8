// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceSampling_h
#define hachure_SurfaceSampling_h

#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace hachure
{
/// Called on the caller's thread with the finished fraction in [0, 1]; returning false stops the
/// work, and the function then returns an empty result.
using ProgressFn = std::function<bool(double fraction)>;

struct SamplingOptions
{
  /// Samples wanted on every patch, at least 1. Several hundred are enough for a similarity fit
  /// (Breslav et al. 2007, section 3.1).
  int samplesPerPatch = 500;
  /// Least distance between two samples of a patch, as a fraction of the patch's spacing, in
  /// [0, 1]. Samples that cannot keep it are left out. Default of the authors of Breslav et al.
  double minimumDistance = 0.35;
  /// Places tried for every sample, at least 1; the one farthest from the samples that are already
  /// there is taken. 1 gives plain stratified noise, more a more even distribution.
  int regularity = 20;
  std::uint32_t seed = 1;
  ProgressFn progress;
};

/// Samples ordered by patch id; within a patch along a space-filling curve.
struct SurfaceSamples
{
  std::vector<std::int32_t> triangles;
  std::vector<glm::dvec3> barycentrics; ///< each >= 0, their sum is 1
  std::vector<std::int32_t> patches;
  /// Number of the sample's stratum within its patch, in [0, samplesPerPatch). With the patch id it
  /// names a sample whatever happens on other patches.
  std::vector<std::int32_t> strata;
  /// Mean distance of neighbouring samples in model units, sqrt(patch area / samplesPerPatch);
  /// the index is the patch id. 0 for ids without surface.
  std::vector<double> patchSpacing;
};

/// Largest patch id plus one that sampleSurface accepts (patchSpacing is indexed by the id).
constexpr std::int32_t maximumPatchCount = 1 << 24;

/// Spreads samples evenly over every patch, independently of its triangulation. Throws
/// std::invalid_argument for a bad mesh or option.
SurfaceSamples sampleSurface(const TriangleMesh& mesh, const SamplingOptions& options = {});
} // namespace hachure

#endif

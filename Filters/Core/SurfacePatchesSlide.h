// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfacePatchesSlide_h
#define hachure_SurfacePatchesSlide_h

#include "SampleProjection.h"
#include "SurfacePatches.h"

#include <cstdint>
#include <vector>

// How far patterns will slide over the patches of a surface along a camera path: the residual of
// the similarity transform from every view to the next, as vtkSimilarityTracker reports it. What
// hides a part of the surface is not known here; only faces turned away count as hidden.
namespace hachure
{
struct SlideOptions
{
  double maximumSlide = 1.0; ///< pixels per step of the path, above 0
  int maximumPatches = 256;  ///< at least 1: no patch is split once there are so many
  int samplesPerPatch = 300; ///< several hundred (Breslav et al. 2007, section 3.1)
  CompactOptions compact;    ///< how a patch is divided in two
};

/// The largest slide on any step of the path in pixels, per patch. Patches are given per face and
/// run from 0 on; negative ones are no patches. Throws std::invalid_argument on fewer than two
/// views, views that are not valid and bad options.
std::vector<double> predictSlides(const FaceSurface& surface, Span<const std::int32_t> patches,
  Span<const ViewProjection> views, const SlideOptions& options);

struct SlideSplit
{
  std::vector<std::int32_t> patches; ///< per face, numbered by lowest face
  std::vector<double> slides;        ///< per patch
};

/// Divides the patch that slides most in two until none slides more than the limit, until there are
/// as many patches as allowed or until those that slide are single faces. Throws as predictSlides.
/// The result is empty when `compact.progress` stopped the work.
SlideSplit splitSlidingPatches(const FaceSurface& surface, Span<const std::int32_t> patches,
  Span<const ViewProjection> views, const SlideOptions& options);
} // namespace hachure

#endif

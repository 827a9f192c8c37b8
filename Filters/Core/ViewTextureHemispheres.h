// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureHemispheres_h
#define hachure_ViewTextureHemispheres_h

#include "HemisphereTable.h"
#include "SurfaceSampling.h"
#include "ViewCellColors.h"
#include "ViewTextureSurface.h"

#include <glm/gtc/type_precision.hpp>

#include <vector>

namespace hachure
{

// A view that is seen from some directions.
struct DependentView
{
  const TextureView* view = nullptr;
  const ViewCellColors* colors = nullptr;
};

struct HemisphereOptions
{
  bool propagateUp = true;
  // The share of what is seen from some directions includes the views' shares of depth, as in the
  // paper. Then a view is mixed with what is seen from everywhere even where its own camera is.
  bool classicShares = false;
};

// What is seen of a surface from some directions (Grimm and Kowalski 2002, section 6): bytes as
// ViewTextureColors has them, of all nodes' hemispheres. Empty if the progress function stopped
// the work.
//
// Views that see a cell at a level are mixed in every direction by mask, share of depth and fade.
// Cells that none of them sees have the views' colours of neighbours, see spreadRings(). A
// direction without a colour takes the mean of those of the next finer level, and last, if
// propagateUp, the mixture of the level below, if no view is to be seen there, masked or not, at
// its or a finer level. So nothing of what is seen from everywhere comes in.
std::vector<glm::u8vec4> viewTextureHemispheres(const ViewTextureSurface& surface,
  const HemisphereTable& table, Span<const DependentView> views, const HemisphereOptions& options,
  const ProgressFn& progress = {});

} // namespace hachure

#endif

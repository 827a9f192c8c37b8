// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureBase_h
#define hachure_ViewTextureBase_h

#include "SurfaceSampling.h"
#include "ViewCellColors.h"
#include "ViewTextureSurface.h"

#include <glm/vec4.hpp>

#include <vector>

namespace hachure
{

// What is seen of a surface from everywhere (Grimm and Kowalski 2002, section 6): at the nodes of
// all levels linear colours, not times alpha, and alpha: 1, 0 where nothing is known, between at
// corners of which only some cells are known. Where nothing is known the colour is gray, 0.5 in
// sRGB. From the views given, of which none is null.
//
// Views that see a cell at a level are mixed by their masks and shares of depth. Cells that none
// sees take the mean of neighbours, see spreadRings(); a cell that is seen where the mask is 0 has
// no colour, and takes none from neighbours. Then what has no colour takes the mean of those of the
// next finer level, and last, if propagateUp, cells without any take the mixture of the level
// below; where masks have left nothing only of views that have no finer level themselves.
//
// Empty if the progress function stopped the work.
std::vector<glm::vec4> viewTextureBase(const ViewTextureSurface& surface,
  Span<const ViewCellColors* const> views, bool propagateUp, const ProgressFn& progress = {});

} // namespace hachure

#endif

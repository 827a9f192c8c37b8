// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureViewInput_h
#define hachure_TextureViewInput_h

#include "Core/SurfaceCells.h"
#include "Core/TextureView.h"
#include "Core/ViewTexture.h"
#include "HachureFiltersModule.h" // for the export macro

#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

class vtkTextureViews;

namespace hachure
{

/// A view as the algorithms take it. Extreme points of one that is given by a matrix lie about the
/// point on its axis that is nearest to `center`, of the surface.
HACHUREFILTERS_EXPORT TextureView textureView(
  vtkTextureViews* views, int view, const glm::dvec3& center);

/// Its picture, masked: sRGB with straight alpha, rows from the bottom up.
HACHUREFILTERS_EXPORT std::vector<glm::u8vec4> texturePixels(vtkTextureViews* views, int view);

/// The cells that the views ask for, with levels as long as their colours take no more than a
/// number of MiB.
HACHUREFILTERS_EXPORT SurfaceCellOptions surfaceCellOptions(
  vtkTextureViews* views, int memoryBudget);

HACHUREFILTERS_EXPORT ViewTextureOptions viewTextureOptions(
  vtkTextureViews* views, bool propagateUp, bool classicShares);

/// How much a camera sees of what is seen from everywhere, by the blend points; 0 without any.
/// Cameras without perspective are where their near plane is. center: of the surface.
HACHUREFILTERS_EXPORT double independentShare(
  vtkTextureViews* views, const glm::dmat4& modelToClip, const glm::dvec3& center);

} // namespace hachure

#endif

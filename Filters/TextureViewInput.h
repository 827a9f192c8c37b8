// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureViewInput_h
#define hachure_TextureViewInput_h

#include "Core/TextureView.h"
#include "HachureFiltersModule.h" // for the export macro

#include <glm/gtc/type_precision.hpp>
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

} // namespace hachure

#endif

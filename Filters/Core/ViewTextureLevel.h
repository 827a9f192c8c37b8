// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureLevel_h
#define hachure_ViewTextureLevel_h

#include "TriangleMesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace hachure
{

// The level of detail of a whole surface in a picture (Grimm and Kowalski 2002, section 4.2): that
// of the mean size of its cells there. Both sides count, and what lies outside the picture or is
// hidden counts too, so that it does not jump where something comes into view; what lies behind the
// viewer does not. cellArea: of a cell of level 0; pictureSize: in pixels. 0 where nothing counts.
double levelOfSurface(const TriangleMesh& mesh, const glm::dmat4& modelToClip,
  const glm::dvec2& pictureSize, double cellArea);

} // namespace hachure

#endif

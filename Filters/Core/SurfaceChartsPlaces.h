// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsPlaces_h
#define hachure_SurfaceChartsPlaces_h

#include "SurfaceChartsCollapse.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace hachure
{

// Internal: where a triangle of the fine mesh lies.
struct TrianglePlace
{
  std::int32_t triangle = -1; // of the base mesh; -1: none
  std::array<glm::vec2, 3> corners{};
  bool isClamped = false; // a corner lies too far away to be reached across rims
};

// Of three vertices of the mesh that was simplified. Its corners' places continue over the rims of
// base triangles as weightsAcross() says, from one to the other by as few rims as possible: the
// same ones from both sides of an edge of the fine mesh.
TrianglePlace placeTriangle(const BaseMesh& base, const glm::ivec3& vertices);

} // namespace hachure

#endif

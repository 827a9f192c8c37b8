// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsPlaces_h
#define hachure_SurfaceChartsPlaces_h

#include "SurfaceChartsCollapse.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace hachure
{

// Internal: places on a base mesh, also of what lies on other triangles of it: coordinates continue
// over rims as weightsAcross() says, from one triangle to another by as few rims as possible; by
// the same ones for all and both ways. Empty where it is too far, or over a border.
std::optional<glm::dvec3> weightsUnfolded(
  const BaseMesh& base, const glm::dvec3& weights, std::int32_t from, std::int32_t to);
// Of a vertex of the fine mesh.
std::optional<glm::dvec3> vertexWeightsIn(
  const BaseMesh& base, std::int32_t triangle, std::int32_t vertex);

// Of a place beyond the edge opposite to a corner: its weights across.
glm::dvec3 weightsBeyond(const BaseMesh& base, const glm::dvec3& weights, std::int32_t corner);

// Where a triangle of the fine mesh lies.
struct TrianglePlace
{
  std::int32_t triangle = -1; // of the base mesh; -1: none
  std::array<glm::vec2, 3> corners{};
  bool isClamped = false; // a corner lies too far away to be reached across rims
};

// Of three vertices of the fine mesh.
TrianglePlace placeTriangle(const BaseMesh& base, const glm::ivec3& vertices);

} // namespace hachure

#endif

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
// over rims as weightsAcross() says, here over those that the straight line between two places
// crosses, which are the same both ways. Empty where it is too far, or over a border.
//
// Of a place on the triangle `from`: its weights in the triangle `to`, as seen from a place there.
std::optional<glm::dvec3> weightsUnfolded(const BaseMesh& base, const glm::dvec3& weights,
  std::int32_t from, std::int32_t to, const glm::dvec3& seenFrom);
// Of a vertex of the fine mesh in a triangle.
std::optional<glm::dvec3> vertexWeightsIn(
  const BaseMesh& base, std::int32_t vertex, std::int32_t triangle, const glm::dvec3& seenFrom);

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

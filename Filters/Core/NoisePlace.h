// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoisePlace_h
#define hachure_NoisePlace_h

#include "NoiseProjection.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hachure
{

// A triangle of a surface where it is now.
struct NoisePlace
{
  glm::dvec3 origin, u, v; // first corner, and the edges to the second and third
  glm::dvec3 normal;       // of unit length; 0 without area
  double area;             // now

  NoisePlace(const NoiseSurface& surface, const NoiseFacet& facet);

  glm::dvec3 at(const glm::dvec2& weights) const
  {
    return this->origin + weights.x * this->u + weights.y * this->v;
  }
  // A direction in the plane as multiples of the edges: it stays in the surface where that deforms.
  glm::dvec2 inEdges(const glm::dvec3& direction) const;
  // The same in space, of unit length.
  glm::dvec3 fromEdges(const glm::dvec2& edges) const;
};

// The kernel of a point of this surface's facet whose direction, in edges, is to it what the first
// edge is to the facet's own points. False where it has none.
bool makeCarriedKernel(const NoiseSurface& surface, const NoiseProjection& projection,
  const NoiseFacet& facet, const NoisePoint& point, const glm::dvec2& direction,
  NoiseKernel& kernel);

} // namespace hachure

#endif

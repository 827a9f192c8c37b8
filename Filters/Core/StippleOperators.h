// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleOperators_h
#define hachure_StippleOperators_h

#include "StippleHierarchy.h"
#include "StippleParticles.h"
#include "StippleProjection.h"
#include "StippleSurface.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// Where a vertex of the particle mesh is on the surface.
struct StippleFoothold
{
  std::int32_t triangle = 0; // of StippleSurface::triangles
  bool isOnBorder = false;
};

// The randomise and the projection operator (section 2.4 of the paper).
class StippleOperators
{
public:
  StippleOperators(const StippleSurface& surface, const StippleOptions& options);

  // Where a vertex goes, and its foothold with it: to a random place in one of the triangles around
  // it, and back to the surface. On a border: along the border, and back to it. With a straight
  // border on both sides it stays on it exactly; sharp corners of a border stay.
  glm::dvec3 move(
    const StippleParticles& particles, std::int32_t vertex, StippleFoothold& foothold) const;

  StipplePoint pointAt(const glm::dvec3& place, const StippleFoothold& foothold) const;

private:
  glm::dvec3 randomise(const StippleParticles& particles, std::int32_t vertex,
    const std::vector<std::int32_t>& around, double size) const;
  glm::dvec3 moveOnBorder(const StippleParticles& particles, std::int32_t vertex,
    const std::vector<std::int32_t>& around, StippleFoothold& foothold) const;
  glm::dvec3 project(const glm::dvec3& place, const glm::dvec3& normal, double reach,
    StippleFoothold& foothold) const;
  bool keepsSides(const StippleParticles& particles, std::int32_t vertex,
    const std::vector<std::int32_t>& around, const glm::dvec3& place) const;
  double share(std::int32_t vertex, std::uint32_t dimension) const;

  const StippleSurface& surface;
  const StippleOptions& options;
  StippleTree faces, borders;
};

// The other ends of the border at a vertex.
std::vector<std::int32_t> borderNeighbours(const StippleParticles& particles, std::int32_t vertex);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleClassic_h
#define hachure_StippleClassic_h

#include "StippleHierarchy.h"
#include "StippleParticles.h"
#include "StippleSurface.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// The order in which edge collapses take vertices away, with the neighbours they then have.
struct StippleCollapses
{
  std::vector<std::int32_t> gone;       // vertices, the first gone first
  std::vector<std::uint32_t> first;     // of the neighbours; one more than vertices are gone
  std::vector<std::int32_t> neighbours; // vertices
  std::vector<glm::ivec3> triangles;    // when there are no more than `wanted` vertices
};

// Collapses edges, the shortest first, until none is left that can be: a border stays a border, and
// where more than two triangles meet vertices stay. progress: of 0 to 1; if it returns false, what
// has been done so far.
StippleCollapses collapseEdges(
  StippleParticles particles, std::int64_t wanted, std::uint32_t seed, const ProgressFn& progress);

// Everything but area and size. Empty if the progress function stopped it.
StippleHierarchy classicStipples(const StippleSurface& surface, const StippleOptions& options);

} // namespace hachure

#endif

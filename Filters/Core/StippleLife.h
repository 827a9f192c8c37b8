// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleLife_h
#define hachure_StippleLife_h

#include "StippleHierarchy.h"

#include <cstdint>
#include <vector>

// Stipples of a surface that is replaced by others with other triangles, again and again: what can
// stay stays, what comes grows and what goes shrinks over a number of such changes.
namespace hachure
{

struct LivingStipples
{
  StippleHierarchy hierarchy;        // of the surface
  std::vector<float> shares;         // of every stipple's full area, 0 to 1; empty: all are grown
  std::vector<StipplePoint> leaving; // stipples of surfaces before, where they are on this one
  std::vector<double> leavingDensities; // in points per area, at which they came in
  std::vector<float> leavingShares;
};

// Those of the next surface. before: on `mesh`, as it was last. life: changes over which stipples
// grow and shrink, 1 or more; with 1 they do at once. reach: as carryStipples has it. Throws as
// carryStipples does, and for a life below 1.
LivingStipples carryLiving(const TriangleMesh& mesh, const LivingStipples& before,
  const TriangleMesh& nextMesh, int life, const StippleOptions& options, double reach);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleTransfer_h
#define hachure_StippleTransfer_h

#include "StippleHierarchy.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// Stipples on a surface that is replaced by another one, with other triangles: the next isosurface,
// a blade that was meshed anew. Those that still fit stay, at about their density, so that few
// appear and vanish in a picture.
namespace hachure
{

// A stipple of the surface before.
struct CarriedStipple
{
  glm::dvec3 place{ 0.0 };
  glm::dvec3 normal{ 0.0 }; // of any length; 0: faces every way
  float spacing = 0.0f;     // as StipplePoint has it, 0 or more
};

// A progressive hierarchy on the mesh that has as many of the old points as have their place on it:
// - old points, which come by rank, go to the closest point of the mesh, if that does not face the
//   other way and is nearer than a half of their spacing or than `reach`: how far surfaces move, in
//   units of the mesh, 0 or more, such as the distance between two isosurfaces;
// - gaps are filled as in stippleSurface, but an old point may come in as soon as the new surface
//   has the density, in points per area, that the old one had at its rank: even where there is a
//   little less room for it than a new point would need. Where it does not fit it may later.
// oldArea: StippleHierarchy::area of the surface before. origins: for every point the index of the
// old one that it continues, or -1. moved, if wanted: every old point where it is on the new
// surface, kept or not, with its old spacing; in triangle -1 where it is nowhere. Without old
// points the result is that of stippleSurface.
//
// Throws std::invalid_argument as stippleSurface does, for StippleOrder::Classic, numbers that are
// not finite, spacings and a reach below 0 and, with old points, an area that is not above 0. The
// result does not depend on the number of threads.
StippleHierarchy carryStipples(const TriangleMesh& mesh, Span<const CarriedStipple> old,
  double oldArea, const StippleOptions& options, std::vector<std::int32_t>& origins,
  double reach = 0.0, std::vector<StipplePoint>* moved = nullptr);

// The points of a hierarchy on its mesh, to be carried to another one.
std::vector<CarriedStipple> carriedStipples(
  const TriangleMesh& mesh, const StippleHierarchy& hierarchy);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NearCells_h
#define hachure_NearCells_h

#include "CanonicalOrder.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

/// The cells that are not in a part but near its border, ascending: those with a corner at most
/// `distance` away from a place where cells of the part and others meet. Corners in the same place
/// meet, whether they are the same point or not. owned: of every cell, not 0 where it is in the
/// part. Throws std::invalid_argument where sizes differ, a corner is not a point, or the distance
/// is negative or not finite.
std::vector<std::int64_t> nearCells(Span<const glm::dvec3> points, const PolygonCells& cells,
  Span<const std::uint8_t> owned, double distance);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleTreeBase_h
#define hachure_StippleTreeBase_h

#include "StippleCube.h"
#include "StippleHierarchy.h"
#include "StippleNode.h"
#include "StippleShape.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// Points that an area as large as a side of a cube has before its level begins; up to four times as
// many. So a node of a flat surface has some 300 to 1200.
constexpr double leastPointsPerSquare = 100.0;

// Throws std::invalid_argument for points that are not on the shape, and more than there are ranks.
void checkBase(const StippleHierarchy& base, const StippleShape& shape);

// Whether the points are evenly spread over a known area in the order of their ranks.
bool hasEvenRanks(const StippleHierarchy& base, bool hasMesh);

// Of a checked base that has points; frame and bounds of the shape are set already.
void setDensities(StippleLevels& levels, const StippleHierarchy& base, bool hasMesh);

// Nodes with the points of a checked base, parents first, not yet placed. Also makes the nodes of
// the given cubes, whether they have points or not.
std::vector<StippleNode> makeBaseNodes(const StippleHierarchy& base, const StippleShape& shape,
  const StippleLevels& levels, const std::vector<std::uint64_t>& cubes);

// Enters the node among the children of its parent.
void linkChild(std::vector<StippleNode>& nodes, std::int32_t child);

} // namespace hachure

#endif

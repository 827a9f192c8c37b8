// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StipplePlacing_h
#define hachure_StipplePlacing_h

#include "StippleCube.h"
#include "StippleNode.h"
#include "StippleShape.h"

#include <vector>

namespace hachure
{

// Makes the arrays of the node for where the shape is now, from its places and densities on the
// reference, and its own bounds and densities.
void placePoints(StippleNode& node, const StippleShape& shape, const StippleLevels& levels);

// A node without points, below which there may be some, has the bounds of its parent's points
// unless its cube is known to hold all, and the cone of their normals. For the parent's own bounds
// made.
void inheritBounds(const std::vector<StippleNode>& nodes, StippleNode& node);

// Bounds and least density of the node, from its own and those of its children.
void gatherBounds(std::vector<StippleNode>& nodes, StippleNode& node);

// All of this for all nodes. A node comes after its parent.
void placeAllPoints(
  std::vector<StippleNode>& nodes, const StippleShape& shape, const StippleLevels& levels);

} // namespace hachure

#endif

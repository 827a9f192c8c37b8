// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleFilling_h
#define hachure_StippleFilling_h

#include "StippleCube.h"
#include "StippleNode.h"
#include "StippleTriangles.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// What a cube is filled with, and around. Lengths are in sides of the cube, from its middle.
struct StippleFilling
{
  // How far around the cube points matter, in sides of the cube; at most 1.
  static double reachAround(const StippleLevels& levels, std::int32_t level);

  // A point that is there.
  struct Given
  {
    glm::vec3 place;
    glm::vec3 normal;
    float room; // that it had when it came in; infinite for those of coarser levels
  };
  struct Point
  {
    StipplePlace place;
    double density; // scaled
  };

  StippleCube cube;
  std::uint32_t seed = 1;
  std::vector<Given> given; // all up to reachAround(), with those of neighbours that are filled
  // Neighbours that are filled already. Bit (x + 1) + 3 (y + 1) + 9 (z + 1).
  std::uint32_t filled = 0;

  // The points of the cube for its level, by density. A neighbour that is not filled yet is filled
  // for a time only, as far as it matters.
  std::vector<Point> fill(const StippleTriangles& triangles, const StippleLevels& levels) const;

  // Radius of the widest gaps between so many points; scaled, as the following.
  static double gapFor(double density);
  // Room of a point that comes in at the density, at a level that begins at the least one.
  static double roomFor(double density, double least);
};

} // namespace hachure

#endif

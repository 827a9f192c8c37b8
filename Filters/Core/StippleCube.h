// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCube_h
#define hachure_StippleCube_h

#include "StippleCells.h"
#include "StippleSurface.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace hachure
{

// One of the 8^level cubes of a level, in scaled space (StippleFrame): that of level 0 has the side
// 1 and its middle in the origin.
struct StippleCube
{
  // A code has three bits for each level, and one more.
  static constexpr std::int32_t mostLevel = 20;

  std::int32_t level = 0;
  glm::ivec3 cell{ 0 }; // from the low corner, 0 to 2^level - 1

  static StippleCube fromCode(std::uint64_t code)
  {
    StippleCube cube;
    while (code >> (3 * (cube.level + 1)) != 0)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        cube.cell[axis] |= static_cast<int>(code >> (3 * cube.level + axis) & 1u) << cube.level;
      }
      ++cube.level;
    }
    return cube;
  }
  static StippleCube around(const glm::dvec3& place, std::int32_t level)
  {
    const int count = 1 << level;
    const glm::dvec3 cell = glm::floor((place + 0.5) * static_cast<double>(count));
    return { level, glm::clamp(glm::ivec3(cell), glm::ivec3(0), glm::ivec3(count - 1)) };
  }
  std::uint64_t code() const
  {
    return StippleGrid::name(this->cell) | std::uint64_t{ 1 } << (3 * this->level);
  }
  double side() const { return std::ldexp(1.0, -this->level); }
  glm::dvec3 low() const { return glm::dvec3(this->cell) * this->side() - 0.5; }
  StippleCube parent() const { return { this->level - 1, this->cell / 2 }; }
  StippleCube child(int index) const
  {
    return { this->level + 1,
      2 * this->cell + glm::ivec3(index & 1, index >> 1 & 1, index >> 2 & 1) };
  }
  // Where it is among the children of its parent.
  int childIndex() const
  {
    return (this->cell.x & 1) | (this->cell.y & 1) << 1 | (this->cell.z & 1) << 2;
  }
  bool isInside() const
  {
    const int count = 1 << this->level;
    return this->cell.x >= 0 && this->cell.y >= 0 && this->cell.z >= 0 && this->cell.x < count &&
      this->cell.y < count && this->cell.z < count;
  }
};

// Which densities are at which level, in scaled space: a level has those above leastDensity(level)
// and up to four times as much.
struct StippleLevels
{
  StippleFrame frame;
  glm::dvec3 low{ 0.0 }, high{ 0.0 }; // of the reference, in units of the mesh
  double baseDensity = 0.0;           // of all points of the base
  std::int32_t firstRefined = 1;      // level at which the base ends
  std::int32_t lastLevel = -1;        // that can be refined to; -1: none

  double leastDensity(std::int32_t level) const
  {
    return std::ldexp(this->baseDensity, 2 * (level - this->firstRefined));
  }
  double inUnitsOfMesh(double density) const
  {
    return density / (this->frame.size * this->frame.size);
  }
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCells_h
#define hachure_StippleCells_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

// Cubic cells of space of which only those are kept that have something in them, for places within
// the unit cube around the origin.
namespace hachure
{

// The cell of a place, and its name: its Morton number, so that cells in the order of their names
// are near each other.
class StippleGrid
{
public:
  explicit StippleGrid(double cellSide)
    : scale(1.0 / cellSide)
  {
  }
  glm::ivec3 cellOf(const glm::vec3& place) const
  {
    // Cut off, which is floor for what is above 0, but no call of a function.
    constexpr double half = 1 << 20;
    return glm::ivec3(glm::dvec3(place) * this->scale + half);
  }
  std::uint64_t nameOf(const glm::vec3& place) const { return name(this->cellOf(place)); }
  static std::uint64_t name(const glm::ivec3& cell)
  {
    return spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
  }
  // Calls visit(name) for the cell and the 26 around it.
  template <class Visit>
  static void visitBlock(const glm::ivec3& cell, Visit&& visit)
  {
    std::uint64_t names[3][3];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int step = 0; step < 3; ++step)
      {
        names[axis][step] = spread(cell[axis] + step - 1) << axis;
      }
    }
    for (int i = 0; i < 27; ++i)
    {
      visit(names[0][i % 3] | names[1][i / 3 % 3] | names[2][i / 9]);
    }
  }

private:
  // The 21 lowest bits, two places apart.
  static std::uint64_t spread(int value)
  {
    std::uint64_t bits = static_cast<std::uint32_t>(value) & 0x1fffffu;
    bits = (bits | bits << 32) & 0x001f00000000ffffull;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffull;
    bits = (bits | bits << 8) & 0x100f00f00f00f00full;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ull;
    return (bits | bits << 2) & 0x1249249249249249ull;
  }

  double scale;
};

// The members of every cell, which are numbers from 0 on.
class StippleCells
{
public:
  struct Range
  {
    std::int32_t begin = 0, end = 0; // in members
  };

  StippleCells() = default;
  // names: the cell of every member.
  explicit StippleCells(const std::vector<std::uint64_t>& names);

  std::int32_t size() const { return static_cast<std::int32_t>(this->ranges.size()); }
  Range range(std::int32_t cell) const { return this->ranges[static_cast<std::size_t>(cell)]; }
  std::uint64_t name(std::int32_t cell) const
  {
    return this->cellNames[static_cast<std::size_t>(cell)];
  }
  // -1 for a cell without members.
  std::int32_t find(std::uint64_t name) const
  {
    std::size_t slot = this->slotOf(name);
    while (!this->slots.empty() && this->slots[slot] >= 0)
    {
      if (this->cellNames[static_cast<std::size_t>(this->slots[slot])] == name)
      {
        return this->slots[slot];
      }
      slot = (slot + 1) & (this->slots.size() - 1);
    }
    return -1;
  }

  std::vector<std::int32_t> members; // by cell; within a cell ascending

private:
  std::size_t slotOf(std::uint64_t name) const
  {
    return static_cast<std::size_t>((name * 0x9e3779b97f4a7c15ull) >> this->shift);
  }

  std::vector<Range> ranges;
  std::vector<std::uint64_t> cellNames;
  std::vector<std::int32_t> slots; // open addressing; -1: free
  int shift = 63;
};

} // namespace hachure

#endif

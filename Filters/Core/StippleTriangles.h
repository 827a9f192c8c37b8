// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleTriangles_h
#define hachure_StippleTriangles_h

#include "StippleCube.h"
#include "StipplePolygon.h"
#include "StippleSurface.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace hachure
{

// The triangles of a surface, found by where they are; and which cubes of space the surface meets.
class StippleTriangles
{
public:
  // The points and triangles of the surface's mesh must outlive this.
  explicit StippleTriangles(StippleSurface someSurface);

  const StippleSurface& surface() const { return this->theSurface; }
  // A triangle by its place in surface().triangles, which is the number it has here.
  std::array<glm::dvec3, 3> corners(std::int32_t number) const
  {
    return this->theSurface.corners(this->theSurface.triangles[static_cast<std::size_t>(number)]);
  }
  // Bit i: the side from corner i to the next is an open border.
  unsigned openSides(std::int32_t number) const
  {
    return this->borders[static_cast<std::size_t>(number)];
  }

  // The numbers of all triangles whose boxes meet the box, ascending.
  std::vector<std::int32_t> find(const glm::dvec3& low, const glm::dvec3& high) const;

  // Codes of the cubes of a level that the surface meets, ascending.
  std::vector<std::uint64_t> cubes(std::int32_t level) const;
  // Bit i: the surface meets the cube's child i.
  unsigned children(const StippleCube& cube);

  std::size_t memory() const;

private:
  struct Box
  {
    glm::vec3 low, high;
  };

  Box boxOf(std::int32_t number) const;
  void makeBoxes();
  unsigned findChildren(const StippleCube& cube) const;

  StippleSurface theSurface;
  std::vector<std::uint8_t> borders;
  // Of so many neighbouring triangles; of so many of these, and so on up to one.
  std::vector<std::vector<Box>> boxes;
  std::unordered_map<std::uint64_t, std::uint8_t> knownChildren; // by code
};

} // namespace hachure

#endif

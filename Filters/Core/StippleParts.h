// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleParts_h
#define hachure_StippleParts_h

#include "StippleTriangles.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// Places all over a surface, one at random in each part of it of about the same area; those within
// a box are found without the others. Always the same for the same seed and area.
class StippleParts
{
public:
  struct Place
  {
    glm::dvec3 place;
    glm::vec3 normal;
    std::int32_t triangle;
    glm::dvec2 weights; // barycentric, of the second and third corner
  };

  StippleParts(const StippleTriangles& someTriangles, double anArea, std::uint64_t someSeed)
    : triangles(someTriangles)
    , area(anArea)
    , seed(someSeed)
  {
  }

  // Appends the places on a triangle that are within the box, its high sides not included.
  void add(std::int32_t number, const glm::dvec3& low, const glm::dvec3& high,
    std::vector<Place>& places) const;

private:
  class Walk;

  const StippleTriangles& triangles;
  double area; // of a part, scaled
  std::uint64_t seed;
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StipplePolygon_h
#define hachure_StipplePolygon_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace hachure
{

// A triangle, or what is left of it within a box: convex.
class StipplePolygon
{
public:
  struct Corner
  {
    glm::dvec3 place;
    glm::dvec2 weights; // barycentric, of the triangle's second and third corner
  };

  explicit StipplePolygon(const std::array<glm::dvec3, 3>& triangle)
    : count(3)
  {
    this->corners[0] = { triangle[0], { 0.0, 0.0 } };
    this->corners[1] = { triangle[1], { 1.0, 0.0 } };
    this->corners[2] = { triangle[2], { 0.0, 1.0 } };
  }

  int size() const { return this->count; }
  const Corner& corner(int index) const { return this->corners[static_cast<std::size_t>(index)]; }
  glm::dvec3 low() const;
  glm::dvec3 high() const;

  // Cuts off what is outside. What is left is empty if it has no area or is all on the high sides
  // of the box, which belong to the next one.
  void clip(const glm::dvec3& boxLow, const glm::dvec3& boxHigh);
  bool isEmpty() const { return this->count < 3; }

private:
  void clip(int axis, double bound, double sign);
  bool hasArea() const;

  std::array<Corner, 9> corners; // one more for every side of the box
  int count;
};

} // namespace hachure

#endif

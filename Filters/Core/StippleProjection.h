// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleProjection_h
#define hachure_StippleProjection_h

#include "StippleSurface.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace hachure
{

// A place on one of the triangles that a tree was made of.
struct StippleSpot
{
  std::int32_t item = -1;
  glm::dvec3 place{ 0.0 };
  double distance = 2.0; // from the place that was asked for; more than anything within the frame
};

// Boxes around boxes around triangles, for the projection operator of the paper (section 2.4.2). A
// triangle with two equal corners is a line.
class StippleTree
{
public:
  using Triangle = std::array<glm::dvec3, 3>;

  // Triangles that follow each other should be near each other.
  explicit StippleTree(std::vector<Triangle> triangles);

  const Triangle& triangle(std::int32_t item) const
  {
    return this->triangles[static_cast<std::size_t>(item)];
  }
  // The nearest place on any triangle, if it is nearer than the one known.
  StippleSpot nearest(const glm::dvec3& place, const StippleSpot& known = {}) const;
  // Where the line through the place meets the triangles nearest to it, at most `reach` away in
  // either direction; otherwise no item.
  StippleSpot alongLine(
    const glm::dvec3& place, const glm::dvec3& unitDirection, double reach) const;

private:
  struct Box
  {
    glm::dvec3 low{ 2.0 }, high{ -2.0 };
  };

  void makeBoxes();
  double squareTo(const Box& box, const glm::dvec3& place) const;
  template <class Enters, class Visit>
  void descend(Enters&& enters, Visit&& visit) const;

  std::vector<Triangle> triangles;
  std::vector<Box> boxes; // of a complete binary tree, root first
  std::size_t leafCount = 1;
};

glm::dvec3 nearestOnTriangle(const StippleTree::Triangle& triangle, const glm::dvec3& place);

// Barycentric weights of the second and third corner of a place in the triangle, inside it.
glm::dvec2 stippleWeights(const StippleTree::Triangle& triangle, const glm::dvec3& place);

} // namespace hachure

#endif

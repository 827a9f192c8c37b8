// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseClosestPoint_h
#define hachure_NoiseClosestPoint_h

#include "NoiseSurfaceTree.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// A place on a surface.
struct NoiseFoot
{
  std::int32_t facet = -1;   // in the order of the tree; -1: none
  glm::dvec2 weights{ 0.0 }; // barycentric, of the second and third corner
  glm::dvec3 position{ 0.0 };
  double distance = 0.0;
};

// The closest point of the triangle as weights of its second and third corner.
glm::dvec2 closestInTriangle(
  const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Finds closest points on the triangles of a tree, where they are now. Both must outlive it. It has
// boxes of its own, eight in a node, closer ones than the spheres of the tree: a search meets few
// triangles.
class NoiseClosestPoint
{
public:
  NoiseClosestPoint(const NoiseSurfaceTree& surfaceTree, Span<const glm::dvec3> places);

  // Of triangles with area, nearer than `farthest`, and not facing the other way than `normal` (by
  // more than 120 degrees): the back of a thin wall is not the surface that was left. `guess`: a
  // facet that may be near, which makes it faster, or -1; of several as near it may be the one
  // found.
  NoiseFoot find(const glm::dvec3& point, const glm::dvec3& normal, double farthest,
    std::int32_t guess = -1) const;

  // Place on a curve through the surface's surroundings: what is close on it is close in space.
  std::uint64_t placeOnCurve(const glm::dvec3& point) const;

private:
  static constexpr int width = 8;
  // Boxes around what is below, or around triangles, about the surface's centre and in its radii.
  struct Node
  {
    float low[3][width];
    float high[3][width];
  };
  struct Search;
  void sortFacets();
  void makeNodes();
  void setBox(std::size_t level, std::int64_t child);
  float limitOf(double square) const;
  void searchFacet(std::int32_t facet, Search& search) const;
  void searchNode(std::size_t level, std::int64_t index, Search& search) const;

  const NoiseSurfaceTree& tree;
  Span<const glm::dvec3> positions;
  glm::dvec3 center{ 0.0 };
  double radius = 1.0;
  std::vector<std::int32_t> order; // facets, those next to each other close together
  // Level by level; box i of the first is that of order[i], of another that of node i below.
  std::vector<std::vector<Node>> levels;
};

} // namespace hachure

#endif

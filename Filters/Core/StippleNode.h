// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleNode_h
#define hachure_StippleNode_h

#include "Span.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// A box and a sphere around its middle, both around the same places, and a cone around their
// normals.
struct StippleBounds
{
  glm::dvec3 low{ 0.0 }, high{ 0.0 };
  double radius = -1.0; // below 0: of nothing
  // The angle between the axis, of unit length, and a normal has at least this cosine. -1: normals
  // may have any direction.
  glm::vec3 axis{ 0.0f, 0.0f, 1.0f };
  float cosine = -1.0f;

  bool isEmpty() const { return this->radius < 0.0; }
  glm::dvec3 middle() const { return 0.5 * this->low + 0.5 * this->high; }
  // Of all that are not empty.
  static StippleBounds around(Span<const StippleBounds> parts);
};

// Where a point is on the reference surface.
struct StipplePlace
{
  // Barycentric weights are multiples of this: on the longest edge a point is placed to 2.3e-10 of
  // its length, where a float would be off by some 3e-8.
  static constexpr double weightUnit = 1.0 / 4294967296.0; // 2^-32

  std::int32_t triangle = 0;              // of the mesh; of points without a mesh, the point
  std::array<std::uint32_t, 2> weights{}; // of the second and third corner, in units

  StipplePlace() = default;
  // Weights are cut off, so that their sum is 1 at most.
  StipplePlace(std::int32_t aTriangle, double second, double third);

  double second() const { return this->weights[0] * weightUnit; }
  double third() const { return this->weights[1] * weightUnit; }
};

// The points of a cube of space that come in within a range of densities.
struct StippleNode
{
  // Cubes have half the side at the next level. The code is 1 followed by three bits for each
  // level: which of eight the cube is, x lowest.
  std::uint64_t code = 1;
  std::int32_t level = 0;
  std::int32_t parent = -1;
  // Nodes; the first childCount are set. None: there is nothing finer yet.
  std::array<std::int32_t, 8> children{ { -1, -1, -1, -1, -1, -1, -1, -1 } };
  std::int32_t childCount = 0;
  StippleBounds own; // of the points here
  // Of the points here and below. Further points will be within the sphere, too: it holds the cube
  // as long as the mesh is where it was, then the points with what may be around them.
  StippleBounds bounds;
  // No point here or below, there or still to be made, has less, per unit of the present area.
  double leastDensity = 0.0;
  // All there will ever be up to this density are here and above: where a higher one is wanted and
  // there are no children, the node can be refined. Infinite: it cannot.
  double heldDensity = 0.0;

  std::int32_t count = 0;   // of points
  glm::dvec3 origin{ 0.0 }; // their places are relative to this

  // Arrays of paddedCount() numbers, all in one block, in the order of the density on the reference
  // surface, the least first. Those after the last point have an infinite density and are 0
  // otherwise.
  std::int32_t paddedCount() const { return (this->count + 7) / 8 * 8; }
  const float* place(int axis) const { return this->lane(axis); }
  const float* normal(int axis) const { return this->lane(3 + axis); } // of unit length, or 0
  const float* density() const { return this->lane(6); } // per unit of the present area
  // One for every 8 points: the least density of these and of all that follow.
  const float* leastOfBlocks() const { return this->lane(7); }

  std::vector<StipplePlace> places;
  std::vector<float> referenceDensities; // per unit of the reference area
  std::vector<std::uint32_t> ranks;      // in the base; empty for points of a refinement
  std::vector<float> lanes;

  // The arrays above, from the first place to the least of blocks.
  const float* lane(int index) const
  {
    return this->lanes.data() + static_cast<std::ptrdiff_t>(index) * this->paddedCount();
  }
  float* writableLane(int index)
  {
    return this->lanes.data() + static_cast<std::ptrdiff_t>(index) * this->paddedCount();
  }
  std::size_t memory() const; // bytes held, with the node itself
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseSurfaceTree_h
#define hachure_NoiseSurfaceTree_h

#include "NoiseTriangleOrder.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// The triangles of a NoiseSurface in an order in which neighbours are close, and a binary tree over
// that order. Every node owns some octaves of the points of its triangles, all octaves being owned
// by one node on the way from a triangle to the root: large nodes the rare low ones, so that a
// coarse view meets few nodes, whatever the number of triangles.
namespace hachure
{

constexpr std::int64_t noiseLeafSize = 32; // triangles

// An octave below all others: what lies above the root.
constexpr std::int32_t noNoiseOctave = std::numeric_limits<std::int32_t>::min();

struct NoiseSphere
{
  glm::dvec3 center{ 0.0 };
  double radius = -1.0; // below 0: nothing is in it
};

struct NoiseNode
{
  NoiseSphere sphere;   // around its triangles where they are now
  double stretch = 1.0; // highest ratio of a triangle's area now to that in the reference
  // It owns the octaves above those of its parent, up to this one.
  std::int32_t octave = noNoiseOctave;
  // Lowest octave in which one of its triangles has a count of its own, less one.
  std::int32_t shared = std::numeric_limits<std::int32_t>::max();
};

// A point of a node. Its place follows from its id.
struct NoiseRecord
{
  std::uint64_t id = 0;
  double birth = 0.0;
  std::int32_t triangle = 0; // in the order of the tree
  std::int32_t cell = 0;     // its number, see noiseChildNumber
};

// What is read of a triangle at once.
struct NoiseFacet
{
  glm::ivec3 corners;
  std::int32_t index; // in the mesh
  double area;        // in the reference; 0: it has no points
  std::uint64_t key;  // hash of seed and id
};

struct NoiseSurfaceTree
{
  UninitialisedArray<NoiseFacet> facets; // in the order of the tree

  // Nodes level by level, leaves first and the root last. Leaf i has the triangles from
  // i * noiseLeafSize on; node i of another level has the children 2 i and 2 i + 1, where that is.
  std::vector<NoiseNode> nodes;
  std::vector<std::int64_t> levelFirst; // per level, and the number of nodes

  // Points of the octaves that share a count, per node that owns them: those of nodes[n] are
  // shared[sharedFirst[n]] to shared[sharedFirst[n + 1]].
  std::vector<NoiseRecord> shared;
  std::vector<std::uint32_t> sharedFirst;

  int levels() const { return static_cast<int>(this->levelFirst.size()) - 1; }
  std::int64_t levelSize(int level) const
  {
    return this->levelFirst[level + 1] - this->levelFirst[level];
  }
  std::int64_t leafEnd(std::int64_t leaf) const
  {
    const auto count = static_cast<std::int64_t>(this->facets.size());
    return (leaf + 1) * noiseLeafSize < count ? (leaf + 1) * noiseLeafSize : count;
  }
};

// Throws std::invalid_argument as checkTriangleMesh does, for ids and areas of another number, and
// for areas that are not finite and 0 or more. Empty ids: a hash of the corners' positions. Empty
// areas: those of the reference.
NoiseSurfaceTree buildNoiseSurfaceTree(const TriangleMesh& reference, Span<const std::uint64_t> ids,
  std::uint32_t seed, Span<const double> areas = {});

// Moves the spheres to other positions. Throws std::invalid_argument, and changes nothing, where a
// corner is not finite.
void placeNoiseSurfaceTree(NoiseSurfaceTree& tree, Span<const glm::dvec3> positions);

// The key of a triangle.
std::uint64_t noiseTriangleKey(std::uint32_t seed, std::uint64_t id);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseDescent_h
#define hachure_NoiseDescent_h

#include "NoiseProcess.h"
#include "NoiseProjection.h"
#include "NoiseSurfaceTree.h"

#include <vector>

namespace hachure
{

// Octaves of points that may be seen: those of a node, or of a triangle or a cell of it.
struct NoiseVisit
{
  std::int64_t node = -1;     // -1: a triangle
  std::int32_t triangle = -1; // in the order of the tree
  std::int32_t octaveBelow = 0;
  std::int32_t octave = 0; // octaves above octaveBelow, up to this one
  double density = 0.0;    // higher than at any of them that is seen
  NoiseCell cell;
};

// The lowest birth in the octaves above this one.
inline double lowestBirthAbove(std::int32_t octave)
{
  return octave == noNoiseOctave ? 0.0 : powerOfTwo(octave + 1);
}

// What has points that may be seen, from the root down, in an order that depends on the mesh alone.
std::vector<NoiseVisit> findNoiseVisits(const NoiseSurfaceTree& tree,
  Span<const glm::dvec3> positions, const NoiseProjection& projection);

// The points of a node in the octaves in which triangles have counts of their own, up to one that
// the node owns; it owns those above `octaveBelow`.
std::vector<NoiseRecord> makeNodePoints(
  const NoiseSurfaceTree& tree, std::int64_t node, std::int32_t octaveBelow, std::int32_t octave);

} // namespace hachure

#endif

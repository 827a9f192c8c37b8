// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleNeighbourhood_h
#define hachure_StippleNeighbourhood_h

#include "StippleCandidates.h"
#include "StippleCells.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

// How crowded a place is by the points around it. A point at distance d, with the reach R within
// which points matter, counts (R / d)^8 - 1. So the nearest points decide, and with a single one
// the *room* around a place, R (1 + crowding)^(-1/8), is the distance; each further one makes it
// less. With the room instead of the distance the density is evener (measured: a tenth less power
// at low frequencies), and it never is more than the distance.
namespace hachure
{

// Two places that face nearly opposite ways do not matter to each other: no view shows them side by
// side.
inline bool stipplesMatter(const glm::vec3& firstNormal, const glm::vec3& secondNormal)
{
  constexpr float oppositeCosine = -0.7f;
  return glm::dot(firstNormal, secondNormal) > oppositeCosine;
}

// Of one point, from the squares of distance and reach.
inline float stippleCrowding(float square, float reachSquare)
{
  const float ratio = reachSquare / square; // infinite in the same place
  const float fourth = ratio * ratio;
  return square < reachSquare ? fourth * fourth - 1.0f : 0.0f;
}

inline float stippleRoom(float crowding, float reach)
{
  return reach * std::pow(1.0f + crowding, -0.125f);
}

// A border keeps points away as a point so many times as far away as it: about as if they were
// mirrored there. Measured: with 2 there is an empty strip along the border, without it a row of
// points on it.
constexpr float stippleMirrorDistance = 3.1f;

// By the nearest place of a border; borders of other sheets do not matter.
float stippleBorderCrowding(
  const glm::vec3& place, const glm::vec3& normal, const StippleBorder& border, float reach);

// All that keeps further points away: the points that are there, and the open borders.
class StippleNeighbourhood
{
public:
  // What matters in the block of cells around some place.
  struct Block
  {
    glm::ivec3 cell{ -1 };
    std::vector<StippleCandidate> placed;
    std::vector<StippleBorder> borders;
  };
  // Those of the last places that were asked for: places that are asked for one after the other are
  // mostly near each other. One for each thread.
  struct Blocks
  {
    std::array<Block, 64> blocks;
  };

  StippleNeighbourhood(const std::vector<StippleCandidate>& placed,
    const std::vector<StippleBorder>& borders, float reach);

  // Above the limit any number above it will do.
  float crowding(const glm::vec3& place, const glm::vec3& normal, Blocks& blocks,
    float limit = std::numeric_limits<float>::infinity()) const;

  // A bound: all places of the triangle are at least so crowded. 0 for triangles much larger than
  // the reach.
  float leastCrowding(
    const std::array<glm::vec3, 3>& corners, const glm::vec3& normal, Blocks& blocks) const;

private:
  const Block& visit(const glm::vec3& place, Blocks& blocks) const;
  void gather(const glm::ivec3& cell, Block& block) const;

  const std::vector<StippleCandidate>& placed;
  std::vector<StippleBorder> pieces; // of borders, no longer than half a cell
  float reach;
  StippleGrid grid;
  StippleCells placedCells, borderCells;
};

} // namespace hachure

#endif

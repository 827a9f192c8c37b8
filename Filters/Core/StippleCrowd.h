// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCrowd_h
#define hachure_StippleCrowd_h

#include "StippleCandidates.h"
#include "StippleNode.h"
#include "StippleSurface.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace hachure
{

// The candidates in a cube around the origin, in cells as wide as points reach; the least crowded
// is found and the others are crowded by it, one after the other.
class StippleCrowd
{
public:
  struct Candidate
  {
    glm::vec3 place;
    glm::vec3 normal;
    float crowding = 0.0f; // see StippleNeighbourhood
    StipplePlace origin;
    bool isKept = false; // not used here
  };
  // A point that is there from the beginning for places nearer than `nearer`, and for all others
  // only when crowdBy() is told so.
  struct Point
  {
    glm::vec3 place;
    glm::vec3 normal;
    float nearer = std::numeric_limits<float>::infinity();
  };

  // What is farther from the origin than half of the width, along an axis, does not matter.
  StippleCrowd(float width, float aReach);

  // Takes those of the candidates that are not more crowded than the limit. Such as become so are
  // dropped.
  void begin(std::vector<Candidate>&& candidates, const std::vector<Point>& points,
    const std::vector<StippleBorder>& borders, float aMostCrowded);

  // The least crowded; a null pointer if there is none. Valid until the next call.
  const Candidate* least() const;
  void crowdBy(const Point& point);

private:
  struct Cell
  {
    std::int32_t begin = 0, end = 0; // of candidates
    std::int32_t best = -1;
    float leastCrowding = std::numeric_limits<float>::infinity();
  };

  bool isWithin(const glm::vec3& place) const;
  glm::ivec3 cellOf(const glm::vec3& place) const;
  std::size_t indexOf(const glm::ivec3& cell) const
  {
    return static_cast<std::size_t>((cell.z * this->count + cell.y) * this->count + cell.x);
  }
  template <class Visit>
  void visitAround(const glm::ivec3& cell, Visit&& visit) const;
  // Numbers of places, cell by cell.
  template <class T>
  std::vector<std::int32_t> sortByCell(
    const std::vector<T>& items, std::vector<std::int32_t>& firstOfCell) const;
  void crowdCell(std::size_t index, const std::vector<Point>& around);
  void crowdByBorders(const std::vector<StippleBorder>& borders);
  void findBest(Cell& cell);

  float half, reach, reachSquare;
  float mostCrowded = 0.0f;
  int count; // of cells along an axis
  std::vector<Candidate> candidates;
  std::vector<Cell> cells;
  std::vector<std::int32_t> filledCells;
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCrowd_h
#define hachure_StippleCrowd_h

#include "StippleCandidates.h"
#include "StippleSurface.h"

#include <glm/vec2.hpp>
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
    bool isKept = false;   // this and the following are not used here
    std::int32_t triangle = 0;
    glm::dvec2 weights{ 0.0 };
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
  StippleCrowd(float width, float aReach, float aMostCrowded);

  // What is there before the candidates.
  void setAround(const std::vector<Point>& points, const std::vector<StippleBorder>& borders);
  // Takes a candidate unless it is more crowded than the limit, which is the same for all. Such as
  // become so are dropped.
  void offer(const Candidate& candidate);
  // After the last candidate.
  void begin();

  // The least crowded; a null pointer if there is none. Valid until the next call.
  const Candidate* least();
  void crowdBy(const Point& point);

private:
  struct Cell
  {
    std::int32_t begin = 0, end = 0; // of candidates
    std::int32_t best = -1;
    float leastCrowding = std::numeric_limits<float>::infinity();
  };

  // What matters in a cell.
  struct Around
  {
    bool isKnown = false;
    std::int32_t begin = 0, end = 0;    // in aroundPoints
    std::vector<StippleBorder> borders; // few have any
  };

  bool isWithin(const glm::vec3& place) const;
  glm::ivec3 cellOf(const glm::vec3& place) const;
  std::size_t indexOf(const glm::ivec3& cell) const
  {
    const auto side = static_cast<std::size_t>(this->count);
    return (static_cast<std::size_t>(cell.z) * side + static_cast<std::size_t>(cell.y)) * side +
      static_cast<std::size_t>(cell.x);
  }
  template <class Visit>
  void visitBlock(const glm::ivec3& low, const glm::ivec3& high, Visit&& visit) const;
  template <class Visit>
  void visitAround(const glm::ivec3& cell, Visit&& visit) const
  {
    this->visitBlock(cell - 1, cell + 1, visit);
  }
  // Numbers of items within the width, cell by cell.
  template <class T>
  std::vector<std::int32_t> sortByCell(
    const std::vector<T>& items, std::vector<std::int32_t>& firstOfCell) const;
  void addBorder(const StippleBorder& border);
  const Around& aroundOf(const glm::ivec3& cell);
  void findBest(Cell& cell);

  float half, reach, reachSquare, mostCrowded, cellsPerLength;
  int count;                            // of cells along an axis
  std::vector<Point> points;            // cell by cell
  std::vector<std::int32_t> firstPoint; // of each cell
  std::vector<Around> around;           // of each cell
  std::vector<Point> aroundPoints;
  std::vector<Candidate> candidates; // cell by cell from begin() on
  std::vector<Cell> cells;
  std::vector<std::int32_t> filledCells;
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCandidateCells_h
#define hachure_StippleCandidateCells_h

#include "Random.h"
#include "StippleCandidates.h"
#include "StippleCells.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace hachure
{

// The candidates of an octave, by cells.
class StippleCandidateCells
{
public:
  StippleCandidateCells(const std::vector<StippleCandidate>& someCandidates, float side);

  // From now on, only carried candidates, those of the first `due` points.
  void chooseCarried(std::int32_t due);
  // Only new ones, as at the beginning.
  void chooseNew() { this->kind = New; }
  // Places candidates until all are more crowded than the limit, and appends them.
  void fill(float mostCrowded, std::vector<StippleCandidate>& placed);

private:
  struct Best
  {
    float crowding = std::numeric_limits<float>::infinity();
    std::int32_t candidate = -1;
  };

  // Whichever other candidates there are.
  std::uint64_t hashOf(std::int32_t candidate) const
  {
    const StippleCandidate& at = this->candidates[static_cast<std::size_t>(candidate)];
    std::uint64_t bits[2] = {};
    std::memcpy(bits, &at.place, sizeof(at.place));
    return hashPair(bits[0], bits[1]);
  }
  bool isBetter(const Best& first, const Best& second) const
  {
    return first.crowding != second.crowding
      ? first.crowding < second.crowding
      : this->hashOf(first.candidate) > this->hashOf(second.candidate);
  }
  enum Kind
  {
    New,
    Carried
  };

  const Best& bestOf(std::int32_t cell) const
  {
    return this->best[this->kind][static_cast<std::size_t>(cell)];
  }
  void linkNeighbours(float side);
  void findBest(std::int32_t cell);
  void findBestCarried(std::int32_t cell);
  bool isChosen(std::int32_t cell) const;
  void place(std::int32_t cell, std::vector<StippleCandidate>& placed);
  void crowd(std::int32_t cell);

  float reachSquare;
  Kind kind = New;
  std::int32_t carriedDue = 0;
  std::vector<StippleCandidate> candidates; // by cell
  StippleCells cells;
  std::vector<std::int32_t> firstNeighbour, neighbours; // of each cell, with itself
  std::vector<std::int32_t> firstCarried;               // of each cell, after the new ones
  std::vector<Best> best[2];                            // of each cell, by kind
  std::vector<std::int32_t> chosen;                     // candidate placed now, or -1
  std::vector<char> isTouched;
};

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleProgressive_h
#define hachure_StippleProgressive_h

#include "StippleCandidates.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// Points of a hierarchy before that are to be among those found.
struct CarriedCandidates
{
  std::vector<StippleCandidate> points; // by rank there; triangle -1: not on this surface
  double growth = 1.0;                  // ranks here for one there: the ratio of areas
};

// Of a point that was found: which of the carried ones it is, or -1. It has no other triangle.
inline std::int32_t carriedIndex(const StippleCandidate& found)
{
  return found.triangle < 0 ? -1 - found.triangle : -1;
}

// Up to `count` points from the source, by rank; `crowding` is then the room that each had when
// it came in, which never rises where none is carried. area: scaled. Empty if the progress function
// stopped it.
std::vector<StippleCandidate> fillGaps(StippleSource& source, double area,
  const std::vector<StippleBorder>& borders, std::int64_t count, const ProgressFn& progress,
  const CarriedCandidates& carried = {});

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleProgressive_h
#define hachure_StippleProgressive_h

#include "StippleCandidates.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// Up to `count` points from the source, by rank; `crowding` is then the room that each had when
// it came in, which never rises. area: scaled. Empty if the progress function stopped it.
std::vector<StippleCandidate> fillGaps(StippleSource& source, double area,
  const std::vector<StippleBorder>& borders, std::int64_t count, const ProgressFn& progress);

} // namespace hachure

#endif

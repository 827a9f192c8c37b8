// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternColor_h
#define PatternColor_h

#include <algorithm>

namespace hachure
{

/** Stores a colour with its components clamped to [0,1]; tells whether that changed it. */
inline bool assignColor(double (&target)[3], const double* color)
{
  bool changed = false;
  for (int i = 0; i < 3; ++i)
  {
    const double component = color[i] > 0.0 ? std::min(color[i], 1.0) : 0.0; // NaN becomes 0
    changed = changed || target[i] != component;
    target[i] = component;
  }
  return changed;
}

} // namespace hachure

#endif

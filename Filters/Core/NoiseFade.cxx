// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseSurface.h"

#include <algorithm>
#include <cmath>

namespace hachure
{

double noiseFadeWeight(double density, double birth, double fade)
{
  if (!(density > birth))
  {
    return 0.0;
  }
  // Of all curves a straight one changes the picture least while it zooms: it has the smallest mean
  // of squared changes.
  return std::min(1.0, std::log2(density / birth) / fade);
}

double noiseFadeShare(double fade)
{
  // With q = D 2^(-fade t) the births from D 2^(-fade) to D are fade ln 2 2^(-fade t) D dt, and
  // those below count in full. Simpson's rule.
  const int steps = 128;
  const double rate = fade * 0.69314718055994530942; // ln 2
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double t = static_cast<double>(i) / steps;
    const double weight = t;
    const double factor = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += factor * weight * weight * std::exp(-rate * t);
  }
  return std::exp(-rate) + rate * sum / (3.0 * steps);
}

} // namespace hachure

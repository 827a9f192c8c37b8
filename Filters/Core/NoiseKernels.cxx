// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseKernels.h"

#include <cmath>

namespace hachure
{

namespace
{

// Bandwidth times radius where exp(-pi a^2 r^2) is 5 %: sqrt(-ln .05 / pi).
constexpr double cutOff = 0.9765097024771845;

} // namespace

float noiseRadius(float bandwidth)
{
  return static_cast<float>(cutOff / static_cast<double>(bandwidth));
}

float noiseBandwidth(float radius)
{
  return static_cast<float>(cutOff / static_cast<double>(radius));
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseTransfer_h
#define hachure_NoiseTransfer_h

#include "NoiseClosestPoint.h"

#include <glm/vec3.hpp>

#include <vector>

namespace hachure
{

// A point that goes from one surface to another.
struct NoiseMover
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 normal{ 0.0 };
  double radius = 1.0;  // of its kernel on the surface
  NoiseFoot foot;       // on the other surface
  bool returns = false; // the closest point to the foot is where it came from, or near
  double growth = 1.0;  // of the surface's area from here to the foot
};

// Fills foot and returns. Feet are nearer than `reach`.
void transferNoisePoints(const NoiseClosestPoint& from, const NoiseClosestPoint& to, double reach,
  std::vector<NoiseMover>& movers);

// Fills the growth of those that return, from how their neighbours move: that of the area which the
// points in a cube about as large as a kernel span, so that the roughness of triangles tells
// nothing. 1 where there are too few.
void measureNoiseGrowth(std::vector<NoiseMover>& movers);

} // namespace hachure

#endif

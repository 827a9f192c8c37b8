// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_BlendPoints_h
#define hachure_BlendPoints_h

#include "Span.h"

#include <glm/vec3.hpp>

#include <vector>

namespace hachure
{

// A camera and how much it sees of what is seen from everywhere, in place of what is seen from some
// directions (Grimm and Kowalski 2002, appendix A).
struct BlendPoint
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 }; // of view, of any length but 0
  double share = 1.0;                     // 0 to 1
};

// The paper's function of camera positions and directions, with all directions made unit vectors:
// the mean of the points' shares, each by how near its direction and position are. Beyond the clip
// values a point has no weight.
class BlendFunction
{
public:
  // The clip values, which the paper gives as "the average minimum dot product and distance for all
  // blend points", are the means over the points of the smallest dot product of a point's
  // direction with those of the others, and of the smallest distance to another point. Of a
  // single point they would be undefined, and where all directions or, for each point, another
  // one's position are the same nothing would have weight: then the direction is clipped at 0, and
  // the distance at the mean of the points' distances from `centre`, the middle of the surface, or,
  // if that is 0 as well, not at all. Throws std::invalid_argument naming the first bad point:
  // numbers that are not finite, a direction of length 0 or a share outside of [0, 1].
  BlendFunction(Span<const BlendPoint> points, const glm::dvec3& centre);

  // 0 to 1: how much of what is seen from everywhere takes the place of the rest. 0 where no point
  // has weight, and without points. Position and direction of a camera must be finite; a direction
  // of length 0 is near no point's.
  double at(const glm::dvec3& position, const glm::dvec3& direction) const;

  double directionClip() const { return this->leastCosine; } // -1 to below 1
  double distanceClip() const { return this->mostDistance; } // infinite: none

private:
  std::vector<BlendPoint> points; // directions of unit length
  double leastCosine = 0.0;
  double mostDistance = 0.0;
};

} // namespace hachure

#endif

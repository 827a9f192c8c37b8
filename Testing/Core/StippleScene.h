// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleScene_h
#define hachure_StippleScene_h

#include "StippleHierarchy.h"
#include "TestSurfaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hachure
{

inline Surface unitPlane(int grid)
{
  Surface plane;
  addGrid(plane, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, grid);
  return plane;
}

// Six faces of n x n quads, blown up; every face has points of its own, at the places of others.
inline Surface unitSphere(int n)
{
  Surface sphere;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      glm::dvec3 normal(0.0), u(0.0), v(0.0);
      normal[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1.0;
      addGrid(sphere, normal - u - v, 2.0 * u, 2.0 * v, n);
    }
  }
  for (glm::dvec3& point : sphere.points)
  {
    point = glm::normalize(glm::round(point * static_cast<double>(n))); // equal at the seams
  }
  return sphere;
}

inline glm::dvec3 normalOf(const Surface& surface, const StipplePoint& point)
{
  return glm::normalize(triangleAreaVector(surface.mesh(), point.triangle));
}

// The first points of both.
inline void expectEqual(
  const StippleHierarchy& first, const StippleHierarchy& second, std::size_t count)
{
  ASSERT_GE(std::min(first.points.size(), second.points.size()), count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const StipplePoint& a = first.points[i];
    const StipplePoint& b = second.points[i];
    ASSERT_TRUE(a.triangle == b.triangle && a.weights[0] == b.weights[0] &&
      a.weights[1] == b.weights[1] && a.spacing == b.spacing)
      << "point " << i;
  }
}

} // namespace hachure

#endif

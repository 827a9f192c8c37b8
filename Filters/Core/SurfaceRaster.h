// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceRaster_h
#define hachure_SurfaceRaster_h

#include "TriangleMesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// What a camera sees of a surface, from both of its sides, at every pixel's centre. Rows from the
// bottom up.
struct SurfaceRaster
{
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> triangles; // -1: nothing
  std::vector<glm::vec2> weights;      // of the triangle's second and third corner
  std::int64_t pixels = 0;             // that show anything
  double area = 0.0; // of the surface that they show, without what is almost edge-on
};

// Draws the surface with a matrix to OpenGL's clip space. What is behind the eye (w <= 0) is not
// seen; there is no other near or far limit. Triangles with a negative number in `shown`, one for
// each, are left out. The same for any number of threads.
SurfaceRaster rasterOf(const TriangleMesh& mesh, Span<const std::int32_t> shown,
  const glm::dmat4& modelToClip, int width, int height);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ScreenMotion_h
#define hachure_ScreenMotion_h

#include "Span.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// Exact motion of a surface in the image from one state to another. Given is which triangle is seen
// at every pixel of both states. The point of the triangle at the centre of the pixel keeps its
// barycentric coordinates; it is projected in both states, in double precision, so nothing is lost
// to what the drawing hardware interpolates.
// Image space: pixels, y up, origin at the lower left corner, pixel centres at halves.
namespace hachure
{

// A state of the scene: camera at the origin, looking along -z; viewToClip is the projection, in
// OpenGL's convention. `seen` holds the triangle seen at every pixel, rows from the bottom up, or
// nothingSeen.
struct MotionState
{
  Span<const glm::dvec3> points;
  glm::dmat4 viewToClip{ 1.0 };
  Span<const std::int32_t> seen;
};

constexpr std::int32_t nothingSeen = -1;

struct MotionScene
{
  MotionState before;
  MotionState after;
  Span<const glm::ivec3> triangles; // corners, the same in both states
  Span<const std::int32_t> labels;  // per triangle: object from 1 on, 0 = only hides others
  Span<const glm::dvec3> normals;   // per point before, any length; 0 = the triangle's own
  glm::ivec2 size{ 0, 0 };          // width and height in pixels
};

// All 0 where no labelled triangle is seen in the state before.
struct PixelMotion
{
  float u = 0.0f; // motion in pixels; 0 where the point goes behind the camera
  float v = 0.0f;
  float visible = 0.0f;  // 1 where the point is seen in the state after, too
  float facing = 0.0f;   // |n.v|, 1 = head-on, in the state before
  float distance = 0.0f; // along the direction of view, scene units, in the state before
  float label = 0.0f;
};

// Row by row from the bottom. A point is hidden after where a triangle that is seen at one of the
// nine pixels around it lies right over it. Where another triangle is seen at its own pixel, beside
// the point by a part of a pixel, depth decides, following the slope of the point's own triangle:
// so up to a pixel beside something nearer may count as hidden.
//
// Throws std::invalid_argument on a size below 1, arrays of different lengths, corners that are no
// points, seen triangles that do not exist, and positions or projections that are not finite.
std::vector<PixelMotion> screenMotion(const MotionScene& scene);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseBlock_h
#define hachure_NoiseBlock_h

#include "Lanes.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace hachure
{

// A triangle where it is now.
struct NoiseTriangle
{
  glm::dvec3 origin, u, v; // first corner, and the edges to the second and third
  double area = 0.0;       // in the reference
};

// Where blocks are: places are relative to an origin near by and in units about as large as the
// surface, so that single precision does. What it loses is small against the distance between
// points of their births.
struct NoiseFrame
{
  glm::dvec3 origin{ 0.0 };
  double unit = 1.0; // a power of two
};

// Eight points of a surface where they are now.
struct NoiseBlock
{
  using Numbers = std::array<float, floatLanes>;
  struct Vectors
  {
    alignas(32) Numbers x, y, z;
  };
  Vectors offset;  // from the frame's origin
  Vectors normal;  // of the triangle, as long as its area is in units of that in the reference
  Vectors tangent; // along the first edge, of unit length
  Numbers birth;   // per unit of the frame's area
  std::array<std::uint64_t, floatLanes> id;
  std::array<std::int32_t, floatLanes> triangle; // in the order of the tree
  std::array<std::int8_t, floatLanes> cell;      // as in NoiseRecord
  int count;                                     // points in use, the first ones

  // Puts a point of a triangle to its place; weights: of the second and third corner.
  void place(int lane, const NoiseTriangle& at, const glm::dvec2& weights, const NoiseFrame& frame);
};

// What a view makes of a block.
struct NoiseImages
{
  using Numbers = NoiseBlock::Numbers;
  alignas(32) Numbers x, y; // pixels
  Numbers depth, slopeX, slopeY;
  Numbers density;     // wanted there, kernels per unit of the frame's area, of the reference
  Numbers weight;      // that of the fade, 0: no kernel
  Numbers orientation; // radians: of the turn of the image against the first edge, where wanted
  Numbers seen;        // negative: behind the near plane, too far away, or edge-on
};

// A view of a frame, in single precision.
struct NoiseBlockView
{
  // Rows to clip space, of the frame's places. The third is that of depth less depthOffset times
  // that of w, which keeps depths exact far from the near plane.
  glm::vec4 rowX, rowY, rowZ, rowW;
  double scale = 1.0; // of all rows: clip space is homogeneous
  double depthOffset = 0.0;
  glm::vec2 origin, size;     // of the viewport, pixels
  float reach = 0.0f;         // largest radius of a kernel
  float densityFactor = 1.0f; // kernels per unit of area where that is one of clip space
  float inverseFade = 1.0f;
  float highestDensity = 1.0f; // factor of a control
  bool turning = false;
  // Crossed rows, of which the image of an area is made.
  glm::vec3 xy, yw, wx, zy, wz, xz;
};

void projectNoiseBlock(const NoiseBlockView& view, const NoiseBlock& block, NoiseImages& images);

} // namespace hachure

#endif

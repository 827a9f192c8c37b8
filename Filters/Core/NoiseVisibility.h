// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseVisibility_h
#define hachure_NoiseVisibility_h

#include "NoiseField.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// How much of a kernel's disc is seen.
struct NoiseShare
{
  float seen = 1.0f; // 0 to 1, by noiseShownShare
  // Whether all that is seen in the disc, as far as its samples tell, and a little around it lies
  // on the kernel's plane.
  bool complete = true;
};

// Partial visibility from a depth image alone (after Cole & Finkelstein 2008): the share of a
// disc's samples whose pixels lie on the kernel's plane, with noiseSampleWeight. Where nothing is
// there (depth 1) nothing is seen; pixels outside the rectangle are not known and count neither
// way. With no known sample the kernel counts as seen, but not completely.
//
// Samples are those pixels of the framebuffer whose column and row are multiples of
// noiseSampleStep: they stay where they are when a kernel moves, and none enters or leaves its disc
// with a jump. For every step that occurs, its pixels are copied side by side.
class NoiseVisibility
{
public:
  NoiseVisibility(const NoiseSurroundings& surroundings, Span<const NoiseKernel> kernels);

  NoiseShare share(const NoiseKernel& kernel, float radius) const;

  // Pixels at multiples of a step.
  struct Samples
  {
    int step = 0;                      // 0: none
    int firstColumn = 0, firstRow = 0; // in steps
    int columns = 0, rows = 0;
    std::vector<float> depth; // above 1: not known
    std::vector<std::int32_t> objects;
  };

private:
  std::vector<Samples> samples; // by step
  int stepOf(float radius) const;

  float tolerance = 0.0f;
  bool everyPixel = false;
  bool active = false; // whether anything can hide a kernel
};

// NoiseSurroundings::depthTolerance with which surfaces count whose radius of curvature is 4 kernel
// radii or more: as much as they leave their tangent plane at the kernel's rim. depthPerPixel:
// change of window depth by moving the surface away by the size of a pixel.
float noiseDepthToleranceFor(float radius, float depthPerPixel);

} // namespace hachure

#endif

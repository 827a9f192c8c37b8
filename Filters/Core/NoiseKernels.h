// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseKernels_h
#define hachure_NoiseKernels_h

#include <glm/vec2.hpp>

#include <cstdint>

// Noise that moves with a surface and looks flat (Benard et al. 2010): a sum of kernels that are
// defined in the picture, at points that are attached to the surface.
namespace hachure
{

// One kernel as it is drawn. Pixels are those of the framebuffer, y up; the centre of the pixel in
// column i and row j is at (i + .5, j + .5).
//
// The Gabor kernel is weight * exp(-pi a^2 r^2) * cos(2 pi F0 d + phase), where r is the distance
// from the centre and d the distance along the orientation (section 3.1, equation 1); it ends at
// the radius where the envelope is 5 % (noiseRadius).
struct NoiseKernel
{
  glm::vec2 center{ 0.0f };
  float weight = 1.0f;      // 0 to 1: fades kernels in and out
  float phase = 0.0f;       // radians
  float frequency = 0.125f; // F0, cycles per pixel
  float bandwidth = 0.06f;  // a, 1 / pixels
  float orientation = 0.0f; // of the wave vector, radians counter-clockwise from +x
  // The plane of the surface: window depth at the centre, and its change per pixel.
  float depth = 0.0f;
  glm::vec2 depthSlope{ 0.0f };
  std::int32_t triangle = 0; // index in the mesh
  std::int32_t object = 0;   // block of the mesh
  std::uint64_t id = 0;      // of the point, the same in every frame
};

// Distance in pixels at which the envelope of a kernel has fallen to 5 %: sqrt(-ln .05 / pi) / a.
float noiseRadius(float bandwidth);

// The bandwidth of this radius.
float noiseBandwidth(float radius);

} // namespace hachure

#endif

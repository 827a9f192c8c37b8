// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseField_h
#define hachure_NoiseField_h

#include "NoiseKernels.h"
#include "Span.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

// The field of a noise on a CPU: kernels summed up at every pixel, normalised, and made uniform.
namespace hachure
{

enum class NoiseKind
{
  gabor,  // the sum of the kernels (Benard et al. 2010)
  phasor, // the phase of their complex sum (Tricard et al. 2019): lines of constant contrast
  spot    // an image in place of the kernel (van Wijk 1991)
};

// A user's spot, rows from the bottom; its mean is subtracted. Its image is drawn as large as the
// square around the kernel's disc, turned by the kernel's orientation, linearly interpolated, and
// cut off at the disc; a kernel whose phase has a negative cosine draws the negative.
struct NoiseSpot
{
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

// What is seen at the pixels of a rectangle; empty arrays: no such test. Pixels of other blocks
// than the kernel's, or of other triangles, are not drawn to.
struct NoiseSurroundings
{
  std::array<int, 4> rectangle{ 0, 0, 0, 0 }; // x, y, width, height in the framebuffer
  Span<const float> depth;          // window depth, row by row from the bottom; 1: nothing is there
  Span<const std::int32_t> objects; // block seen
  Span<const std::int32_t> triangles; // triangle seen
  // A pixel counts as on the kernel's plane if it is nearer to it than this much window depth, > 0,
  // plus noiseSlopeTolerance times the kernel's depth slope times the square of the distance from
  // its centre over its radius. From once to twice that it fades. noiseDepthToleranceFor has what
  // suits a curved surface.
  float depthTolerance = 1e-4f;
  bool depthTest = true;         // pixels off the kernel's plane are not drawn to
  bool partialVisibility = true; // a kernel counts by the share of its disc that is seen
  bool everyPixel = false;       // which is found from every pixel of the disc, not from samples
};

struct NoiseFieldOptions
{
  NoiseKind kind = NoiseKind::gabor;
  double overlap = 32.0; // N', for the distribution
  const NoiseSpot* spot = nullptr;
  // Least width of the field, 0 to 1: how softly marks end.
  double smoothness = 0.0;
};

// Per pixel of the rectangle. Where hardly any kernel is, the field is flat, .5, and 1 wide: its
// ink is the tone.
struct NoiseField
{
  std::vector<float> value; // uniform in [0, 1]; 0 where nothing is seen
  std::vector<float> width; // change across a pixel, > 0
};

// Deterministic for any number of threads: a pixel sums its kernels in their order. Kernels with a
// number that is not finite, or without weight or bandwidth, are left out. Throws
// std::invalid_argument for arrays of another size than the rectangle, and for options out of
// range.
NoiseField noiseField(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options);

// What noiseField needs from frame to frame, so that a moving picture asks for no memory.
class NoiseFieldMemory
{
public:
  NoiseFieldMemory();
  ~NoiseFieldMemory();
  NoiseFieldMemory(NoiseFieldMemory&&) noexcept;
  NoiseFieldMemory& operator=(NoiseFieldMemory&&) noexcept;

  struct Data;
  std::unique_ptr<Data> data;
};

// The same into the memory of a frame before.
void noiseField(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options, NoiseField& result, NoiseFieldMemory& memory);

// Sums before they are made uniform: what all back ends must agree on. Gabor and spot: the sum (x)
// and its expected variance, sum of weight^2 envelope^2 / 2 (z; of a spot weight^2 spot^2); phasor:
// the real (x) and imaginary part (y). 0 where nothing is seen. What does not apply is empty.
struct NoiseSums
{
  std::vector<float> x, y, z;
};
NoiseSums noiseSums(Span<const NoiseKernel> kernels, const NoiseSurroundings& surroundings,
  const NoiseFieldOptions& options);

// The same straight from the definition in double precision, slowly. All agree to 1e-5 of the sums'
// deviation, but at rims of kernels, where rounding decides which pixels are inside.
struct NoiseReference
{
  std::vector<double> x, y, z;
};
NoiseReference noiseReference(Span<const NoiseKernel> kernels,
  const NoiseSurroundings& surroundings, const NoiseFieldOptions& options);

// Share of a normalised noise of `overlap` kernels that lies below a value, tabulated within .001:
// cached. That noise is the sum over the root of its variance plus noiseVarianceFloor.
struct NoiseDistribution
{
  double range = 0.0;       // values from -range to range
  std::vector<float> share; // at equal steps; 0 to 1, growing
};
std::shared_ptr<const NoiseDistribution> noiseDistribution(double overlap);

// Thresholds of 256 tones, i / 255, for noise of these kernels (frequency, bandwidth, spread as in
// NoiseKernelOptions) drawn with inkCoverage: mean ink equals the tone. The first prints nothing
// and the last everything, -.5 and 1.5. Measured with pictures made of the seed; cached.
struct NoiseThresholdOptions
{
  NoiseFieldOptions field;
  double frequency = 0.125;
  double radius = 16.0;
  double spread = 0.0;
  std::uint32_t seed = 1;
};
std::vector<float> noiseThresholds(const NoiseThresholdOptions& options);

} // namespace hachure

#endif

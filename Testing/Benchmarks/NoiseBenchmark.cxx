// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-noise-benchmark: processor time (and time by the clock) of the noise of a sphere that
/// covers 28 % of the picture, 32 kernels of radius 8 over every pixel: of the sums alone and of
/// the whole field, over the number of pixels in all kernels' discs.

#include "Core/Kernels.h"
#include "Core/NoiseField.h"
#include "Core/NoiseVisibility.h"
#include "Core/Random.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <omp.h>
#include <vector>

namespace
{
using namespace hachure;

constexpr float kernelRadius = 8.0f;
constexpr double overlap = 32.0;
constexpr double pi = 3.14159265358979323846;

// A sphere in a parallel view; window depth 0 to 1 is twice its diameter.
struct Scene
{
  int width, height;
  double radius;
  std::vector<float> depth;
  std::vector<NoiseKernel> kernels;

  Scene(int columns, int rows)
    : width(columns)
    , height(rows)
    , radius(std::sqrt(0.28 * columns * rows / pi))
  {
    this->depth.reserve(static_cast<std::size_t>(columns) * rows);
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i)
      {
        const double square = this->heightSquare(i + 0.5, j + 0.5);
        this->depth.push_back(square > 0.0 ? this->depthAt(std::sqrt(square)) : 1.0f);
      }
    }
    const double density = overlap / (pi * kernelRadius * kernelRadius);
    const auto count = static_cast<std::uint64_t>(4.0 * density * this->radius * this->radius);
    this->kernels.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      this->addKernel(i);
    }
  }
  NoiseSurroundings surroundings() const
  {
    NoiseSurroundings result;
    result.rectangle = { 0, 0, this->width, this->height };
    result.depth = this->depth;
    result.depthTolerance =
      noiseDepthToleranceFor(kernelRadius, static_cast<float>(0.25 / this->radius));
    return result;
  }

private:
  double heightSquare(double x, double y) const
  {
    const double a = x - 0.5 * this->width;
    const double b = y - 0.5 * this->height;
    return this->radius * this->radius - a * a - b * b;
  }
  float depthAt(double z) const { return static_cast<float>(0.5 - 0.25 * z / this->radius); }
  void addKernel(std::uint64_t id)
  {
    NoiseKernel kernel;
    const auto random = [id](std::uint32_t dimension) { return unitRandom(1, id, dimension); };
    const double x = 0.5 * this->width + this->radius * (2.0 * random(0) - 1.0);
    const double y = 0.5 * this->height + this->radius * (2.0 * random(1) - 1.0);
    const double square = this->heightSquare(x, y);
    if (!(square > 1.0))
    {
      return;
    }
    kernel.center = { x, y };
    kernel.depth = this->depthAt(std::sqrt(square));
    const double slope = 0.25 / (this->radius * std::sqrt(square));
    kernel.depthSlope = { slope * (x - 0.5 * this->width), slope * (y - 0.5 * this->height) };
    kernel.bandwidth = glsl::kernelBandwidth(kernelRadius);
    kernel.phase = static_cast<float>(2.0 * pi * random(2));
    kernel.orientation = static_cast<float>(pi * random(3));
    this->kernels.push_back(kernel);
  }
};

// The least times of several calls of body(), since others only ever add to them: of the processors
// and by the clock, in nanoseconds.
struct Cost
{
  double processor = 1e30, clock = 1e30;
};

template <class Body>
Cost leastCost(Body&& body)
{
  using Clock = std::chrono::steady_clock;
  Cost best;
  for (int repeat = 0; repeat < 12; ++repeat)
  {
    const Clock::time_point start = Clock::now();
    const std::clock_t before = std::clock();
    body();
    const double used = static_cast<double>(std::clock() - before) * (1e9 / CLOCKS_PER_SEC);
    const std::chrono::duration<double, std::nano> passed = Clock::now() - start;
    best = { std::min(best.processor, used), std::min(best.clock, passed.count()) };
  }
  return best;
}

double measure(const Scene& scene, const char* name, const NoiseFieldOptions& options, int threads)
{
  omp_set_num_threads(threads);
  const double pixels =
    pi * kernelRadius * kernelRadius * static_cast<double>(scene.kernels.size());
  double checksum = 0.0;
  const Cost sums =
    leastCost([&] { checksum += noiseSums(scene.kernels, scene.surroundings(), options).x[0]; });
  const Cost field = leastCost(
    [&] { checksum += noiseField(scene.kernels, scene.surroundings(), options).value[0]; });
  std::printf("{\"kind\": \"%s\", \"threads\": %d, \"kernels\": %zu, "
              "\"sums_ns_per_kernel_pixel\": %.3f, \"field_ns_per_kernel_pixel\": %.3f, "
              "\"field_ms\": %.2f}\n",
    name, threads, scene.kernels.size(), sums.processor / pixels, field.processor / pixels,
    field.clock * 1e-6);
  return checksum;
}
} // namespace

int main(int argumentCount, char** arguments)
{
  const int width = argumentCount > 1 ? std::atoi(arguments[1]) : 1280;
  const int height = argumentCount > 2 ? std::atoi(arguments[2]) : 720;
  if (width < 16 || height < 16 || argumentCount > 3)
  {
    std::fputs("usage: hachure-noise-benchmark [width [height]]\n", stderr);
    return 2;
  }
  const Scene scene(width, height);
  const NoiseSpot spot = { 4, 4, { 0, 1, 1, 0, 1, 3, 3, 1, 1, 3, 3, 1, 0, 1, 1, 0 } };
  double checksum = 0.0;
  for (const int threads : { 1, 2 })
  {
    checksum += measure(scene, "gabor", { NoiseKind::gabor, overlap, nullptr }, threads);
    checksum += measure(scene, "phasor", { NoiseKind::phasor, overlap, nullptr }, threads);
    checksum += measure(scene, "spot", { NoiseKind::spot, overlap, &spot }, threads);
  }
  return std::isfinite(checksum) ? 0 : 1;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseScenes_h
#define hachure_NoiseScenes_h

#include "Core/Kernels.h"
#include "Core/NoiseField.h"
#include "Core/Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Kernels and depth images for the tests of noise fields.
namespace hachure::testing
{

constexpr double pi = 3.14159265358979323846;

struct FlatNoise
{
  std::array<int, 4> rectangle{ 0, 0, 128, 128 };
  double overlap = 32.0;
  double radius = 8.0;
  double frequency = 0.125;
  double orientation = 0.0;
  double spread = 0.0;
  std::uint32_t seed = 1;

  // A Poisson process of kernels on a surface that fills the rectangle and goes on outside.
  std::vector<NoiseKernel> kernels() const
  {
    const double width = this->rectangle[2] + 2.0 * this->radius;
    const double height = this->rectangle[3] + 2.0 * this->radius;
    const double mean = this->overlap * width * height / (pi * this->radius * this->radius);
    const auto count = static_cast<std::uint64_t>(std::llround(mean));
    std::vector<NoiseKernel> result(count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      const auto random = [&](std::uint32_t dimension)
      { return unitRandom(this->seed, i, dimension); };
      NoiseKernel& kernel = result[i];
      kernel.center.x = static_cast<float>(this->rectangle[0] - this->radius + width * random(0));
      kernel.center.y = static_cast<float>(this->rectangle[1] - this->radius + height * random(1));
      kernel.phase = static_cast<float>(2.0 * pi * random(2));
      kernel.frequency = static_cast<float>(this->frequency);
      kernel.bandwidth = glsl::kernelBandwidth(static_cast<float>(this->radius));
      kernel.orientation =
        static_cast<float>(this->orientation + this->spread * (2.0 * random(3) - 1.0));
      kernel.id = i;
    }
    return result;
  }
  NoiseSurroundings surroundings() const
  {
    NoiseSurroundings result;
    result.rectangle = this->rectangle;
    return result;
  }
};

// A function of the pixels of a rectangle, row by row.
template <class T, class Function>
std::vector<T> imageOf(const std::array<int, 4>& rectangle, Function&& function)
{
  std::vector<T> result;
  result.reserve(static_cast<std::size_t>(rectangle[2]) * rectangle[3]);
  for (int row = 0; row < rectangle[3]; ++row)
  {
    for (int column = 0; column < rectangle[2]; ++column)
    {
      result.push_back(
        static_cast<T>(function(rectangle[0] + column + 0.5, rectangle[1] + row + 0.5)));
    }
  }
  return result;
}

// The centre of a pixel of a rectangle.
inline glm::dvec2 centerOf(const std::array<int, 4>& rectangle, std::size_t pixel)
{
  const std::size_t column = pixel % rectangle[2];
  const std::size_t row = pixel / rectangle[2];
  return glm::dvec2(column, row) + glm::dvec2(rectangle[0] + 0.5, rectangle[1] + 0.5);
}

// A sphere seen from far away, in pixels; one pixel of depth is depthPerPixel of window depth.
struct Sphere
{
  double x = 0.0, y = 0.0, radius = 1.0;
  double depthPerPixel = 1e-3;
  double center = 0.5; // window depth

  // Negative outside.
  double heightSquare(double column, double row) const
  {
    const double a = column - this->x;
    const double b = row - this->y;
    return this->radius * this->radius - a * a - b * b;
  }
  double depthAt(double column, double row) const
  {
    const double square = this->heightSquare(column, row);
    return square > 0.0 ? this->center - this->depthPerPixel * std::sqrt(square) : 1.0;
  }
  // Puts a kernel onto the sphere; those outside have weight 0.
  void place(NoiseKernel& kernel) const
  {
    const double square = this->heightSquare(kernel.center.x, kernel.center.y);
    kernel.weight = square > 0.0 ? kernel.weight : 0.0f;
    const double height = std::sqrt(std::max(square, 1e-3));
    kernel.depth = static_cast<float>(this->center - this->depthPerPixel * height);
    const double slope = this->depthPerPixel / height;
    kernel.depthSlope = { slope * (kernel.center.x - this->x),
      slope * (kernel.center.y - this->y) };
  }
};

// Root mean square of the normalised sums at pixels that are chosen.
template <class Choose>
double normalisedDeviation(const NoiseSums& sums, Choose&& choose)
{
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < sums.x.size(); ++i)
  {
    if (choose(i) && sums.z[i] > 0.0f)
    {
      squares += static_cast<double>(sums.x[i]) * sums.x[i] / sums.z[i];
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

} // namespace hachure::testing

#endif

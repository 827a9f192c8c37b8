// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OctaveContrast.h"

#include "Kernels.h"
#include "TileChecks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hachure
{
namespace
{

// Below this a transition would begin with a jump.
constexpr double leastContrast = 0.25;
// Variance in square pixels: that of the eye, and of a box as wide as a pixel.
constexpr double blurVariance = 1.0 + 1.0 / 12.0;

struct Picture
{
  int width;
  int height;
  std::vector<float> ink;
};

// A convolution along x that repeats, of a picture that is returned turned by a quarter.
Picture blurredAlongX(const Picture& picture, const std::vector<float>& weights)
{
  const int radius = static_cast<int>(weights.size()) - 1;
  Picture turned{ picture.height, picture.width, std::vector<float>(picture.ink.size()) };
  std::vector<float> row(static_cast<std::size_t>(picture.width) + 2 * radius);
  for (int y = 0; y < picture.height; ++y)
  {
    const float* ink = &picture.ink[static_cast<std::size_t>(y) * picture.width];
    const int whole = (radius / picture.width + 1) * picture.width;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      row[i] = ink[(static_cast<int>(i) - radius + whole) % picture.width];
    }
    for (int x = 0; x < picture.width; ++x)
    {
      const float* middle = &row[static_cast<std::size_t>(x) + radius];
      float sum = weights[0] * middle[0];
      for (int k = 1; k <= radius; ++k)
      {
        sum += weights[k] * (middle[-k] + middle[k]);
      }
      turned.ink[static_cast<std::size_t>(x) * picture.height + y] = sum;
    }
  }
  return turned;
}

// Of a Gaussian, from its middle on to where nothing is left of it.
std::vector<float> gaussian(double deviation)
{
  const int radius = static_cast<int>(std::ceil(3.5 * deviation));
  std::vector<double> values(radius + 1);
  double sum = 0.0;
  for (int k = 0; k <= radius; ++k)
  {
    values[k] = std::exp(-0.5 * k * k / (deviation * deviation));
    sum += (k == 0 ? 1.0 : 2.0) * values[k];
  }
  std::vector<float> weights;
  weights.reserve(values.size());
  for (const double value : values)
  {
    weights.push_back(static_cast<float>(value / sum));
  }
  return weights;
}

double blurredVariance(const Picture& picture, double deviation)
{
  const std::vector<float> weights = gaussian(deviation);
  const Picture blurred = blurredAlongX(blurredAlongX(picture, weights), weights);
  double sum = 0.0;
  double squares = 0.0;
  for (const float ink : blurred.ink)
  {
    sum += ink;
    squares += static_cast<double>(ink) * ink;
  }
  const auto count = static_cast<double>(blurred.ink.size());
  return std::max(0.0, squares / count - sum * sum / (count * count));
}

} // namespace

double octaveContrast(Span<const PatternTile> mips, double texelsPerPixel)
{
  if (!(texelsPerPixel > 0.0) || !std::isfinite(texelsPerPixel))
  {
    check::fail("octaveContrast", "texelsPerPixel",
      std::to_string(texelsPerPixel) + ", expected a positive number");
  }
  // The level with 1.4 to 2.8 texels per pixel, enough for a Gaussian of a pixel.
  const auto fitting = static_cast<std::size_t>(std::max(0.0, std::log2(texelsPerPixel) - 0.5));
  const std::size_t level = std::min(fitting, mips.size() - 1);
  const PatternTile& tile = mips[level];
  Picture picture{ tile.width, tile.height, {} };
  picture.ink.reserve(tile.screen.size());
  const auto step = std::ldexp(1.0f, static_cast<int>(level)); // gradients are those of level 0
  for (std::size_t i = 0; i < tile.screen.size(); ++i)
  {
    picture.ink.push_back(glsl::inkCoverage(tile.screen[i], 0.5f, step * tile.gradient[i]));
  }
  // The blur of a pixel covers the whole tile where it is wider than that.
  const double widest = 0.5 * std::min(tile.width, tile.height);
  const double deviation =
    std::sqrt(blurVariance) * std::ldexp(texelsPerPixel, -static_cast<int>(level));
  const double first = blurredVariance(picture, std::min(deviation, widest));
  const double second = blurredVariance(picture, std::min(2.0 * deviation, widest));
  constexpr double nothing = 1.0e-9;
  return first > nothing ? std::clamp(std::sqrt(second / first), leastContrast, 1.0)
                         : leastContrast;
}

} // namespace hachure

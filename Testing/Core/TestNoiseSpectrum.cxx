// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoiseScenes.h"

#include <gtest/gtest.h>

#include <complex>

using namespace hachure;
using namespace hachure::testing;

namespace
{

// Power of an image's spectrum at a frequency, in cycles per pixel, under a smooth window.
double powerAt(const std::vector<float>& image, int side, double fx, double fy)
{
  std::vector<std::complex<double>> columns;
  columns.reserve(static_cast<std::size_t>(side));
  const auto window = [side](int i) { return std::sin(pi * (i + 0.5) / side); };
  for (int i = 0; i < side; ++i)
  {
    columns.push_back(window(i) * std::polar(1.0, -2.0 * pi * fx * i));
  }
  std::complex<double> sum = 0.0;
  for (int row = 0; row < side; ++row)
  {
    std::complex<double> line = 0.0;
    for (int i = 0; i < side; ++i)
    {
      line += columns[i] * static_cast<double>(image[static_cast<std::size_t>(row) * side + i]);
    }
    sum += line * window(row) * std::polar(1.0, -2.0 * pi * fy * row);
  }
  return std::norm(sum);
}

FlatNoise largeNoise(double frequency, double radius)
{
  FlatNoise noise;
  noise.rectangle = { 0, 0, 384, 384 };
  noise.frequency = frequency;
  noise.radius = radius;
  return noise;
}

} // namespace

// The radial power of isotropic noise has its peak at f = F0 I1(x) / I0(x), x = f F0 / s^2, where
// the kernel's power is a Gaussian of deviation s = a / sqrt(4 pi).
TEST(NoiseSpectrum, IsotropicSpectrumPeaksBelowTheFrequency)
{
  FlatNoise noise = largeNoise(0.125, 14.0);
  noise.spread = 0.5 * pi;
  const double s = glsl::kernelBandwidth(14.0f) / std::sqrt(4.0 * pi);
  double expected = noise.frequency;
  for (int i = 0; i < 100; ++i)
  {
    const double x = expected * noise.frequency / (s * s);
    expected = noise.frequency * std::cyl_bessel_i(1.0, x) / std::cyl_bessel_i(0.0, x);
  }
  std::vector<double> power(41, 0.0);
  for (std::uint32_t seed = 1; seed <= 2; ++seed)
  {
    noise.seed = seed;
    const auto image = noiseSums(noise.kernels(), noise.surroundings(), {}).x;
    for (int step = 0; step <= 40; ++step)
    {
      for (int direction = 0; direction < 24; ++direction)
      {
        const double f = noise.frequency * (0.6 + 0.02 * step);
        const double angle = pi * direction / 24.0;
        power[step] += powerAt(image, 384, f * std::cos(angle), f * std::sin(angle));
      }
    }
  }
  // The centre of what rises above most of it.
  double weights = 0.0, mean = 0.0;
  const double most = *std::max_element(power.begin(), power.end());
  for (int step = 0; step <= 40; ++step)
  {
    const double weight = std::max(power[step] - 0.4 * most, 0.0);
    weights += weight;
    mean += weight * noise.frequency * (0.6 + 0.02 * step);
  }
  EXPECT_NEAR(mean / weights / expected, 1.0, 0.03);
  EXPECT_LT(expected, 0.99 * noise.frequency);
}

TEST(NoiseSpectrum, AnisotropicSpectrumHasFrequencyOrientationAndBandwidth)
{
  FlatNoise noise = largeNoise(0.11, 12.0);
  noise.orientation = 0.6;
  const double expectedWidth = glsl::kernelBandwidth(12.0f) / std::sqrt(4.0 * pi);
  double sum = 0.0, x = 0.0, y = 0.0, square = 0.0;
  constexpr int half = 12;
  for (std::uint32_t seed = 1; seed <= 2; ++seed)
  {
    noise.seed = seed;
    const auto image = noiseSums(noise.kernels(), noise.surroundings(), {}).x;
    for (int j = -half; j <= half; ++j)
    {
      for (int i = -half; i <= half; ++i)
      {
        const glm::dvec2 offset = glm::dvec2(i, j) * (3.5 * expectedWidth / half);
        const double fx = noise.frequency * std::cos(noise.orientation) + offset.x;
        const double fy = noise.frequency * std::sin(noise.orientation) + offset.y;
        const double power = powerAt(image, 384, fx, fy);
        sum += power;
        x += power * fx;
        y += power * fy;
        square += power * glm::dot(offset, offset);
      }
    }
  }
  x /= sum;
  y /= sum;
  EXPECT_NEAR(std::hypot(x, y) / noise.frequency, 1.0, 0.03);
  EXPECT_NEAR(std::atan2(y, x), noise.orientation, 2.0 * pi / 180.0);
  // Per direction; the cut at 5 % widens it a little.
  EXPECT_NEAR(std::sqrt(0.5 * square / sum) / expectedWidth, 1.0, 0.06);
}

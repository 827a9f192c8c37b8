// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsImage.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hachure
{

namespace
{

constexpr std::int64_t rowsPerRange = 8;

std::vector<float> gaussianWeights(double sigma)
{
  const int radius = static_cast<int>(std::ceil(4.0 * sigma)); // the rest is below 1e-4
  std::vector<float> weights;
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i)
  {
    sum += std::exp(-0.5 * i * i / (sigma * sigma));
  }
  for (int i = -radius; i <= radius; ++i)
  {
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum));
  }
  return weights;
}

// Convolves along x and turns the image by exchanging x and y, so that two calls do both.
MetricImage convolvedAndTransposed(const ImageView& image, const std::vector<float>& weights)
{
  const int radius = static_cast<int>(weights.size() / 2);
  const int width = image.width;
  const int height = image.height;
  MetricImage result{ height, width, std::vector<float>(image.values.size()) };
  parallelForRanges(height, rowsPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t y = begin; y < end; ++y)
      {
        const float* row = image.values.data() + y * width;
        for (int x = 0; x < width; ++x)
        {
          float sum = 0.0f;
          for (int k = -radius; k <= radius; ++k)
          {
            const int tap = k + radius;
            sum += weights[static_cast<std::size_t>(tap)] * row[std::clamp(x + k, 0, width - 1)];
          }
          result.values[static_cast<std::size_t>(x * static_cast<std::int64_t>(height) + y)] = sum;
        }
      }
    });
  return result;
}

// The recursive filter that turns values into coefficients of a cubic B-spline,
// with the border mirrored.
void splineFilter(float* values, std::int64_t count, std::int64_t stride)
{
  if (count < 2)
  {
    return;
  }
  const double pole = std::sqrt(3.0) - 2.0;
  const std::int64_t horizon = std::min<std::int64_t>(count, 16); // pole^16 is below 1e-9
  double sum = 0.0;
  for (std::int64_t i = horizon - 1; i >= 0; --i)
  {
    sum = values[i * stride] + pole * sum;
  }
  double previous = 6.0 * sum;
  std::vector<double> line(static_cast<std::size_t>(count));
  line[0] = previous;
  for (std::int64_t i = 1; i < count; ++i)
  {
    previous = 6.0 * values[i * stride] + pole * previous;
    line[static_cast<std::size_t>(i)] = previous;
  }
  const auto last = static_cast<std::size_t>(count - 1);
  line[last] = pole / (pole * pole - 1.0) * (line[last] + pole * line[last - 1]);
  for (std::size_t i = last; i-- > 0;)
  {
    line[i] = pole * (line[i + 1] - line[i]);
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    values[i * stride] = static_cast<float>(line[static_cast<std::size_t>(i)]);
  }
}

void splineWeights(double t, double weights[4])
{
  const double rest = 1.0 - t;
  weights[0] = rest * rest * rest / 6.0;
  weights[1] = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
  weights[2] = 2.0 / 3.0 - 0.5 * rest * rest * (2.0 - rest);
  weights[3] = t * t * t / 6.0;
}

// Along x, and turned as above.
std::vector<std::uint8_t> erodedAndTransposed(
  const std::vector<std::uint8_t>& mask, int width, int height, int radius)
{
  std::vector<std::uint8_t> result(mask.size(), 0);
  for (int y = 0; y < height; ++y)
  {
    int run = 0; // pixels of the mask that end at x
    for (int x = 0; x < width; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
      run = mask[i + static_cast<std::size_t>(x)] != 0 ? run + 1 : 0;
      if (run > 2 * radius)
      {
        const auto centre = static_cast<std::size_t>(x - radius);
        result[centre * static_cast<std::size_t>(height) + static_cast<std::size_t>(y)] = 1;
      }
    }
  }
  return result;
}

} // namespace

MetricImage smoothed(const ImageView& image, double sigma)
{
  if (sigma <= 0.0)
  {
    return { image.width, image.height, { image.values.begin(), image.values.end() } };
  }
  const std::vector<float> weights = gaussianWeights(sigma);
  return convolvedAndTransposed(convolvedAndTransposed(image, weights).view(), weights);
}

MetricImage smoothedInside(
  const ImageView& image, const std::vector<std::uint8_t>& mask, double sigma, MetricImage& support)
{
  MetricImage inside{ image.width, image.height, { mask.begin(), mask.end() } };
  const auto columns = static_cast<std::size_t>(image.width);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    // The border stands for all beyond it, and that is outside.
    const std::size_t x = i % columns;
    if (x == 0 || x + 1 == columns || i < columns || i + columns >= mask.size())
    {
      inside.values[i] = 0.0f;
    }
  }
  support = smoothed(inside.view(), sigma);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    inside.values[i] *= mask[i] != 0 ? image.values[i] : 1.0f;
  }
  MetricImage result = smoothed(inside.view(), sigma);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    result.values[i] = support.values[i] > 0.0f ? result.values[i] / support.values[i] : 0.0f;
  }
  return result;
}

MetricImage splineCoefficients(const MetricImage& image)
{
  MetricImage result = image;
  parallelForRanges(image.height, rowsPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t y = begin; y < end; ++y)
      {
        splineFilter(result.values.data() + y * image.width, image.width, 1);
      }
    });
  parallelForRanges(image.width, rowsPerRange,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t x = begin; x < end; ++x)
      {
        splineFilter(result.values.data() + x, image.height, image.width);
      }
    });
  return result;
}

double sampleSpline(const MetricImage& coefficients, double x, double y)
{
  const double floorX = std::floor(x);
  const double floorY = std::floor(y);
  double weightsX[4], weightsY[4];
  splineWeights(x - floorX, weightsX);
  splineWeights(y - floorY, weightsY);
  const int left = static_cast<int>(floorX) - 1;
  const int bottom = static_cast<int>(floorY) - 1;
  double sum = 0.0;
  for (int j = 0; j < 4; ++j)
  {
    const int row = std::clamp(bottom + j, 0, coefficients.height - 1);
    const float* values =
      coefficients.values.data() + static_cast<std::ptrdiff_t>(row) * coefficients.width;
    double line = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      line += weightsX[i] * values[std::clamp(left + i, 0, coefficients.width - 1)];
    }
    sum += weightsY[j] * line;
  }
  return sum;
}

void sampleSplineRow(
  const MetricImage& coefficients, int y, double shiftX, double shiftY, std::vector<float>& row)
{
  const int width = coefficients.width;
  row.assign(static_cast<std::size_t>(width), 0.0f);
  const double floorX = std::floor(shiftX);
  const double floorY = std::floor(shiftY);
  const int left = static_cast<int>(floorX) - 1;
  const int bottom = y + static_cast<int>(floorY) - 1;
  if (bottom < 0 || bottom + 3 >= coefficients.height)
  {
    return;
  }
  double weightsX[4], weightsY[4];
  splineWeights(shiftX - floorX, weightsX);
  splineWeights(shiftY - floorY, weightsY);
  const float* lines = coefficients.values.data() + static_cast<std::ptrdiff_t>(bottom) * width;
  std::vector<float> across(row.size());
  for (int x = 0; x < width; ++x)
  {
    double sum = 0.0;
    for (int j = 0; j < 4; ++j)
    {
      sum += weightsY[j] * lines[static_cast<std::ptrdiff_t>(j) * width + x];
    }
    across[static_cast<std::size_t>(x)] = static_cast<float>(sum);
  }
  const int end = std::min(width, width - 3 - left);
  for (int x = std::max(0, -left); x < end; ++x)
  {
    const float* taps = across.data() + x + left;
    row[static_cast<std::size_t>(x)] = static_cast<float>(weightsX[0] * taps[0] +
      weightsX[1] * taps[1] + weightsX[2] * taps[2] + weightsX[3] * taps[3]);
  }
}

std::vector<std::uint8_t> eroded(
  const std::vector<std::uint8_t>& mask, int width, int height, int radius)
{
  return erodedAndTransposed(
    erodedAndTransposed(mask, width, height, radius), height, width, radius);
}

void checkSameSize(int width, int height, const ImageView& first, const std::string& name)
{
  if (width < 1 || height < 1 || width != first.width || height != first.height)
  {
    throw std::invalid_argument(name + ": " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels, expected the size of frame 0, " +
      std::to_string(first.width) + " x " + std::to_string(first.height) + ", at least 1 x 1");
  }
}

void checkInk(const ImageView& image, const std::string& name)
{
  const auto pixels =
    static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.values.size() != pixels)
  {
    throw std::invalid_argument(name + ": " + std::to_string(image.values.size()) +
      " values, expected " + std::to_string(pixels));
  }
  constexpr float rounding = 0.01f; // of pictures that were stored as bytes or filtered
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (!(image.values[i] >= -rounding && image.values[i] <= 1.0f + rounding))
    {
      throw std::invalid_argument(name + ": ink " + std::to_string(image.values[i]) + " at pixel " +
        pixelName(i, image.width) + ", expected a number from 0 to 1");
    }
  }
}

std::string pixelName(std::size_t index, int width)
{
  const auto columns = static_cast<std::size_t>(width);
  return "(" + std::to_string(index % columns) + ", " + std::to_string(index / columns) + ")";
}

} // namespace hachure

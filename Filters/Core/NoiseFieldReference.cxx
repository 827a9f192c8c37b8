// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseFieldTiles.h"

#include "Kernels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

// Everything pixel by pixel and kernel by kernel, in double precision: nothing is shared with the
// fast loops but the constants.
namespace hachure
{

namespace
{

constexpr double pi = 3.14159265358979323846;
const double rimExponent = -std::log(0.05);

double radiusOf(const NoiseKernel& kernel)
{
  return std::sqrt(rimExponent / pi) / kernel.bandwidth;
}

glm::dvec2 offsetOf(const NoiseKernel& kernel, int column, int row)
{
  return glm::dvec2(column + 0.5, row + 0.5) - glm::dvec2(kernel.center);
}

// What is known of a pixel of the framebuffer.
struct Surroundings
{
  const NoiseSurroundings& known;

  bool contains(int column, int row) const
  {
    const auto& [left, bottom, width, height] = this->known.rectangle;
    return column >= left && column < left + width && row >= bottom && row < bottom + height;
  }
  std::size_t pixel(int column, int row) const
  {
    return static_cast<std::size_t>(row - this->known.rectangle[1]) * this->known.rectangle[2] +
      (column - this->known.rectangle[0]);
  }
  bool seen(std::size_t pixel) const
  {
    return this->known.depth.empty() || this->known.depth[pixel] < 1.0f;
  }
  double onPlane(const NoiseKernel& kernel, glm::dvec2 offset, std::size_t pixel) const
  {
    if (this->known.depth.empty())
    {
      return 1.0;
    }
    const glm::dvec2 slope(kernel.depthSlope);
    const double tolerance = this->known.depthTolerance +
      glsl::noiseSlopeTolerance * glm::length(slope) * glm::dot(offset, offset) / radiusOf(kernel);
    const double deviation =
      this->known.depth[pixel] - static_cast<double>(kernel.depth) - glm::dot(slope, offset);
    const double x = std::clamp(2.0 - std::abs(deviation) / tolerance, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
  }
  bool ofObject(const NoiseKernel& kernel, std::size_t pixel) const
  {
    return this->known.objects.empty() || this->known.objects[pixel] == kernel.object;
  }
  bool ofTriangle(const NoiseKernel& kernel, std::size_t pixel) const
  {
    return this->known.triangles.empty() || this->known.triangles[pixel] == kernel.triangle;
  }
};

// Partial visibility, as NoiseVisibility describes it.
struct Share
{
  double seen = 1.0;
  bool complete = true;
};

Share shareOf(const NoiseKernel& kernel, const Surroundings& surroundings)
{
  const double radius = radiusOf(kernel);
  const int step = static_cast<int>(std::max(std::ceil(radius / 3.0), 1.0));
  const double reach = radius + 0.5 * step;
  double all = 0.0, seen = 0.0;
  Share result;
  const auto first = [&](float center) { return std::ceil((center - reach - 0.5) / step) * step; };
  for (int row = static_cast<int>(first(kernel.center.y)); row + 0.5 <= kernel.center.y + reach;
       row += step)
  {
    for (int column = static_cast<int>(first(kernel.center.x));
         column + 0.5 <= kernel.center.x + reach; column += step)
    {
      const glm::dvec2 offset = offsetOf(kernel, column, row);
      if (!surroundings.contains(column, row) || glm::length(offset) > reach)
      {
        continue;
      }
      const std::size_t pixel = surroundings.pixel(column, row);
      const double visible = surroundings.seen(pixel) && surroundings.ofObject(kernel, pixel)
        ? surroundings.onPlane(kernel, offset, pixel)
        : 0.0;
      const double inside = std::max(1.0 - glm::dot(offset, offset) / (radius * radius), 0.0);
      all += inside * inside;
      seen += inside * inside * visible;
      result.complete = result.complete && (visible == 1.0 || !surroundings.seen(pixel));
    }
  }
  const double shown = std::clamp((seen / std::max(all, 1e-30) - 0.1) / 0.9, 0.0, 1.0);
  return all > 0.0 ? Share{ shown, result.complete } : Share{ 1.0, false };
}

double spotAt(const NoiseSpot& spot, glm::dvec2 place)
{
  double mean = 0.0;
  for (const float value : spot.values)
  {
    mean += value / static_cast<double>(spot.values.size());
  }
  const glm::dvec2 texel =
    (0.5 * place + 0.5) * glm::dvec2(spot.width, spot.height) - glm::dvec2(0.5);
  const auto at = [&](double column, double row)
  {
    const int i = std::clamp(static_cast<int>(column), 0, spot.width - 1);
    const int j = std::clamp(static_cast<int>(row), 0, spot.height - 1);
    return spot.values[static_cast<std::size_t>(j) * spot.width + i] - mean;
  };
  const glm::dvec2 low = glm::floor(texel);
  const glm::dvec2 part = texel - low;
  return glm::mix(glm::mix(at(low.x, low.y), at(low.x + 1.0, low.y), part.x),
    glm::mix(at(low.x, low.y + 1.0), at(low.x + 1.0, low.y + 1.0), part.x), part.y);
}

// A kernel of weight 1 at an offset: value in the real part, and its expected variance.
struct Sample
{
  std::complex<double> value;
  double variance;
};

Sample sampleOf(const NoiseKernel& kernel, const NoiseFieldOptions& options, glm::dvec2 offset)
{
  const double orientation = kernel.orientation;
  const glm::dvec2 along(std::cos(orientation), std::sin(orientation));
  if (options.kind == NoiseKind::spot)
  {
    const glm::dvec2 across(-along.y, along.x);
    const glm::dvec2 place(glm::dot(offset, along), glm::dot(offset, across));
    const double value = spotAt(*options.spot, place / radiusOf(kernel));
    return { std::cos(static_cast<double>(kernel.phase)) >= 0.0 ? value : -value, value * value };
  }
  const double bandwidth = kernel.bandwidth;
  const double envelope = std::exp(-pi * bandwidth * bandwidth * glm::dot(offset, offset));
  const double angle = 2.0 * pi * kernel.frequency * glm::dot(offset, along) + kernel.phase;
  return { std::polar(envelope, angle), 0.5 * envelope * envelope };
}

bool isDrawable(const NoiseKernel& kernel)
{
  return std::isfinite(kernel.center.x + kernel.center.y + kernel.weight + kernel.phase +
           kernel.frequency + kernel.bandwidth + kernel.orientation + kernel.depth +
           kernel.depthSlope.x + kernel.depthSlope.y) &&
    kernel.weight > 0.0f && kernel.bandwidth > 0.0f;
}

// How much a seen pixel counts.
double passOf(const NoiseKernel& kernel, const Surroundings& surroundings, const Share& share,
  glm::dvec2 offset, std::size_t pixel)
{
  if (!surroundings.seen(pixel) || !surroundings.ofObject(kernel, pixel) ||
    !surroundings.ofTriangle(kernel, pixel))
  {
    return 0.0;
  }
  return surroundings.known.depthTest && !share.complete
    ? surroundings.onPlane(kernel, offset, pixel)
    : 1.0;
}

void addKernel(const NoiseKernel& kernel, const Surroundings& surroundings,
  const NoiseFieldOptions& options, NoiseReference& result)
{
  const auto& [left, bottom, width, height] = surroundings.known.rectangle;
  const Share share = shareOf(kernel, surroundings);
  const bool partial = surroundings.known.partialVisibility &&
    !(surroundings.known.depth.empty() && surroundings.known.objects.empty());
  const double weight = kernel.weight * (partial ? share.seen : 1.0);
  const bool hidden = share.seen == 0.0 &&
    (partial || (surroundings.known.depthTest && !surroundings.known.depth.empty()));
  for (int row = bottom; row < bottom + height && !hidden; ++row)
  {
    for (int column = left; column < left + width; ++column)
    {
      const glm::dvec2 offset = offsetOf(kernel, column, row);
      const std::size_t pixel = surroundings.pixel(column, row);
      const double pass = glm::length(offset) <= radiusOf(kernel)
        ? weight * passOf(kernel, surroundings, share, offset, pixel)
        : 0.0;
      if (pass > 0.0)
      {
        const Sample sample = sampleOf(kernel, options, offset);
        result.x[pixel] += pass * sample.value.real();
        (options.kind == NoiseKind::phasor ? result.y : result.z)[pixel] +=
          options.kind == NoiseKind::phasor ? pass * sample.value.imag()
                                            : pass * pass * sample.variance;
      }
    }
  }
}

} // namespace

NoiseReference noiseReference(Span<const NoiseKernel> kernels,
  const NoiseSurroundings& surroundings, const NoiseFieldOptions& options)
{
  noise::checkNoiseInput(surroundings, options);
  const std::size_t pixels =
    static_cast<std::size_t>(surroundings.rectangle[2]) * surroundings.rectangle[3];
  NoiseReference result;
  result.x.assign(pixels, 0.0);
  (options.kind == NoiseKind::phasor ? result.y : result.z).assign(pixels, 0.0);
  for (const NoiseKernel& kernel : kernels)
  {
    if (isDrawable(kernel))
    {
      addKernel(kernel, { surroundings }, options, result);
    }
  }
  return result;
}

} // namespace hachure

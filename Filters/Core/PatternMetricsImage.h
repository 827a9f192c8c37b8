// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternMetricsImage_h
#define hachure_PatternMetricsImage_h

#include "PatternMetrics.h"

#include <string>

// Smoothing, exact look-up between pixels, and checks of the images that are measured.
namespace hachure
{

struct MetricImage
{
  int width = 0;
  int height = 0;
  std::vector<float> values;

  ImageView view() const { return { this->width, this->height, this->values }; }
};

// Gaussian of this deviation, in pixels (0 = a copy); beyond the border stands the border pixel.
MetricImage smoothed(const ImageView& image, double sigma);

// The mean of the pixels with mask 1 around each pixel, Gaussian weights; `support` gets the share
// of the weights that has mask 1, 0 to 1. The outermost pixels count as mask 0.
MetricImage smoothedInside(const ImageView& image, const std::vector<std::uint8_t>& mask,
  double sigma, MetricImage& support);

// The cubic spline through all pixels: coefficients for sampleSpline. Interpolating splines keep
// fine detail that a four-point cubic blurs, by a different amount at every fraction of a pixel.
MetricImage splineCoefficients(const MetricImage& image);
double sampleSpline(const MetricImage& coefficients, double x, double y);
// sampleSpline at (x + shiftX, y + shiftY) for all x of a row, in one pass. 0 where the four by
// four pixels around a place do not lie inside the image.
void sampleSplineRow(
  const MetricImage& coefficients, int y, double shiftX, double shiftY, std::vector<float>& row);

// 1 where the square of `radius` pixels around is 1 and inside the image, else 0.
std::vector<std::uint8_t> eroded(
  const std::vector<std::uint8_t>& mask, int width, int height, int radius);

// Throw std::invalid_argument with the name of the image.
void checkSameSize(int width, int height, const ImageView& first, const std::string& name);
void checkInk(const ImageView& image, const std::string& name);
std::string pixelName(std::size_t index, int width); // "(x, y)"

} // namespace hachure

#endif

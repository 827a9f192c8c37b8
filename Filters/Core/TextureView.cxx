// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureView.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <stdexcept>

namespace hachure
{
namespace
{
[[noreturn]] void refuse(const std::string& name, const std::string& problem)
{
  throw std::invalid_argument(name + problem);
}

bool isFinite(const glm::dvec3& place)
{
  return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

void checkPlace(const glm::dvec3& place, const std::string& name)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(place[axis]))
    {
      refuse(name, " has the coordinate " + std::to_string(place[axis]) + "; expected numbers");
    }
  }
}

// Of rows of length 1 the determinant is their volume.
void checkMatrix(const glm::dmat4& matrix, const std::string& name)
{
  constexpr double leastVolume = 1e-14; // rounding of a matrix with equal rows
  const glm::dmat4 rows = glm::transpose(matrix);
  double volume = glm::determinant(matrix);
  for (int row = 0; row < 4; ++row)
  {
    const double length = std::sqrt(glm::dot(rows[row], rows[row]));
    volume /= length > 0.0 ? length : 1.0;
  }
  if (!std::isfinite(volume) || std::abs(volume) < leastVolume)
  {
    refuse(name,
      ".modelToClip has the determinant " + std::to_string(glm::determinant(matrix)) +
        "; expected a camera, which can be inverted");
  }
}

void checkSide(int pixels, const std::string& name)
{
  if (pixels < 1 || pixels > mostViewPixels)
  {
    refuse(name,
      " is " + std::to_string(pixels) + "; expected 1 to " + std::to_string(mostViewPixels) +
        " pixels");
  }
}

bool isShare(double value)
{
  return value >= 0.0 && value <= 1.0;
}

void checkCurve(const std::vector<glm::dvec2>& curve, const std::string& name)
{
  if (curve.empty())
  {
    refuse(name, ".fadeCurve is empty; expected at least one point");
  }
  double last = 0.0;
  for (const glm::dvec2& point : curve)
  {
    if (!isShare(point.x) || !isShare(point.y) || point.x < last)
    {
      refuse(name,
        ".fadeCurve has the point " + std::to_string(point.x) + ", " + std::to_string(point.y) +
          "; expected rising angles and shares of 0 to 1");
    }
    last = point.x;
  }
}
} // namespace

void checkTextureView(const TextureView& view, const std::string& name)
{
  checkMatrix(view.modelToClip, name);
  checkPlace(view.eye, name + ".eye");
  checkPlace(view.focus, name + ".focus");
  const glm::dvec3 away = view.eye - view.focus;
  if (!isFinite(away) || !(glm::dot(away, away) > 0.0))
  {
    refuse(name,
      ".eye is " + std::to_string(glm::length(away)) +
        " away from its focus; expected another place");
  }
  checkSide(view.width, name + ".width");
  checkSide(view.height, name + ".height");
  for (std::size_t i = 0; i < view.extremes.size(); ++i)
  {
    checkPlace(view.extremes[i], name + ".extremes[" + std::to_string(i) + "]");
  }
  checkCurve(view.fadeCurve, name);
}

void checkTextureImage(const TextureImage& image, const TextureView& view, const std::string& name)
{
  const auto sizeOf = [](int width, int height)
  { return std::to_string(width) + " x " + std::to_string(height); };
  if (image.width != view.width || image.height != view.height)
  {
    refuse(name,
      " has " + sizeOf(image.width, image.height) + " pixels; expected " +
        sizeOf(view.width, view.height) + " as its view has");
  }
  if (image.pixels.size() !=
    static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
  {
    refuse(name,
      ".pixels has " + std::to_string(image.pixels.size()) + " of " +
        sizeOf(image.width, image.height) + " pixels");
  }
}

bool haveSameCamera(const TextureView& a, const TextureView& b)
{
  return a.modelToClip == b.modelToClip && a.width == b.width && a.height == b.height;
}

bool haveSameFade(const TextureView& a, const TextureView& b)
{
  return a.eye == b.eye && a.focus == b.focus && a.parallel == b.parallel &&
    a.dependent == b.dependent && a.extremes == b.extremes && a.fadeCurve == b.fadeCurve &&
    a.fadeMode == b.fadeMode;
}

} // namespace hachure

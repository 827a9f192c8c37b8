// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorPage.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{

void require(bool holds, const char* what, std::size_t index, const char* expected)
{
  if (!holds)
  {
    std::string message(what);
    message += '[';
    message += std::to_string(index);
    message += "]: ";
    message += expected;
    throw std::invalid_argument(message);
  }
}

bool isFinite(const glm::dvec2& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y);
}

bool isFinite(const glm::vec3& color)
{
  return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b);
}

void checkStroke(const VectorStroke& stroke, std::size_t index)
{
  require(std::isfinite(stroke.width) && stroke.width >= 0.0, "strokes", index,
    "the width is not a finite number of 0 or more pixels");
  require(isFinite(stroke.color), "strokes", index, "the colour is not finite");
  for (const glm::dvec2& point : stroke.points)
  {
    require(isFinite(point), "strokes", index, "a point is not finite");
  }
}

} // namespace

void checkVectorPage(const VectorPage& page)
{
  if (!(isFinite(page.size) && page.size.x > 0.0 && page.size.y > 0.0))
  {
    throw std::invalid_argument("page size: " + std::to_string(page.size.x) + " x " +
      std::to_string(page.size.y) + ", expected more than 0 pixels");
  }
  if (!(std::isfinite(page.millimetresPerPixel) && page.millimetresPerPixel > 0.0))
  {
    throw std::invalid_argument("millimetres per pixel: " +
      std::to_string(page.millimetresPerPixel) + ", expected more than 0");
  }
  if (!isFinite(page.background))
  {
    throw std::invalid_argument("page background: the colour is not finite");
  }
  for (std::size_t i = 0; i < page.discs.size(); ++i)
  {
    const VectorDisc& disc = page.discs[i];
    require(isFinite(disc.center), "discs", i, "the centre is not finite");
    require(std::isfinite(disc.radius) && disc.radius >= 0.0, "discs", i,
      "the radius is not a finite number of 0 or more pixels");
    require(isFinite(disc.color) && std::isfinite(disc.opacity), "discs", i,
      "the colour or opacity is not finite");
  }
  for (std::size_t i = 0; i < page.strokes.size(); ++i)
  {
    checkStroke(page.strokes[i], i);
  }
}

} // namespace hachure

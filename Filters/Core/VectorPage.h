// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_VectorPage_h
#define hachure_VectorPage_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

// A picture as shapes instead of pixels, for files that can be edited and printed at any size.
// Lengths are pixels of the picture, y up, origin at its lower left corner; colours are sRGB, 0 to
// 1. Shapes may reach past the page and are cut off there.
namespace hachure
{

struct VectorDisc
{
  glm::dvec2 center{ 0.0 };
  double radius = 0.0;
  glm::vec3 color{ 0.0f };
  float opacity = 1.0f; // 0 to 1
};

// Corners and ends are round.
struct VectorStroke
{
  std::vector<glm::dvec2> points;
  double width = 1.0;
  glm::vec3 color{ 0.0f };
  bool closed = false; // the last point is joined to the first, which is not repeated
};

// What comes later covers what came before, strokes cover discs.
struct VectorPage
{
  glm::dvec2 size{ 0.0 }; // of the picture, pixels
  double millimetresPerPixel = 25.4 / 96.0;
  bool paintsBackground = true;
  glm::vec3 background{ 1.0f };
  std::vector<VectorDisc> discs;
  std::vector<VectorStroke> strokes;
};

// Throws std::invalid_argument naming the first bad value: a page of no or no finite size, a
// coordinate, width or colour that is not finite, a negative radius or width.
void checkVectorPage(const VectorPage& page);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ContourScene_h
#define hachure_ContourScene_h

// Surfaces in front of a camera at (0, 0, distance) that looks along -z, and their depth image.

#include "ContourLines.h"
#include "TestSurfaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hachure
{

constexpr double fullCircle = 6.283185307179586;

// rings x segments quads on a torus around the z axis, whose tube has radius `tube`.
inline Surface torus(double radius, double tube, int rings, int segments)
{
  Surface surface;
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < segments; ++j)
    {
      const double around = fullCircle * i / rings;
      const double across = fullCircle * j / segments;
      const double out = radius + tube * std::cos(across);
      surface.points.emplace_back(
        out * std::cos(around), out * std::sin(around), tube * std::sin(across));
      const int a = i * segments + j;
      const int b = i * segments + (j + 1) % segments;
      const int turn = (i + 1) % rings * segments - i * segments;
      surface.triangles.emplace_back(a, a + turn, b + turn);
      surface.triangles.emplace_back(a, b + turn, b);
    }
  }
  return surface;
}

// The cube from -1 to 1, every face n x n quads with points of their own.
inline Surface cube(int n)
{
  Surface surface;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      glm::dvec3 normal(0.0), u(0.0), v(0.0);
      normal[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1.0;
      addGrid(surface, normal - u - v, 2.0 * u, 2.0 * v, n);
    }
  }
  for (glm::dvec3& point : surface.points)
  {
    point = glm::round(point * static_cast<double>(n)) / static_cast<double>(n); // equal at seams
  }
  return surface;
}

inline Surface sphere(int n, double radius = 1.0, const glm::dvec3& center = glm::dvec3(0.0))
{
  Surface surface = cube(n);
  for (glm::dvec3& point : surface.points)
  {
    point = center + radius * glm::normalize(point);
  }
  return surface;
}

inline Surface turned(Surface surface, double angle, const glm::dvec3& axis)
{
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(axis)));
  for (glm::dvec3& point : surface.points)
  {
    point = turn * point;
  }
  return surface;
}

inline ViewProjection perspectiveView(double distance, double size, double halfAngle = 0.3)
{
  const double side = std::tan(halfAngle);
  ViewProjection view;
  view.modelToView = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -distance));
  view.viewToClip = glm::frustum(-side, side, -side, side, 1.0, 2.0 * distance);
  view.viewportSize = glm::dvec2(size);
  return view;
}

inline ViewProjection parallelView(double halfWidth, double size)
{
  ViewProjection view = perspectiveView(5.0, size);
  view.viewToClip = glm::ortho(-halfWidth, halfWidth, -halfWidth, halfWidth, 1.0, 10.0);
  return view;
}

inline glm::dvec3 windowPlace(const ViewProjection& view, const glm::dvec3& point)
{
  const glm::dvec4 clip = view.viewToClip * view.modelToView * glm::dvec4(point, 1.0);
  return (0.5 * glm::dvec3(clip) / clip.w + 0.5) * glm::dvec3(view.viewportSize, 1.0);
}

// The depth image of surfaces in front of the eye.
class DepthPicture
{
public:
  explicit DepthPicture(const ViewProjection& pictureView)
    : view(pictureView)
    , width(static_cast<int>(pictureView.viewportSize.x))
    , height(static_cast<int>(pictureView.viewportSize.y))
    , values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1.0f)
  {
  }

  DepthPicture& draw(const Surface& surface)
  {
    for (const glm::ivec3& corners : surface.triangles)
    {
      this->fill(windowPlace(this->view, surface.points[corners.x]),
        windowPlace(this->view, surface.points[corners.y]),
        windowPlace(this->view, surface.points[corners.z]));
    }
    return *this;
  }

  ContourDepth depth() const { return { { 0, 0, this->width, this->height }, this->values }; }

private:
  static double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  void fill(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    const double whole = area(a, b, c);
    const glm::dvec3 low = glm::floor(glm::min(a, glm::min(b, c)));
    const glm::dvec3 high = glm::max(a, glm::max(b, c));
    for (int y = std::max(0, static_cast<int>(low.y)); y < std::min<double>(height, high.y); ++y)
    {
      for (int x = std::max(0, static_cast<int>(low.x)); x < std::min<double>(width, high.x); ++x)
      {
        const glm::dvec2 pixel(x + 0.5, y + 0.5);
        const double u = area(pixel, b, c) / whole;
        const double v = area(pixel, c, a) / whole;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0)
        {
          float& value = this->values[static_cast<std::size_t>(y) * this->width + x];
          value = std::min(value, static_cast<float>(u * a.z + v * b.z + (1.0 - u - v) * c.z));
        }
      }
    }
  }

  ViewProjection view;
  int width, height;
  std::vector<float> values;
};

inline double lengthOf(const ContourLine& line)
{
  double length = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
  {
    length += glm::distance(line.points[i - 1], line.points[i]);
  }
  return line.closed ? length + glm::distance(line.points.back(), line.points.front()) : length;
}

inline double lengthOf(const std::vector<ContourLine>& lines)
{
  double length = 0.0;
  for (const ContourLine& line : lines)
  {
    length += lengthOf(line);
  }
  return length;
}

} // namespace hachure

#endif

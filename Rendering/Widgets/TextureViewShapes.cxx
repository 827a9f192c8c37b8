// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewShapes.h"

#include "ViewFade.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkTextureViews.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
constexpr double pi = 3.14159265358979323846;
// Corners of clip space, from the lower left anticlockwise.
constexpr std::array<std::array<double, 2>, 4> clipCorners{ { { -1.0, -1.0 }, { 1.0, -1.0 },
  { 1.0, 1.0 }, { -1.0, 1.0 } } };
// Depth of a pyramid or prism over the longer side of its picture, where nothing else says it.
constexpr double prismDepth = 1.0;
// Points of a border besides the extreme ones.
constexpr int borderPoints = 96;

double longerSide(const std::array<glm::dvec3, 4>& corners)
{
  return std::max(glm::distance(corners[0], corners[1]), glm::distance(corners[0], corners[3]));
}

glm::dmat4 modelToClip(vtkTextureViews* views, int view)
{
  vtkNew<vtkMatrix4x4> matrix;
  views->ComputeModelToClip(view, matrix);
  return matrixOf(matrix);
}

// From the eye to the corners of the picture, one unit along the direction of view away.
std::array<glm::dvec3, 4> rays(
  const glm::dmat4& toClip, const glm::dvec3& eye, const glm::dvec3& focus)
{
  const glm::dmat4 fromClip = glm::inverse(toClip);
  const glm::dvec4 row(toClip[0].w, toClip[1].w, toClip[2].w, toClip[3].w);
  // A matrix of the other sign projects alike; what it looks at tells where its front is.
  const double sign = glm::dot(row, glm::dvec4(focus, 1.0)) < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 forward = glm::normalize(glm::dvec3(row) * sign);
  std::array<glm::dvec3, 4> result;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const glm::dvec4 point = fromClip * glm::dvec4(clipCorners[i][0], clipCorners[i][1], 0.0, 1.0);
    const glm::dvec3 ray = glm::dvec3(point) - point.w * eye;
    result[i] = ray / glm::dot(ray, forward);
  }
  return result;
}

ViewPyramid perspectivePyramid(
  const ViewScene& scene, const glm::dmat4& toClip, const ViewPlace& place)
{
  std::array<glm::dvec3, 4> sides = rays(toClip, place.eye, place.focus);
  for (glm::dvec3& side : sides)
  {
    side = movedVector(scene.modelToWorld, side);
  }
  const glm::dvec3 middle = 0.5 * (sides[0] + sides[2]);
  const double distance =
    glm::length(movedVector(scene.modelToWorld, place.focus - place.eye)) / glm::length(middle);
  const double depth = std::min(scene.pictureSize / longerSide(sides), 0.5 * distance);
  ViewPyramid pyramid;
  pyramid.bases.fill(movedPoint(scene.modelToWorld, place.eye));
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    pyramid.corners[i] = pyramid.bases[i] + depth * sides[i];
  }
  return pyramid;
}

// Around the camera, since all that it sees may be as large as the surface.
ViewPyramid parallelPrism(const ViewScene& scene, const glm::dmat4& toClip, const ViewPlace& place)
{
  const glm::dmat4 fromClip = glm::inverse(toClip);
  std::array<glm::dvec3, 4> plane;
  for (std::size_t i = 0; i < plane.size(); ++i)
  {
    const glm::dvec4 point = fromClip * glm::dvec4(clipCorners[i][0], clipCorners[i][1], 0.0, 1.0);
    plane[i] = movedPoint(scene.modelToWorld, glm::dvec3(point) / point.w);
  }
  const glm::dvec3 eye = movedPoint(scene.modelToWorld, place.eye);
  const glm::dvec3 sight = movedVector(scene.modelToWorld, place.focus - place.eye);
  const glm::dvec3 middle = 0.5 * (plane[0] + plane[2]);
  const double scale = scene.pictureSize / longerSide(plane);
  const double depth = std::min(prismDepth * scene.pictureSize, 0.5 * glm::length(sight));
  ViewPyramid prism;
  for (std::size_t i = 0; i < plane.size(); ++i)
  {
    prism.bases[i] = eye + scale * (plane[i] - middle);
    prism.corners[i] = prism.bases[i] + depth * glm::normalize(sight);
  }
  return prism;
}

// Directions at right angles to a unit vector and each other.
std::array<glm::dvec3, 2> sidesOf(const glm::dvec3& direction)
{
  const glm::dvec3 axis =
    std::abs(direction.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 side = glm::normalize(glm::cross(direction, axis));
  return { side, glm::cross(direction, side) };
}

struct BorderCorner
{
  double around = 0.0;   // radians, -pi to pi
  double distance = 0.0; // from the focus
};

// Of the corners in their order around the view.
double distanceAt(const std::vector<BorderCorner>& corners, double around)
{
  const auto next = std::find_if(corners.begin(), corners.end(),
    [&](const BorderCorner& corner) { return corner.around > around; });
  const bool inside = next != corners.begin() && next != corners.end();
  const BorderCorner& from = inside ? *(next - 1) : corners.back();
  const BorderCorner& to = inside ? *next : corners.front();
  const double width = to.around - from.around + (inside ? 0.0 : 2.0 * pi);
  double along = around - from.around;
  along += along < 0.0 ? 2.0 * pi : 0.0;
  return glm::mix(from.distance, to.distance, std::clamp(along / std::max(width, 1e-9), 0.0, 1.0));
}

std::vector<double> anglesAround(const std::vector<BorderCorner>& corners)
{
  std::vector<double> angles;
  angles.reserve(corners.size() + borderPoints + 1);
  for (int i = 0; i < borderPoints; ++i)
  {
    angles.push_back(2.0 * pi * i / borderPoints - pi);
  }
  for (const BorderCorner& corner : corners)
  {
    angles.push_back(corner.around);
  }
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front());
  return angles;
}
} // namespace

glm::dmat4 matrixOf(vtkMatrix4x4* matrix)
{
  return matrix ? glm::transpose(glm::make_mat4(matrix->GetData())) : glm::dmat4(1.0);
}

glm::dvec3 movedPoint(const glm::dmat4& matrix, const glm::dvec3& point)
{
  return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

glm::dvec3 movedVector(const glm::dmat4& matrix, const glm::dvec3& vector)
{
  return glm::dvec3(matrix * glm::dvec4(vector, 0.0));
}

ViewPlace viewPlace(const ViewScene& scene, int view)
{
  ViewPlace place;
  if (vtkCamera* camera = scene.views->GetViewCamera(view))
  {
    camera->GetPosition(glm::value_ptr(place.eye));
    camera->GetFocalPoint(glm::value_ptr(place.focus));
    return place;
  }
  glm::dvec4 eye;
  scene.views->ComputeEye(view, glm::value_ptr(eye));
  place.focus = scene.middle;
  place.eye = eye.w != 0.0 ? glm::dvec3(eye) : scene.middle + scene.modelLength * glm::dvec3(eye);
  if (place.eye == place.focus)
  {
    place.focus.z -= scene.modelLength; // no other place is better
  }
  return place;
}

ViewPyramid viewPyramid(const ViewScene& scene, int view)
{
  glm::dvec4 eye;
  scene.views->ComputeEye(view, glm::value_ptr(eye));
  const glm::dmat4 toClip = modelToClip(scene.views, view);
  const ViewPlace place = viewPlace(scene, view);
  return eye.w != 0.0 ? perspectivePyramid(scene, toClip, place)
                      : parallelPrism(scene, toClip, place);
}

std::vector<glm::dvec3> extremePoints(vtkTextureViews* views, int view)
{
  std::vector<glm::dvec3> points(static_cast<std::size_t>(views->GetNumberOfExtremePoints(view)));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    views->GetExtremePoint(view, static_cast<int>(i), glm::value_ptr(points[i]));
  }
  return points;
}

std::vector<glm::dvec3> rangeBorder(const ViewPlace& place, const std::vector<glm::dvec3>& extremes)
{
  const glm::dvec3 middle = glm::normalize(place.eye - place.focus);
  const auto [side, up] = sidesOf(middle);
  std::vector<BorderCorner> corners;
  std::vector<glm::dvec3> directions;
  corners.reserve(extremes.size());
  directions.reserve(extremes.size());
  for (const glm::dvec3& extreme : extremes)
  {
    const glm::dvec3 from = extreme - place.focus;
    directions.push_back(from);
    corners.push_back({ std::atan2(glm::dot(from, up), glm::dot(from, side)), glm::length(from) });
  }
  std::vector<glm::dvec3> border;
  if (corners.empty())
  {
    return border;
  }
  std::sort(corners.begin(), corners.end(),
    [](const BorderCorner& a, const BorderCorner& b) { return a.around < b.around; });
  const FadeRegion region(middle, directions);
  // So near the middle that it is inside the border, and far enough for numbers of single
  // precision.
  constexpr double probe = 0.01;
  const std::vector<double> angles = anglesAround(corners);
  border.reserve(angles.size());
  for (const double around : angles)
  {
    const glm::dvec3 outwards = std::cos(around) * side + std::sin(around) * up;
    const glm::vec3 probed(std::cos(probe) * middle + std::sin(probe) * outwards);
    const double angle = probe / std::max(static_cast<double>(region.relativeAngle(probed)), 1e-6);
    border.push_back(place.focus +
      distanceAt(corners, around) * (std::cos(angle) * middle + std::sin(angle) * outwards));
  }
  return border;
}

glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& from, const glm::dvec3& to)
{
  const double scale = glm::length(from) * glm::length(to);
  const glm::dvec3 axis = glm::cross(from, to) / scale;
  const double cosine = glm::dot(from, to) / scale;
  if (!(scale > 0.0) || cosine <= -1.0 + 1e-12)
  {
    return vector;
  }
  const glm::dvec3 moved = glm::cross(axis, vector);
  return vector + moved + glm::cross(axis, moved) / (1.0 + cosine);
}

} // namespace hachure

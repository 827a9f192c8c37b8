// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewFit.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::program
{
namespace
{
/// Vertical angle of view at zoom 1: that of a short telephoto lens, little distortion.
constexpr double ViewAngleDegrees = 24.0;
/// Share of the picture's half side that stays free.
constexpr double Margin = 0.04;
/// A golden section search narrows to 1e-6 of its start.
constexpr int SearchSteps = 30;

glm::dvec3 axisDirection(const std::string& axis)
{
  glm::dvec3 direction(0.0);
  direction[axis.back() - 'x'] = axis[0] == '-' ? -1.0 : 1.0;
  return direction;
}

glm::dvec3 towardsCamera(const Turntable& turntable, double azimuth, double elevation)
{
  const double a = vtkMath::RadiansFromDegrees(azimuth);
  const double e = vtkMath::RadiansFromDegrees(elevation);
  return std::cos(e) * (std::cos(a) * turntable.front + std::sin(a) * turntable.right) +
    std::sin(e) * turntable.up;
}

/// Exactly square to the view direction, defined at the poles too.
glm::dvec3 cameraUp(const Turntable& turntable, double azimuth, double elevation)
{
  return towardsCamera(turntable, azimuth, elevation + 90.0);
}

glm::dvec3 middle(const std::vector<glm::dvec3>& points)
{
  glm::dvec3 low(points.front());
  glm::dvec3 high(points.front());
  for (const glm::dvec3& point : points)
  {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return 0.5 * (low + high);
}

/// A point beside the axis of view, in camera directions.
struct ViewPoint
{
  double aside;
  double above;
  double nearer;
};

std::vector<ViewPoint> viewPoints(const Turntable& turntable, const std::vector<glm::dvec3>& points,
  const std::vector<double>& azimuths, double elevation)
{
  std::vector<ViewPoint> all;
  all.reserve(points.size() * azimuths.size());
  for (const double azimuth : azimuths)
  {
    const glm::dvec3 towards = towardsCamera(turntable, azimuth, elevation);
    const glm::dvec3 above = cameraUp(turntable, azimuth, elevation);
    const glm::dvec3 aside = glm::cross(above, towards);
    for (const glm::dvec3& point : points)
    {
      const glm::dvec3 offset = point - turntable.centre;
      all.push_back(
        { glm::dot(offset, aside), glm::dot(offset, above), glm::dot(offset, towards) });
    }
  }
  return all;
}

/// Smallest distance that shows all points when the centre moves along up by shift.
double neededDistance(const std::vector<ViewPoint>& points, double shift, double elevation,
  double tangentAside, double tangentAbove)
{
  const double e = vtkMath::RadiansFromDegrees(elevation);
  const double shiftAbove = shift * std::cos(e);
  const double shiftNearer = shift * std::sin(e);
  double needed = 0.0;
  for (const ViewPoint& point : points)
  {
    const double extent = std::max(
      std::abs(point.aside) / tangentAside, std::abs(point.above - shiftAbove) / tangentAbove);
    needed = std::max(needed, point.nearer - shiftNearer + extent);
  }
  return needed;
}
} // namespace

//----------------------------------------------------------------------------
Turntable makeTurntable(const std::string& up, const std::string& front)
{
  Turntable turntable;
  turntable.up = axisDirection(up);
  turntable.front = axisDirection(front);
  if (up.back() == front.back())
  {
    turntable.front = axisDirection(up.back() == 'z' ? "-y" : "z");
  }
  turntable.right = glm::cross(turntable.up, turntable.front);
  return turntable;
}

//----------------------------------------------------------------------------
void fitTurntable(Turntable& turntable, const std::vector<glm::dvec3>& points,
  const std::vector<double>& azimuths, double elevation, double aspect)
{
  turntable.centre = middle(points);
  const auto seen = viewPoints(turntable, points, azimuths, elevation);
  const double tangentAbove =
    (1.0 - Margin) * std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngleDegrees));
  const auto needed = [&](double shift)
  { return neededDistance(seen, shift, elevation, tangentAbove * aspect, tangentAbove); };

  // The need is convex in the shift, a maximum of linear functions: search by golden section.
  double reach = 0.0;
  for (const glm::dvec3& point : points)
  {
    reach = std::max(reach, glm::length(point - turntable.centre));
  }
  constexpr double Golden = 0.6180339887498949;
  double low = -reach;
  double high = reach;
  double left = high - Golden * (high - low);
  double right = low + Golden * (high - low);
  double needLeft = needed(left);
  double needRight = needed(right);
  for (int step = 0; step < SearchSteps; ++step)
  {
    if (needLeft < needRight)
    {
      high = right;
      right = left;
      needRight = needLeft;
      left = high - Golden * (high - low);
      needLeft = needed(left);
    }
    else
    {
      low = left;
      left = right;
      needLeft = needRight;
      right = low + Golden * (high - low);
      needRight = needed(right);
    }
  }
  const double shift = 0.5 * (low + high);
  turntable.distance = std::max(needed(shift), 1e-12);
  turntable.centre += shift * turntable.up;
}

//----------------------------------------------------------------------------
void placeCamera(vtkCamera* camera, const Turntable& turntable, const TurntableView& view)
{
  const glm::dvec3 position =
    turntable.centre + turntable.distance * towardsCamera(turntable, view.azimuth, view.elevation);
  const glm::dvec3 up = cameraUp(turntable, view.azimuth, view.elevation);
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngleDegrees));
  camera->SetFocalPoint(turntable.centre.x, turntable.centre.y, turntable.centre.z);
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetViewUp(up.x, up.y, up.z);
  camera->Roll(view.roll);
  camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(tangent / view.zoom)));
}
} // namespace hachure::program

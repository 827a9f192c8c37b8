// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DisplayRay.h"

#include "vtkCamera.h"
#include "vtkInteractorObserver.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure
{
namespace
{
glm::dvec3 transformed(const glm::dmat4& matrix, const glm::dvec3& point)
{
  return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}
} // namespace

DisplayRay displayRay(vtkRenderer* renderer, const glm::dvec2& display, const glm::dmat4& fromWorld)
{
  const auto at = [&](double depth)
  { return transformed(fromWorld, displayToWorld(renderer, glm::dvec3(display, depth))); };
  DisplayRay ray;
  ray.origin = at(0.0);
  ray.direction = glm::normalize(at(1.0) - ray.origin);
  vtkCamera* camera = renderer->GetActiveCamera();
  if (!camera->GetParallelProjection())
  {
    glm::dvec3 eye;
    camera->GetPosition(glm::value_ptr(eye));
    ray.origin = transformed(fromWorld, eye);
  }
  return ray;
}

glm::dvec3 pointOnSphere(
  const DisplayRay& ray, const glm::dvec3& center, double radius, const glm::dvec3* preferred)
{
  const double middle = glm::dot(center - ray.origin, ray.direction);
  const glm::dvec3 away = ray.origin + middle * ray.direction - center;
  const double distance = glm::length(away);
  if (distance >= radius)
  {
    return center + (radius / distance) * away;
  }
  const double half = std::sqrt(radius * radius - distance * distance);
  const glm::dvec3 first = center + away - half * ray.direction;
  const glm::dvec3 second = center + away + half * ray.direction;
  // Without a preferred one it is the first in front of who looks, who may be inside.
  const bool takeFirst = preferred
    ? glm::distance(first, *preferred) <= glm::distance(second, *preferred)
    : middle >= half;
  return takeFirst ? first : second;
}

double placeOnLine(
  const DisplayRay& ray, const glm::dvec3& point, const glm::dvec3& direction, double otherwise)
{
  const double cosine = glm::dot(ray.direction, direction);
  const double sineSquared = 1.0 - cosine * cosine;
  const glm::dvec3 between = ray.origin - point;
  if (sineSquared < 1e-9)
  {
    return otherwise;
  }
  return glm::dot(between, direction - cosine * ray.direction) / sineSquared;
}

glm::dvec3 worldToDisplay(vtkRenderer* renderer, const glm::dvec3& world)
{
  glm::dvec3 display;
  vtkInteractorObserver::ComputeWorldToDisplay(
    renderer, world.x, world.y, world.z, glm::value_ptr(display));
  return display;
}

glm::dvec3 displayToWorld(vtkRenderer* renderer, const glm::dvec3& display)
{
  glm::dvec4 world;
  vtkInteractorObserver::ComputeDisplayToWorld(
    renderer, display.x, display.y, display.z, glm::value_ptr(world));
  return glm::dvec3(world);
}

double depthInView(vtkRenderer* renderer, const glm::dvec3& world)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dvec3 eye;
  glm::dvec3 sight;
  camera->GetPosition(glm::value_ptr(eye));
  camera->GetDirectionOfProjection(glm::value_ptr(sight));
  return glm::dot(world - eye, sight);
}

bool isInFront(vtkRenderer* renderer, const glm::dvec3& world)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return camera->GetParallelProjection() ||
    depthInView(renderer, world) > 1e-6 * camera->GetDistance();
}

double pixelSize(vtkRenderer* renderer, const glm::dvec3& world)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* size = renderer->GetSize();
  const int pixels = std::max(1, size[camera->GetUseHorizontalViewAngle() ? 0 : 1]);
  if (camera->GetParallelProjection())
  {
    return 2.0 * camera->GetParallelScale() / pixels;
  }
  const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  return 2.0 * half * std::max(depthInView(renderer, world), 0.0) / pixels;
}

double distanceToSegment(vtkRenderer* renderer, const glm::dvec2& display, const glm::dvec3& from,
  const glm::dvec3& to, glm::dvec3& nearest)
{
  if (!isInFront(renderer, from) || !isInFront(renderer, to))
  {
    return std::numeric_limits<double>::infinity();
  }
  const glm::dvec3 start = worldToDisplay(renderer, from);
  const glm::dvec3 end = worldToDisplay(renderer, to);
  const glm::dvec2 along(end - start);
  const double length = glm::dot(along, along);
  const double place = length > 0.0
    ? std::clamp(glm::dot(display - glm::dvec2(start), along) / length, 0.0, 1.0)
    : 0.0;
  nearest = glm::mix(start, end, place);
  return glm::distance(display, glm::dvec2(nearest));
}

} // namespace hachure

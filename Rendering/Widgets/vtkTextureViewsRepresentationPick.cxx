// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What is under the cursor.

#include "vtkRenderer.h"
#include "vtkTextureViewsRepresentationInternals.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/** Pixels around a ball, and on both sides of a line, that count as parts of it. */
constexpr double handleMargin = 3.0;
constexpr double lineMargin = 4.0;

/** Whether a place is in a convex polygon of display coordinates. */
bool isInside(const std::array<glm::dvec3, 4>& polygon, const glm::dvec2& place)
{
  int left = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2 from(polygon[i]);
    const glm::dvec2 side = glm::dvec2(polygon[(i + 1) % polygon.size()]) - from;
    left += side.x * (place.y - from.y) > side.y * (place.x - from.x) ? 1 : 0;
  }
  return left == 0 || left == static_cast<int>(polygon.size());
}

/** The depth at which a picture is seen at a place; infinite where it is not. */
double pictureDepth(
  vtkRenderer* renderer, const std::array<glm::dvec3, 4>& corners, const glm::dvec2& place)
{
  std::array<glm::dvec3, 4> seen;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (!hachure::isInFront(renderer, corners[i]))
    {
      return std::numeric_limits<double>::infinity();
    }
    seen[i] = hachure::worldToDisplay(renderer, corners[i]);
  }
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[3] - corners[0]);
  const hachure::DisplayRay ray = hachure::displayRay(renderer, place, glm::dmat4(1.0));
  const double slope = glm::dot(ray.direction, normal);
  if (!isInside(seen, place) || slope == 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double along = glm::dot(corners[0] - ray.origin, normal) / slope;
  return hachure::worldToDisplay(renderer, ray.origin + along * ray.direction).z;
}

/** The depth of the edges of a pyramid near a place; infinite where there are none. */
double edgeDepth(
  vtkRenderer* renderer, const hachure::ViewPyramid& pyramid, const glm::dvec2& place)
{
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pyramid.corners.size(); ++i)
  {
    const glm::dvec3& corner = pyramid.corners[i];
    const glm::dvec3& base = pyramid.bases[i];
    const std::size_t next = (i + 1) % pyramid.corners.size();
    for (const glm::dvec3* from : { &base, &pyramid.corners[next] })
    {
      glm::dvec3 nearest;
      if (hachure::distanceToSegment(renderer, place, *from, corner, nearest) <= lineMargin)
      {
        depth = std::min(depth, nearest.z);
      }
    }
    glm::dvec3 nearest;
    if (hachure::distanceToSegment(renderer, place, base, pyramid.bases[next], nearest) <=
      lineMargin)
    {
      depth = std::min(depth, nearest.z);
    }
  }
  return depth;
}

} // namespace

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::ComputeInteractionState(int x, int y, int)
{
  this->InteractionState = NOTHING;
  if (this->Renderer && this->Internal->views)
  {
    this->BuildRepresentation();
    this->FindHandles(x, y);
    if (this->InteractionState == NOTHING)
    {
      this->FindViews(x, y);
    }
  }
  return this->InteractionState;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::FindHandles(int x, int y)
{
  Internals& internal = *this->Internal;
  double nearest = std::numeric_limits<double>::infinity();
  const auto look = [&](hachure::HandleMark& mark, const Internals::Item& item)
  {
    if (!mark.prop()->GetVisibility() || !hachure::isInFront(this->Renderer, mark.position))
    {
      return;
    }
    const glm::dvec3 seen = hachure::worldToDisplay(this->Renderer, mark.position);
    const double reach = 0.5 * this->HandleSize + handleMargin;
    if (glm::distance(glm::dvec2(seen), glm::dvec2(x, y)) <= reach && seen.z < nearest &&
      !this->IsHidden(x, y, seen.z, mark.radius))
    {
      nearest = seen.z;
      internal.found = item;
      this->InteractionState = item.kind;
    }
  };
  for (std::size_t i = 0; i < internal.extremeMarks.size(); ++i)
  {
    look(*internal.extremeMarks[i], { EXTREME_POINT, internal.selected.view, static_cast<int>(i) });
  }
  for (std::size_t i = 0; i < internal.blendMarks.size(); ++i)
  {
    look(internal.blendMarks[i]->handle, { BLEND_POINT, -1, static_cast<int>(i) });
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::FindViews(int x, int y)
{
  Internals& internal = *this->Internal;
  const glm::dvec2 place(x, y);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < internal.viewMarks.size(); ++i)
  {
    hachure::ViewMark& mark = *internal.viewMarks[i];
    if (!mark.lines.prop()->GetVisibility())
    {
      continue;
    }
    double depth = edgeDepth(this->Renderer, mark.pyramid, place);
    if (this->ShowPictures)
    {
      depth = std::min(depth, pictureDepth(this->Renderer, mark.pyramid.corners, place));
    }
    if (depth < nearest && !this->IsHidden(x, y, depth, 0.0))
    {
      nearest = depth;
      internal.found = { VIEW, static_cast<int>(i), -1 };
      this->InteractionState = VIEW;
    }
  }
}

//------------------------------------------------------------------------------
/** Whether something nearer than a mark, of a radius, was drawn where the mark would be. */
bool vtkTextureViewsRepresentation::IsHidden(int x, int y, double depth, double radius)
{
  constexpr double share = 0.005; // of the distance: of the depth buffer and of slopes
  const double drawn = this->Renderer->GetZ(x, y);
  if (!(drawn < 1.0))
  {
    return false;
  }
  const auto distanceOf = [&](double z)
  {
    return hachure::depthInView(
      this->Renderer, hachure::displayToWorld(this->Renderer, glm::dvec3(x, y, z)));
  };
  const double distance = distanceOf(depth);
  return distanceOf(drawn) < distance - std::max(2.0 * radius, share * std::abs(distance));
}

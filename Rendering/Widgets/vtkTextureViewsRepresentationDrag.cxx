// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What is selected, what is under the cursor, and how it is dragged.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkTextureViewsRepresentationInternals.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

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
bool vtkTextureViewsRepresentation::Takes(int index, int count, const char* what)
{
  if (index >= 0 && index < count)
  {
    return true;
  }
  vtkErrorMacro(<< what << " " << index << " cannot be selected; there are " << count << ".");
  return false;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::SelectView(int view)
{
  vtkTextureViews* views = this->Internal->views;
  if (!this->Takes(view, views ? views->GetNumberOfViews() : 0, "View"))
  {
    return false;
  }
  this->Internal->selected = { VIEW, view, -1 };
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::SelectExtremePoint(int view, int point)
{
  vtkTextureViews* views = this->Internal->views;
  if (!this->Takes(view, views ? views->GetNumberOfViews() : 0, "View") ||
    !this->Takes(point, views->GetNumberOfExtremePoints(view), "Extreme point"))
  {
    return false;
  }
  this->Internal->selected = { EXTREME_POINT, view, point };
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::SelectBlendPoint(int point)
{
  vtkTextureViews* views = this->Internal->views;
  if (!this->Takes(point, views ? views->GetNumberOfBlendPoints() : 0, "Blend point"))
  {
    return false;
  }
  this->Internal->selected = { BLEND_POINT, this->GetSelectedView(), point };
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SelectNothing()
{
  this->Internal->selected = {};
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SelectFound()
{
  const Internals::Item found = this->Internal->found;
  switch (this->InteractionState)
  {
    case VIEW:
      this->SelectView(found.view);
      break;
    case EXTREME_POINT:
      this->SelectExtremePoint(found.view, found.point);
      break;
    case BLEND_POINT:
      this->SelectBlendPoint(found.point);
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::ForgetLost()
{
  Internals::Item& selected = this->Internal->selected;
  vtkTextureViews* views = this->Internal->views;
  const int count = views ? views->GetNumberOfViews() : 0;
  const bool hasView = selected.view >= 0 && selected.view < count;
  selected.view = hasView ? selected.view : -1;
  int points = 0;
  if (selected.kind == EXTREME_POINT && hasView)
  {
    points = views->GetNumberOfExtremePoints(selected.view);
  }
  else if (selected.kind == BLEND_POINT && views)
  {
    points = views->GetNumberOfBlendPoints();
  }
  const bool isThere = selected.kind == VIEW ? hasView : selected.point < points;
  if (!isThere)
  {
    selected.kind = NOTHING;
    selected.point = -1;
  }
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::GetSelectedItem()
{
  this->ForgetLost();
  return this->Internal->selected.kind;
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::GetSelectedView()
{
  this->ForgetLost();
  return this->Internal->selected.view;
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::GetSelectedPoint()
{
  this->ForgetLost();
  return this->Internal->selected.point;
}

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

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::GetSelectedPosition(double world[3])
{
  if (!this->MakeScene())
  {
    return false;
  }
  Internals& internal = *this->Internal;
  const Internals::Item& selected = internal.selected;
  glm::dvec3 place;
  switch (selected.kind)
  {
    case VIEW:
      place = hachure::viewPlace(internal.scene, selected.view).eye;
      break;
    case EXTREME_POINT:
      internal.views->GetExtremePoint(selected.view, selected.point, glm::value_ptr(place));
      break;
    case BLEND_POINT:
      internal.views->GetBlendPointPosition(selected.point, glm::value_ptr(place));
      break;
    default:
      return false;
  }
  place = hachure::movedPoint(internal.scene.modelToWorld, place);
  std::copy_n(glm::value_ptr(place), 3, world);
  return true;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::StartWidgetInteraction(double display[2])
{
  Internals& internal = *this->Internal;
  internal.last = glm::make_vec2(display);
  internal.grabbed = glm::dvec2(0.0);
  glm::dvec3 world;
  if (this->Renderer && this->GetSelectedPosition(glm::value_ptr(world)) &&
    hachure::isInFront(this->Renderer, world))
  {
    internal.grabbed = glm::dvec2(hachure::worldToDisplay(this->Renderer, world)) - internal.last;
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::WidgetInteraction(double display[2])
{
  if (!this->Renderer || !this->MakeScene())
  {
    return;
  }
  switch (this->Internal->selected.kind)
  {
    case VIEW:
      this->MoveView(display);
      break;
    case EXTREME_POINT:
      this->MoveExtremePoint(display);
      break;
    case BLEND_POINT:
      this->MoveBlendPoint(display);
      break;
    default:
      break;
  }
  this->Internal->last = glm::make_vec2(display);
  this->BuildRepresentation();
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::MoveExtremePoint(const double display[2])
{
  Internals& internal = *this->Internal;
  const Internals::Item& selected = internal.selected;
  const hachure::ViewPlace place = hachure::viewPlace(internal.scene, selected.view);
  const hachure::DisplayRay ray = hachure::displayRay(
    this->Renderer, glm::make_vec2(display) + internal.grabbed, internal.scene.worldToModel);
  glm::dvec3 point;
  internal.views->GetExtremePoint(selected.view, selected.point, glm::value_ptr(point));
  double radius = glm::distance(point, place.focus);
  radius = radius > 0.0 ? radius : glm::distance(place.eye, place.focus);
  point = hachure::pointOnSphere(ray, place.focus, radius, &point);
  internal.views->SetExtremePoint(selected.view, selected.point, glm::value_ptr(point));
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::MoveView(const double display[2])
{
  Internals& internal = *this->Internal;
  const int view = internal.selected.view;
  const hachure::ViewPlace place = hachure::viewPlace(internal.scene, view);
  vtkCamera* camera = internal.views->GetViewCamera(view);
  if (!camera)
  {
    return; // a matrix says no more than what it shows
  }
  const hachure::DisplayRay ray = hachure::displayRay(
    this->Renderer, glm::make_vec2(display) + internal.grabbed, internal.scene.worldToModel);
  const glm::dvec3 from = place.eye - place.focus;
  const double distance = glm::length(from);
  glm::dvec3 eye;
  if (this->MovesDistance)
  {
    constexpr double least = 0.1; // of the distance before, so that it can be undone
    const double along = hachure::placeOnLine(ray, place.focus, from / distance, distance);
    eye = place.focus + (std::max(along, least * distance) / distance) * from;
  }
  else
  {
    eye = hachure::pointOnSphere(ray, place.focus, distance, &place.eye);
  }
  glm::dvec3 up;
  internal.views->GetViewUp(view, glm::value_ptr(up));
  up = hachure::turned(up, from, eye - place.focus);
  camera->SetPosition(glm::value_ptr(eye));
  camera->SetViewUp(glm::value_ptr(up));
  internal.views->SetViewCamera(view, camera);
  internal.views->SetViewUp(view, glm::value_ptr(up)); // VTK's camera has changed its length
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::MoveBlendPoint(const double display[2])
{
  Internals& internal = *this->Internal;
  glm::dvec3 world;
  if (!this->GetSelectedPosition(glm::value_ptr(world)) ||
    !hachure::isInFront(this->Renderer, world))
  {
    return;
  }
  const glm::dvec2 to = glm::make_vec2(display);
  if (this->MovesDistance)
  {
    constexpr double doublings = 4.0; // of the distance, over the height of the renderer
    const double upwards = (to.y - internal.last.y) / std::max(this->Renderer->GetSize()[1], 1);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const glm::dvec3 eye = glm::make_vec3(camera->GetPosition());
    const glm::dvec3 sight = glm::make_vec3(camera->GetDirectionOfProjection());
    world = camera->GetParallelProjection()
      ? world + 2.0 * camera->GetParallelScale() * upwards * sight
      : eye + std::exp2(doublings * upwards) * (world - eye);
  }
  else
  {
    const double depth = hachure::worldToDisplay(this->Renderer, world).z;
    world = hachure::displayToWorld(this->Renderer, glm::dvec3(to + internal.grabbed, depth));
  }
  const int point = internal.selected.point;
  const glm::dvec3 position = hachure::movedPoint(internal.scene.worldToModel, world);
  glm::dvec3 direction;
  internal.views->GetBlendPointDirection(point, glm::value_ptr(direction));
  internal.views->SetBlendPoint(point, glm::value_ptr(position), glm::value_ptr(direction),
    internal.views->GetBlendPointPercentage(point));
}

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::ComputePlaceOnSphere(
  int view, const double display[2], double place[3])
{
  std::fill_n(place, 3, 0.0);
  Internals& internal = *this->Internal;
  if (!this->Renderer || !this->MakeScene() || view < 0 ||
    view >= internal.views->GetNumberOfViews())
  {
    return false;
  }
  const hachure::ViewPlace camera = hachure::viewPlace(internal.scene, view);
  const hachure::DisplayRay ray =
    hachure::displayRay(this->Renderer, glm::make_vec2(display), internal.scene.worldToModel);
  const glm::dvec3 found =
    hachure::pointOnSphere(ray, camera.focus, glm::distance(camera.eye, camera.focus), nullptr);
  std::copy_n(glm::value_ptr(found), 3, place);
  return true;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// How what is selected is dragged.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkTextureViewsRepresentationInternals.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

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

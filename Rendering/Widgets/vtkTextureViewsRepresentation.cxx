// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureViewsRepresentation.h"

#include "vtkBoundingBox.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextureViewsRepresentationInternals.h"

#include <algorithm>

vtkStandardNewMacro(vtkTextureViewsRepresentation);

//------------------------------------------------------------------------------
vtkTextureViewsRepresentation::vtkTextureViewsRepresentation()
  : Internal(new Internals)
{
  this->HandleSize = 12.0; // pixels across
}

//------------------------------------------------------------------------------
vtkTextureViewsRepresentation::~vtkTextureViewsRepresentation() = default;

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SetViews(vtkTextureViews* views)
{
  if (this->Internal->views != views)
  {
    this->Internal->views = views;
    this->Internal->viewMarks.clear();
    this->SelectNothing();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTextureViews* vtkTextureViewsRepresentation::GetViews()
{
  return this->Internal->views;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SetModelToWorld(vtkMatrix4x4* matrix)
{
  if (this->Internal->modelToWorld != matrix)
  {
    this->Internal->modelToWorld = matrix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkTextureViewsRepresentation::GetModelToWorld()
{
  return this->Internal->modelToWorld;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SetSurface(vtkDataObject* surface)
{
  if (this->Internal->regions.setSurface(surface))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTextureViewsRepresentation::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part :
    std::initializer_list<vtkObject*>{ this->Internal->views, this->Internal->modelToWorld })
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::PlaceWidget(double bounds[6])
{
  std::copy_n(bounds, 6, this->InitialBounds);
  const vtkBoundingBox box(bounds);
  this->InitialLength = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  this->Placed = box.IsValid();
  this->Modified();
}

//------------------------------------------------------------------------------
double* vtkTextureViewsRepresentation::GetBounds()
{
  this->BuildRepresentation();
  vtkBoundingBox box;
  for (vtkProp* prop : this->Internal->props)
  {
    // Where text is depends on the camera, and so would its bounds.
    if (double* bounds = vtkActor::SafeDownCast(prop) ? prop->GetBounds() : nullptr)
    {
      box.AddBounds(bounds);
    }
  }
  if (!box.IsValid())
  {
    return nullptr;
  }
  box.GetBounds(this->Internal->bounds.data());
  return this->Internal->bounds.data();
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::GetActors(vtkPropCollection* actors)
{
  this->BuildRepresentation();
  for (vtkProp* prop : this->Internal->props)
  {
    prop->GetActors(actors);
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkProp* prop : this->Internal->allProps())
  {
    prop->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
/** Not where things are selected by drawing them: these marks have their own way. */
bool vtkTextureViewsRepresentation::IsDrawnIn(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || renderer->GetSelector())
  {
    return false;
  }
  if (!this->Renderer)
  {
    this->SetRenderer(renderer);
  }
  this->BuildRepresentation();
  // Passes, as those for translucent surfaces, tell the props of the renderer how to be drawn.
  for (vtkProp* prop : this->Internal->props)
  {
    prop->SetPropertyKeys(this->GetPropertyKeys());
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  if (this->IsDrawnIn(viewport))
  {
    for (vtkProp* prop : this->Internal->props)
    {
      drawn += prop->RenderOpaqueGeometry(viewport);
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  if (this->IsDrawnIn(viewport))
  {
    for (vtkProp* prop : this->Internal->props)
    {
      drawn += prop->RenderTranslucentPolygonalGeometry(viewport);
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkTextureViewsRepresentation::HasTranslucentPolygonalGeometry()
{
  this->BuildRepresentation();
  const auto& props = this->Internal->props;
  return std::any_of(props.begin(), props.end(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

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
void vtkTextureViewsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Views: " << this->Internal->views.Get() << "\n";
  os << indent << "ModelToWorld: " << this->Internal->modelToWorld.Get() << "\n";
  os << indent << "PictureSize: " << this->PictureSize << "\n";
  os << indent << "ShowPictures: " << this->ShowPictures << "\n";
  os << indent << "ShowLabels: " << this->ShowLabels << "\n";
  os << indent << "MovesDistance: " << this->MovesDistance << "\n";
  os << indent << "SelectedItem: " << this->Internal->selected.kind << "\n";
  os << indent << "SelectedView: " << this->Internal->selected.view << "\n";
  os << indent << "SelectedPoint: " << this->Internal->selected.point << "\n";
}

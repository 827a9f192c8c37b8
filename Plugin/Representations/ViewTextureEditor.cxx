// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureEditor.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkProp3D.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextureViews.h"
#include "vtkTextureViewsRepresentation.h"
#include "vtkTextureViewsWidget.h"

#include <algorithm>

//------------------------------------------------------------------------------
ViewTextureEditor::ViewTextureEditor()
{
  this->Marks->VisibilityOff();
  this->Marks->PickableOff();
  this->Marks->SetModelToWorld(this->ModelToWorld);
  this->Widget->SetRepresentation(this->Marks);
}

//------------------------------------------------------------------------------
ViewTextureEditor::~ViewTextureEditor()
{
  this->SetView(nullptr);
}

//------------------------------------------------------------------------------
bool ViewTextureEditor::IsAlone()
{
  auto* const processes = vtkProcessModule::GetProcessModule();
  auto* const session = vtkPVSession::SafeDownCast(processes->GetActiveSession());
  const bool draws = !session ||
    (session->HasProcessRole(vtkPVSession::CLIENT) &&
      session->HasProcessRole(vtkPVSession::RENDER_SERVER));
  return draws && processes->GetNumberOfLocalPartitions() == 1;
}

//------------------------------------------------------------------------------
void ViewTextureEditor::SetView(vtkPVRenderView* view)
{
  if (this->View == view)
  {
    return;
  }
  this->Hide();
  if (this->View)
  {
    this->View->GetRenderer()->RemoveViewProp(this->Marks);
  }
  this->View = view;
  // Only the default renderer of a widget stays: others are those under the mouse.
  vtkRenderer* const renderer = view ? view->GetRenderer() : nullptr;
  this->Widget->SetDefaultRenderer(nullptr);
  this->Widget->SetInteractor(nullptr);
  this->Widget->SetCurrentRenderer(renderer);
  this->Widget->SetDefaultRenderer(renderer);
  this->Marks->SetRenderer(renderer);
  if (renderer)
  {
    renderer->AddViewProp(this->Marks);
  }
}

//------------------------------------------------------------------------------
void ViewTextureEditor::Place(vtkTextureViews* views, vtkProp3D* surface)
{
  vtkNew<vtkMatrix4x4> matrix;
  surface->GetMatrix(matrix);
  if (!std::equal(matrix->GetData(), matrix->GetData() + 16, this->ModelToWorld->GetData()))
  {
    this->ModelToWorld->DeepCopy(matrix);
  }
  this->Widget->SetViews(views);
  double* const bounds = surface->GetBounds();
  if (bounds && vtkMath::AreBoundsInitialized(bounds))
  {
    this->Marks->PlaceWidget(bounds);
  }
}

//------------------------------------------------------------------------------
void ViewTextureEditor::Show(
  vtkTextureViews* views, vtkProp3D* surface, vtkDataObject* regions, const std::string& manifest)
{
  if (!this->View)
  {
    return;
  }
  this->Place(views, surface);
  this->Marks->SetSurface(regions);
  this->Widget->SetManifestFileName(manifest);
  this->Marks->VisibilityOn();
  this->Enable(this->View->GetInteractor() != nullptr && ViewTextureEditor::IsAlone());
}

//------------------------------------------------------------------------------
void ViewTextureEditor::Hide()
{
  this->Enable(false);
  this->Marks->VisibilityOff();
}

//------------------------------------------------------------------------------
void ViewTextureEditor::Enable(bool enabled)
{
  if ((this->Widget->GetEnabled() != 0) == enabled || !this->View)
  {
    return;
  }
  this->Widget->SetInteractor(this->View->GetInteractor());
  this->Widget->SetEnabled(enabled ? 1 : 0);
  this->View->GetRenderer()->AddViewProp(this->Marks); // the widget takes it away with itself
}

//------------------------------------------------------------------------------
int ViewTextureEditor::AddCamera(
  vtkTextureViews* views, vtkProp3D* surface, bool transparent, double angle)
{
  this->Place(views, surface);
  this->Widget->SetCurrentRenderer(this->View->GetRenderer());
  this->Widget->SetPicture(transparent || !ViewTextureEditor::IsAlone()
      ? vtkTextureViewsWidget::TRANSPARENT
      : vtkTextureViewsWidget::RENDERED);
  const int added = this->Widget->AddCurrentCamera("");
  if (added < 0)
  {
    return added;
  }
  views->SetViewKind(added, vtkTextureViews::DEPENDENT);
  vtkNew<vtkMatrix4x4> worldToModel;
  vtkMatrix4x4::Invert(this->ModelToWorld, worldToModel);
  vtkCamera* const own = this->View->GetActiveCamera();
  const double turns[4][2] = { { 0.0, angle }, { angle, 0.0 }, { 0.0, -angle }, { -angle, 0.0 } };
  for (const double* turn : turns)
  {
    vtkNew<vtkCamera> camera;
    camera->SetPosition(own->GetPosition());
    camera->SetFocalPoint(own->GetFocalPoint());
    camera->SetViewUp(own->GetViewUp());
    camera->OrthogonalizeViewUp();
    camera->Azimuth(turn[0]);
    camera->Elevation(turn[1]);
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    camera->GetPosition(point);
    worldToModel->MultiplyPoint(point, point);
    views->AddExtremePoint(added, point);
  }
  return added;
}

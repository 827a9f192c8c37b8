// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternLegendPlace.h"

#include "vtkBorderWidget.h"
#include "vtkCommand.h"
#include "vtkCompositeRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkPatternLegendActor.h"
#include "vtkPatternLegendRepresentation.h"
#include "vtkProcessModule.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

#include <string>
#include <utility>

//------------------------------------------------------------------------------
PatternLegendPlace::PatternLegendPlace(vtkActor* surface, std::function<void()> moved)
  : Moved(std::move(moved))
{
  this->GetLegend()->SetSurface(surface);
  this->Representation->VisibilityOff();
  this->Representation->PickableOff();
  this->Widget->SetRepresentation(this->Representation);
  this->Widget->SelectableOff();
  this->Widget->SetKeyPressActivation(false);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this, &PatternLegendPlace::Tell);
}

//------------------------------------------------------------------------------
PatternLegendPlace::~PatternLegendPlace()
{
  this->SetView(nullptr);
}

//------------------------------------------------------------------------------
void PatternLegendPlace::Tell()
{
  this->Moved();
}

//------------------------------------------------------------------------------
vtkPatternLegendActor* PatternLegendPlace::GetLegend() const
{
  return this->Representation->GetLegend();
}

//------------------------------------------------------------------------------
bool PatternLegendPlace::IsSeenHere()
{
  auto* const processes = vtkProcessModule::GetProcessModule();
  auto* const session = vtkPVSession::SafeDownCast(processes->GetActiveSession());
  return (!session || session->HasProcessRole(vtkPVSession::CLIENT)) &&
    processes->GetPartitionId() == 0;
}

//------------------------------------------------------------------------------
void PatternLegendPlace::SetView(vtkPVRenderView* view)
{
  if (this->View == view)
  {
    return;
  }
  this->Widget->SetEnabled(0);
  if (this->View)
  {
    this->View->GetNonCompositedRenderer()->RemoveViewProp(this->Representation);
  }
  this->View = view;
  vtkRenderer* const renderer = view ? view->GetNonCompositedRenderer() : nullptr;
  // Only the default renderer of a widget stays: others are those under the mouse.
  this->Widget->SetDefaultRenderer(nullptr);
  this->Widget->SetInteractor(nullptr);
  this->Widget->SetCurrentRenderer(renderer);
  this->Widget->SetDefaultRenderer(renderer);
  this->Representation->SetRenderer(renderer);
  if (renderer)
  {
    renderer->AddViewProp(this->Representation);
  }
  this->Update();
}

//------------------------------------------------------------------------------
void PatternLegendPlace::SetShown(bool shown)
{
  this->Shown = shown;
  this->Update();
}

//------------------------------------------------------------------------------
void PatternLegendPlace::SetSurfaceVisible(bool visible)
{
  this->SurfaceVisible = visible;
  this->Update();
}

//------------------------------------------------------------------------------
void PatternLegendPlace::Update()
{
  const bool seen = this->Shown && this->SurfaceVisible && PatternLegendPlace::IsSeenHere();
  this->Representation->SetVisibility(seen);
  const bool enabled = seen && this->View && this->View->GetInteractor();
  if (this->View && (this->Widget->GetEnabled() != 0) != enabled)
  {
    this->Widget->SetInteractor(this->View->GetInteractor());
    this->Widget->SetEnabled(enabled ? 1 : 0);
    // The widget takes it away with itself, and makes it visible.
    this->View->GetNonCompositedRenderer()->AddViewProp(this->Representation);
    this->Representation->SetVisibility(seen);
  }
}

//------------------------------------------------------------------------------
void writeLegendPlace(vtkObjectBase* representation, const double corner[2], const double size[2])
{
  vtkSMProxyManager* const manager = vtkSMProxyManager::GetProxyManager();
  vtkSMSessionProxyManager* const session =
    manager ? manager->GetActiveSessionProxyManager() : nullptr;
  if (!session)
  {
    return;
  }
  // The XML names properties after the class.
  const std::string className = representation->GetClassName();
  const std::size_t before = std::string("vtk").size();
  const std::string prefix = className.substr(before, className.find("Representation") - before);
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSessionProxyManager(session);
  for (proxies->Begin("representations"); !proxies->IsAtEnd(); proxies->Next())
  {
    vtkSMProxy* const proxy = proxies->GetProxy();
    auto* const parts = vtkCompositeRepresentation::SafeDownCast(proxy->GetClientSideObject());
    if (parts && parts->GetActiveRepresentation() == representation)
    {
      vtkSMPropertyHelper(proxy, (prefix + "LegendPosition").c_str(), true).Set(corner, 2);
      vtkSMPropertyHelper(proxy, (prefix + "LegendSize").c_str(), true).Set(size, 2);
      proxy->UpdateVTKObjects();
      return;
    }
  }
}

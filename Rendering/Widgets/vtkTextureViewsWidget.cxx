// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureViewsWidget.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextureViews.h"
#include "vtkTextureViewsRepresentation.h"
#include "vtkWidgetCallbackMapper.h"
#include "vtkWidgetEvent.h"

#include <cctype>

vtkStandardNewMacro(vtkTextureViewsWidget);

namespace
{

/** By how much keys change numbers. */
constexpr double percentageStep = 5.0;
constexpr double plateauStep = 0.05;
constexpr double newPercentage = 50.0;

} // namespace

//------------------------------------------------------------------------------
vtkTextureViewsWidget::vtkTextureViewsWidget()
{
  const struct
  {
    unsigned long event;
    unsigned long widgetEvent;
    void (*action)(vtkAbstractWidget*);
  } actions[] = {
    { vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, SelectAction },
    { vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, MoveAction },
    { vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, EndSelectAction },
    { vtkCommand::KeyPressEvent, vtkWidgetEvent::ModifyEvent, KeyAction },
    { vtkCommand::CharEvent, vtkWidgetEvent::Completed, CharAction },
  };
  for (const auto& action : actions)
  {
    this->CallbackMapper->SetCallbackMethod(action.event, action.widgetEvent, this, action.action);
  }
}

//------------------------------------------------------------------------------
vtkTextureViewsWidget::~vtkTextureViewsWidget() = default;

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
  {
    this->WidgetRep = vtkTextureViewsRepresentation::New();
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::SetRepresentation(vtkTextureViewsRepresentation* representation)
{
  this->EndDrag();
  this->History.clear();
  this->SetWidgetRepresentation(representation);
}

//------------------------------------------------------------------------------
vtkTextureViewsRepresentation* vtkTextureViewsWidget::GetTextureViewsRepresentation()
{
  return static_cast<vtkTextureViewsRepresentation*>(this->GetRepresentation());
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::SetViews(vtkTextureViews* views)
{
  if (views != this->GetViews())
  {
    this->EndDrag();
    this->History.clear();
    this->GetTextureViewsRepresentation()->SetViews(views);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTextureViews* vtkTextureViewsWidget::GetViews()
{
  return this->GetTextureViewsRepresentation()->GetViews();
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::SetEnabled(int enabling)
{
  if (!enabling)
  {
    this->EndDrag();
  }
  this->Superclass::SetEnabled(enabling);
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::SetCursor(int state)
{
  this->RequestCursorShape(
    state == vtkTextureViewsRepresentation::NOTHING ? VTK_CURSOR_DEFAULT : VTK_CURSOR_HAND);
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::IsHere(int x, int y)
{
  return this->CurrentRenderer && this->CurrentRenderer->IsInViewport(x, y);
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::SelectAction(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkTextureViewsWidget*>(widget);
  vtkTextureViewsRepresentation* representation = self->GetTextureViewsRepresentation();
  const int* place = self->Interactor->GetEventPosition();
  if (!self->IsHere(place[0], place[1]) ||
    !representation->ComputeInteractionState(place[0], place[1]))
  {
    return;
  }
  representation->SelectFound();
  double start[2] = { double(place[0]), double(place[1]) };
  representation->StartWidgetInteraction(start);
  self->GrabFocus(self->EventCallbackCommand);
  self->Dragging = true;
  self->Dragged = false;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->StartInteraction();
  self->InvokeEvent(vtkCommand::StartInteractionEvent, nullptr);
  self->Render();
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::MoveAction(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkTextureViewsWidget*>(widget);
  vtkTextureViewsRepresentation* representation = self->GetTextureViewsRepresentation();
  const int* place = self->Interactor->GetEventPosition();
  if (!self->Dragging)
  {
    const bool here = self->IsHere(place[0], place[1]);
    self->SetCursor(here ? representation->ComputeInteractionState(place[0], place[1])
                         : vtkTextureViewsRepresentation::NOTHING);
    return;
  }
  if (!self->Dragged && self->GetViews())
  {
    self->Remember();
    self->Dragged = true;
  }
  double to[2] = { double(place[0]), double(place[1]) };
  representation->SetMovesDistance(self->Interactor->GetShiftKey() != 0);
  representation->WidgetInteraction(to);
  self->EventCallbackCommand->SetAbortFlag(1);
  self->InvokeEvent(vtkCommand::InteractionEvent, nullptr);
  self->Render();
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::EndSelectAction(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkTextureViewsWidget*>(widget);
  if (self->Dragging)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->EndDrag();
    self->Render();
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::EndDrag()
{
  if (this->Dragging)
  {
    this->Dragging = false;
    // Both may be on their way out, with the interactor first.
    if (this->Interactor && this->Interactor->GetRenderWindow())
    {
      this->ReleaseFocus();
      this->EndInteraction();
    }
    this->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::KeyAction(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkTextureViewsWidget*>(widget);
  const int* place = self->Interactor->GetEventPosition();
  self->KeyTaken = self->GetViews() && self->IsHere(place[0], place[1]) && self->ActOnKey();
  if (self->KeyTaken)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

//------------------------------------------------------------------------------
/** Styles act on characters, which follow the keys. */
void vtkTextureViewsWidget::CharAction(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkTextureViewsWidget*>(widget);
  if (self->KeyTaken)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
  self->KeyTaken = false;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::ActOnKey()
{
  const std::string name = this->Interactor->GetKeySym() ? this->Interactor->GetKeySym() : "";
  if (this->Interactor->GetControlKey() || this->Interactor->GetAltKey())
  {
    return this->Interactor->GetControlKey() && (name == "z" || name == "Z") && this->Undo();
  }
  if (name == "Delete" || name == "BackSpace")
  {
    return this->RemoveSelected();
  }
  return this->ActOnLetter(
    static_cast<char>(std::tolower(static_cast<unsigned char>(this->Interactor->GetKeyCode()))));
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::ActOnLetter(char letter)
{
  const int* place = this->Interactor->GetEventPosition();
  const double sign = letter == '-' ? -1.0 : 1.0;
  switch (letter)
  {
    case 'a':
      this->AddCurrentCamera("");
      return true;
    case 'e':
      this->AddExtremePoint(place[0], place[1]);
      return true;
    case 'b':
      this->AddBlendPoint(newPercentage);
      return true;
    case 's':
      this->Save();
      return true;
    case '+':
    case '-':
      return this->ChangePercentage(sign * percentageStep) ||
        this->ChangePlateau(sign * plateauStep);
    case 'm':
      return this->SwitchFadeMode();
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ManifestFileName: " << this->ManifestFileName << "\n";
  os << indent << "Picture: " << this->Picture << "\n";
  os << indent << "Actions to undo: " << this->History.size() << "\n";
}

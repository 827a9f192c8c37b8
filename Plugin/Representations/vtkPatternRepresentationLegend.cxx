// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// The legend of the representation.
#include "vtkPatternRepresentation.h"

#include "PatternLegendPlace.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPatternLegendActor.h"
#include "vtkPatternLegendRepresentation.h"
#include "vtkTextProperty.h"

//------------------------------------------------------------------------------
std::unique_ptr<PatternLegendPlace> vtkPatternRepresentation::MakeLegend()
{
  auto legend = std::make_unique<PatternLegendPlace>(this->Actor,
    [this]()
    {
      const double* const corner = this->GetPatternLegendPosition();
      const double* const size = this->GetPatternLegendSize();
      const double place[] = { corner[0], corner[1], size[0], size[1] };
      writeLegendPlace(this, place, place + 2);
    });
  legend->GetRepresentation()->SetPosition(0.82, 0.2);
  legend->GetRepresentation()->SetPosition2(0.16, 0.6);
  return legend;
}

//------------------------------------------------------------------------------
vtkPatternLegendActor* vtkPatternRepresentation::GetLegend()
{
  return this->Legend->GetLegend();
}

//------------------------------------------------------------------------------
bool vtkPatternRepresentation::AddToView(vtkView* view)
{
  this->Legend->SetView(vtkPVRenderView::SafeDownCast(view));
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkPatternRepresentation::RemoveFromView(vtkView* view)
{
  this->Legend->SetView(nullptr);
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Legend->SetSurfaceVisible(visible);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegend(int shown)
{
  this->Legend->SetShown(shown != 0);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegend()
{
  return this->Legend->GetShown() ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendPosition(double x, double y)
{
  this->Legend->GetRepresentation()->SetPosition(x, y);
}

//------------------------------------------------------------------------------
double* vtkPatternRepresentation::GetPatternLegendPosition()
{
  return this->Legend->GetRepresentation()->GetPosition();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendSize(double width, double height)
{
  this->Legend->GetRepresentation()->SetPosition2(std::max(0.0, width), std::max(0.0, height));
}

//------------------------------------------------------------------------------
double* vtkPatternRepresentation::GetPatternLegendSize()
{
  return this->Legend->GetRepresentation()->GetPosition2();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendTitle(const char* title)
{
  this->GetLegend()->SetTitle(title ? title : "");
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternLegendTitle()
{
  this->LegendText = this->GetLegend()->GetTitle();
  return this->LegendText.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendOrientation(int orientation)
{
  this->GetLegend()->SetOrientation(orientation);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendOrientation()
{
  return this->GetLegend()->GetOrientation();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendMode(int mode)
{
  this->GetLegend()->SetMode(mode);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendMode()
{
  return this->GetLegend()->GetMode();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendSteps(int steps)
{
  this->GetLegend()->SetNumberOfSteps(steps);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendSteps()
{
  return this->GetLegend()->GetNumberOfSteps();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendLabels(int labels)
{
  this->GetLegend()->SetNumberOfLabels(labels);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendLabels()
{
  return this->GetLegend()->GetNumberOfLabels();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendLabelFormat(const char* format)
{
  this->GetLegend()->SetLabelFormat(format ? format : "");
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternLegendLabelFormat()
{
  this->LegendText = this->GetLegend()->GetLabelFormat();
  return this->LegendText.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendNan(int shown)
{
  this->GetLegend()->SetDrawNanSwatch(shown != 0);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendNan()
{
  return this->GetLegend()->GetDrawNanSwatch() ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendThickness(int pixels)
{
  this->GetLegend()->SetSwatchThickness(pixels);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendThickness()
{
  return this->GetLegend()->GetSwatchThickness();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendTitleFontSize(int points)
{
  this->GetLegend()->GetTitleTextProperty()->SetFontSize(std::clamp(points, 4, 200));
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendTitleFontSize()
{
  return this->GetLegend()->GetTitleTextProperty()->GetFontSize();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLegendLabelFontSize(int points)
{
  this->GetLegend()->GetLabelTextProperty()->SetFontSize(std::clamp(points, 4, 200));
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternLegendLabelFontSize()
{
  return this->GetLegend()->GetLabelTextProperty()->GetFontSize();
}

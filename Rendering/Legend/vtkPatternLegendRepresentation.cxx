// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternLegendRepresentation.h"

#include "vtkObjectFactory.h"
#include "vtkPatternLegendActor.h"
#include "vtkPropCollection.h"

#include <algorithm>

vtkStandardNewMacro(vtkPatternLegendRepresentation);

vtkPatternLegendRepresentation::vtkPatternLegendRepresentation()
  : Legend(vtkSmartPointer<vtkPatternLegendActor>::New())
{
  this->SetShowBorder(BORDER_ACTIVE);
  const double* corner = this->Legend->GetPosition();
  this->SetPosition(corner[0], corner[1]);
  const double* size = this->Legend->GetPosition2();
  this->SetPosition2(size[0], size[1]);
}

vtkPatternLegendRepresentation::~vtkPatternLegendRepresentation() = default;

void vtkPatternLegendRepresentation::SetLegend(vtkPatternLegendActor* legend)
{
  if (!legend)
  {
    vtkErrorMacro("There must be a legend; null was given.");
  }
  else if (this->Legend != legend)
  {
    this->Legend = legend;
    this->Modified();
  }
}

vtkPatternLegendActor* vtkPatternLegendRepresentation::GetLegend()
{
  return this->Legend;
}

void vtkPatternLegendRepresentation::BuildRepresentation()
{
  this->Legend->SetPosition(this->GetPosition());
  this->Legend->SetPosition2(this->GetPosition2());
  this->Superclass::BuildRepresentation();
}

// Any proportion will do.
void vtkPatternLegendRepresentation::GetSize(double size[2])
{
  size[0] = 1.0;
  size[1] = 1.0;
}

void vtkPatternLegendRepresentation::GetActors2D(vtkPropCollection* props)
{
  props->AddItem(this->Legend);
  this->Superclass::GetActors2D(props);
}

void vtkPatternLegendRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Legend->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkPatternLegendRepresentation::RenderOverlay(vtkViewport* viewport)
{
  this->BuildRepresentation();
  const int drawn = this->Legend->GetVisibility() ? this->Legend->RenderOverlay(viewport) : 0;
  return drawn + this->Superclass::RenderOverlay(viewport);
}

vtkMTimeType vtkPatternLegendRepresentation::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Legend->GetMTime());
}

void vtkPatternLegendRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Legend: " << this->Legend.Get() << "\n";
}

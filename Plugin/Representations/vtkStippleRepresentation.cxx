// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStippleRepresentation.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkStippleRepresentation);

//------------------------------------------------------------------------------
vtkStippleRepresentation::vtkStippleRepresentation()
{
  this->SetPatternStyle("stipple");
}

//------------------------------------------------------------------------------
vtkStippleRepresentation::~vtkStippleRepresentation() = default;

//------------------------------------------------------------------------------
void vtkStippleRepresentation::AdjustStyle(vtkPatternStyle* style)
{
  this->Superclass::AdjustStyle(style);
  ForEachLayer<vtkStippleLayer>(style,
    [this](vtkStippleLayer* layer)
    {
      this->AdjustDots(layer);
      this->AdjustPoints(layer);
    });
}

//------------------------------------------------------------------------------
void vtkStippleRepresentation::AdjustDots(vtkStippleLayer* layer)
{
  if (this->StippleSize > 0.0)
  {
    layer->SetSize(this->StippleSize * this->GetPatternScale());
    layer->SetSizeUnit(vtkPatternLayer::PIXELS);
  }
  if (this->StippleCarrier != AS_IN_STYLE)
  {
    layer->SetCarrier(this->StippleCarrier);
  }
  if (this->StippleGrowth > 0.0)
  {
    layer->SetGrowth(this->StippleGrowth);
  }
  if (this->StippleGrowthFrames >= 0)
  {
    layer->SetGrowthFrames(this->StippleGrowthFrames);
  }
  if (this->StippleLife >= 0)
  {
    layer->SetLife(this->StippleLife);
  }
}

//------------------------------------------------------------------------------
void vtkStippleRepresentation::AdjustPoints(vtkStippleLayer* layer)
{
  if (this->StippleOrder != AS_IN_STYLE)
  {
    layer->SetOrder(this->StippleOrder);
  }
  if (this->StippleNumberOfPoints > 0)
  {
    layer->SetNumberOfPoints(this->StippleNumberOfPoints);
  }
  if (this->StippleRefinement != AS_IN_STYLE)
  {
    layer->SetRefinement(this->StippleRefinement != 0);
  }
  if (this->StippleMemoryBudget > 0)
  {
    layer->SetMemoryBudget(this->StippleMemoryBudget);
  }
}

//------------------------------------------------------------------------------
void vtkStippleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StippleSize: " << this->StippleSize << "\n";
  os << indent << "StippleCarrier: " << this->StippleCarrier << "\n";
  os << indent << "StippleGrowth: " << this->StippleGrowth << "\n";
  os << indent << "StippleGrowthFrames: " << this->StippleGrowthFrames << "\n";
  os << indent << "StippleLife: " << this->StippleLife << "\n";
  os << indent << "StippleOrder: " << this->StippleOrder << "\n";
  os << indent << "StippleNumberOfPoints: " << this->StippleNumberOfPoints << "\n";
  os << indent << "StippleRefinement: " << this->StippleRefinement << "\n";
  os << indent << "StippleMemoryBudget: " << this->StippleMemoryBudget << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStippleLayer.h"

#include "PatternStyleArchive.h"
#include "vtkObjectFactory.h"

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkStippleLayer);

//------------------------------------------------------------------------------
double vtkStippleLayer::GetReach(double dotsPerInch)
{
  constexpr double millimetresPerInch = 25.4;
  return this->Size * (this->SizeUnit == MILLIMETRES ? dotsPerInch / millimetresPerInch : 1.0);
}

void vtkStippleLayer::DescribeField(hachure::StyleArchive& archive)
{
  using Self = vtkStippleLayer;
  archive.length("size", this, &Self::GetSize, &Self::SetSize, &Self::GetSizeUnit,
    &Self::SetSizeUnit, { this->GetSizeMinValue(), this->GetSizeMaxValue() });
  archive.choice("carrier", this, &Self::GetCarrier, &Self::SetCarrier, { "density", "size" });
  archive.number("growth", this, &Self::GetGrowth, &Self::SetGrowth,
    { this->GetGrowthMinValue(), this->GetGrowthMaxValue() });
  archive.integer("growthFrames", this, &Self::GetGrowthFrames, &Self::SetGrowthFrames,
    { double(this->GetGrowthFramesMinValue()), double(this->GetGrowthFramesMaxValue()) });
  archive.choice("order", this, &Self::GetOrder, &Self::SetOrder, { "progressive", "classic" });
  archive.integer("numberOfPoints", this, &Self::GetNumberOfPoints, &Self::SetNumberOfPoints,
    { double(this->GetNumberOfPointsMinValue()), double(this->GetNumberOfPointsMaxValue()) });
  archive.boolean("refinement", this, &Self::GetRefinement, &Self::SetRefinement);
  archive.integer("life", this, &Self::GetLife, &Self::SetLife,
    { double(this->GetLifeMinValue()), double(this->GetLifeMaxValue()) });
  archive.integer("memoryBudget", this, &Self::GetMemoryBudget, &Self::SetMemoryBudget,
    { double(this->GetMemoryBudgetMinValue()), double(this->GetMemoryBudgetMaxValue()) });
}

//------------------------------------------------------------------------------
void vtkStippleLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "SizeUnit: " << this->SizeUnit << "\n";
  os << indent << "Carrier: " << this->Carrier << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "GrowthFrames: " << this->GrowthFrames << "\n";
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Refinement: " << this->Refinement << "\n";
  os << indent << "Life: " << this->Life << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}

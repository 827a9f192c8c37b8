// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternTone.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPatternTone);

//------------------------------------------------------------------------------
void vtkPatternTone::SetArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (text != this->ArrayName)
  {
    this->ArrayName = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkPatternTone::GetArrayName()
{
  return this->ArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternTone::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << this->Source << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "ArrayAssociation: " << this->ArrayAssociation << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Range: " << this->Range[0] << ", " << this->Range[1] << "\n";
  os << indent << "Constant: " << this->Constant << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Invert: " << this->Invert << "\n";
  os << indent << "Remap: " << this->Remap << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "RemapRange: " << this->RemapRange[0] << ", " << this->RemapRange[1] << "\n";
  os << indent << "LightIndex: " << this->LightIndex << "\n";
  os << indent << "HighlightPower: " << this->HighlightPower << "\n";
  os << indent << "BlackGeneration: " << this->BlackGeneration << "\n";
}

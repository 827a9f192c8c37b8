// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternLayer.h"

#include "PatternColor.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkPatternLayer::vtkPatternLayer()
  : Tone(vtkSmartPointer<vtkPatternTone>::New())
{
}

//------------------------------------------------------------------------------
vtkPatternLayer::~vtkPatternLayer() = default;

//------------------------------------------------------------------------------
void vtkPatternLayer::SetTone(vtkPatternTone* tone)
{
  if (!tone)
  {
    vtkErrorMacro("SetTone: a layer always has a tone, but null was given.");
    return;
  }
  if (this->Tone != tone)
  {
    this->Tone = tone;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPatternTone* vtkPatternLayer::GetTone()
{
  return this->Tone;
}

//------------------------------------------------------------------------------
void vtkPatternLayer::SetColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  this->SetColor(color);
}

//------------------------------------------------------------------------------
void vtkPatternLayer::SetColor(const double color[3])
{
  if (hachure::assignColor(this->Color, color))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPatternLayer::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Tone->GetMTime());
}

//------------------------------------------------------------------------------
void vtkPatternLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tone:\n";
  this->Tone->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Color: " << this->Color[0] << ", " << this->Color[1] << ", " << this->Color[2]
     << "\n";
  os << indent << "ColorSource: " << this->ColorSource << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
}

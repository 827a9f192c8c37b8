// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternRepresentation.h"

#include "vtkDataObject.h"
#include "vtkImagePatternLayer.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPatternLayer.h"
#include "vtkPatternMapper.h"
#include "vtkPatternStyle.h"
#include "vtkPatternTone.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPatternRepresentation);

namespace
{
// The setters take angles within a full turn.
double WithinTurn(double degrees)
{
  return std::fmod(degrees, 360.0);
}

std::string Text(const char* text)
{
  return text ? text : "";
}
} // namespace

//------------------------------------------------------------------------------
vtkPatternRepresentation::vtkPatternRepresentation()
  : PatternStyle(vtkPatternStyle::GetDefaultPresetName())
{
  this->Mapper->Delete();
  this->LODMapper->Delete();
  auto* mapper = vtkPatternMapper::New();
  auto* mapperLOD = vtkPatternMapper::New();
  mapperLOD->SetTrackedMapper(mapper);
  // The base class set these on the mapper that was replaced; selections need them.
  mapper->SetProcessIdArrayName("vtkProcessId");
  mapper->SetCompositeIdArrayName("vtkCompositeIndex");
  this->Mapper = mapper;
  this->LODMapper = mapperLOD;
  this->SetArrayIdNames(nullptr, nullptr);
  this->SetupDefaults();
  this->UpdateStyle();
}

//------------------------------------------------------------------------------
template <class T>
void vtkPatternRepresentation::Change(T& member, const T& value)
{
  if (member != value)
  {
    member = value;
    this->StyleChanged = true;
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternStyle(const char* name)
{
  this->Change(this->PatternStyle, Text(name));
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternStyle()
{
  return this->PatternStyle.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternStyleFile(const char* fileName)
{
  this->Change(this->PatternStyleFile, Text(fileName));
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternStyleFile()
{
  return this->PatternStyleFile.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternTone(int source)
{
  this->Change(
    this->PatternTone, std::clamp<int>(source, AS_IN_STYLE, vtkPatternTone::SourceType::ARRAY));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternToneArray(int vtkNotUsed(index), int vtkNotUsed(port),
  int vtkNotUsed(connection), int association, const char* name)
{
  this->Change(this->PatternToneAssociation, association);
  this->Change(this->PatternToneArrayName, Text(name));
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternToneArrayName()
{
  return this->PatternToneArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternToneComponent(int component)
{
  this->Change(this->PatternToneComponent, std::max(component, -1));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternToneRange(double paper, double ink)
{
  this->Change(this->PatternToneRange[0], paper);
  this->Change(this->PatternToneRange[1], ink);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternScale(double scale)
{
  this->Change(this->PatternScale, std::clamp(scale, 0.01, 100.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternAngle(double angle)
{
  this->Change(this->PatternAngle, std::clamp(angle, -360.0, 360.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternInk(int choice)
{
  this->Change(this->PatternInk, std::clamp<int>(choice, AS_IN_STYLE, 0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternInkColor(double red, double green, double blue)
{
  this->Change(this->PatternInkColor[0], std::clamp(red, 0.0, 1.0));
  this->Change(this->PatternInkColor[1], std::clamp(green, 0.0, 1.0));
  this->Change(this->PatternInkColor[2], std::clamp(blue, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPaper(int choice)
{
  this->Change(this->PatternPaper,
    std::clamp<int>(choice, AS_IN_STYLE, vtkPatternStyle::PaperSourceType::FLAT));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPaperColor(double red, double green, double blue)
{
  this->Change(this->PatternPaperColor[0], std::clamp(red, 0.0, 1.0));
  this->Change(this->PatternPaperColor[1], std::clamp(green, 0.0, 1.0));
  this->Change(this->PatternPaperColor[2], std::clamp(blue, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternOutline(int choice)
{
  this->Change(this->PatternOutline, std::clamp<int>(choice, AS_IN_STYLE, 1));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternOutlineWidth(double width)
{
  this->Change(this->PatternOutlineWidth, std::clamp(width, 0.0, 100.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternTracking(int choice)
{
  this->Change(this->PatternTracking,
    std::clamp<int>(choice, AS_IN_STYLE, vtkPatternStyle::TrackingModeType::ANCHORED));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::UpdateColoringParameters()
{
  this->Superclass::UpdateColoringParameters();
  this->UpdateStyle();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::UpdateStyle()
{
  if (!this->StyleChanged)
  {
    return;
  }
  this->StyleChanged = false; // also when it cannot be loaded: one error, not one per picture
  vtkNew<vtkPatternStyle> style;
  if (this->LoadStyle(style))
  {
    this->AdjustStyle(style);
    static_cast<vtkPatternMapper*>(this->Mapper)->SetStyle(style);
    static_cast<vtkPatternMapper*>(this->LODMapper)->SetStyle(style);
  }
}

//------------------------------------------------------------------------------
bool vtkPatternRepresentation::LoadStyle(vtkPatternStyle* style)
{
  return this->PatternStyleFile.empty() ? style->LoadPreset(this->PatternStyle)
                                        : style->LoadFile(this->PatternStyleFile);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustStyle(vtkPatternStyle* style)
{
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    this->AdjustLayer(style->GetLayer(i));
  }
  if (this->PatternInk != AS_IN_STYLE)
  {
    style->SetOutlineColor(this->PatternInkColor);
  }
  if (this->PatternPaper != AS_IN_STYLE)
  {
    style->SetPaperSource(this->PatternPaper);
    style->SetPaperColor(this->PatternPaperColor);
  }
  if (this->PatternOutline != AS_IN_STYLE)
  {
    style->SetOutline(this->PatternOutline != 0);
    style->SetOutlineWidth(this->PatternOutlineWidth);
    style->SetOutlineWidthUnit(vtkPatternLayer::PIXELS);
  }
  if (this->PatternTracking != AS_IN_STYLE)
  {
    style->SetTrackingMode(this->PatternTracking);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustLayer(vtkPatternLayer* layer)
{
  if (auto* image = vtkImagePatternLayer::SafeDownCast(layer))
  {
    image->SetSize(image->GetSize() * this->PatternScale);
    image->SetAngle(WithinTurn(image->GetAngle() + this->PatternAngle));
  }
  if (this->PatternInk != AS_IN_STYLE)
  {
    layer->SetColor(this->PatternInkColor);
  }
  if (this->PatternTone == AS_IN_STYLE)
  {
    return;
  }
  vtkPatternTone* tone = layer->GetTone();
  tone->SetSource(this->PatternTone);
  if (this->PatternTone == vtkPatternTone::ARRAY)
  {
    const double low = this->PatternToneRange[0];
    const double high = this->PatternToneRange[1];
    tone->SetArrayName(this->PatternToneArrayName.c_str());
    tone->SetArrayAssociation(this->PatternToneAssociation == vtkDataObject::FIELD_ASSOCIATION_CELLS
        ? vtkPatternTone::CELLS
        : vtkPatternTone::POINTS);
    tone->SetComponent(this->PatternToneComponent);
    tone->SetRange(low, low != high ? high : low + std::max(1.0, std::abs(low)));
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatternStyle: " << this->PatternStyle << "\n";
  os << indent << "PatternStyleFile: " << this->PatternStyleFile << "\n";
  os << indent << "PatternTone: " << this->PatternTone << "\n";
  os << indent << "PatternToneArrayName: " << this->PatternToneArrayName << "\n";
  os << indent << "PatternToneAssociation: " << this->PatternToneAssociation << "\n";
  os << indent << "PatternToneComponent: " << this->PatternToneComponent << "\n";
  os << indent << "PatternToneRange: " << this->PatternToneRange[0] << ", "
     << this->PatternToneRange[1] << "\n";
  os << indent << "PatternScale: " << this->PatternScale << "\n";
  os << indent << "PatternAngle: " << this->PatternAngle << "\n";
  os << indent << "PatternInk: " << this->PatternInk << "\n";
  os << indent << "PatternInkColor: " << this->PatternInkColor[0] << ", "
     << this->PatternInkColor[1] << ", " << this->PatternInkColor[2] << "\n";
  os << indent << "PatternPaper: " << this->PatternPaper << "\n";
  os << indent << "PatternPaperColor: " << this->PatternPaperColor[0] << ", "
     << this->PatternPaperColor[1] << ", " << this->PatternPaperColor[2] << "\n";
  os << indent << "PatternOutline: " << this->PatternOutline << "\n";
  os << indent << "PatternOutlineWidth: " << this->PatternOutlineWidth << "\n";
  os << indent << "PatternTracking: " << this->PatternTracking << "\n";
}

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
#include "vtkRepresentationPatches.h"
#include "vtkSurfacePatches.h"

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

// The method of vtkSurfacePatches for patches that are made here.
int MethodOf(int patches)
{
  switch (patches)
  {
    case vtkPatternRepresentation::ARRAY:
      return vtkSurfacePatches::ARRAY;
    case vtkPatternRepresentation::CONNECTED:
      return vtkSurfacePatches::CONNECTED;
    case vtkPatternRepresentation::BLOCKS:
      return vtkSurfacePatches::BLOCK;
    case vtkPatternRepresentation::CREASES:
      return vtkSurfacePatches::CREASE;
    default:
      return vtkSurfacePatches::AUTOMATIC;
  }
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
  this->Patches = vtkSmartPointer<vtkRepresentationPatches>::New();
  this->Patches->SetInputConnection(this->GeometryFilter->GetOutputPort());
  this->UpdatePatches();
  this->UpdateStyle();
}

//------------------------------------------------------------------------------
vtkPatternRepresentation::~vtkPatternRepresentation() = default;

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
void vtkPatternRepresentation::SetPatternDensities(int densities)
{
  this->Change(this->PatternDensities, std::clamp(densities, 0, 4));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPaperGrain(int choice)
{
  this->Change(this->PatternPaperGrain, std::clamp<int>(choice, AS_IN_STYLE, 1));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPaperContrast(double contrast)
{
  this->Change(this->PatternPaperContrast, std::clamp(contrast, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternTransition(int choice)
{
  this->Change(this->PatternTransition,
    std::clamp<int>(choice, AS_IN_STYLE, vtkImagePatternLayer::BLEND_SCREENS));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternToneCorrection(int choice)
{
  this->Change(this->PatternToneCorrection,
    std::clamp<int>(choice, AS_IN_STYLE, vtkImagePatternLayer::NO_CORRECTION));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternMotion(int choice)
{
  this->Change(
    this->PatternMotion, std::clamp<int>(choice, AS_IN_STYLE, vtkImagePatternLayer::DYNAMIC_SOLID));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternSurfacePeriod(double period)
{
  this->Change(this->PatternSurfacePeriod, std::max(period, 0.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLockRotation(int choice)
{
  this->Change(this->PatternLockRotation, std::clamp<int>(choice, AS_IN_STYLE, 1));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternLockScale(int choice)
{
  this->Change(this->PatternLockScale, std::clamp<int>(choice, AS_IN_STYLE, 1));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternWeights(int choice)
{
  this->Change(
    this->PatternWeights, std::clamp<int>(choice, AS_IN_STYLE, vtkPatternStyle::PERCEPTUAL));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternFeatures(int source)
{
  this->Change(this->PatternFeatures,
    std::clamp<int>(source, vtkPatternStyle::CURVATURE, vtkPatternStyle::ARRAY));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternFeatureArray(int vtkNotUsed(index), int vtkNotUsed(port),
  int vtkNotUsed(connection), int vtkNotUsed(association), const char* name)
{
  this->Change(this->PatternFeatureArrayName, Text(name));
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternFeatureArrayName()
{
  return this->PatternFeatureArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternVelocityArray(const char* name)
{
  this->PatternVelocityArray = Text(name);
  const std::string array = this->PatternVelocityArray == "None" ? "" : this->PatternVelocityArray;
  static_cast<vtkPatternMapper*>(this->Mapper)->SetVelocityArrayName(array);
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternVelocityArray()
{
  return this->PatternVelocityArray.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPatches(int patches)
{
  this->ChangePatches(this->PatternPatches, std::clamp<int>(patches, AS_IN_DATA, AUTOMATIC));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPatchArray(int vtkNotUsed(index), int vtkNotUsed(port),
  int vtkNotUsed(connection), int vtkNotUsed(association), const char* name)
{
  this->ChangePatches(this->PatternPatchArrayName, Text(name));
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternPatchArrayName()
{
  return this->PatternPatchArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternNumberOfPatches(int count)
{
  this->ChangePatches(this->PatternNumberOfPatches, std::max(count, 1));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternCreaseAngle(double angle)
{
  this->ChangePatches(this->PatternCreaseAngle, std::clamp(angle, 0.0, 180.0));
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetPatternPatchBlend(int rings)
{
  this->ChangePatches(this->PatternPatchBlend, std::max(rings, 0));
}

//------------------------------------------------------------------------------
template <class T>
void vtkPatternRepresentation::ChangePatches(T& member, const T& value)
{
  if (member != value)
  {
    member = value;
    this->UpdatePatches();
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::UpdatePatches()
{
  this->Patches->SetMethod(MethodOf(this->PatternPatches));
  this->Patches->SetArrayName(this->PatternPatchArrayName);
  this->Patches->SetNumberOfPatches(this->PatternNumberOfPatches);
  this->Patches->SetCreaseAngle(this->PatternCreaseAngle);
  this->Patches->SetRings(this->PatternPatchBlend);
  vtkAlgorithm* surface = this->Patches;
  if (this->PatternPatches <= NONE)
  {
    surface = this->GeometryFilter;
  }
  this->MultiBlockMaker->SetInputConnection(surface->GetOutputPort());
  const char* const array = this->PatternPatches == NONE ? "" : "PatchId";
  static_cast<vtkPatternMapper*>(this->Mapper)->SetPatchArrayName(array);
  static_cast<vtkPatternMapper*>(this->LODMapper)->SetPatchArrayName(array);
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
  this->AdjustMotion(style);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustMotion(vtkPatternStyle* style)
{
  if (this->PatternTracking != AS_IN_STYLE)
  {
    style->SetTrackingMode(this->PatternTracking);
  }
  if (this->PatternLockRotation != AS_IN_STYLE)
  {
    style->SetLockRotation(this->PatternLockRotation != 0);
  }
  if (this->PatternLockScale != AS_IN_STYLE)
  {
    style->SetLockScale(this->PatternLockScale != 0);
  }
  if (this->PatternWeights != AS_IN_STYLE)
  {
    style->SetWeightScheme(this->PatternWeights);
    style->SetFeatureSource(this->PatternFeatures);
    style->SetFeatureArrayName(this->PatternFeatureArrayName);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustLayer(vtkPatternLayer* layer)
{
  if (auto* image = vtkImagePatternLayer::SafeDownCast(layer))
  {
    this->AdjustImageLayer(image);
  }
  if (this->PatternInk != AS_IN_STYLE)
  {
    layer->SetColor(this->PatternInkColor);
  }
  if (this->PatternTone != AS_IN_STYLE)
  {
    this->AdjustTone(layer);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustImageLayer(vtkImagePatternLayer* layer)
{
  layer->SetSize(layer->GetSize() * this->PatternScale);
  layer->SetAngle(WithinTurn(layer->GetAngle() + this->PatternAngle));
  if (this->PatternDensities > 0)
  {
    layer->SetDensities(this->PatternDensities);
  }
  if (this->PatternPaperGrain != AS_IN_STYLE)
  {
    layer->SetPaperContrast(this->PatternPaperGrain != 0 ? this->PatternPaperContrast : 0.0);
  }
  if (this->PatternTransition != AS_IN_STYLE)
  {
    layer->SetTransition(this->PatternTransition);
  }
  if (this->PatternToneCorrection != AS_IN_STYLE)
  {
    layer->SetToneCorrection(this->PatternToneCorrection);
  }
  if (this->PatternMotion != AS_IN_STYLE)
  {
    layer->SetMotion(this->PatternMotion);
    layer->SetSurfacePeriod(this->PatternSurfacePeriod);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustTone(vtkPatternLayer* layer)
{
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
  os << indent << "PatternDensities: " << this->PatternDensities << "\n";
  os << indent << "PatternPaperGrain: " << this->PatternPaperGrain << "\n";
  os << indent << "PatternPaperContrast: " << this->PatternPaperContrast << "\n";
  os << indent << "PatternTransition: " << this->PatternTransition << "\n";
  os << indent << "PatternToneCorrection: " << this->PatternToneCorrection << "\n";
  os << indent << "PatternMotion: " << this->PatternMotion << "\n";
  os << indent << "PatternSurfacePeriod: " << this->PatternSurfacePeriod << "\n";
  os << indent << "PatternLockRotation: " << this->PatternLockRotation << "\n";
  os << indent << "PatternLockScale: " << this->PatternLockScale << "\n";
  os << indent << "PatternWeights: " << this->PatternWeights << "\n";
  os << indent << "PatternFeatures: " << this->PatternFeatures << "\n";
  os << indent << "PatternFeatureArrayName: " << this->PatternFeatureArrayName << "\n";
  os << indent << "PatternVelocityArray: " << this->PatternVelocityArray << "\n";
  os << indent << "PatternPatches: " << this->PatternPatches << "\n";
  os << indent << "PatternPatchArrayName: " << this->PatternPatchArrayName << "\n";
  os << indent << "PatternNumberOfPatches: " << this->PatternNumberOfPatches << "\n";
  os << indent << "PatternCreaseAngle: " << this->PatternCreaseAngle << "\n";
  os << indent << "PatternPatchBlend: " << this->PatternPatchBlend << "\n";
}

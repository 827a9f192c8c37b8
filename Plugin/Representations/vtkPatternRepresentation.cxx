// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternRepresentation.h"

#include "PatternLegendPlace.h"
#include "RepresentationFile.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPatternLegendActor.h"
#include "vtkPatternMapper.h"
#include "vtkPatternPartMapper.h"
#include "vtkRepresentationPatches.h"
#include "vtkSurfacePatches.h"
#include "vtkWholeSurface.h"

vtkStandardNewMacro(vtkPatternRepresentation);

namespace
{
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
  : Loaded(vtkSmartPointer<vtkPatternStyle>::New())
  , LoadedFile(std::make_unique<RepresentationFile>())
  , PictureFile(std::make_unique<RepresentationFile>())
  , PatternStyle(vtkPatternStyle::GetDefaultPresetName())
{
  this->Mapper->Delete();
  this->LODMapper->Delete();
  auto* mapper = vtkPatternPartMapper::New();
  auto* mapperLOD = vtkPatternMapper::New();
  mapperLOD->SetTrackedMapper(mapper);
  mapperLOD->SetStyle(mapper->GetStyle());
  // The view gives the mapper another producer for every piece of data.
  mapper->SetInputOrigin(this->GeometryFilter);
  // The base class set these on the mapper that was replaced; selections need them.
  mapper->SetProcessIdArrayName("vtkProcessId");
  mapper->SetCompositeIdArrayName("vtkCompositeIndex");
  this->Mapper = mapper;
  this->LODMapper = mapperLOD;
  this->SetArrayIdNames(nullptr, nullptr);
  this->SetupDefaults();
  this->Patches = vtkSmartPointer<vtkRepresentationPatches>::New();
  this->Whole = vtkSmartPointer<vtkWholeSurface>::New();
  this->Whole->SetInputConnection(this->GeometryFilter->GetOutputPort());
  this->MultiBlockMaker->SetInputConnection(this->Whole->GetOutputPort());
  this->UpdatePatches();
  this->UpdateStyle();
  this->Legend = this->MakeLegend();
}

//------------------------------------------------------------------------------
vtkPatternRepresentation::~vtkPatternRepresentation() = default;

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
void vtkPatternRepresentation::SetPatternStyleSaveName(const char* fileName)
{
  this->PatternStyleSaveName = Text(fileName);
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternStyleSaveName()
{
  return this->PatternStyleSaveName.c_str();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SavePatternStyle()
{
  this->UpdateStyle();
  const std::string unsaved = this->GetUnsaved();
  if (this->PatternStyleSaveName.empty())
  {
    vtkErrorMacro("There is no name of a file that the style could be saved to.");
  }
  else if (!unsaved.empty())
  {
    vtkErrorMacro(
      "The style was not saved to \"" << this->PatternStyleSaveName << "\". " << unsaved);
  }
  else if (RepresentationFile::IsWriter())
  {
    this->GetStyle()->SaveFile(this->PatternStyleSaveName);
  }
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
void vtkPatternRepresentation::SetPatternImageFile(const char* fileName)
{
  this->Change(this->PatternImageFile, Text(fileName));
}

//------------------------------------------------------------------------------
const char* vtkPatternRepresentation::GetPatternImageFile()
{
  return this->PatternImageFile.c_str();
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
void vtkPatternRepresentation::SetPatternBackEnd(int backEnd)
{
  static_cast<vtkPatternMapper*>(this->Mapper)->SetNoiseBackEnd(backEnd);
  static_cast<vtkPatternMapper*>(this->LODMapper)->SetNoiseBackEnd(backEnd);
}

//------------------------------------------------------------------------------
int vtkPatternRepresentation::GetPatternBackEnd()
{
  return static_cast<vtkPatternMapper*>(this->Mapper)->GetNoiseBackEnd();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::Reanchor()
{
  static_cast<vtkPatternMapper*>(this->Mapper)->Reanchor();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::SetUpdateTime(double time)
{
  this->Superclass::SetUpdateTime(time);
  static_cast<vtkPatternMapper*>(this->Mapper)->SetAnimationTime(time);
  static_cast<vtkPatternMapper*>(this->LODMapper)->SetAnimationTime(time);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::UpdatePatches()
{
  this->Patches->SetMethod(MethodOf(this->PatternPatches));
  this->Patches->SetArrayName(this->PatternPatchArrayName);
  this->Patches->SetNumberOfPatches(this->PatternNumberOfPatches);
  this->Patches->SetNormalWeight(this->PatternNormalWeight);
  this->Patches->SetCreaseAngle(this->PatternCreaseAngle);
  this->Patches->SetJoinBlocks(this->PatternJoinBlocks != 0);
  this->Patches->SetWidthMode(this->PatternPatchBlendMode);
  this->Patches->SetRings(this->PatternPatchBlend);
  this->Patches->SetDistance(this->PatternPatchBlendDistance);
  this->Patches->SetInitial(this->PatternBorderWeights);
  this->Whole->SetFilter(this->PatternPatches > NONE ? this->Patches.Get() : nullptr);
  const char* const array = this->PatternPatches == NONE ? "" : "PatchId";
  static_cast<vtkPatternMapper*>(this->Mapper)->SetPatchArrayName(array);
  static_cast<vtkPatternMapper*>(this->LODMapper)->SetPatchArrayName(array);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::UpdateColoringParameters()
{
  this->Superclass::UpdateColoringParameters();
  this->UpdateStyle();
  this->Legend->Update();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::UpdateStyle()
{
  if (!this->StyleChanged)
  {
    return;
  }
  this->StyleChanged = false;
  this->LoadStyle();
  vtkNew<vtkPatternStyle> style;
  style->CopyFrom(this->Loaded);
  this->AdjustStyle(style);
  this->GetStyle()->CopyFrom(style);
}

//------------------------------------------------------------------------------
vtkPatternStyle* vtkPatternRepresentation::GetStyle()
{
  return static_cast<vtkPatternMapper*>(this->Mapper)->GetStyle();
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::LoadStyle()
{
  const std::string name = this->PatternStyleFile.empty() ? this->PatternStyle : std::string();
  const bool newFile = this->LoadedFile->IsNew(this->PatternStyleFile);
  if (newFile || name != this->LoadedName)
  {
    this->LoadedName = name; // also when it cannot be loaded: one error, not one per change
    vtkNew<vtkPatternStyle> style;
    const bool loaded =
      name.empty() ? style->LoadFile(this->PatternStyleFile) : style->LoadPreset(name);
    this->Loaded = loaded ? style.Get() : this->Loaded.Get();
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatternStyle: " << this->PatternStyle << "\n";
  os << indent << "PatternStyleFile: " << this->PatternStyleFile << "\n";
  os << indent << "PatternStyleSaveName: " << this->PatternStyleSaveName << "\n";
  os << indent << "PatternScale: " << this->PatternScale << "\n";
  os << indent << "PatternAngle: " << this->PatternAngle << "\n";
  os << indent << "PatternInk: " << this->PatternInk << "\n";
  os << indent << "PatternInkColor: " << this->PatternInkColor[0] << ", "
     << this->PatternInkColor[1] << ", " << this->PatternInkColor[2] << "\n";
  os << indent << "PatternInkOpacity: " << this->PatternInkOpacity << "\n";
  os << indent << "PatternBlendMode: " << this->PatternBlendMode << "\n";
  os << indent << "PatternPaper: " << this->PatternPaper << "\n";
  os << indent << "PatternPaperColor: " << this->PatternPaperColor[0] << ", "
     << this->PatternPaperColor[1] << ", " << this->PatternPaperColor[2] << "\n";
  os << indent << "PatternTone: " << this->PatternTone << "\n";
  os << indent << "PatternToneArrayName: " << this->PatternToneArrayName << "\n";
  os << indent << "PatternToneAssociation: " << this->PatternToneAssociation << "\n";
  os << indent << "PatternToneComponent: " << this->PatternToneComponent << "\n";
  os << indent << "PatternToneRange: " << this->PatternToneRange[0] << ", "
     << this->PatternToneRange[1] << "\n";
  os << indent << "PatternToneConstant: " << this->PatternToneConstant << "\n";
  os << indent << "PatternToneLight: " << this->PatternToneLight << "\n";
  os << indent << "PatternHighlightLight: " << this->PatternHighlightLight << "\n";
  os << indent << "PatternHighlightPower: " << this->PatternHighlightPower << "\n";
  os << indent << "PatternToneInvert: " << this->PatternToneInvert << "\n";
  os << indent << "PatternToneGamma: " << this->PatternToneGamma << "\n";
  os << indent << "PatternToneRemap: " << this->PatternToneRemap << "\n";
  os << indent << "PatternToneSteps: " << this->PatternToneSteps << "\n";
  os << indent << "PatternToneRemapRange: " << this->PatternToneRemapRange[0] << ", "
     << this->PatternToneRemapRange[1] << "\n";
  os << indent << "PatternBlackGeneration: " << this->PatternBlackGeneration << "\n";
  os << indent << "PatternToneCorrection: " << this->PatternToneCorrection << "\n";
  os << indent << "PatternKind: " << this->PatternKind << "\n";
  os << indent << "PatternImageFile: " << this->PatternImageFile << "\n";
  os << indent << "PatternIrregularity: " << this->PatternIrregularity << "\n";
  os << indent << "PatternDensities: " << this->PatternDensities << "\n";
  os << indent << "PatternBrush: " << this->PatternBrush << "\n";
  os << indent << "PatternDabLength: " << this->PatternDabLength << "\n";
  os << indent << "PatternDabJitter: " << this->PatternDabJitter << "\n";
  os << indent << "PatternDabDensity: " << this->PatternDabDensity << "\n";
  os << indent << "PatternBristles: " << this->PatternBristles << "\n";
  os << indent << "PatternBump: " << this->PatternBump << "\n";
  os << indent << "PatternColorVariation: " << this->PatternColorVariation << "\n";
  os << indent << "PatternPaperGrain: " << this->PatternPaperGrain << "\n";
  os << indent << "PatternPaperContrast: " << this->PatternPaperContrast << "\n";
  os << indent << "PatternPaperScale: " << this->PatternPaperScale << "\n";
  os << indent << "PatternSeed: " << this->PatternSeed << "\n";
  os << indent << "PatternOutline: " << this->PatternOutline << "\n";
  os << indent << "PatternOutlineWidth: " << this->PatternOutlineWidth << "\n";
  os << indent << "PatternOutlineSilhouette: " << this->PatternOutlineSilhouette << "\n";
  os << indent << "PatternOutlineCreases: " << this->PatternOutlineCreases << "\n";
  os << indent << "PatternOutlineBorders: " << this->PatternOutlineBorders << "\n";
  os << indent << "PatternOutlineCreaseAngle: " << this->PatternOutlineCreaseAngle << "\n";
  os << indent << "PatternOutlineInk: " << this->PatternOutlineInk << "\n";
  os << indent << "PatternOutlineColor: " << this->PatternOutlineColor[0] << ", "
     << this->PatternOutlineColor[1] << ", " << this->PatternOutlineColor[2] << "\n";
  os << indent << "PatternPatches: " << this->PatternPatches << "\n";
  os << indent << "PatternPatchArrayName: " << this->PatternPatchArrayName << "\n";
  os << indent << "PatternNumberOfPatches: " << this->PatternNumberOfPatches << "\n";
  os << indent << "PatternNormalWeight: " << this->PatternNormalWeight << "\n";
  os << indent << "PatternCreaseAngle: " << this->PatternCreaseAngle << "\n";
  os << indent << "PatternJoinBlocks: " << this->PatternJoinBlocks << "\n";
  os << indent << "PatternPatchBlendMode: " << this->PatternPatchBlendMode << "\n";
  os << indent << "PatternPatchBlend: " << this->PatternPatchBlend << "\n";
  os << indent << "PatternPatchPower: " << this->PatternPatchPower << "\n";
  os << indent << "PatternPatchBlendDistance: " << this->PatternPatchBlendDistance << "\n";
  os << indent << "PatternBorderWeights: " << this->PatternBorderWeights << "\n";
  os << indent << "PatternMotion: " << this->PatternMotion << "\n";
  os << indent << "PatternSurfacePeriod: " << this->PatternSurfacePeriod << "\n";
  os << indent << "PatternTracking: " << this->PatternTracking << "\n";
  os << indent << "PatternLockRotation: " << this->PatternLockRotation << "\n";
  os << indent << "PatternLockScale: " << this->PatternLockScale << "\n";
  os << indent << "PatternTransition: " << this->PatternTransition << "\n";
  os << indent << "PatternPace: " << this->PatternPace << "\n";
  os << indent << "PatternTransitionTime: " << this->PatternTransitionTime << "\n";
  os << indent << "PatternTransitionScales: " << this->PatternTransitionScales << "\n";
  os << indent << "PatternTransitionRange: " << this->PatternTransitionRange[0] << ", "
     << this->PatternTransitionRange[1] << "\n";
  os << indent << "PatternWeights: " << this->PatternWeights << "\n";
  os << indent << "PatternFeatures: " << this->PatternFeatures << "\n";
  os << indent << "PatternFeatureArrayName: " << this->PatternFeatureArrayName << "\n";
  os << indent << "PatternSamplesPerPatch: " << this->PatternSamplesPerPatch << "\n";
  os << indent << "PatternVelocityArray: " << this->PatternVelocityArray << "\n";
  os << indent << "PatternBackEnd: " << this->GetPatternBackEnd() << "\n";
  os << indent << "PatternLegend: " << this->GetPatternLegend() << "\n";
  this->GetLegend()->PrintSelf(os, indent.GetNextIndent());
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImagePatternLayer.h"

#include "PatternImageFile.h"
#include "PatternStyleArchive.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkImagePatternLayer);

//------------------------------------------------------------------------------
void vtkImagePatternLayer::SetImage(vtkImageData* image)
{
  if (this->Image != image)
  {
    this->Image = image;
    this->ImageFileName.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkImagePatternLayer::GetImage()
{
  return this->Image;
}

//------------------------------------------------------------------------------
bool vtkImagePatternLayer::ReadImage(const std::string& fileName)
{
  try
  {
    this->SetImage(hachure::readPatternImage(fileName));
    this->SetImageFileName(fileName.c_str());
    return true;
  }
  catch (const std::runtime_error& error)
  {
    vtkErrorMacro("ReadImage: " << error.what());
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkImagePatternLayer::SetImageFileName(const char* fileName)
{
  const std::string text = fileName ? fileName : "";
  if (text != this->ImageFileName)
  {
    this->ImageFileName = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkImagePatternLayer::GetImageFileName()
{
  return this->ImageFileName.c_str();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkImagePatternLayer::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Image ? std::max(time, this->Image->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkImagePatternLayer::DescribeField(hachure::StyleArchive& archive)
{
  using Self = vtkImagePatternLayer;
  archive.choice("pattern", this, &Self::GetPattern, &Self::SetPattern,
    { "hatch", "crossHatch", "halftone", "image", "stipple", "paint", "paper" });
  if (archive.imageFile("image", this->Image, this->ImageFileName))
  {
    this->Modified();
  }
  archive.length("size", this, &Self::GetSize, &Self::SetSize, &Self::GetSizeUnit,
    &Self::SetSizeUnit, { this->GetSizeMinValue(), this->GetSizeMaxValue() });
  archive.number("angle", this, &Self::GetAngle, &Self::SetAngle,
    { this->GetAngleMinValue(), this->GetAngleMaxValue() });
  archive.number("irregularity", this, &Self::GetIrregularity, &Self::SetIrregularity,
    { this->GetIrregularityMinValue(), this->GetIrregularityMaxValue() });
  archive.integer("densities", this, &Self::GetDensities, &Self::SetDensities,
    { double(this->GetDensitiesMinValue()), double(this->GetDensitiesMaxValue()) });
  archive.number("dabLength", this, &Self::GetDabLength, &Self::SetDabLength,
    { this->GetDabLengthMinValue(), this->GetDabLengthMaxValue() });
  archive.number("dabJitter", this, &Self::GetDabJitter, &Self::SetDabJitter,
    { this->GetDabJitterMinValue(), this->GetDabJitterMaxValue() });
  archive.number("dabDensity", this, &Self::GetDabDensity, &Self::SetDabDensity,
    { this->GetDabDensityMinValue(), this->GetDabDensityMaxValue() });
  archive.number("bristles", this, &Self::GetBristles, &Self::SetBristles,
    { this->GetBristlesMinValue(), this->GetBristlesMaxValue() });
  archive.number("bump", this, &Self::GetBump, &Self::SetBump,
    { this->GetBumpMinValue(), this->GetBumpMaxValue() });
  archive.number("colorVariation", this, &Self::GetColorVariation, &Self::SetColorVariation,
    { this->GetColorVariationMinValue(), this->GetColorVariationMaxValue() });
  archive.number("paperContrast", this, &Self::GetPaperContrast, &Self::SetPaperContrast,
    { this->GetPaperContrastMinValue(), this->GetPaperContrastMaxValue() });
  archive.length("paperSize", this, &Self::GetPaperSize, &Self::SetPaperSize,
    &Self::GetPaperSizeUnit, &Self::SetPaperSizeUnit,
    { this->GetPaperSizeMinValue(), this->GetPaperSizeMaxValue() });
  archive.choice("motion", this, &Self::GetMotion, &Self::SetMotion,
    { "similarity", "fixedInImage", "texture", "dynamicSolid" });
  archive.number("surfacePeriod", this, &Self::GetSurfacePeriod, &Self::SetSurfacePeriod,
    { this->GetSurfacePeriodMinValue(), this->GetSurfacePeriodMaxValue() });
  archive.number("lodStart", this, &Self::GetLodStart, &Self::SetLodStart,
    { this->GetLodStartMinValue(), this->GetLodStartMaxValue() });
  archive.number("lodEnd", this, &Self::GetLodEnd, &Self::SetLodEnd,
    { this->GetLodEndMinValue(), this->GetLodEndMaxValue() });
  archive.number("patchPower", this, &Self::GetPatchPower, &Self::SetPatchPower,
    { this->GetPatchPowerMinValue(), this->GetPatchPowerMaxValue() });
  archive.choice("transition", this, &Self::GetTransition, &Self::SetTransition,
    { "automatic", "crossFade", "blendScreens" });
  archive.choice("pace", this, &Self::GetPace, &Self::SetPace, { "even", "classic" });
  archive.number("transitionTime", this, &Self::GetTransitionTime, &Self::SetTransitionTime,
    { this->GetTransitionTimeMinValue(), this->GetTransitionTimeMaxValue() });
  archive.choice("toneCorrection", this, &Self::GetToneCorrection, &Self::SetToneCorrection,
    { "full", "transitionOnly", "off" });
}

//------------------------------------------------------------------------------
void vtkImagePatternLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent << "Image: " << this->Image.Get() << "\n";
  os << indent << "ImageFileName: " << this->ImageFileName << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "SizeUnit: " << this->SizeUnit << "\n";
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "Irregularity: " << this->Irregularity << "\n";
  os << indent << "Densities: " << this->Densities << "\n";
  os << indent << "DabLength: " << this->DabLength << "\n";
  os << indent << "DabJitter: " << this->DabJitter << "\n";
  os << indent << "DabDensity: " << this->DabDensity << "\n";
  os << indent << "Bristles: " << this->Bristles << "\n";
  os << indent << "Bump: " << this->Bump << "\n";
  os << indent << "ColorVariation: " << this->ColorVariation << "\n";
  os << indent << "PaperContrast: " << this->PaperContrast << "\n";
  os << indent << "PaperSize: " << this->PaperSize << "\n";
  os << indent << "PaperSizeUnit: " << this->PaperSizeUnit << "\n";
  os << indent << "Motion: " << this->Motion << "\n";
  os << indent << "SurfacePeriod: " << this->SurfacePeriod << "\n";
  os << indent << "LodStart: " << this->LodStart << "\n";
  os << indent << "LodEnd: " << this->LodEnd << "\n";
  os << indent << "PatchPower: " << this->PatchPower << "\n";
  os << indent << "Transition: " << this->Transition << "\n";
  os << indent << "Pace: " << this->Pace << "\n";
  os << indent << "TransitionTime: " << this->TransitionTime << "\n";
  os << indent << "ToneCorrection: " << this->ToneCorrection << "\n";
}

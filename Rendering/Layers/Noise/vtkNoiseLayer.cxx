// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseLayer.h"

#include "PatternImageFile.h"
#include "PatternStyleArchive.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkNoiseLayer);

namespace
{
constexpr hachure::NumberRange factors = { 0.25, 4.0 };

// Returns whether the text changed.
bool Change(std::string& text, const char* name)
{
  const std::string before = text;
  text = name ? name : "";
  return text != before;
}

bool Change(double (&pair)[2], double lowest, double highest)
{
  const double before[2] = { pair[0], pair[1] };
  pair[0] = std::clamp(lowest, factors.least, factors.greatest);
  pair[1] = std::clamp(highest, factors.least, factors.greatest);
  return pair[0] != before[0] || pair[1] != before[1];
}
} // namespace

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetDirectionArrayName(const char* name)
{
  if (Change(this->DirectionArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkNoiseLayer::GetDirectionArrayName()
{
  return this->DirectionArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetControlArrayName(const char* name)
{
  if (Change(this->ControlArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkNoiseLayer::GetControlArrayName()
{
  return this->ControlArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetSizeFactors(double lowest, double highest)
{
  if (Change(this->SizeFactors, lowest, highest))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetRegularityFactors(double lowest, double highest)
{
  if (Change(this->RegularityFactors, lowest, highest))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetImage(vtkImageData* image)
{
  if (this->Image != image)
  {
    this->Image = image;
    this->ImageFileName.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkNoiseLayer::GetImage()
{
  return this->Image;
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetThresholdImage(vtkImageData* image)
{
  if (this->ThresholdImage != image)
  {
    this->ThresholdImage = image;
    this->ThresholdImageFileName.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkNoiseLayer::GetThresholdImage()
{
  return this->ThresholdImage;
}

//------------------------------------------------------------------------------
bool vtkNoiseLayer::ReadThresholdImage(const std::string& fileName)
{
  try
  {
    this->SetThresholdImage(hachure::readPatternImage(fileName));
    this->SetThresholdImageFileName(fileName.c_str());
    return true;
  }
  catch (const std::runtime_error& error)
  {
    vtkErrorMacro("ReadThresholdImage: " << error.what());
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::SetThresholdImageFileName(const char* fileName)
{
  if (Change(this->ThresholdImageFileName, fileName))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkNoiseLayer::GetThresholdImageFileName()
{
  return this->ThresholdImageFileName.c_str();
}

//------------------------------------------------------------------------------
bool vtkNoiseLayer::ReadImage(const std::string& fileName)
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
void vtkNoiseLayer::SetImageFileName(const char* fileName)
{
  if (Change(this->ImageFileName, fileName))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkNoiseLayer::GetImageFileName()
{
  return this->ImageFileName.c_str();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNoiseLayer::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkImageData* image : { this->Image.Get(), this->ThresholdImage.Get() })
  {
    time = image ? std::max(time, image->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
// A kernel reaches one radius, and what may hide it lies as far around it.
double vtkNoiseLayer::GetReach(double dotsPerInch)
{
  constexpr double millimetresPerInch = 25.4;
  const double unit = this->SizeUnit == MILLIMETRES ? dotsPerInch / millimetresPerInch : 1.0;
  const double factor = this->Control == NO_CONTROL
    ? 1.0
    : std::max({ 1.0, this->SizeFactors[0] * this->RegularityFactors[0],
        this->SizeFactors[1] * this->RegularityFactors[1] });
  return 2.0 * factor * this->Regularity * this->Size * unit;
}

void vtkNoiseLayer::DescribeField(hachure::StyleArchive& archive)
{
  using Self = vtkNoiseLayer;
  archive.choice("kind", this, &Self::GetKind, &Self::SetKind, { "gabor", "phasor", "spot" });
  if (archive.imageFile("image", this->Image, this->ImageFileName))
  {
    this->Modified();
  }
  archive.length("size", this, &Self::GetSize, &Self::SetSize, &Self::GetSizeUnit,
    &Self::SetSizeUnit, { this->GetSizeMinValue(), this->GetSizeMaxValue() });
  archive.number("regularity", this, &Self::GetRegularity, &Self::SetRegularity,
    { this->GetRegularityMinValue(), this->GetRegularityMaxValue() });
  archive.number("angle", this, &Self::GetAngle, &Self::SetAngle,
    { this->GetAngleMinValue(), this->GetAngleMaxValue() });
  archive.number("spread", this, &Self::GetSpread, &Self::SetSpread,
    { this->GetSpreadMinValue(), this->GetSpreadMaxValue() });
  archive.text("directionArray", this, &Self::GetDirectionArrayName, &Self::SetDirectionArrayName);
  archive.choice(
    "control", this, &Self::GetControl, &Self::SetControl, { "none", "tone", "array" });
  archive.text("controlArray", this, &Self::GetControlArrayName, &Self::SetControlArrayName);
  archive.pair("controlRange", this, &Self::GetControlRange, &Self::SetControlRange);
  archive.pair("sizeFactors", this, &Self::GetSizeFactors, &Self::SetSizeFactors, factors);
  archive.pair(
    "regularityFactors", this, &Self::GetRegularityFactors, &Self::SetRegularityFactors, factors);
  archive.number("smoothness", this, &Self::GetSmoothness, &Self::SetSmoothness,
    { this->GetSmoothnessMinValue(), this->GetSmoothnessMaxValue() });
  if (archive.imageFile("thresholdImage", this->ThresholdImage, this->ThresholdImageFileName))
  {
    this->Modified();
  }
  archive.number("overlap", this, &Self::GetOverlap, &Self::SetOverlap,
    { this->GetOverlapMinValue(), this->GetOverlapMaxValue() });
  archive.number("fade", this, &Self::GetFade, &Self::SetFade,
    { this->GetFadeMinValue(), this->GetFadeMaxValue() });
  archive.integer("life", this, &Self::GetLife, &Self::SetLife,
    { double(this->GetLifeMinValue()), double(this->GetLifeMaxValue()) });
  archive.choice(
    "distribution", this, &Self::GetDistribution, &Self::SetDistribution, { "even", "classic" });
  archive.boolean("objectTest", this, &Self::GetObjectTest, &Self::SetObjectTest);
  archive.boolean("triangleTest", this, &Self::GetTriangleTest, &Self::SetTriangleTest);
  archive.boolean("depthTest", this, &Self::GetDepthTest, &Self::SetDepthTest);
  archive.boolean(
    "partialVisibility", this, &Self::GetPartialVisibility, &Self::SetPartialVisibility);
}

//------------------------------------------------------------------------------
void vtkNoiseLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->Kind << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "SizeUnit: " << this->SizeUnit << "\n";
  os << indent << "Regularity: " << this->Regularity << "\n";
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "Spread: " << this->Spread << "\n";
  os << indent << "DirectionArrayName: " << this->DirectionArrayName << "\n";
  os << indent << "Control: " << this->Control << "\n";
  os << indent << "ControlArrayName: " << this->ControlArrayName << "\n";
  os << indent << "ControlRange: " << this->ControlRange[0] << ", " << this->ControlRange[1]
     << "\n";
  os << indent << "SizeFactors: " << this->SizeFactors[0] << ", " << this->SizeFactors[1] << "\n";
  os << indent << "RegularityFactors: " << this->RegularityFactors[0] << ", "
     << this->RegularityFactors[1] << "\n";
  os << indent << "Smoothness: " << this->Smoothness << "\n";
  os << indent << "ThresholdImage: " << this->ThresholdImage.Get() << "\n";
  os << indent << "ThresholdImageFileName: " << this->ThresholdImageFileName << "\n";
  os << indent << "Overlap: " << this->Overlap << "\n";
  os << indent << "Fade: " << this->Fade << "\n";
  os << indent << "Life: " << this->Life << "\n";
  os << indent << "Distribution: " << this->Distribution << "\n";
  os << indent << "ObjectTest: " << this->ObjectTest << "\n";
  os << indent << "TriangleTest: " << this->TriangleTest << "\n";
  os << indent << "DepthTest: " << this->DepthTest << "\n";
  os << indent << "PartialVisibility: " << this->PartialVisibility << "\n";
  os << indent << "Image: " << this->Image.Get() << "\n";
  os << indent << "ImageFileName: " << this->ImageFileName << "\n";
}

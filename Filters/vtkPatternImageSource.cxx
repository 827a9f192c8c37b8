// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternImageSource.h"

#include "Core/PaintTile.h"
#include "Core/PaperTile.h"
#include "PatternTileImage.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPatternImageSource);

namespace
{

// Pictures with fewer distinct values show steps where the tone changes slowly.
constexpr int fewLevels = 16;

// Grey of every texel: the first component, or the luma (Rec. 709) of three.
std::vector<float> greyValues(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  const vtkIdType texels = array->GetNumberOfTuples();
  std::vector<float> grey(static_cast<std::size_t>(texels));
  for (vtkIdType i = 0; i < texels; ++i)
  {
    const double first = array->GetComponent(i, 0);
    grey[i] = static_cast<float>(components < 3
        ? first
        : 0.2126 * first + 0.7152 * array->GetComponent(i, 1) + 0.0722 * array->GetComponent(i, 2));
  }
  return grey;
}

hachure::PatternTile pictureTile(vtkImageData* picture, vtkDataArray* array, int periods)
{
  if (!picture)
  {
    throw std::invalid_argument("Pattern is IMAGE, but no image is connected to the input.");
  }
  int dimensions[3];
  picture->GetDimensions(dimensions);
  if (picture->GetNumberOfPoints() < 1)
  {
    throw std::invalid_argument("The input image is empty.");
  }
  if (dimensions[2] != 1)
  {
    throw std::invalid_argument(
      "The input image has " + std::to_string(dimensions[2]) + " slices along z, expected one.");
  }
  if (!array)
  {
    throw std::invalid_argument("The input image has no numeric point scalars.");
  }
  const std::string name = array->GetName() ? array->GetName() : "";
  if (array->GetNumberOfComponents() < 1 || array->GetNumberOfComponents() > 4)
  {
    throw std::invalid_argument("Input array '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()) + " components, expected 1 to 4.");
  }
  try
  {
    return hachure::imageTile(greyValues(array), dimensions[0], dimensions[1], periods);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument("Input array '" + name + "': " + error.what());
  }
}

} // namespace

vtkPatternImageSource::vtkPatternImageSource()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkPatternImageSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkPatternImageSource::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int extent[6] = { 0, this->Size - 1, 0, this->Size - 1, 0, 0 };
  vtkInformation* inputInformation = inputVector[0]->GetInformationObject(0);
  if (this->Pattern == IMAGE && inputInformation)
  {
    int whole[6] = { 0, -1, 0, -1, 0, -1 };
    inputInformation->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    extent[1] = whole[1] - whole[0];
    extent[3] = whole[3] - whole[2];
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkPatternImageSource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Ranks need all texels, whatever part of the output is asked for.
  if (vtkInformation* information = inputVector[0]->GetInformationObject(0))
  {
    int whole[6] = { 0, -1, 0, -1, 0, -1 };
    information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  }
  return 1;
}

void vtkPatternImageSource::DrawStrokesOrDots(vtkImageData* output)
{
  hachure::CrossHatchOptions options;
  options.size = this->Size;
  options.periods = this->Periods;
  options.irregularity = this->Irregularity;
  options.seed = this->Seed;
  options.densities = this->Densities;
  options.crossingAngle = this->CrossingAngle;
  options.delay = this->CrossingDelay;
  const hachure::PatternTile tile = this->Pattern == CROSS_HATCH ? hachure::crossHatchTile(options)
    : this->Pattern == HALFTONE                                  ? hachure::halftoneTile(options)
    : this->Pattern == STIPPLE                                   ? hachure::stippleTile(options)
                                                                 : hachure::hatchTile(options);
  this->NumberOfLevels = tile.levels;
  hachure::writeTile(tile, output);
}

void vtkPatternImageSource::DrawPaint(vtkImageData* output)
{
  hachure::PaintOptions options;
  options.size = this->Size;
  options.periods = this->Periods;
  options.seed = this->Seed;
  options.density = this->DabDensity;
  options.aspect = this->DabAspect;
  options.angleJitter = this->DabAngleJitter;
  options.sizeVariation = this->DabSizeVariation;
  options.bristles = this->Bristles;
  const hachure::PaintTile tile = hachure::paintTile(options);
  this->NumberOfLevels = tile.pattern.levels;
  hachure::writePaint(tile, output);
}

void vtkPatternImageSource::DrawPaper(vtkImageData* output)
{
  hachure::PaperOptions options;
  options.size = this->Size;
  options.periods = this->Periods;
  options.seed = this->Seed;
  options.grain = this->Grain;
  options.fibres = this->Fibres;
  options.laid = this->Laid;
  options.weave = this->Weave;
  const hachure::PatternTile tile = hachure::paperTile(options);
  this->NumberOfLevels = tile.levels;
  hachure::writeTile(tile, output);
}

void vtkPatternImageSource::Draw(vtkInformationVector** inputVector, vtkImageData* output)
{
  if (this->Pattern == IMAGE)
  {
    vtkImageData* picture = vtkImageData::GetData(inputVector[0]);
    vtkDataArray* array = picture ? this->GetInputArrayToProcess(0, inputVector) : nullptr;
    const hachure::PatternTile tile = pictureTile(picture, array, this->Periods);
    this->NumberOfLevels = tile.levels;
    hachure::writeTile(tile, output);
  }
  else if (this->Pattern == PAINT)
  {
    this->DrawPaint(output);
  }
  else if (this->Pattern == PAPER)
  {
    this->DrawPaper(output);
  }
  else
  {
    this->DrawStrokesOrDots(output);
  }
}

int vtkPatternImageSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  try
  {
    this->Draw(inputVector, output);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    this->NumberOfLevels = 0;
    vtkErrorMacro(<< error.what());
    return 0;
  }
  if (this->Pattern == IMAGE && this->NumberOfLevels < fewLevels)
  {
    vtkWarningMacro(<< "The input image has only " << this->NumberOfLevels
                    << " distinct values; tones between them come out as flat grey. " << fewLevels
                    << " or more draw well.");
  }
  return 1;
}

void vtkPatternImageSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "Periods: " << this->Periods << "\n";
  os << indent << "Irregularity: " << this->Irregularity << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "CrossingAngle: " << this->CrossingAngle << "\n";
  os << indent << "CrossingDelay: " << this->CrossingDelay << "\n";
  os << indent << "Densities: " << this->Densities << "\n";
  os << indent << "DabDensity: " << this->DabDensity << "\n";
  os << indent << "DabAspect: " << this->DabAspect << "\n";
  os << indent << "DabAngleJitter: " << this->DabAngleJitter << "\n";
  os << indent << "DabSizeVariation: " << this->DabSizeVariation << "\n";
  os << indent << "Bristles: " << this->Bristles << "\n";
  os << indent << "Grain: " << this->Grain << "\n";
  os << indent << "Fibres: " << this->Fibres << "\n";
  os << indent << "Laid: " << this->Laid << "\n";
  os << indent << "Weave: " << this->Weave << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToneCorrectionTable.h"

#include "Core/Kernels.h"
#include "Core/ToneTable.h"
#include "PatternTileImage.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkToneCorrectionTable);

static_assert(vtkToneCorrectionTable::NO_TRANSITION == int(hachure::LodTransition::none) &&
    vtkToneCorrectionTable::BLEND_SCREENS == int(hachure::LodTransition::blendScreens) &&
    vtkToneCorrectionTable::EVEN == int(hachure::LodPace::even) &&
    vtkToneCorrectionTable::CLASSIC == int(hachure::LodPace::classic) &&
    vtkToneCorrectionTable::TRANSITION_ONLY == int(hachure::ToneCorrection::transitionOnly) &&
    vtkToneCorrectionTable::NO_CORRECTION == int(hachure::ToneCorrection::off),
  "the same order on both sides");

namespace
{

void addNumber(vtkImageData* image, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  image->GetFieldData()->AddArray(array);
}

void writeTable(const hachure::ToneTable& table, vtkImageData* image)
{
  image->Initialize();
  image->SetDimensions(table.tones, table.steps, 1);
  vtkNew<vtkFloatArray> threshold;
  threshold->SetName("Threshold");
  threshold->SetNumberOfTuples(static_cast<vtkIdType>(table.threshold.size()));
  std::copy(table.threshold.begin(), table.threshold.end(), threshold->GetPointer(0));
  image->GetPointData()->SetScalars(threshold);
  addNumber(image, "TexelsPerPixel", table.options.texelsPerPixelAtScale1);
  addNumber(image, "LodStart", table.options.lodStart);
  addNumber(image, "LodEnd", table.options.lodEnd);
}

} // namespace

int vtkToneCorrectionTable::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int tones = hachure::ToneTable().tones;
  const int steps = hachure::tableRows(static_cast<hachure::LodTransition>(this->Transition));
  const int extent[6] = { 0, tones - 1, 0, steps - 1, 0, 0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkToneCorrectionTable::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Every threshold depends on all texels.
  vtkInformation* information = inputVector[0]->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

int vtkToneCorrectionTable::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  try
  {
    bool periodsKnown = false;
    const hachure::PatternTile tile =
      hachure::readTile(vtkImageData::GetData(inputVector[0]), periodsKnown);
    if (!periodsKnown)
    {
      vtkWarningMacro(
        "The input image has no field array 'Periods' of at least 1; one period across "
        "its width is assumed.");
    }
    hachure::ToneTableOptions options;
    options.texelsPerPixelAtScale1 = tile.width / (tile.periods * this->PeriodInPixels);
    options.fixedLevel =
      hachure::glsl::fixedTileLevel(static_cast<float>(options.texelsPerPixelAtScale1));
    options.lodStart = this->LodStart;
    options.lodEnd = this->LodEnd;
    options.transition = static_cast<hachure::LodTransition>(this->Transition);
    options.pace = static_cast<hachure::LodPace>(this->Pace);
    options.correction = static_cast<hachure::ToneCorrection>(this->ToneCorrection);
    writeTable(hachure::buildToneTable(hachure::mipChain(tile), options), output);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkToneCorrectionTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PeriodInPixels: " << this->PeriodInPixels << "\n";
  os << indent << "LodStart: " << this->LodStart << "\n";
  os << indent << "LodEnd: " << this->LodEnd << "\n";
  os << indent << "Transition: " << this->Transition << "\n";
  os << indent << "Pace: " << this->Pace << "\n";
  os << indent << "ToneCorrection: " << this->ToneCorrection << "\n";
}

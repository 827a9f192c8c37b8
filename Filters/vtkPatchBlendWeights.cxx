// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatchBlendWeights.h"

#include "Core/PatchBlendWeights.h"
#include "SurfacePatchesInput.h"

#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkPatchBlendWeights);

namespace
{
template <class ArrayType>
ArrayType* addArray(vtkPolyData* block, const char* name)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(hachure::maximumBlendPatches);
  array->SetNumberOfTuples(block->GetNumberOfPoints());
  block->GetPointData()->AddArray(array);
  return array;
}

/// The blends of all points, block after block.
void attachBlends(vtkDataObject* output, const std::vector<hachure::PatchBlend>& blends)
{
  std::size_t next = 0;
  for (vtkPolyData* block : hachure::polyDataBlocks(output))
  {
    auto* patches = addArray<vtkIntArray>(block, "BlendPatches");
    auto* weights = addArray<vtkFloatArray>(block, "BlendWeights");
    for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
    {
      const hachure::PatchBlend& blend = blends[next++];
      patches->SetTypedTuple(point, blend.patches.data());
      weights->SetTypedTuple(point, blend.weights.data());
    }
  }
}
} // namespace

vtkPatchBlendWeights::vtkPatchBlendWeights() = default;

int vtkPatchBlendWeights::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkPatchBlendWeights::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  hachure::BlendOptions options;
  options.width = static_cast<hachure::BlendWidth>(this->WidthMode);
  options.rings = this->Rings;
  options.distance = this->Distance;
  options.start = static_cast<hachure::BlendStart>(this->Initial);
  options.progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !this->GetAbortExecute();
  };
  try
  {
    if (this->PatchArrayName.empty())
    {
      throw std::invalid_argument("PatchArrayName is empty; expected the name of a cell array");
    }
    const hachure::PatchSurface surface = hachure::readPatchSurface(
      input, { this->PatchArrayName, false }, this->JoinBlocks, hachure::StripFaces::Triangles);
    const std::vector<hachure::PatchBlend> blends =
      hachure::patchBlendWeights(surface.surface(), options);
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
    hachure::copyBlocks(input, output);
    attachBlends(output, blends);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkPatchBlendWeights::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WidthMode: " << this->WidthMode << "\n";
  os << indent << "Rings: " << this->Rings << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "Initial: " << this->Initial << "\n";
  os << indent << "PatchArrayName: " << this->PatchArrayName << "\n";
  os << indent << "JoinBlocks: " << (this->JoinBlocks ? "on" : "off") << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRepresentationPatches.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPatchBlendWeights.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfacePatches.h"

vtkStandardNewMacro(vtkRepresentationPatches);

namespace
{
// Calls the function with every vtkPolyData of a surface.
template <class Function>
void ForEachBlock(vtkDataObject* surface, const Function& function)
{
  if (auto* block = vtkPolyData::SafeDownCast(surface))
  {
    function(block);
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(surface);
  if (!composite)
  {
    return;
  }
  const auto position = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (position->InitTraversal(); !position->IsDoneWithTraversal(); position->GoToNextItem())
  {
    if (auto* block = vtkPolyData::SafeDownCast(position->GetCurrentDataObject()))
    {
      function(block);
    }
  }
}

bool HasCells(vtkDataObject* surface)
{
  vtkIdType cells = 0;
  ForEachBlock(surface, [&cells](vtkPolyData* block) { cells += block->GetNumberOfCells(); });
  return cells > 0;
}

// What the input was blended by belongs to other patches.
void RemoveBlending(vtkDataObject* surface)
{
  ForEachBlock(surface,
    [](vtkPolyData* block)
    {
      block->GetPointData()->RemoveArray("BlendPatches");
      block->GetPointData()->RemoveArray("BlendWeights");
    });
}

// Runs a filter; false, after its error, when it failed.
bool Run(vtkAlgorithm* filter)
{
  return filter->GetExecutive()->Update() != 0;
}
} // namespace

//------------------------------------------------------------------------------
int vtkRepresentationPatches::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRepresentationPatches::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  output->ShallowCopy(input);
  if (!HasCells(input))
  {
    return 1;
  }
  vtkNew<vtkSurfacePatches> patches;
  patches->SetMethod(this->Method);
  patches->SetArrayName(this->ArrayName);
  patches->SetNumberOfPatches(this->NumberOfPatches);
  patches->SetNormalWeight(this->NormalWeight);
  patches->SetCreaseAngle(this->CreaseAngle);
  patches->SetJoinBlocks(this->JoinBlocks);
  patches->SetInputDataObject(input);
  vtkNew<vtkPatchBlendWeights> weights;
  weights->SetWidthMode(this->WidthMode);
  weights->SetRings(this->Rings);
  weights->SetDistance(this->Distance);
  weights->SetInitial(this->Initial);
  weights->SetJoinBlocks(this->JoinBlocks);
  weights->SetInputConnection(patches->GetOutputPort());
  vtkAlgorithm* last = patches;
  const bool blend =
    this->WidthMode == vtkPatchBlendWeights::RINGS ? this->Rings > 0 : this->Distance > 0.0;
  if (blend)
  {
    last = weights;
  }
  if (Run(last))
  {
    output->ShallowCopy(last->GetOutputDataObject(0));
    if (!blend)
    {
      RemoveBlending(output);
    }
  }
  return 1;
}

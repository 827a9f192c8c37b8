// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfacePatches.h"

#include "CameraView.h"
#include "Core/SurfacePatchesSlide.h"
#include "SurfacePatchesInput.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkSurfacePatches);

namespace
{
using hachure::PatchSurface;

std::vector<std::int32_t> rank(const std::vector<std::int64_t>& labels)
{
  std::vector<std::int32_t> patches;
  hachure::rankPatches(labels, patches);
  return patches;
}

std::vector<std::int64_t> blockLabels(const PatchSurface& surface)
{
  std::vector<std::int64_t> labels;
  for (const PatchSurface::FaceCell& cell : surface.cells)
  {
    labels.push_back(cell.block);
  }
  return labels;
}

/// PatchId of all blocks.
void attachPatches(
  vtkDataObject* output, const PatchSurface& surface, const std::vector<std::int32_t>& patches)
{
  std::vector<vtkIntArray*> arrays;
  for (vtkPolyData* block : hachure::polyDataBlocks(output))
  {
    vtkNew<vtkIntArray> array;
    array->SetName("PatchId");
    array->SetNumberOfTuples(block->GetNumberOfCells());
    array->FillValue(-1);
    block->GetCellData()->AddArray(array);
    arrays.push_back(array);
  }
  for (std::size_t face = 0; face < patches.size(); ++face)
  {
    const PatchSurface::FaceCell& cell = surface.cells[face];
    arrays[cell.block]->SetValue(cell.cell, patches[face]);
  }
}

void attachSlides(vtkDataObject* output, const std::vector<double>& slides)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("PatchSlide");
  array->SetNumberOfValues(static_cast<vtkIdType>(slides.size()));
  std::copy(slides.begin(), slides.end(), array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}

/// A check that an input of the method is there.
void require(bool given, const char* what)
{
  if (!given)
  {
    throw std::invalid_argument(what);
  }
}
} // namespace

vtkSurfacePatches::vtkSurfacePatches()
{
  this->SetNumberOfInputPorts(2);
}

vtkSurfacePatches::~vtkSurfacePatches() = default;

void vtkSurfacePatches::AddCamera(vtkCamera* camera)
{
  if (!camera)
  {
    vtkErrorMacro("AddCamera: no camera given; the path stays as it is.");
    return;
  }
  auto copy = vtkSmartPointer<vtkCamera>::New();
  copy->DeepCopy(camera);
  this->Cameras.push_back(std::move(copy));
  this->Modified();
}

void vtkSurfacePatches::RemoveAllCameras()
{
  if (!this->Cameras.empty())
  {
    this->Cameras.clear();
    this->Modified();
  }
}

int vtkSurfacePatches::GetNumberOfCameras()
{
  return static_cast<int>(this->Cameras.size());
}

vtkCamera* vtkSurfacePatches::GetCamera(int index)
{
  const bool exists = index >= 0 && index < this->GetNumberOfCameras();
  return exists ? this->Cameras[static_cast<std::size_t>(index)].Get() : nullptr;
}

void vtkSurfacePatches::SetViewportSize(double width, double height)
{
  const double clamped[2] = { std::max(1.0, width), std::max(1.0, height) };
  if (this->ViewportSize[0] != clamped[0] || this->ViewportSize[1] != clamped[1])
  {
    std::copy(clamped, clamped + 2, this->ViewportSize);
    this->Modified();
  }
}

int vtkSurfacePatches::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSurfacePatches::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkSelection* selection = vtkSelection::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);

  hachure::SlideOptions slide;
  slide.maximumSlide = this->MaximumSlide > 0.0 ? this->MaximumSlide : 1.0;
  slide.maximumPatches = this->MaximumNumberOfPatches;
  slide.compact.patches = this->NumberOfPatches;
  slide.compact.normalWeight = this->NormalWeight;
  slide.compact.progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !this->GetAbortExecute();
  };
  const bool splits = this->Method == AUTOMATIC && this->MaximumSlide > 0.0;
  std::vector<hachure::ViewProjection> views;
  for (vtkCamera* camera : this->Cameras)
  {
    views.push_back(hachure::cameraView(camera, this->ViewportSize));
  }
  try
  {
    require(this->Method != ARRAY || !this->ArrayName.empty(),
      "ArrayName is empty; expected the name of a cell or point array");
    require(this->Method != SELECTION || selection,
      "There is no selection on port 1; expected a vtkSelection");
    require(!splits || views.size() >= 2,
      "MaximumSlide needs a camera path; expected two or more cameras: AddCamera");

    const PatchSurface read = hachure::readPatchSurface(
      input, hachure::PatchSource(), this->JoinBlocks, hachure::StripFaces::Whole);
    const hachure::FaceSurface surface = read.surface();
    std::vector<std::int32_t> patches;
    switch (this->Method)
    {
      case ARRAY:
        patches = rank(hachure::labelsFromArray(read, input, this->ArrayName));
        break;
      case SELECTION:
        patches = rank(hachure::labelsFromSelection(read, input, selection));
        break;
      case CONNECTED:
        patches = hachure::connectedPatches(surface);
        break;
      case BLOCK:
        patches = rank(blockLabels(read));
        break;
      case CREASE:
        patches = hachure::creasePatches(surface, this->CreaseAngle);
        break;
      default:
        patches = hachure::compactPatches(surface, slide.compact);
    }
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
    hachure::copyBlocks(input, output);
    if (views.size() >= 2)
    {
      hachure::SlideSplit result;
      if (splits)
      {
        result = hachure::splitSlidingPatches(surface, patches, views, slide);
        patches = result.patches;
      }
      else
      {
        result.slides = hachure::predictSlides(surface, patches, views, slide);
      }
      if (splits && !result.slides.empty() &&
        *std::max_element(result.slides.begin(), result.slides.end()) > this->MaximumSlide)
      {
        vtkWarningMacro("With " << result.slides.size() << " patches some still slide more than "
                                << this->MaximumSlide << " pixels per frame, see PatchSlide.");
      }
      attachSlides(output, result.slides);
    }
    attachPatches(output, read, patches);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSurfacePatches::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "CreaseAngle: " << this->CreaseAngle << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "NormalWeight: " << this->NormalWeight << "\n";
  os << indent << "JoinBlocks: " << (this->JoinBlocks ? "on" : "off") << "\n";
  os << indent << "Cameras: " << this->Cameras.size() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
  os << indent << "MaximumSlide: " << this->MaximumSlide << "\n";
  os << indent << "MaximumNumberOfPatches: " << this->MaximumNumberOfPatches << "\n";
}

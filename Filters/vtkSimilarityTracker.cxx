// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimilarityTracker.h"

#include "CameraView.h"
#include "Core/PatchFit.h"
#include "SimilaritySamples.h"

#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkSimilarityTracker);

namespace
{
hachure::ProjectedSamples project(const hachure::TrackedSampleSet& samples,
  const hachure::SampleGeometry& geometry, vtkCamera* camera, const double size[2])
{
  return hachure::projectSamples(
    { geometry.positions, geometry.normals, samples.patches, samples.spacing },
    hachure::cameraView(camera, size), hachure::FacingRule::FrontOnly);
}

void fillTable(vtkTable* table, const std::vector<int>& patchIds,
  const hachure::PatternFrame& anchor, const std::vector<hachure::SimilarityFit>& fits,
  const std::vector<hachure::PatchResidual>& residuals)
{
  const auto rows = static_cast<vtkIdType>(patchIds.size());
  vtkNew<vtkIntArray> ids;
  ids->SetName("PatchId");
  ids->SetNumberOfTuples(rows);
  table->AddColumn(ids);
  const char* names[] = { "OriginX", "OriginY", "UX", "UY", "VX", "VY", "ZReal", "ZImaginary",
    "Scale", "AngleDegrees", "WeightSum", "Residual" };
  std::vector<vtkDoubleArray*> columns;
  for (const char* name : names)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->SetNumberOfTuples(rows);
    table->AddColumn(column);
    columns.push_back(column);
  }
  vtkNew<vtkStringArray> status;
  status->SetName("Status");
  status->SetNumberOfTuples(rows);
  table->AddColumn(status);

  for (vtkIdType row = 0; row < rows; ++row)
  {
    const hachure::SimilarityFit& fit = fits[static_cast<std::size_t>(row)];
    const hachure::PatternFrame frame = hachure::advance(anchor, fit.transform);
    const hachure::Similarity& step = fit.transform;
    const double values[] = { frame.origin.x, frame.origin.y, frame.u.x, frame.u.y, frame.v.x,
      frame.v.y, step.z.x, step.z.y, step.scale(), step.angleDegrees(), fit.weight,
      residuals[static_cast<std::size_t>(row)].residual };
    ids->SetValue(row, patchIds[static_cast<std::size_t>(row)]);
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
      columns[k]->SetValue(row, values[k]);
    }
    status->SetValue(row, hachure::fitStatusName(fit.status));
  }
}
} // namespace

vtkSimilarityTracker::vtkSimilarityTracker()
{
  this->SetNumberOfInputPorts(3);
}

vtkSimilarityTracker::~vtkSimilarityTracker() = default;

void vtkSimilarityTracker::SetCameraBefore(vtkCamera* camera)
{
  if (this->CameraBefore != camera)
  {
    this->CameraBefore = camera;
    this->Modified();
  }
}

vtkCamera* vtkSimilarityTracker::GetCameraBefore()
{
  return this->CameraBefore;
}

void vtkSimilarityTracker::SetCameraAfter(vtkCamera* camera)
{
  if (this->CameraAfter != camera)
  {
    this->CameraAfter = camera;
    this->Modified();
  }
}

vtkCamera* vtkSimilarityTracker::GetCameraAfter()
{
  return this->CameraAfter;
}

void vtkSimilarityTracker::SetViewportSize(double width, double height)
{
  const double clamped[2] = { std::max(1.0, width), std::max(1.0, height) };
  if (this->ViewportSize[0] != clamped[0] || this->ViewportSize[1] != clamped[1])
  {
    std::copy(clamped, clamped + 2, this->ViewportSize);
    this->Modified();
  }
}

vtkMTimeType vtkSimilarityTracker::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkCamera* camera : { this->CameraBefore.Get(), this->CameraAfter.Get() })
  {
    time = std::max(time, camera != nullptr ? camera->GetMTime() : 0);
  }
  return time;
}

int vtkSimilarityTracker::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSimilarityTracker::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* before = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* after = vtkPolyData::GetData(inputVector[2]);
  if (this->CameraBefore == nullptr || this->CameraAfter == nullptr)
  {
    vtkErrorMacro("No camera " << (this->CameraBefore == nullptr ? "before" : "after")
                               << ", expected two cameras: SetCameraBefore and SetCameraAfter.");
    return 0;
  }
  try
  {
    const hachure::TrackedSampleSet samples =
      hachure::readSamples(input, before != nullptr || after != nullptr);
    hachure::SampleGeometry geometryBefore, geometryAfter;
    hachure::placeSamples(samples, before, after, geometryBefore, geometryAfter);
    const auto samplesBefore =
      project(samples, geometryBefore, this->CameraBefore, this->ViewportSize);
    const auto samplesAfter =
      project(samples, geometryAfter, this->CameraAfter, this->ViewportSize);

    const auto scheme = static_cast<hachure::WeightScheme>(this->WeightScheme);
    const std::vector<double> weightsBefore = hachure::facingWeights(samplesBefore, scheme);
    const std::vector<double> weightsAfter = hachure::facingWeights(samplesAfter, scheme);
    const hachure::WeightedFrame frameBefore{ samplesBefore, weightsBefore };
    const hachure::WeightedFrame frameAfter{ samplesAfter, weightsAfter };
    const hachure::PatchRuns patches =
      hachure::findPatchRuns(samples.patches, samplesBefore.size(), samples.patchIds.size());
    const std::vector<hachure::SimilarityFit> fits =
      hachure::fitPatches(frameBefore, frameAfter, patches, scheme).fits;
    fillTable(vtkTable::GetData(outputVector), samples.patchIds,
      hachure::anchorPattern(samplesBefore), fits,
      hachure::measureResiduals(fits, frameBefore, frameAfter, patches, scheme));
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSimilarityTracker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CameraBefore: " << this->CameraBefore.Get() << "\n";
  os << indent << "CameraAfter: " << this->CameraAfter.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
  os << indent << "WeightScheme: " << this->WeightScheme << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimilarityTracker.h"

#include "Core/PatchFit.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSimilarityTracker);

namespace
{
using Corners = std::array<vtkIdType, 3>;

// The samples as the input has them, patches numbered by row of the output.
struct SampleSet
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<std::int32_t> patches;
  std::vector<int> patchIds;   // per row
  std::vector<double> spacing; // per row
  // Only with meshes.
  std::vector<Corners> corners;
  std::vector<glm::dvec3> barycentrics;
};

// Positions and normals of the samples in one frame.
struct Geometry
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
};

std::string quoted(const char* name)
{
  return "'" + std::string(name) + "'";
}

// The samples' array of that name, or an error that says what was expected.
vtkDataArray* requireArray(
  vtkFieldData* data, const char* where, const char* name, int components, bool integers)
{
  vtkDataArray* array = data->GetArray(name);
  const std::string expected = std::string(integers ? "integers" : "numbers") + " with " +
    std::to_string(components) + (components == 1 ? " component" : " components");
  if (array == nullptr)
  {
    throw std::invalid_argument("Samples: no " + std::string(where) + " array " + quoted(name) +
      ", expected " + expected + " as from vtkStratifiedSurfaceSampler");
  }
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  if (array->GetNumberOfComponents() != components || (integers && isReal))
  {
    throw std::invalid_argument("Samples: array " + quoted(name) + " has " +
      array->GetDataTypeAsString() + " with " + std::to_string(array->GetNumberOfComponents()) +
      " components, expected " + expected);
  }
  return array;
}

std::vector<glm::dvec3> readVectors(vtkDataArray* array)
{
  std::vector<glm::dvec3> result(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), &result[i].x);
  }
  return result;
}

void readPatches(vtkPolyData* input, SampleSet& samples)
{
  std::vector<int> ids(samples.positions.size(), 0);
  if (input->GetPointData()->HasArray("PatchId"))
  {
    vtkDataArray* array = requireArray(input->GetPointData(), "point", "PatchId", 1, true);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      ids[i] = static_cast<int>(array->GetComponent(static_cast<vtkIdType>(i), 0));
    }
  }
  samples.patchIds = ids;
  std::sort(samples.patchIds.begin(), samples.patchIds.end());
  samples.patchIds.erase(
    std::unique(samples.patchIds.begin(), samples.patchIds.end()), samples.patchIds.end());

  vtkDataArray* spacing = requireArray(input->GetFieldData(), "field", "PatchSpacing", 1, false);
  std::map<int, std::int32_t> rows;
  for (const int id : samples.patchIds)
  {
    if (id < 0 || id >= spacing->GetNumberOfTuples())
    {
      throw std::invalid_argument("Samples: PatchId " + std::to_string(id) + ", expected 0 to " +
        std::to_string(spacing->GetNumberOfTuples()) + " - 1, the size of 'PatchSpacing'");
    }
    rows.emplace(id, static_cast<std::int32_t>(rows.size()));
    samples.spacing.push_back(spacing->GetComponent(id, 0));
  }
  for (const int id : ids)
  {
    samples.patches.push_back(rows[id]);
  }
}

void readCorners(vtkPolyData* input, SampleSet& samples)
{
  vtkDataArray* ids = requireArray(input->GetPointData(), "point", "PointIds", 3, true);
  samples.barycentrics =
    readVectors(requireArray(input->GetPointData(), "point", "Barycentrics", 3, false));
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    Corners corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[static_cast<std::size_t>(k)] = static_cast<vtkIdType>(ids->GetComponent(i, k));
    }
    samples.corners.push_back(corners);
  }
  vtkDataArray* blocks = input->GetPointData()->GetArray("BlockIndex");
  if (blocks != nullptr && blocks->GetNumberOfTuples() > 0 &&
    blocks->GetFiniteRange(0)[0] != blocks->GetFiniteRange(0)[1])
  {
    throw std::invalid_argument(
      "Samples: array 'BlockIndex' names several blocks, expected samples "
      "of the one mesh that is given");
  }
}

SampleSet readSamples(vtkPolyData* input, bool withCorners)
{
  SampleSet samples;
  if (input->GetNumberOfPoints() == 0)
  {
    return samples;
  }
  samples.positions = readVectors(input->GetPoints()->GetData());
  samples.normals = readVectors(requireArray(input->GetPointData(), "point", "Normals", 3, false));
  readPatches(input, samples);
  if (withCorners)
  {
    readCorners(input, samples);
  }
  return samples;
}

void checkMeshes(const SampleSet& samples, vtkPolyData* before, vtkPolyData* after)
{
  if (before != nullptr && after != nullptr &&
    before->GetNumberOfPoints() != after->GetNumberOfPoints())
  {
    throw std::invalid_argument("Meshes: " + std::to_string(before->GetNumberOfPoints()) +
      " points before and " + std::to_string(after->GetNumberOfPoints()) +
      " after, expected the same points");
  }
  const vtkIdType count = (before != nullptr ? before : after)->GetNumberOfPoints();
  for (std::size_t i = 0; i < samples.corners.size(); ++i)
  {
    for (const vtkIdType id : samples.corners[i])
    {
      if (id < 0 || id >= count)
      {
        throw std::invalid_argument("Samples: array 'PointIds' has " + std::to_string(id) +
          " at sample " + std::to_string(i) + ", expected 0 to " + std::to_string(count) +
          " - 1, the points of the mesh");
      }
    }
  }
}

// Where the samples lie on the mesh, with the normals of its triangles in their own orientation.
Geometry placeOnMesh(const SampleSet& samples, vtkPolyData* mesh)
{
  Geometry geometry;
  for (std::size_t i = 0; i < samples.corners.size(); ++i)
  {
    glm::dvec3 p[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      mesh->GetPoint(samples.corners[i][k], &p[k].x);
    }
    const glm::dvec3 weights = samples.barycentrics[i];
    geometry.positions.push_back(weights.x * p[0] + weights.y * p[1] + weights.z * p[2]);
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(area);
    geometry.normals.push_back(length > 0.0 ? area / length : glm::dvec3(0.0));
  }
  return geometry;
}

// The two frames. The order of a triangle's corners does not tell its front; the samples' normals
// do.
void placeSamples(const SampleSet& samples, vtkPolyData* before, vtkPolyData* after,
  Geometry& geometryBefore, Geometry& geometryAfter)
{
  geometryBefore = geometryAfter = { samples.positions, samples.normals };
  if (before == nullptr && after == nullptr)
  {
    return;
  }
  checkMeshes(samples, before, after);
  if (before != nullptr)
  {
    geometryBefore = placeOnMesh(samples, before);
  }
  if (after != nullptr)
  {
    geometryAfter = placeOnMesh(samples, after);
  }
  const std::vector<glm::dvec3> reference =
    (before != nullptr ? geometryBefore : geometryAfter).normals;
  for (std::size_t i = 0; i < samples.corners.size(); ++i)
  {
    const double side = glm::dot(reference[i], samples.normals[i]) < 0.0 ? -1.0 : 1.0;
    geometryBefore.normals[i] *= before != nullptr ? side : 1.0;
    geometryAfter.normals[i] *= after != nullptr ? side : 1.0;
  }
}

glm::dmat4 toMatrix(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

std::vector<hachure::ProjectedSample> project(
  const SampleSet& samples, const Geometry& geometry, vtkCamera* camera, const double size[2])
{
  hachure::ViewProjection view;
  view.modelToView = toMatrix(camera->GetModelViewTransformMatrix());
  view.viewToClip = toMatrix(camera->GetProjectionTransformMatrix(size[0] / size[1], -1.0, 1.0));
  view.viewportSize = { size[0], size[1] };
  return hachure::projectSamples(
    { geometry.positions, geometry.normals, samples.patches, samples.spacing }, view,
    hachure::FacingRule::FrontOnly);
}

void fillTable(vtkTable* table, const std::vector<int>& patchIds,
  const std::vector<hachure::PatternFrame>& anchors, const hachure::PatchFits& fits)
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
    const hachure::SimilarityFit& fit = fits.fits[static_cast<std::size_t>(row)];
    const hachure::PatternFrame frame =
      hachure::advance(anchors[static_cast<std::size_t>(row)], fit.transform);
    const hachure::Similarity& step = fit.transform;
    const double values[] = { frame.origin.x, frame.origin.y, frame.u.x, frame.u.y, frame.v.x,
      frame.v.y, step.z.x, step.z.y, step.scale(), step.angleDegrees(), fit.weight, fit.residual };
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
    const SampleSet samples = readSamples(input, before != nullptr || after != nullptr);
    Geometry geometryBefore, geometryAfter;
    placeSamples(samples, before, after, geometryBefore, geometryAfter);
    const auto samplesBefore =
      project(samples, geometryBefore, this->CameraBefore, this->ViewportSize);
    const auto samplesAfter =
      project(samples, geometryAfter, this->CameraAfter, this->ViewportSize);

    const auto scheme = static_cast<hachure::WeightScheme>(this->WeightScheme);
    const std::vector<double> weightsBefore = hachure::facingWeights(samplesBefore, scheme);
    const std::vector<double> weightsAfter = hachure::facingWeights(samplesAfter, scheme);
    const hachure::WeightedFrame frameBefore{ samplesBefore, weightsBefore };
    const hachure::WeightedFrame frameAfter{ samplesAfter, weightsAfter };
    const std::size_t rows = samples.patchIds.size();
    hachure::PatchFits fits =
      hachure::fitPatches(frameBefore, frameAfter, samples.patches, rows, scheme);
    hachure::measureResiduals(fits, frameBefore, frameAfter, samples.patches);
    const hachure::PatternAnchors anchors =
      hachure::anchorPatterns(samplesBefore, samples.patches, rows);
    fillTable(vtkTable::GetData(outputVector), samples.patchIds, anchors.frames, fits);
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

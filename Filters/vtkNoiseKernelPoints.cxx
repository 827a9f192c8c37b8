// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseKernelPoints.h"

#include "CameraView.h"
#include "Core/NoiseProcess.h"
#include "Core/NoiseSurface.h"
#include "SurfaceTriangles.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt64Array.h>
#include <vtkUnsignedIntArray.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkNoiseKernelPoints);

namespace
{
using hachure::NoiseKernel;
using hachure::NoisePoint;
using hachure::SurfaceTriangles;

constexpr double degree = 0.017453292519943295; // radians

// The kernels of a view, and their points.
struct Kernels
{
  std::vector<NoiseKernel> kernels;
  std::vector<NoisePoint> points;
};

// The global ids of every block's cells; null where it has none.
std::vector<vtkDataArray*> globalIds(vtkDataObject* input)
{
  std::vector<vtkDataArray*> result;
  const auto add = [&](vtkDataObject* block)
  {
    vtkPolyData* surface = vtkPolyData::SafeDownCast(block);
    vtkDataArray* ids = surface ? surface->GetCellData()->GetGlobalIds() : nullptr;
    result.push_back(
      ids && ids->GetNumberOfTuples() == surface->GetNumberOfCells() ? ids : nullptr);
  };
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    add(input);
    return result;
  }
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    add(iterator->GetCurrentDataObject());
  }
  return result;
}

// An id for every triangle: of its cell and its number within it, or of where it is.
std::vector<std::uint64_t> triangleIds(vtkDataObject* input, const SurfaceTriangles& surface)
{
  const std::vector<vtkDataArray*> cellIds = globalIds(input);
  std::vector<std::uint64_t> ids(surface.triangles.size());
  std::uint64_t inCell = 0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const bool isSameCell = i > 0 && surface.cells[i] == surface.cells[i - 1] &&
      surface.blockIndices[i] == surface.blockIndices[i - 1];
    inCell = isSameCell ? inCell + 1 : 0;
    const glm::ivec3 corners = surface.triangles[i];
    vtkDataArray* known = cellIds[static_cast<std::size_t>(surface.blockIndices[i])];
    ids[i] = known ? hachure::hashPair(static_cast<std::uint64_t>(
                                         known->GetVariantValue(surface.cells[i]).ToTypeInt64()),
                       inCell)
                   : hachure::noiseTriangleId(surface.points[corners.x], surface.points[corners.y],
                       surface.points[corners.z]);
  }
  return ids;
}

template <class ArrayType>
ArrayType* addArray(vtkPolyData* output, const char* name, std::size_t count, int components = 1)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  output->GetPointData()->AddArray(array);
  return array;
}

// Where on the surface the kernels are.
void attachPlaces(const SurfaceTriangles& surface, const Kernels& found, vtkPolyData* output)
{
  const std::size_t count = found.points.size();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  vtkNew<vtkCellArray> vertices;
  auto* ids = addArray<vtkTypeUInt64Array>(output, "KernelId", count);
  auto* cells = addArray<vtkIdTypeArray>(output, "CellId", count);
  auto* blocks = addArray<vtkUnsignedIntArray>(output, "BlockIndex", count);
  auto* levels = addArray<vtkIntArray>(output, "Level", count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const NoisePoint& point = found.points[i];
    const auto triangle = static_cast<std::size_t>(point.triangle);
    const glm::ivec3 corners = surface.triangles[triangle];
    const glm::dvec3& first = surface.points[corners.x];
    const glm::dvec3 place = first + point.weights.x * (surface.points[corners.y] - first) +
      point.weights.y * (surface.points[corners.z] - first);
    points->SetPoint(id, &place.x);
    vertices->InsertNextCell(1, &id);
    ids->SetValue(id, point.id);
    cells->SetValue(id, surface.cells[triangle]);
    blocks->SetValue(
      id, surface.blocks[static_cast<std::size_t>(surface.blockIndices[triangle])].flatIndex);
    levels->SetValue(id, hachure::binaryExponent(point.birth));
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
}

// How the kernels are drawn.
void attachParameters(const std::vector<NoiseKernel>& kernels, vtkPolyData* output)
{
  const std::size_t count = kernels.size();
  auto* weights = addArray<vtkFloatArray>(output, "Weight", count);
  auto* centers = addArray<vtkFloatArray>(output, "Center", count, 2);
  auto* radii = addArray<vtkFloatArray>(output, "Radius", count);
  auto* bandwidths = addArray<vtkFloatArray>(output, "Bandwidth", count);
  auto* frequencies = addArray<vtkFloatArray>(output, "Frequency", count);
  auto* orientations = addArray<vtkFloatArray>(output, "Orientation", count);
  auto* phases = addArray<vtkFloatArray>(output, "Phase", count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const NoiseKernel& kernel = kernels[i];
    weights->SetValue(id, kernel.weight);
    centers->SetTypedTuple(id, &kernel.center.x);
    radii->SetValue(id, hachure::noiseRadius(kernel.bandwidth));
    bandwidths->SetValue(id, kernel.bandwidth);
    frequencies->SetValue(id, kernel.frequency);
    orientations->SetValue(id, static_cast<float>(kernel.orientation / degree));
    phases->SetValue(id, static_cast<float>(kernel.phase / degree));
  }
}

hachure::NoiseView viewOf(vtkCamera* camera, const double size[2])
{
  const hachure::ViewProjection projection = hachure::cameraView(camera, size);
  hachure::NoiseView view;
  view.modelToClip = projection.viewToClip * projection.modelToView;
  view.viewportSize = projection.viewportSize;
  return view;
}
} // namespace

vtkNoiseKernelPoints::vtkNoiseKernelPoints() = default;
vtkNoiseKernelPoints::~vtkNoiseKernelPoints() = default;

void vtkNoiseKernelPoints::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkNoiseKernelPoints::GetCamera()
{
  return this->Camera;
}

void vtkNoiseKernelPoints::SetViewportSize(double width, double height)
{
  const double clamped[2] = { std::max(1.0, width), std::max(1.0, height) };
  if (this->ViewportSize[0] != clamped[0] || this->ViewportSize[1] != clamped[1])
  {
    std::copy(clamped, clamped + 2, this->ViewportSize);
    this->Modified();
  }
}

vtkMTimeType vtkNoiseKernelPoints::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Camera ? std::max(time, this->Camera->GetMTime()) : time;
}

int vtkNoiseKernelPoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkNoiseKernelPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (this->Camera == nullptr)
  {
    vtkErrorMacro("No camera, expected one: SetCamera.");
    return 0;
  }
  hachure::NoiseKernelOptions options;
  options.overlap = this->Overlap;
  options.radius = this->Radius;
  options.frequency = this->Frequency;
  options.orientation = this->Orientation * degree;
  options.spread = this->Spread * degree;
  options.fade = this->Fade;
  const auto goesOn = [this](double progress)
  {
    this->UpdateProgress(progress);
    return !this->GetAbortExecute();
  };
  try
  {
    const SurfaceTriangles surface = hachure::extractSurfaceTriangles(input);
    if (surface.nonFinitePoints > 0)
    {
      vtkWarningMacro(<< surface.nonFinitePoints
                      << " input point(s) have a coordinate that is not finite; the cells that use "
                         "them have no kernels.");
    }
    const hachure::NoiseView view = viewOf(this->Camera, this->ViewportSize);
    const std::vector<std::uint64_t> ids = triangleIds(input, surface);
    Kernels found;
    if (goesOn(0.2) && this->Classic)
    {
      found.kernels = hachure::classicNoiseKernels(
        surface.mesh(), ids, {}, this->Seed, view, options, &found.points);
    }
    else if (!this->GetAbortExecute())
    {
      hachure::NoiseSurface points(surface.mesh(), ids, {}, this->Seed);
      if (goesOn(0.5))
      {
        points.kernels(view, options, found.kernels, &found.points);
      }
    }
    if (goesOn(0.9))
    {
      attachPlaces(surface, found, output);
      attachParameters(found.kernels, output);
    }
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkNoiseKernelPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
  os << indent << "Overlap: " << this->Overlap << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "Spread: " << this->Spread << "\n";
  os << indent << "Fade: " << this->Fade << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Classic: " << (this->Classic ? "on" : "off") << "\n";
}

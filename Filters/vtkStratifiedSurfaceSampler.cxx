// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStratifiedSurfaceSampler.h"

#include "Core/Parallel.h"
#include "Core/SurfaceSampling.h"
#include "SurfaceTriangles.h"

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedIntArray.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkStratifiedSurfaceSampler);

namespace
{
using hachure::SurfaceSamples;
using hachure::SurfaceTriangles;

template <class ArrayType>
ArrayType* addArray(vtkPolyData* output, const char* name, int components, std::size_t count)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  output->GetPointData()->AddArray(array);
  return array;
}

/// Positions, normals and barycentric coordinates.
void attachGeometry(
  const SurfaceTriangles& surface, const SurfaceSamples& samples, vtkPolyData* output)
{
  const std::size_t count = samples.triangles.size();
  std::vector<double> blockSigns;
  for (std::size_t block = 0; block < surface.blocks.size(); ++block)
  {
    blockSigns.push_back(hachure::isInsideOut(surface.blockMesh(block)) ? -1.0 : 1.0);
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(count));
  auto* barycentrics = addArray<vtkDoubleArray>(output, "Barycentrics", 3, count);

  const hachure::TriangleMesh mesh = surface.mesh();
  hachure::parallelFor(static_cast<std::int64_t>(count),
    [&](std::int64_t i)
    {
      const std::int32_t triangle = samples.triangles[i];
      const glm::ivec3 corners = surface.triangles[triangle];
      const glm::dvec3 weights = samples.barycentrics[i];
      const glm::dvec3 position = weights.x * surface.points[corners.x] +
        weights.y * surface.points[corners.y] + weights.z * surface.points[corners.z];
      const glm::dvec3 normal = blockSigns[surface.blockIndices[triangle]] *
        glm::normalize(hachure::triangleAreaVector(mesh, triangle));
      points->SetPoint(i, &position.x);
      normals->SetTypedTuple(i, &normal.x);
      barycentrics->SetTypedTuple(i, &weights.x);
    });
  output->SetPoints(points);
  output->GetPointData()->SetNormals(normals);
}

/// Everything that says where on the input a sample lies.
void attachIdentity(const SurfaceTriangles& surface, const SurfaceSamples& samples,
  int samplesPerPatch, vtkPolyData* output)
{
  const std::size_t count = samples.triangles.size();
  auto* cellIds = addArray<vtkIdTypeArray>(output, "CellId", 1, count);
  auto* pointIds = addArray<vtkIdTypeArray>(output, "PointIds", 3, count);
  auto* patchIds = addArray<vtkIntArray>(output, "PatchId", 1, count);
  auto* blockIndices = addArray<vtkUnsignedIntArray>(output, "BlockIndex", 1, count);
  auto* sampleIds = addArray<vtkIdTypeArray>(output, "SampleId", 1, count);
  vtkNew<vtkCellArray> vertices;
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkIdType id = static_cast<vtkIdType>(i);
    const std::int32_t triangle = samples.triangles[i];
    const SurfaceTriangles::Block& block = surface.blocks[surface.blockIndices[triangle]];
    for (int corner = 0; corner < 3; ++corner)
    {
      pointIds->SetTypedComponent(
        id, corner, surface.triangles[triangle][corner] - block.firstPoint);
    }
    cellIds->SetValue(id, surface.cells[triangle]);
    patchIds->SetValue(id, samples.patches[i]);
    blockIndices->SetValue(id, block.flatIndex);
    sampleIds->SetValue(
      id, static_cast<vtkIdType>(samples.patches[i]) * samplesPerPatch + samples.strata[i]);
    vertices->InsertNextCell(1, &id);
  }
  output->SetVerts(vertices);

  vtkNew<vtkDoubleArray> spacing;
  spacing->SetName("PatchSpacing");
  spacing->SetNumberOfValues(static_cast<vtkIdType>(samples.patchSpacing.size()));
  std::copy(samples.patchSpacing.begin(), samples.patchSpacing.end(), spacing->GetPointer(0));
  output->GetFieldData()->AddArray(spacing);
}
} // namespace

vtkStratifiedSurfaceSampler::vtkStratifiedSurfaceSampler() = default;

int vtkStratifiedSurfaceSampler::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkStratifiedSurfaceSampler::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  hachure::SamplingOptions options;
  options.samplesPerPatch = this->SamplesPerPatch;
  options.minimumDistance = this->MinimumDistance;
  options.regularity = this->Regularity;
  options.seed = this->Seed;
  options.progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !this->GetAbortExecute();
  };
  try
  {
    const SurfaceTriangles surface =
      hachure::extractSurfaceTriangles(input, { this->PatchArrayName, this->PatchByBlock });
    if (surface.nonFinitePoints > 0)
    {
      vtkWarningMacro(<< surface.nonFinitePoints
                      << " input point(s) have a coordinate that is not finite; the cells that use "
                         "them take no samples.");
    }
    const SurfaceSamples samples = hachure::sampleSurface(surface.mesh(), options);
    attachGeometry(surface, samples, output);
    attachIdentity(surface, samples, this->SamplesPerPatch, output);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkStratifiedSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerPatch: " << this->SamplesPerPatch << "\n";
  os << indent << "MinimumDistance: " << this->MinimumDistance << "\n";
  os << indent << "Regularity: " << this->Regularity << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "PatchArrayName: " << this->PatchArrayName << "\n";
  os << indent << "PatchByBlock: " << (this->PatchByBlock ? "on" : "off") << "\n";
}

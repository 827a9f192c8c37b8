// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStippleHierarchy.h"

#include "Core/Parallel.h"
#include "StippleInput.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedIntArray.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkStippleHierarchy);

namespace
{
using hachure::StippleHierarchy;
using hachure::StippleInput;
using hachure::StipplePoint;

template <class ArrayType>
vtkNew<ArrayType> makeArray(const char* name, std::size_t count, int components = 1)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

// Cells of equal size with 32 bits for every number.
vtkNew<vtkCellArray> makeCells(const int* corners, std::size_t count, int size)
{
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(count) + 1);
  vtkNew<vtkTypeInt32Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(count) * size);
  for (std::size_t i = 0; i <= count; ++i)
  {
    offsets->SetValue(static_cast<vtkIdType>(i), static_cast<int>(i) * size);
  }
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(size); ++i)
  {
    connectivity->SetValue(static_cast<vtkIdType>(i), corners ? corners[i] : static_cast<int>(i));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  return cells;
}

// The signs that turn normals outward, of every block.
std::vector<double> outwardSigns(const StippleInput& input)
{
  std::vector<double> signs;
  signs.reserve(input.surface.blocks.size());
  for (std::size_t block = 0; block < input.surface.blocks.size(); ++block)
  {
    const bool isTurned =
      !input.hasPointsOnly && hachure::isInsideOut(input.surface.blockMesh(block));
    signs.push_back(isTurned ? -1.0 : 1.0);
  }
  return signs;
}

// Where the points are and which way they face.
void attachGeometry(
  const StippleInput& input, const std::vector<StipplePoint>& found, vtkPolyData* output)
{
  const std::vector<double> signs = outwardSigns(input);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(found.size()));
  const auto normals = makeArray<vtkFloatArray>("Normals", found.size(), 3);
  hachure::parallelFor(static_cast<std::int64_t>(found.size()),
    [&](std::int64_t i)
    {
      const StipplePoint& point = found[static_cast<std::size_t>(i)];
      const glm::dvec3 position = input.placeOf(point);
      const glm::dvec3 normal =
        signs[static_cast<std::size_t>(input.blockOf(point))] * input.normalOf(point);
      points->SetPoint(i, &position.x);
      normals->SetTuple(i, &normal.x);
    });
  output->SetPoints(points);
  output->SetVerts(makeCells(nullptr, found.size(), 1));
  output->GetPointData()->SetNormals(normals);
}

// Where on the input the points are, and how relevant.
void attachPlaces(const StippleInput& input, const std::vector<StipplePoint>& found,
  bool isComposite, vtkPolyData* output)
{
  const auto cells = makeArray<vtkIntArray>("StippleCell", found.size());
  const auto weights = makeArray<vtkFloatArray>("StippleWeights", found.size(), 2);
  const auto spacings = makeArray<vtkFloatArray>("StippleSpacing", found.size());
  const auto blocks = makeArray<vtkUnsignedIntArray>("BlockIndex", isComposite ? found.size() : 0);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    cells->SetValue(id, static_cast<int>(input.cellOf(found[i])));
    weights->SetTypedTuple(id, found[i].weights);
    spacings->SetValue(id, found[i].spacing);
    if (isComposite)
    {
      const auto block = static_cast<std::size_t>(input.blockOf(found[i]));
      blocks->SetValue(id, input.surface.blocks[block].flatIndex);
    }
  }
  vtkPointData* data = output->GetPointData();
  data->AddArray(cells);
  data->AddArray(weights);
  data->AddArray(spacings);
  if (isComposite)
  {
    data->AddArray(blocks);
  }
}

void attachPointIds(
  const StippleInput& input, const std::vector<StipplePoint>& found, vtkPolyData* output)
{
  const auto pointIds = makeArray<vtkIntArray>("StipplePointIds", found.size(), 3);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const glm::ivec3 corners = input.pointsOf(found[i]);
    pointIds->SetTypedTuple(static_cast<vtkIdType>(i), &corners.x);
  }
  output->GetPointData()->AddArray(pointIds);
}

// The arrays of the input at the points.
void interpolate(const StippleInput& input, const std::vector<StipplePoint>& found,
  vtkPolyData* from, vtkPolyData* output)
{
  auto* weights = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("StippleWeights"));
  auto* cells = vtkIntArray::SafeDownCast(output->GetPointData()->GetArray("StippleCell"));
  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<vtkPointData> points;
  points->InterpolateAllocate(from->GetPointData(), count);
  vtkNew<vtkPointData> ofCells;
  ofCells->CopyAllocate(from->GetCellData(), count);
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const glm::ivec3 ids = input.pointsOf(found[static_cast<std::size_t>(i)]);
    for (int corner = 0; corner < 3; ++corner)
    {
      corners->SetId(corner, ids[corner]);
    }
    const double second = weights->GetTypedComponent(i, 0);
    const double third = weights->GetTypedComponent(i, 1);
    double shares[3] = { 1.0 - second - third, second, third };
    points->InterpolatePoint(from->GetPointData(), i, corners, shares);
    if (cells->GetValue(i) >= 0)
    {
      ofCells->CopyData(from->GetCellData(), cells->GetValue(i), i);
    }
  }
  // What is there already has precedence.
  for (vtkPointData* source : { points.Get(), ofCells.Get() })
  {
    for (int i = 0; i < source->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = source->GetAbstractArray(i);
      if (array->GetNumberOfTuples() == count && array->GetName() &&
        !output->GetPointData()->HasArray(array->GetName()))
      {
        output->GetPointData()->AddArray(array);
      }
    }
  }
}

template <class ArrayType, class Value>
void addField(vtkPolyData* output, const char* name, const std::vector<Value>& values)
{
  const auto array = makeArray<ArrayType>(name, values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}

void attachParticles(const StippleHierarchy& found, vtkPolyData* output, vtkPolyData* particles)
{
  particles->SetPoints(output->GetPoints());
  const int* corners =
    found.particleTriangles.empty() ? nullptr : &found.particleTriangles.front().x;
  particles->SetPolys(makeCells(corners, found.particleTriangles.size(), 3));
}
} // namespace

vtkStippleHierarchy::vtkStippleHierarchy()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkStippleHierarchy::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkStippleHierarchy::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* data = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* particles = vtkPolyData::GetData(outputVector, 1);
  hachure::StippleOptions options;
  options.count = this->NumberOfPoints;
  options.seed = this->Seed;
  options.order =
    this->Order == CLASSIC ? hachure::StippleOrder::Classic : hachure::StippleOrder::Progressive;
  options.leastMove = this->LeastMove;
  options.mostMove = this->MostMove;
  options.progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !this->GetAbortExecute();
  };
  try
  {
    const StippleInput input = hachure::readStippleInput(data);
    if (input.surface.nonFinitePoints > 0)
    {
      vtkWarningMacro(<< input.surface.nonFinitePoints
                      << " input point(s) have a coordinate that is not finite; they and the cells "
                         "that use them take no stipples.");
    }
    if (input.isMissingNormals)
    {
      vtkWarningMacro("The input has neither polygons nor point normals; its points are taken to "
                      "face every way.");
    }
    const StippleHierarchy found = input.hierarchy(options);
    vtkPolyData* surface = vtkPolyData::SafeDownCast(data);
    attachGeometry(input, found.points, output);
    attachPlaces(input, found.points, surface == nullptr, output);
    addField<vtkDoubleArray>(output, "StippleArea", std::vector<double>{ found.area });
    if (this->GeneratePointIds || input.hasPointsOnly)
    {
      attachPointIds(input, found.points, output);
    }
    if (this->InterpolateData && surface)
    {
      interpolate(input, found.points, surface, output);
    }
    if (options.order == hachure::StippleOrder::Classic)
    {
      addField<vtkUnsignedIntArray>(output, "StippleNeighbourOffsets", found.firstNeighbour);
      addField<vtkIntArray>(output, "StippleNeighbours", found.neighbours);
      if (this->GenerateParticleMesh)
      {
        attachParticles(found, output, particles);
      }
    }
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    particles->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkStippleHierarchy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Order: " << (this->Order == CLASSIC ? "Classic" : "Progressive") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "LeastMove: " << this->LeastMove << "\n";
  os << indent << "MostMove: " << this->MostMove << "\n";
  os << indent << "InterpolateData: " << (this->InterpolateData ? "on" : "off") << "\n";
  os << indent << "GeneratePointIds: " << (this->GeneratePointIds ? "on" : "off") << "\n";
  os << indent << "GenerateParticleMesh: " << (this->GenerateParticleMesh ? "on" : "off") << "\n";
}

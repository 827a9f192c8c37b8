// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceDirectionField.h"

#include "Core/SurfaceDirections.h"
#include "SurfaceDirectionInput.h"
#include "SurfacePatchesInput.h"

#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSurfaceDirectionField);

namespace
{
using hachure::DirectionBlock;

/// What the properties of the filter say.
struct FieldOptions
{
  int method = vtkSurfaceDirectionField::CURVATURE;
  std::string arrayName;
  hachure::CurvatureLine line = hachure::CurvatureLine::LargestMagnitude;
  bool perpendicular = false;
  double radius = 0.0;
  hachure::SmoothingOptions smoothing;
};

struct BlockField
{
  hachure::DirectionField points;
  std::vector<hachure::VertexCurvature> curvatures; // per vertex
};

/// Progress of a part of the work.
hachure::ProgressFn part(const hachure::ProgressFn& progress, double begin, double end)
{
  return [=](double fraction) { return progress(begin + (end - begin) * fraction); };
}

std::vector<glm::dvec2> estimateLines(const DirectionBlock& block,
  const hachure::VertexGraph& graph, const FieldOptions& options, BlockField& field)
{
  if (options.method == vtkSurfaceDirectionField::GRADIENT)
  {
    const std::vector<double> scalars = hachure::readScalars(block, options.arrayName);
    return hachure::gradientLines(graph, block.mesh(), scalars);
  }
  if (options.method == vtkSurfaceDirectionField::VECTORS)
  {
    const hachure::DirectionVectors vectors = hachure::readVectors(block, options.arrayName);
    return vectors.ofPoints ? hachure::pointVectorLines(graph, block.vertices, vectors.values)
                            : hachure::triangleVectorLines(graph, vectors.values);
  }
  hachure::CurvatureOptions curvature;
  curvature.radius = options.radius > 0.0 ? options.radius : hachure::defaultCurvatureRadius(graph);
  curvature.progress = part(options.smoothing.progress, 0.0, 0.6);
  field.curvatures = hachure::vertexCurvatures(graph, curvature);
  return field.curvatures.empty() ? std::vector<glm::dvec2>()
                                  : hachure::curvatureLines(graph, field.curvatures, options.line);
}

/// The field of one block; without points after an abort.
BlockField makeField(const DirectionBlock& block, const FieldOptions& options)
{
  BlockField field;
  if (block.triangles.empty())
  {
    field.points.directions.assign(block.points.size(), glm::dvec3(0.0));
    field.points.reliabilities.assign(block.points.size(), 0.0);
    return field;
  }
  const hachure::VertexGraph graph = hachure::makeVertexGraph(block.mesh(), block.vertices);
  std::vector<glm::dvec2> lines = estimateLines(block, graph, options, field);
  for (glm::dvec2& line : lines)
  {
    line = options.perpendicular ? -line : line;
  }
  hachure::SmoothingOptions smoothing = options.smoothing;
  smoothing.progress = part(options.smoothing.progress, 0.6, 1.0);
  hachure::DirectionField vertices;
  if (!lines.empty())
  {
    vertices = hachure::smoothDirections(graph, lines, smoothing);
  }
  if (!vertices.directions.empty())
  {
    field.points =
      hachure::directionsAtPoints(graph, block.mesh(), block.vertices, vertices, block.normals);
  }
  return field;
}

/// The fields of all blocks; none after an abort, which `progress` tells.
std::vector<BlockField> makeFields(const std::vector<DirectionBlock>& blocks,
  const FieldOptions& options, const hachure::ProgressFn& progress)
{
  std::vector<BlockField> fields;
  fields.reserve(blocks.size());
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, blocks.size()));
  for (const DirectionBlock& block : blocks)
  {
    const double begin = share * static_cast<double>(fields.size());
    if (!progress(begin))
    {
      return {};
    }
    FieldOptions ofBlock = options;
    ofBlock.smoothing.progress = part(progress, begin, begin + share);
    fields.push_back(makeField(block, ofBlock));
  }
  return fields;
}

vtkFloatArray* addArray(vtkPolyData* data, const char* name, int components)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  array->FillValue(0.0f);
  data->GetPointData()->AddArray(array);
  return array;
}

void attachCurvatures(vtkPolyData* data, const DirectionBlock& block, const BlockField& field)
{
  vtkFloatArray* array = addArray(data, "PrincipalCurvatures", 2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints() && !field.curvatures.empty(); ++i)
  {
    if (field.points.directions[i] != glm::dvec3(0.0))
    {
      const hachure::VertexCurvature& curvature = field.curvatures[block.vertices[i]];
      array->SetTuple2(i, curvature.largest, curvature.smallest);
    }
  }
}

void attachField(vtkPolyData* data, const BlockField& field, bool asTangents)
{
  vtkFloatArray* directions = addArray(data, "Direction", 3);
  vtkFloatArray* reliabilities = addArray(data, "Reliability", 1);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    directions->SetTuple(i, &field.points.directions[i].x);
    reliabilities->SetValue(i, static_cast<float>(field.points.reliabilities[i]));
  }
  if (asTangents)
  {
    data->GetPointData()->SetTangents(directions);
  }
}

void attachFields(vtkDataObject* output, const std::vector<DirectionBlock>& blocks,
  const std::vector<BlockField>& fields, vtkSurfaceDirectionField& filter)
{
  const std::vector<vtkPolyData*> data = hachure::polyDataBlocks(output);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    attachField(data[i], fields[i], filter.GetActiveTangents());
    if (filter.GetMethod() == vtkSurfaceDirectionField::CURVATURE)
    {
      attachCurvatures(data[i], blocks[i], fields[i]);
    }
  }
}

FieldOptions readOptions(vtkSurfaceDirectionField& filter)
{
  FieldOptions options;
  options.method = filter.GetMethod();
  options.arrayName = filter.GetArrayName();
  options.line = static_cast<hachure::CurvatureLine>(filter.GetPrincipalDirection());
  options.perpendicular = filter.GetPerpendicular();
  options.radius = filter.GetRadius();
  options.smoothing.iterations = filter.GetSmoothingIterations();
  filter.GetReferenceAxis(&options.smoothing.axis.x);
  if (options.method != vtkSurfaceDirectionField::CURVATURE && options.arrayName.empty())
  {
    throw std::invalid_argument("ArrayName is empty; expected the name of an array");
  }
  return options;
}
} // namespace

vtkSurfaceDirectionField::vtkSurfaceDirectionField() = default;

int vtkSurfaceDirectionField::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkSurfaceDirectionField::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const hachure::ProgressFn progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !this->GetAbortExecute();
  };
  try
  {
    const FieldOptions options = readOptions(*this);
    const std::vector<DirectionBlock> blocks = hachure::readDirectionBlocks(input);
    const std::vector<BlockField> fields = makeFields(blocks, options, progress);
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
    hachure::copyBlocks(input, output);
    attachFields(output, blocks, fields, *this);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSurfaceDirectionField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "PrincipalDirection: " << this->PrincipalDirection << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Perpendicular: " << (this->Perpendicular ? "on" : "off") << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "ReferenceAxis: " << this->ReferenceAxis[0] << " " << this->ReferenceAxis[1]
     << " " << this->ReferenceAxis[2] << "\n";
  os << indent << "ActiveTangents: " << (this->ActiveTangents ? "on" : "off") << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDirectionInput.h"

#include "Core/SurfacePatchesMesh.h"
#include "SurfacePatchesInput.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <stdexcept>

namespace hachure
{
namespace
{
/// The error about an array, with what is wrong and what was expected.
[[noreturn]] void refuse(const DirectionBlock& block, const std::string& name,
  const std::string& what, const std::string& expected)
{
  std::string message = "Array '" + name + "' " + what;
  if (block.flatIndex != 0)
  {
    message += " in block ";
    message += std::to_string(block.flatIndex);
  }
  throw std::invalid_argument(message + "; expected " + expected);
}

vtkDataArray* checkArray(const DirectionBlock& block, vtkAbstractArray* found,
  const std::string& name, int components, vtkIdType size, const std::string& expected)
{
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  if (!array)
  {
    refuse(
      block, name, std::string("has values of type ") + found->GetDataTypeAsString(), expected);
  }
  if (array->GetNumberOfComponents() != components)
  {
    const int actual = array->GetNumberOfComponents();
    const std::string count = std::to_string(actual) + (actual == 1 ? " component" : " components");
    refuse(block, name, "has " + count, expected);
  }
  if (array->GetNumberOfTuples() != size)
  {
    const std::string counts =
      std::to_string(array->GetNumberOfTuples()) + " tuples for " + std::to_string(size);
    refuse(block, name, "has " + counts, expected);
  }
  return array;
}

glm::dvec3 vectorOf(vtkDataArray* array, vtkIdType tuple)
{
  glm::dvec3 value(0.0);
  array->GetTuple(tuple, &value.x);
  return value;
}

std::vector<glm::dvec3> readPointVectors(vtkDataArray* array)
{
  std::vector<glm::dvec3> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values[i] = vectorOf(array, i);
  }
  return values;
}

void readNormals(DirectionBlock& block)
{
  vtkDataArray* normals = block.data->GetPointData()->GetNormals();
  if (normals && normals->GetNumberOfComponents() == 3 &&
    normals->GetNumberOfTuples() == block.data->GetNumberOfPoints())
  {
    block.normals = readPointVectors(normals);
  }
}
} // namespace

std::vector<DirectionBlock> readDirectionBlocks(vtkDataObject* input)
{
  const SurfaceTriangles all = extractSurfaceTriangles(input, {}, TriangleChoice::Finite);
  const std::vector<vtkPolyData*> data = polyDataBlocks(input);
  std::vector<DirectionBlock> blocks(data.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    DirectionBlock& block = blocks[i];
    block.data = data[i];
    block.flatIndex = all.blocks[i].flatIndex;
    const std::int32_t first = all.blocks[i].firstPoint;
    const auto begin = all.points.begin() + first;
    block.points.assign(begin, begin + data[i]->GetNumberOfPoints());
    const std::size_t firstTriangle = all.blocks[i].firstTriangle;
    const TriangleMesh mesh = all.blockMesh(i);
    block.triangles.reserve(mesh.triangles.size());
    for (const glm::ivec3& corners : mesh.triangles)
    {
      block.triangles.push_back(corners - first);
    }
    const auto cells = all.cells.begin() + static_cast<std::ptrdiff_t>(firstTriangle);
    block.cells.assign(cells, cells + static_cast<std::ptrdiff_t>(mesh.triangles.size()));
    block.vertices = joinPoints(block.points);
    readNormals(block);
  }
  return blocks;
}

std::vector<double> readScalars(const DirectionBlock& block, const std::string& name)
{
  const std::string expected = "a point array of numbers with one component";
  vtkAbstractArray* found = block.data->GetPointData()->GetAbstractArray(name.c_str());
  if (!found)
  {
    const bool ofCells = block.data->GetCellData()->GetAbstractArray(name.c_str()) != nullptr;
    refuse(block, name, ofCells ? "is a cell array" : "is missing", expected);
  }
  vtkDataArray* array =
    checkArray(block, found, name, 1, block.data->GetNumberOfPoints(), expected);
  std::vector<double> values(block.points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

DirectionVectors readVectors(const DirectionBlock& block, const std::string& name)
{
  const std::string expected = "a point or cell array of numbers with three components";
  DirectionVectors result;
  if (vtkAbstractArray* found = block.data->GetPointData()->GetAbstractArray(name.c_str()))
  {
    result.values = readPointVectors(
      checkArray(block, found, name, 3, block.data->GetNumberOfPoints(), expected));
    return result;
  }
  vtkAbstractArray* found = block.data->GetCellData()->GetAbstractArray(name.c_str());
  if (!found)
  {
    refuse(block, name, "is missing", expected);
  }
  vtkDataArray* array = checkArray(block, found, name, 3, block.data->GetNumberOfCells(), expected);
  result.ofPoints = false;
  result.values.reserve(block.cells.size());
  for (const vtkIdType cell : block.cells)
  {
    result.values.push_back(vectorOf(array, cell));
  }
  return result;
}
} // namespace hachure

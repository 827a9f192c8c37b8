// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatchesInput.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace hachure
{
namespace
{
template <class Body>
void forEachLeaf(vtkCompositeDataSet* composite, Body&& body)
{
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    body(iterator.Get(), vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()));
  }
}

/// Fills the faces of the triangles and the cells of the faces.
void findFaces(PatchSurface& result, const std::vector<vtkPolyData*>& blocks, StripFaces strips)
{
  const SurfaceTriangles& surface = result.triangles;
  result.faces.reserve(surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const PatchSurface::FaceCell cell{ surface.blockIndices[i], surface.cells[i] };
    vtkPolyData* block = blocks[cell.block];
    const vtkIdType firstStrip =
      block->GetNumberOfVerts() + block->GetNumberOfLines() + block->GetNumberOfPolys();
    const bool isSame = !result.cells.empty() && result.cells.back().block == cell.block &&
      result.cells.back().cell == cell.cell;
    if (!isSame || (strips == StripFaces::Triangles && cell.cell >= firstStrip))
    {
      result.cells.push_back(cell);
    }
    result.faces.push_back(static_cast<std::int32_t>(result.cells.size()) - 1);
  }
}

/// The block of every point.
std::vector<std::int32_t> blockOfPoints(const SurfaceTriangles& surface)
{
  std::vector<std::int32_t> blocks(surface.points.size(), 0);
  for (std::size_t i = 0; i < surface.blocks.size(); ++i)
  {
    const std::size_t end = i + 1 < surface.blocks.size()
      ? static_cast<std::size_t>(surface.blocks[i + 1].firstPoint)
      : blocks.size();
    for (std::size_t k = surface.blocks[i].firstPoint; k < end; ++k)
    {
      blocks[k] = static_cast<std::int32_t>(i);
    }
  }
  return blocks;
}
} // namespace

PatchSurface readPatchSurface(
  vtkDataObject* input, const PatchSource& source, bool joinBlocks, StripFaces strips)
{
  PatchSurface result;
  result.triangles = extractSurfaceTriangles(input, source, TriangleChoice::All);
  findFaces(result, polyDataBlocks(input), strips);
  result.vertices = joinPoints(result.triangles.points,
    joinBlocks ? std::vector<std::int32_t>() : blockOfPoints(result.triangles));
  return result;
}

std::vector<vtkPolyData*> polyDataBlocks(vtkDataObject* data)
{
  std::vector<vtkPolyData*> blocks;
  if (vtkPolyData* polyData = vtkPolyData::SafeDownCast(data))
  {
    blocks.push_back(polyData);
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    forEachLeaf(
      composite, [&](vtkCompositeDataIterator*, vtkPolyData* leaf) { blocks.push_back(leaf); });
  }
  return blocks;
}

void copyBlocks(vtkDataObject* input, vtkDataObject* output)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(input);
    return;
  }
  vtkCompositeDataSet* copy = vtkCompositeDataSet::SafeDownCast(output);
  copy->CopyStructure(composite);
  copy->GetFieldData()->ShallowCopy(composite->GetFieldData());
  forEachLeaf(composite,
    [&](vtkCompositeDataIterator* position, vtkPolyData* leaf)
    {
      const auto block = vtkSmartPointer<vtkPolyData>::New();
      block->ShallowCopy(leaf);
      copy->SetDataSet(position, block);
    });
}
} // namespace hachure

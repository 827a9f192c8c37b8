// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleInput.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure
{

namespace
{

// Blocks as extractSurfaceTriangles numbers them.
std::vector<vtkPolyData*> blocksOf(vtkDataObject* input)
{
  std::vector<vtkPolyData*> blocks;
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      blocks.push_back(vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()));
    }
  }
  else if (vtkPolyData* surface = vtkPolyData::SafeDownCast(input))
  {
    blocks.push_back(surface);
  }
  return blocks;
}

bool isFinite(const glm::dvec3& value)
{
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

void addPoints(StippleInput& result, vtkPolyData* block, std::int32_t index)
{
  vtkDataArray* normals = block->GetPointData()->GetNormals();
  const auto first =
    static_cast<std::size_t>(result.surface.blocks[static_cast<std::size_t>(index)].firstPoint);
  for (vtkIdType id = 0; id < block->GetNumberOfPoints(); ++id)
  {
    const glm::dvec3& position = result.surface.points[first + static_cast<std::size_t>(id)];
    glm::dvec3 normal(0.0);
    if (normals)
    {
      normals->GetTuple(id, &normal.x);
    }
    if (isFinite(position))
    {
      result.positions.push_back(position);
      result.normals.push_back(isFinite(normal) ? normal : glm::dvec3(0.0));
      result.pointIds.push_back(id);
      result.pointBlocks.push_back(index);
    }
  }
  result.isMissingNormals = result.isMissingNormals || (!normals && block->GetNumberOfPoints() > 0);
}

} // namespace

StippleInput readStippleInput(vtkDataObject* input)
{
  StippleInput result;
  result.surface = extractSurfaceTriangles(input);
  const std::vector<vtkPolyData*> blocks = blocksOf(input);
  result.hasPointsOnly = true;
  for (vtkPolyData* block : blocks)
  {
    result.hasPointsOnly =
      result.hasPointsOnly && block->GetNumberOfPolys() == 0 && block->GetNumberOfStrips() == 0;
  }
  for (std::size_t i = 0; i < blocks.size() && result.hasPointsOnly; ++i)
  {
    addPoints(result, blocks[i], static_cast<std::int32_t>(i));
  }
  return result;
}

StippleHierarchy StippleInput::hierarchy(const StippleOptions& options) const
{
  return this->hasPointsOnly ? stipplePoints(this->positions, this->normals, options)
                             : stippleSurface(this->surface.mesh(), options);
}

vtkIdType StippleInput::cellOf(const StipplePoint& point) const
{
  return this->hasPointsOnly ? -1 : this->surface.cells[static_cast<std::size_t>(point.triangle)];
}

std::int32_t StippleInput::blockOf(const StipplePoint& point) const
{
  const auto index = static_cast<std::size_t>(point.triangle);
  return this->hasPointsOnly ? this->pointBlocks[index] : this->surface.blockIndices[index];
}

glm::ivec3 StippleInput::pointsOf(const StipplePoint& point) const
{
  const auto index = static_cast<std::size_t>(point.triangle);
  return this->hasPointsOnly ? glm::ivec3(static_cast<int>(this->pointIds[index]))
                             : this->surface.triangles[index] -
      this->surface.blocks[static_cast<std::size_t>(this->blockOf(point))].firstPoint;
}

glm::dvec3 StippleInput::placeOf(const StipplePoint& point) const
{
  return this->hasPointsOnly ? this->positions[static_cast<std::size_t>(point.triangle)]
                             : stipplePosition(this->surface.mesh(), point);
}

glm::dvec3 StippleInput::normalOf(const StipplePoint& point) const
{
  const glm::dvec3 normal = this->hasPointsOnly
    ? this->normals[static_cast<std::size_t>(point.triangle)]
    : triangleAreaVector(this->surface.mesh(), point.triangle);
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

} // namespace hachure

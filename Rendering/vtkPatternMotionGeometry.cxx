// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternMotionGeometry.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPatternBlocks.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{
constexpr const char* stateNames[] = { "before", "after" };

[[noreturn]] void Refuse(const std::string& name, const std::string& what)
{
  throw std::invalid_argument(name + ": " + what);
}

void ExpectEqual(const std::string& name, const char* things, vtkIdType before, vtkIdType after)
{
  if (before != after)
  {
    Refuse(name,
      "the state after has " + std::to_string(after) + " " + things + ", expected " +
        std::to_string(before) + " as before");
  }
}

// Same polygons and strips with the same points in the same order.
bool HaveEqualCells(vtkCellArray* before, vtkCellArray* after)
{
  if (before == after)
  {
    return true;
  }
  if (before->GetNumberOfCells() != after->GetNumberOfCells())
  {
    return false;
  }
  vtkIdType sizes[2];
  const vtkIdType* points[2];
  for (vtkIdType cell = 0; cell < before->GetNumberOfCells(); ++cell)
  {
    before->GetCellAtId(cell, sizes[0], points[0]);
    after->GetCellAtId(cell, sizes[1], points[1]);
    if (sizes[0] != sizes[1] || !std::equal(points[0], points[0] + sizes[0], points[1]))
    {
      return false;
    }
  }
  return true;
}
} // namespace

void vtkPatternMotionGeometry::Append(const Surface& surface)
{
  std::array<std::vector<vtkPattern::Block>, 2> blocks;
  for (int state : { Before, After })
  {
    blocks[state] = vtkPattern::Blocks(surface.Data[state]);
  }
  ExpectEqual(surface.Name, "blocks of polydata", static_cast<vtkIdType>(blocks[Before].size()),
    static_cast<vtkIdType>(blocks[After].size()));
  for (std::size_t i = 0; i < blocks[Before].size(); ++i)
  {
    std::string name = surface.Name;
    if (blocks[Before].size() > 1)
    {
      name += ", block " + std::to_string(blocks[Before][i].FlatIndex);
    }
    this->AppendBlock(surface, name, blocks[Before][i].Data, blocks[After][i].Data);
  }
}

void vtkPatternMotionGeometry::AppendBlock(
  const Surface& surface, const std::string& name, vtkPolyData* before, vtkPolyData* after)
{
  ExpectEqual(name, "points", before->GetNumberOfPoints(), after->GetNumberOfPoints());
  ExpectEqual(name, "polygons", before->GetNumberOfPolys(), after->GetNumberOfPolys());
  ExpectEqual(name, "strips", before->GetNumberOfStrips(), after->GetNumberOfStrips());
  if (!HaveEqualCells(before->GetPolys(), after->GetPolys()) ||
    !HaveEqualCells(before->GetStrips(), after->GetStrips()))
  {
    Refuse(
      name, "the state after joins its points in another way, expected the polygons of before");
  }
  const std::size_t firstPoint = this->Points[Before].size();
  const auto count = static_cast<std::size_t>(before->GetNumberOfPoints());
  if (firstPoint + count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    Refuse(name, "more points than " + std::to_string(std::numeric_limits<int>::max()));
  }
  this->AppendPoints(surface, name, Before, before);
  this->AppendPoints(surface, name, After, after);
  this->AppendNormals(surface, before);
  this->AppendTriangles(name, surface.Label, static_cast<int>(firstPoint), before);
}

void vtkPatternMotionGeometry::AppendPoints(
  const Surface& surface, const std::string& name, int state, vtkPolyData* data)
{
  const auto count = static_cast<std::size_t>(data->GetNumberOfPoints());
  std::vector<glm::dvec3>& points = this->Points[state];
  const std::size_t first = points.size();
  points.resize(first + count);
  const glm::dmat4& toView = surface.ToView[state];
  for (std::size_t i = 0; i < count; ++i)
  {
    double position[3];
    data->GetPoint(static_cast<vtkIdType>(i), position);
    if (!std::isfinite(position[0] + position[1] + position[2]))
    {
      Refuse(name,
        "point " + std::to_string(i) + " of the state " + stateNames[state] + " is not finite");
    }
    points[first + i] = glm::dvec3(toView * glm::dvec4(position[0], position[1], position[2], 1.0));
  }
}

void vtkPatternMotionGeometry::AppendNormals(const Surface& surface, vtkPolyData* data)
{
  const std::size_t first = this->Normals.size();
  this->Normals.resize(this->Points[Before].size(), glm::dvec3(0.0));
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  if (!normals)
  {
    return;
  }
  const glm::dmat3 toView = glm::transpose(glm::inverse(glm::dmat3(surface.ToView[Before])));
  for (std::size_t i = first; i < this->Normals.size(); ++i)
  {
    double normal[3];
    normals->GetTuple(static_cast<vtkIdType>(i - first), normal);
    this->Normals[i] = toView * glm::dvec3(normal[0], normal[1], normal[2]);
  }
}

void vtkPatternMotionGeometry::AppendTriangles(
  const std::string& name, int label, int firstPoint, vtkPolyData* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  const auto corner = [&](vtkIdType point)
  {
    if (point < 0 || point >= count)
    {
      Refuse(
        name, "a polygon names point " + std::to_string(point) + " of " + std::to_string(count));
    }
    return firstPoint + static_cast<int>(point);
  };
  vtkIdType size;
  const vtkIdType* points;
  for (vtkIdType cell = 0; cell < data->GetPolys()->GetNumberOfCells(); ++cell)
  {
    data->GetPolys()->GetCellAtId(cell, size, points);
    for (vtkIdType i = 2; i < size; ++i) // a fan, as VTK draws it
    {
      this->Triangles.emplace_back(corner(points[0]), corner(points[i - 1]), corner(points[i]));
    }
  }
  for (vtkIdType cell = 0; cell < data->GetStrips()->GetNumberOfCells(); ++cell)
  {
    data->GetStrips()->GetCellAtId(cell, size, points);
    for (vtkIdType i = 2; i < size; ++i) // which way round does not matter
    {
      this->Triangles.emplace_back(corner(points[i - 2]), corner(points[i - 1]), corner(points[i]));
    }
  }
  this->Labels.resize(this->Triangles.size(), label);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternSurfaceArray.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPatternBlocks.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace
{
// The array of a block, checked.
vtkDataArray* Find(vtkPolyData* block, const std::string& name, int components, bool& ofPoints)
{
  vtkAbstractArray* found = block->GetPointData()->GetAbstractArray(name.c_str());
  ofPoints = found != nullptr;
  found = found ? found : block->GetCellData()->GetAbstractArray(name.c_str());
  auto* array = vtkDataArray::SafeDownCast(found);
  const vtkIdType tuples = ofPoints ? block->GetNumberOfPoints() : block->GetNumberOfCells();
  if (array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() >= tuples)
  {
    return array;
  }
  std::ostringstream text;
  text << "array '" << name << "' ";
  if (!array)
  {
    text << (found ? "is not numeric" : "is missing");
  }
  else
  {
    text << "has " << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components";
  }
  text << "; expected " << components << (components == 1 ? " number" : " numbers")
       << " for every point or cell";
  throw std::invalid_argument(text.str());
}
} // namespace

vtkPatternSurfaceArray::vtkPatternSurfaceArray(vtkDataObject* input,
  const hachure::SurfaceTriangles& surface, const std::string& name, int components)
  : Surface(&surface)
  , Components(components)
{
  for (const vtkPattern::Block& block : vtkPattern::Blocks(input))
  {
    Part part;
    if (block.Data->GetNumberOfPolys() > 0 || block.Data->GetNumberOfStrips() > 0)
    {
      vtkDataArray* array = Find(block.Data, name, components, part.OfPoints);
      const vtkIdType count = array->GetNumberOfTuples();
      part.Values.resize(static_cast<std::size_t>(count * components));
      for (vtkIdType i = 0; i < count; ++i)
      {
        array->GetTuple(i, &part.Values[static_cast<std::size_t>(i * components)]);
      }
    }
    this->Parts.push_back(std::move(part));
  }
}

glm::dvec3 vtkPatternSurfaceArray::Vector(const Part& part, std::size_t tuple) const
{
  glm::dvec3 vector(0.0);
  for (int i = 0; i < this->Components && i < 3; ++i)
  {
    vector[i] =
      part.Values[tuple * static_cast<std::size_t>(this->Components) + static_cast<std::size_t>(i)];
  }
  return vector;
}

double vtkPatternSurfaceArray::Number(std::int32_t triangle, const glm::dvec2& weights) const
{
  const auto index = static_cast<std::size_t>(triangle);
  const auto block = static_cast<std::size_t>(this->Surface->blockIndices[index]);
  const Part& part = this->Parts[block];
  if (!part.OfPoints)
  {
    return part.Values[static_cast<std::size_t>(this->Surface->cells[index])];
  }
  const glm::ivec3 corners =
    this->Surface->triangles[index] - this->Surface->blocks[block].firstPoint;
  return (1.0 - weights.x - weights.y) * part.Values[static_cast<std::size_t>(corners.x)] +
    weights.x * part.Values[static_cast<std::size_t>(corners.y)] +
    weights.y * part.Values[static_cast<std::size_t>(corners.z)];
}

glm::dvec3 vtkPatternSurfaceArray::Line(std::int32_t triangle, const glm::dvec2& weights) const
{
  const auto index = static_cast<std::size_t>(triangle);
  const auto block = static_cast<std::size_t>(this->Surface->blockIndices[index]);
  const Part& part = this->Parts[block];
  const auto known = [](const glm::dvec3& v)
  { return std::isfinite(v.x + v.y + v.z) ? v : glm::dvec3(0.0); };
  if (!part.OfPoints)
  {
    return known(this->Vector(part, static_cast<std::size_t>(this->Surface->cells[index])));
  }
  const glm::ivec3 corners =
    this->Surface->triangles[index] - this->Surface->blocks[block].firstPoint;
  glm::dvec3 sum(0.0);
  glm::dvec3 side(0.0);
  const double shares[] = { 1.0 - weights.x - weights.y, weights.x, weights.y };
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 line = known(this->Vector(part, static_cast<std::size_t>(corners[i])));
    side = side == glm::dvec3(0.0) ? line : side;
    sum += shares[i] * (glm::dot(line, side) < 0.0 ? -line : line);
  }
  return sum;
}

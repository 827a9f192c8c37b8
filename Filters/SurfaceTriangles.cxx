// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTriangles.h"

#include "Core/SurfaceSampling.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace hachure
{
namespace
{
bool isInteger(vtkDataArray* array)
{
  const int type = array->GetDataType();
  return type != VTK_FLOAT && type != VTK_DOUBLE;
}

/// Appends one vtkPolyData after the other.
class TriangleExtractor
{
public:
  TriangleExtractor(SurfaceTriangles& target, const PatchSource& patchSource, TriangleChoice wanted)
    : result(target)
    , source(patchSource)
    , takesAll(wanted == TriangleChoice::All)
    , choice(wanted)
  {
  }

  void add(vtkPolyData* input, unsigned int flatIndex)
  {
    block.flatIndex = flatIndex;
    block.firstPoint = static_cast<std::int32_t>(result.points.size());
    block.firstTriangle = static_cast<std::int32_t>(result.triangles.size());
    result.blocks.push_back(block);
    addPoints(input->GetPoints());
    if (input->GetNumberOfPolys() == 0 && input->GetNumberOfStrips() == 0)
    {
      return;
    }
    patchArray = findPatchArray(input);
    ghosts = vtkUnsignedCharArray::SafeDownCast(
      input->GetCellData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));

    // Cells are numbered vertices first, then lines, polygons and strips.
    cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
    addCells(input->GetPolys(), false);
    addCells(input->GetStrips(), true);
  }

private:
  void addPoints(vtkPoints* points)
  {
    blockPoints = points ? points->GetNumberOfPoints() : 0;
    if (blockPoints > std::numeric_limits<std::int32_t>::max() - block.firstPoint)
    {
      throw std::invalid_argument("The input has more than 2147483647 points");
    }
    result.points.reserve(result.points.size() + blockPoints);
    for (vtkIdType i = 0; i < blockPoints; ++i)
    {
      glm::dvec3 point;
      points->GetPoint(i, &point.x);
      result.nonFinitePoints += isFinite(point) ? 0 : 1;
      result.points.push_back(point);
    }
  }

  static bool isFinite(const glm::dvec3& point)
  {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
  }

  vtkDataArray* findPatchArray(vtkPolyData* input) const
  {
    const std::string& name = source.cellArray;
    if (source.byBlock || name.empty())
    {
      return nullptr;
    }
    const std::string prefix = "Patch array '" + name + "' ";
    const std::string expected = "; expected a cell array of integers with one component";
    vtkAbstractArray* found = input->GetCellData()->GetAbstractArray(name.c_str());
    if (!found)
    {
      const bool isPointArray = input->GetPointData()->GetAbstractArray(name.c_str()) != nullptr;
      const bool isFieldArray = input->GetFieldData()->GetAbstractArray(name.c_str()) != nullptr;
      throw std::invalid_argument(prefix +
        (isPointArray      ? "is a point array"
            : isFieldArray ? "is a field array"
                           : "is missing") +
        blockName() + expected);
    }
    vtkDataArray* array = vtkDataArray::SafeDownCast(found);
    if (!array || !isInteger(array))
    {
      throw std::invalid_argument(
        prefix + "has values of type " + found->GetDataTypeAsString() + blockName() + expected);
    }
    if (array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(prefix + "has " + std::to_string(array->GetNumberOfComponents()) +
        " components" + blockName() + expected);
    }
    if (array->GetNumberOfTuples() != input->GetNumberOfCells())
    {
      throw std::invalid_argument(prefix + "has " + std::to_string(array->GetNumberOfTuples()) +
        " values for " + std::to_string(input->GetNumberOfCells()) + " cells" + blockName());
    }
    return array;
  }

  std::string blockName() const
  {
    return block.flatIndex == 0 ? std::string() : " in block " + std::to_string(block.flatIndex);
  }

  void addCells(vtkCellArray* cells, bool areStrips)
  {
    const auto iterator = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      iterator->GetCurrentCell(size, corners);
      if (isVisible() && hasFiniteCorners(size, corners))
      {
        patch = findPatch();
        areStrips ? addStrip(size, corners) : addPolygon(size, corners);
      }
      ++cell;
    }
  }

  bool isVisible() const
  {
    const int ghost = choice == TriangleChoice::Drawable ? vtkDataSetAttributes::DUPLICATECELL : 0;
    const int skipped = ghost | vtkDataSetAttributes::HIDDENCELL;
    return takesAll || !ghosts || cell >= ghosts->GetNumberOfTuples() ||
      (ghosts->GetValue(cell) & skipped) == 0;
  }

  bool hasFiniteCorners(vtkIdType size, const vtkIdType* corners) const
  {
    bool allFinite = true;
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (corners[i] < 0 || corners[i] >= blockPoints)
      {
        throw std::invalid_argument("Cell " + std::to_string(cell) + blockName() +
          " refers to point " + std::to_string(corners[i]) + "; there are " +
          std::to_string(blockPoints) + " points");
      }
      const bool finite = isFinite(point(corners[i]));
      if (takesAll && !finite)
      {
        throw std::invalid_argument("Point " + std::to_string(corners[i]) + blockName() +
          ", a corner of cell " + std::to_string(cell) + ", has a coordinate that is not finite");
      }
      allFinite = allFinite && finite;
    }
    return allFinite;
  }

  std::int32_t findPatch() const
  {
    if (source.byBlock)
    {
      return static_cast<std::int32_t>(block.flatIndex);
    }
    const double value = patchArray ? patchArray->GetComponent(cell, 0) : 0.0;
    if (value >= maximumPatchCount)
    {
      throw std::invalid_argument("Patch array '" + source.cellArray + "' has the value " +
        patchArray->GetVariantValue(cell).ToString() + blockName() + "; ids must be below " +
        std::to_string(maximumPatchCount));
    }
    return value < 0.0 ? -1 : static_cast<std::int32_t>(value);
  }

  const glm::dvec3& point(vtkIdType id) const { return result.points[block.firstPoint + id]; }

  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (choice == TriangleChoice::Drawable && isDegenerateTriangle(point(a), point(b), point(c)))
    {
      return;
    }
    result.triangles.push_back(
      glm::ivec3(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)) + block.firstPoint);
    result.cells.push_back(cell);
    result.blockIndices.push_back(static_cast<std::int32_t>(result.blocks.size()) - 1);
    if (source.byBlock || !source.cellArray.empty())
    {
      result.patches.push_back(patch);
    }
  }

  void addStrip(vtkIdType size, const vtkIdType* corners)
  {
    for (vtkIdType i = 2; i < size; ++i)
    {
      const vtkIdType odd = i % 2; // every other triangle of a strip is turned over
      addTriangle(corners[i - 2], corners[i - 1 + odd], corners[i - odd]);
    }
  }

  void addPolygon(vtkIdType size, const vtkIdType* corners)
  {
    if (size <= 3 || isFan(size, corners) || !addEars(size, corners))
    {
      for (vtkIdType i = 2; i < size; ++i)
      {
        addTriangle(corners[0], corners[i - 1], corners[i]);
      }
    }
  }

  /// Whether all triangles of the fan around the first corner face the same way: true for every
  /// convex polygon, and then no costly triangulation is needed.
  bool isFan(vtkIdType size, const vtkIdType* corners) const
  {
    const glm::dvec3 first = point(corners[0]);
    glm::dvec3 sum(0.0);
    for (vtkIdType i = 2; i < size; ++i)
    {
      sum += glm::cross(point(corners[i - 1]) - first, point(corners[i]) - first);
    }
    for (vtkIdType i = 2; i < size; ++i)
    {
      const glm::dvec3 area = glm::cross(point(corners[i - 1]) - first, point(corners[i]) - first);
      if (glm::dot(area, sum) < 0.0)
      {
        return false;
      }
    }
    return true;
  }

  bool addEars(vtkIdType size, const vtkIdType* corners)
  {
    polygon->GetPoints()->SetDataTypeToDouble();
    polygon->GetPoints()->SetNumberOfPoints(size);
    polygon->GetPointIds()->SetNumberOfIds(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      polygon->GetPoints()->SetPoint(i, &point(corners[i]).x);
      polygon->GetPointIds()->SetId(i, i);
    }
    // Ids and points, although points are not needed: every VTK has this form.
    if (!polygon->Triangulate(0, ears, earPoints) || ears->GetNumberOfIds() == 0)
    {
      return false;
    }
    for (vtkIdType i = 0; i + 2 < ears->GetNumberOfIds(); i += 3)
    {
      addTriangle(
        corners[ears->GetId(i)], corners[ears->GetId(i + 1)], corners[ears->GetId(i + 2)]);
    }
    return true;
  }

  SurfaceTriangles& result;
  const PatchSource& source;
  const bool takesAll;
  const TriangleChoice choice;
  SurfaceTriangles::Block block;
  vtkDataArray* patchArray = nullptr;
  vtkUnsignedCharArray* ghosts = nullptr;
  vtkIdType blockPoints = 0;
  vtkIdType cell = 0;
  std::int32_t patch = 0;
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> ears;
  vtkNew<vtkPoints> earPoints;
};

void addBlocks(vtkCompositeDataSet* input, TriangleExtractor& extractor)
{
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(input->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    vtkPolyData* polyData = vtkPolyData::SafeDownCast(leaf);
    if (!polyData)
    {
      throw std::invalid_argument("Block " + std::to_string(iterator->GetCurrentFlatIndex()) +
        " is a " + leaf->GetClassName() + "; expected a vtkPolyData");
    }
    extractor.add(polyData, iterator->GetCurrentFlatIndex());
  }
}
} // namespace

TriangleMesh SurfaceTriangles::blockMesh(std::size_t block) const
{
  const std::size_t begin = this->blocks[block].firstTriangle;
  const std::size_t end = block + 1 < this->blocks.size() ? this->blocks[block + 1].firstTriangle
                                                          : this->triangles.size();
  TriangleMesh all = this->mesh();
  all.triangles = all.triangles.subspan(begin, end - begin);
  all.patches = all.patches.empty() ? all.patches : all.patches.subspan(begin, end - begin);
  return all;
}

SurfaceTriangles extractSurfaceTriangles(
  vtkDataObject* input, const PatchSource& source, TriangleChoice choice)
{
  SurfaceTriangles result;
  TriangleExtractor extractor(result, source, choice);
  if (vtkPolyData* polyData = vtkPolyData::SafeDownCast(input))
  {
    extractor.add(polyData, 0);
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    addBlocks(composite, extractor);
  }
  else if (input)
  {
    throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
      "; expected a vtkPolyData or a composite of vtkPolyData");
  }
  return result;
}
} // namespace hachure

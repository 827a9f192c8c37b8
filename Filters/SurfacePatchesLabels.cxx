// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatchesInput.h"

#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkExtractSelection.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace hachure
{
namespace
{
const char* const expectedArray =
  "; expected a cell or point array of integers or strings with one component";

/// An array of one block, read as labels.
class LabelArray
{
public:
  LabelArray(vtkPolyData* block, unsigned int flatIndex, const std::string& name)
  {
    const std::string where = flatIndex == 0 ? "" : " in block " + std::to_string(flatIndex);
    prefix = "Patch array '" + name + "' ";
    suffix = where + expectedArray;
    array = block->GetCellData()->GetAbstractArray(name.c_str());
    ofPoints = array == nullptr;
    array = ofPoints ? block->GetPointData()->GetAbstractArray(name.c_str()) : array;
    if (!array)
    {
      throw std::invalid_argument(prefix + "is missing" + suffix);
    }
    numbers = vtkDataArray::SafeDownCast(array);
    texts = vtkStringArray::SafeDownCast(array);
    const vtkIdType expected = ofPoints ? block->GetNumberOfPoints() : block->GetNumberOfCells();
    if (!numbers && !texts)
    {
      throw std::invalid_argument(
        prefix + "has values of type " + array->GetDataTypeAsString() + suffix);
    }
    if (array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(
        prefix + "has " + std::to_string(array->GetNumberOfComponents()) + " components" + suffix);
    }
    if (array->GetNumberOfTuples() != expected)
    {
      throw std::invalid_argument(prefix + "has " + std::to_string(array->GetNumberOfTuples()) +
        " values for " + std::to_string(expected) + (ofPoints ? " points" : " cells") + where);
    }
  }

  bool isOfPoints() const { return ofPoints; }
  vtkStringArray* strings() const { return texts; }

  std::int64_t label(vtkIdType index, const std::vector<std::string>& names) const
  {
    if (texts)
    {
      return std::lower_bound(names.begin(), names.end(), texts->GetValue(index)) - names.begin();
    }
    const int type = numbers->GetDataType();
    if (type != VTK_FLOAT && type != VTK_DOUBLE)
    {
      return numbers->GetVariantValue(index).ToTypeInt64();
    }
    const double value = numbers->GetComponent(index, 0);
    const double largestExact = 9007199254740992.0; // 2^53
    if (!(std::abs(value) <= largestExact) || value != std::floor(value))
    {
      throw std::invalid_argument(prefix + "has the value " +
        numbers->GetVariantValue(index).ToString() + " at " + (ofPoints ? "point " : "cell ") +
        std::to_string(index) + suffix);
    }
    return static_cast<std::int64_t>(value);
  }

private:
  std::string prefix;
  std::string suffix;
  vtkAbstractArray* array = nullptr;
  vtkDataArray* numbers = nullptr;
  vtkStringArray* texts = nullptr;
  bool ofPoints = false;
};

/// The most frequent value, the lowest of several.
std::int64_t mostFrequent(std::vector<std::int64_t>& values)
{
  std::sort(values.begin(), values.end());
  std::int64_t best = values.front();
  std::ptrdiff_t most = 0;
  for (auto begin = values.begin(); begin != values.end();)
  {
    const auto end = std::upper_bound(begin, values.end(), *begin);
    if (end - begin > most)
    {
      most = end - begin;
      best = *begin;
    }
    begin = end;
  }
  return best;
}

/// All strings of all blocks, in alphabetical order.
std::vector<std::string> collectNames(const std::vector<LabelArray>& arrays)
{
  std::set<std::string> names;
  for (const LabelArray& array : arrays)
  {
    for (vtkIdType i = 0; array.strings() && i < array.strings()->GetNumberOfValues(); ++i)
    {
      names.insert(array.strings()->GetValue(i));
    }
  }
  return { names.begin(), names.end() };
}

/// The insidedness array of the cells of every block, null where nothing of it was selected.
std::vector<vtkDataArray*> selectedCells(vtkDataObject* input, vtkDataObject* selected)
{
  const auto cellsOf = [](vtkDataObject* data) -> vtkDataArray*
  {
    vtkPolyData* polyData = vtkPolyData::SafeDownCast(data);
    return polyData ? polyData->GetCellData()->GetArray("vtkInsidedness") : nullptr;
  };
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  vtkCompositeDataSet* selectedComposite = vtkCompositeDataSet::SafeDownCast(selected);
  if (!composite || !selectedComposite)
  {
    return { cellsOf(selected) };
  }
  std::vector<vtkDataArray*> result;
  const auto position = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (position->InitTraversal(); !position->IsDoneWithTraversal(); position->GoToNextItem())
  {
    result.push_back(cellsOf(selectedComposite->GetDataSet(position)));
  }
  return result;
}
} // namespace

std::vector<std::int64_t> labelsFromArray(
  const PatchSurface& surface, vtkDataObject* input, const std::string& name)
{
  const std::vector<vtkPolyData*> blocks = polyDataBlocks(input);
  std::vector<LabelArray> arrays;
  std::vector<std::int32_t> arrayOfBlock(blocks.size(), -1); // blocks without faces need none
  for (const PatchSurface::FaceCell& cell : surface.cells)
  {
    if (arrayOfBlock[cell.block] < 0)
    {
      arrayOfBlock[cell.block] = static_cast<std::int32_t>(arrays.size());
      arrays.emplace_back(blocks[cell.block], surface.triangles.blocks[cell.block].flatIndex, name);
    }
  }
  const std::vector<std::string> names = collectNames(arrays);
  std::vector<std::int64_t> labels;
  labels.reserve(surface.cells.size());
  std::size_t triangle = 0;
  for (std::size_t face = 0; face < surface.cells.size(); ++face)
  {
    const PatchSurface::FaceCell& cell = surface.cells[face];
    const LabelArray& array = arrays[arrayOfBlock[cell.block]];
    std::set<std::int32_t> corners;
    for (; triangle < surface.faces.size() && surface.faces[triangle] == static_cast<int>(face);
         ++triangle)
    {
      const glm::ivec3 ids = surface.triangles.triangles[triangle];
      if (array.isOfPoints())
      {
        corners.insert({ ids.x, ids.y, ids.z });
      }
    }
    std::vector<std::int64_t> values;
    values.reserve(corners.size());
    for (const std::int32_t corner : corners)
    {
      values.push_back(
        array.label(corner - surface.triangles.blocks[cell.block].firstPoint, names));
    }
    labels.push_back(array.isOfPoints() ? mostFrequent(values) : array.label(cell.cell, names));
  }
  return labels;
}

namespace
{
/// A check for what vtkExtractSelection cannot extract; debug builds of it abort.
void requireExtractable(vtkSelectionNode* node, unsigned int index)
{
  const int content = node->GetContentType();
  if (content < vtkSelectionNode::GLOBALIDS || content > vtkSelectionNode::BLOCK_SELECTORS)
  {
    const char* name = content < 0 ? "none" : vtkSelectionNode::GetContentTypeAsString(content);
    throw std::invalid_argument("Selection node " + std::to_string(index) +
      " has the content type " + name + "; expected one from GLOBALIDS to BLOCK_SELECTORS, as ids");
  }
}
} // namespace

std::vector<std::int64_t> labelsFromSelection(
  const PatchSurface& surface, vtkDataObject* input, vtkSelection* selection)
{
  std::vector<std::int64_t> labels(surface.cells.size(), 0);
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkNew<vtkSelectionNode> node;
    node->ShallowCopy(selection->GetNode(i));
    requireExtractable(node, i);
    if (node->GetFieldType() == vtkSelectionNode::POINT)
    {
      node->GetProperties()->Set(vtkSelectionNode::CONTAINING_CELLS(), 1);
    }
    vtkNew<vtkSelection> single;
    single->AddNode(node);
    vtkNew<vtkExtractSelection> extract;
    extract->PreserveTopologyOn();
    extract->SetInputDataObject(0, input);
    extract->SetInputDataObject(1, single);
    extract->Update();
    const std::vector<vtkDataArray*> selected =
      selectedCells(input, extract->GetOutputDataObject(0));
    for (std::size_t face = 0; face < labels.size(); ++face)
    {
      const PatchSurface::FaceCell& cell = surface.cells[face];
      vtkDataArray* inside = selected[cell.block];
      if (labels[face] == 0 && inside && inside->GetComponent(cell.cell, 0) > 0.0)
      {
        labels[face] = static_cast<std::int64_t>(i) + 1;
      }
    }
  }
  return labels;
}
} // namespace hachure

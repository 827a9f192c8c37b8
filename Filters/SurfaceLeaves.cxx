// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceLeaves.h"

#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkPolyData.h>

namespace hachure
{
namespace
{
vtkSmartPointer<vtkDataObjectTreeIterator> leavesOf(vtkDataObjectTree* tree)
{
  auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  iterator->VisitOnlyLeavesOn();
  iterator->SkipEmptyNodesOff();
  iterator->InitTraversal();
  return iterator;
}
} // namespace

std::vector<vtkPolyData*> surfaceLeaves(vtkDataObject* surface)
{
  if (auto* block = vtkPolyData::SafeDownCast(surface))
  {
    return { block };
  }
  std::vector<vtkPolyData*> leaves;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(surface))
  {
    for (auto leaf = leavesOf(tree); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      leaves.push_back(vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject()));
    }
  }
  return leaves;
}

vtkSmartPointer<vtkDataObject> withLeaves(
  vtkDataObject* surface, const std::vector<vtkSmartPointer<vtkPolyData>>& leaves)
{
  auto result = vtkSmartPointer<vtkDataObject>::Take(surface->NewInstance());
  auto* tree = vtkDataObjectTree::SafeDownCast(surface);
  auto* copy = vtkDataObjectTree::SafeDownCast(result);
  if (!tree || !copy)
  {
    if (!leaves.empty() && leaves.front())
    {
      result->ShallowCopy(leaves.front());
    }
    return result;
  }
  copy->CopyStructure(tree);
  if (tree->GetFieldData())
  {
    copy->GetFieldData()->PassData(tree->GetFieldData());
  }
  std::size_t next = 0;
  for (auto leaf = leavesOf(tree); !leaf->IsDoneWithTraversal() && next < leaves.size();
       leaf->GoToNextItem())
  {
    if (leaves[next])
    {
      copy->SetDataSetFrom(leaf, leaves[next]);
    }
    ++next;
  }
  return result;
}

void copyDataTime(vtkDataObject* from, vtkDataObject* to)
{
  vtkInformationDoubleKey* time = vtkDataObject::DATA_TIME_STEP();
  if (from->GetInformation()->Has(time))
  {
    to->GetInformation()->Set(time, from->GetInformation()->Get(time));
  }
}
} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternBlocks.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace
{
void AppendVisible(vtkDataObject* node, bool visible, vtkCompositeDataDisplayAttributes* attributes,
  std::vector<bool>& leaves)
{
  if (node && attributes->HasBlockVisibility(node))
  {
    visible = attributes->GetBlockVisibility(node);
  }
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      AppendVisible(blocks->GetBlock(i), visible, attributes, leaves);
    }
  }
  else if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(node))
  {
    for (unsigned int i = 0; i < pieces->GetNumberOfPartitions(); ++i)
    {
      AppendVisible(pieces->GetPartitionAsDataObject(i), visible, attributes, leaves);
    }
  }
  else
  {
    leaves.push_back(visible);
  }
}
} // namespace

namespace vtkPattern
{
std::vector<bool> VisibleLeaves(vtkDataObject* input, vtkCompositeDataDisplayAttributes* attributes)
{
  std::vector<bool> leaves;
  AppendVisible(input, true, attributes, leaves);
  return leaves;
}

std::vector<Block> Blocks(vtkDataObject* input)
{
  std::vector<Block> blocks;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> iterator;
    iterator.TakeReference(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (auto* block = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        blocks.push_back({ block, iterator->GetCurrentFlatIndex() });
      }
    }
  }
  else if (auto* block = vtkPolyData::SafeDownCast(input))
  {
    blocks.push_back({ block, 0 });
  }
  return blocks;
}
} // namespace vtkPattern

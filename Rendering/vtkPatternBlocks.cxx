// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace vtkPattern
{
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

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternGeometry.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPatternBlocks.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{
std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  hash ^= value + 0x9e3779b97f4a7c15ULL + (hash << 6) + (hash >> 2);
  return hash;
}

// Content of a cell array: filters often hand over equal connectivity in a new array.
std::uint64_t HashCells(vtkCellArray* cells)
{
  std::uint64_t hash = static_cast<std::uint64_t>(cells->GetNumberOfCells());
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  const vtkIdType count = connectivity->GetNumberOfValues();
  for (vtkIdType i = 0; i < count; ++i)
  {
    hash = Mix(hash, static_cast<std::uint64_t>(connectivity->GetComponent(i, 0)));
  }
  return hash;
}

} // namespace

std::vector<vtkPatternGeometry::Block> vtkPatternGeometry::Collect(vtkDataObject* input) const
{
  const std::vector<Block>& previous = this->Blocks;
  std::vector<Block> blocks;
  for (const vtkPattern::Block& found : vtkPattern::Blocks(input))
  {
    vtkPolyData* leaf = found.Data;
    if (!leaf->GetPoints())
    {
      continue;
    }
    Block block;
    block.Data = leaf;
    block.FlatIndex = found.FlatIndex;
    block.PointCount = static_cast<std::uint64_t>(leaf->GetNumberOfPoints());
    block.PointTime =
      std::max(leaf->GetPoints()->GetMTime(), leaf->GetPoints()->GetData()->GetMTime());
    block.CellTime = std::max(leaf->GetPolys()->GetMTime(), leaf->GetStrips()->GetMTime());
    const std::size_t index = blocks.size();
    const bool known = index < previous.size() && previous[index].CellTime == block.CellTime &&
      previous[index].PointCount == block.PointCount;
    block.CellHash = known ? previous[index].CellHash
                           : Mix(HashCells(leaf->GetPolys()), HashCells(leaf->GetStrips()));
    blocks.push_back(block);
  }
  return blocks;
}

vtkPatternGeometry::Change vtkPatternGeometry::Update(vtkDataObject* input)
{
  std::vector<Block> blocks = this->Collect(input);
  bool sameCells = this->Known && blocks.size() == this->Blocks.size();
  bool samePoints = sameCells;
  for (std::size_t i = 0; sameCells && i < blocks.size(); ++i)
  {
    sameCells = blocks[i].CellHash == this->Blocks[i].CellHash &&
      blocks[i].PointCount == this->Blocks[i].PointCount;
    samePoints = samePoints && blocks[i].PointTime == this->Blocks[i].PointTime &&
      blocks[i].Data == this->Blocks[i].Data;
  }
  this->Blocks = std::move(blocks);
  this->Known = true;
  return !sameCells ? REPLACED : samePoints ? NOTHING : MOVED;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWholeSurface.h"

#include "SurfaceLeaves.h"
#include "WholeSurfaceLeaf.h"

#include <vtkCellData.h>
#include <vtkCommunicator.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkWholeSurface);

struct vtkWholeSurface::Internals
{
  std::vector<hachure::WholeSurfaceLeaf> Leaves;
  std::size_t Rank = 0;
};

namespace
{
using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;

vtkInformationObjectBaseKey* WholeKey()
{
  static vtkInformationObjectBaseKey* key =
    vtkInformationObjectBaseKey::MakeKey("WHOLE", "vtkWholeSurface");
  return key;
}

bool IsAlone(vtkMultiProcessController* controller)
{
  return !controller || controller->GetNumberOfProcesses() < 2;
}

vtkIdType CountPolygons(vtkDataObject* input)
{
  vtkIdType count = 0;
  for (vtkPolyData* leaf : hachure::surfaceLeaves(input))
  {
    count += leaf ? leaf->GetNumberOfPolys() + leaf->GetNumberOfStrips() : 0;
  }
  return count;
}

// The polygons of every leaf, of every process.
std::vector<Parts> Gathered(vtkDataObject* input, vtkMultiProcessController* controller)
{
  vtkNew<vtkMultiBlockDataSet> own;
  unsigned int count = 0;
  for (vtkPolyData* leaf : hachure::surfaceLeaves(input))
  {
    own->SetBlock(count++, hachure::polygonsOf(leaf));
  }
  std::vector<vtkSmartPointer<vtkDataObject>> all;
  if (IsAlone(controller))
  {
    all.emplace_back(own);
  }
  else
  {
    controller->AllGather(own, all);
  }
  std::vector<Parts> leaves(count);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    leaves[leaf].reserve(all.size());
    for (const auto& process : all)
    {
      auto* blocks = vtkMultiBlockDataSet::SafeDownCast(process);
      auto* part = vtkPolyData::SafeDownCast(blocks->GetBlock(static_cast<unsigned int>(leaf)));
      leaves[leaf].push_back(part ? part : vtkSmartPointer<vtkPolyData>::New().Get());
    }
  }
  return leaves;
}

hachure::CellBox BoxOf(const std::vector<Parts>& leaves)
{
  hachure::CellBox box;
  for (const Parts& parts : leaves)
  {
    for (vtkPolyData* part : parts)
    {
      hachure::addPolygons(part, box);
    }
  }
  return box;
}

// Adds the arrays that the filter has added or replaced, by the number that `numberOf` gives.
template <class NumberOf>
void AddArrays(vtkDataSetAttributes* before, vtkDataSetAttributes* after, vtkIdType count,
  const NumberOf& numberOf, vtkDataSetAttributes* part)
{
  for (int i = 0; i < after->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = after->GetArray(i);
    if (!array || !array->GetName() || before->GetArray(array->GetName()) == array)
    {
      continue;
    }
    const auto taken = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    taken->SetName(array->GetName());
    taken->SetNumberOfComponents(array->GetNumberOfComponents());
    taken->SetNumberOfTuples(count);
    for (vtkIdType tuple = 0; tuple < count; ++tuple)
    {
      const vtkIdType number = numberOf(tuple);
      for (int component = 0; component < array->GetNumberOfComponents(); ++component)
      {
        taken->SetComponent(
          tuple, component, number < 0 ? -1.0 : array->GetComponent(number, component));
      }
    }
    part->AddArray(taken);
  }
  for (int i = before->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const char* const name = before->GetArrayName(i);
    if (name && !after->HasArray(name))
    {
      part->RemoveArray(name);
    }
  }
}
} // namespace

vtkWholeSurface::vtkWholeSurface()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Internal(std::make_unique<Internals>())
{
  this->SetNumberOfOutputPorts(2);
}

vtkWholeSurface::~vtkWholeSurface() = default;

void vtkWholeSurface::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkWholeSurface::GetController()
{
  return this->Controller;
}

void vtkWholeSurface::SetFilter(vtkAlgorithm* filter)
{
  if (this->Filter != filter)
  {
    this->Filter = filter;
    this->Modified();
  }
}

vtkAlgorithm* vtkWholeSurface::GetFilter()
{
  return this->Filter;
}

vtkMTimeType vtkWholeSurface::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Filter ? std::max(own, this->Filter->GetMTime()) : own;
}

vtkDataObject* vtkWholeSurface::GetWhole(vtkDataObject* part)
{
  for (vtkPolyData* leaf : hachure::surfaceLeaves(part))
  {
    vtkDataArray* ids = leaf ? leaf->GetCellData()->GetArray(GetCellIdsName()) : nullptr;
    if (ids && ids->HasInformation() && ids->GetInformation()->Has(WholeKey()))
    {
      return vtkDataObject::SafeDownCast(ids->GetInformation()->Get(WholeKey()));
    }
  }
  return nullptr;
}

int vtkWholeSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

// All processes say the same.
bool vtkWholeSurface::CanBeWhole(vtkDataObject* input)
{
  const auto leaves = static_cast<vtkIdType>(hachure::surfaceLeaves(input).size());
  vtkIdType own[3] = { CountPolygons(input), leaves, -leaves };
  vtkIdType cells = own[0];
  vtkIdType most[2] = { leaves, -leaves };
  if (!IsAlone(this->Controller))
  {
    this->Controller->AllReduce(own, &cells, 1, vtkCommunicator::SUM_OP);
    this->Controller->AllReduce(own + 1, most, 2, vtkCommunicator::MAX_OP);
  }
  if (most[0] != -most[1])
  {
    vtkErrorMacro("input: processes have " << -most[1] << " to " << most[0]
                                           << " blocks, expected the same structure in all; "
                                              "every process draws its part by itself");
    return false;
  }
  if (cells > this->MaximumNumberOfCells)
  {
    vtkErrorMacro("input: " << cells << " polygons in all processes, expected at most "
                            << this->MaximumNumberOfCells
                            << " (MaximumNumberOfCells); every process draws its part by itself");
    return false;
  }
  return true;
}

vtkSmartPointer<vtkDataObject> vtkWholeSurface::Filtered(vtkDataObject* surface)
{
  if (!this->Filter)
  {
    return surface;
  }
  this->Filter->SetInputDataObject(surface);
  this->Filter->Update();
  auto result = vtkSmartPointer<vtkDataObject>::Take(surface->NewInstance());
  result->ShallowCopy(this->Filter->GetOutputDataObject(0));
  this->Filter->SetInputDataObject(nullptr);
  return result;
}

int vtkWholeSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* part = vtkDataObject::GetData(outputVector, 0);
  vtkDataObject* whole = vtkDataObject::GetData(outputVector, 1);
  if (!this->CanBeWhole(input))
  {
    part->ShallowCopy(this->Filtered(input));
    return 1;
  }
  const std::vector<Parts> leaves = Gathered(input, this->Controller);
  this->UpdateProgress(0.3);
  this->Internal->Leaves.resize(leaves.size());
  this->Internal->Rank =
    IsAlone(this->Controller) ? 0 : static_cast<std::size_t>(this->Controller->GetLocalProcessId());
  std::vector<vtkSmartPointer<vtkPolyData>> blocks;
  blocks.reserve(leaves.size());
  std::optional<hachure::CellBox> box;
  const auto boxOfAll = [&]()
  {
    box = box ? box : BoxOf(leaves);
    return *box;
  };
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    this->Internal->Leaves[i].assemble(leaves[i], boxOfAll);
    blocks.emplace_back(this->Internal->Leaves[i].whole());
  }
  this->UpdateProgress(0.7);
  const auto assembled = hachure::withLeaves(input, blocks);
  hachure::copyDataTime(input, assembled);
  const vtkSmartPointer<vtkDataObject> filtered = this->Filtered(assembled);
  hachure::copyDataTime(input, filtered);
  whole->ShallowCopy(filtered);
  hachure::copyDataTime(input, whole);
  std::vector<vtkSmartPointer<vtkPolyData>> own;
  for (vtkPolyData* leaf : hachure::surfaceLeaves(input))
  {
    own.push_back(hachure::withoutGhosts(leaf));
  }
  part->ShallowCopy(hachure::withLeaves(input, own));
  hachure::copyDataTime(input, part);
  this->StorePart(assembled, filtered, part);
  return 1;
}

// The part's leaves are its own, but for their arrays.
void vtkWholeSurface::StorePart(
  vtkDataObject* assembled, vtkDataObject* filtered, vtkDataObject* part)
{
  const auto before = hachure::surfaceLeaves(assembled);
  const auto after = hachure::surfaceLeaves(filtered);
  const auto own = hachure::surfaceLeaves(part);
  const std::size_t rank = this->Internal->Rank;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    if (!own[i])
    {
      continue;
    }
    const hachure::WholeSurfaceLeaf& leaf = this->Internal->Leaves[i];
    const vtkIdType others = own[i]->GetNumberOfVerts() + own[i]->GetNumberOfLines();
    const auto cellOf = [&](vtkIdType cell)
    { return cell < others ? -1 : leaf.cellOf(rank, cell - others); };
    const auto pointOf = [&](vtkIdType point) { return leaf.pointOf(rank, point); };
    AddArrays(before[i]->GetCellData(), after[i]->GetCellData(), own[i]->GetNumberOfCells(), cellOf,
      own[i]->GetCellData());
    AddArrays(before[i]->GetPointData(), after[i]->GetPointData(), own[i]->GetNumberOfPoints(),
      pointOf, own[i]->GetPointData());
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(GetCellIdsName());
    ids->SetNumberOfTuples(own[i]->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < own[i]->GetNumberOfCells(); ++cell)
    {
      ids->SetValue(cell, cellOf(cell));
    }
    ids->GetInformation()->Set(WholeKey(), filtered);
    own[i]->GetCellData()->AddArray(ids);
  }
}

void vtkWholeSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "Filter: " << this->Filter.Get() << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfacePart.h"

#include "Core/NearCells.h"
#include "SurfaceLeaves.h"
#include "WholeSurfaceLeaf.h"
#include "vtkWholeSurface.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkSurfacePart);

namespace
{
const char* const notDrawn = "NotDrawn";

vtkInformationObjectBaseKey* PointsKey()
{
  static vtkInformationObjectBaseKey* key =
    vtkInformationObjectBaseKey::MakeKey("POINTS_OF_WHOLE", "vtkSurfacePart");
  return key;
}

vtkDataArray* CellIds(vtkPolyData* block)
{
  return block->GetCellData()->GetArray(vtkWholeSurface::GetCellIdsName());
}

// Which polygons of the whole's block a part has; empty where the part cannot be told.
std::vector<std::uint8_t> OwnedCells(vtkPolyData* part, vtkPolyData* whole)
{
  std::vector<std::uint8_t> owned(static_cast<std::size_t>(whole->GetNumberOfPolys()), 0);
  vtkDataArray* ids = part ? CellIds(part) : nullptr;
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
    if (id >= 0 && id < whole->GetNumberOfPolys())
    {
      owned[static_cast<std::size_t>(id)] = 1;
    }
  }
  return owned;
}

std::vector<vtkIdType> Chosen(const std::vector<std::uint8_t>& owned)
{
  std::vector<vtkIdType> cells;
  for (std::size_t i = 0; i < owned.size(); ++i)
  {
    if (owned[i] != 0)
    {
      cells.push_back(static_cast<vtkIdType>(i));
    }
  }
  return cells;
}

// Some polygons of a block, with its points.
vtkSmartPointer<vtkPolyData> Polygons(vtkPolyData* whole, const std::vector<vtkIdType>& cells)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  vtkNew<vtkIdTypeArray> ids;
  const auto count = static_cast<vtkIdType>(cells.size());
  from->SetNumberOfIds(count);
  to->SetNumberOfIds(count);
  ids->SetName(vtkWholeSurface::GetCellIdsName());
  ids->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType cell = cells[static_cast<std::size_t>(i)];
    whole->GetPolys()->GetCellAtId(cell, corners);
    polygons->InsertNextCell(corners);
    from->SetId(i, cell);
    to->SetId(i, i);
    ids->SetValue(i, cell);
  }
  result->SetPoints(whole->GetPoints());
  result->SetPolys(polygons);
  result->GetPointData()->ShallowCopy(whole->GetPointData());
  result->GetCellData()->CopyAllOn();
  result->GetCellData()->CopyAllocate(whole->GetCellData(), count);
  result->GetCellData()->SetNumberOfTuples(count);
  result->GetCellData()->CopyData(whole->GetCellData(), from, to);
  result->GetCellData()->AddArray(ids);
  return result;
}

vtkSmartPointer<vtkCellArray> Shifted(vtkCellArray* cells, vtkIdType shift)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      corners->SetId(i, corners->GetId(i) + shift);
    }
    result->InsertNextCell(corners);
  }
  return result;
}

// Tuples of the same array behind each other; those that the first one lacks are left out.
void Append(vtkDataSetAttributes* first, vtkIdType firstCount, vtkDataSetAttributes* second,
  vtkIdType secondCount, vtkDataSetAttributes* result)
{
  result->CopyAllOn();
  result->CopyAllocate(first, firstCount + secondCount);
  result->SetNumberOfTuples(firstCount + secondCount);
  for (int i = 0; i < result->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = result->GetAbstractArray(i);
    vtkAbstractArray* other =
      array->GetName() ? second->GetAbstractArray(array->GetName()) : nullptr;
    vtkAbstractArray* own = first->GetAbstractArray(array->GetName());
    if (own && firstCount > 0)
    {
      array->InsertTuples(0, firstCount, 0, own);
    }
    if (other && other->GetNumberOfComponents() == array->GetNumberOfComponents() &&
      secondCount > 0)
    {
      array->InsertTuples(firstCount, secondCount, 0, other);
    }
  }
}

// A part's vertices and lines, before polygons of the whole.
vtkSmartPointer<vtkPolyData> WithLines(vtkPolyData* part, vtkPolyData* polygons)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  const vtkIdType shift = polygons->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(part->GetPoints()->GetDataType());
  points->SetNumberOfPoints(shift + part->GetNumberOfPoints());
  if (shift > 0)
  {
    points->GetData()->InsertTuples(0, shift, 0, polygons->GetPoints()->GetData());
  }
  points->GetData()->InsertTuples(
    shift, part->GetNumberOfPoints(), 0, part->GetPoints()->GetData());
  result->SetPoints(points);
  result->SetVerts(Shifted(part->GetVerts(), shift));
  result->SetLines(Shifted(part->GetLines(), shift));
  result->SetPolys(polygons->GetPolys());
  vtkPolyData* layout = shift > 0 ? polygons : part;
  if (layout == polygons)
  {
    Append(polygons->GetPointData(), shift, part->GetPointData(), part->GetNumberOfPoints(),
      result->GetPointData());
  }
  else
  {
    result->GetPointData()->ShallowCopy(part->GetPointData());
  }
  Append(part->GetCellData(), part->GetNumberOfVerts() + part->GetNumberOfLines(),
    polygons->GetCellData(), polygons->GetNumberOfPolys(), result->GetCellData());
  return result;
}

vtkSmartPointer<vtkPolyData> DrawnBlock(
  vtkPolyData* part, vtkPolyData* whole, const std::vector<std::uint8_t>& owned)
{
  const bool all = std::find(owned.begin(), owned.end(), 0) == owned.end();
  const bool lines = part && part->GetNumberOfVerts() + part->GetNumberOfLines() > 0;
  if (all && !lines)
  {
    return whole;
  }
  const vtkSmartPointer<vtkPolyData> polygons = Polygons(whole, Chosen(owned));
  vtkSmartPointer<vtkPolyData> drawn = lines ? WithLines(part, polygons) : polygons;
  CellIds(drawn)->GetInformation()->Set(PointsKey(), whole->GetPoints());
  return drawn;
}

std::vector<std::int64_t> Numbers(vtkDataArray* array)
{
  std::vector<std::int64_t> numbers;
  const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
  numbers.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers.push_back(static_cast<std::int64_t>(array->GetComponent(i, 0)));
  }
  return numbers;
}

vtkSmartPointer<vtkPolyData> SurroundingBlock(
  vtkPolyData* whole, const std::vector<std::uint8_t>& owned, double distance)
{
  std::vector<glm::dvec3> points(static_cast<std::size_t>(whole->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    whole->GetPoint(static_cast<vtkIdType>(i), &points[i][0]);
  }
  const std::vector<std::int64_t> offsets = Numbers(whole->GetPolys()->GetOffsetsArray());
  const std::vector<std::int64_t> corners = Numbers(whole->GetPolys()->GetConnectivityArray());
  const std::vector<std::int64_t> near =
    hachure::nearCells(points, { offsets, corners }, owned, distance);
  if (near.empty())
  {
    return nullptr;
  }
  vtkSmartPointer<vtkPolyData> block =
    Polygons(whole, std::vector<vtkIdType>(near.begin(), near.end()));
  vtkNew<vtkUnsignedCharArray> mark;
  mark->SetName(notDrawn);
  mark->InsertNextValue(1);
  CellIds(block)->GetInformation()->Set(PointsKey(), whole->GetPoints());
  block->GetFieldData()->AddArray(mark);
  return block;
}

double DiagonalOf(const std::vector<vtkPolyData*>& leaves)
{
  vtkBoundingBox box;
  for (vtkPolyData* leaf : leaves)
  {
    if (leaf && leaf->GetNumberOfPoints() > 0)
    {
      box.AddBounds(leaf->GetBounds());
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

vtkSmartPointer<vtkMultiBlockDataSet> AsComposite(vtkDataObject* part)
{
  auto composite = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(part))
  {
    composite->ShallowCopy(blocks);
  }
  else
  {
    composite->SetBlock(0, part);
  }
  return composite;
}
} // namespace

vtkSurfacePart::vtkSurfacePart()
{
  this->SetNumberOfInputPorts(2);
}

bool vtkSurfacePart::IsSurroundings(vtkPolyData* block)
{
  return block->GetFieldData() && block->GetFieldData()->HasArray(notDrawn);
}

vtkPoints* vtkSurfacePart::GetPointsOfWhole(vtkPolyData* block)
{
  vtkDataArray* ids = CellIds(block);
  const bool known = ids && ids->HasInformation() && ids->GetInformation()->Has(PointsKey());
  return known ? vtkPoints::SafeDownCast(ids->GetInformation()->Get(PointsKey()))
               : block->GetPoints();
}

int vtkSurfacePart::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkSurfacePart::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* part = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* whole = vtkDataObject::GetData(inputVector[1]);
  auto* output = vtkMultiBlockDataSet::GetData(outputVector);
  whole = whole ? whole : vtkWholeSurface::GetWhole(part);
  const vtkSmartPointer<vtkMultiBlockDataSet> composite = AsComposite(part);
  const auto own = hachure::surfaceLeaves(composite);
  const auto all = hachure::surfaceLeaves(whole);
  output->ShallowCopy(composite);
  if (!whole || own.size() != all.size())
  {
    return 1;
  }
  const double distance = this->Surroundings * DiagonalOf(all);
  std::vector<vtkSmartPointer<vtkPolyData>> drawn;
  std::vector<vtkSmartPointer<vtkPolyData>> surroundings;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (!all[i] || all[i]->GetNumberOfPolys() == 0)
    {
      drawn.emplace_back(own[i]);
      continue;
    }
    const std::vector<std::uint8_t> owned = OwnedCells(own[i], all[i]);
    drawn.push_back(DrawnBlock(own[i], all[i], owned));
    if (drawn.back() != all[i])
    {
      surroundings.push_back(SurroundingBlock(all[i], owned, distance));
    }
  }
  output->ShallowCopy(hachure::withLeaves(composite, drawn));
  for (vtkPolyData* block : surroundings)
  {
    if (block)
    {
      output->SetBlock(output->GetNumberOfBlocks(), block);
    }
  }
  hachure::copyDataTime(part, output);
  return 1;
}

void vtkSurfacePart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surroundings: " << this->Surroundings << "\n";
}

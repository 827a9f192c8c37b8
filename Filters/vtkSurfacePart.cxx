// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfacePart.h"

#include "Core/NearCells.h"
#include "OwnedCells.h"
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
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdint>
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

// The cells that are owned, or those that are not.
template <class Number>
std::vector<Number> CellsThatAre(bool wanted, const std::vector<std::uint8_t>& owned)
{
  std::vector<Number> cells;
  for (std::size_t i = 0; i < owned.size(); ++i)
  {
    if ((owned[i] != 0) == wanted)
    {
      cells.push_back(static_cast<Number>(i));
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
  const vtkSmartPointer<vtkPolyData> polygons =
    Polygons(whole, CellsThatAre<vtkIdType>(true, owned));
  vtkSmartPointer<vtkPolyData> drawn = lines ? WithLines(part, polygons) : polygons;
  CellIds(drawn)->GetInformation()->Set(PointsKey(), whole->GetPoints());
  return drawn;
}

// The cells of all blocks behind each other, so that blocks that touch surround each other.
struct JoinedCells
{
  std::vector<glm::dvec3> points;
  std::vector<std::int64_t> offsets = { 0 };
  std::vector<std::int64_t> corners;
  std::vector<std::uint8_t> owned;

  void append(vtkPolyData* block, const std::vector<std::uint8_t>& ownedOfBlock)
  {
    const auto firstPoint = static_cast<std::int64_t>(this->points.size());
    const auto firstCorner = static_cast<std::int64_t>(this->corners.size());
    const std::vector<glm::dvec3> places = hachure::pointsOf(block);
    this->points.insert(this->points.end(), places.begin(), places.end());
    const hachure::PolygonLists lists = hachure::polygonLists(block);
    for (std::size_t i = 1; i < lists.offsets.size(); ++i)
    {
      this->offsets.push_back(firstCorner + lists.offsets[i]);
    }
    for (const std::int64_t corner : lists.corners)
    {
      this->corners.push_back(firstPoint + corner);
    }
    this->owned.insert(this->owned.end(), ownedOfBlock.begin(), ownedOfBlock.end());
  }
};

vtkSmartPointer<vtkPolyData> SurroundingBlock(
  vtkPolyData* whole, int number, const std::vector<vtkIdType>& cells)
{
  vtkSmartPointer<vtkPolyData> block = Polygons(whole, cells);
  vtkNew<vtkIntArray> mark;
  mark->SetName(notDrawn);
  mark->InsertNextValue(number);
  CellIds(block)->GetInformation()->Set(PointsKey(), whole->GetPoints());
  block->GetFieldData()->AddArray(mark);
  return block;
}

// owned: of the cells of every block; empty for blocks without polygons. all: the largest number of
// cells of which none is too far.
std::vector<vtkSmartPointer<vtkPolyData>> SurroundingBlocks(const std::vector<vtkPolyData*>& whole,
  const std::vector<std::vector<std::uint8_t>>& owned, double distance, vtkIdType all)
{
  JoinedCells joined;
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    if (!owned[i].empty())
    {
      joined.append(whole[i], owned[i]);
    }
  }
  std::vector<vtkSmartPointer<vtkPolyData>> blocks;
  const bool any = std::find(joined.owned.begin(), joined.owned.end(), 1) != joined.owned.end();
  if (!any || std::find(joined.owned.begin(), joined.owned.end(), 0) == joined.owned.end())
  {
    return blocks;
  }
  const std::vector<std::int64_t> near = static_cast<vtkIdType>(joined.owned.size()) <= all
    ? CellsThatAre<std::int64_t>(false, joined.owned)
    : hachure::nearCells(joined.points, { joined.offsets, joined.corners }, joined.owned, distance);
  auto next = near.begin();
  std::int64_t first = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    const std::int64_t end = first + static_cast<std::int64_t>(owned[i].size());
    std::vector<vtkIdType> cells;
    for (; next != near.end() && *next < end; ++next)
    {
      cells.push_back(static_cast<vtkIdType>(*next - first));
    }
    if (!cells.empty())
    {
      blocks.push_back(SurroundingBlock(whole[i], static_cast<int>(i), cells));
    }
    first = end;
  }
  return blocks;
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

// What stays while the surroundings alone become wider or narrower.
struct vtkSurfacePart::Internals
{
  const void* Part = nullptr;
  const void* Whole = nullptr;
  vtkMTimeType PartTime = 0;
  vtkMTimeType WholeTime = 0;
  std::vector<vtkSmartPointer<vtkPolyData>> Drawn;
  std::vector<std::vector<std::uint8_t>> Owned; // cells of the whole's blocks with polygons

  bool IsOf(vtkDataObject* part, vtkDataObject* whole) const
  {
    return this->Part == part && this->Whole == whole && this->PartTime == part->GetMTime() &&
      this->WholeTime == whole->GetMTime();
  }
};

vtkSurfacePart::vtkSurfacePart()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(2);
}

vtkSurfacePart::~vtkSurfacePart() = default;

bool vtkSurfacePart::IsSurroundings(vtkPolyData* block)
{
  return block->GetFieldData() && block->GetFieldData()->HasArray(notDrawn);
}

int vtkSurfacePart::GetSurroundedBlock(vtkPolyData* block)
{
  vtkDataArray* mark = block->GetFieldData() ? block->GetFieldData()->GetArray(notDrawn) : nullptr;
  return mark && mark->GetNumberOfTuples() > 0 ? static_cast<int>(mark->GetComponent(0, 0)) : -1;
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
  if (!this->Internal->IsOf(part, whole))
  {
    this->Draw(own, all);
    this->Internal->Part = part;
    this->Internal->Whole = whole;
    this->Internal->PartTime = part->GetMTime();
    this->Internal->WholeTime = whole->GetMTime();
  }
  output->ShallowCopy(hachure::withLeaves(composite, this->Internal->Drawn));
  for (vtkPolyData* block : SurroundingBlocks(all, this->Internal->Owned,
         this->Surroundings * DiagonalOf(all), this->MaximumNumberOfCells))
  {
    output->SetBlock(output->GetNumberOfBlocks(), block);
  }
  hachure::copyDataTime(part, output);
  return 1;
}

void vtkSurfacePart::Draw(
  const std::vector<vtkPolyData*>& part, const std::vector<vtkPolyData*>& whole)
{
  this->Internal->Drawn.clear();
  this->Internal->Owned.assign(whole.size(), {});
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    if (!whole[i] || whole[i]->GetNumberOfPolys() == 0)
    {
      this->Internal->Drawn.emplace_back(part[i]);
      continue;
    }
    this->Internal->Owned[i] =
      hachure::ownedCells(part[i], whole[i], vtkWholeSurface::GetCellIdsName());
    this->Internal->Drawn.push_back(DrawnBlock(part[i], whole[i], this->Internal->Owned[i]));
  }
}

void vtkSurfacePart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surroundings: " << this->Surroundings << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WholeSurfaceLeaf.h"

#include "Core/Parallel.h"
#include "Core/Random.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

namespace hachure
{
namespace
{
std::vector<std::int64_t> numbersOf(vtkDataArray* array)
{
  const auto count = array ? static_cast<std::size_t>(array->GetNumberOfTuples()) : 0;
  std::vector<std::int64_t> numbers(count);
  parallelFor(static_cast<std::int64_t>(count),
    [&](std::int64_t i)
    {
      numbers[static_cast<std::size_t>(i)] =
        static_cast<std::int64_t>(array->GetComponent(static_cast<vtkIdType>(i), 0));
    });
  return numbers;
}

std::uint64_t connectivityOf(vtkPolyData* part)
{
  const PolygonLists lists = polygonLists(part);
  auto hash = static_cast<std::uint64_t>(part->GetNumberOfPoints());
  for (const std::vector<std::int64_t>* list : { &lists.offsets, &lists.corners })
  {
    for (const std::int64_t number : *list)
    {
      hash = hashPair(hash, static_cast<std::uint64_t>(number));
    }
  }
  return hash;
}

// Numbers that belong to the part a point is in, not to the point.
bool isOfThePart(const std::string& array)
{
  return array == "vtkOriginalPointIds" || array == "vtkProcessId" ||
    array == vtkDataSetAttributes::GhostArrayName();
}

void hashTuples(vtkDataArray* array, std::vector<std::uint64_t>& hashes)
{
  const std::size_t size = static_cast<std::size_t>(array->GetNumberOfComponents()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
  const auto* const bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  parallelFor(static_cast<std::int64_t>(hashes.size()),
    [&](std::int64_t i)
    {
      const auto tuple = static_cast<std::size_t>(i);
      for (std::size_t begin = 0; begin < size; begin += sizeof(std::uint64_t))
      {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + tuple * size + begin, std::min(sizeof(word), size - begin));
        hashes[tuple] = hashPair(hashes[tuple], word);
      }
    });
}

// Equal where points have the same place and the same data.
std::vector<std::uint64_t> identitiesOf(vtkPolyData* surface)
{
  std::vector<std::uint64_t> hashes(static_cast<std::size_t>(surface->GetNumberOfPoints()), 1);
  if (hashes.empty())
  {
    return hashes;
  }
  hashTuples(surface->GetPoints()->GetData(), hashes);
  vtkPointData* data = surface->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (array && !isOfThePart(name) && array->GetNumberOfTuples() >= surface->GetNumberOfPoints())
    {
      hashTuples(array, hashes);
    }
  }
  return hashes;
}

vtkSmartPointer<vtkPolyData> appended(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  vtkPolyData* only = nullptr;
  int count = 0;
  for (const auto& part : parts)
  {
    if (part->GetNumberOfCells() > 0)
    {
      append->AddInputData(part);
      only = part;
      ++count;
    }
  }
  if (count == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  if (count == 1)
  {
    return only;
  }
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkIdList> listOf(const std::vector<std::int64_t>& numbers)
{
  auto list = vtkSmartPointer<vtkIdList>::New();
  list->SetNumberOfIds(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), list->GetPointer(0));
  return list;
}

// Tuples in another order.
void copyTuples(
  vtkDataSetAttributes* from, const std::vector<std::int64_t>& which, vtkDataSetAttributes* to)
{
  std::vector<std::int64_t> next(which.size());
  std::iota(next.begin(), next.end(), 0);
  to->CopyAllOn();
  to->CopyAllocate(from, static_cast<vtkIdType>(which.size()));
  to->SetNumberOfTuples(static_cast<vtkIdType>(which.size()));
  to->CopyData(from, listOf(which), listOf(next));
}
} // namespace

vtkSmartPointer<vtkPolyData> withoutGhosts(vtkPolyData* block)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (!block)
  {
    return result;
  }
  result->ShallowCopy(block);
  if (result->GetNumberOfStrips() > 0)
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(result);
    triangles->Update();
    result->ShallowCopy(triangles->GetOutput());
  }
  if (result->GetCellGhostArray())
  {
    result->RemoveGhostCells();
  }
  return result;
}

vtkSmartPointer<vtkPolyData> polygonsOf(vtkPolyData* block)
{
  const vtkSmartPointer<vtkPolyData> all = withoutGhosts(block);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (all->GetNumberOfPolys() == 0)
  {
    return result;
  }
  result->SetPoints(all->GetPoints());
  result->SetPolys(all->GetPolys());
  result->GetPointData()->PassData(all->GetPointData());
  const vtkIdType others = all->GetNumberOfVerts() + all->GetNumberOfLines();
  if (others == 0)
  {
    result->GetCellData()->PassData(all->GetCellData());
    return result;
  }
  std::vector<std::int64_t> cells(static_cast<std::size_t>(all->GetNumberOfPolys()));
  std::iota(cells.begin(), cells.end(), others);
  copyTuples(all->GetCellData(), cells, result->GetCellData());
  return result;
}

PolygonLists polygonLists(vtkPolyData* polygons)
{
  return { numbersOf(polygons->GetPolys()->GetOffsetsArray()),
    numbersOf(polygons->GetPolys()->GetConnectivityArray()) };
}

std::vector<glm::dvec3> pointsOf(vtkPolyData* surface)
{
  std::vector<glm::dvec3> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), &points[i][0]);
  }
  return points;
}

void addPolygons(vtkPolyData* polygons, CellBox& box)
{
  box.add(pointsOf(polygons), polygonLists(polygons).cells());
}

void WholeSurfaceLeaf::assemble(
  const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const std::function<CellBox()>& boxOfAll)
{
  std::vector<std::uint64_t> connectivity;
  connectivity.reserve(parts.size());
  this->FirstCells.assign(1, 0);
  this->FirstPoints.assign(1, 0);
  for (const auto& part : parts)
  {
    const bool used = part->GetNumberOfCells() > 0;
    connectivity.push_back(used ? connectivityOf(part) : 0);
    this->FirstCells.push_back(this->FirstCells.back() + part->GetNumberOfCells());
    this->FirstPoints.push_back(this->FirstPoints.back() + (used ? part->GetNumberOfPoints() : 0));
  }
  const vtkSmartPointer<vtkPolyData> all = appended(parts);
  if (connectivity != this->Connectivity || !this->Whole)
  {
    this->order(all, boxOfAll());
    this->Connectivity = connectivity;
  }
  this->build(all);
}

void WholeSurfaceLeaf::order(vtkPolyData* all, const CellBox& box)
{
  const PolygonLists lists = polygonLists(all);
  this->Order = canonicalOrder(pointsOf(all), lists.cells(), box);
  this->CellNumbers.resize(this->Order.size());
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    this->CellNumbers[static_cast<std::size_t>(this->Order[i])] = static_cast<vtkIdType>(i);
  }
  this->Points = distinctPoints(identitiesOf(all), lists.cells(), this->Order);
}

void WholeSurfaceLeaf::build(vtkPolyData* all)
{
  this->Whole = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  if (all->GetPoints())
  {
    points->SetDataType(all->GetPoints()->GetDataType());
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.first.size()));
    all->GetPoints()->GetData()->GetTuples(listOf(this->Points.first), points->GetData());
  }
  const PolygonLists lists = polygonLists(all);
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(
    static_cast<vtkIdType>(this->Order.size()), static_cast<vtkIdType>(lists.corners.size()));
  std::vector<vtkIdType> corners;
  for (const std::int64_t cell : this->Order)
  {
    corners.clear();
    for (auto i = lists.offsets[static_cast<std::size_t>(cell)];
         i < lists.offsets[static_cast<std::size_t>(cell) + 1]; ++i)
    {
      const auto corner = static_cast<std::size_t>(lists.corners[static_cast<std::size_t>(i)]);
      corners.push_back(static_cast<vtkIdType>(this->Points.numbers[corner]));
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  this->Whole->SetPoints(points);
  this->Whole->SetPolys(polygons);
  copyTuples(all->GetPointData(), this->Points.first, this->Whole->GetPointData());
  copyTuples(all->GetCellData(), this->Order, this->Whole->GetCellData());
}

vtkIdType WholeSurfaceLeaf::cellOf(std::size_t part, vtkIdType cell) const
{
  return this->CellNumbers[static_cast<std::size_t>(this->FirstCells[part] + cell)];
}

vtkIdType WholeSurfaceLeaf::pointOf(std::size_t part, vtkIdType point) const
{
  const bool used = this->FirstPoints[part + 1] > this->FirstPoints[part];
  const auto index = static_cast<std::size_t>(this->FirstPoints[part] + point);
  return used ? static_cast<vtkIdType>(this->Points.numbers[index]) : -1;
}

} // namespace hachure

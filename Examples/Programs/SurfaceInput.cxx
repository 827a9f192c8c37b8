// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceInput.h"

#include "ErrorCollector.h"
#include "FileReading.h"
#include "UserError.h"

#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace hachure::program
{
namespace
{
using Leaf = vtkSmartPointer<vtkPolyData>;

/// Points to fit a view to.
constexpr std::size_t LargestFitSet = 20000;

std::string rangeText(const double range[2])
{
  std::ostringstream text;
  text << "[" << range[0] << ", " << range[1] << "]";
  return text.str();
}

/// A grid with more than one cell layer in all three directions.
bool isVolume(vtkDataSet* data)
{
  int size[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(size);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(size);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(size);
  }
  return std::min({ size[0], size[1], size[2] }) > 1;
}

/// The point scalars to contour: the active ones, else the first array.
vtkDataArray* contourScalars(vtkDataSet* data)
{
  vtkPointData* points = data->GetPointData();
  vtkDataArray* scalars = points->GetScalars();
  return scalars ? scalars : points->GetArray(0);
}

bool isFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

void finiteRange(vtkDataArray* array, double range[2])
{
  array->GetFiniteRange(range, array->GetNumberOfComponents() == 1 ? 0 : -1);
}

Leaf isosurface(vtkDataSet* data, double isovalue, const std::string& path)
{
  vtkDataArray* scalars = contourScalars(data);
  if (!scalars || !scalars->GetName())
  {
    throw UserError("'" + path + "' has no point scalars to take an isosurface of");
  }
  double range[2];
  finiteRange(scalars, range);
  if (!(isovalue >= range[0] && isovalue <= range[1]))
  {
    std::ostringstream text;
    text << "isovalue " << isovalue << " lies outside the scalar range " << rangeText(range)
         << " of '" << path << "'";
    throw UserError(text.str());
  }
  data->GetPointData()->SetActiveScalars(scalars->GetName());
  vtkSmartPointer<vtkPolyDataAlgorithm> contour;
  if (vtkImageData::SafeDownCast(data))
  {
    auto edges = vtkSmartPointer<vtkFlyingEdges3D>::New();
    edges->SetValue(0, isovalue);
    edges->InterpolateAttributesOn();
    contour = edges;
  }
  else
  {
    auto general = vtkSmartPointer<vtkContourFilter>::New();
    general->SetValue(0, isovalue);
    contour = general;
  }
  contour->SetInputData(data);
  contour->Update();
  return contour->GetOutput();
}

Leaf outerSurface(vtkDataSet* data)
{
  if (auto* already = vtkPolyData::SafeDownCast(data))
  {
    return already;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  return surface->GetOutput();
}

/// Degenerate cells are dropped. Coincident points are merged only where no normals tell the two
/// sides of an edge apart.
Leaf cleaned(vtkPolyData* surface, bool mergePoints)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->SetPointMerging(mergePoints);
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(0.0);
  clean->ConvertStripsToPolysOff();
  clean->ConvertPolysToLinesOff();
  clean->ConvertLinesToPointsOff();
  clean->Update();
  return clean->GetOutput();
}

/// From this angle between its faces on, in degrees, an edge is sharp: light and outlines tell its
/// two sides apart. Where outlines begin to show a crease, too.
constexpr double SharpEdge = 40.0;

Leaf withNormals(vtkPolyData* surface)
{
  if (surface->GetPointData()->GetNormals() ||
    surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    return surface;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOn();
  normals->SetFeatureAngle(SharpEdge);
  normals->ConsistencyOn();
  normals->Update();
  return normals->GetOutput();
}

Leaf leafSurface(vtkDataSet* data, const std::optional<double>& isovalue, const std::string& path)
{
  Leaf surface;
  bool mergePoints = true;
  if (isovalue)
  {
    if (vtkPolyData::SafeDownCast(data))
    {
      throw UserError("'" + path + "' is a surface already: --isovalue needs a volume");
    }
    surface = isosurface(data, *isovalue, path);
  }
  else if (isVolume(data))
  {
    double range[2] = { 0.0, 0.0 };
    vtkDataArray* scalars = contourScalars(data);
    if (!scalars)
    {
      throw UserError("'" + path + "' is a volume without point scalars");
    }
    finiteRange(scalars, range);
    throw UserError(
      "'" + path + "' is a volume: give --isovalue V inside its scalar range " + rangeText(range));
  }
  else
  {
    surface = outerSurface(data);
    mergePoints = surface->GetPointData()->GetNormals() == nullptr;
  }
  return withNormals(cleaned(surface, mergePoints));
}

vtkSmartPointer<vtkDataObject> surfaceOf(
  vtkDataObject* data, const std::optional<double>& isovalue, const std::string& path)
{
  if (auto* single = vtkDataSet::SafeDownCast(data))
  {
    return leafSurface(single, isovalue, path);
  }
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  if (!blocks)
  {
    throw UserError("'" + path + "' holds a " + data->GetClassName() + ", which has no surface");
  }
  auto result = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  result->CopyStructure(blocks);
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(blocks->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (block && block->GetNumberOfCells() > 0)
    {
      result->SetDataSet(leaf, leafSurface(block, isovalue, path));
    }
  }
  return result;
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Scans stand along z: NIfTI looks along -y (right, anterior, superior axes), the others along +y
/// (left, posterior, superior). STL parts and simulations stand along z, modelled meshes along y.
void setUsualAxes(const std::string& path, Surface& surface)
{
  const std::string name = lowerCase(path);
  for (const char* modelled : { ".obj", ".ply", ".vtp", ".vtm" })
  {
    if (endsWith(name, modelled))
    {
      return;
    }
  }
  surface.up = "z";
  surface.front = endsWith(name, ".nii") || endsWith(name, ".nii.gz") ? "y" : "-y";
}

std::set<std::string> arrayNames(vtkPolyData* leaf)
{
  std::set<std::string> names;
  const std::array<vtkDataSetAttributes*, 2> both = { leaf->GetPointData(), leaf->GetCellData() };
  for (vtkDataSetAttributes* attributes : both)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      if (attributes->GetArray(i) && attributes->GetArrayName(i))
      {
        names.insert(attributes->GetArrayName(i));
      }
    }
  }
  return names;
}

[[noreturn]] void refuseArray(vtkDataObject* surface, const std::string& name)
{
  std::set<std::string> known;
  for (vtkPolyData* leaf : surfaceLeaves(surface))
  {
    known.merge(arrayNames(leaf));
  }
  std::string list;
  for (const std::string& one : known)
  {
    list += (list.empty() ? "" : ", ") + one;
  }
  throw UserError(
    "no array '" + name + "' on the surface; it has: " + (list.empty() ? "none" : list));
}
} // namespace

//----------------------------------------------------------------------------
std::vector<vtkPolyData*> surfaceLeaves(vtkDataObject* surface)
{
  std::vector<vtkPolyData*> leaves;
  if (auto* single = vtkPolyData::SafeDownCast(surface))
  {
    leaves.push_back(single);
  }
  else if (auto* blocks = vtkCompositeDataSet::SafeDownCast(surface))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(blocks->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (auto* block = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject()))
      {
        leaves.push_back(block);
      }
    }
  }
  const auto isEmpty = [](vtkPolyData* leaf) { return leaf->GetNumberOfCells() == 0; };
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(), isEmpty), leaves.end());
  return leaves;
}

//----------------------------------------------------------------------------
std::vector<glm::dvec3> fitPoints(vtkDataObject* surface, const std::string& path)
{
  const auto leaves = surfaceLeaves(surface);
  vtkIdType count = 0;
  for (vtkPolyData* leaf : leaves)
  {
    count += leaf->GetNumberOfPoints();
  }
  const vtkIdType stride = 1 + count / static_cast<vtkIdType>(LargestFitSet);
  std::vector<glm::dvec3> points;
  for (vtkPolyData* leaf : leaves)
  {
    for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); i += stride)
    {
      glm::dvec3 point;
      leaf->GetPoint(i, &point.x);
      if (isFinite(point))
      {
        points.push_back(point);
      }
    }
  }
  if (points.empty())
  {
    throw UserError("'" + path + "' has no point with finite coordinates");
  }
  return points;
}

//----------------------------------------------------------------------------
ToneArray toneArray(vtkDataObject* surface, const std::string& name)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  ToneArray result;
  double low = Infinity;
  double high = -Infinity;
  bool found = false;
  for (vtkPolyData* leaf : surfaceLeaves(surface))
  {
    vtkDataArray* array = leaf->GetPointData()->GetArray(name.c_str());
    array = array ? array : leaf->GetCellData()->GetArray(name.c_str());
    if (array)
    {
      double range[2];
      finiteRange(array, range);
      found = true;
      result.component = array->GetNumberOfComponents() == 1 ? 0 : -1;
      low = std::min(low, range[0]);
      high = std::max(high, range[1]);
    }
  }
  if (!found)
  {
    refuseArray(surface, name);
  }
  if (low == high)
  {
    // A constant array is drawn at half tone.
    const double half = std::max(0.5, 0.5 * std::abs(low));
    result.range = { low - half, high + half };
  }
  else if (low < high)
  {
    result.range = { low, high };
  }
  return result;
}

//----------------------------------------------------------------------------
Surface readSurface(const std::string& path, const std::optional<double>& isovalue)
{
  Surface surface;
  const vtkSmartPointer<vtkDataObject> data = readFile(path);
  surface.data = surfaceOf(data, isovalue, path);
  setUsualAxes(path, surface);
  if (surfaceLeaves(surface.data).empty())
  {
    throw UserError("'" + path + "' has no surface to draw");
  }
  return surface;
}
} // namespace hachure::program

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternPatches.h"

#include "vtkHachureCompatibility.h"

#include "TrianglePatches.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPatternBlocks.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

namespace
{
// As vtkPatchBlendWeights writes them.
const char* const blendPatches = "BlendPatches";
const char* const blendWeights = "BlendWeights";
constexpr int blendComponents = 4;

bool HasSurface(vtkPolyData* block)
{
  return block->GetNumberOfPolys() > 0 || block->GetNumberOfStrips() > 0;
}

vtkDataArray* BlendArray(vtkPolyData* block, const char* name)
{
  vtkDataArray* array = block->GetPointData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == blendComponents &&
    array->GetNumberOfTuples() >= block->GetNumberOfPoints();
  return fits ? array : nullptr;
}

std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  return (hash ^ (value + 0x9e3779b97f4a7c15ULL)) * 0x100000001b3ULL;
}

// What is wrong with a block's patch array, empty where nothing is; raises `largest`.
std::string Complaint(vtkAbstractArray* found, vtkIdType cells, int& largest, std::uint64_t& hash)
{
  std::ostringstream text;
  auto* array = vtkDataArray::SafeDownCast(found);
  text << "patch array '" << found->GetName() << "' ";
  const bool whole =
    array && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  if (!whole || array->GetNumberOfComponents() != 1)
  {
    text << "is a " << found->GetClassName() << " of " << found->GetNumberOfComponents()
         << " components; expected one whole number";
    return text.str();
  }
  for (vtkIdType i = 0; i < std::min(cells, array->GetNumberOfTuples()); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!(value < hachure::maximumDrawnPatches))
    {
      text << "has the value " << value << " at cell " << i << "; expected less than "
           << hachure::maximumDrawnPatches;
      return text.str();
    }
    const int patch = static_cast<int>(std::max(value, -1.0)); // all negative numbers are alike
    largest = std::max(largest, patch);
    hash = Mix(hash, static_cast<std::uint64_t>(patch));
  }
  return {};
}

hachure::CornerPatches Corner(vtkDataArray* patches, vtkDataArray* weights, vtkIdType point)
{
  hachure::CornerPatches corner;
  for (int i = 0; i < blendComponents; ++i)
  {
    const double patch = patches->GetComponent(point, i);
    const double weight = weights->GetComponent(point, i);
    const bool known = patch >= 0.0 && patch < hachure::maximumDrawnPatches && weight > 0.0;
    corner.patches[static_cast<std::size_t>(i)] = known ? static_cast<int>(patch) : -1;
    corner.weights[i] = known ? static_cast<float>(weight) : 0.0f;
  }
  return corner;
}

// The patch of every point that belongs to no other one, else -1.
std::vector<int> OnlyPatches(vtkDataArray* patches, vtkDataArray* weights, vtkIdType count)
{
  constexpr double whole = 1.0 - 1e-6;
  std::vector<int> only(static_cast<std::size_t>(count), -1);
  for (vtkIdType point = 0; point < count; ++point)
  {
    const double patch = patches->GetComponent(point, 0);
    if (weights->GetComponent(point, 0) >= whole && patch >= 0.0 &&
      patch < hachure::maximumDrawnPatches)
    {
      only[static_cast<std::size_t>(point)] = static_cast<int>(patch);
    }
  }
  return only;
}
} // namespace

void vtkPatternPatches::Collect(
  vtkDataObject* input, const std::string& arrayName, std::string& error)
{
  State arrays;
  for (const vtkPattern::Block& block : vtkPattern::Blocks(input))
  {
    vtkDataArray* const used[] = {
      vtkDataArray::SafeDownCast(block.Data->GetCellData()->GetAbstractArray(arrayName.c_str())),
      block.Data->GetPointData()->GetArray(blendPatches),
      block.Data->GetPointData()->GetArray(blendWeights)
    };
    for (vtkDataArray* array : used)
    {
      arrays.emplace_back(array, array ? array->GetMTime() : 0);
    }
  }
  if (this->Version == 0 || arrays != this->Arrays || arrayName != this->ArrayName)
  {
    this->Arrays = arrays;
    this->ArrayName = arrayName;
    ++this->Version;
    this->Error.clear();
    this->Read(input, this->Error);
  }
  if (error.empty())
  {
    error = this->Error;
  }
}

void vtkPatternPatches::Read(vtkDataObject* input, std::string& error)
{
  this->Count = 1;
  this->Blended = false;
  this->Hash = 0;
  if (this->ArrayName.empty())
  {
    return;
  }
  int largest = 0;
  bool found = false;
  bool missing = false;
  bool blended = true;
  for (const vtkPattern::Block& block : vtkPattern::Blocks(input))
  {
    vtkAbstractArray* array = block.Data->GetCellData()->GetAbstractArray(this->ArrayName.c_str());
    if (!HasSurface(block.Data))
    {
      continue;
    }
    found = found || array;
    missing = missing || !array;
    if (!array)
    {
      continue;
    }
    error = Complaint(array, block.Data->GetNumberOfCells(), largest, this->Hash);
    if (!error.empty())
    {
      return;
    }
    blended =
      blended && BlendArray(block.Data, blendPatches) && BlendArray(block.Data, blendWeights);
  }
  if (missing)
  {
    const bool asked = found || this->ArrayName != DefaultArrayName();
    error = asked ? std::string(found ? "some blocks have" : "there is") + " no cell array '" +
        this->ArrayName + "' to take the patches from; the surface is drawn as one patch"
                  : std::string();
    return;
  }
  this->Count = largest + 1;
  this->Blended = blended;
}

void vtkPatternPatches::Append(vtkPolyData* block, const std::vector<vtkIdType>& cells,
  std::uint32_t firstVertex, const glm::dvec3& origin, hachure::TrianglePatches& all) const
{
  if (!HasSurface(block))
  {
    return;
  }
  vtkDataArray* numbers = block->GetCellData()->GetArray(this->ArrayName.c_str());
  const auto patchOf = [&](vtkIdType cell)
  {
    const bool known = numbers && cell < numbers->GetNumberOfTuples();
    return known ? static_cast<int>(std::max(numbers->GetComponent(cell, 0), 0.0)) : 0;
  };
  // The corners of what VTK draws, triangulated by VTK itself.
  std::vector<unsigned int> corners;
  vtkOpenGLIndexBufferObject::AppendTriangleIndexBuffer(
    corners, block->GetPolys(), block->GetPoints(), 0, nullptr, nullptr);
  vtkOpenGLIndexBufferObject::AppendStripIndexBuffer(corners, block->GetStrips(), 0, false);
  vtkDataArray* patches = this->Blended ? BlendArray(block, blendPatches) : nullptr;
  vtkDataArray* weights = this->Blended ? BlendArray(block, blendWeights) : nullptr;
  const std::vector<int> only = patches && weights
    ? OnlyPatches(patches, weights, block->GetNumberOfPoints())
    : std::vector<int>();
  const std::size_t triangles = std::min(cells.size(), corners.size() / 3);
  for (std::size_t triangle = 0; triangle < triangles; ++triangle)
  {
    const unsigned int* ids = &corners[3 * triangle];
    const std::uint32_t lastVertex = firstVertex + ids[2];
    hachure::TriangleCorners points;
    for (std::size_t i = 0; i < 3; ++i)
    {
      block->GetPoint(ids[i], &points[i][0]);
      points[i] -= origin;
    }
    if (only.empty())
    {
      hachure::appendTriangle(all, lastVertex, points, patchOf(cells[triangle]));
      continue;
    }
    const int patch = only[ids[0]];
    if (patch >= 0 && patch == only[ids[1]] && patch == only[ids[2]])
    {
      hachure::appendTriangle(all, lastVertex, points, patch);
      continue;
    }
    std::array<hachure::CornerPatches, 3> weighted;
    for (std::size_t i = 0; i < 3; ++i)
    {
      weighted[i] = Corner(patches, weights, ids[i]);
    }
    hachure::appendTriangle(all, lastVertex, points, weighted);
  }
}

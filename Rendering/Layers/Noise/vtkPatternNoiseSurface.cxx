// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternNoiseSurface.h"

#include "Random.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPatternBlocks.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
// A composite does not tell of changes in its blocks.
std::uint64_t TimeOf(vtkDataObject* input)
{
  std::uint64_t time = input->GetMTime();
  for (const vtkPattern::Block& block : vtkPattern::Blocks(input))
  {
    time = std::max<std::uint64_t>(time, block.Data->GetMTime());
  }
  return time;
}

// Whether VTK cuts a cell into these triangles, in this order. corners: memory.
bool IsCutAlike(vtkPolyData* block, vtkIdType cell, hachure::Span<const glm::ivec3> triangles,
  int firstPoint, vtkIdList* corners)
{
  constexpr std::size_t mostCorners = 4;
  const vtkIdType firstPolygon = block->GetNumberOfVerts() + block->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + block->GetNumberOfPolys();
  const bool strip = cell >= firstStrip;
  (strip ? block->GetStrips() : block->GetPolys())
    ->GetCellAtId(cell - (strip ? firstStrip : firstPolygon), corners);
  const auto size = static_cast<std::size_t>(corners->GetNumberOfIds());
  if (triangles.size() + 2 != size || (!strip && size > mostCorners))
  {
    return false;
  }
  const auto corner = [&](std::size_t i)
  { return static_cast<int>(corners->GetId(static_cast<vtkIdType>(i))) + firstPoint; };
  bool alike = true;
  for (std::size_t i = 0; !strip && i < triangles.size(); ++i)
  {
    alike = alike && triangles[i] == glm::ivec3(corner(0), corner(i + 1), corner(i + 2));
  }
  return alike;
}
} // namespace

void vtkPatternNoiseSurface::Update(vtkDataObject* input)
{
  const std::uint64_t time = TimeOf(input);
  if (this->Input != input || this->InputTime != time)
  {
    this->Input = input;
    this->InputTime = time;
    ++this->Version;
    this->Arrays.clear();
  }
  const vtkPatternGeometry::Change change = this->Geometry.Update(input);
  if (change == vtkPatternGeometry::REPLACED)
  {
    ++this->CellVersion;
    this->FacetOfTriangle.clear();
    this->Seeds.clear();
    this->Arrays.clear();
    this->Surface = {}; // also of an input that is refused
    this->Surface = hachure::extractSurfaceTriangles(input);
    this->Identify(input);
  }
  if (change != vtkPatternGeometry::NOTHING)
  {
    ++this->Version;
    this->Move();
  }
}

// A triangle is the one of this number that its cell is cut into.
void vtkPatternNoiseSurface::Identify(vtkDataObject* input)
{
  this->Ids.clear();
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(input);
  const bool known = std::all_of(blocks.begin(), blocks.end(),
    [](const vtkPattern::Block& block)
    { return block.Data->GetNumberOfCells() == 0 || block.Data->GetCellData()->GetGlobalIds(); });
  if (!known || blocks.size() != this->Surface.blocks.size())
  {
    return;
  }
  const std::size_t count = this->Surface.triangles.size();
  this->Ids.reserve(count);
  std::uint64_t part = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto block = static_cast<std::size_t>(this->Surface.blockIndices[i]);
    const vtkIdType cell = this->Surface.cells[i];
    const bool another = i == 0 || cell != this->Surface.cells[i - 1] ||
      this->Surface.blockIndices[i] != this->Surface.blockIndices[i - 1];
    part = another ? 0 : part + 1;
    vtkDataArray* ids = blocks[block].Data->GetCellData()->GetGlobalIds();
    this->Ids.push_back(
      hachure::hashPair(static_cast<std::uint64_t>(ids->GetComponent(cell, 0)), part));
  }
}

void vtkPatternNoiseSurface::Move()
{
  this->Positions.clear();
  this->Positions.reserve(this->Surface.points.size());
  for (const vtkPatternGeometry::Block& block : this->Geometry.GetBlocks())
  {
    for (vtkIdType i = 0; i < block.Data->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 point;
      block.Data->GetPoint(i, &point[0]);
      const bool finite = std::isfinite(point.x + point.y + point.z);
      this->Positions.push_back(finite ? point : glm::dvec3(0.0)); // in no triangle
    }
  }
  for (auto& seed : this->Seeds)
  {
    seed.second.setPositions(this->Positions);
  }
}

const std::vector<std::int32_t>& vtkPatternNoiseSurface::Facets()
{
  const std::size_t count = this->Surface.triangles.size();
  if (this->FacetOfTriangle.size() == count)
  {
    return this->FacetOfTriangle;
  }
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(this->Input);
  const hachure::Span<const glm::ivec3> triangles(this->Surface.triangles);
  vtkNew<vtkIdList> corners;
  this->FacetOfTriangle.clear();
  this->FacetOfTriangle.reserve(count);
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < count; begin = end)
  {
    const vtkIdType cell = this->Surface.cells[begin];
    const std::int32_t block = this->Surface.blockIndices[begin];
    while (
      end < count && this->Surface.cells[end] == cell && this->Surface.blockIndices[end] == block)
    {
      ++end;
    }
    const auto index = static_cast<std::size_t>(block);
    const bool alike = IsCutAlike(blocks[index].Data, cell, triangles.subspan(begin, end - begin),
      this->Surface.blocks[index].firstPoint, corners);
    for (std::size_t i = begin; i < end; ++i)
    {
      this->FacetOfTriangle.push_back(static_cast<std::int32_t>(alike ? i : begin));
    }
  }
  return this->FacetOfTriangle;
}

void vtkPatternNoiseSurface::AppendPrimitiveIds(
  vtkPolyData* block, hachure::Span<const vtkIdType> cells, std::vector<float>& ids)
{
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(this->Input);
  const auto object = static_cast<std::size_t>(
    std::find_if(blocks.begin(), blocks.end(),
      [block](const vtkPattern::Block& candidate) { return candidate.Data == block; }) -
    blocks.begin());
  const auto start = [this](std::size_t index)
  {
    const bool known = index < this->Surface.blocks.size();
    return known ? static_cast<std::size_t>(this->Surface.blocks[index].firstTriangle)
                 : this->Surface.triangles.size();
  };
  const auto begin = this->Surface.cells.begin() + static_cast<std::ptrdiff_t>(start(object));
  const auto end = this->Surface.cells.begin() + static_cast<std::ptrdiff_t>(start(object + 1));
  const std::vector<std::int32_t>& facets = this->Facets();
  ids.reserve(ids.size() + 2 * cells.size());
  auto triangle = begin;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const bool another = i == 0 || cells[i] != cells[i - 1];
    triangle = another ? std::lower_bound(begin, end, cells[i]) : triangle;
    const bool found = triangle != end && *triangle == cells[i];
    const auto index = static_cast<std::size_t>(triangle - this->Surface.cells.begin());
    ids.push_back(object < blocks.size() ? static_cast<float>(object) : -1.0f);
    ids.push_back(found ? static_cast<float>(facets[index]) : -1.0f);
    const bool more = found && triangle + 1 != end && *(triangle + 1) == cells[i];
    triangle += more ? 1 : 0;
  }
}

hachure::NoiseSurface& vtkPatternNoiseSurface::Points(std::uint32_t seed)
{
  auto found = this->Seeds.find(seed);
  if (found == this->Seeds.end())
  {
    // Not the first positions where the surface has moved since: those of the reference.
    std::vector<glm::dvec3>& first = this->Surface.points;
    std::replace_if(
      first.begin(), first.end(),
      [](const glm::dvec3& p) { return !std::isfinite(p.x + p.y + p.z); }, glm::dvec3(0.0));
    hachure::NoiseSurface points(
      { first, this->Surface.triangles, {} }, this->Ids, this->Surface.blockIndices, seed);
    points.setPositions(this->Positions);
    found = this->Seeds.emplace(seed, std::move(points)).first;
  }
  return found->second;
}

const vtkPatternSurfaceArray& vtkPatternNoiseSurface::Array(const std::string& name, int components)
{
  const std::pair<std::string, int> key(name, components);
  auto found = this->Arrays.find(key);
  if (found == this->Arrays.end())
  {
    const vtkPatternSurfaceArray array(this->Input, this->Surface, name, components);
    found = this->Arrays.emplace(key, array).first;
  }
  return found->second;
}

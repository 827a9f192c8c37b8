// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternNoiseSurface.h"

#include "Random.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
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
    this->Seeds.clear();
    this->Arrays.clear();
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

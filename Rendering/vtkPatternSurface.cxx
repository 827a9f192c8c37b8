// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternSurface.h"

#include "Random.h"
#include "SurfaceCharts.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPatternBlocks.h"
#include "vtkPolyData.h"
#include "vtkSurfacePart.h"
#include "vtkWholeSurface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

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

// Reference areas of the triangles of `state`: those of the same ids in `before`, where there are,
// else what they are now.
std::vector<double> AreasOf(
  const vtkPatternSurface::State& state, const vtkPatternSurface::State* before)
{
  std::unordered_map<std::uint64_t, double> known;
  for (std::size_t i = 0; before && i < before->Areas.size(); ++i)
  {
    known.emplace(before->Ids[i], before->Areas[i]);
  }
  std::vector<double> areas;
  areas.reserve(state.Ids.size());
  for (std::size_t i = 0; i < state.Ids.size(); ++i)
  {
    const auto found = known.find(state.Ids[i]);
    const auto triangle = static_cast<std::int64_t>(i);
    constexpr double half = 0.5; // of the parallelogram
    areas.push_back(found != known.end()
        ? found->second
        : half * glm::length(hachure::triangleAreaVector(state.Surface.mesh(), triangle)));
  }
  return areas;
}
// Points of no triangle need not be finite.
std::vector<glm::dvec3> FiniteOf(std::vector<glm::dvec3> points)
{
  std::replace_if(
    points.begin(), points.end(),
    [](const glm::dvec3& p) { return !std::isfinite(p.x + p.y + p.z); }, glm::dvec3(0.0));
  return points;
}

hachure::StippleOptions OptionsOf(const vtkPatternSurface::StippleKey& key)
{
  hachure::StippleOptions options;
  options.order = key.Order;
  options.seed = key.Seed;
  options.count = key.Count;
  return options;
}

// Closed blocks that are inside out are turned.
std::vector<glm::ivec3> OutwardTriangles(const hachure::SurfaceTriangles& surface)
{
  std::vector<glm::ivec3> triangles = surface.triangles;
  for (std::size_t block = 0; block < surface.blocks.size(); ++block)
  {
    if (hachure::isInsideOut(surface.blockMesh(block)))
    {
      const bool isLast = block + 1 == surface.blocks.size();
      const auto begin = static_cast<std::size_t>(surface.blocks[block].firstTriangle);
      const std::size_t end = isLast
        ? triangles.size()
        : static_cast<std::size_t>(surface.blocks[block + 1].firstTriangle);
      for (std::size_t i = begin; i < end; ++i)
      {
        std::swap(triangles[i].y, triangles[i].z);
      }
    }
  }
  return triangles;
}

// Places and normals.
std::pair<std::vector<glm::dvec3>, std::vector<glm::dvec3>> PlacesOf(
  const hachure::TriangleMesh& mesh, const std::vector<hachure::StipplePoint>& points)
{
  std::pair<std::vector<glm::dvec3>, std::vector<glm::dvec3>> result;
  result.first.reserve(points.size());
  result.second.reserve(points.size());
  for (const hachure::StipplePoint& point : points)
  {
    result.first.push_back(hachure::stipplePosition(mesh, point));
    result.second.push_back(hachure::triangleAreaVector(mesh, point.triangle));
  }
  return result;
}

// Stipples that leave, as points without a mesh, which have the density of their spacing.
hachure::StippleHierarchy HierarchyOf(const hachure::LivingStipples& living)
{
  hachure::StippleHierarchy result;
  result.points.reserve(living.leaving.size());
  for (std::size_t i = 0; i < living.leaving.size(); ++i)
  {
    result.points.push_back({ static_cast<std::int32_t>(i), { 0.0f, 0.0f },
      static_cast<float>(std::sqrt(hachure::stippleSquareSpacing / living.leavingDensities[i])) });
  }
  return result;
}
} // namespace

bool vtkPatternSurface::State::Follows(const State& before) const
{
  // Where the data stand still, as while properties of a filter are animated, another clock counts.
  const double data = this->DataTime - before.DataTime;
  const bool moves = std::isfinite(data) && data != 0.0;
  const double passed = moves ? data : this->AnimationTime - before.AnimationTime;
  return this->Lineage == before.Lineage && !(passed < 0.0);
}

void vtkPatternSurface::Update(vtkDataObject* input, const Source& source)
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
    this->RunsOfPoints = {};
  }
  const bool related =
    !this->IsAnew && this->Algorithm == source.Algorithm && this->Port == source.Port;
  const bool again = this->IsAnew && (change == vtkPatternGeometry::MOVED || this->HasMoved());
  if (change == vtkPatternGeometry::REPLACED || again)
  {
    this->Replace(input, related);
  }
  this->IsAnew = false;
  this->Algorithm = source.Algorithm;
  this->Port = source.Port;
  this->Current->DataTime = source.DataTime;
  this->Current->AnimationTime = source.AnimationTime;
  if (change != vtkPatternGeometry::NOTHING || again)
  {
    ++this->Version;
    this->Move();
  }
}

void vtkPatternSurface::Replace(vtkDataObject* input, bool related)
{
  const std::shared_ptr<State> before = this->Current;
  this->Arrays.clear();
  this->Current = std::make_shared<State>();
  this->Current->Lineage = before->Lineage + (related ? 0 : 1);
  before->Before.reset();
  // For its stipples; whatever else it has is not needed.
  this->Current->Before = related && !before->Stipples.empty() ? before : nullptr;
  this->Current->Surface = hachure::extractSurfaceTriangles(input);
  this->Identify(input);
  if (!this->Current->Ids.empty())
  {
    this->Current->Areas = AreasOf(*this->Current, related ? before.get() : nullptr);
  }
}

// A triangle is the one of this number that its cell is cut into.
void vtkPatternSurface::Identify(vtkDataObject* input)
{
  this->Current->Ids.clear();
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(input);
  const bool known = std::all_of(blocks.begin(), blocks.end(),
    [](const vtkPattern::Block& block)
    { return block.Data->GetNumberOfCells() == 0 || block.Data->GetCellData()->GetGlobalIds(); });
  if (!known || blocks.size() != this->Current->Surface.blocks.size())
  {
    return;
  }
  const std::size_t count = this->Current->Surface.triangles.size();
  this->Current->Ids.reserve(count);
  std::uint64_t part = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto block = static_cast<std::size_t>(this->Current->Surface.blockIndices[i]);
    const vtkIdType cell = this->Current->Surface.cells[i];
    const bool another = i == 0 || cell != this->Current->Surface.cells[i - 1] ||
      this->Current->Surface.blockIndices[i] != this->Current->Surface.blockIndices[i - 1];
    part = another ? 0 : part + 1;
    vtkDataArray* ids = blocks[block].Data->GetCellData()->GetGlobalIds();
    this->Current->Ids.push_back(
      hachure::hashPair(static_cast<std::uint64_t>(ids->GetComponent(cell, 0)), part));
  }
}

void vtkPatternSurface::Move()
{
  this->Current->Positions.clear();
  this->Current->Positions.reserve(this->Current->Surface.points.size());
  for (const vtkPatternGeometry::Block& block : this->Geometry.GetBlocks())
  {
    for (vtkIdType i = 0; i < block.Data->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 point;
      block.Data->GetPoint(i, &point[0]);
      const bool finite = std::isfinite(point.x + point.y + point.z);
      this->Current->Positions.push_back(finite ? point : glm::dvec3(0.0)); // in no triangle
    }
  }
  for (auto& seed : this->Current->Seeds)
  {
    seed.second.setPositions(this->Current->Positions);
  }
  for (auto& stipples : this->Current->Stipples)
  {
    stipples.second.Move({ this->Current->Positions, this->Current->Outward, {} });
  }
  for (auto& stipples : this->Current->ClassicStipples)
  {
    stipples.second.setPositions(this->Current->Positions);
  }
  for (auto& cells : this->Current->Cells)
  {
    const std::vector<glm::dvec3> first = this->FirstPositions();
    cells.second.Move({ first, this->Current->Surface.triangles, {} }, this->Current->Positions);
  }
}

std::vector<glm::dvec3> vtkPatternSurface::FirstPositions() const
{
  return FiniteOf(this->Current->Surface.points);
}

void vtkPatternSurface::CellSet::Move(
  const hachure::TriangleMesh& first, hachure::Span<const glm::dvec3> positions)
{
  this->Frames = this->First;
  if (!std::equal(first.points.begin(), first.points.end(), positions.begin(), positions.end()))
  {
    hachure::moveFrames(this->Frames, first, positions);
  }
}

std::shared_ptr<vtkPatternSurface::CellSet> vtkPatternSurface::Cells(const CellKey& key)
{
  State& state = *this->Current;
  auto found = state.Cells.find(key);
  if (found == state.Cells.end())
  {
    const std::vector<glm::dvec3> first = this->FirstPositions();
    const hachure::TriangleMesh mesh = { first, state.Surface.triangles, {} };
    hachure::SurfaceCellOptions options;
    options.baseCells = key.BaseCells;
    options.finestLevel = key.FinestLevel;
    options.mostNodes = key.MostNodes;
    CellSet set;
    set.Cells = hachure::surfaceCells(mesh, options);
    set.First = hachure::surfaceFrames(mesh, set.Cells);
    set.Move(mesh, state.Positions);
    found = state.Cells.emplace(key, std::move(set)).first;
  }
  return { this->Current, &found->second };
}

const std::vector<std::int32_t>& vtkPatternSurface::Facets()
{
  const std::size_t count = this->Current->Surface.triangles.size();
  if (this->FacetOfTriangle.size() == count)
  {
    return this->FacetOfTriangle;
  }
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(this->Input);
  const hachure::Span<const glm::ivec3> triangles(this->Current->Surface.triangles);
  vtkNew<vtkIdList> corners;
  this->FacetOfTriangle.clear();
  this->FacetOfTriangle.reserve(count);
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < count; begin = end)
  {
    const vtkIdType cell = this->Current->Surface.cells[begin];
    const std::int32_t block = this->Current->Surface.blockIndices[begin];
    while (end < count && this->Current->Surface.cells[end] == cell &&
      this->Current->Surface.blockIndices[end] == block)
    {
      ++end;
    }
    const auto index = static_cast<std::size_t>(block);
    const bool alike = IsCutAlike(blocks[index].Data, cell, triangles.subspan(begin, end - begin),
      this->Current->Surface.blocks[index].firstPoint, corners);
    for (std::size_t i = begin; i < end; ++i)
    {
      this->FacetOfTriangle.push_back(static_cast<std::int32_t>(alike ? i : begin));
    }
  }
  return this->FacetOfTriangle;
}

vtkPatternSurface::Part vtkPatternSurface::FindPart(vtkPolyData* drawn) const
{
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(this->Input);
  const auto same = std::find_if(blocks.begin(), blocks.end(),
    [drawn](const vtkPattern::Block& block) { return block.Data == drawn; });
  if (same != blocks.end())
  {
    return { static_cast<std::size_t>(same - blocks.begin()), nullptr };
  }
  vtkPoints* const points = vtkSurfacePart::GetPointsOfWhole(drawn);
  const auto whole = std::find_if(blocks.begin(), blocks.end(),
    [points](const vtkPattern::Block& block) { return block.Data->GetPoints() == points; });
  return { static_cast<std::size_t>(whole - blocks.begin()),
    drawn->GetCellData()->GetArray(vtkWholeSurface::GetCellIdsName()) };
}

void vtkPatternSurface::AppendPrimitiveIds(
  vtkPolyData* block, hachure::Span<const vtkIdType> cells, std::vector<float>& ids)
{
  const Part part = this->FindPart(block);
  const std::size_t object = part.Block;
  const auto start = [this](std::size_t index)
  {
    const bool known = index < this->Current->Surface.blocks.size();
    return known ? static_cast<std::size_t>(this->Current->Surface.blocks[index].firstTriangle)
                 : this->Current->Surface.triangles.size();
  };
  const auto begin =
    this->Current->Surface.cells.begin() + static_cast<std::ptrdiff_t>(start(object));
  const auto end =
    this->Current->Surface.cells.begin() + static_cast<std::ptrdiff_t>(start(object + 1));
  const std::vector<std::int32_t>& facets = this->Facets();
  ids.reserve(ids.size() + 2 * cells.size());
  auto triangle = begin;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const bool another = i == 0 || cells[i] != cells[i - 1];
    const vtkIdType cell =
      part.Cells ? static_cast<vtkIdType>(part.Cells->GetComponent(cells[i], 0)) : cells[i];
    triangle = another ? std::lower_bound(begin, end, cell) : triangle;
    const bool found = triangle != end && *triangle == cell;
    const auto index = static_cast<std::size_t>(triangle - this->Current->Surface.cells.begin());
    const bool known = object < this->Current->Surface.blocks.size();
    ids.push_back(known ? static_cast<float>(object) : -1.0f);
    ids.push_back(found ? static_cast<float>(facets[index]) : -1.0f);
    const bool more = found && triangle + 1 != end && *(triangle + 1) == cell;
    triangle += more ? 1 : 0;
  }
}

const hachure::TriangleRuns& vtkPatternSurface::Runs()
{
  const hachure::SurfaceTriangles& surface = this->Current->Surface;
  if (this->RunsOfPoints.firstOfPoint.size() != surface.points.size())
  {
    this->RunsOfPoints =
      hachure::triangleRuns(surface.points.size(), surface.triangles, this->Facets());
  }
  return this->RunsOfPoints;
}

void vtkPatternSurface::AppendRuns(vtkPolyData* block, std::vector<float>& records)
{
  const std::size_t object = this->FindPart(block).Block;
  const hachure::SurfaceTriangles& surface = this->Current->Surface;
  const bool known = object < surface.blocks.size();
  const auto first = known ? static_cast<std::size_t>(surface.blocks[object].firstPoint) : 0;
  const auto count = static_cast<std::size_t>(block->GetNumberOfPoints());
  const std::vector<std::int32_t>& runs = this->Runs().firstOfPoint;
  records.reserve(records.size() + count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool drawn = known && first + i < runs.size() && runs[first + i] >= 0;
    records.push_back(drawn ? static_cast<float>(runs[first + i]) : 0.0f);
  }
}

std::shared_ptr<hachure::NoiseSurface> vtkPatternSurface::Points(std::uint32_t seed)
{
  State& state = *this->Current;
  auto found = state.Seeds.find(seed);
  if (found == state.Seeds.end())
  {
    // Not the first positions where the surface has moved since: those of the reference.
    const std::vector<glm::dvec3> first = FiniteOf(state.Surface.points);
    hachure::NoiseSurface points({ first, state.Surface.triangles, {} }, state.Ids,
      state.Surface.blockIndices, seed, state.Areas);
    points.setPositions(state.Positions);
    found = state.Seeds.emplace(seed, std::move(points)).first;
  }
  return { this->Current, &found->second };
}

void vtkPatternSurface::StippleSet::Move(const hachure::TriangleMesh& mesh)
{
  this->Tree.setPositions(mesh.points);
  const auto places = PlacesOf(mesh, this->Living.leaving);
  if (!this->Living.leaving.empty())
  {
    this->Leaving.setPositions(places.first, places.second);
  }
}

const std::vector<glm::ivec3>& vtkPatternSurface::Outward()
{
  State& state = *this->Current;
  if (state.Outward.empty())
  {
    state.Outward = OutwardTriangles(state.Surface);
  }
  return state.Outward;
}

vtkPatternSurface::StippleSet vtkPatternSurface::MakeStipples(const StippleKey& key)
{
  State& state = *this->Current;
  const std::vector<glm::dvec3> first = FiniteOf(state.Surface.points);
  const hachure::TriangleMesh mesh = { first, this->Outward(), {} };
  const hachure::StippleOptions options = OptionsOf(key);
  hachure::StippleTreeOptions treeOptions;
  treeOptions.seed = key.Seed;
  hachure::LivingStipples living;
  const bool follows = key.Life > 0 && key.Order == hachure::StippleOrder::Progressive &&
    state.Before && state.Follows(*state.Before);
  const auto before = follows ? state.Before->Stipples.find(key) : state.Stipples.end();
  if (follows && before != state.Before->Stipples.end())
  {
    // How far surfaces move at once; of their size.
    constexpr double reach = 0.02;
    living = hachure::carryLiving({ state.Before->Positions, state.Before->Outward, {} },
      before->second.Living, mesh, key.Life, options, reach * before->second.Living.hierarchy.size);
  }
  else
  {
    living.hierarchy = hachure::stippleSurface(mesh, options);
  }
  hachure::StippleTree tree(mesh, living.hierarchy, treeOptions);
  const auto places = PlacesOf(mesh, living.leaving);
  const hachure::StippleHierarchy leaving = HierarchyOf(living);
  return { std::move(living), std::move(tree),
    hachure::StippleTree(places.first, places.second, leaving, treeOptions) };
}

std::shared_ptr<vtkPatternSurface::StippleSet> vtkPatternSurface::Stipples(const StippleKey& key)
{
  State& state = *this->Current;
  auto found = state.Stipples.find(key);
  if (found == state.Stipples.end())
  {
    found = state.Stipples.emplace(key, this->MakeStipples(key)).first;
    found->second.Move({ state.Positions, state.Outward, {} });
  }
  return { this->Current, &found->second };
}

void vtkPatternSurface::BeginAnew()
{
  this->IsAnew = true;
  this->ForgetStipples();
}

bool vtkPatternSurface::HasMoved() const
{
  const State& state = *this->Current;
  return !std::equal(state.Positions.begin(), state.Positions.end(), state.Surface.points.begin(),
    state.Surface.points.end());
}

// Those carried from surfaces before.
void vtkPatternSurface::ForgetStipples()
{
  State& state = *this->Current;
  state.Before.reset();
  for (auto set = state.Stipples.begin(); set != state.Stipples.end();)
  {
    const bool carried = !set->second.Living.shares.empty();
    set = carried ? state.Stipples.erase(set) : std::next(set);
  }
}

std::shared_ptr<hachure::StippleEdges> vtkPatternSurface::ClassicStipples(const StippleKey& key)
{
  State& state = *this->Current;
  auto found = state.ClassicStipples.find(key);
  if (found == state.ClassicStipples.end())
  {
    const std::vector<glm::dvec3> first = FiniteOf(state.Surface.points);
    const hachure::TriangleMesh mesh = { first, this->Outward(), {} };
    hachure::StippleEdges edges(mesh, hachure::stippleSurface(mesh, OptionsOf(key)));
    edges.setPositions(state.Positions);
    found = state.ClassicStipples.emplace(key, std::move(edges)).first;
  }
  return { this->Current, &found->second };
}

const vtkPatternSurfaceArray& vtkPatternSurface::Array(const std::string& name, int components)
{
  const std::pair<std::string, int> key(name, components);
  auto found = this->Arrays.find(key);
  if (found == this->Arrays.end())
  {
    const vtkPatternSurfaceArray array(this->Input, this->Current->Surface, name, components);
    found = this->Arrays.emplace(key, array).first;
  }
  return found->second;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleRefinement.h"

#include "Parallel.h"
#include "StipplePlacing.h"
#include "StippleTreeBase.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hachure
{

namespace
{

constexpr int colourCount = 8;

std::size_t at(std::int64_t index)
{
  return static_cast<std::size_t>(index);
}

int colourOf(const StippleCube& cube)
{
  return cube.childIndex(); // even or odd
}

// Calls visit(neighbour, index from 0 to 26) for the cube and those around it.
template <class Visit>
void visitNeighbours(const StippleCube& cube, Visit&& visit)
{
  for (int i = 0; i < 27; ++i)
  {
    StippleCube neighbour = cube;
    neighbour.cell += glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    if (neighbour.isInside())
    {
      visit(neighbour, i);
    }
  }
}

float aboveDensity(double density)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return std::nextafter(std::nextafter(static_cast<float>(density), infinity), infinity);
}

} // namespace

void StippleRefinement::enterBase(const std::vector<StippleNode>& nodes)
{
  this->nodeOf.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    this->nodeOf.emplace(nodes[i].code, static_cast<std::int32_t>(i));
  }
}

// The base has a node for every cube with surface.
bool StippleRefinement::meetsSurface(const StippleCube& cube, const StippleLevels& levels)
{
  return cube.level < levels.firstRefined
    ? this->isMade(cube.code())
    : (this->triangles.children(cube.parent()) >> cube.childIndex() & 1u) != 0;
}

void StippleRefinement::need(
  const StippleCube& first, const StippleLevels& levels, std::map<std::int32_t, Codes>& needed)
{
  std::vector<StippleCube> open{ first };
  while (!open.empty())
  {
    const StippleCube cube = open.back();
    open.pop_back();
    const std::uint64_t code = cube.code();
    if (cube.level < levels.firstRefined || this->isMade(code) ||
      !needed[cube.level].insert(code).second)
    {
      continue;
    }
    visitNeighbours(cube,
      [&](const StippleCube& neighbour, int)
      {
        if (this->meetsSurface(neighbour, levels))
        {
          open.push_back(neighbour.parent());
          if (colourOf(neighbour) < colourOf(cube))
          {
            open.push_back(neighbour);
          }
        }
      });
  }
}

bool StippleRefinement::refine(Work& work, const std::vector<std::int32_t>& parents)
{
  std::map<std::int32_t, Codes> needed; // by level
  for (const std::int32_t parent : parents)
  {
    const StippleCube cube = StippleCube::fromCode(work.nodes[at(parent)].code);
    for (int i = 0; i < 8; ++i)
    {
      if (this->meetsSurface(cube.child(i), work.levels))
      {
        this->need(cube.child(i), work.levels, needed);
      }
    }
  }
  return std::all_of(needed.begin(), needed.end(),
    [&](const std::pair<const std::int32_t, Codes>& level)
    { return this->make(work, level.second); });
}

bool StippleRefinement::make(Work& work, const Codes& level)
{
  std::vector<std::uint64_t> byColour[colourCount];
  for (const std::uint64_t code : level)
  {
    byColour[code & 7u].push_back(code);
  }
  bool isComplete = true;
  for (int colour = 0; colour < colourCount && isComplete; ++colour)
  {
    isComplete = this->makeColour(work, byColour[colour]);
  }
  this->link(work, level);
  return isComplete;
}

bool StippleRefinement::makeColour(Work& work, const std::vector<std::uint64_t>& codes)
{
  constexpr std::size_t perNode = 128; // in the tables of cubes
  constexpr std::size_t batch = 32;    // nodes made without a look at the room that is left
  for (std::size_t first = 0; first < codes.size(); first += batch)
  {
    if (work.progress &&
      !work.progress(static_cast<double>(first) / static_cast<double>(codes.size())))
    {
      return false;
    }
    std::vector<StippleNode> made(std::min(batch, codes.size() - first));
    parallelForRanges(static_cast<std::int64_t>(made.size()), 1,
      [&](std::int64_t i, std::int64_t) { made[at(i)] = this->fill(work, codes[first + at(i)]); });
    for (StippleNode& node : made)
    {
      const std::size_t bytes = node.memory() + perNode;
      if (bytes > work.room)
      {
        return false;
      }
      work.room -= bytes;
      this->enter(work, std::move(node));
    }
  }
  return true;
}

StippleNode StippleRefinement::fill(const Work& work, std::uint64_t code) const
{
  StippleFilling filling;
  filling.cube = StippleCube::fromCode(code);
  filling.seed = this->seed;
  this->gather(work, filling);
  const std::vector<StippleFilling::Point> points = filling.fill(this->triangles, work.levels);
  StippleNode node;
  node.code = code;
  node.level = filling.cube.level;
  node.count = static_cast<std::int32_t>(points.size());
  node.places.reserve(points.size());
  node.referenceDensities.reserve(points.size());
  const float least = aboveDensity(work.levels.inUnitsOfMesh(work.levels.leastDensity(node.level)));
  for (const StippleFilling::Point& point : points)
  {
    node.places.push_back(point.place);
    node.referenceDensities.push_back(
      std::max(least, static_cast<float>(work.levels.inUnitsOfMesh(point.density))));
  }
  placePoints(node, work.shape, work.levels);
  return node;
}

// All points around the cube: of coarser levels, and of the neighbours it depends on.
void StippleRefinement::gather(const Work& work, StippleFilling& filling) const
{
  const StippleCube& cube = filling.cube;
  const double reach = StippleFilling::reachAround(work.levels, cube.level) * cube.side();
  for (std::int32_t level = 0; level < cube.level; ++level)
  {
    const StippleCube low = StippleCube::around(cube.low() - reach, level);
    const StippleCube high = StippleCube::around(cube.low() + cube.side() + reach, level);
    for (int z = low.cell.z; z <= high.cell.z; ++z)
    {
      for (int y = low.cell.y; y <= high.cell.y; ++y)
      {
        for (int x = low.cell.x; x <= high.cell.x; ++x)
        {
          this->gatherFrom(work, { level, { x, y, z } }, reach, filling);
        }
      }
    }
  }
  visitNeighbours(cube,
    [&](const StippleCube& neighbour, int index)
    {
      if (colourOf(neighbour) < colourOf(cube) && this->isMade(neighbour.code()))
      {
        filling.filled |= 1u << index;
        this->gatherFrom(work, neighbour, reach, filling);
      }
    });
}

void StippleRefinement::gatherFrom(
  const Work& work, const StippleCube& from, double reach, StippleFilling& filling) const
{
  const auto found = this->nodeOf.find(from.code());
  if (found == this->nodeOf.end())
  {
    return;
  }
  const StippleNode& node = work.nodes[at(found->second)];
  const StippleCube& cube = filling.cube;
  const double side = cube.side();
  const glm::dvec3 middle = cube.low() + 0.5 * side;
  const double farthest = 0.5 * side + reach;
  const double area = work.levels.frame.size * work.levels.frame.size;
  const double least = work.levels.leastDensity(cube.level);
  for (std::size_t i = 0; i < node.places.size(); ++i)
  {
    const StipplePlace& place = node.places[i];
    const glm::dvec3 offset = work.levels.frame.place(work.shape.referencePlace(place)) - middle;
    if (glm::all(glm::lessThan(glm::abs(offset), glm::dvec3(farthest))))
    {
      const double density = area * static_cast<double>(node.referenceDensities[i]);
      filling.given.push_back(
        { glm::vec3(offset / side), work.shape.referenceNormal(place.triangle),
          from.level < cube.level
            ? std::numeric_limits<float>::infinity()
            : static_cast<float>(StippleFilling::roomFor(density, least) / side) });
    }
  }
}

void StippleRefinement::enter(Work& work, StippleNode&& node)
{
  const auto index = static_cast<std::int32_t>(work.nodes.size());
  node.parent = this->nodeOf.at(node.code >> 3);
  this->nodeOf.emplace(node.code, index);
  inheritBounds(work.nodes, node);
  work.nodes.push_back(std::move(node));
  gatherBounds(work.nodes, work.nodes.back());
}

// Parents of which all children are there get them.
void StippleRefinement::link(Work& work, const Codes& made)
{
  std::uint64_t last = 0;
  for (const std::uint64_t code : made)
  {
    const std::uint64_t parentCode = code >> 3;
    if (parentCode == last)
    {
      continue;
    }
    last = parentCode;
    const StippleCube parentCube = StippleCube::fromCode(parentCode);
    const unsigned children = this->triangles.children(parentCube);
    bool isComplete = true;
    for (unsigned i = 0; i < 8; ++i)
    {
      isComplete = isComplete && ((children >> i & 1u) == 0 || this->isMade(parentCode << 3 | i));
    }
    const std::int32_t parent = this->nodeOf.at(parentCode);
    if (!isComplete || work.nodes[at(parent)].childCount > 0)
    {
      continue;
    }
    for (unsigned i = 0; i < 8; ++i)
    {
      if ((children >> i & 1u) != 0)
      {
        linkChild(work.nodes, this->nodeOf.at(parentCode << 3 | i));
      }
    }
    for (std::int32_t above = parent; above >= 0; above = work.nodes[at(above)].parent)
    {
      gatherBounds(work.nodes, work.nodes[at(above)]);
    }
  }
}

void StippleRefinement::forget(std::size_t baseCount)
{
  for (auto entry = this->nodeOf.begin(); entry != this->nodeOf.end();)
  {
    entry = at(entry->second) >= baseCount ? this->nodeOf.erase(entry) : std::next(entry);
  }
}

std::size_t StippleRefinement::memory() const
{
  constexpr std::size_t perEntry = 40; // of a hash table
  return this->triangles.memory() + this->nodeOf.size() * perEntry;
}

} // namespace hachure

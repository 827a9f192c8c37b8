// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleNeighbourhood.h"

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

constexpr float borderCosine = 0.5f; // of one sheet

std::vector<StippleBorder> cut(const std::vector<StippleBorder>& borders, float longest)
{
  std::vector<StippleBorder> pieces;
  pieces.reserve(borders.size());
  for (const StippleBorder& border : borders)
  {
    const glm::vec3 side = border.ends[1] - border.ends[0];
    const int count = std::max(1, static_cast<int>(std::ceil(glm::length(side) / longest)));
    for (int i = 0; i < count; ++i)
    {
      const float begin = static_cast<float>(i) / static_cast<float>(count);
      const float end = static_cast<float>(i + 1) / static_cast<float>(count);
      pieces.push_back(
        { { border.ends[0] + begin * side, border.ends[0] + end * side }, border.normal });
    }
  }
  return pieces;
}

float distanceToBorder(const glm::vec3& place, const StippleBorder& border)
{
  const glm::vec3 side = border.ends[1] - border.ends[0];
  const float square = glm::dot(side, side);
  const float along =
    square > 0.0f ? glm::clamp(glm::dot(place - border.ends[0], side) / square, 0.0f, 1.0f) : 0.0f;
  return glm::length(place - border.ends[0] - along * side);
}

} // namespace

float stippleBorderCrowding(
  const glm::vec3& place, const glm::vec3& normal, const StippleBorder& border, float reach)
{
  if (!(glm::dot(border.normal, normal) > borderCosine))
  {
    return 0.0f;
  }
  const float distance = stippleMirrorDistance * distanceToBorder(place, border);
  return stippleCrowding(distance * distance, reach * reach);
}

StippleNeighbourhood::StippleNeighbourhood(const std::vector<StippleCandidate>& somePlaced,
  const std::vector<StippleBorder>& borders, float aReach)
  : placed(somePlaced)
  , pieces(cut(borders, 0.5f * aReach))
  , reach(aReach)
  , grid(aReach)
{
  std::vector<std::uint64_t> names;
  names.reserve(somePlaced.size());
  for (const StippleCandidate& point : somePlaced)
  {
    names.push_back(this->grid.nameOf(point.place));
  }
  this->placedCells = StippleCells(names);
  names.clear();
  names.reserve(this->pieces.size());
  for (const StippleBorder& piece : this->pieces)
  {
    names.push_back(this->grid.nameOf(0.5f * (piece.ends[0] + piece.ends[1])));
  }
  this->borderCells = StippleCells(names);
}

void StippleNeighbourhood::gather(const glm::ivec3& cell, Block& block) const
{
  const auto add = [](const StippleCells& cells, std::uint64_t name, const auto& all, auto& result)
  {
    const std::int32_t found = cells.find(name);
    if (found >= 0)
    {
      const StippleCells::Range range = cells.range(found);
      for (std::int32_t i = range.begin; i < range.end; ++i)
      {
        result.push_back(all[static_cast<std::size_t>(cells.members[static_cast<std::size_t>(i)])]);
      }
    }
  };
  block.cell = cell;
  block.placed.clear();
  block.borders.clear();
  StippleGrid::visitBlock(cell,
    [&](std::uint64_t name)
    {
      add(this->placedCells, name, this->placed, block.placed);
      add(this->borderCells, name, this->pieces, block.borders);
    });
}

const StippleNeighbourhood::Block& StippleNeighbourhood::visit(
  const glm::vec3& place, Blocks& blocks) const
{
  const glm::ivec3 cell = this->grid.cellOf(place);
  const int index = (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4;
  Block& block = blocks.blocks[static_cast<std::size_t>(index)];
  if (cell != block.cell)
  {
    this->gather(cell, block);
  }
  return block;
}

float StippleNeighbourhood::crowding(
  const glm::vec3& place, const glm::vec3& normal, Blocks& blocks, float limit) const
{
  const Block& block = this->visit(place, blocks);
  const float reachSquare = this->reach * this->reach;
  float sum = 0.0f;
  for (const StippleCandidate& other : block.placed)
  {
    const glm::vec3 offset = place - other.place;
    const float square = glm::dot(offset, offset);
    if (square < reachSquare && stipplesMatter(normal, other.normal))
    {
      sum += stippleCrowding(square, reachSquare);
      if (sum > limit)
      {
        return sum;
      }
    }
  }
  float byBorder = 0.0f;
  for (const StippleBorder& border : block.borders)
  {
    byBorder = std::max(byBorder, stippleBorderCrowding(place, normal, border, this->reach));
  }
  return sum + byBorder;
}

float StippleNeighbourhood::leastCrowding(
  const std::array<glm::vec3, 3>& corners, const glm::vec3& normal, Blocks& blocks) const
{
  const float reachSquare = this->reach * this->reach;
  const auto squareBetween = [](const glm::vec3& a, const glm::vec3& b)
  { return glm::dot(a - b, a - b); };
  if (squareBetween(corners[0], corners[1]) > reachSquare ||
    squareBetween(corners[0], corners[2]) > reachSquare)
  {
    return 0.0f;
  }
  const Block& block = this->visit((corners[0] + corners[1] + corners[2]) / 3.0f, blocks);
  float sum = 0.0f;
  for (const StippleCandidate& other : block.placed)
  {
    // Nothing of a triangle is farther away than its farthest corner.
    const float square = std::max({ squareBetween(other.place, corners[0]),
      squareBetween(other.place, corners[1]), squareBetween(other.place, corners[2]) });
    if (square < reachSquare && stipplesMatter(normal, other.normal))
    {
      sum += stippleCrowding(square, reachSquare);
    }
  }
  return sum;
}

} // namespace hachure

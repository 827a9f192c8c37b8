// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleCrowd.h"

#include "StippleNeighbourhood.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hachure
{

StippleCrowd::StippleCrowd(float width, float aReach, float aMostCrowded)
  : half(0.5f * width)
  , reach(aReach)
  , reachSquare(aReach * aReach)
  , mostCrowded(aMostCrowded)
  , cellsPerLength(1.0f / aReach)
  , count(std::max(1, static_cast<int>(std::ceil(width / aReach))))
{
}

bool StippleCrowd::isWithin(const glm::vec3& place) const
{
  return std::max({ std::abs(place.x), std::abs(place.y), std::abs(place.z) }) < this->half;
}

glm::ivec3 StippleCrowd::cellOf(const glm::vec3& place) const
{
  const glm::ivec3 cell((place + this->half) * this->cellsPerLength); // above 0: cut off is floor
  return glm::clamp(cell, glm::ivec3(0), glm::ivec3(this->count - 1));
}

template <class Visit>
void StippleCrowd::visitBlock(const glm::ivec3& from, const glm::ivec3& to, Visit&& visit) const
{
  const glm::ivec3 low = glm::max(from, glm::ivec3(0));
  const glm::ivec3 high = glm::min(to, glm::ivec3(this->count - 1));
  for (int z = low.z; z <= high.z; ++z)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        visit(this->indexOf({ x, y, z }));
      }
    }
  }
}

template <class T>
std::vector<std::int32_t> StippleCrowd::sortByCell(
  const std::vector<T>& items, std::vector<std::int32_t>& firstOfCell) const
{
  const auto side = static_cast<std::size_t>(this->count);
  const std::size_t cellCount = side * side * side;
  firstOfCell.assign(cellCount + 1, 0);
  std::vector<std::int32_t> cellOfItem(items.size(), -1);
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (this->isWithin(items[i].place))
    {
      const std::size_t cell = this->indexOf(this->cellOf(items[i].place));
      cellOfItem[i] = static_cast<std::int32_t>(cell);
      ++firstOfCell[cell + 1];
    }
  }
  for (std::size_t cell = 0; cell < cellCount; ++cell)
  {
    firstOfCell[cell + 1] += firstOfCell[cell];
  }
  std::vector<std::int32_t> sorted(static_cast<std::size_t>(firstOfCell.back()));
  std::vector<std::int32_t> next(firstOfCell.begin(), firstOfCell.end() - 1);
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (cellOfItem[i] >= 0)
    {
      const auto slot = next[static_cast<std::size_t>(cellOfItem[i])]++;
      sorted[static_cast<std::size_t>(slot)] = static_cast<std::int32_t>(i);
    }
  }
  return sorted;
}

void StippleCrowd::setAround(
  const std::vector<Point>& somePoints, const std::vector<StippleBorder>& borders)
{
  const std::vector<std::int32_t> order = this->sortByCell(somePoints, this->firstPoint);
  this->points.clear();
  this->points.reserve(order.size());
  for (const std::int32_t i : order)
  {
    this->points.push_back(somePoints[static_cast<std::size_t>(i)]);
  }
  this->around.assign(this->firstPoint.size() - 1, Around());
  for (const StippleBorder& border : borders)
  {
    this->addBorder(border);
  }
}

void StippleCrowd::addBorder(const StippleBorder& border)
{
  const float farthest = this->reach / stippleMirrorDistance;
  const glm::vec3 low = glm::min(border.ends[0], border.ends[1]) - farthest;
  const glm::vec3 high = glm::max(border.ends[0], border.ends[1]) + farthest;
  if (glm::all(glm::lessThan(low, glm::vec3(this->half))) &&
    glm::all(glm::greaterThan(high, glm::vec3(-this->half))))
  {
    this->visitBlock(this->cellOf(glm::max(low, glm::vec3(-this->half))),
      this->cellOf(glm::min(high, glm::vec3(this->half))),
      [&](std::size_t index) { this->around[index].borders.push_back(border); });
  }
}

const StippleCrowd::Around& StippleCrowd::aroundOf(const glm::ivec3& cell)
{
  Around& result = this->around[this->indexOf(cell)];
  if (!result.isKnown)
  {
    result.isKnown = true;
    result.begin = static_cast<std::int32_t>(this->aroundPoints.size());
    const auto add = [this](std::size_t other)
    {
      this->aroundPoints.insert(this->aroundPoints.end(),
        this->points.begin() + this->firstPoint[other],
        this->points.begin() + this->firstPoint[other + 1]);
    };
    const std::size_t own = this->indexOf(cell);
    add(own); // most places are left out because of a point near by
    this->visitAround(cell,
      [&](std::size_t other)
      {
        if (other != own)
        {
          add(other);
        }
      });
    result.end = static_cast<std::int32_t>(this->aroundPoints.size());
  }
  return result;
}

void StippleCrowd::offer(const Candidate& candidate)
{
  if (!this->isWithin(candidate.place))
  {
    return;
  }
  float crowding = 0.0f;
  const Around& near = this->aroundOf(this->cellOf(candidate.place));
  for (std::int32_t i = near.begin; i < near.end; ++i)
  {
    const Point& point = this->aroundPoints[static_cast<std::size_t>(i)];
    const glm::vec3 offset = candidate.place - point.place;
    const float square = glm::dot(offset, offset);
    if (square < this->reachSquare && square < point.nearer * point.nearer &&
      stipplesMatter(candidate.normal, point.normal))
    {
      crowding += stippleCrowding(square, this->reachSquare);
      if (crowding > this->mostCrowded)
      {
        return;
      }
    }
  }
  float byBorder = 0.0f;
  for (const StippleBorder& border : near.borders)
  {
    byBorder = std::max(
      byBorder, stippleBorderCrowding(candidate.place, candidate.normal, border, this->reach));
  }
  if (crowding + byBorder <= this->mostCrowded)
  {
    this->candidates.push_back(candidate);
    this->candidates.back().crowding = crowding + byBorder;
  }
}

void StippleCrowd::begin()
{
  std::vector<std::int32_t> firstOfCell;
  const std::vector<std::int32_t> order = this->sortByCell(this->candidates, firstOfCell);
  std::vector<Candidate> sorted;
  sorted.reserve(order.size());
  for (const std::int32_t i : order)
  {
    sorted.push_back(this->candidates[static_cast<std::size_t>(i)]);
  }
  this->candidates = std::move(sorted);
  this->cells.assign(firstOfCell.size() - 1, Cell());
  for (std::size_t i = 0; i < this->cells.size(); ++i)
  {
    this->cells[i].begin = firstOfCell[i];
    this->cells[i].end = firstOfCell[i + 1];
    if (this->cells[i].begin < this->cells[i].end)
    {
      this->filledCells.push_back(static_cast<std::int32_t>(i));
      this->findBest(this->cells[i]);
    }
  }
}

void StippleCrowd::findBest(Cell& cell)
{
  cell.best = -1;
  cell.leastCrowding = std::numeric_limits<float>::infinity();
  for (std::int32_t i = cell.begin; i < cell.end;)
  {
    const float crowding = this->candidates[static_cast<std::size_t>(i)].crowding;
    if (crowding > this->mostCrowded)
    {
      --cell.end;
      this->candidates[static_cast<std::size_t>(i)] =
        this->candidates[static_cast<std::size_t>(cell.end)];
      continue;
    }
    if (crowding < cell.leastCrowding)
    {
      cell.leastCrowding = crowding;
      cell.best = i;
    }
    ++i;
  }
}

const StippleCrowd::Candidate* StippleCrowd::least()
{
  std::int32_t best = -1;
  float leastCrowding = std::numeric_limits<float>::infinity();
  std::size_t kept = 0;
  for (const std::int32_t index : this->filledCells)
  {
    const Cell& cell = this->cells[static_cast<std::size_t>(index)];
    this->filledCells[kept] = index;
    kept += cell.best >= 0 ? 1 : 0; // an empty one stays empty
    if (cell.leastCrowding < leastCrowding)
    {
      leastCrowding = cell.leastCrowding;
      best = cell.best;
    }
  }
  this->filledCells.resize(kept);
  return best >= 0 ? &this->candidates[static_cast<std::size_t>(best)] : nullptr;
}

void StippleCrowd::crowdBy(const Point& point)
{
  if (!this->isWithin(point.place))
  {
    return;
  }
  const bool isAlways = std::isinf(point.nearer);
  const float fromSquare = isAlways ? -1.0f : point.nearer * point.nearer;
  this->visitAround(this->cellOf(point.place),
    [&](std::size_t index)
    {
      Cell& cell = this->cells[index];
      for (std::int32_t i = cell.begin; i < cell.end; ++i)
      {
        Candidate& candidate = this->candidates[static_cast<std::size_t>(i)];
        const glm::vec3 offset = candidate.place - point.place;
        const float square = glm::dot(offset, offset);
        if (square < this->reachSquare && square >= fromSquare &&
          stipplesMatter(candidate.normal, point.normal))
        {
          candidate.crowding += stippleCrowding(square, this->reachSquare);
        }
      }
      this->findBest(cell);
    });
}

} // namespace hachure

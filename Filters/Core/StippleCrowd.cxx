// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleCrowd.h"

#include "StippleNeighbourhood.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

StippleCrowd::StippleCrowd(float width, float aReach)
  : half(0.5f * width)
  , reach(aReach)
  , reachSquare(aReach * aReach)
  , count(std::max(1, static_cast<int>(std::ceil(width / aReach))))
{
}

bool StippleCrowd::isWithin(const glm::vec3& place) const
{
  return std::max({ std::abs(place.x), std::abs(place.y), std::abs(place.z) }) < this->half;
}

glm::ivec3 StippleCrowd::cellOf(const glm::vec3& place) const
{
  const glm::ivec3 cell((place + this->half) / this->reach); // above 0: cut off is floor
  return glm::clamp(cell, glm::ivec3(0), glm::ivec3(this->count - 1));
}

template <class Visit>
void StippleCrowd::visitAround(const glm::ivec3& cell, Visit&& visit) const
{
  const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0));
  const glm::ivec3 high = glm::min(cell + 1, glm::ivec3(this->count - 1));
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
  const auto cellCount = static_cast<std::size_t>(this->count * this->count * this->count);
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

void StippleCrowd::begin(std::vector<Candidate>&& someCandidates, const std::vector<Point>& points,
  const std::vector<StippleBorder>& borders, float aMostCrowded)
{
  this->mostCrowded = aMostCrowded;
  std::vector<std::int32_t> firstOfCell, firstPoint;
  const std::vector<std::int32_t> order = this->sortByCell(someCandidates, firstOfCell);
  const std::vector<std::int32_t> pointOrder = this->sortByCell(points, firstPoint);
  this->candidates.clear();
  this->candidates.reserve(order.size());
  for (const std::int32_t i : order)
  {
    this->candidates.push_back(someCandidates[static_cast<std::size_t>(i)]);
  }
  this->cells.assign(firstOfCell.size() - 1, Cell());
  for (std::size_t i = 0; i < this->cells.size(); ++i)
  {
    this->cells[i].begin = firstOfCell[i];
    this->cells[i].end = firstOfCell[i + 1];
    if (this->cells[i].begin < this->cells[i].end)
    {
      this->filledCells.push_back(static_cast<std::int32_t>(i));
    }
  }
  this->crowdByBorders(borders);
  std::vector<Point> around;
  for (const std::int32_t index : this->filledCells)
  {
    const Cell& cell = this->cells[static_cast<std::size_t>(index)];
    around.clear();
    this->visitAround(this->cellOf(this->candidates[static_cast<std::size_t>(cell.begin)].place),
      [&](std::size_t other)
      {
        for (std::int32_t i = firstPoint[other]; i < firstPoint[other + 1]; ++i)
        {
          around.push_back(
            points[static_cast<std::size_t>(pointOrder[static_cast<std::size_t>(i)])]);
        }
      });
    this->crowdCell(static_cast<std::size_t>(index), around);
  }
}

void StippleCrowd::crowdByBorders(const std::vector<StippleBorder>& borders)
{
  const float farthest = this->reach / stippleMirrorDistance;
  for (const StippleBorder& border : borders)
  {
    const glm::vec3 low = glm::min(border.ends[0], border.ends[1]) - farthest;
    const glm::vec3 high = glm::max(border.ends[0], border.ends[1]) + farthest;
    if (glm::any(glm::greaterThan(low, glm::vec3(this->half))) ||
      glm::any(glm::lessThan(high, glm::vec3(-this->half))))
    {
      continue;
    }
    const glm::ivec3 first = this->cellOf(glm::max(low, glm::vec3(-this->half)));
    const glm::ivec3 last = this->cellOf(glm::min(high, glm::vec3(this->half)));
    for (int i = 0; i < (last.x - first.x + 1) * (last.y - first.y + 1) * (last.z - first.z + 1);
         ++i)
    {
      const int width = last.x - first.x + 1;
      const int height = last.y - first.y + 1;
      const Cell& cell = this->cells[this->indexOf(
        first + glm::ivec3(i % width, i / width % height, i / width / height))];
      for (std::int32_t k = cell.begin; k < cell.end; ++k)
      {
        Candidate& candidate = this->candidates[static_cast<std::size_t>(k)];
        candidate.crowding = std::max(candidate.crowding,
          stippleBorderCrowding(candidate.place, candidate.normal, border, this->reach));
      }
    }
  }
}

void StippleCrowd::crowdCell(std::size_t index, const std::vector<Point>& around)
{
  Cell& cell = this->cells[index];
  for (std::int32_t i = cell.begin; i < cell.end; ++i)
  {
    Candidate& candidate = this->candidates[static_cast<std::size_t>(i)];
    float sum = 0.0f;
    for (const Point& point : around)
    {
      const glm::vec3 offset = candidate.place - point.place;
      const float square = glm::dot(offset, offset);
      if (square < this->reachSquare && square < point.nearer * point.nearer &&
        stipplesMatter(candidate.normal, point.normal))
      {
        sum += stippleCrowding(square, this->reachSquare);
      }
    }
    candidate.crowding += sum;
  }
  this->findBest(cell);
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

const StippleCrowd::Candidate* StippleCrowd::least() const
{
  const Cell* best = nullptr;
  for (const std::int32_t index : this->filledCells)
  {
    const Cell& cell = this->cells[static_cast<std::size_t>(index)];
    if (cell.best >= 0 && (best == nullptr || cell.leastCrowding < best->leastCrowding))
    {
      best = &cell;
    }
  }
  return best != nullptr ? &this->candidates[static_cast<std::size_t>(best->best)] : nullptr;
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

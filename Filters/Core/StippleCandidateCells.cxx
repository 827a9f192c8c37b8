// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleCandidateCells.h"

#include "Parallel.h"
#include "StippleNeighbourhood.h"
#include "StippleProgressive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hachure
{

namespace
{

std::size_t at(std::int64_t index)
{
  return static_cast<std::size_t>(index);
}

} // namespace

StippleCandidateCells::StippleCandidateCells(
  const std::vector<StippleCandidate>& someCandidates, float side)
  : reachSquare(side * side)
{
  const StippleGrid grid(side);
  std::vector<std::uint64_t> names(someCandidates.size());
  parallelFor(static_cast<std::int64_t>(names.size()),
    [&](std::int64_t i) { names[at(i)] = grid.nameOf(someCandidates[at(i)].place); });
  this->cells = StippleCells(names);
  this->candidates.resize(someCandidates.size());
  parallelFor(static_cast<std::int64_t>(names.size()),
    [&](std::int64_t i)
    { this->candidates[at(i)] = someCandidates[at(this->cells.members[at(i)])]; });
  this->linkNeighbours(side);
  this->best[New].resize(at(this->cells.size()));
  this->best[Carried].resize(at(this->cells.size()));
  this->firstCarried.resize(at(this->cells.size()));
  this->chosen.assign(at(this->cells.size()), -1);
  this->isTouched.assign(at(this->cells.size()), 0);
  parallelFor(this->cells.size(),
    [this](std::int64_t cell)
    {
      const StippleCells::Range range = this->cells.range(static_cast<std::int32_t>(cell));
      std::int32_t first = range.end; // carried candidates came last, and so they are in the cell
      while (first > range.begin && this->candidates[at(first - 1)].triangle < 0)
      {
        --first;
      }
      this->firstCarried[at(cell)] = first;
      this->findBest(static_cast<std::int32_t>(cell));
    });
}

void StippleCandidateCells::linkNeighbours(float side)
{
  const StippleGrid grid(side);
  constexpr std::int64_t grain = 1024;
  const std::int64_t count = this->cells.size();
  std::vector<std::vector<std::int32_t>> parts(at(count / grain + 1));
  this->firstNeighbour.assign(at(count + 1), 0);
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::int32_t>& part = parts[at(begin / grain)];
      for (std::int64_t cell = begin; cell < end; ++cell)
      {
        const StippleCells::Range range = this->cells.range(static_cast<std::int32_t>(cell));
        const std::size_t before = part.size();
        StippleGrid::visitBlock(grid.cellOf(this->candidates[at(range.begin)].place),
          [&](std::uint64_t name)
          {
            const std::int32_t found = this->cells.find(name);
            if (found >= 0)
            {
              part.push_back(found);
            }
          });
        this->firstNeighbour[at(cell + 1)] = static_cast<std::int32_t>(part.size() - before);
      }
    });
  for (std::int64_t cell = 0; cell < count; ++cell)
  {
    this->firstNeighbour[at(cell + 1)] += this->firstNeighbour[at(cell)];
  }
  this->neighbours.reserve(at(this->firstNeighbour.back()));
  for (const std::vector<std::int32_t>& part : parts)
  {
    this->neighbours.insert(this->neighbours.end(), part.begin(), part.end());
  }
}

void StippleCandidateCells::findBest(std::int32_t cell)
{
  Best result;
  for (std::int32_t i = this->cells.range(cell).begin; i < this->firstCarried[at(cell)]; ++i)
  {
    const Best other = { this->candidates[at(i)].crowding, i };
    if (result.candidate < 0 || this->isBetter(other, result))
    {
      result = other;
    }
  }
  this->best[New][at(cell)] = result;
}

void StippleCandidateCells::findBestCarried(std::int32_t cell)
{
  Best result;
  for (std::int32_t i = this->firstCarried[at(cell)]; i < this->cells.range(cell).end; ++i)
  {
    const Best other = { this->candidates[at(i)].crowding, i };
    if (carriedIndex(this->candidates[at(i)]) < this->carriedDue &&
      (result.candidate < 0 || this->isBetter(other, result)))
    {
      result = other;
    }
  }
  this->best[Carried][at(cell)] = result;
}

void StippleCandidateCells::chooseCarried(std::int32_t due)
{
  this->kind = Carried;
  this->carriedDue = due;
  parallelFor(this->cells.size(),
    [this](std::int64_t cell) { this->findBestCarried(static_cast<std::int32_t>(cell)); });
}

// Whether no better candidate is so near that it would change this one's room by much.
bool StippleCandidateCells::isChosen(std::int32_t cell) const
{
  constexpr float nearRatio = 1.5f; // of distance and room
  const Best& own = this->bestOf(cell);
  const StippleCandidate& candidate = this->candidates[at(own.candidate)];
  const float nearest = nearRatio * stippleRoom(own.crowding, std::sqrt(this->reachSquare));
  for (std::int32_t k = this->firstNeighbour[at(cell)]; k < this->firstNeighbour[at(cell + 1)]; ++k)
  {
    const std::int32_t neighbour = this->neighbours[at(k)];
    const Best& other = this->bestOf(neighbour);
    if (neighbour != cell && this->isBetter(other, own))
    {
      const StippleCandidate& better = this->candidates[at(other.candidate)];
      if (glm::length(better.place - candidate.place) < nearest &&
        stipplesMatter(better.normal, candidate.normal))
      {
        return false;
      }
    }
  }
  return true;
}

void StippleCandidateCells::place(std::int32_t cell, std::vector<StippleCandidate>& placed)
{
  placed.push_back(this->candidates[at(this->bestOf(cell).candidate)]);
  this->chosen[at(cell)] = this->bestOf(cell).candidate;
}

// Takes the points just placed around a cell into account.
void StippleCandidateCells::crowd(std::int32_t cell)
{
  const StippleCells::Range range = this->cells.range(cell);
  for (std::int32_t k = this->firstNeighbour[at(cell)]; k < this->firstNeighbour[at(cell + 1)]; ++k)
  {
    const std::int32_t other = this->chosen[at(this->neighbours[at(k)])];
    if (other >= 0)
    {
      const StippleCandidate point = this->candidates[at(other)];
      for (std::int32_t i = range.begin; i < range.end; ++i)
      {
        StippleCandidate& candidate = this->candidates[at(i)];
        const glm::vec3 offset = candidate.place - point.place;
        const float square = glm::dot(offset, offset);
        if (square < this->reachSquare && stipplesMatter(candidate.normal, point.normal))
        {
          candidate.crowding += stippleCrowding(square, this->reachSquare);
        }
      }
    }
  }
  this->findBest(cell);
  this->findBestCarried(cell);
}

void StippleCandidateCells::fill(float mostCrowded, std::vector<StippleCandidate>& placed)
{
  std::vector<std::int32_t> open; // cells that have a candidate with room enough
  for (std::int32_t cell = 0; cell < this->cells.size(); ++cell)
  {
    if (this->bestOf(cell).crowding <= mostCrowded)
    {
      open.push_back(cell);
    }
  }
  std::vector<char> isFree;
  std::vector<std::int32_t> touched, placing;
  while (!open.empty())
  {
    isFree.assign(open.size(), 0);
    parallelFor(static_cast<std::int64_t>(open.size()),
      [&](std::int64_t i) { isFree[at(i)] = this->isChosen(open[at(i)]) ? 1 : 0; });
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      if (isFree[i] != 0)
      {
        this->place(open[i], placed);
        placing.push_back(open[i]);
        const std::int32_t end = this->firstNeighbour[at(open[i] + 1)];
        for (std::int32_t k = this->firstNeighbour[at(open[i])]; k < end; ++k)
        {
          const std::int32_t neighbour = this->neighbours[at(k)];
          if (this->isTouched[at(neighbour)] == 0)
          {
            this->isTouched[at(neighbour)] = 1;
            touched.push_back(neighbour);
          }
        }
      }
    }
    parallelFor(static_cast<std::int64_t>(touched.size()),
      [&](std::int64_t i) { this->crowd(touched[at(i)]); });
    for (const std::int32_t cell : touched)
    {
      this->isTouched[at(cell)] = 0;
    }
    for (const std::int32_t cell : placing)
    {
      this->chosen[at(cell)] = -1;
    }
    touched.clear();
    placing.clear();
    open.erase(std::remove_if(open.begin(), open.end(),
                 [&](std::int32_t cell) { return this->bestOf(cell).crowding > mostCrowded; }),
      open.end());
  }
}

} // namespace hachure

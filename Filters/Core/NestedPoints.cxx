// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NestedPoints.h"

// Farthest-point order (Eldar et al. 1997) under a constraint. The first points are one cycle of
// the doubling map x -> 2x modulo 1: the multiples of 1 / (2^m - 1) have cycles of m points. Every
// further point lies near one of the four points that doubling carries to an earlier one, so that
// the set stays closed. Those places are four times as dense as the points, and each may move a
// little: freedom enough to fill the widest gap each time.

#include "Random.h"
#include "TileChecks.h"

#include <algorithm>
#include <queue>

namespace hachure
{
namespace
{

// Choices per place; the first is the place itself.
constexpr int movesPerPlace = 32;
// How far a point may move from its place, in mean spacings: well inside the mark drawn there.
constexpr double farthestMove = 0.35;

struct Candidate
{
  double distance; // squared, to the nearest point when last looked at
  std::int64_t order;
  TorusPoint place;

  bool operator<(const Candidate& other) const
  {
    return this->distance != other.distance ? this->distance < other.distance
                                            : this->order > other.order;
  }
};

double wrapped(double position)
{
  const double rest = position - std::floor(position);
  return rest < 1.0 ? rest : 0.0; // just below a whole number it rounds up
}

// The best spread of a few cycles of `length` points; (0, 0) alone for length 1.
std::vector<TorusPoint> firstCycle(int length, std::uint32_t seed)
{
  constexpr std::uint64_t attempts = 48;
  const std::uint32_t denominator = (1u << length) - 1;
  std::vector<TorusPoint> best{ TorusPoint() };
  double widest = -1.0;
  for (std::uint64_t attempt = 0; attempt < attempts && length > 1; ++attempt)
  {
    auto x = static_cast<std::uint32_t>(unitRandom(seed, attempt, 0) * denominator);
    auto y = static_cast<std::uint32_t>(unitRandom(seed, attempt, 1) * denominator);
    TorusGrid cycle(1);
    double narrowest = 2.0;
    for (int i = 0; i < length; ++i)
    {
      const TorusPoint point = { static_cast<double>(x) / denominator,
        static_cast<double>(y) / denominator };
      narrowest = std::min(narrowest, cycle.nearestSquared(point.x, point.y));
      cycle.add(point);
      x = x * 2 % denominator;
      y = y * 2 % denominator;
    }
    if (narrowest > widest)
    {
      widest = narrowest;
      best = cycle.points();
    }
  }
  return best;
}

// Primes, whose cycles are all of full length but for the origin.
int cycleLength(int count)
{
  return count >= 36 ? 7 : count >= 16 ? 5 : count >= 4 ? 3 : 1;
}

class GapFiller
{
public:
  GapFiller(int count, std::uint32_t seedIn)
    : grid(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count)))))
    , reach(farthestMove / std::sqrt(static_cast<double>(count)))
    , seed(seedIn)
  {
  }

  void add(const TorusPoint& point)
  {
    this->grid.add(point);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      for (int move = 0; move < movesPerPlace; ++move)
      {
        const auto id = static_cast<std::uint64_t>(this->order);
        const double angle = 2.0 * pi * unitRandom(this->seed, id, 20);
        const double step =
          move > 0 ? this->reach * std::sqrt(unitRandom(this->seed, id, 21)) : 0.0;
        const int right = quarter % 2;
        const int upper = quarter / 2;
        const TorusPoint place = { wrapped(0.5 * (point.x + right) + step * std::cos(angle)),
          wrapped(0.5 * (point.y + upper) + step * std::sin(angle)) };
        this->queue.push({ this->grid.nearestSquared(place.x, place.y), this->order, place });
        ++this->order;
      }
    }
  }

  // The place in the widest gap; distances only ever shrink, so that an old one is an upper bound.
  TorusPoint takeFarthest()
  {
    while (true)
    {
      Candidate top = this->queue.top();
      this->queue.pop();
      const double now = this->grid.nearestSquared(top.place.x, top.place.y);
      if (now >= top.distance || this->queue.empty())
      {
        return top.place;
      }
      top.distance = now;
      this->queue.push(top);
    }
  }

  const TorusGrid& found() const { return this->grid; }

private:
  TorusGrid grid;
  double reach;
  std::uint32_t seed;
  std::int64_t order = 0;
  std::priority_queue<Candidate> queue;
};

} // namespace

TorusGrid::TorusGrid(int cellsAcross)
  : cells(cellsAcross)
  , members(static_cast<std::size_t>(cellsAcross) * cellsAcross)
{
}

int TorusGrid::cellOf(double position) const
{
  return std::clamp(static_cast<int>(position * this->cells), 0, this->cells - 1);
}

void TorusGrid::add(const TorusPoint& point)
{
  const int column = this->cellOf(point.x);
  const int row = this->cellOf(point.y);
  this->members[static_cast<std::size_t>(row) * this->cells + column].push_back(
    static_cast<int>(this->all.size()));
  this->all.push_back(point);
}

double TorusGrid::nearestSquared(double x, double y) const
{
  double nearest = 2.0;
  const auto look = [&nearest](int, double dx, double dy)
  { nearest = std::min(nearest, dx * dx + dy * dy); };
  const int column = this->cellOf(x);
  const int row = this->cellOf(y);
  // Rings of cells, until what lies outside cannot be nearer.
  for (int ring = 0; ring <= this->cells; ++ring)
  {
    const double sure = static_cast<double>(ring - 1) / this->cells;
    if (ring > 0 && sure > 0.0 && sure * sure >= nearest)
    {
      break;
    }
    for (int j = -ring; j <= ring; ++j)
    {
      const int step = std::abs(j) == ring ? 1 : std::max(1, 2 * ring);
      for (int i = -ring; i <= ring; i += step)
      {
        this->visitCell(column + i, row + j, x, y, look);
      }
    }
  }
  return nearest;
}

std::vector<TorusPoint> nestedPoints(int count, std::uint32_t seed)
{
  check::inRange("nestedPoints", "count", count, 1, 131072);
  GapFiller filler(count, seed);
  for (const TorusPoint& point : firstCycle(cycleLength(count), seed))
  {
    filler.add(point);
  }
  while (static_cast<int>(filler.found().points().size()) < count)
  {
    filler.add(filler.takeFarthest());
  }
  return filler.found().points();
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleProgressive.h"

// Farthest-point order (Eldar et al. 1997): the next point goes to where there is most room, the
// middle of the widest gap. So the first n points are, for every n, about as far apart as their
// gaps are wide.
//
// The radius of the gaps, the most room there is, shrinks in *octaves*, in which the number of
// points doubles. In each the places to choose from are *candidates*, many for every point there
// will be, made anew; those which have too little room even for its end are left out at once. The
// others are in cells as wide as points matter, so that a point matters to the cells around its own
// only.
//
// An octave is a sequence of *rounds*, in which all gaps wider than a radius are filled. In a round
// cells work at the same time: each proposes its best candidate, the least crowded, and it is
// placed unless a neighbour's better one is near; until all candidates are too crowded. A round's
// points are then sorted by room. No choice depends on the order of work.
//
// Carried points take part as candidates that nobody chooses unless they are due: in a round, those
// first that had come in at the density of now, and with a little less room than the radius; then
// those that soon would, where there is a gap of that radius; then new ones.

#include "Parallel.h"
#include "Random.h"
#include "StippleCandidateCells.h"
#include "StippleNeighbourhood.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

namespace hachure
{

namespace
{

// Candidates for every point that is there at the end of an octave: the more there are, the nearer
// to the middle of its gap a point is, which the eye sees among some thousand points but not among
// a million. The first points are roughly placed, so that no lattice grows around them.
constexpr double mostPerPoint = 256.0;
constexpr double leastPerPoint = 20.0;
constexpr double manyCandidates = 2e6;
constexpr double firstPoints = 64.0;
constexpr double firstPerPoint = 48.0;

constexpr float octaveRatio = 0.70710678f; // of radii: twice the density
constexpr float roundRatio = 0.97f;        // of radii
constexpr float reachRatio = 1.6f;         // of the radius at the beginning of an octave
// Points that fill an area up to a radius: 0.45 area / radius^2 (measured).
constexpr double pointsPerDisc = 0.45;
constexpr float finestRadius = 1e-6f; // floats within 1 do not resolve less
constexpr std::int64_t candidateGrain = 16384;

// Of the radius of a round. Measured: with 0.7 after ten changes the evenness R is 1.63, with 0.75
// 1.66; with 0.85 a quarter of the points of an unchanged surface go, with 0.75 none.
constexpr float leastCarriedRoom = 0.75f;
constexpr double soonRatio = 1.25; // of densities

std::size_t at(std::int64_t index)
{
  return static_cast<std::size_t>(index);
}

// The candidates that may be placed in an octave.
struct Survivors
{
  std::vector<StippleCandidate> candidates;
  float leastLeftOut = std::numeric_limits<float>::infinity(); // crowding
};

Survivors makeCandidates(const StippleSource& source, std::int64_t count,
  const StippleNeighbourhood& around, float mostCrowded)
{
  std::vector<Survivors> parts(at((count + candidateGrain - 1) / candidateGrain));
  parallelForRanges(count, candidateGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      Survivors& part = parts[at(begin / candidateGrain)];
      part.leastLeftOut = source.make(begin, end, around, mostCrowded, part.candidates);
    });
  Survivors all;
  std::size_t total = 0;
  for (const Survivors& part : parts)
  {
    total += part.candidates.size();
  }
  all.candidates.reserve(total);
  for (Survivors& part : parts)
  {
    all.leastLeftOut = std::min(all.leastLeftOut, part.leastLeftOut);
    all.candidates.insert(all.candidates.end(), part.candidates.begin(), part.candidates.end());
    part.candidates = std::vector<StippleCandidate>(); // not all of them twice
  }
  return all;
}

// Crowding to the eighth of a length.
float crowdingFor(float room, float reach)
{
  return stippleCrowding(room * room, reach * reach);
}

// Crowding of the points just placed becomes their room, the most first.
void sortByRoom(
  std::vector<StippleCandidate>& points, std::size_t first, float reach, float mostRoom)
{
  std::stable_sort(points.begin() + static_cast<std::ptrdiff_t>(first), points.end(),
    [](const StippleCandidate& a, const StippleCandidate& b) { return a.crowding < b.crowding; });
  for (std::size_t i = first; i < points.size(); ++i)
  {
    points[i].crowding = std::min(mostRoom, stippleRoom(points[i].crowding, reach));
  }
}

std::int64_t candidatesFor(double area, float radius, std::size_t placed)
{
  const double fromArea = pointsPerDisc * area / (static_cast<double>(radius) * radius);
  const double points = std::max({ 1.0, fromArea, 1.4 * static_cast<double>(placed) });
  const double perPoint = points < firstPoints
    ? firstPerPoint
    : std::clamp(manyCandidates / points, leastPerPoint, mostPerPoint);
  return static_cast<std::int64_t>(perPoint * points);
}

// The end of the round by which there should be `count` points: those placed fill the area up to a
// radius, and twice as many up to one of 1 / sqrt(2).
float radiusFor(std::int64_t count, std::size_t placed, float radius)
{
  constexpr std::size_t fewPoints = 2000; // for which all candidates are soon made
  constexpr double margin = 0.97;
  const double wanted =
    margin * radius * std::sqrt(static_cast<double>(placed) / static_cast<double>(count));
  while (placed >= fewPoints && radius > wanted)
  {
    radius *= roundRatio;
  }
  return placed < fewPoints ? 0.0f : radius;
}

class GapFiller
{
public:
  GapFiller(StippleSource& someSource, double anArea, const std::vector<StippleBorder>& someBorders,
    std::int64_t wanted, const ProgressFn& aProgress, const CarriedCandidates& someCarried)
    : source(someSource)
    , area(anArea)
    , borders(someBorders)
    , count(wanted)
    , progress(aProgress)
    , carried(someCarried)
  {
    this->placed.reserve(at(wanted));
  }

  std::vector<StippleCandidate> run()
  {
    for (std::uint32_t octave = 0; this->radius > finestRadius && !this->isComplete(); ++octave)
    {
      const float first = this->radius;
      const std::size_t before = this->placed.size();
      const float last = first * octaveRatio;
      const std::int64_t candidates =
        this->source.prepare(candidatesFor(this->area, last, before), octave);
      // Candidates that have no room before all points are placed change nothing. If there are
      // still too few points then, all others had their say, too.
      const float enough = radiusFor(this->count, this->usualNumber(), first);
      if (enough > last && !this->source.isExhausted())
      {
        this->fillOctave(candidates, enough);
      }
      if (!this->isComplete())
      {
        this->radius = first;
        this->placed.resize(before);
        this->fillOctave(candidates, last);
      }
    }
    return this->isStopped ? std::vector<StippleCandidate>() : std::move(this->placed);
  }

private:
  bool isComplete() const { return this->isStopped || this->placed.size() >= at(this->count); }

  // So many points as there mostly are at the radius: carried ones come in somewhat earlier, until
  // there are no more of them.
  std::size_t usualNumber() const
  {
    const double usual =
      pointsPerDisc * this->area / (static_cast<double>(this->radius) * this->radius);
    return this->carried.points.empty()
      ? this->placed.size()
      : std::min(this->placed.size(), static_cast<std::size_t>(usual));
  }

  void report()
  {
    this->reported = std::max(
      this->reported, static_cast<double>(this->placed.size()) / static_cast<double>(this->count));
    this->isStopped = this->progress && !this->progress(this->reported);
  }

  // How many of the carried points had come in at the density that there will be when the gaps,
  // now of one radius, are of another; and at one so many times as high.
  std::int32_t dueAt(float now, float then, double ratio) const
  {
    const double growth = static_cast<double>(now) / static_cast<double>(then);
    const double ranks = static_cast<double>(this->placed.size()) * growth * growth + 1.0;
    return static_cast<std::int32_t>(std::min(
      ratio * ranks / this->carried.growth, static_cast<double>(this->carried.points.size())));
  }

  // Those that will be due within the octave and are not placed yet.
  void addCarried(const StippleNeighbourhood& around, float last, float reach,
    std::vector<StippleCandidate>& candidates) const
  {
    constexpr double margin = 1.5; // of the number of points
    const std::int32_t due = this->dueAt(this->radius, last, margin * soonRatio);
    std::vector<char> isPlaced(this->carried.points.size(), 0);
    for (const StippleCandidate& point : this->placed)
    {
      if (point.triangle < 0)
      {
        isPlaced[at(carriedIndex(point))] = 1;
      }
    }
    const StippleGrid grid(reach);
    std::vector<std::pair<std::uint64_t, std::int32_t>> order; // near each other in space
    order.reserve(at(due));
    for (std::int32_t i = 0; i < due; ++i)
    {
      if (isPlaced[at(i)] == 0 && this->carried.points[at(i)].triangle >= 0)
      {
        order.emplace_back(grid.nameOf(this->carried.points[at(i)].place), i);
      }
    }
    std::sort(order.begin(), order.end());
    std::vector<StippleCandidate> waiting;
    waiting.reserve(order.size());
    for (const auto& [name, i] : order)
    {
      waiting.push_back(this->carried.points[at(i)]);
      waiting.back().triangle = -1 - i;
    }
    constexpr std::int64_t grain = 1024;
    parallelForRanges(static_cast<std::int64_t>(waiting.size()), grain,
      [&](std::int64_t begin, std::int64_t end)
      {
        StippleNeighbourhood::Blocks blocks;
        for (std::int64_t i = begin; i < end; ++i)
        {
          StippleCandidate& point = waiting[at(i)];
          point.crowding = around.crowding(point.place, point.normal, blocks);
        }
      });
    const float mostCrowded = crowdingFor(leastCarriedRoom * last, reach);
    std::copy_if(waiting.begin(), waiting.end(), std::back_inserter(candidates),
      [&](const StippleCandidate& point) { return point.crowding <= mostCrowded; });
  }

  void placeCarried(StippleCandidateCells& cells, float before, float reach)
  {
    if (this->carried.points.empty())
    {
      return;
    }
    cells.chooseCarried(this->dueAt(before, this->radius, 1.0));
    cells.fill(crowdingFor(leastCarriedRoom * this->radius, reach), this->placed);
    cells.chooseCarried(this->dueAt(before, this->radius, soonRatio));
    cells.fill(crowdingFor(this->radius, reach), this->placed);
    cells.chooseNew();
  }

  // All gaps wider than `last`, or until there are points enough.
  void fillOctave(std::int64_t candidates, float last)
  {
    const float reach = this->radius * reachRatio;
    const StippleNeighbourhood around(this->placed, this->borders, reach);
    Survivors survivors =
      makeCandidates(this->source, candidates, around, crowdingFor(last, reach));
    this->addCarried(around, last, reach, survivors.candidates);
    if (survivors.candidates.empty() && this->source.isExhausted())
    {
      this->radius = stippleRoom(survivors.leastLeftOut, reach);
      return;
    }
    StippleCandidateCells cells(survivors.candidates, reach);
    while (this->radius > last && !this->isComplete())
    {
      this->report();
      const float before = this->radius;
      const std::size_t first = this->placed.size();
      this->radius = std::max(last, this->radius * roundRatio);
      this->placeCarried(cells, before, reach);
      cells.fill(crowdingFor(this->radius, reach), this->placed);
      sortByRoom(this->placed, first, reach, before);
    }
    this->placed.resize(std::min(this->placed.size(), at(this->count)));
  }

  StippleSource& source;
  double area;
  const std::vector<StippleBorder>& borders;
  std::int64_t count;
  const ProgressFn& progress;
  const CarriedCandidates& carried;
  std::vector<StippleCandidate> placed;
  float radius = 1.0f; // up to which gaps are filled
  double reported = 0.0;
  bool isStopped = false;
};

} // namespace

std::vector<StippleCandidate> fillGaps(StippleSource& source, double area,
  const std::vector<StippleBorder>& borders, std::int64_t count, const ProgressFn& progress,
  const CarriedCandidates& carried)
{
  return GapFiller(source, area, borders, count, progress, carried).run();
}

} // namespace hachure

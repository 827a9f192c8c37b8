// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleCandidates.h"

// The triangles, which are sorted along a curve through space, are one long line of area. It is cut
// into strata of equal area, and each has one candidate at random. Within a large triangle the line
// goes on as a curve: through its four quarters, and theirs.

#include "Random.h"
#include "StippleNeighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hachure
{

namespace
{

struct Weights
{
  double second, third;
};

Weights middle(const Weights& a, const Weights& b)
{
  return { 0.5 * (a.second + b.second), 0.5 * (a.third + b.third) };
}

// Part of a triangle: its corners.
using Part = std::array<Weights, 3>;

Part quarterOf(const Part& part, int quarter)
{
  const Weights ab = middle(part[0], part[1]);
  const Weights bc = middle(part[1], part[2]);
  const Weights ca = middle(part[2], part[0]);
  switch (quarter)
  {
    case 0:
      return { part[0], ab, ca };
    case 1:
      return { bc, ca, ab };
    case 2:
      return { part[1], bc, ab };
    default:
      return { part[2], ca, bc };
  }
}

// Uniform in the part: Osada et al. 2002, equation 1.
Weights randomPlace(const Part& part, double first, double second)
{
  const double root = std::sqrt(first);
  const double a = 1.0 - root;
  const double b = root * (1.0 - second);
  const double c = root * second;
  return { a * part[0].second + b * part[1].second + c * part[2].second,
    a * part[0].third + b * part[1].third + c * part[2].third };
}

glm::vec3 unitNormal(const glm::dvec3& normal)
{
  const double length = glm::length(normal);
  return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

// The candidates of one range of strata.
class StrataWalk
{
public:
  StrataWalk(const StippleSurface& someSurface, const StippleNeighbourhood& someAround,
    float aMostCrowded, std::uint32_t someSeed, std::vector<StippleCandidate>& aResult)
    : surface(someSurface)
    , around(someAround)
    , mostCrowded(aMostCrowded)
    , seed(someSeed)
    , result(aResult)
  {
  }

  void walk(std::int64_t begin, std::int64_t end, double aStratum)
  {
    this->stratum = aStratum;
    this->from = begin;
    this->to = end;
    const std::vector<double>& before = this->surface.areaBefore;
    auto next = std::upper_bound(before.begin(), before.end() - 1, aStratum * begin);
    const double last = aStratum * end;
    while (true)
    {
      const auto index = static_cast<std::size_t>(next - before.begin()) - 1;
      this->enter(this->surface.triangles[index]);
      this->descend({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } } }, before[index], *next);
      if (next + 1 == before.end() || *next >= last)
      {
        return;
      }
      ++next;
    }
  }

  float leastLeftOut = std::numeric_limits<float>::infinity();

private:
  void enter(std::int32_t triangle)
  {
    const std::array<glm::dvec3, 3> corners = this->surface.corners(triangle);
    this->current.triangle = triangle;
    this->origin = corners[0];
    this->second = corners[1] - corners[0];
    this->third = corners[2] - corners[0];
    this->current.normal = unitNormal(glm::cross(this->second, this->third));
  }

  glm::vec3 placeOf(const Weights& weights) const
  {
    return glm::vec3(this->origin + weights.second * this->second + weights.third * this->third);
  }

  // The part has the areas from low to high on the line.
  void descend(const Part& part, double low, double high)
  {
    constexpr double smallestPart = 3.0; // strata: a look at one costs as much as a few candidates
    if (low >= this->stratum * this->to || high <= this->stratum * this->from)
    {
      return;
    }
    if (high - low < smallestPart * this->stratum)
    {
      this->draw(part, low, high);
      return;
    }
    const float crowding = this->around.leastCrowding(
      { this->placeOf(part[0]), this->placeOf(part[1]), this->placeOf(part[2]) },
      this->current.normal, this->blocks);
    if (crowding > this->mostCrowded)
    {
      return;
    }
    const double quarter = 0.25 * (high - low);
    for (int i = 0; i < 4; ++i)
    {
      this->descend(quarterOf(part, i), low + i * quarter, low + (i + 1) * quarter);
    }
  }

  // The candidates of all strata whose own place on the line is within the part.
  void draw(const Part& part, double low, double high)
  {
    const auto begin = std::max(this->from, static_cast<std::int64_t>(low / this->stratum));
    for (std::int64_t i = begin; i < this->to && this->stratum * i < high; ++i)
    {
      const auto id = static_cast<std::uint64_t>(i);
      const double area = this->stratum * (i + unitRandom(this->seed, id, 0));
      if (area >= low && area < high)
      {
        this->add(randomPlace(part, unitRandom(this->seed, id, 1), unitRandom(this->seed, id, 2)));
      }
    }
  }

  void add(const Weights& weights)
  {
    this->current.weights[0] = static_cast<float>(weights.second);
    this->current.weights[1] =
      std::min(static_cast<float>(weights.third), 1.0f - this->current.weights[0]);
    this->current.place = this->placeOf(weights);
    this->current.crowding = this->around.crowding(
      this->current.place, this->current.normal, this->blocks, this->mostCrowded);
    if (this->current.crowding <= this->mostCrowded)
    {
      this->result.push_back(this->current);
    }
    else
    {
      this->leastLeftOut = std::min(this->leastLeftOut, this->current.crowding);
    }
  }

  const StippleSurface& surface;
  const StippleNeighbourhood& around;
  StippleNeighbourhood::Blocks blocks;
  float mostCrowded;
  std::uint32_t seed;
  std::vector<StippleCandidate>& result;
  double stratum = 1.0; // area
  std::int64_t from = 0, to = 0;
  StippleCandidate current;
  glm::dvec3 origin{ 0.0 }, second{ 0.0 }, third{ 0.0 };
};

} // namespace

std::int64_t StippleSurfaceSource::prepare(std::int64_t wanted, std::uint32_t octave)
{
  this->octaveSeed = hashCombine(this->seed, octave);
  this->strata = wanted;
  return wanted;
}

float StippleSurfaceSource::make(std::int64_t begin, std::int64_t end,
  const StippleNeighbourhood& around, float mostCrowded,
  std::vector<StippleCandidate>& result) const
{
  result.reserve(static_cast<std::size_t>((end - begin) / 4)); // about so many survive
  StrataWalk walk(this->surface, around, mostCrowded, this->octaveSeed, result);
  walk.walk(begin, end, this->surface.area() / static_cast<double>(this->strata));
  return walk.leastLeftOut;
}

std::int64_t StipplePointSource::prepare(std::int64_t wanted, std::uint32_t)
{
  this->share =
    std::min(1.0, static_cast<double>(wanted) / static_cast<double>(this->points.size()));
  return static_cast<std::int64_t>(this->points.size());
}

float StipplePointSource::make(std::int64_t begin, std::int64_t end,
  const StippleNeighbourhood& around, float mostCrowded,
  std::vector<StippleCandidate>& result) const
{
  float leastLeftOut = std::numeric_limits<float>::infinity();
  StippleNeighbourhood::Blocks blocks;
  for (std::int64_t i = begin; i < end; ++i)
  {
    if (unitRandom(this->seed, static_cast<std::uint64_t>(i), 0) < this->share)
    {
      const auto index = static_cast<std::size_t>(i);
      StippleCandidate candidate;
      candidate.triangle = static_cast<std::int32_t>(i);
      candidate.place = glm::vec3(this->frame.place(this->points[index]));
      candidate.normal = this->normals.empty() ? glm::vec3(0.0f) : unitNormal(this->normals[index]);
      candidate.crowding = around.crowding(candidate.place, candidate.normal, blocks);
      if (candidate.crowding <= mostCrowded)
      {
        result.push_back(candidate);
      }
      else
      {
        leastLeftOut = std::min(leastLeftOut, candidate.crowding);
      }
    }
  }
  return leastLeftOut;
}

} // namespace hachure

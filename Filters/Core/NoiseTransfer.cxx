// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseTransfer.h"

#include "NoiseProcess.h"
#include "Parallel.h"
#include "Random.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hachure
{

namespace
{

// How far from where it came from a way to the other surface and back may end, in kernel radii.
constexpr double returnTolerance = 0.5;
constexpr std::int64_t moverGrain = 256;
constexpr std::size_t fewestNeighbours = 6;
constexpr double largestGrowth = 4.0; // of a change, and 1 / it the smallest

// Facets near those found last.
struct Guess
{
  std::int32_t to = -1;
  std::int32_t from = -1;
};

void transfer(const NoiseClosestPoint& from, const NoiseClosestPoint& to, double reach,
  NoiseMover& mover, Guess& guess)
{
  mover.foot = to.find(mover.position, mover.normal, reach, guess.to);
  mover.returns = false;
  if (mover.foot.facet >= 0)
  {
    // Where it came from is one of the candidates.
    const double farthest =
      mover.foot.distance * (1.0 + 1e-9) + 1e-9 * std::min(mover.radius, reach);
    const NoiseFoot back = from.find(mover.foot.position, mover.normal, farthest, guess.from);
    mover.returns = back.facet >= 0 &&
      glm::length(back.position - mover.position) <= returnTolerance * mover.radius;
    guess = { mover.foot.facet, back.facet };
  }
}

// The cube of side 2^n, above the kernel's radius, and the side of the surface that faces one of
// the axes: the two sides of a thin wall move on their own.
std::uint64_t neighbourhood(const NoiseMover& mover)
{
  const int exponent = binaryExponent(mover.radius) + 1;
  const glm::dvec3 cell = glm::floor(mover.position / powerOfTwo(exponent));
  const glm::dvec3 facing = glm::abs(mover.normal);
  const int axis =
    facing.x >= facing.y ? (facing.x >= facing.z ? 0 : 2) : (facing.y >= facing.z ? 1 : 2);
  std::uint64_t key =
    hashPair(static_cast<std::uint64_t>(exponent), 2 * axis + (mover.normal[axis] < 0.0 ? 1 : 0));
  for (int i = 0; i < 3; ++i)
  {
    key = hashPair(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[i])));
  }
  return key;
}

// Mean square of the areas that pairs of points span with their mean, up to a factor.
class SpannedArea
{
public:
  void add(const glm::dvec3& arm)
  {
    this->sum += arm;
    this->squares += glm::outerProduct(arm, arm);
    this->count += 1.0;
  }
  double square() const
  {
    const glm::dvec3 mean = this->sum / this->count;
    const glm::dmat3 c = this->squares / this->count - glm::outerProduct(mean, mean);
    return c[0][0] * c[1][1] + c[0][0] * c[2][2] + c[1][1] * c[2][2] - c[0][1] * c[0][1] -
      c[0][2] * c[0][2] - c[1][2] * c[1][2];
  }

private:
  glm::dvec3 sum{ 0.0 };
  glm::dmat3 squares{ 0.0 };
  double count = 0.0;
};

using KeyedMover = std::pair<std::uint64_t, NoiseMover*>;

void setGrowth(const KeyedMover* first, const KeyedMover* last)
{
  if (last - first < static_cast<std::ptrdiff_t>(fewestNeighbours))
  {
    return;
  }
  SpannedArea before, after;
  for (const KeyedMover* i = first; i != last; ++i)
  {
    before.add(i->second->position - first->second->position);
    after.add(i->second->foot.position - first->second->foot.position);
  }
  const double growth = std::sqrt(after.square() / before.square());
  for (const KeyedMover* i = first; i != last && std::isfinite(growth); ++i)
  {
    i->second->growth = std::clamp(growth, 1.0 / largestGrowth, largestGrowth);
  }
}

} // namespace

void transferNoisePoints(const NoiseClosestPoint& from, const NoiseClosestPoint& to, double reach,
  std::vector<NoiseMover>& movers)
{
  // Along the curve the last facet found is a good guess for the next.
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(movers.size());
  for (std::size_t i = 0; i < movers.size(); ++i)
  {
    order.emplace_back(from.placeOnCurve(movers[i].position), i);
  }
  std::sort(order.begin(), order.end());
  parallelForRanges(static_cast<std::int64_t>(movers.size()), moverGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      Guess guess;
      for (std::int64_t i = begin; i < end; ++i)
      {
        transfer(from, to, reach, movers[order[i].second], guess);
      }
    });
}

void measureNoiseGrowth(std::vector<NoiseMover>& movers)
{
  std::vector<KeyedMover> keyed;
  keyed.reserve(movers.size());
  for (NoiseMover& mover : movers)
  {
    if (mover.returns)
    {
      keyed.emplace_back(neighbourhood(mover), &mover);
    }
  }
  // Of equal keys the address is the place in the vector.
  std::sort(keyed.begin(), keyed.end());
  const KeyedMover* first = keyed.data();
  const KeyedMover* end = first + keyed.size();
  while (first != end)
  {
    const KeyedMover* last = std::find_if(
      first, end, [&](const KeyedMover& mover) { return mover.first != first->first; });
    setGrowth(first, last);
    first = last;
  }
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleClassic.h"

// Vertices never move, so that a half of every edge collapse of Hoppe 1996 is done: one end becomes
// the other. The edge to go is the shortest; its end that goes the one in the denser place.

#include "Random.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>

namespace hachure
{

namespace
{

// An edge that may be gone by now.
struct ShortEdge
{
  double length;
  std::uint64_t order; // random, for edges of equal length
  std::int32_t a, b;

  bool operator<(const ShortEdge& other) const // for a queue with the largest on top
  {
    return std::tie(other.length, other.order) < std::tie(this->length, this->order);
  }
};

class EdgeCollapser
{
public:
  EdgeCollapser(StippleParticles someParticles, std::int64_t aWanted, std::uint32_t someSeed)
    : particles(std::move(someParticles))
    , wanted(aWanted)
    , seed(someSeed)
    , isGone(this->particles.places.size(), 0)
    , alive(static_cast<std::int64_t>(this->particles.places.size()))
  {
    this->result.first.push_back(0);
    this->keepTriangles();
  }

  void pushAll()
  {
    for (std::size_t vertex = 0; vertex < this->isGone.size(); ++vertex)
    {
      if (this->isGone[vertex] == 0)
      {
        this->push(static_cast<std::int32_t>(vertex), true);
      }
    }
  }

  // False if it was stopped.
  bool run(bool keepsSides, const ProgressFn& progress)
  {
    constexpr std::int64_t reportAfter = 4096; // collapses
    std::int64_t next = this->alive - reportAfter;
    while (!this->queue.empty())
    {
      const ShortEdge edge = this->queue.top();
      this->queue.pop();
      this->tryCollapse(edge, keepsSides);
      if (this->alive <= next)
      {
        next -= reportAfter;
        const auto all = static_cast<double>(this->isGone.size());
        if (progress && !progress(1.0 - static_cast<double>(this->alive) / all))
        {
          return false;
        }
      }
    }
    return true;
  }

  StippleCollapses result;

private:
  void push(std::int32_t vertex, bool isOnce)
  {
    std::vector<std::int32_t> around;
    this->particles.neighbours(vertex, around);
    for (const std::int32_t other : around)
    {
      if (!isOnce || other > vertex)
      {
        const std::int32_t a = std::min(vertex, other);
        const std::int32_t b = std::max(vertex, other);
        this->queue.push({ this->particles.length(a, b),
          hashPair(
            this->seed, hashPair(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b))),
          a, b });
      }
    }
  }

  double meanLength(std::int32_t vertex, std::vector<std::int32_t>& around) const
  {
    this->particles.neighbours(vertex, around);
    double sum = 0.0;
    for (const std::int32_t other : around)
    {
      sum += this->particles.length(vertex, other);
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, around.size()));
  }

  void tryCollapse(const ShortEdge& edge, bool keepsSides)
  {
    if (this->isGone[static_cast<std::size_t>(edge.a)] != 0 ||
      this->isGone[static_cast<std::size_t>(edge.b)] != 0)
    {
      return;
    }
    this->particles.trianglesAt(edge.a, edge.b, this->shared);
    if (this->shared.empty() || this->shared.size() > 2)
    {
      return;
    }
    std::int32_t gone = edge.a;
    std::int32_t kept = edge.b;
    if (this->meanLength(edge.b, this->ringB) < this->meanLength(edge.a, this->ringA))
    {
      std::swap(gone, kept);
    }
    if (!this->keepsTopology())
    {
      return;
    }
    for (int attempt = 0; attempt < 2; ++attempt)
    {
      if (this->mayGo(gone, keepsSides) && (!keepsSides || this->keepsSides(gone, kept)))
      {
        this->collapse(gone, kept);
        return;
      }
      std::swap(gone, kept);
    }
  }

  // The link condition: only the triangles at the edge join its ends' neighbours; and something is
  // left.
  bool keepsTopology() const
  {
    std::vector<std::int32_t> common;
    std::set_intersection(this->ringA.begin(), this->ringA.end(), this->ringB.begin(),
      this->ringB.end(), std::back_inserter(common));
    if (common.size() != this->shared.size())
    {
      return false;
    }
    std::vector<std::int32_t> third;
    for (const std::int32_t other : common)
    {
      // Else what is left of the triangles there would lie one on the other.
      this->particles.neighbours(other, third);
      if (third.size() <= (this->shared.size() == 2 ? 3u : 2u))
      {
        return false;
      }
    }
    return true;
  }

  // Inside the surface, or on a border of which the edge is a part, and not a corner of it.
  bool mayGo(std::int32_t vertex, bool keepsCorners) const
  {
    std::vector<std::int32_t> around, at;
    this->particles.neighbours(vertex, around);
    std::vector<glm::dvec3> borders;
    for (const std::int32_t other : around)
    {
      this->particles.trianglesAt(vertex, other, at);
      if (at.size() > 2)
      {
        return false;
      }
      if (at.size() == 1)
      {
        borders.push_back(
          glm::normalize(this->particles.place(other) - this->particles.place(vertex)));
      }
    }
    constexpr double straightCosine = 0.9; // less than 26 degrees of a turn
    return borders.empty() ||
      (borders.size() == 2 && this->shared.size() == 1 &&
        (!keepsCorners || glm::dot(borders[0], borders[1]) < -straightCosine));
  }

  bool keepsSides(std::int32_t gone, std::int32_t kept) const
  {
    bool areKept = true;
    this->particles.visitTriangles(gone,
      [&](std::int32_t index)
      {
        const glm::ivec3 corners = this->particles.triangle(index);
        if (corners.x == kept || corners.y == kept || corners.z == kept)
        {
          return;
        }
        const auto placeOf = [&](std::int32_t vertex)
        { return this->particles.place(vertex == gone ? kept : vertex); };
        const glm::dvec3 origin = placeOf(corners.x);
        const glm::dvec3 after =
          glm::cross(placeOf(corners.y) - origin, placeOf(corners.z) - origin);
        const glm::dvec3 before = this->particles.areaVector(index);
        constexpr double leastCosine = 0.2;
        areKept = areKept &&
          glm::dot(after, before) > leastCosine * glm::length(after) * glm::length(before);
      });
    return areKept;
  }

  void collapse(std::int32_t gone, std::int32_t kept)
  {
    std::vector<std::int32_t> around;
    this->particles.neighbours(gone, around);
    this->result.gone.push_back(gone);
    this->result.neighbours.insert(this->result.neighbours.end(), around.begin(), around.end());
    this->result.first.push_back(static_cast<std::uint32_t>(this->result.neighbours.size()));
    this->particles.collapse(gone, kept);
    this->isGone[static_cast<std::size_t>(gone)] = 1;
    --this->alive;
    this->keepTriangles();
    this->push(kept, false);
  }

  // Those of the finest mesh with no more vertices than wanted.
  void keepTriangles()
  {
    if (this->isKept || this->alive > this->wanted)
    {
      return;
    }
    this->isKept = true;
    for (const glm::ivec3& triangle : this->particles.triangles)
    {
      if (triangle.x >= 0)
      {
        this->result.triangles.push_back(triangle);
      }
    }
  }

  StippleParticles particles;
  std::int64_t wanted;
  std::uint32_t seed;
  std::vector<char> isGone;
  std::int64_t alive;
  bool isKept = false;
  std::priority_queue<ShortEdge> queue;
  std::vector<std::int32_t> shared, ringA, ringB;
};

} // namespace

StippleCollapses collapseEdges(
  StippleParticles particles, std::int64_t wanted, std::uint32_t seed, const ProgressFn& progress)
{
  EdgeCollapser collapser(std::move(particles), wanted, seed);
  for (const bool keepsSides : { true, false })
  {
    collapser.pushAll();
    if (!collapser.run(keepsSides, progress))
    {
      break;
    }
  }
  return std::move(collapser.result);
}

} // namespace hachure

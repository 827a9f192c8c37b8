// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleClassic.h"

// Meruvia Pastor and Strothotte 2002, section 2. The vertices of the mesh are moved at random and
// projected back; edge collapses order them, the last to go first; then the longest edge in space
// is split again and again. Every vertex keeps the neighbours that it has when it comes in as those
// that are relevant for it. The order of splits is a function of the mesh alone, not of what a
// camera has seen.

#include "Parallel.h"
#include "Random.h"
#include "StippleOperators.h"
#include "SurfacePatchesMesh.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace hachure
{

namespace
{

std::size_t at(std::int64_t index)
{
  return static_cast<std::size_t>(index);
}

struct LongEdge
{
  double length;
  std::uint64_t order; // random, for edges of equal length
  std::int32_t a, b;

  bool operator<(const LongEdge& other) const
  {
    return std::tie(this->length, this->order) < std::tie(other.length, other.order);
  }
};

class ClassicHierarchy
{
public:
  ClassicHierarchy(const StippleSurface& someSurface, const StippleOptions& someOptions)
    : surface(someSurface)
    , options(someOptions)
    , operators(someSurface, someOptions)
    , particles(this->verticesOf(someSurface))
  {
    this->findFootholds();
  }

  StippleHierarchy run()
  {
    this->inputCount = static_cast<std::int64_t>(this->particles.places.size());
    this->moveVertices();
    if (!this->collapse() || !this->refine())
    {
      return {};
    }
    this->result.points.shrink_to_fit();
    return std::move(this->result);
  }

private:
  bool moves() const { return this->options.mostMove > 0.0; }
  bool report(double fraction) const
  {
    return !this->options.progress || this->options.progress(fraction);
  }

  // Points in one place are one vertex; those of no triangle are left out.
  StippleParticles verticesOf(const StippleSurface& from) const
  {
    const std::vector<std::int32_t> joined = joinPoints(from.mesh.points);
    std::vector<std::int32_t> numbers(joined.size(), -1);
    std::vector<glm::dvec3> places;
    std::vector<glm::ivec3> triangles;
    std::vector<std::int32_t> sorted = from.triangles;
    std::sort(sorted.begin(), sorted.end());
    triangles.reserve(sorted.size());
    for (const std::int32_t triangle : sorted)
    {
      glm::ivec3 corners = from.mesh.triangles[at(triangle)];
      for (int i = 0; i < 3; ++i)
      {
        std::int32_t& number = numbers[at(joined[at(corners[i])])];
        if (number < 0)
        {
          number = static_cast<std::int32_t>(places.size());
          places.push_back(from.frame.place(from.mesh.points[at(corners[i])]));
        }
        corners[i] = number;
      }
      triangles.push_back(corners);
    }
    return StippleParticles(std::move(places), std::move(triangles));
  }

  void findFootholds()
  {
    // Particle triangles are in the order of the mesh, footholds in that of the surface.
    std::vector<std::pair<std::int32_t, std::int32_t>> order(this->surface.triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      order[i] = { this->surface.triangles[i], static_cast<std::int32_t>(i) };
    }
    std::sort(order.begin(), order.end());
    this->footholds.resize(this->particles.places.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->footholds[at(this->particles.triangles[i][corner])].triangle = order[i].second;
      }
    }
    parallelFor(static_cast<std::int64_t>(this->footholds.size()),
      [this](std::int64_t vertex)
      {
        this->footholds[at(vertex)].isOnBorder =
          !borderNeighbours(this->particles, static_cast<std::int32_t>(vertex)).empty();
      });
  }

  void moveVertices()
  {
    if (!this->moves())
    {
      return;
    }
    std::vector<glm::dvec3> moved(this->particles.places.size());
    parallelFor(this->inputCount,
      [&](std::int64_t vertex)
      {
        moved[at(vertex)] = this->operators.move(
          this->particles, static_cast<std::int32_t>(vertex), this->footholds[at(vertex)]);
      });
    this->particles.places = std::move(moved);
  }

  // ---- Ranks -----------------------------------------------------------------------------------

  // The ranks of the vertices of the input, by collapses; and their points.
  bool collapse()
  {
    const auto progress = [this](double fraction)
    {
      this->isStopped = this->isStopped || !this->report(0.4 * fraction);
      return !this->isStopped;
    };
    StippleCollapses collapses =
      collapseEdges(this->particles, this->options.count, this->options.seed, progress);
    if (this->isStopped)
    {
      return false;
    }
    std::vector<std::int32_t> order = this->survivors(collapses);
    const std::size_t top = order.size();
    order.insert(order.end(), collapses.gone.rbegin(), collapses.gone.rend());
    this->ranks.assign(order.size(), 0);
    for (std::size_t rank = 0; rank < order.size(); ++rank)
    {
      this->ranks[at(order[rank])] = static_cast<std::int32_t>(rank);
    }
    const std::size_t count = std::min(order.size(), at(this->options.count));
    for (std::size_t rank = 0; rank < count; ++rank)
    {
      std::vector<std::int32_t> relevant;
      if (rank >= top) // else nothing is relevant for it
      {
        const std::size_t step = order.size() - 1 - rank; // at which it was gone
        relevant.assign(collapses.neighbours.begin() + collapses.first[step],
          collapses.neighbours.begin() + collapses.first[step + 1]);
      }
      this->add(order[rank], relevant);
    }
    if (this->inputCount >= this->options.count)
    {
      this->keepTriangles(collapses.triangles);
    }
    return true;
  }

  // In an order that is random.
  std::vector<std::int32_t> survivors(const StippleCollapses& collapses) const
  {
    std::vector<char> isGone(this->particles.places.size(), 0);
    for (const std::int32_t vertex : collapses.gone)
    {
      isGone[at(vertex)] = 1;
    }
    std::vector<std::pair<std::uint64_t, std::int32_t>> sorted;
    for (std::size_t vertex = 0; vertex < isGone.size(); ++vertex)
    {
      if (isGone[vertex] == 0)
      {
        sorted.emplace_back(
          hashPair(this->options.seed, vertex), static_cast<std::int32_t>(vertex));
      }
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::int32_t> order;
    order.reserve(sorted.size());
    for (const auto& [hash, vertex] : sorted)
    {
      order.push_back(vertex);
    }
    return order;
  }

  // The point of the next rank.
  void add(std::int32_t vertex, const std::vector<std::int32_t>& relevant)
  {
    StipplePoint point =
      this->operators.pointAt(this->particles.place(vertex), this->footholds[at(vertex)]);
    double spacing = 1.0;
    for (const std::int32_t other : relevant)
    {
      spacing = std::min(spacing, this->particles.length(vertex, other));
      this->result.neighbours.push_back(this->ranks[at(other)]);
    }
    point.spacing = static_cast<float>(spacing * this->surface.frame.size);
    this->result.points.push_back(point);
    if (this->result.firstNeighbour.empty())
    {
      this->result.firstNeighbour.push_back(0);
    }
    this->result.firstNeighbour.push_back(
      static_cast<std::uint32_t>(this->result.neighbours.size()));
  }

  void keepTriangles(const std::vector<glm::ivec3>& triangles)
  {
    const auto count = static_cast<std::int32_t>(this->result.points.size());
    this->result.particleTriangles.reserve(triangles.size());
    for (const glm::ivec3& triangle : triangles)
    {
      const glm::ivec3 corners(
        this->ranks[at(triangle.x)], this->ranks[at(triangle.y)], this->ranks[at(triangle.z)]);
      if (std::max({ corners.x, corners.y, corners.z }) < count)
      {
        this->result.particleTriangles.push_back(corners);
      }
    }
  }

  // ---- Splits ----------------------------------------------------------------------------------

  void push(std::int32_t a, std::int32_t b)
  {
    const std::uint64_t pair =
      static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
    this->queue.push({ this->particles.length(a, b), hashPair(this->options.seed, pair), a, b });
  }

  bool refine()
  {
    const std::int64_t count = this->options.count;
    if (this->inputCount >= count)
    {
      return true;
    }
    this->reserve(at(count));
    std::vector<std::int32_t> around;
    for (std::int32_t vertex = 0; vertex < this->inputCount; ++vertex)
    {
      this->particles.neighbours(vertex, around);
      for (const std::int32_t other : around)
      {
        if (other > vertex)
        {
          this->push(vertex, other);
        }
      }
    }
    constexpr std::int64_t reportAfter = 4096;
    for (std::int64_t i = this->inputCount; i < count && !this->queue.empty(); ++i)
    {
      if (i % reportAfter == 0 && !this->report(0.4 + 0.6 * static_cast<double>(i) / count))
      {
        return false;
      }
      const LongEdge edge = this->queue.top();
      this->queue.pop();
      this->split(edge);
    }
    this->keepTriangles(this->particles.triangles);
    return true;
  }

  void reserve(std::size_t count)
  {
    this->particles.places.reserve(count);
    this->footholds.reserve(count);
    this->ranks.reserve(count);
    this->result.points.reserve(count);
    this->result.firstNeighbour.reserve(count + 1);
    this->result.neighbours.reserve(
      this->result.neighbours.size() + 4 * (count - this->result.points.size()));
  }

  void split(const LongEdge& edge)
  {
    std::vector<std::int32_t> triangles, relevant;
    this->particles.trianglesAt(edge.a, edge.b, triangles);
    relevant = { edge.a, edge.b };
    for (const std::int32_t index : triangles)
    {
      relevant.push_back(oppositeCorner(this->particles.triangle(index), edge.a, edge.b));
    }
    const StippleFoothold from = this->footholds[at(edge.a)];
    const glm::dvec3 middle = 0.5 * (this->particles.place(edge.a) + this->particles.place(edge.b));
    const std::int32_t vertex = this->particles.split(edge.a, edge.b, middle);
    this->footholds.push_back({ from.triangle, triangles.size() == 1 });
    this->particles.places[at(vertex)] =
      this->operators.move(this->particles, vertex, this->footholds.back());
    this->ranks.push_back(static_cast<std::int32_t>(this->result.points.size()));
    this->add(vertex, relevant);
    for (const std::int32_t other : relevant)
    {
      this->push(vertex, other);
    }
  }

  const StippleSurface& surface;
  const StippleOptions& options;
  StippleOperators operators;
  StippleParticles particles;
  std::vector<StippleFoothold> footholds; // of the vertices
  std::vector<std::int32_t> ranks;        // of the vertices
  std::int64_t inputCount = 0;            // vertices before the first split
  bool isStopped = false;
  std::priority_queue<LongEdge> queue;
  StippleHierarchy result;
};

} // namespace

StippleHierarchy classicStipples(const StippleSurface& surface, const StippleOptions& options)
{
  return ClassicHierarchy(surface, options).run();
}

} // namespace hachure

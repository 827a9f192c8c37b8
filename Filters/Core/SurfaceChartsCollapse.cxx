// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsCollapse.h"

#include "SurfaceChartsQueue.h"
#include "SurfaceChartsRing.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

// Times the wanted area: no triangle gets larger, and no vertex with more around it goes.
constexpr double mostArea = 2.0;
constexpr double mostRingArea = 4.5;

class Simplifier
{
public:
  Simplifier(CornerMesh someMesh, const CollapseOptions& someOptions)
    : options(someOptions)
    , base{ std::move(someMesh), {}, {}, false }
    , queue(this->base.mesh.positions.size())
  {
    CornerMesh& mesh = this->base.mesh;
    this->base.homes.resize(mesh.positions.size());
    this->base.areas.resize(mesh.triangleCount());
    this->starAreas.assign(mesh.positions.size(), 0.0);
    this->marks.assign(mesh.positions.size(), 0);
    this->heads.assign(mesh.triangleCount(), -1);
    this->nexts.assign(mesh.positions.size(), -1);
    this->live = static_cast<std::int64_t>(mesh.triangleCount());
    for (std::size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle)
    {
      const auto corner = static_cast<std::int32_t>(3 * triangle);
      const glm::dvec3& first = mesh.position(mesh.vertex(corner));
      this->base.areas[triangle] = 0.5 *
        glm::length(glm::cross(mesh.position(mesh.vertex(corner + 1)) - first,
          mesh.position(mesh.vertex(corner + 2)) - first));
      this->addArea(static_cast<std::int32_t>(triangle), 1.0);
    }
  }

  BaseMesh run()
  {
    for (const RingLimits& limits : { strictLimits, looseLimits, lastLimits })
    {
      this->current = limits;
      for (std::size_t vertex = 0; vertex < this->starAreas.size(); ++vertex)
      {
        this->enqueue(static_cast<std::int32_t>(vertex));
      }
      if (!this->runQueue())
      {
        this->base.isStopped = true;
        break;
      }
    }
    return std::move(this->base);
  }

private:
  // Of a triangle: to the stars of its corners.
  void addArea(std::int32_t triangle, double sign)
  {
    for (std::int32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
    {
      this->starAreas[indexOf(this->base.mesh.vertex(corner))] +=
        sign * this->base.areas[indexOf(triangle)];
    }
  }

  void enqueue(std::int32_t vertex)
  {
    const std::size_t index = indexOf(vertex);
    if (this->base.mesh.cornerAt[index] >= 0 && this->base.mesh.isFrozen[index] == 0 &&
      this->starAreas[index] < mostRingArea * this->options.area)
    {
      this->queue.push(vertex, this->starAreas[index] / this->options.area);
    }
  }

  // False if it was stopped.
  bool runQueue()
  {
    constexpr std::int64_t reportAfter = 8192; // triangles
    const std::int64_t all = this->live;
    std::int64_t next = this->live;
    while (this->live > this->options.triangles)
    {
      const std::int32_t vertex = this->queue.pop();
      if (vertex < 0)
      {
        return true;
      }
      this->tryCollapse(vertex);
      if (this->live <= next)
      {
        next = this->live - reportAfter;
        const double fraction = 1.0 - static_cast<double>(this->live) / static_cast<double>(all);
        if (this->options.progress && !this->options.progress(fraction))
        {
          return false;
        }
      }
    }
    this->queue.clear();
    return true;
  }

  void tryCollapse(std::int32_t vertex)
  {
    this->ring.find(this->base.mesh, vertex);
    if (!this->flat.lay(this->base.mesh, vertex, this->ring))
    {
      return;
    }
    this->stamp += 1;
    for (const std::int32_t end : this->ring.ends)
    {
      this->marks[indexOf(end)] = this->stamp;
    }
    double area = 0.0;
    for (const std::int32_t corner : this->ring.corners)
    {
      area += this->base.areas[indexOf(corner / 3)];
    }
    int best = -1;
    double bestScore = 0.0;
    const int count = static_cast<int>(this->ring.ends.size());
    for (int target = 0; target < count; target += this->ring.isClosed ? 1 : count - 1)
    {
      const double score =
        this->flat.score(this->current, target, mostArea * this->options.area / area);
      if (score > bestScore && this->keepsTopology(target))
      {
        best = target;
        bestScore = score;
      }
    }
    if (best >= 0)
    {
      this->collapse(vertex, best, area);
    }
  }

  // The link condition: the only neighbours of both ends are those at their two triangles, and
  // these keep enough triangles.
  bool keepsTopology(int target) const
  {
    constexpr int mostEnds = 64; // of the other vertex: around larger ones it would take long
    const CornerMesh& mesh = this->base.mesh;
    const std::int32_t first =
      mesh.cornerAt[indexOf(this->ring.ends[static_cast<std::size_t>(target)])];
    int common = 0;
    int ends = 0;
    std::int32_t corner = first;
    std::int32_t last = first;
    do
    {
      common += this->isMarked(mesh.vertex(CornerMesh::next(corner)));
      last = corner;
      corner = mesh.after(corner);
    } while (corner >= 0 && corner != first && ++ends < mostEnds);
    common += corner < 0 ? this->isMarked(mesh.vertex(CornerMesh::previous(last))) : 0;
    const int count = static_cast<int>(this->ring.ends.size());
    if (ends >= mostEnds || common != (this->ring.isClosed ? 2 : 1) ||
      (count > 4 && ends + count - 4 > this->current.ends))
    {
      return false;
    }
    if (!this->ring.isClosed)
    {
      return this->canLoseTriangle(target == 0 ? 1 : count - 2);
    }
    return this->canLoseTriangle((target + 1) % count) &&
      this->canLoseTriangle((target + count - 1) % count);
  }

  int isMarked(std::int32_t vertex) const
  {
    return this->marks[indexOf(vertex)] == this->stamp ? 1 : 0;
  }

  bool canLoseTriangle(int end) const
  {
    const CornerMesh& mesh = this->base.mesh;
    const std::int32_t first =
      mesh.cornerAt[indexOf(this->ring.ends[static_cast<std::size_t>(end)])];
    std::int32_t corner = first;
    int triangles = 0;
    do
    {
      ++triangles;
      corner = mesh.after(corner);
    } while (corner >= 0 && corner != first && triangles < 4);
    return triangles >= 4 || (corner < 0 && triangles >= 2);
  }

  void collapse(std::int32_t vertex, int target, double area)
  {
    this->takePoints(vertex);
    for (const std::int32_t corner : this->ring.corners)
    {
      this->addArea(corner / 3, -1.0);
    }
    this->removeTriangles(target);
    this->flat.makeFan(target);
    const std::int32_t kept = this->ring.ends[static_cast<std::size_t>(target)];
    for (const FlatTriangle& made : this->flat.fan)
    {
      const std::int32_t corner = this->ring.corners[made.place];
      this->base.mesh.vertices[indexOf(corner)] = kept;
      this->base.areas[indexOf(corner / 3)] = area * made.share;
      this->addArea(corner / 3, 1.0);
    }
    this->base.mesh.cornerAt[indexOf(vertex)] = -1;
    this->tellFirstCorners();
    this->putPoints();
    for (const std::int32_t end : this->ring.ends)
    {
      this->enqueue(end);
    }
  }

  // All that lies around the vertex, and itself, where it is in the plane.
  void takePoints(std::int32_t vertex)
  {
    this->points.assign(1, { vertex, glm::dvec2(0.0) });
    for (std::size_t place = 0; place < this->ring.corners.size(); ++place)
    {
      const std::int32_t corner = this->ring.corners[place];
      std::int32_t& head = this->heads[indexOf(corner / 3)];
      for (std::int32_t point = head; point >= 0; point = this->nexts[indexOf(point)])
      {
        const glm::dvec2& weights = this->base.homes[indexOf(point)].weights;
        const double all[3] = { 1.0 - weights.x - weights.y, weights.x, weights.y };
        this->points.push_back(
          { point, this->flat.inPlane(place, all[(corner + 1) % 3], all[(corner + 2) % 3]) });
      }
      head = -1;
    }
  }

  void putPoints()
  {
    for (const FlatPoint& point : this->points)
    {
      const FlatTriangle& under = this->flat.under(point.place);
      const glm::dvec3 weights = under.weightsOf(point.place); // of the kept vertex first
      const std::int32_t corner = this->ring.corners[under.place];
      VertexHome& home = this->base.homes[indexOf(point.vertex)];
      home.triangle = corner / 3;
      // From the kept vertex on to the order of the triangle's corners.
      home.weights = { weights[(4 - corner % 3) % 3], weights[(5 - corner % 3) % 3] };
      std::int32_t& head = this->heads[indexOf(home.triangle)];
      this->nexts[indexOf(point.vertex)] = head;
      head = point.vertex;
    }
  }

  // The two at the edge, or the one at a border.
  void removeTriangles(int target)
  {
    const int triangles = static_cast<int>(this->ring.corners.size());
    if (this->ring.isClosed || target == 0)
    {
      const std::int32_t corner = this->ring.corners[static_cast<std::size_t>(target)];
      this->joinAcross(corner, CornerMesh::next(corner));
    }
    if (this->ring.isClosed || target != 0)
    {
      const int place = (target + triangles - 1) % triangles;
      const std::int32_t corner = this->ring.corners[static_cast<std::size_t>(place)];
      this->joinAcross(corner, CornerMesh::previous(corner));
    }
  }

  // Joins what is across two edges of a triangle and removes it.
  void joinAcross(std::int32_t corner, std::int32_t other)
  {
    CornerMesh& mesh = this->base.mesh;
    const std::int32_t one = mesh.opposite(corner);
    const std::int32_t two = mesh.opposite(other);
    if (one >= 0)
    {
      mesh.opposites[indexOf(one)] = two;
    }
    if (two >= 0)
    {
      mesh.opposites[indexOf(two)] = one;
    }
    for (std::int32_t gone = corner / 3 * 3; gone < corner / 3 * 3 + 3; ++gone)
    {
      mesh.vertices[indexOf(gone)] = -1;
    }
    --this->live;
  }

  void tellFirstCorners()
  {
    CornerMesh& mesh = this->base.mesh;
    for (const FlatTriangle& made : this->flat.fan)
    {
      const std::int32_t corner = this->ring.corners[made.place];
      for (const std::int32_t at :
        { corner, CornerMesh::next(corner), CornerMesh::previous(corner) })
      {
        // It changes only where it was removed, at borders too.
        const std::int32_t known = mesh.cornerAt[indexOf(mesh.vertex(at))];
        if (mesh.vertex(known) != mesh.vertex(at))
        {
          mesh.cornerAt[indexOf(mesh.vertex(at))] = mesh.firstCorner(at);
        }
      }
    }
  }

  struct FlatPoint
  {
    std::int32_t vertex;
    glm::dvec2 place;
  };

  CollapseOptions options;
  BaseMesh base;
  VertexQueue queue;
  RingLimits current = strictLimits;
  std::int64_t live = 0;
  std::vector<double> starAreas;   // of vertices
  std::vector<std::int32_t> marks; // of vertices
  std::int32_t stamp = 0;
  std::vector<std::int32_t> heads; // of triangles: a vertex that lies on it
  std::vector<std::int32_t> nexts; // of vertices: another one on the same triangle
  VertexRing ring;
  FlatRing flat;
  std::vector<FlatPoint> points;
};
} // namespace

BaseMesh collapseToBase(CornerMesh mesh, const CollapseOptions& options)
{
  return Simplifier(std::move(mesh), options).run();
}

} // namespace hachure

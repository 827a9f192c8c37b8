// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourSegments.h"

#include "ContourMesh.h"
#include "Parallel.h"
#include "SurfacePatchesMesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

// Every corner of a triangle has a facing: its normal times the direction to the eye, above 0 where
// the surface faces the viewer. Around a vertex, corners share a normal as far as no sharp edge
// lies between them. Facing is linear along edges, so smooth silhouettes are the lines of facing 0,
// straight in every triangle; along a sharp edge, silhouettes are those parts on whose two sides
// facing has different signs. Both join without a gap: a line across triangles that meets a sharp
// edge goes on along it. Without smoothing all edges are sharp.
namespace hachure
{
namespace
{

class ContourFinder
{
public:
  ContourFinder(
    const TriangleMesh& triangles, const ViewProjection& view, const ContourOptions& wanted)
    : options(wanted)
    , smallestSmoothCosine(std::cos(glm::radians(wanted.creaseAngle)))
    , parallelView(glm::dvec3(glm::transpose(view.viewToClip)[3]) == glm::dvec3(0.0))
    , mesh(triangles, view.modelToView)
  {
  }

  std::vector<ContourSegment> find()
  {
    this->joinSides();
    this->addNormals();
    this->addFacing();
    this->mesh.eachEdge([this](const Edge& edge) { this->addEdgeContours(edge); });
    if (this->options.silhouettes && this->options.smooth)
    {
      const auto corners = static_cast<std::int32_t>(this->mesh.cornerCount());
      for (std::int32_t first = 0; first < corners; first += 3)
      {
        this->addCrossing(first);
      }
    }
    return std::move(this->segments);
  }

private:
  using Edge = ContourMesh::Edge;

  bool isCrease(const Edge& edge) const
  {
    if (edge.size() != 2)
    {
      return edge.size() > 2;
    }
    const double cosine =
      glm::dot(this->mesh.faceNormal(edge[0].corner), this->mesh.faceNormal(edge[1].corner));
    return (this->mesh.isTwisted(edge[0], edge[1]) ? -cosine : cosine) < this->smallestSmoothCosine;
  }

  bool isSharp(const Edge& edge) const
  {
    return !this->options.smooth || edge.size() != 2 || this->mesh.isTwisted(edge[0], edge[1]) ||
      this->isCrease(edge);
  }

  // One number for the place on all half-edges of a smooth edge, and one group of all corners
  // around a vertex between sharp edges.
  void joinSides()
  {
    DisjointSets corners(this->mesh.cornerCount());
    this->places.resize(this->mesh.cornerCount());
    this->mesh.eachEdge(
      [&](const Edge& edge)
      {
        const bool sharp = this->isSharp(edge);
        for (const ContourHalfEdge& half : edge)
        {
          this->places[half.corner] = sharp ? half.corner : edge[0].corner;
        }
        if (!sharp)
        {
          corners.join(this->mesh.lowCorner(edge[0]), this->mesh.lowCorner(edge[1]));
          corners.join(this->mesh.highCorner(edge[0]), this->mesh.highCorner(edge[1]));
        }
      });
    this->groups.resize(this->mesh.cornerCount());
    for (std::size_t i = 0; i < this->groups.size(); ++i)
    {
      this->groups[i] = corners.find(static_cast<std::int32_t>(i));
    }
  }

  // The mean of the faces around, by their angles (Thuermer and Wuethrich 1998).
  void addNormals()
  {
    this->normals.assign(this->groups.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < this->groups.size(); ++i)
    {
      const auto corner = static_cast<std::int32_t>(i);
      this->normals[this->groups[i]] += this->mesh.angleAt(corner) * this->mesh.faceNormal(corner);
    }
    for (glm::dvec3& normal : this->normals)
    {
      const double length = glm::length(normal);
      normal = length > 0.0 ? normal / length : glm::dvec3(0.0);
    }
  }

  const glm::dvec3& normalAt(std::int32_t corner) const
  {
    return this->normals[this->groups[corner]];
  }

  glm::dvec3 toEye(const glm::dvec3& position) const
  {
    return this->parallelView ? glm::dvec3(0.0, 0.0, 1.0) : -position;
  }

  void addFacing()
  {
    this->facing.resize(this->mesh.cornerCount());
    parallelFor(static_cast<std::int64_t>(this->mesh.cornerCount()),
      [this](std::int64_t i)
      {
        // A flat triangle faces one way: told from one corner, rounding cannot split it.
        const auto corner = static_cast<std::int32_t>(this->options.smooth ? i : i - i % 3);
        const glm::dvec3 normal =
          this->options.smooth ? this->normalAt(corner) : this->mesh.faceNormal(corner);
        this->facing[i] = glm::dot(normal, this->toEye(this->mesh.placeOf(corner)));
      });
  }

  void addEdgeContours(const Edge& edge)
  {
    if (edge.size() == 1)
    {
      if (this->options.borders)
      {
        this->addWholeEdge(edge, ContourSide::Across);
      }
    }
    else if (this->options.creases && this->isCrease(edge))
    {
      this->addWholeEdge(edge, ContourSide::Both);
    }
    else if (this->options.silhouettes && this->isSharp(edge))
    {
      this->addSilhouetteParts(edge);
    }
  }

  void addWholeEdge(const Edge& edge, ContourSide side)
  {
    ContourSegment segment = this->edgeSegment(edge, side);
    segment.nodes = { edge[0].low, edge[0].high };
    segment.ends = { this->mesh.position(edge[0].low), this->mesh.position(edge[0].high) };
    this->segments.push_back(segment);
  }

  // What all parts of an edge have in common.
  ContourSegment edgeSegment(const Edge& edge, ContourSide side) const
  {
    ContourSegment segment;
    segment.side = side;
    const glm::dvec3 middle =
      0.5 * (this->mesh.position(edge[0].low) + this->mesh.position(edge[0].high));
    for (std::size_t i = 0; i < std::min<std::size_t>(edge.size(), 2); ++i)
    {
      const std::int32_t opposite =
        ContourMesh::nextCorner(ContourMesh::nextCorner(edge[i].corner));
      segment.away += middle - this->mesh.placeOf(opposite);
      segment.planeNormals[i] = this->mesh.faceNormal(edge[i].corner);
    }
    return segment;
  }

  // Facing of one side along an edge.
  struct EdgeSide
  {
    bool startsFront = false, endsFront = false;
    double crossing = 2.0; // where the sign changes, from 0 at the lower vertex to 1; 2: nowhere
    std::int64_t place = 0;

    bool isFront(double position) const
    {
      return position < this->crossing ? this->startsFront : this->endsFront;
    }
  };

  EdgeSide sideOf(const ContourHalfEdge& half, bool twisted) const
  {
    const double start = this->facing[this->mesh.lowCorner(half)];
    const double end = this->facing[this->mesh.highCorner(half)];
    EdgeSide side;
    side.startsFront = twisted ? start < 0.0 : start > 0.0;
    side.endsFront = twisted ? end < 0.0 : end > 0.0;
    side.place = this->placeOn(half.corner);
    if (side.startsFront != side.endsFront)
    {
      side.crossing = start / (start - end);
    }
    return side;
  }

  std::int64_t placeOn(std::int32_t halfEdge) const
  {
    return static_cast<std::int64_t>(this->mesh.vertexCount()) + this->places[halfEdge];
  }

  void addSilhouetteParts(const Edge& edge)
  {
    std::vector<EdgeSide> sides;
    std::vector<std::pair<double, std::int64_t>> cuts{ { 0.0, edge[0].low },
      { 1.0, edge[0].high } };
    sides.reserve(edge.size());
    cuts.reserve(edge.size() + 2);
    for (const ContourHalfEdge& half : edge)
    {
      const bool twisted =
        edge.size() == 2 && &half != &edge[0] && this->mesh.isTwisted(edge[0], half);
      sides.push_back(this->sideOf(half, twisted));
      if (sides.back().crossing < 2.0)
      {
        cuts.emplace_back(sides.back().crossing, sides.back().place);
      }
    }
    // Vertices first and last, also where a crossing is on one of them.
    std::sort(cuts.begin() + 2, cuts.end());
    std::rotate(cuts.begin() + 1, cuts.begin() + 2, cuts.end());
    const ContourSegment common =
      this->edgeSegment(edge, edge.size() == 2 ? ContourSide::Across : ContourSide::Both);
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      const double middle = 0.5 * (cuts[i - 1].first + cuts[i].first);
      const bool front = sides[0].isFront(middle);
      if (std::any_of(sides.begin() + 1, sides.end(),
            [&](const EdgeSide& side) { return side.isFront(middle) != front; }))
      {
        this->addPart(common, edge[0], cuts[i - 1], cuts[i]);
      }
    }
  }

  void addPart(ContourSegment segment, const ContourHalfEdge& edge,
    const std::pair<double, std::int64_t>& from, const std::pair<double, std::int64_t>& to)
  {
    const glm::dvec3& low = this->mesh.position(edge.low);
    const glm::dvec3& high = this->mesh.position(edge.high);
    segment.nodes = { from.second, to.second };
    segment.ends = { glm::mix(low, high, from.first), glm::mix(low, high, to.first) };
    this->segments.push_back(segment);
  }

  // The line of facing 0 across a triangle.
  void addCrossing(std::int32_t first)
  {
    ContourSegment segment;
    glm::dvec3 normal(0.0);
    int crossed = 0;
    for (std::int32_t corner = first; corner < first + 3; ++corner)
    {
      const std::int32_t next = ContourMesh::nextCorner(corner);
      const double from = this->facing[corner];
      const double to = this->facing[next];
      if ((from > 0.0) != (to > 0.0))
      {
        segment.nodes[crossed] = this->placeOn(corner);
        segment.ends[crossed] = this->crossingBetween(corner, next);
        const double share = from / (from - to);
        ++crossed;
        normal += glm::mix(this->normalAt(corner), this->normalAt(next), share);
      }
      segment.inset = std::max(segment.inset, this->insetOf(corner, next));
    }
    if (crossed == 2)
    {
      segment.side = ContourSide::Along;
      segment.away = this->bulges(first) ? normal : -normal;
      this->segments.push_back(segment);
    }
  }

  // The same bits from both sides of an edge.
  glm::dvec3 crossingBetween(std::int32_t from, std::int32_t to) const
  {
    if (this->mesh.vertexOf(from) > this->mesh.vertexOf(to))
    {
      std::swap(from, to);
    }
    const double share = this->facing[from] / (this->facing[from] - this->facing[to]);
    return glm::mix(this->mesh.placeOf(from), this->mesh.placeOf(to), share);
  }

  // Between the chord and the arc over it that has the normals of its ends.
  double insetOf(std::int32_t from, std::int32_t to) const
  {
    const glm::dvec3 a = this->normalAt(from);
    const glm::dvec3 b = this->normalAt(to);
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    return 0.125 * angle * glm::distance(this->mesh.placeOf(from), this->mesh.placeOf(to));
  }

  // Whether the surface is behind the line, seen from where its normals point to: facing grows
  // towards the eye. Otherwise it is a hollow, seen from its inner side.
  bool bulges(std::int32_t first) const
  {
    const glm::dvec3 eye = this->toEye(this->mesh.placeOf(first));
    glm::dvec3 gradient(0.0); // of facing in the triangle, of any length
    for (std::int32_t corner = first; corner < first + 3; ++corner)
    {
      const std::int32_t next = ContourMesh::nextCorner(corner);
      const glm::dvec3 opposite =
        this->mesh.placeOf(ContourMesh::nextCorner(next)) - this->mesh.placeOf(next);
      gradient += this->facing[corner] * glm::cross(this->mesh.faceNormal(first), opposite);
    }
    return glm::dot(gradient, eye) >= 0.0;
  }

  ContourOptions options;
  double smallestSmoothCosine;
  bool parallelView;
  ContourMesh mesh;
  // Per corner or half-edge:
  std::vector<std::int32_t> places;
  std::vector<std::int32_t> groups;
  std::vector<glm::dvec3> normals; // at the first corner of a group
  std::vector<double> facing;
  std::vector<ContourSegment> segments;
};

} // namespace

std::vector<ContourSegment> contourSegments(
  const TriangleMesh& mesh, const ViewProjection& view, const ContourOptions& options)
{
  return ContourFinder(mesh, view, options).find();
}

} // namespace hachure

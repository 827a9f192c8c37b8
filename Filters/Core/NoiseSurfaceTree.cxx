// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseSurfaceTree.h"

#include "NoiseProcess.h"
#include "NoiseTriangleOrder.h"
#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr std::int64_t leafGrain = 256;
constexpr std::int64_t nodeGrain = 2048;
// Rounding must not leave a corner outside.
constexpr double looseness = 1.0 + 1e-12;

// Octaves of a node: up to 24 points in the highest, but of a leaf up to 375, so that its
// triangles, which come next, have a dozen each. (One triangle that is nearly all of a leaf is cut
// into 16 cells for them.)
std::int32_t nodeOctave(double area, bool isLeaf)
{
  return (isLeaf ? 8 : 4) - noiseAreaExponent(area);
}

// The box around a leaf's corners, and the squares of its areas.
struct LeafExtent
{
  glm::dvec3 low{ std::numeric_limits<double>::max() };
  glm::dvec3 high{ -std::numeric_limits<double>::max() };
  double highestRatio = 0.0; // of 4 area^2 now to area^2 in the reference
  double sumOfSquares = 0.0; // not finite where a corner is not

  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    this->low = glm::min(glm::min(this->low, a), glm::min(b, c));
    this->high = glm::max(glm::max(this->high, a), glm::max(b, c));
  }

  // A sphere around the box: leaves are flat, and reach into its corners.
  NoiseSphere sphere() const
  {
    return { 0.5 * this->low + 0.5 * this->high,
      0.5 * glm::length(this->high - this->low) * looseness };
  }
};

LeafExtent leafExtent(
  const NoiseSurfaceTree& tree, Span<const glm::dvec3> positions, std::int64_t leaf)
{
  LeafExtent extent;
  for (std::int64_t i = leaf * noiseLeafSize; i < tree.leafEnd(leaf); ++i)
  {
    const NoiseFacet& facet = tree.facets[i];
    const glm::dvec3& a = positions[facet.corners.x];
    const glm::dvec3& b = positions[facet.corners.y];
    const glm::dvec3& c = positions[facet.corners.z];
    extent.add(a, b, c);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double square = glm::dot(normal, normal);
    extent.sumOfSquares += square;
    if (facet.area > 0.0)
    {
      extent.highestRatio = std::max(extent.highestRatio, square / (facet.area * facet.area));
    }
  }
  return extent;
}

[[noreturn]] void refuseLeaf(
  const NoiseSurfaceTree& tree, Span<const glm::dvec3> positions, std::int64_t leaf)
{
  for (std::int64_t i = leaf * noiseLeafSize; i < tree.leafEnd(leaf); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::int32_t point = tree.facets[i].corners[corner];
      const glm::dvec3& position = positions[point];
      if (!std::isfinite(position.x + position.y + position.z))
      {
        throw std::invalid_argument(
          "positions[" + std::to_string(point) + "]: a coordinate is not finite");
      }
    }
  }
  throw std::invalid_argument("positions: the area of a triangle next to triangle " +
    std::to_string(tree.facets[leaf * noiseLeafSize].index) + " is too large for a number");
}

NoiseSphere merge(const NoiseSphere& a, const NoiseSphere& b)
{
  const glm::dvec3 arm = b.center - a.center;
  const double distance = glm::length(arm);
  if (distance + b.radius <= a.radius)
  {
    return a;
  }
  if (distance + a.radius <= b.radius)
  {
    return b;
  }
  const double radius = 0.5 * (distance + a.radius + b.radius);
  return { a.center + arm * ((radius - a.radius) / distance), radius * looseness };
}

// Calls body(node, first child, second child or null) for all nodes above the leaves, level by
// level.
template <class Body>
void forInnerNodes(NoiseSurfaceTree& tree, std::vector<NoiseNode>& nodes, Body&& body)
{
  for (int level = 1; level < tree.levels(); ++level)
  {
    NoiseNode* children = &nodes[tree.levelFirst[level - 1]];
    const std::int64_t childCount = tree.levelSize(level - 1);
    parallelForRanges(tree.levelSize(level), nodeGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          body(tree.levelFirst[level] + i, children[2 * i],
            2 * i + 1 < childCount ? &children[2 * i + 1] : nullptr);
        }
      });
  }
}

void mergePlaces(NoiseSurfaceTree& tree, std::vector<NoiseNode>& nodes)
{
  forInnerNodes(tree, nodes,
    [&](std::int64_t node, const NoiseNode& first, const NoiseNode* second)
    {
      nodes[node].sphere = second ? merge(first.sphere, second->sphere) : first.sphere;
      nodes[node].stretch = second ? std::max(first.stretch, second->stretch) : first.stretch;
    });
}

// Makes the levels, for the leaves of this many triangles.
void makeNodes(NoiseSurfaceTree& tree)
{
  const auto triangles = static_cast<std::int64_t>(tree.facets.size());
  std::int64_t size = (triangles + noiseLeafSize - 1) / noiseLeafSize;
  tree.levelFirst.assign(1, 0);
  while (size > 0)
  {
    tree.levelFirst.push_back(tree.levelFirst.back() + size);
    size = size > 1 ? (size + 1) / 2 : 0;
  }
  tree.nodes.resize(static_cast<std::size_t>(tree.levelFirst.back()));
}

struct Reference
{
  const TriangleMesh& mesh;
  Span<const std::uint64_t> ids;
  std::uint32_t seed;
  Span<const double> areas;
  const UninitialisedArray<std::int32_t>& order;
};

bool hasCorners(const TriangleMesh& mesh, const glm::ivec3& corners)
{
  const std::size_t points = mesh.points.size();
  return static_cast<std::uint32_t>(corners.x) < points &&
    static_cast<std::uint32_t>(corners.y) < points &&
    static_cast<std::uint32_t>(corners.z) < points;
}

// Area of a triangle with these edges; 0 where it is degenerate.
double areaOf(const glm::dvec3& u, const glm::dvec3& v)
{
  const glm::dvec3 normal = glm::cross(u, v);
  const double square = glm::dot(normal, normal);
  const double lengths = glm::dot(u, u) + glm::dot(v, v);
  // The limit of isDegenerateTriangle, squared, and squares that are numbers without loss.
  const bool isDegenerate = square <= 1e-24 * lengths * lengths || square < 1e-290;
  return isDegenerate ? 0.0 : 0.5 * std::sqrt(square);
}

// Fills a leaf, and adds the points whose octaves share a count. The sum of the areas: not finite
// where something may be wrong with a triangle.
double fillLeaf(NoiseSurfaceTree& tree, const Reference& reference, std::int64_t leaf,
  std::vector<NoiseRecord>& records)
{
  NoiseNode& node = tree.nodes[leaf];
  LeafExtent extent;
  double sum = 0.0;
  for (std::int64_t i = leaf * noiseLeafSize; i < tree.leafEnd(leaf); ++i)
  {
    NoiseFacet& facet = tree.facets[i];
    facet.index = reference.order[i];
    facet.corners = reference.mesh.triangles[facet.index];
    if (!hasCorners(reference.mesh, facet.corners))
    {
      return std::numeric_limits<double>::infinity();
    }
    const glm::dvec3& a = reference.mesh.points[facet.corners.x];
    const glm::dvec3& b = reference.mesh.points[facet.corners.y];
    const glm::dvec3& c = reference.mesh.points[facet.corners.z];
    const std::uint64_t id =
      reference.ids.empty() ? noiseTriangleId(a, b, c) : reference.ids[facet.index];
    facet.area = reference.areas.empty() ? areaOf(b - a, c - a) : reference.areas[facet.index];
    facet.key = noiseTriangleKey(reference.seed, id);
    extent.add(a, b, c);
    sum += facet.area;
    node.shared = std::min(node.shared, noiseSharedOctave(facet.area));
    const NoiseBatch batch = noiseSharedBatch(facet.key, facet.area);
    for (int k = 0; k < batch.count; ++k)
    {
      const std::uint64_t point = batch.id(k);
      records.push_back({ point, batch.birth(point), static_cast<std::int32_t>(i), 0 });
    }
  }
  node.octave = nodeOctave(sum, true);
  node.sphere = extent.sphere();
  return sum;
}

using RecordParts = std::vector<std::vector<NoiseRecord>>;

RecordParts fillLeaves(
  NoiseSurfaceTree& tree, const Reference& reference, std::vector<double>& areas)
{
  const std::int64_t leaves = tree.levels() > 0 ? tree.levelSize(0) : 0;
  RecordParts parts(static_cast<std::size_t>(leaves / leafGrain + 1));
  parallelForRanges(leaves, leafGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<NoiseRecord>& part = parts[begin / leafGrain];
      for (std::int64_t leaf = begin; leaf < end; ++leaf)
      {
        areas[leaf] = fillLeaf(tree, reference, leaf, part);
      }
    });
  return parts;
}

void fillInnerNodes(NoiseSurfaceTree& tree, std::vector<double>& areas)
{
  forInnerNodes(tree, tree.nodes,
    [&](std::int64_t index, const NoiseNode& first, const NoiseNode* second)
    {
      const double* childAreas = &areas[&first - tree.nodes.data()];
      NoiseNode& node = tree.nodes[index];
      areas[index] = childAreas[0] + (second ? childAreas[1] : 0.0);
      node.octave = nodeOctave(areas[index], false);
      node.shared = second ? std::min(first.shared, second->shared) : first.shared;
    });
  mergePlaces(tree, tree.nodes);
}

// The node on the way from the record's leaf to the root that owns its octave; -1 where the
// triangle itself does.
std::int64_t findOwner(const NoiseSurfaceTree& tree, const NoiseRecord& record)
{
  const std::int32_t octave = binaryExponent(record.birth);
  std::int64_t place = record.triangle / noiseLeafSize;
  std::int64_t owner = -1;
  for (int level = 0; level < tree.levels(); ++level, place /= 2)
  {
    const std::int64_t node = tree.levelFirst[level] + place;
    if (tree.nodes[node].octave < octave)
    {
      break;
    }
    owner = node;
  }
  return owner;
}

void shareOut(NoiseSurfaceTree& tree, const RecordParts& parts)
{
  std::vector<std::vector<std::int32_t>> owners(parts.size());
  parallelForRanges(static_cast<std::int64_t>(parts.size()), 1,
    [&](std::int64_t part, std::int64_t)
    {
      owners[part].reserve(parts[part].size());
      for (const NoiseRecord& record : parts[part])
      {
        owners[part].push_back(static_cast<std::int32_t>(findOwner(tree, record)));
      }
    });
  // Entry n + 1 counts, and then is where the next record of node n goes; owner -1 is entry 0.
  std::vector<std::uint32_t> next(tree.nodes.size() + 1, 0);
  for (const std::vector<std::int32_t>& part : owners)
  {
    for (const std::int32_t owner : part)
    {
      ++next[owner + 1];
    }
  }
  next[0] = 0;
  std::partial_sum(next.begin(), next.end(), next.begin());
  tree.sharedFirst = next;
  tree.shared.resize(next.back());
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (std::size_t i = 0; i < parts[part].size(); ++i)
    {
      if (owners[part][i] >= 0)
      {
        tree.shared[next[owners[part][i]]++] = parts[part][i];
      }
    }
  }
}

// Values per triangle, where there are any.
void checkLength(const char* name, std::size_t length, const TriangleMesh& reference)
{
  if (length != 0 && length != reference.triangles.size())
  {
    std::string message = name;
    message += ": " + std::to_string(length);
    message += " values for " + std::to_string(reference.triangles.size());
    message += " triangles";
    throw std::invalid_argument(message);
  }
}

void checkAreas(Span<const double> areas)
{
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    if (!(areas[i] >= 0.0 && std::isfinite(areas[i])))
    {
      std::string message = "areas[" + std::to_string(i);
      message += "] is " + std::to_string(areas[i]);
      message += ", expected a finite number, 0 or more";
      throw std::invalid_argument(message);
    }
  }
}

} // namespace

std::uint64_t noiseTriangleKey(std::uint32_t seed, std::uint64_t id)
{
  return hashPair(seed, id);
}

NoiseSurfaceTree buildNoiseSurfaceTree(const TriangleMesh& reference, Span<const std::uint64_t> ids,
  std::uint32_t seed, Span<const double> areas)
{
  checkLength("ids", ids.size(), reference);
  checkLength("areas", areas.size(), reference);
  checkAreas(areas);
  NoiseSurfaceTree tree;
  tree.facets = UninitialisedArray<NoiseFacet>(reference.triangles.size());
  const UninitialisedArray<std::int32_t> order = orderNoiseTriangles(reference);
  makeNodes(tree);
  std::vector<double> nodeAreas(tree.nodes.size());
  const RecordParts parts = fillLeaves(tree, { reference, ids, seed, areas, order }, nodeAreas);
  const bool isFinite = std::isfinite(std::accumulate(nodeAreas.begin(), nodeAreas.end(), 0.0));
  if (!isFinite || !reference.patches.empty())
  {
    checkTriangleMesh(reference);
  }
  if (!isFinite)
  {
    throw std::invalid_argument("mesh.points: the area of the triangles is too large for a number");
  }
  fillInnerNodes(tree, nodeAreas);
  shareOut(tree, parts);
  if (!areas.empty())
  {
    placeNoiseSurfaceTree(tree, reference.points);
  }
  return tree;
}

void placeNoiseSurfaceTree(NoiseSurfaceTree& tree, Span<const glm::dvec3> positions)
{
  std::vector<NoiseNode> nodes = tree.nodes;
  const std::int64_t leaves = tree.levels() > 0 ? tree.levelSize(0) : 0;
  parallelForRanges(leaves, leafGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t leaf = begin; leaf < end; ++leaf)
      {
        const LeafExtent extent = leafExtent(tree, positions, leaf);
        if (!std::isfinite(extent.sumOfSquares))
        {
          refuseLeaf(tree, positions, leaf);
        }
        nodes[leaf].stretch = 0.5 * std::sqrt(extent.highestRatio) * looseness;
        nodes[leaf].sphere = extent.sphere();
      }
    });
  mergePlaces(tree, nodes);
  tree.nodes = std::move(nodes);
}

} // namespace hachure

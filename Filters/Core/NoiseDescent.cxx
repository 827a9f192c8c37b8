// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseDescent.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace hachure
{

namespace
{

constexpr int deepestCell = 28; // of a plane that passes through the eye

NoiseSphere cellSphere(const NoiseTriangle& triangle, const NoiseCell& cell)
{
  std::array<glm::dvec3, 3> corners;
  NoiseSphere sphere;
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = triangle.origin + cell.corners[i].x * triangle.u + cell.corners[i].y * triangle.v;
    sphere.center += corners[i] / 3.0;
  }
  double square = 0.0;
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 arm = corner - sphere.center;
    square = std::max(square, glm::dot(arm, arm));
  }
  sphere.radius = std::sqrt(square) * (1.0 + 1e-12);
  return sphere;
}

class Descent
{
public:
  Descent(
    const NoiseSurfaceTree& surfaceTree, Span<const glm::dvec3> places, const NoiseProjection& view)
    : tree(surfaceTree)
    , positions(places)
    , projection(view)
  {
  }

  std::vector<NoiseVisit> run()
  {
    if (this->tree.levels() > 0)
    {
      this->visitNode(this->tree.levels() - 1, 0, noNoiseOctave);
    }
    return std::move(this->visits);
  }

private:
  void visitNode(int level, std::int64_t place, std::int32_t octaveBelow)
  {
    const std::int64_t index = this->tree.levelFirst[level] + place;
    const NoiseNode& node = this->tree.nodes[index];
    const double density = this->densityIn(node.sphere, node.stretch);
    if (density <= lowestBirthAbove(octaveBelow))
    {
      return;
    }
    if (node.octave > octaveBelow)
    {
      this->visits.push_back({ index, -1, octaveBelow, node.octave, density, {} });
    }
    if (density <= lowestBirthAbove(node.octave))
    {
      return;
    }
    if (level == 0)
    {
      for (std::int64_t i = place * noiseLeafSize; i < this->tree.leafEnd(place); ++i)
      {
        this->visitTriangle(static_cast<std::int32_t>(i), node.octave);
      }
      return;
    }
    this->visitNode(level - 1, 2 * place, node.octave);
    if (2 * place + 1 < this->tree.levelSize(level - 1))
    {
      this->visitNode(level - 1, 2 * place + 1, node.octave);
    }
  }

  void visitTriangle(std::int32_t index, std::int32_t leafOctave)
  {
    const NoiseFacet& facet = this->tree.facets[index];
    if (!(facet.area > 0.0))
    {
      return;
    }
    const NoiseTriangle triangle = noiseTriangleAt(this->positions, facet.corners, facet.area);
    const double stretch =
      0.5 * glm::length(glm::cross(triangle.u, triangle.v)) / facet.area * (1.0 + 1e-12);
    NoiseCell cell;
    cell.key = facet.key;
    this->visitCell(index, triangle, stretch, cell, leafOctave);
  }

  void visitCell(std::int32_t index, const NoiseTriangle& triangle, double stretch,
    const NoiseCell& cell, std::int32_t octaveBelow)
  {
    const double density = this->densityIn(cellSphere(triangle, cell), stretch);
    if (density <= lowestBirthAbove(octaveBelow))
    {
      return;
    }
    const std::int32_t octave = noiseWholeOctave(triangle.area) + 2 * cell.depth;
    if (octave > octaveBelow)
    {
      this->visits.push_back({ -1, index, octaveBelow, octave, density, cell });
    }
    const std::int32_t next = std::max(octave, octaveBelow);
    for (int child = 0; child < 4 && cell.depth < deepestCell && density > lowestBirthAbove(next);
         ++child)
    {
      this->visitCell(index, triangle, stretch, noiseChild(cell, child), next);
    }
  }

  // 0 where nothing is seen.
  double densityIn(const NoiseSphere& sphere, double stretch) const
  {
    return this->projection.misses(sphere) ? 0.0 : this->projection.densityBound(sphere, stretch);
  }

  const NoiseSurfaceTree& tree;
  Span<const glm::dvec3> positions;
  const NoiseProjection& projection;
  std::vector<NoiseVisit> visits;
};

class NodePoints
{
public:
  NodePoints(const NoiseSurfaceTree& surfaceTree, std::int64_t node, std::int32_t octaveBelow,
    std::int32_t octave)
    : tree(surfaceTree)
    , lowest(octaveBelow)
    , highest(octave)
  {
    int level = 0;
    while (node >= surfaceTree.levelFirst[level + 1])
    {
      ++level;
    }
    this->addNode(level, node - surfaceTree.levelFirst[level]);
    this->records.shrink_to_fit();
  }

  std::vector<NoiseRecord> records;

private:
  void addNode(int level, std::int64_t place)
  {
    if (this->tree.nodes[this->tree.levelFirst[level] + place].shared >= this->highest)
    {
      return;
    }
    if (level == 0)
    {
      for (std::int64_t i = place * noiseLeafSize; i < this->tree.leafEnd(place); ++i)
      {
        this->addTriangle(static_cast<std::int32_t>(i));
      }
      return;
    }
    this->addNode(level - 1, 2 * place);
    if (2 * place + 1 < this->tree.levelSize(level - 1))
    {
      this->addNode(level - 1, 2 * place + 1);
    }
  }

  void addTriangle(std::int32_t triangle)
  {
    const double area = this->tree.facets[triangle].area;
    NoiseCell whole;
    whole.key = this->tree.facets[triangle].key;
    for (std::int32_t octave = std::max(this->lowest, noiseSharedOctave(area)) + 1;
         octave <= this->highest; ++octave)
    {
      this->addOctave(whole, 0, area, octave, triangle);
    }
  }

  // The points of an octave in a cell, whose number is `path`.
  void addOctave(const NoiseCell& cell, std::int32_t path, double area, std::int32_t octave,
    std::int32_t triangle)
  {
    if (cell.depth >= noiseCellDepth(area, octave))
    {
      this->addBatch(noiseBatch(cell, area, octave), triangle, path);
      return;
    }
    for (int child = 0; child < 4; ++child)
    {
      this->addOctave(
        noiseChild(cell, child), noiseChildNumber(path, child), area, octave, triangle);
    }
  }

  void addBatch(const NoiseBatch& batch, std::int32_t triangle, std::int32_t cell)
  {
    for (int i = 0; i < batch.count; ++i)
    {
      const std::uint64_t id = batch.id(i);
      this->records.push_back({ id, batch.birth(id), triangle, cell });
    }
  }

  const NoiseSurfaceTree& tree;
  const std::int32_t lowest;
  const std::int32_t highest;
};

} // namespace

std::vector<NoiseVisit> findNoiseVisits(
  const NoiseSurfaceTree& tree, Span<const glm::dvec3> positions, const NoiseProjection& projection)
{
  return Descent(tree, positions, projection).run();
}

std::vector<NoiseRecord> makeNodePoints(
  const NoiseSurfaceTree& tree, std::int64_t node, std::int32_t octaveBelow, std::int32_t octave)
{
  return NodePoints(tree, node, octaveBelow, octave).records;
}

} // namespace hachure

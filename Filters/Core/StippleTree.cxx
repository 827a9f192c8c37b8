// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleTree.h"

#include "Parallel.h"
#include "Random.h"
#include "StippleCube.h"
#include "StipplePlacing.h"
#include "StippleRefinement.h"
#include "StippleShape.h"
#include "StippleTreeBase.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

void checkFinite(const char* name, Span<const glm::dvec3> values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const glm::dvec3& value = values[i];
    if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z))
    {
      throw std::invalid_argument(
        std::string(name).append("[") + std::to_string(i) + "]: a coordinate is not finite");
    }
  }
}

void checkCount(const char* name, std::size_t count, std::size_t expected)
{
  if (count != expected)
  {
    throw std::invalid_argument(std::string(name).append(": ") + std::to_string(count) +
      ", expected " + std::to_string(expected));
  }
}

void setBounds(StippleLevels& levels, Span<const glm::dvec3> points)
{
  levels.low = levels.high = points.front();
  for (const glm::dvec3& point : points)
  {
    levels.low = glm::min(levels.low, point);
    levels.high = glm::max(levels.high, point);
  }
}

StippleFrame frameOf(const StippleShape& shape)
{
  StippleFrame frame = stippleFrame(shape.referencePoints());
  if (frame.size == 0.0) // all in one place
  {
    frame.size = 1.0;
    frame.middle = shape.referencePoints().front();
  }
  return frame;
}

// With few points the root is larger than the mesh, so that cubes have as many points as usual.
void widenFrame(StippleSurface& surface, std::size_t pointCount)
{
  double ratio = 1.0;
  while (
    static_cast<double>(pointCount) / surface.area() * ratio * ratio < 4.0 * leastPointsPerSquare)
  {
    ratio *= 2.0;
  }
  surface.frame.size *= ratio;
  for (double& area : surface.areaBefore)
  {
    area /= ratio * ratio;
  }
}

// Up to the spacing at which places are still right to a thousandth of it.
std::int32_t lastLevelFor(const StippleSurface& surface, const StippleLevels& levels)
{
  double longest = 0.0;
  for (const std::int32_t triangle : surface.triangles)
  {
    const std::array<glm::dvec3, 3> corners = surface.corners(triangle);
    for (std::size_t i = 0; i < 3; ++i)
    {
      longest = std::max(longest, glm::length(corners[i] - corners[(i + 1) % 3]));
    }
  }
  const double leastRoom = 1000.0 * StipplePlace::weightUnit * longest;
  std::int32_t level = levels.firstRefined - 1;
  while (level < StippleCube::mostLevel &&
    StippleFilling::gapFor(levels.leastDensity(level + 2)) > leastRoom)
  {
    ++level;
  }
  return level;
}

void checkRequests(Span<const StippleRequest> requests, std::size_t nodeCount)
{
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    const bool isNode =
      requests[i].node >= 0 && static_cast<std::size_t>(requests[i].node) < nodeCount;
    if (!isNode || std::isnan(requests[i].density))
    {
      throw std::invalid_argument("requests[" + std::to_string(i) + "]: node " +
        std::to_string(requests[i].node) + " of " + std::to_string(nodeCount) + ", density " +
        std::to_string(requests[i].density));
    }
  }
}

} // namespace

StippleTree::StippleTree(
  const TriangleMesh& reference, const StippleHierarchy& base, const StippleTreeOptions& options)
{
  checkTriangleMesh(reference);
  this->shape = std::make_unique<StippleShape>(reference);
  this->build(base, options);
}

StippleTree::StippleTree(Span<const glm::dvec3> points, Span<const glm::dvec3> normals,
  const StippleHierarchy& base, const StippleTreeOptions& options)
{
  checkFinite("points", points);
  checkFinite("normals", normals);
  if (!normals.empty())
  {
    checkCount("normals", normals.size(), points.size());
  }
  this->shape = std::make_unique<StippleShape>(points, normals);
  this->build(base, options);
}

StippleTree::~StippleTree() = default;
StippleTree::StippleTree(StippleTree&&) noexcept = default;
StippleTree& StippleTree::operator=(StippleTree&&) noexcept = default;

void StippleTree::build(const StippleHierarchy& base, const StippleTreeOptions& options)
{
  checkBase(base, *this->shape);
  this->levels = std::make_unique<StippleLevels>();
  const auto goesOn = [&options](double fraction)
  { return !options.progress || options.progress(fraction); };
  if (base.points.empty() || !goesOn(0.0))
  {
    return;
  }
  this->budget = options.budget;
  this->levels->frame = frameOf(*this->shape);
  setBounds(*this->levels, this->shape->referencePoints());
  if (hasEvenRanks(base, this->shape->hasMesh()))
  {
    this->prepareRefinement(options.seed, base.points.size());
  }
  setDensities(*this->levels, base, this->shape->hasMesh());
  std::vector<std::uint64_t> cubes;
  if (this->refinement)
  {
    this->levels->lastLevel = lastLevelFor(this->refinement->surface().surface(), *this->levels);
    cubes = this->refinement->surface().cubes(this->levels->firstRefined - 1);
  }
  this->allNodes = makeBaseNodes(base, *this->shape, *this->levels, cubes);
  if (!goesOn(0.7))
  {
    this->allNodes.clear();
    return;
  }
  placeAllPoints(this->allNodes, *this->shape, *this->levels);
  this->baseCount = this->allNodes.size();
  if (this->refinement)
  {
    this->refinement->enterBase(this->allNodes);
  }
  goesOn(1.0);
  this->baseMemory = this->memory();
}

void StippleTree::prepareRefinement(std::uint32_t seed, std::size_t pointCount)
{
  StippleSurface surface = makeStippleSurface(this->shape->referenceMesh());
  if (!surface.triangles.empty())
  {
    widenFrame(surface, pointCount);
    this->levels->frame = surface.frame;
    this->refinement =
      std::make_unique<StippleRefinement>(StippleTriangles(std::move(surface)), seed);
  }
}

std::uint64_t StippleTree::identity(std::int32_t node, std::int32_t point) const
{
  const StippleNode& from = this->node(node);
  if (!from.ranks.empty())
  {
    return from.ranks[static_cast<std::size_t>(point)];
  }
  constexpr std::uint64_t isRefined = std::uint64_t{ 1 } << 63;
  return hashPair(from.code, static_cast<std::uint64_t>(point)) | isRefined;
}

void StippleTree::setPositions(Span<const glm::dvec3> points, Span<const glm::dvec3> normals)
{
  checkCount("points", points.size(), this->shape->pointCount());
  checkFinite("points", points);
  if (!normals.empty())
  {
    checkCount("normals", normals.size(), this->shape->hasMesh() ? 0 : points.size());
    checkFinite("normals", normals);
  }
  this->shape->move(points, normals);
  placeAllPoints(this->allNodes, *this->shape, *this->levels);
}

bool StippleTree::refine(Span<const StippleRequest> requests, const ProgressFn& progress)
{
  checkRequests(requests, this->allNodes.size());
  bool isFineEnough = true;
  std::vector<std::int32_t> wanted;
  wanted.reserve(requests.size());
  for (const StippleRequest& request : requests)
  {
    const StippleNode& from = this->node(request.node);
    const bool isMissing = from.childCount == 0 && request.density > from.heldDensity;
    const bool isFinest = from.childCount == 0 && from.level >= this->levels->lastLevel;
    isFineEnough = isFineEnough && !isFinest;
    if (isMissing)
    {
      wanted.push_back(request.node);
    }
  }
  if (!this->refinement || wanted.empty())
  {
    return isFineEnough;
  }
  const std::size_t held = this->refinedMemory();
  StippleRefinement::Work work{ this->allNodes, *this->shape, *this->levels,
    this->budget > held ? this->budget - held : 0, progress };
  return this->refinement->refine(work, wanted) && isFineEnough;
}

void StippleTree::dropRefinements()
{
  if (!this->refinement || this->allNodes.size() == this->baseCount)
  {
    return;
  }
  this->refinement->forget(this->baseCount);
  this->allNodes.resize(this->baseCount);
  for (std::size_t i = this->baseCount; i-- > 0;)
  {
    StippleNode& node = this->allNodes[i];
    const bool isLast = node.level + 1 >= this->levels->firstRefined;
    node.childCount = isLast ? 0 : node.childCount;
    gatherBounds(this->allNodes, node);
  }
}

std::size_t StippleTree::memory() const
{
  std::size_t bytes = this->shape->memory() + (this->refinement ? this->refinement->memory() : 0);
  for (const StippleNode& node : this->allNodes)
  {
    bytes += node.memory();
  }
  return bytes;
}

} // namespace hachure

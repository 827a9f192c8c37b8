// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleTree.h"

#include "Parallel.h"
#include "Random.h"
#include "StippleCube.h"
#include "StipplePlacing.h"
#include "StippleShape.h"
#include "StippleTreeBase.h"

#include <glm/common.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

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
  this->levels->frame = frameOf(*this->shape);
  setBounds(*this->levels, this->shape->referencePoints());
  setDensities(*this->levels, base, this->shape->hasMesh());
  this->allNodes = makeBaseNodes(base, *this->shape, *this->levels, {});
  if (!goesOn(0.7))
  {
    this->allNodes.clear();
    return;
  }
  placeAllPoints(this->allNodes, *this->shape, *this->levels);
  goesOn(1.0);
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

bool StippleTree::refine(Span<const StippleRequest>, const ProgressFn&)
{
  return false;
}

bool StippleTree::canRefine() const
{
  return this->levels && this->levels->canRefine;
}

void StippleTree::dropRefinements() {}

std::size_t StippleTree::memory() const
{
  std::size_t bytes = this->shape->memory();
  for (const StippleNode& node : this->allNodes)
  {
    bytes += node.memory();
  }
  return bytes;
}

} // namespace hachure

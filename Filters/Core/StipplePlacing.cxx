// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StipplePlacing.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int laneCount = 8;

float asDensity(double density)
{
  const auto most = static_cast<double>(std::numeric_limits<float>::max());
  return std::isfinite(density) ? static_cast<float>(std::min(density, most)) : infinity;
}

// Of the density ratios of a node's points that are not infinite.
struct Ratios
{
  double least = std::numeric_limits<double>::max();
  double widest = 1.0; // largest present area / reference area, at least 1
};

// The box of the points' places; the radius is that of the sphere around all of them.
StippleBounds boxOf(const std::vector<glm::dvec3>& places)
{
  StippleBounds bounds;
  if (places.empty())
  {
    return bounds;
  }
  bounds.low = bounds.high = places.front();
  for (const glm::dvec3& place : places)
  {
    bounds.low = glm::min(bounds.low, place);
    bounds.high = glm::max(bounds.high, place);
  }
  bounds.radius = 0.0;
  for (const glm::dvec3& place : places)
  {
    bounds.radius = std::max(bounds.radius, glm::length(place - bounds.middle()));
  }
  return bounds;
}

void setCone(StippleBounds& bounds, const StippleNode& node)
{
  const float* const n[3] = { node.normal(0), node.normal(1), node.normal(2) };
  glm::vec3 sum(0.0f);
  for (std::int32_t i = 0; i < node.count; ++i)
  {
    sum += glm::vec3(n[0][i], n[1][i], n[2][i]);
  }
  const float length = glm::length(sum);
  if (!(length > 0.0f))
  {
    return;
  }
  constexpr float rounding = 1e-6f;
  bounds.axis = sum / length;
  float least = 1.0f;
  for (std::int32_t i = 0; i < node.count; ++i)
  {
    const glm::vec3 normal(n[0][i], n[1][i], n[2][i]);
    least = normal == glm::vec3(0.0f) ? -1.0f : std::min(least, glm::dot(bounds.axis, normal));
    if (least <= -1.0f)
    {
      break;
    }
  }
  bounds.cosine = std::max(-1.0f, least - rounding);
}

void setLeastOfBlocks(StippleNode& node)
{
  const float* const densities = node.density();
  float* const least = node.writableLane(laneCount - 1);
  float after = infinity;
  for (std::int32_t i = node.paddedCount() - 1; i >= 0; --i)
  {
    after = std::min(after, densities[i]);
    if (i % 8 == 0)
    {
      least[i / 8] = after;
    }
  }
}

// Makes the bounds such that they hold all the points that will be within the cube.
void widenOwn(
  StippleNode& node, const StippleShape& shape, const StippleLevels& levels, double widest)
{
  if (!shape.hasMesh())
  {
    return;
  }
  if (!shape.isMoved())
  {
    const StippleCube cube = StippleCube::fromCode(node.code);
    const glm::dvec3 low = levels.frame.middle + levels.frame.size * cube.low();
    const double side = levels.frame.size * cube.side();
    node.own.low = glm::clamp(low, levels.low, levels.high);
    node.own.high = glm::clamp(low + side, levels.low, levels.high);
    node.own.radius = 0.5 * glm::length(node.own.high - node.own.low);
  }
  else if (node.count > 0)
  {
    // Twice the widest gap, when all points of the level are there; stretched one way at the worst.
    const double gap = std::sqrt(0.5 / (4.0 * levels.leastDensity(node.level)));
    const double width = 2.0 * gap * levels.frame.size * widest;
    node.own.low -= width;
    node.own.high += width;
    node.own.radius += width;
  }
}

Ratios fillLanes(
  StippleNode& node, const StippleShape& shape, const std::vector<glm::dvec3>& places)
{
  const auto padded = static_cast<std::size_t>(node.paddedCount());
  node.lanes.assign((laneCount - 1) * padded + padded / 8, 0.0f);
  Ratios ratios;
  float* lanes[laneCount];
  for (int lane = 0; lane < laneCount; ++lane)
  {
    lanes[lane] = node.writableLane(lane);
  }
  std::fill(lanes[6], lanes[6] + node.paddedCount(), infinity);
  for (std::int32_t i = 0; i < node.count; ++i)
  {
    const auto index = static_cast<std::size_t>(i);
    const std::int32_t triangle = node.places[index].triangle;
    const glm::vec3 normal = shape.presentNormal(triangle);
    const glm::vec3 place(places[index] - node.origin);
    for (int axis = 0; axis < 3; ++axis)
    {
      lanes[axis][i] = place[axis];
      lanes[3 + axis][i] = normal[axis];
    }
    const double ratio = shape.densityRatio(triangle);
    lanes[6][i] = asDensity(ratio * static_cast<double>(node.referenceDensities[index]));
    if (std::isfinite(ratio) && ratio > 0.0)
    {
      ratios.least = std::min(ratios.least, ratio);
      ratios.widest = std::max(ratios.widest, 1.0 / ratio);
    }
  }
  return ratios;
}

} // namespace

void placePoints(StippleNode& node, const StippleShape& shape, const StippleLevels& levels)
{
  std::vector<glm::dvec3> places;
  places.reserve(node.places.size());
  for (const StipplePlace& place : node.places)
  {
    places.push_back(shape.presentPlace(place));
  }
  node.own = boxOf(places);
  node.origin = node.own.middle();
  const Ratios ratios = fillLanes(node, shape, places);
  setLeastOfBlocks(node);
  setCone(node.own, node);
  widenOwn(node, shape, levels, ratios.widest);
  node.heldDensity = std::numeric_limits<double>::infinity();
  if (node.level < levels.lastLevel)
  {
    const double held = levels.inUnitsOfMesh(4.0 * levels.leastDensity(node.level));
    // What is still to be made is above that on the reference.
    node.heldDensity = node.count > 0 && shape.isMoved() ? held * ratios.least : held;
  }
}

void inheritBounds(const std::vector<StippleNode>& nodes, StippleNode& node)
{
  if (node.count == 0 && node.parent >= 0)
  {
    const StippleBounds& parent = nodes[static_cast<std::size_t>(node.parent)].own;
    node.own = node.own.isEmpty() ? parent : node.own;
    node.own.axis = parent.axis;
    node.own.cosine = parent.cosine;
  }
}

void gatherBounds(std::vector<StippleNode>& nodes, StippleNode& node)
{
  std::vector<StippleBounds> parts;
  parts.reserve(9);
  parts.push_back(node.own);
  node.leastDensity =
    node.childCount > 0 ? std::numeric_limits<double>::infinity() : node.heldDensity;
  if (node.count > 0)
  {
    node.leastDensity = std::min(node.leastDensity, static_cast<double>(node.leastOfBlocks()[0]));
  }
  for (std::int32_t i = 0; i < node.childCount; ++i)
  {
    const StippleNode& child =
      nodes[static_cast<std::size_t>(node.children[static_cast<std::size_t>(i)])];
    parts.push_back(child.bounds);
    node.leastDensity = std::min(node.leastDensity, child.leastDensity);
  }
  node.bounds = StippleBounds::around(parts);
}

void placeAllPoints(
  std::vector<StippleNode>& nodes, const StippleShape& shape, const StippleLevels& levels)
{
  parallelFor(static_cast<std::int64_t>(nodes.size()),
    [&](std::int64_t i) { placePoints(nodes[static_cast<std::size_t>(i)], shape, levels); });
  for (StippleNode& node : nodes)
  {
    inheritBounds(nodes, node);
  }
  for (std::size_t i = nodes.size(); i-- > 0;)
  {
    gatherBounds(nodes, nodes[i]);
  }
}

} // namespace hachure

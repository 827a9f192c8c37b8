// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureSurface.h"

#include "Kernels.h"
#include "NodePlaces.h"
#include "Parallel.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
// Inside a triangle: see SurfaceFrames.h.
glm::quat turnAt(const SurfaceFrames& frames, const NodePlace& place, bool other)
{
  const std::vector<glm::quat>& turns = other ? frames.otherTurns : frames.turns;
  const glm::ivec3& corners = frames.corners[static_cast<std::size_t>(place.triangle)];
  const glm::vec3 weights(
    1.0f - place.weights.x - place.weights.y, place.weights.x, place.weights.y);
  const glm::quat first = turns[static_cast<std::size_t>(corners.x)];
  glm::quat sum = weights.x * first;
  for (int corner = 1; corner < 3; ++corner)
  {
    const glm::quat& turn = turns[static_cast<std::size_t>(corners[corner])];
    sum = sum + (glm::dot(first, turn) < 0.0f ? -weights[corner] : weights[corner]) * turn;
  }
  const float length = glm::length(sum);
  return length > 1e-6f ? sum / length : first;
}
} // namespace

ViewTextureSurface::ViewTextureSurface(
  const TriangleMesh& mesh, const SurfaceCells& ofCells, const SurfaceFrames& frames)
  : points(mesh.points.begin(), mesh.points.end())
  , triangles(mesh.triangles.begin(), mesh.triangles.end())
  , cells(ofCells)
{
  checkTriangleMesh(this->mesh());
  this->checkInput(frames);
  const auto levelCount = static_cast<std::size_t>(this->cells.finestLevel) + 1;
  this->layers.reserve(levelCount);
  this->nodes.reserve(levelCount);
  for (int level = 0; level <= this->cells.finestLevel; ++level)
  {
    this->layers.emplace_back(this->cells, level);
    this->nodes.push_back(this->layers.back().nodeCells());
  }
  this->placeNodes(frames);
}

void ViewTextureSurface::checkInput(const SurfaceFrames& frames) const
{
  checkSurfaceCells(this->mesh(), this->cells);
  const std::size_t count = this->triangles.size();
  if (frames.corners.size() != count)
  {
    throw std::invalid_argument("frames.corners: " + std::to_string(frames.corners.size()) +
      " values for " + std::to_string(count) + " triangles");
  }
  if (frames.otherTurns.size() != frames.turns.size() ||
    frames.chartsDown.size() != this->cells.charts.size())
  {
    throw std::invalid_argument(
      "frames.otherTurns, chartsDown: " + std::to_string(frames.otherTurns.size()) + " and " +
      std::to_string(frames.chartsDown.size()) + " values for " +
      std::to_string(frames.turns.size()) + " frames and " +
      std::to_string(this->cells.charts.size()) + " charts");
  }
  const auto frameCount = static_cast<int>(frames.turns.size());
  for (std::size_t triangle = 0; triangle < count; ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int frame = frames.corners[triangle][corner];
      if (frame >= frameCount || (frame < 0 && this->cells.chartOfTriangle[triangle] >= 0))
      {
        throw std::invalid_argument("frames.corners: triangle " + std::to_string(triangle) +
          " has the frame " + std::to_string(frame) + " of " + std::to_string(frameCount));
      }
    }
  }
}

void ViewTextureSurface::placeNodes(const SurfaceFrames& frames)
{
  const std::vector<NodePlace> nodePlaceList = nodePlaces(this->mesh(), this->cells);
  this->turns.assign(nodePlaceList.size(), glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
  parallelFor(static_cast<std::int64_t>(this->cells.charts.size()),
    [&](std::int64_t i)
    {
      const auto chart = static_cast<std::size_t>(i);
      for (auto node = static_cast<std::size_t>(this->cells.firstNode[chart]);
           node < static_cast<std::size_t>(this->cells.firstNode[chart + 1]); ++node)
      {
        const NodePlace& place = nodePlaceList[node];
        if (place.triangle >= 0)
        {
          const std::int32_t own =
            this->cells.chartOfTriangle[static_cast<std::size_t>(place.triangle)];
          this->turns[node] =
            turnAt(frames, place, areOtherFrames(frames, own, static_cast<std::int32_t>(chart)));
        }
      }
    });
  this->places.resize(this->layers.size());
  for (std::size_t level = 0; level < this->layers.size(); ++level)
  {
    const CellLayer& layer = this->layers[level];
    this->places[level].assign(static_cast<std::size_t>(layer.size()), glm::dvec3(0.0));
    parallelFor(layer.size(),
      [&](std::int64_t cell)
      {
        const std::int64_t node = layer.nodeOf(static_cast<std::int32_t>(cell));
        const NodePlace& place = nodePlaceList[static_cast<std::size_t>(node)];
        if (place.triangle >= 0)
        {
          const glm::ivec3& corners = this->triangles[static_cast<std::size_t>(place.triangle)];
          const glm::dvec2 weights(place.weights);
          this->places[level][static_cast<std::size_t>(cell)] =
            (1.0 - weights.x - weights.y) * this->points[static_cast<std::size_t>(corners.x)] +
            weights.x * this->points[static_cast<std::size_t>(corners.y)] +
            weights.y * this->points[static_cast<std::size_t>(corners.z)];
        }
      });
  }
}

void ViewTextureSurface::mixFromBelow(
  int level, std::int32_t cell, std::vector<NodeCells::Share>& shares) const
{
  const CellLayer& own = this->layer(level);
  const CellLayer& below = this->layer(level - 1);
  const std::int32_t chart = own.chartOf(cell);
  const int segments = own.segmentsOf(chart);
  const CellSpot spot = cellSpot(cell - own.firstOf(chart), segments);
  const glm::vec2 place =
    (glm::vec2(spot.column, spot.row) + glm::vec2((1.0f + static_cast<float>(spot.odd)) / 3.0f)) /
    static_cast<float>(segments);
  const glsl::NodeMix mix = glsl::nodesAt(place, below.segmentsOf(chart));
  const NodeCells& lists = this->nodeCells(level - 1);
  constexpr float leastWeight = 1e-6f; // what is less is rounding, of either sign
  shares.clear();
  const int numbers[3] = { mix.cell, mix.corner, mix.next };
  for (int i = 0; i < 3; ++i)
  {
    if (mix.weights[i] < leastWeight)
    {
      continue;
    }
    const auto node = static_cast<std::size_t>(below.firstLevelNodeOf(chart) + numbers[i]);
    for (std::int64_t j = lists.first[node]; j < lists.first[node + 1]; ++j)
    {
      const NodeCells::Share& share = lists.shares[static_cast<std::size_t>(j)];
      const auto same = std::find_if(shares.begin(), shares.end(),
        [&](const NodeCells::Share& other) { return other.cell == share.cell; });
      if (same != shares.end())
      {
        same->weight += mix.weights[i] * share.weight;
      }
      else
      {
        shares.push_back({ share.cell, mix.weights[i] * share.weight });
      }
    }
  }
}

} // namespace hachure

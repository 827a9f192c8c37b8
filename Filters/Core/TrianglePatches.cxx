// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglePatches.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace hachure
{
namespace
{
constexpr std::size_t slots = 4;
const glm::u8vec4 onlyFirst(255, 0, 0, 0);

struct Share
{
  int patch;
  float total;
};

// The patches of the corners: the heaviest four, equal ones by number, in the order of their
// numbers, in which screens are mixed.
std::vector<Share> sharesOf(const std::array<CornerPatches, 3>& corners)
{
  std::vector<Share> shares;
  for (const CornerPatches& corner : corners)
  {
    for (int i = 0; i < 4; ++i)
    {
      const int patch = corner.patches[static_cast<std::size_t>(i)];
      if (patch < 0 || !(corner.weights[i] > 0.0f))
      {
        continue;
      }
      const auto known = std::find_if(
        shares.begin(), shares.end(), [patch](const Share& share) { return share.patch == patch; });
      if (known == shares.end())
      {
        shares.push_back({ patch, corner.weights[i] });
      }
      else
      {
        known->total += corner.weights[i];
      }
    }
  }
  std::sort(shares.begin(), shares.end(),
    [](const Share& a, const Share& b)
    { return a.total != b.total ? a.total > b.total : a.patch < b.patch; });
  shares.resize(std::min(shares.size(), slots));
  std::sort(
    shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.patch < b.patch; });
  return shares;
}

// Weights of the kept patches at a corner.
glm::u8vec4 weightsAt(const CornerPatches& corner, const std::vector<Share>& kept)
{
  glm::vec4 weights(0.0f);
  float sum = 0.0f;
  for (std::size_t slot = 0; slot < kept.size(); ++slot)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (corner.patches[static_cast<std::size_t>(i)] == kept[slot].patch)
      {
        weights[static_cast<int>(slot)] += corner.weights[i];
        sum += corner.weights[i];
      }
    }
  }
  constexpr float whole = 255.0f;
  return sum > 0.0f ? glm::u8vec4(glm::round(whole / sum * weights)) : onlyFirst;
}

// The weight of a corner is the dot product with the dual of its edge. False without area.
bool appendShape(const TriangleCorners& points, std::vector<glm::vec4>& records)
{
  const glm::dvec3 second = points[1] - points[0];
  const glm::dvec3 third = points[2] - points[0];
  const double ss = glm::dot(second, second);
  const double st = glm::dot(second, third);
  const double tt = glm::dot(third, third);
  const double area = ss * tt - st * st;
  if (!(area > 0.0))
  {
    return false;
  }
  records.emplace_back(glm::vec3(points[0]), 0.0f);
  records.emplace_back(glm::vec3((tt * second - st * third) / area), 0.0f);
  records.emplace_back(glm::vec3((ss * third - st * second) / area), 0.0f);
  return true;
}

int drawnPatch(int patch)
{
  return std::clamp(patch, 0, maximumDrawnPatches - 1);
}

// What the triangles that end at a vertex have in common.
constexpr int unused = -1;
constexpr int several = -2;

std::vector<int> commonPatches(const TrianglePatches& triangles, std::size_t vertexCount)
{
  std::vector<int> common(vertexCount, unused);
  for (const TrianglePatches::Plain& triangle : triangles.plain)
  {
    int& known = common[triangle.lastVertex];
    known = known == unused || known == triangle.patch ? triangle.patch : several;
  }
  for (const std::uint32_t vertex : triangles.overlapLastVertex)
  {
    common[vertex] = several;
  }
  return common;
}

// The record after the last one of every vertex, and before that one its first.
std::vector<std::size_t> recordRanges(
  const TrianglePatches& triangles, const std::vector<int>& common)
{
  std::vector<std::size_t> ends(common.size() + 1, 0);
  for (const TrianglePatches::Plain& triangle : triangles.plain)
  {
    ends[triangle.lastVertex + 1] += common[triangle.lastVertex] == several ? 1 : 0;
  }
  for (const std::uint32_t vertex : triangles.overlapLastVertex)
  {
    ++ends[vertex + 1];
  }
  for (std::size_t vertex = 0; vertex < common.size(); ++vertex)
  {
    ends[vertex + 1] += ends[vertex];
  }
  return ends;
}
} // namespace

void appendTriangle(
  TrianglePatches& all, std::uint32_t lastVertex, const TriangleCorners& points, int patch)
{
  all.plain.push_back({ lastVertex, drawnPatch(patch),
    { glm::vec3(points[0]), glm::vec3(points[1]), glm::vec3(points[2]) } });
}

void appendTriangle(TrianglePatches& all, std::uint32_t lastVertex, const TriangleCorners& points,
  const std::array<CornerPatches, 3>& corners)
{
  const std::vector<Share> kept = sharesOf(corners);
  if (kept.size() <= 1)
  {
    appendTriangle(all, lastVertex, points, kept.empty() ? 0 : kept[0].patch);
    return;
  }
  if (!appendShape(points, all.overlapRecords.shapes))
  {
    return;
  }
  all.overlapLastVertex.push_back(lastVertex);
  glm::vec4 numbers(0.0f);
  for (std::size_t slot = 0; slot < slots; ++slot)
  {
    const int patch = kept[slot < kept.size() ? slot : 0].patch;
    numbers[static_cast<int>(slot)] = static_cast<float>(drawnPatch(patch));
  }
  all.overlapRecords.shapes.push_back(numbers);
  for (const CornerPatches& corner : corners)
  {
    all.overlapRecords.weights.push_back(weightsAt(corner, kept));
  }
}

VertexPatches patchesOfVertices(const TrianglePatches& triangles, std::size_t vertexCount)
{
  const std::vector<int> common = commonPatches(triangles, vertexCount);
  const std::vector<std::size_t> ends = recordRanges(triangles, common);
  VertexPatches result;
  result.vertices.reserve(vertexCount);
  for (std::size_t vertex = 0; vertex < vertexCount; ++vertex)
  {
    result.vertices.push_back(common[vertex] == several
        ? -1.0f - static_cast<float>(ends[vertex])
        : static_cast<float>(std::max(common[vertex], 0)));
  }
  result.records.shapes.resize(recordShapes * ends.back());
  result.records.weights.resize(recordWeights * ends.back());
  std::vector<std::size_t> next(ends.begin(), ends.end() - 1);
  const auto place = [&](std::uint32_t vertex, const glm::vec4* shape, const glm::u8vec4* weights)
  {
    const std::size_t record = next[vertex]++;
    glm::vec4* first = &result.records.shapes[recordShapes * record];
    std::copy_n(shape, recordShapes, first);
    first->w = next[vertex] < ends[vertex + 1] ? 1.0f : 0.0f;
    std::copy_n(weights, recordWeights, &result.records.weights[recordWeights * record]);
  };
  for (std::size_t i = 0; i < triangles.overlapLastVertex.size(); ++i)
  {
    place(triangles.overlapLastVertex[i], &triangles.overlapRecords.shapes[recordShapes * i],
      &triangles.overlapRecords.weights[recordWeights * i]);
  }
  const glm::u8vec4 whole[] = { onlyFirst, onlyFirst, onlyFirst };
  std::vector<glm::vec4> shape;
  for (const TrianglePatches::Plain& triangle : triangles.plain)
  {
    if (common[triangle.lastVertex] == several)
    {
      shape.clear();
      const TriangleCorners corners = { glm::dvec3(triangle.corners[0]),
        glm::dvec3(triangle.corners[1]), glm::dvec3(triangle.corners[2]) };
      if (!appendShape(corners, shape))
      {
        shape.assign(3, glm::vec4(0.0f)); // draws nothing
      }
      shape.emplace_back(static_cast<float>(triangle.patch));
      place(triangle.lastVertex, shape.data(), whole);
    }
  }
  return result;
}

} // namespace hachure

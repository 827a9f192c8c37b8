// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchBlendWeights.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{
namespace detail
{
PatchBorders::PatchBorders(const FaceSurface& someSurface)
  : surface(someSurface)
  , patches(static_cast<std::size_t>(someSurface.vertexCount()), -1)
  , offsets(patches.size() + 1, 0)
{
  std::vector<std::uint8_t> isBorder(patches.size(), 0);
  const auto forEachCorner = [this](auto&& body)
  {
    for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i)
    {
      const std::int32_t patch = surface.mesh.patches.empty() ? 0 : surface.mesh.patches[i];
      if (patch < 0)
      {
        continue;
      }
      const glm::ivec3 corners = surface.verticesOf(i);
      for (int k = 0; k < 3; ++k)
      {
        body(corners[k], static_cast<std::int32_t>(i), patch);
      }
    }
  };
  forEachCorner(
    [&](std::int32_t vertex, std::int32_t, std::int32_t patch)
    {
      ++offsets[vertex + 1];
      isBorder[vertex] |= patches[vertex] >= 0 && patches[vertex] != patch;
      patches[vertex] = patches[vertex] < 0 ? patch : patches[vertex];
    });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  triangles.resize(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  forEachCorner([&](std::int32_t vertex, std::int32_t triangle, std::int32_t)
    { triangles[next[vertex]++] = triangle; });
  for (std::size_t i = 0; i < isBorder.size(); ++i)
  {
    if (isBorder[i])
    {
      borders.push_back(static_cast<std::int32_t>(i));
    }
  }
}

std::int32_t VertexBlends::slotOf(std::int32_t vertex, const PatchBorders& borders)
{
  if (slots[vertex] < 0)
  {
    slots[vertex] = static_cast<std::int32_t>(vertices.size());
    vertices.push_back(vertex);
    weights.push_back({ { borders.patches[vertex], 1.0 } });
  }
  return slots[vertex];
}

void normalise(PatchWeights& weights)
{
  double sum = 0.0;
  for (const PatchWeight& weight : weights)
  {
    sum += weight.weight;
  }
  for (PatchWeight& weight : weights)
  {
    weight.weight /= sum;
  }
}
} // namespace detail

namespace
{
using detail::PatchBorders;
using detail::PatchWeight;
using detail::PatchWeights;
using detail::VertexBlends;

void addWeight(PatchWeights& weights, std::int32_t patch, double weight)
{
  const auto found = std::find_if(weights.begin(), weights.end(),
    [patch](const PatchWeight& known) { return known.patch == patch; });
  if (found == weights.end())
  {
    weights.push_back({ patch, weight });
  }
  else
  {
    found->weight += weight;
  }
}

/// 1/k for every patch at a border vertex, or its fraction of the faces there.
PatchWeights startWeights(const PatchBorders& borders, std::int32_t vertex, BlendStart start)
{
  PatchWeights weights;
  std::int32_t lastFace = -1;
  for (const std::int32_t triangle : borders.trianglesAt(vertex))
  {
    const std::int32_t face = borders.surface.faceOf(static_cast<std::size_t>(triangle));
    const double share = face == lastFace ? 0.0 : 1.0; // a face counts once
    addWeight(weights, borders.surface.mesh.patches[triangle], share);
    lastFace = face;
  }
  for (PatchWeight& weight : weights)
  {
    weight.weight = start == BlendStart::Equal ? 1.0 : weight.weight;
  }
  detail::normalise(weights);
  return weights;
}

/// The vertices across the edges of faces, ascending.
std::vector<std::int32_t> neighboursOf(const PatchBorders& borders, std::int32_t vertex)
{
  std::vector<std::pair<std::int32_t, std::int32_t>> ends; // vertex, face
  for (const std::int32_t triangle : borders.trianglesAt(vertex))
  {
    const glm::ivec3 corners = borders.surface.verticesOf(static_cast<std::size_t>(triangle));
    for (int k = 0; k < 3; ++k)
    {
      if (corners[k] != vertex)
      {
        ends.emplace_back(corners[k], borders.surface.faceOf(static_cast<std::size_t>(triangle)));
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::int32_t> neighbours;
  for (std::size_t begin = 0; begin < ends.size();)
  {
    std::size_t end = begin + 1;
    while (end < ends.size() && ends[end] == ends[begin])
    {
      ++end;
    }
    // An edge within a face is a side of two of its triangles.
    const bool isOuter = (end - begin) % 2 == 1;
    if (isOuter && (neighbours.empty() || neighbours.back() != ends[begin].first))
    {
      neighbours.push_back(ends[begin].first);
    }
    begin = end;
  }
  return neighbours;
}

/// Section 3.6 of the paper: averages over neighbours, in place of all weights at once.
class RingSmoothing
{
public:
  RingSmoothing(const PatchBorders& someBorders, VertexBlends& someBlends)
    : borders(someBorders)
    , blends(someBlends)
  {
  }

  void iterate()
  {
    // The vertices within reach grow by one ring, which has neighbours of its own.
    const std::size_t count = blends.vertices.size();
    findNeighbours();
    for (; surrounded < count; ++surrounded)
    {
      for (const std::int32_t neighbour : neighbours[surrounded])
      {
        blends.slotOf(neighbour, borders);
      }
    }
    findNeighbours();
    std::vector<PatchWeights> results(blends.vertices.size());
    parallelFor(static_cast<std::int64_t>(results.size()),
      [&](std::int64_t slot) { results[slot] = average(static_cast<std::size_t>(slot)); });
    blends.weights.swap(results);
  }

private:
  void findNeighbours()
  {
    const std::size_t begin = neighbours.size();
    neighbours.resize(blends.vertices.size());
    parallelFor(static_cast<std::int64_t>(neighbours.size() - begin),
      [&](std::int64_t i)
      {
        const std::size_t slot = begin + static_cast<std::size_t>(i);
        neighbours[slot] = neighboursOf(borders, blends.vertices[slot]);
      });
  }

  PatchWeights average(std::size_t slot) const
  {
    PatchWeights sum;
    for (const std::int32_t neighbour : neighbours[slot])
    {
      const std::int32_t other = blends.slots[neighbour];
      if (other < 0)
      {
        addWeight(sum, borders.patches[neighbour], 1.0);
        continue;
      }
      for (const PatchWeight& weight : blends.weights[other])
      {
        addWeight(sum, weight.patch, weight.weight);
      }
    }
    if (sum.empty())
    {
      return blends.weights[slot]; // all corners of its faces lie in one place
    }
    detail::normalise(sum);
    return sum;
  }

  const PatchBorders& borders;
  VertexBlends& blends;
  std::vector<std::vector<std::int32_t>> neighbours; // per slot
  std::size_t surrounded = 0; // slots from 0 on whose neighbours have slots, too
};

bool blendOverRings(const PatchBorders& borders, const BlendOptions& options, VertexBlends& blends)
{
  for (const std::int32_t vertex : borders.borders)
  {
    const std::int32_t slot = blends.slotOf(vertex, borders);
    blends.weights[slot] = startWeights(borders, vertex, options.start);
  }
  RingSmoothing smoothing(borders, blends);
  for (int i = 1; i < options.rings; ++i)
  {
    if (options.progress && !options.progress(static_cast<double>(i) / options.rings))
    {
      return false;
    }
    smoothing.iterate();
  }
  return true;
}

PatchBlend strongest(PatchWeights weights)
{
  std::sort(weights.begin(), weights.end(),
    [](const PatchWeight& a, const PatchWeight& b)
    { return a.weight != b.weight ? a.weight > b.weight : a.patch < b.patch; });
  weights.resize(std::min<std::size_t>(weights.size(), maximumBlendPatches));
  detail::normalise(weights);
  PatchBlend blend;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    blend.weights[i] = static_cast<float>(weights[i].weight);
    blend.patches[i] = blend.weights[i] > 0.0f ? weights[i].patch : -1;
  }
  return blend;
}

void checkOptions(const BlendOptions& options)
{
  if (options.rings < 1)
  {
    throw std::invalid_argument(
      "rings is " + std::to_string(options.rings) + ", expected 1 or more");
  }
  if (!(options.distance > 0.0) || !std::isfinite(options.distance))
  {
    throw std::invalid_argument(
      "distance is " + std::to_string(options.distance) + ", expected more than 0");
  }
}
} // namespace

std::vector<PatchBlend> patchBlendWeights(const FaceSurface& surface, const BlendOptions& options)
{
  checkFaceSurface(surface);
  checkOptions(options);
  const PatchBorders borders(surface);
  VertexBlends blends(borders.patches.size());
  const bool finished = options.width == BlendWidth::Rings
    ? blendOverRings(borders, options, blends)
    : detail::blendOverDistance(borders, options, blends);
  if (!finished)
  {
    return {};
  }
  std::vector<PatchBlend> results(surface.mesh.points.size());
  parallelFor(static_cast<std::int64_t>(results.size()),
    [&](std::int64_t point)
    {
      const std::int32_t vertex =
        surface.vertices.empty() ? static_cast<std::int32_t>(point) : surface.vertices[point];
      const std::int32_t slot = blends.slots[vertex];
      if (slot >= 0)
      {
        results[point] = strongest(blends.weights[slot]);
      }
      else if (borders.patches[vertex] >= 0)
      {
        results[point].patches[0] = borders.patches[vertex];
        results[point].weights[0] = 1.0f;
      }
    });
  return results;
}
} // namespace hachure

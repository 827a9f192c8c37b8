// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatches.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
std::vector<std::int32_t> numberSets(DisjointSets& sets, std::size_t count)
{
  std::vector<std::int32_t> patches(count, -1);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t lowest = sets.find(static_cast<std::int32_t>(i));
    // The lowest face of a set comes first, so that its number is known here.
    patches[i] = lowest == static_cast<std::int32_t>(i) ? next++ : patches[lowest];
  }
  return patches;
}

bool hasNormal(const FaceShape& shape)
{
  return glm::dot(shape.normal, shape.normal) > 0.0;
}

/// Joins every face without area to the neighbour of lowest number that leads to one with area.
void joinFlatFaces(const FaceGraph& graph, Span<const FaceShape> shapes, DisjointSets& sets)
{
  std::vector<std::uint8_t> known(shapes.size());
  std::deque<std::int32_t> front;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    known[i] = hasNormal(shapes[i]);
    if (known[i])
    {
      front.push_back(static_cast<std::int32_t>(i));
    }
  }
  const auto spread = [&]()
  {
    for (; !front.empty(); front.pop_front())
    {
      for (const FaceNeighbour& neighbour : graph.neighbours(front.front()))
      {
        if (!known[neighbour.face])
        {
          known[neighbour.face] = 1;
          sets.join(front.front(), neighbour.face);
          front.push_back(neighbour.face);
        }
      }
    }
  };
  spread();
  for (std::size_t i = 0; i < shapes.size(); ++i) // pieces without any area
  {
    if (!known[i])
    {
      known[i] = 1;
      front.push_back(static_cast<std::int32_t>(i));
      spread();
    }
  }
}
} // namespace

std::int32_t rankPatches(Span<const std::int64_t> labels, std::vector<std::int32_t>& patches)
{
  std::vector<std::int64_t> values(labels.begin(), labels.end());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const auto first = std::lower_bound(values.begin(), values.end(), 0);
  patches.resize(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    patches[i] = labels[i] < 0
      ? -1
      : static_cast<std::int32_t>(std::lower_bound(first, values.end(), labels[i]) - first);
  }
  return static_cast<std::int32_t>(values.end() - first);
}

std::vector<std::int32_t> numberByLowestFace(std::vector<std::int32_t>& patches)
{
  std::vector<std::int32_t> newNumbers;
  std::vector<std::int32_t> oldNumbers;
  for (std::int32_t& patch : patches)
  {
    if (patch < 0)
    {
      continue;
    }
    if (static_cast<std::size_t>(patch) >= newNumbers.size())
    {
      newNumbers.resize(static_cast<std::size_t>(patch) + 1, -1);
    }
    if (newNumbers[patch] < 0)
    {
      newNumbers[patch] = static_cast<std::int32_t>(oldNumbers.size());
      oldNumbers.push_back(patch);
    }
    patch = newNumbers[patch];
  }
  return oldNumbers;
}

std::vector<std::int32_t> connectedPatches(const FaceSurface& surface)
{
  checkFaceSurface(surface);
  const std::size_t faceCount = static_cast<std::size_t>(surface.faceCount());
  std::vector<std::int32_t> faceAtVertex(static_cast<std::size_t>(surface.vertexCount()), -1);
  DisjointSets sets(faceCount);
  for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i)
  {
    const glm::ivec3 corners = surface.verticesOf(i);
    for (int k = 0; k < 3; ++k)
    {
      std::int32_t& other = faceAtVertex[corners[k]];
      other = other < 0 ? surface.faceOf(i) : other;
      sets.join(other, surface.faceOf(i));
    }
  }
  return numberSets(sets, faceCount);
}

std::vector<std::int32_t> creasePatches(const FaceSurface& surface, double creaseAngle)
{
  checkFaceSurface(surface);
  if (!(creaseAngle >= 0.0 && creaseAngle <= 180.0))
  {
    throw std::invalid_argument(
      "creaseAngle is " + std::to_string(creaseAngle) + ", expected 0 to 180 degrees");
  }
  const FaceGraph graph(surface);
  const std::vector<FaceShape> shapes = faceShapes(surface);
  // Faces of one plane have rounded normals: at an angle of 0 they must stay together.
  const double rounding = 1e-9;
  const double smallestCosine = std::cos(glm::radians(creaseAngle)) - rounding;
  DisjointSets sets(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    for (const FaceNeighbour& neighbour : graph.neighbours(static_cast<std::int32_t>(i)))
    {
      const FaceShape& other = shapes[neighbour.face];
      const double cosine =
        (neighbour.turned ? -1.0 : 1.0) * glm::dot(shapes[i].normal, other.normal);
      if (hasNormal(shapes[i]) && hasNormal(other) && cosine >= smallestCosine)
      {
        sets.join(static_cast<std::int32_t>(i), neighbour.face);
      }
    }
  }
  joinFlatFaces(graph, shapes, sets);
  return numberSets(sets, shapes.size());
}
} // namespace hachure

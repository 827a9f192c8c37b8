// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleOperators.h"

#include "Parallel.h"
#include "Random.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

enum RandomDimension : std::uint32_t
{
  ChosenFace,
  FirstShare,
  SecondShare
};

constexpr double sharpCosine = 0.9; // a border that turns by 26 degrees or more has a corner

std::vector<StippleTree::Triangle> trianglesOf(const StippleSurface& surface)
{
  std::vector<StippleTree::Triangle> result(surface.triangles.size());
  parallelFor(static_cast<std::int64_t>(result.size()),
    [&](std::int64_t i)
    {
      const auto index = static_cast<std::size_t>(i);
      result[index] = surface.corners(surface.triangles[index]);
    });
  return result;
}

std::vector<StippleTree::Triangle> linesOf(const StippleSurface& surface)
{
  std::vector<StippleTree::Triangle> result;
  result.reserve(surface.borders.size());
  for (const StippleBorder& border : surface.borders)
  {
    result.push_back(
      { glm::dvec3(border.ends[0]), glm::dvec3(border.ends[1]), glm::dvec3(border.ends[1]) });
  }
  return result;
}

glm::dvec3 unit(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

std::vector<std::int32_t> trianglesAround(const StippleParticles& particles, std::int32_t vertex)
{
  std::vector<std::int32_t> around;
  particles.visitTriangles(vertex, [&](std::int32_t index) { around.push_back(index); });
  std::sort(around.begin(), around.end()); // whatever the history of the mesh
  return around;
}

} // namespace

std::vector<std::int32_t> borderNeighbours(const StippleParticles& particles, std::int32_t vertex)
{
  std::vector<std::int32_t> neighbours, at, result;
  particles.neighbours(vertex, neighbours);
  for (const std::int32_t neighbour : neighbours)
  {
    particles.trianglesAt(vertex, neighbour, at);
    if (at.size() == 1)
    {
      result.push_back(neighbour);
    }
  }
  return result;
}

StippleOperators::StippleOperators(
  const StippleSurface& someSurface, const StippleOptions& someOptions)
  : surface(someSurface)
  , options(someOptions)
  , faces(trianglesOf(someSurface))
  , borders(linesOf(someSurface))
{
}

double StippleOperators::share(std::int32_t vertex, std::uint32_t dimension) const
{
  return this->options.leastMove +
    (this->options.mostMove - this->options.leastMove) *
    unitRandom(this->options.seed, static_cast<std::uint64_t>(vertex), dimension);
}

// Section 2.4.1. `size`: of the move, 1 as in the paper.
glm::dvec3 StippleOperators::randomise(const StippleParticles& particles, std::int32_t vertex,
  const std::vector<std::int32_t>& around, double size) const
{
  const double random =
    unitRandom(this->options.seed, static_cast<std::uint64_t>(vertex), ChosenFace);
  const auto chosen = static_cast<std::size_t>(random * static_cast<double>(around.size()));
  const glm::ivec3 corners = particles.triangle(around[chosen]);
  const int own = corners.x == vertex ? 0 : corners.y == vertex ? 1 : 2;
  const glm::dvec3 place = particles.place(vertex);
  return place +
    size * this->share(vertex, FirstShare) * (particles.place(corners[(own + 1) % 3]) - place) +
    size * this->share(vertex, SecondShare) * (particles.place(corners[(own + 2) % 3]) - place);
}

// Whether no triangle around the vertex turns over.
bool StippleOperators::keepsSides(const StippleParticles& particles, std::int32_t vertex,
  const std::vector<std::int32_t>& around, const glm::dvec3& place) const
{
  return std::all_of(around.begin(), around.end(),
    [&](std::int32_t index)
    {
      const glm::ivec3 corners = particles.triangle(index);
      std::array<glm::dvec3, 3> moved;
      for (int i = 0; i < 3; ++i)
      {
        moved[static_cast<std::size_t>(i)] =
          corners[i] == vertex ? place : particles.place(corners[i]);
      }
      return glm::dot(glm::cross(moved[1] - moved[0], moved[2] - moved[0]),
               particles.areaVector(index)) > 0.0;
    });
}

glm::dvec3 StippleOperators::project(
  const glm::dvec3& place, const glm::dvec3& normal, double reach, StippleFoothold& foothold) const
{
  const glm::dvec3 onKnown = nearestOnTriangle(this->faces.triangle(foothold.triangle), place);
  constexpr double sameTriangle = 1e-12; // the place is on the triangle where it was
  if (glm::length(onKnown - place) < sameTriangle)
  {
    return onKnown;
  }
  StippleSpot spot;
  if (normal != glm::dvec3(0.0))
  {
    spot = this->faces.alongLine(place, normal, reach);
  }
  if (spot.item < 0)
  {
    spot = this->faces.nearest(place, { foothold.triangle, onKnown, glm::length(onKnown - place) });
  }
  foothold.triangle = spot.item;
  return spot.place;
}

glm::dvec3 StippleOperators::moveOnBorder(const StippleParticles& particles, std::int32_t vertex,
  const std::vector<std::int32_t>& around, StippleFoothold& foothold) const
{
  const std::vector<std::int32_t> ends = borderNeighbours(particles, vertex);
  glm::dvec3 place = particles.place(vertex);
  if (ends.size() == 2)
  {
    const glm::dvec3 first = particles.place(ends[0]) - place;
    const glm::dvec3 second = particles.place(ends[1]) - place;
    if (-glm::dot(unit(first), unit(second)) > sharpCosine)
    {
      const bool isSecond =
        unitRandom(this->options.seed, static_cast<std::uint64_t>(vertex), ChosenFace) >= 0.5;
      const glm::dvec3 moved =
        place + this->share(vertex, FirstShare) * (isSecond ? second : first);
      place = this->keepsSides(particles, vertex, around, moved) ? moved : place;
    }
  }
  const StippleSpot onBorder = this->borders.nearest(place);
  place = onBorder.item < 0 ? place : onBorder.place;
  return this->project(place, glm::dvec3(0.0), 0.0, foothold);
}

glm::dvec3 StippleOperators::move(
  const StippleParticles& particles, std::int32_t vertex, StippleFoothold& foothold) const
{
  const std::vector<std::int32_t> around = trianglesAround(particles, vertex);
  if (foothold.isOnBorder)
  {
    return this->moveOnBorder(particles, vertex, around, foothold);
  }
  glm::dvec3 normal(0.0);
  double reach = 0.0; // the surface is not farther away than the neighbours are
  for (const std::int32_t index : around)
  {
    normal += unit(particles.areaVector(index));
    for (int corner = 0; corner < 3; ++corner)
    {
      reach = std::max(reach, particles.length(vertex, particles.triangle(index)[corner]));
    }
  }
  glm::dvec3 place = particles.place(vertex);
  for (double size = 1.0; size > 0.1; size *= 0.5)
  {
    const glm::dvec3 moved = this->randomise(particles, vertex, around, size);
    if (this->keepsSides(particles, vertex, around, moved))
    {
      place = moved;
      break;
    }
  }
  return this->project(place, unit(normal), reach, foothold);
}

StipplePoint StippleOperators::pointAt(
  const glm::dvec3& place, const StippleFoothold& foothold) const
{
  const glm::dvec2 weights = stippleWeights(this->faces.triangle(foothold.triangle), place);
  StipplePoint point;
  point.triangle = this->surface.triangles[static_cast<std::size_t>(foothold.triangle)];
  point.weights[0] = static_cast<float>(weights.x);
  point.weights[1] = std::min(static_cast<float>(weights.y), 1.0f - point.weights[0]);
  return point;
}

} // namespace hachure

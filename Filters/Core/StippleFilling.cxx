// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleFilling.h"

// Farthest points first, as in StippleProgressive.cxx, but in and around one cube, one point after
// the other. A level is two octaves. Places to choose from are the same for all cubes of a level
// (StippleParts), so that around a cube nearly the same points come in as will be there: where
// fillings meet, little tells them apart.
//
// Points of neighbours that are filled come in at their turn. A place that would be in the way of
// one that comes in later is crowded by it from the beginning; otherwise it could be taken early.

#include "Random.h"
#include "StippleCrowd.h"
#include "StippleNeighbourhood.h"
#include "StippleParts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

// Points that fill an area up to a radius, for every radius squared (measured, in the hierarchy of
// a sphere: .47 to .49).
constexpr double pointsPerSquare = 0.48;
constexpr double octaveRatio = 0.70710678118654752; // of radii: twice the density
constexpr int octavesOfLevel = 2;
// Of the radius at the beginning of an octave:
constexpr double reachRatio = 1.6;  // how far points matter
constexpr double marginRatio = 3.0; // how far around the cube is filled for a time
constexpr double candidatesPerPoint = 24.0;

// One octave of a filling.
class Octave
{
public:
  Octave(const StippleFilling& aFilling, const StippleTriangles& someTriangles,
    const StippleLevels& levels, int aNumber)
    : filling(aFilling)
    , triangles(someTriangles)
    , number(aNumber)
  {
    const StippleCube& cube = aFilling.cube;
    this->begin = StippleFilling::roomFor(levels.leastDensity(cube.level)) / cube.side() *
      std::pow(octaveRatio, aNumber);
    this->end = this->begin * octaveRatio;
    this->reach = reachRatio * this->begin;
    this->margin = std::clamp(marginRatio * this->begin, 0.0, std::max(0.0, 1.0 - this->reach));
    this->middle = cube.low() + 0.5 * cube.side();
    // Parts of area for a density at the end of the octave.
    this->partArea =
      std::ldexp(1.0 / (candidatesPerPoint * levels.leastDensity(cube.level)), -1 - aNumber);
  }

  // Points that come in, with their rooms; known has those that are there and those that come in
  // by their room.
  void fill(
    std::vector<StippleFilling::Given>& known, std::vector<StippleFilling::Point>& kept) const
  {
    StippleCrowd crowd(static_cast<float>(1.0 + 2.0 * (this->margin + this->reach)),
      static_cast<float>(this->reach));
    crowd.begin(
      this->candidates(), this->pointsOf(known), this->borders(), this->crowdingFor(this->end));
    const std::vector<StippleFilling::Given> coming = this->comingOf(known);
    std::size_t next = 0;
    const auto begins = static_cast<float>(this->begin);
    while (const StippleCrowd::Candidate* const least = crowd.least())
    {
      const float room =
        std::min(begins, stippleRoom(least->crowding, static_cast<float>(this->reach)));
      if (next < coming.size() && coming[next].room >= room)
      {
        crowd.crowdBy({ coming[next].place, coming[next].normal, coming[next].room });
        ++next;
        continue;
      }
      const StippleCrowd::Candidate placed = *least;
      known.push_back({ placed.place, placed.normal, room });
      if (placed.isKept)
      {
        kept.push_back({ placed.origin,
          StippleFilling::densityFor(static_cast<double>(room) * this->filling.cube.side()) });
      }
      crowd.crowdBy({ placed.place, placed.normal });
    }
  }

private:
  float crowdingFor(double room) const
  {
    return stippleCrowding(
      static_cast<float>(room * room), static_cast<float>(this->reach * this->reach));
  }

  glm::vec3 inSides(const glm::dvec3& place) const
  {
    return glm::vec3((place - this->middle) / this->filling.cube.side());
  }

  std::vector<StippleCrowd::Candidate> candidates() const
  {
    const StippleCube& cube = this->filling.cube;
    const double half = (0.5 + this->margin) * cube.side();
    const glm::dvec3 low = this->middle - half;
    const glm::dvec3 high = this->middle + half;
    const std::uint64_t seed = hashPair(
      this->filling.seed, static_cast<std::uint64_t>(octavesOfLevel * cube.level + this->number));
    const StippleParts parts(this->triangles, this->partArea, seed);
    std::vector<StippleParts::Place> places;
    for (const std::int32_t triangle : this->triangles.find(low, high))
    {
      parts.add(triangle, low, high, places);
    }
    std::vector<StippleCrowd::Candidate> result;
    result.reserve(places.size());
    for (const StippleParts::Place& place : places)
    {
      const glm::ivec3 offset = StippleCube::around(place.place, cube.level).cell - cube.cell + 1;
      if ((this->filling.filled >> (offset.x + 3 * offset.y + 9 * offset.z) & 1u) == 0)
      {
        result.push_back({ this->inSides(place.place), place.normal, 0.0f, place.origin,
          offset == glm::ivec3(1) });
      }
    }
    return result;
  }

  // Those that come in within this octave or later matter only to places nearer than their rooms.
  std::vector<StippleCrowd::Point> pointsOf(const std::vector<StippleFilling::Given>& known) const
  {
    std::vector<StippleCrowd::Point> points;
    points.reserve(known.size());
    for (const StippleFilling::Given& given : known)
    {
      StippleCrowd::Point point = { given.place, given.normal };
      point.nearer = given.room > static_cast<float>(this->begin) ? point.nearer : given.room;
      points.push_back(point);
    }
    return points;
  }

  std::vector<StippleFilling::Given> comingOf(const std::vector<StippleFilling::Given>& known) const
  {
    std::vector<StippleFilling::Given> coming;
    for (const StippleFilling::Given& given : known)
    {
      if (given.room <= static_cast<float>(this->begin) &&
        given.room > static_cast<float>(this->end))
      {
        coming.push_back(given);
      }
    }
    std::stable_sort(coming.begin(), coming.end(),
      [](const StippleFilling::Given& a, const StippleFilling::Given& b)
      { return a.room > b.room; });
    return coming;
  }

  std::vector<StippleBorder> borders() const
  {
    std::vector<StippleBorder> result;
    const double half = (0.5 + this->margin + this->reach) * this->filling.cube.side();
    for (const std::int32_t triangle :
      this->triangles.find(this->middle - half, this->middle + half))
    {
      const std::array<glm::dvec3, 3> corners = this->triangles.corners(triangle);
      for (std::size_t side = 0; side < 3; ++side)
      {
        if ((this->triangles.openSides(triangle) >> side & 1u) != 0)
        {
          StippleBorder border;
          border.ends = { this->inSides(corners[side]), this->inSides(corners[(side + 1) % 3]) };
          border.normal =
            glm::vec3(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
          result.push_back(border);
        }
      }
    }
    return result;
  }

  const StippleFilling& filling;
  const StippleTriangles& triangles;
  int number;
  double begin, end, reach, margin; // in sides of the cube
  glm::dvec3 middle;                // scaled, as the area
  double partArea;
};

} // namespace

double StippleFilling::roomFor(double density)
{
  return std::sqrt(pointsPerSquare / density);
}

double StippleFilling::densityFor(double room)
{
  return pointsPerSquare / (room * room);
}

double StippleFilling::reachAround(const StippleLevels& levels, std::int32_t level)
{
  const double room = roomFor(levels.leastDensity(level)) * std::ldexp(1.0, level);
  return std::min(1.0, (reachRatio + marginRatio) * room);
}

std::vector<StippleFilling::Point> StippleFilling::fill(
  const StippleTriangles& triangles, const StippleLevels& levels) const
{
  std::vector<Given> known = this->given;
  std::vector<Point> points;
  const double least = levels.leastDensity(this->cube.level);
  for (int octave = 0; octave < octavesOfLevel; ++octave)
  {
    const std::size_t first = points.size();
    Octave(*this, triangles, levels, octave).fill(known, points);
    for (std::size_t i = first; i < points.size(); ++i)
    {
      points[i].density = std::clamp(points[i].density, least, 4.0 * least);
    }
  }
  std::stable_sort(points.begin(), points.end(),
    [](const Point& a, const Point& b) { return a.density < b.density; });
  return points;
}

} // namespace hachure

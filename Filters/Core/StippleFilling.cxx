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

// Points that fill an area up to a radius at the end of an octave, for every radius squared
// (measured). With the candidates of the next octave gaps are found that are a little wider still,
// so that at its beginning there are more by this share, which goes down to 0 at its end.
constexpr double pointsPerSquare = 0.473;
constexpr double moreAtBeginning = 0.042;
constexpr double widestLeft = 0.06; // how much wider, as a share of the radius; about the most
constexpr double octaveRatio = 0.70710678118654752; // of radii: twice the density
constexpr int octavesOfLevel = 2;
// Of the radius at the beginning of an octave:
constexpr double reachRatio = 1.6;  // how far points matter
constexpr double marginRatio = 1.5; // how far around the cube is filled for a time
constexpr double candidatesPerPoint = 24.0;

// Density at which a point with some room comes in, from shares of those at the beginning of the
// octave: such that at every density there are as many. Those left over from the octave before come
// in one after the other, too.
double densityShareFor(double roomShare)
{
  if (roomShare >= 1.0)
  {
    return 1.0 + moreAtBeginning * std::max(0.0, 1.0 - (roomShare - 1.0) / widestLeft);
  }
  const double progress = std::clamp(-2.0 * std::log2(roomShare), 0.0, 1.0);
  return (1.0 + moreAtBeginning * (1.0 - progress)) / (roomShare * roomShare);
}

// The other way round, 1 for those left over.
double roomShareFor(double share)
{
  double room = std::sqrt(1.0 / share);
  for (int i = 0; i < 3; ++i)
  {
    const double progress = std::clamp(-2.0 * std::log2(room), 0.0, 1.0);
    room = std::sqrt((1.0 + moreAtBeginning * (1.0 - progress)) / share);
  }
  return std::min(1.0, room);
}

// One octave of a filling.
class Octave
{
public:
  Octave(const StippleFilling& aFilling, const StippleTriangles& someTriangles,
    const StippleLevels& levels, int someNumber)
    : filling(aFilling)
    , triangles(someTriangles)
    , number(someNumber)
  {
    const StippleCube& cube = aFilling.cube;
    this->sidesPerLength = 1.0 / cube.side();
    this->beginDensity = std::ldexp(levels.leastDensity(cube.level), someNumber);
    this->begin = StippleFilling::gapFor(this->beginDensity) / cube.side();
    this->end = this->begin * octaveRatio;
    this->reach = reachRatio * this->begin;
    this->margin = std::clamp(marginRatio * this->begin, 0.0, std::max(0.0, 1.0 - this->reach));
    this->middle = cube.low() + 0.5 * cube.side();
    // Parts of area for a density at the end of the octave.
    this->partArea = 1.0 / (candidatesPerPoint * 2.0 * this->beginDensity);
  }

  // Points that come in, with their rooms; known has those that are there and those that come in
  // by their room.
  void fill(
    std::vector<StippleFilling::Given>& known, std::vector<StippleFilling::Point>& kept) const
  {
    StippleCrowd crowd(static_cast<float>(1.0 + 2.0 * (this->margin + this->reach)),
      static_cast<float>(this->reach), this->crowdingFor(this->end));
    crowd.setAround(this->pointsOf(known), this->borders());
    this->offerCandidates(crowd);
    crowd.begin();
    const std::vector<StippleFilling::Given> coming = this->comingOf(known);
    std::size_t next = 0;
    const auto begins = static_cast<float>(this->begin);
    while (const StippleCrowd::Candidate* const least = crowd.least())
    {
      const float found = stippleRoom(least->crowding, static_cast<float>(this->reach));
      const float room = std::min(begins, found);
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
        kept.push_back({ StipplePlace(placed.triangle, placed.weights.x, placed.weights.y),
          this->beginDensity * densityShareFor(static_cast<double>(found) / this->begin) });
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
    return glm::vec3((place - this->middle) * this->sidesPerLength);
  }

  void offerCandidates(StippleCrowd& crowd) const
  {
    const StippleCube& cube = this->filling.cube;
    const double half = (0.5 + this->margin) * cube.side();
    const glm::dvec3 low = this->middle - half;
    const glm::dvec3 high = this->middle + half;
    const int octave = octavesOfLevel * cube.level + this->number;
    const std::uint64_t seed = hashPair(this->filling.seed, static_cast<std::uint64_t>(octave));
    const StippleParts parts(this->triangles, this->partArea, seed);
    std::vector<StippleParts::Place> places;
    for (const std::int32_t triangle : this->triangles.find(low, high))
    {
      places.clear();
      parts.add(triangle, low, high, places);
      for (const StippleParts::Place& place : places)
      {
        const glm::ivec3 offset = StippleCube::around(place.place, cube.level).cell - cube.cell + 1;
        if ((this->filling.filled >> (offset.x + 3 * offset.y + 9 * offset.z) & 1u) == 0)
        {
          crowd.offer({ this->inSides(place.place), place.normal, 0.0f, offset == glm::ivec3(1),
            place.triangle, place.weights });
        }
      }
    }
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
  double sidesPerLength, beginDensity;
  double begin, end, reach, margin; // in sides of the cube
  glm::dvec3 middle;                // scaled, as the area
  double partArea;
};

} // namespace

double StippleFilling::gapFor(double density)
{
  return std::sqrt(pointsPerSquare / density);
}

double StippleFilling::roomFor(double density, double least)
{
  const double begin = density > 2.0 * least ? 2.0 * least : least;
  return gapFor(begin) * roomShareFor(density / begin);
}

double StippleFilling::reachAround(const StippleLevels& levels, std::int32_t level)
{
  const double gap = gapFor(levels.leastDensity(level)) * std::ldexp(1.0, level);
  return std::min(1.0, (reachRatio + marginRatio) * gap);
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

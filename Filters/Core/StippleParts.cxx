// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleParts.h"

// A triangle of several parts is cut into m rows of small ones like it, whose numbers in a row are
// found from the polygon that is left of it in the box. Smaller triangles are one long line of area
// (they are sorted along a curve through space), which is cut into pieces; each has its place
// somewhere on the line, and whichever triangle is there gets it.

#include "Random.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

constexpr double fewParts = 4.0; // fewer have no rows

struct Chance
{
  double first, second; // uniform in [0, 1)
};

Chance chanceOf(std::uint64_t bits)
{
  constexpr double unit = 1.0 / 4294967296.0;
  return { static_cast<double>(bits >> 32) * unit, static_cast<double>(bits & 0xffffffffu) * unit };
}

struct Range
{
  double low, high;

  void add(double value)
  {
    this->low = std::min(this->low, value);
    this->high = std::max(this->high, value);
  }
};

// Of the third corner's weight in the part of the polygon whose second is from low to high.
Range thirdWithin(const StipplePolygon& polygon, double low, double high)
{
  Range range = { 1.0, 0.0 };
  for (int i = 0; i < polygon.size(); ++i)
  {
    glm::dvec2 from = polygon.corner(i).weights;
    glm::dvec2 to = polygon.corner((i + 1) % polygon.size()).weights;
    if (from.x > to.x)
    {
      std::swap(from, to);
    }
    if (to.x >= low && from.x <= high)
    {
      const double width = to.x - from.x;
      const double slope = width > 0.0 ? (to.y - from.y) / width : 0.0;
      range.add(width > 0.0 ? from.y + slope * (std::max(low, from.x) - from.x) : from.y);
      range.add(width > 0.0 ? from.y + slope * (std::min(high, to.x) - from.x) : to.y);
    }
  }
  return range;
}

} // namespace

class StippleParts::Walk
{
public:
  Walk(const StippleParts& someParts, std::int32_t someNumber, const glm::dvec3& boxLow,
    const glm::dvec3& boxHigh, std::vector<Place>& somePlaces)
    : parts(someParts)
    , number(someNumber)
    , low(boxLow)
    , high(boxHigh)
    , places(somePlaces)
  {
    const StippleSurface& surface = someParts.triangles.surface();
    this->triangle = surface.triangles[static_cast<std::size_t>(someNumber)];
    this->corners = surface.corners(this->triangle);
    this->second = this->corners[1] - this->corners[0];
    this->third = this->corners[2] - this->corners[0];
    this->normal = glm::vec3(glm::normalize(glm::cross(this->second, this->third)));
  }

  void walk()
  {
    const std::vector<double>& before = this->parts.triangles.surface().areaBefore;
    const auto index = static_cast<std::size_t>(this->number);
    const double first = before[index] / this->parts.area;
    const double last = before[index + 1] / this->parts.area;
    if (last - first < fewParts)
    {
      this->addPieces(first, last);
    }
    else
    {
      this->addRows(std::ceil(std::sqrt(last - first)));
    }
  }

private:
  void addPieces(double first, double last)
  {
    for (double piece = std::floor(first); piece < last; piece += 1.0)
    {
      const std::uint64_t bits = hashPair(this->parts.seed, static_cast<std::uint64_t>(piece));
      const double place = piece + chanceOf(bits).first;
      if (place >= first && place < last)
      {
        Chance chance = chanceOf(hashMix(bits));
        this->reflect(chance);
        this->add(chance.first, chance.second);
      }
      if (piece + 1.0 == piece)
      {
        return; // more pieces than numbers
      }
    }
  }

  void addRows(double rows)
  {
    StipplePolygon polygon(this->corners);
    polygon.clip(this->low, this->high);
    if (polygon.isEmpty())
    {
      return;
    }
    this->rowCount = rows;
    this->triangleSeed = hashPair(this->parts.seed, static_cast<std::uint64_t>(this->triangle));
    Range across = { 1.0, 0.0 };
    for (int i = 0; i < polygon.size(); ++i)
    {
      across.add(polygon.corner(i).weights.x);
    }
    const double end = std::min(rows - 1.0, std::floor(across.high * rows));
    for (double row = std::max(0.0, std::floor(across.low * rows)); row <= end; row += 1.0)
    {
      const Range along = thirdWithin(polygon, row / rows, (row + 1.0) / rows);
      this->addRow(row, std::max(0.0, std::floor(along.low * rows)),
        std::min(rows - 1.0 - row, std::floor(along.high * rows)));
    }
  }

  // Both triangles of every square of the row.
  void addRow(double row, double begin, double end)
  {
    for (double column = begin; column <= end; column += 1.0)
    {
      const std::uint64_t square = hashPair(
        this->triangleSeed + static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(column));
      Chance chance = chanceOf(square);
      this->reflect(chance);
      this->add((row + chance.first) / this->rowCount, (column + chance.second) / this->rowCount);
      if (row + column + 1.0 < this->rowCount)
      {
        chance = chanceOf(hashMix(square));
        this->reflect(chance);
        this->add((row + 1.0 - chance.first) / this->rowCount,
          (column + 1.0 - chance.second) / this->rowCount);
      }
    }
  }

  // Into the lower half of the unit square.
  void reflect(Chance& chance) const
  {
    if (chance.first + chance.second > 1.0)
    {
      chance = { 1.0 - chance.first, 1.0 - chance.second };
    }
  }

  void add(double secondWeight, double thirdWeight)
  {
    const glm::dvec3 place =
      this->corners[0] + secondWeight * this->second + thirdWeight * this->third;
    if (glm::all(glm::greaterThanEqual(place, this->low)) &&
      glm::all(glm::lessThan(place, this->high)))
    {
      this->places.push_back(
        { place, this->normal, this->triangle, { secondWeight, thirdWeight } });
    }
  }

  const StippleParts& parts;
  std::int32_t number;
  std::int32_t triangle = 0;
  glm::dvec3 low, high;
  std::array<glm::dvec3, 3> corners{};
  glm::dvec3 second{ 0.0 }, third{ 0.0 };
  glm::vec3 normal{ 0.0f };
  double rowCount = 1.0;
  std::uint64_t triangleSeed = 0;
  std::vector<Place>& places;
};

void StippleParts::add(std::int32_t number, const glm::dvec3& low, const glm::dvec3& high,
  std::vector<Place>& places) const
{
  Walk(*this, number, low, high, places).walk();
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/CanonicalOrder.h"

#include "Core/Random.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

using namespace hachure;

namespace
{
struct Polygons
{
  std::vector<glm::dvec3> points;
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> corners;

  PolygonCells cells() const { return { this->offsets, this->corners }; }
  void add(std::initializer_list<std::int64_t> cell)
  {
    this->corners.insert(this->corners.end(), cell);
    this->offsets.push_back(static_cast<std::int64_t>(this->corners.size()));
  }
  std::vector<glm::dvec3> places(std::int64_t cell) const
  {
    std::vector<glm::dvec3> result;
    for (auto i = this->offsets[static_cast<std::size_t>(cell)];
         i < this->offsets[static_cast<std::size_t>(cell) + 1]; ++i)
    {
      result.push_back(
        this->points[static_cast<std::size_t>(this->corners[static_cast<std::size_t>(i)])]);
    }
    return result;
  }
};

// Quadrilaterals of a bent sheet.
Polygons sheet(int side)
{
  Polygons result;
  for (int i = 0; i <= side; ++i)
  {
    for (int j = 0; j <= side; ++j)
    {
      result.points.emplace_back(0.1 * i, 0.1 * j, 0.001 * i * j);
    }
  }
  for (std::int64_t i = 0; i < side; ++i)
  {
    for (std::int64_t j = 0; j < side; ++j)
    {
      const std::int64_t first = i * (side + 1) + j;
      result.add({ first, first + 1, first + side + 2, first + side + 1 });
    }
  }
  return result;
}

// The same cells in another order, with points of their own in another order.
Polygons shuffled(const Polygons& given)
{
  std::vector<std::int64_t> numbers(given.points.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::sort(numbers.begin(), numbers.end(),
    [](std::int64_t a, std::int64_t b)
    { return hashMix(static_cast<std::uint64_t>(a)) < hashMix(static_cast<std::uint64_t>(b)); });
  Polygons result;
  result.points.resize(given.points.size() + 1, glm::dvec3(1e9)); // and one of no cell
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    result.points[static_cast<std::size_t>(numbers[i])] = given.points[i];
  }
  for (std::int64_t cell = given.cells().count() - 1; cell >= 0; --cell)
  {
    for (auto i = given.offsets[static_cast<std::size_t>(cell)];
         i < given.offsets[static_cast<std::size_t>(cell) + 1]; ++i)
    {
      const auto corner = static_cast<std::size_t>(given.corners[static_cast<std::size_t>(i)]);
      result.corners.push_back(numbers[corner]);
    }
    result.offsets.push_back(static_cast<std::int64_t>(result.corners.size()));
  }
  return result;
}

std::vector<std::uint64_t> identitiesOf(const Polygons& polygons)
{
  std::vector<std::uint64_t> identities;
  for (const glm::dvec3& point : polygons.points)
  {
    identities.push_back(static_cast<std::uint64_t>(1000.0 * point.x + 0.5) * 100000 +
      static_cast<std::uint64_t>(1000.0 * point.y + 0.5));
  }
  return identities;
}
} // namespace

TEST(CanonicalOrder, DependsOnPlacesAlone)
{
  const Polygons given = sheet(40);
  const Polygons other = shuffled(given);
  const auto first = canonicalOrder(given.points, given.cells());
  const auto second = canonicalOrder(other.points, other.cells());
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::set<std::int64_t>(first.begin(), first.end()).size(), 1600u);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    ASSERT_EQ(given.places(first[i]), other.places(second[i])) << i;
  }
}

TEST(CanonicalOrder, CellsThatFollowEachOtherAreNear)
{
  const Polygons given = sheet(64);
  const auto order = canonicalOrder(given.points, given.cells());
  double sum = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    sum += glm::distance(given.places(order[i])[0], given.places(order[i - 1])[0]);
  }
  EXPECT_LT(sum / static_cast<double>(order.size() - 1), 0.3); // sides are 0.1, the sheet is 6.4
}

TEST(CanonicalOrder, PartsInOneBoxKeepTheOrderOfAll)
{
  const Polygons all = sheet(16);
  CellBox box;
  box.add(all.points, all.cells());
  Polygons part;
  part.points = all.points;
  std::vector<std::vector<glm::dvec3>> expected;
  for (const std::int64_t cell : canonicalOrder(all.points, all.cells()))
  {
    if (cell % 3 == 0)
    {
      expected.push_back(all.places(cell));
    }
  }
  for (std::size_t cell = 0; cell < 256; cell += 3)
  {
    part.add({ all.corners[4 * cell], all.corners[4 * cell + 1], all.corners[4 * cell + 2],
      all.corners[4 * cell + 3] });
  }
  const auto order = canonicalOrder(part.points, part.cells(), box);
  ASSERT_EQ(order.size(), expected.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(part.places(order[i]), expected[i]);
  }
}

TEST(CanonicalOrder, CellsThatAreNotFiniteComeLast)
{
  Polygons given = sheet(3);
  given.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  given.points.emplace_back(0.0, std::numeric_limits<double>::infinity(), 0.0);
  given.offsets.insert(given.offsets.begin() + 1, 3);
  given.corners.insert(given.corners.begin(), { 0, 1, 16 });
  std::transform(given.offsets.begin() + 2, given.offsets.end(), given.offsets.begin() + 2,
    [](std::int64_t offset) { return offset + 3; });
  given.add({ 0, 1, 17 });
  const auto order = canonicalOrder(given.points, given.cells());
  ASSERT_EQ(order.size(), 11u);
  EXPECT_EQ((std::set<std::int64_t>{ order[9], order[10] }), (std::set<std::int64_t>{ 0, 10 }));
}

TEST(CanonicalOrder, EqualCellsAreAllThere)
{
  Polygons given = sheet(1);
  given.add({ 0, 1, 3, 2 });
  const auto order = canonicalOrder(given.points, given.cells());
  EXPECT_EQ(order, (std::vector<std::int64_t>{ 0, 1 }));
}

TEST(CanonicalOrder, EmptyAndSingle)
{
  EXPECT_TRUE(canonicalOrder({}, {}).empty());
  Polygons given;
  given.points.emplace_back(1.0, 2.0, 3.0);
  given.add({ 0, 0, 0 });
  EXPECT_EQ(canonicalOrder(given.points, given.cells()).size(), 1u);
}

TEST(CanonicalOrder, RefusesCornersThatAreNoPoints)
{
  Polygons given = sheet(1);
  given.add({ 0, 1, 4 });
  EXPECT_THROW(canonicalOrder(given.points, given.cells()), std::invalid_argument);
  given.corners.back() = -1;
  EXPECT_THROW(canonicalOrder(given.points, given.cells()), std::invalid_argument);
}

TEST(DistinctPoints, AreNumberedAsTheOrderUsesThem)
{
  const Polygons given = sheet(20);
  const Polygons other = shuffled(given);
  const auto first =
    distinctPoints(identitiesOf(given), given.cells(), canonicalOrder(given.points, given.cells()));
  const auto second =
    distinctPoints(identitiesOf(other), other.cells(), canonicalOrder(other.points, other.cells()));
  ASSERT_EQ(first.first.size(), 441u);
  ASSERT_EQ(second.first.size(), 441u);
  EXPECT_EQ(second.numbers.back(), -1); // of no cell
  for (std::size_t i = 0; i < first.first.size(); ++i)
  {
    ASSERT_EQ(given.points[static_cast<std::size_t>(first.first[i])],
      other.points[static_cast<std::size_t>(second.first[i])]);
  }
}

TEST(DistinctPoints, EqualIdentitiesAreOnePoint)
{
  Polygons given; // two triangles with six points, two of which are in the same places
  given.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  given.add({ 0, 1, 2 });
  given.add({ 3, 4, 5 });
  const std::vector<std::int64_t> order{ 1, 0 };
  const auto found = distinctPoints(identitiesOf(given), given.cells(), order);
  EXPECT_EQ(found.first, (std::vector<std::int64_t>{ 3, 4, 5, 0 }));
  EXPECT_EQ(found.numbers, (std::vector<std::int64_t>{ 3, 0, 2, 0, 1, 2 }));
}

TEST(DistinctPoints, RefusesOtherOrders)
{
  const Polygons given = sheet(2);
  const std::vector<std::int64_t> order{ 0, 1 };
  EXPECT_THROW(distinctPoints(identitiesOf(given), given.cells(), order), std::invalid_argument);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/NearCells.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace hachure;

namespace
{
// Squares of side 1 in a row, each with four points of its own.
struct Row
{
  std::vector<glm::dvec3> points;
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> corners;
  std::vector<std::uint8_t> owned;

  explicit Row(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      for (const glm::dvec3 corner :
        { glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0), glm::dvec3(0, 1, 0) })
      {
        this->corners.push_back(static_cast<std::int64_t>(this->points.size()));
        this->points.push_back(corner + glm::dvec3(i, 0, 0));
      }
      this->offsets.push_back(static_cast<std::int64_t>(this->corners.size()));
      this->owned.push_back(0);
    }
  }
  std::vector<std::int64_t> near(double distance) const
  {
    return nearCells(this->points, { this->offsets, this->corners }, this->owned, distance);
  }
};
using Cells = std::vector<std::int64_t>;
} // namespace

TEST(NearCells, AreThoseWithinTheDistanceOfTheBorder)
{
  Row row(10);
  row.owned[4] = 1;
  row.owned[5] = 1;
  EXPECT_EQ(row.near(0.0), (Cells{ 3, 6 })); // corners in the same place meet
  EXPECT_EQ(row.near(0.9), (Cells{ 3, 6 }));
  EXPECT_EQ(row.near(1.0), (Cells{ 2, 3, 6, 7 }));
  EXPECT_EQ(row.near(2.5), (Cells{ 1, 2, 3, 6, 7, 8 }));
  EXPECT_EQ(row.near(100.0), (Cells{ 0, 1, 2, 3, 6, 7, 8, 9 }));
}

TEST(NearCells, AllOrNothingHasNoBorder)
{
  Row row(3);
  EXPECT_TRUE(row.near(10.0).empty());
  row.owned = { 1, 1, 1 };
  EXPECT_TRUE(row.near(10.0).empty());
}

TEST(NearCells, PartsThatDoNotMeetHaveNoBorder)
{
  Row row(2);
  row.owned[0] = 1;
  for (std::size_t i = 4; i < 8; ++i)
  {
    row.points[i].y += 0.25;
  }
  EXPECT_TRUE(row.near(0.5).empty());
}

TEST(NearCells, PlacesThatAreNotFiniteAreNearNothing)
{
  Row row(3);
  row.owned[1] = 1;
  row.points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(row.near(0.5), (Cells{ 0, 2 }));
  row.points[2].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(row.near(0.5), (Cells{ 2 }));
}

TEST(NearCells, RefusesWhatDoesNotFit)
{
  Row row(2);
  EXPECT_THROW(row.near(-1.0), std::invalid_argument);
  EXPECT_THROW(row.near(std::numeric_limits<double>::infinity()), std::invalid_argument);
  row.owned.pop_back();
  EXPECT_THROW(row.near(1.0), std::invalid_argument);
  row.owned.push_back(0);
  row.corners[0] = 8;
  EXPECT_THROW(row.near(1.0), std::invalid_argument);
}

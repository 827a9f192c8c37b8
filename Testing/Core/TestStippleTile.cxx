// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/NestedPoints.h"
#include "Core/PatternTile.h"
#include "TileTests.h"

using namespace hachure;

namespace
{

constexpr int dotsAcross = 24;
constexpr int texelsPerDot = 8;

HatchOptions someOptions(double irregularity = 0.3)
{
  HatchOptions options;
  options.size = dotsAcross * texelsPerDot;
  options.periods = dotsAcross;
  options.irregularity = irregularity;
  return options;
}

struct Blob
{
  TorusPoint centre;
  std::vector<int> texels;
};

// Connected inked areas of the tile taken as a torus.
std::vector<Blob> blobsAt(const PatternTile& tile, double tone)
{
  const int size = tile.width;
  std::vector<char> open(tile.screen.size());
  std::transform(tile.screen.begin(), tile.screen.end(), open.begin(),
    [tone](float value) { return value < tone ? 1 : 0; });
  std::vector<Blob> blobs;
  for (int start = 0; start < size * size; ++start)
  {
    if (!open[start])
    {
      continue;
    }
    Blob blob;
    const int row = start / size;
    const int column = start % size;
    std::vector<TorusPoint> pending{ { column + 0.0, row + 0.0 } }; // not wrapped
    open[start] = 0;
    double sumX = 0.0;
    double sumY = 0.0;
    while (!pending.empty())
    {
      const TorusPoint here = pending.back();
      pending.pop_back();
      sumX += here.x;
      sumY += here.y;
      const auto wrap = [size](double value) { return (static_cast<int>(value) + size) % size; };
      blob.texels.push_back(wrap(here.y) * size + wrap(here.x));
      for (const auto& [dx, dy] : { std::pair{ 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } })
      {
        const int next = wrap(here.y + dy) * size + wrap(here.x + dx);
        if (open[next])
        {
          open[next] = 0;
          pending.push_back({ here.x + dx, here.y + dy });
        }
      }
    }
    const auto count = static_cast<double>(blob.texels.size());
    blob.centre = { (sumX / count + 0.5) / size, (sumY / count + 0.5) / size };
    blobs.push_back(std::move(blob));
  }
  return blobs;
}

double torusDistance(const TorusPoint& a, const TorusPoint& b)
{
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::hypot(dx - std::round(dx), dy - std::round(dy));
}

// Mean distance to the nearest neighbour over what it is for points without order, 1 / (2 sqrt(n)).
double clarkEvans(const std::vector<TorusPoint>& points)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double nearest = 2.0;
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      nearest = j == i ? nearest : std::min(nearest, torusDistance(points[i], points[j]));
    }
    sum += nearest;
  }
  const auto count = static_cast<double>(points.size());
  return 2.0 * std::sqrt(count) * sum / count;
}

} // namespace

TEST(StippleTile, IsUniformAndSeamless)
{
  for (const double irregularity : { 0.0, 1.0 })
  {
    const PatternTile tile = stippleTile(someOptions(irregularity));
    expectSeamless(tile);
    for (const PatternTile& level : mipChain(tile))
    {
      expectUniform(level);
    }
  }
}

TEST(StippleTile, DotsAreBlueNoiseAtEveryTone)
{
  for (const std::uint32_t seed : { 1u, 2u, 3u })
  {
    HatchOptions options = someOptions();
    options.seed = seed;
    const PatternTile tile = stippleTile(options);
    for (const double tone : { 0.1, 0.15, 0.2, 0.25, 0.3 })
    {
      std::vector<TorusPoint> centres;
      for (const Blob& blob : blobsAt(tile, tone))
      {
        centres.push_back(blob.centre);
      }
      EXPECT_GE(clarkEvans(centres), 1.6) << "seed " << seed << ", tone " << tone;
    }
  }
}

// More tone means more dots, not larger ones, until they stand side by side.
TEST(StippleTile, DotsAppearOneByOne)
{
  const PatternTile tile = stippleTile(someOptions());
  const auto sparse = static_cast<double>(blobsAt(tile, 0.1).size());
  const auto middle = static_cast<double>(blobsAt(tile, 0.2).size());
  const auto dense = static_cast<double>(blobsAt(tile, 0.3).size());
  EXPECT_NEAR(middle / sparse, 2.0, 0.2);
  EXPECT_NEAR(dense / sparse, 3.0, 0.35);
  EXPECT_NEAR(sparse, dotsAcross * dotsAcross * 0.1 / 0.42, 0.15 * sparse);
}

TEST(StippleTile, DotsStayInTheHalfSizeCopy)
{
  const PatternTile tile = stippleTile(someOptions());
  const int size = tile.width;
  for (const double tone : { 0.1, 0.25 })
  {
    int stay = 0;
    const std::vector<Blob> blobs = blobsAt(tile, tone);
    for (const Blob& blob : blobs)
    {
      stay += std::any_of(blob.texels.begin(), blob.texels.end(),
                [&](int texel)
                {
                  const int twice = texel / size * 2 % size * size + texel % size * 2 % size;
                  return tile.screen[twice] < tone;
                })
        ? 1
        : 0;
    }
    EXPECT_GT(stay, 0.93 * static_cast<double>(blobs.size())) << tone;
  }
}

TEST(StippleTile, PointsAreClosedUnderDoubling)
{
  for (const int count : { 1, 5, 64, 700 })
  {
    const std::vector<TorusPoint> points = nestedPoints(count, 4);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
    for (int i = 7; i < count; ++i)
    {
      const TorusPoint twice = { 2.0 * points[i].x, 2.0 * points[i].y };
      const bool near = std::any_of(points.begin(), points.begin() + i + 1,
        [&](const TorusPoint& earlier)
        { return torusDistance(twice, earlier) < 2.0 * 0.3501 / std::sqrt(count); });
      ASSERT_TRUE(near) << i << " of " << count;
    }
  }
}

TEST(StippleTile, ThreadsDoNotMatterAndTheSeedDoes)
{
  HatchOptions options = someOptions();
  const auto [one, eight] = withOneAndEightThreads([&] { return stippleTile(options); });
  EXPECT_EQ(one.screen, eight.screen);
  EXPECT_EQ(one.gradient, eight.gradient);
  options.seed = 2;
  EXPECT_NE(one.screen, stippleTile(options).screen);
}

TEST(StippleTile, WrongArgumentsAreNamed)
{
  HatchOptions options;
  options.size = 4096;
  options.periods = 300;
  EXPECT_NE(messageOf([&] { stippleTile(options); }).find("periods: 300"), std::string::npos);
  options.irregularity = 2.0;
  EXPECT_NE(messageOf([&] { stippleTile(options); }).find("irregularity: 2"), std::string::npos);
  EXPECT_NE(messageOf([] { nestedPoints(0, 1); }).find("count: 0"), std::string::npos);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PatternTile.h"
#include "TileTests.h"

using namespace hachure;

namespace
{

CrossHatchOptions someOptions(int densities, double irregularity)
{
  CrossHatchOptions options;
  options.size = 256;
  options.periods = 4;
  options.densities = densities;
  options.irregularity = irregularity;
  return options;
}

// Lines that a cut through the tile meets, and their mean width in texels.
struct Cut
{
  double lines;
  double width;
};

// Mean over all columns (rows when `alongX`) of the tile, which repeats.
Cut cutAt(const PatternTile& tile, double tone, bool alongX = false)
{
  int begins = 0;
  int inked = 0;
  const int size = tile.width;
  for (int i = 0; i < size; ++i)
  {
    const auto ink = [&](int j)
    { return tile.screen[alongX ? i * size + j % size : j % size * size + i] < tone; };
    for (int j = 0; j < size; ++j)
    {
      begins += !ink(j) && ink(j + 1) ? 1 : 0;
      inked += ink(j) ? 1 : 0;
    }
  }
  return { static_cast<double>(begins) / size, static_cast<double>(inked) / std::max(1, begins) };
}

} // namespace

TEST(HatchDensities, TilesAreUniformAndSeamless)
{
  for (int densities = 1; densities <= 4; ++densities)
  {
    for (const double irregularity : { 0.0, 0.7 })
    {
      for (const PatternTile& tile : { hatchTile(someOptions(densities, irregularity)),
             crossHatchTile(someOptions(densities, irregularity)) })
      {
        expectSeamless(tile);
        for (const PatternTile& level : mipChain(tile))
        {
          expectUniform(level);
        }
      }
    }
  }
}

TEST(HatchDensities, LinesDoubleWhereADensitySetsIn)
{
  for (int densities = 2; densities <= 4; ++densities)
  {
    const PatternTile ruled = hatchTile(someOptions(densities, 0.0));
    const PatternTile drawn = hatchTile(someOptions(densities, 0.6));
    for (int density = 0; density < densities; ++density)
    {
      // Before the next density sets in, all lines of this one are there.
      const double tone = densityTone(density + 1, densities) * 0.97;
      const double lines = 4.0 * (1 << density);
      EXPECT_EQ(cutAt(ruled, tone).lines, lines) << densities << " " << density;
      // Strokes overlap at their ends and leave gaps: more or fewer lines, here and there.
      EXPECT_GT(cutAt(drawn, tone).lines, 0.75 * lines) << densities << " " << density;
      EXPECT_LT(cutAt(drawn, tone).lines, 1.4 * lines) << densities << " " << density;
    }
    EXPECT_DOUBLE_EQ(densityTone(densities, densities), 0.5);
    EXPECT_GT(densityTone(2, densities), 2.0 * densityTone(1, densities));
    EXPECT_LT(densityTone(2, densities), 2.5 * densityTone(1, densities));
  }
}

TEST(HatchDensities, LinesKeepNearlyOneWidth)
{
  const PatternTile one = hatchTile(someOptions(1, 0.6));
  const PatternTile three = hatchTile(someOptions(3, 0.6));
  EXPECT_GT(cutAt(one, 0.5).width, 3.0 * cutAt(one, 0.12).width);
  EXPECT_LT(cutAt(three, 0.5).width, 1.7 * cutAt(three, 0.12).width);
}

TEST(HatchDensities, CrossingSetsInAtItsTone)
{
  CrossHatchOptions options = someOptions(3, 0.0);
  options.delay = 0.4;
  const PatternTile tile = crossHatchTile(options);
  EXPECT_EQ(cutAt(tile, 0.39, true).lines, 0.0);
  EXPECT_GT(cutAt(tile, 0.6, true).lines, 1.9);
}

// Where the tile has a line, so has the half-size copy about the origin, at every tone.
TEST(HatchDensities, LinesStayInTheHalfSizeCopy)
{
  const PatternTile tile = hatchTile(someOptions(3, 0.0));
  for (const double tone : { 0.05, 0.2, 0.45 })
  {
    for (int line = 0; line < 4; ++line)
    {
      EXPECT_LT(tile.screen[static_cast<std::size_t>(line) * 64 * 256], tone);
      EXPECT_LT(tile.screen[static_cast<std::size_t>(line) * 128 % 256 * 256], tone);
    }
  }
}

TEST(HatchDensities, ThreadsDoNotMatterAndTheSeedDoes)
{
  CrossHatchOptions options = someOptions(3, 0.5);
  const auto [one, eight] = withOneAndEightThreads([&] { return crossHatchTile(options); });
  EXPECT_EQ(one.screen, eight.screen);
  EXPECT_EQ(one.gradient, eight.gradient);
  options.seed = 2;
  EXPECT_NE(one.screen, crossHatchTile(options).screen);
}

TEST(HatchDensities, WrongArgumentsAreNamed)
{
  EXPECT_NE(
    messageOf([] { hatchTile(someOptions(0, 0.0)); }).find("densities: 0"), std::string::npos);
  EXPECT_NE(
    messageOf([] { crossHatchTile(someOptions(5, 0.0)); }).find("densities: 5"), std::string::npos);
  HatchOptions options = someOptions(4, 0.0);
  options.periods = 16;
  EXPECT_NE(
    messageOf([&] { hatchTile(options); }).find("densities: 4 make 128 lines of 16 periods"),
    std::string::npos);
  EXPECT_NE(messageOf([] { densityTone(4, 3); }).find("density: 4"), std::string::npos);
}

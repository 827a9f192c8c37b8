// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PaperTile.h"
#include "TileTests.h"

using namespace hachure;

namespace
{

PaperOptions someOptions(double grain, double fibres, double laid, double weave)
{
  PaperOptions options;
  options.size = 128;
  options.periods = 16;
  options.grain = grain;
  options.fibres = fibres;
  options.laid = laid;
  options.weave = weave;
  return options;
}

std::vector<PaperOptions> allOptions()
{
  return { PaperOptions(), someOptions(1.0, 0.0, 0.0, 0.0), someOptions(0.0, 1.0, 0.0, 0.0),
    someOptions(0.3, 0.2, 1.0, 0.0), someOptions(0.2, 0.2, 0.0, 1.0) };
}

double meanHeight(const PatternTile& tile, int row)
{
  double sum = 0.0;
  for (int x = 0; x < tile.width; ++x)
  {
    sum += tile.screen[static_cast<std::size_t>(row) * tile.width + x];
  }
  return sum / tile.width;
}

} // namespace

TEST(PaperTile, IsUniformAndSeamless)
{
  for (const PaperOptions& options : allOptions())
  {
    const PatternTile tile = paperTile(options);
    expectSeamless(tile);
    for (const PatternTile& level : mipChain(tile))
    {
      expectUniform(level);
    }
  }
}

TEST(PaperTile, LaidRibsLieOnWholePeriods)
{
  const PatternTile laid = paperTile(someOptions(0.3, 0.2, 1.0, 0.0));
  const PatternTile plain = paperTile(someOptions(1.0, 0.2, 0.0, 0.0));
  const auto rib = [](const PatternTile& tile)
  {
    double sum = 0.0;
    for (int line = 0; line < 16; ++line)
    {
      sum += meanHeight(tile, line * 8) - meanHeight(tile, line * 8 + 4);
    }
    return sum / 16.0;
  };
  EXPECT_GT(rib(laid), 0.4);
  EXPECT_LT(std::abs(rib(plain)), 0.1);
}

// One grain is about one period wide: heights half a period apart tell hardly more than nothing.
TEST(PaperTile, GrainsHaveOneSize)
{
  const PatternTile tile = paperTile(someOptions(1.0, 0.0, 0.0, 0.0));
  const auto correlation = [&](int step)
  {
    double sum = 0.0;
    for (int i = 0; i < 128 * 128; ++i)
    {
      const int other = i / 128 * 128 + (i % 128 + step) % 128;
      sum += (tile.screen[i] - 0.5) * (tile.screen[other] - 0.5);
    }
    return sum * 12.0 / (128 * 128);
  };
  EXPECT_GT(correlation(1), 0.85);
  EXPECT_LT(correlation(6), 0.3);
  EXPECT_LT(std::abs(correlation(24)), 0.1);
}

TEST(PaperTile, ThreadsDoNotMatterAndTheSeedDoes)
{
  PaperOptions options = someOptions(1.0, 0.5, 0.5, 0.5);
  const auto [one, eight] = withOneAndEightThreads([&] { return paperTile(options); });
  EXPECT_EQ(one.screen, eight.screen);
  EXPECT_EQ(one.gradient, eight.gradient);
  options.seed = 2;
  EXPECT_NE(one.screen, paperTile(options).screen);
}

TEST(PaperTile, WrongArgumentsAreNamed)
{
  const auto message = [](auto change)
  {
    PaperOptions options;
    change(options);
    return messageOf([&] { paperTile(options); });
  };
  using Options = PaperOptions;
  EXPECT_NE(message([](Options& o) { o.size = 4; }).find("size: 4"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.periods = 65; }).find("periods: 65"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.grain = 2.0; }).find("grain: 2"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.fibres = -1.0; }).find("fibres: -1"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.laid = NAN; }).find("laid: nan"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.weave = 3.0; }).find("weave: 3"), std::string::npos);
  EXPECT_NE(
    message([](Options& o) { o.grain = o.fibres = 0.0; }).find("grain: 0, and"), std::string::npos);
}

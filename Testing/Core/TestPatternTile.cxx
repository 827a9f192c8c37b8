// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/PatternTile.h"
#include "TileTests.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace hachure;

namespace
{

CrossHatchOptions someOptions(double irregularity, int size = 128)
{
  CrossHatchOptions options;
  options.size = size;
  options.irregularity = irregularity;
  return options;
}

std::vector<PatternTile> allTiles(double irregularity)
{
  const CrossHatchOptions options = someOptions(irregularity);
  CrossHatchOptions oblique = options;
  oblique.crossingAngle = 55.0;
  return { hatchTile(options), crossHatchTile(options), crossHatchTile(oblique),
    halftoneTile(options) };
}

} // namespace

TEST(PatternTile, EveryLevelOfEveryTileIsUniform)
{
  for (const double irregularity : { 0.0, 0.4, 1.0 })
  {
    for (const PatternTile& tile : allTiles(irregularity))
    {
      for (const PatternTile& level : mipChain(tile))
      {
        expectUniform(level);
      }
    }
  }
}

TEST(PatternTile, RepeatsWithoutSeam)
{
  for (const double irregularity : { 0.0, 0.4, 1.0 })
  {
    for (const PatternTile& tile : allTiles(irregularity))
    {
      expectSeamless(tile);
    }
  }
}

TEST(PatternTile, RuledHatchIsTheKernel)
{
  const PatternTile tile = hatchTile(someOptions(0.0));
  const float step = 2.0f * tile.periods / tile.height; // between two rows of texels
  for (int i = 0; i < tile.width * tile.height; ++i)
  {
    const int row = i / tile.width;
    const float y = (static_cast<float>(row) + 0.5f) / tile.height * tile.periods;
    ASSERT_NEAR(tile.screen[i], glsl::hatchScreen(glm::vec2(0.0f, y)), 0.01f * step);
    ASSERT_NEAR(tile.gradient[i], step, 0.01f * step);
  }
}

TEST(PatternTile, DrawnLinesAreStrokesWithEnds)
{
  const auto unbrokenRows = [](const PatternTile& tile)
  {
    int rows = 0;
    for (int y = 0; y < tile.height; ++y)
    {
      const float* row = &tile.screen[static_cast<std::size_t>(y) * tile.width];
      rows += *std::max_element(row, row + tile.width) < 0.25f ? 1 : 0;
    }
    return rows;
  };
  EXPECT_EQ(unbrokenRows(hatchTile(someOptions(0.0))), 32);
  EXPECT_LE(unbrokenRows(hatchTile(someOptions(1.0))), 2);
}

TEST(PatternTile, CrossHatchBeginsAsHatch)
{
  for (const double irregularity : { 0.0, 0.7 })
  {
    CrossHatchOptions options = someOptions(irregularity);
    options.delay = 0.4;
    const PatternTile hatch = hatchTile(options);
    const PatternTile cross = crossHatchTile(options);
    int wrong = 0;
    for (std::size_t i = 0; i < hatch.screen.size(); ++i)
    {
      const bool inHatch = hatch.screen[i] < 0.39f;
      wrong += (cross.screen[i] < 0.39f) != inHatch ? 1 : 0;
    }
    EXPECT_LT(wrong, 0.01 * static_cast<double>(hatch.screen.size()));
  }
}

TEST(PatternTile, ImagesOfAnyShapeAndFewLevels)
{
  std::vector<float> grey(15 * 7);
  for (std::size_t i = 0; i < grey.size(); ++i)
  {
    grey[i] = static_cast<float>(i * i % 4);
  }
  const PatternTile tile = imageTile(grey, 15, 7, 2);
  EXPECT_EQ(tile.levels, 2); // squares are 0 or 1 modulo 4
  for (const PatternTile& level : mipChain(tile))
  {
    expectUniform(level);
  }
  for (std::size_t i = 0; i < grey.size(); ++i)
  {
    EXPECT_EQ(tile.screen[i] < 53.0f / 105.0f, grey[i] == 0.0f); // dark is inked first
    EXPECT_GE(tile.gradient[i], 52.0f / 105.0f);                 // flat areas print grey
  }
  expectUniform(imageTile(std::vector<float>(16, 3.0f), 4, 4));
}

TEST(PatternTile, ThreadsDoNotMatter)
{
  const int threads = omp_get_max_threads();
  for (const double irregularity : { 0.0, 0.6 })
  {
    omp_set_num_threads(1);
    const std::vector<PatternTile> one = allTiles(irregularity);
    omp_set_num_threads(8);
    const std::vector<PatternTile> eight = allTiles(irregularity);
    omp_set_num_threads(threads);
    for (std::size_t i = 0; i < one.size(); ++i)
    {
      EXPECT_EQ(one[i].screen, eight[i].screen);
      EXPECT_EQ(mipChain(one[i])[2].gradient, mipChain(eight[i])[2].gradient);
    }
  }
}

TEST(PatternTile, SeedChangesTheHand)
{
  CrossHatchOptions options = someOptions(0.5);
  const PatternTile first = hatchTile(options);
  EXPECT_EQ(first.screen, hatchTile(options).screen);
  options.seed = 2;
  EXPECT_NE(first.screen, hatchTile(options).screen);
}

TEST(PatternTile, WrongArgumentsAreNamed)
{
  const auto message = [](auto change)
  {
    CrossHatchOptions options;
    change(options);
    return messageOf([&] { crossHatchTile(options); });
  };
  using Options = CrossHatchOptions;
  EXPECT_NE(message([](Options& o) { o.size = 4; }).find("size: 4"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.periods = 200; }).find("periods: 200"), std::string::npos);
  EXPECT_NE(
    message([](Options& o) { o.irregularity = -1.0; }).find("irregularity: -1"), std::string::npos);
  EXPECT_NE(
    message([](Options& o) { o.irregularity = NAN; }).find("irregularity: nan"), std::string::npos);
  EXPECT_NE(
    message([](Options& o) { o.crossingAngle = 0.0; }).find("crossingAngle: 0"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.delay = 1.0; }).find("delay: 1"), std::string::npos);
  const std::vector<float> grey{ 0.0f, NAN, 1.0f, 2.0f };
  EXPECT_NE(messageOf([&] { imageTile(grey, 2, 2); }).find("nan at texel 1"), std::string::npos);
  EXPECT_NE(
    messageOf([&] { imageTile(grey, 3, 2); }).find("4 values for 3 x 2"), std::string::npos);
  EXPECT_NE(messageOf([&] { imageTile({}, 0, 0); }).find("width: 0"), std::string::npos);
  EXPECT_NE(messageOf([] { mipChain(PatternTile()); }).find("tile: 0 x 0"), std::string::npos);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PaintTile.h"
#include "TileTests.h"

#include <map>

using namespace hachure;

namespace
{

PaintOptions someOptions()
{
  PaintOptions options;
  options.size = 120;
  options.periods = 6;
  return options;
}

// The place on the torus that a texel's offset leads to, and how far it is from `expected`.
double missBy(const PaintTile& tile, const DabLayer& layer, std::size_t texel, double* expected)
{
  double worst = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const int size = axis == 0 ? tile.pattern.width : tile.pattern.height;
    const std::size_t width = tile.pattern.width;
    const auto cell = static_cast<double>(axis == 0 ? texel % width : texel / width);
    const double place = (cell + 0.5) / size + layer.offset[2 * texel + axis];
    if (expected[axis] < 0.0)
    {
      expected[axis] = place - std::floor(place);
    }
    const double miss = place - expected[axis];
    worst = std::max(worst, std::abs(miss - std::round(miss)));
  }
  return worst;
}

// Mean screen over the texels where each dab lies on top and is solid; -1 where none.
std::vector<double> meanScreens(const PaintTile& tile, int dabs)
{
  std::vector<double> sum(dabs, 0.0);
  std::vector<int> count(dabs, 0);
  for (std::size_t i = 0; i < tile.top.dab.size(); ++i)
  {
    if (tile.top.alpha[i] > 0.9f)
    {
      sum[tile.top.dab[i]] += tile.pattern.screen[i];
      ++count[tile.top.dab[i]];
    }
  }
  for (int i = 0; i < dabs; ++i)
  {
    sum[i] = count[i] > 0 ? sum[i] / count[i] : -1.0;
  }
  return sum;
}

} // namespace

TEST(PaintTile, EveryLevelIsUniformAndSeamless)
{
  const PaintTile tile = paintTile(someOptions());
  expectSeamless(tile.pattern);
  for (const PaintTile& level : paintMipChain(tile))
  {
    expectUniform(level.pattern);
  }
}

// On every level all texels that show a dab lead to one place: offsets are not averaged.
TEST(PaintTile, OffsetsLeadToTheDabsCentre)
{
  std::vector<double> places(2 * 36, -1.0);
  for (const PaintTile& level : paintMipChain(paintTile(someOptions())))
  {
    for (const DabLayer* layer : { &level.top, &level.below })
    {
      for (std::size_t i = 0; i < layer->dab.size(); ++i)
      {
        ASSERT_GE(layer->alpha[i], 0.0f);
        ASSERT_LE(layer->alpha[i], 1.0f);
        ASSERT_LT(missBy(level, *layer, i, &places[2 * layer->dab[i]]), 1e-5);
      }
    }
  }
}

TEST(PaintTile, DabsOfLowerTonesLieOnTop)
{
  const PaintTile tile = paintTile(someOptions());
  for (std::size_t i = 0; i < tile.top.dab.size(); ++i)
  {
    if (tile.below.alpha[i] > 0.0f)
    {
      ASSERT_LE(tile.top.dab[i], tile.below.dab[i]);
    }
  }
  double last = -1.0;
  int seen = 0;
  for (const double mean : meanScreens(tile, 36))
  {
    if (mean >= 0.0)
    {
      EXPECT_GT(mean, last - 0.02);
      last = std::max(last, mean);
      ++seen;
    }
  }
  EXPECT_GT(seen, 18);
}

TEST(PaintTile, DensityCoversTheGround)
{
  double before = 0.0;
  for (const double density : { 0.5, 1.5, 3.0, 6.0 })
  {
    PaintOptions options = someOptions();
    options.density = density;
    const PaintTile tile = paintTile(options);
    double open = 0.0;
    for (std::size_t i = 0; i < tile.top.alpha.size(); ++i)
    {
      open += (1.0 - tile.top.alpha[i]) * (1.0 - tile.below.alpha[i]);
    }
    const double covered = 1.0 - open / static_cast<double>(tile.top.alpha.size());
    EXPECT_GT(covered, before) << density;
    before = covered;
  }
  EXPECT_GT(before, 0.98);
}

// The first dab lies on top of all and shows its whole shape.
TEST(PaintTile, AspectIsLengthOverWidth)
{
  for (const double aspect : { 1.5, 4.0 })
  {
    PaintOptions options = someOptions();
    options.aspect = aspect;
    options.angleJitter = 0.0;
    options.bristles = 0.0;
    const PaintTile tile = paintTile(options);
    double length = 0.0;
    double width = 0.0;
    for (std::size_t i = 0; i < tile.top.dab.size(); ++i)
    {
      if (tile.top.dab[i] == 0 && tile.top.alpha[i] > 0.0f)
      {
        length = std::max<double>(length, std::abs(tile.top.offset[2 * i]));
        width = std::max<double>(width, std::abs(tile.top.offset[2 * i + 1]));
      }
    }
    EXPECT_NEAR(length / width, aspect, 0.3 * aspect);
  }
}

TEST(PaintTile, ThreadsDoNotMatterAndTheSeedDoes)
{
  PaintOptions options = someOptions();
  const auto [one, eight] =
    withOneAndEightThreads([&] { return paintMipChain(paintTile(options))[1]; });
  EXPECT_EQ(one.pattern.screen, eight.pattern.screen);
  EXPECT_EQ(one.top.offset, eight.top.offset);
  EXPECT_EQ(one.below.alpha, eight.below.alpha);
  EXPECT_EQ(one.height, eight.height);
  const std::vector<float> offset = paintTile(options).top.offset;
  options.seed = 2;
  EXPECT_NE(paintTile(options).top.offset, offset);
}

TEST(PaintTile, WrongArgumentsAreNamed)
{
  const auto message = [](auto change)
  {
    PaintOptions options;
    change(options);
    return messageOf([&] { paintTile(options); });
  };
  using Options = PaintOptions;
  EXPECT_NE(message([](Options& o) { o.size = 5000; }).find("size: 5000"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.periods = 0; }).find("periods: 0"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.density = 9.0; }).find("density: 9"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.aspect = 0.5; }).find("aspect: 0.5"), std::string::npos);
  EXPECT_NE(
    message([](Options& o) { o.angleJitter = NAN; }).find("angleJitter: nan"), std::string::npos);
  EXPECT_NE(
    message([](Options& o) { o.sizeVariation = 1.0; }).find("sizeVariation: 1"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.bristles = -1.0; }).find("bristles: -1"), std::string::npos);
  PaintTile tile = paintTile(someOptions());
  tile.below.alpha.pop_back();
  EXPECT_NE(
    messageOf([&] { paintMipChain(tile); }).find("tile: 14400 dabs for 14400"), std::string::npos);
}

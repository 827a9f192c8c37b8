// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Kernels.h"
#include "Core/Random.h"
#include "Core/ToneTable.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace hachure;

namespace
{

constexpr int tileSize = 256;
constexpr int tilePeriods = 8;
constexpr LodTransition transitions[] = { LodTransition::crossFade, LodTransition::blendScreens };
constexpr double someScales[] = { 1.0, 1.13, 1.357, 1.43, 1.475, 1.62, 1.7, 1.83, 1.999 };
const std::vector<double> someTones{ 0.006, 0.05, 0.1, 0.3, 0.48, 0.5, 0.7, 0.9, 0.994 };

ToneTableOptions forPeriod(double pixels, LodTransition transition = LodTransition::blendScreens,
  ToneCorrection correction = ToneCorrection::full)
{
  ToneTableOptions options;
  options.texelsPerPixelAtScale1 = tileSize / (tilePeriods * pixels);
  options.transition = transition;
  options.correction = correction;
  return options;
}

// Adds `share` of the mean ink of each tone at a scale of the table, at places that the table was
// not built from: another and finer lattice of Fibonacci numbers, shifted.
void addInk(const std::vector<PatternTile>& mips, const ToneTable& table, double scale,
  double share, std::vector<double>& inks)
{
  constexpr std::int64_t places = 75025;
  constexpr std::int64_t stride = 28657;
  std::vector<float> thresholds;
  thresholds.reserve(someTones.size());
  for (const double tone : someTones)
  {
    thresholds.push_back(static_cast<float>(toneThreshold(table, tone, scale)));
  }
  for (std::int64_t i = 0; i < places; ++i)
  {
    const double u = (0.31 + static_cast<double>(i)) / places;
    const double v = (0.17 + static_cast<double>(i * stride % places)) / places;
    const DrawnField field = drawnField(mips, table.options, u, v, scale);
    for (std::size_t k = 0; k < inks.size(); ++k)
    {
      inks[k] += share / places * glsl::inkCoverage(field.screen, thresholds[k], field.width);
    }
  }
}

std::vector<double> meanInks(
  const std::vector<PatternTile>& mips, const ToneTable& table, double scale)
{
  std::vector<double> inks(someTones.size(), 0.0);
  if (table.options.transition == LodTransition::blendScreens)
  {
    addInk(mips, table, scale, 1.0, inks);
    return inks;
  }
  const double blend = glsl::lodBlend(static_cast<float>(scale), 1.3f, 1.7f, table.contrast);
  addInk(mips, table, scale, 1.0 - blend, inks);
  addInk(mips, table, 0.5 * scale, blend, inks);
  return inks;
}

// Over all scales: largest difference of ink and tone, and largest change of the ink of a tone.
struct Deviation
{
  double error = 0.0;
  double swing = 0.0;
};

Deviation deviation(const std::vector<PatternTile>& mips, const ToneTableOptions& options)
{
  const ToneTable table = buildToneTable(mips, options);
  std::vector<double> least(someTones.size(), 1.0);
  std::vector<double> most(someTones.size(), 0.0);
  Deviation worst;
  for (const double scale : someScales)
  {
    const std::vector<double> inks = meanInks(mips, table, scale);
    for (std::size_t k = 0; k < inks.size(); ++k)
    {
      least[k] = std::min(least[k], inks[k]);
      most[k] = std::max(most[k], inks[k]);
      worst.error = std::max(worst.error, std::abs(inks[k] - someTones[k]));
      worst.swing = std::max(worst.swing, most[k] - least[k]);
    }
  }
  return worst;
}

// Few grey values, most of them dark, with large flat areas.
PatternTile userTile()
{
  std::vector<float> grey(tileSize * tileSize);
  for (std::size_t i = 0; i < grey.size(); ++i)
  {
    const auto x = static_cast<double>(i % tileSize);
    const std::size_t row = i / tileSize;
    const auto y = static_cast<double>(row);
    const double wave = 1.0 + std::sin(x * 0.1) * std::sin(y * 0.07) + unitRandom(1, i, 0);
    grey[i] = static_cast<float>(std::floor(wave * wave * 3.0));
  }
  return imageTile(grey, tileSize, tileSize, tilePeriods);
}

std::vector<PatternTile> builtInTiles()
{
  CrossHatchOptions ruled;
  CrossHatchOptions drawn;
  drawn.irregularity = 0.6;
  return { hatchTile(ruled), crossHatchTile(ruled), halftoneTile(ruled), hatchTile(drawn),
    crossHatchTile(drawn), halftoneTile(drawn) };
}

} // namespace

TEST(ToneTable, InkEqualsToneThroughATransition)
{
  for (const PatternTile& tile : builtInTiles())
  {
    const std::vector<PatternTile> mips = mipChain(tile);
    for (const LodTransition transition : transitions)
    {
      const Deviation found = deviation(mips, forPeriod(11.0, transition));
      EXPECT_LT(found.error, 0.005);
      EXPECT_LT(found.swing, 0.002);
    }
  }
}

TEST(ToneTable, InkOfAUsersImageEqualsTone)
{
  const std::vector<PatternTile> mips = mipChain(userTile());
  for (const LodTransition transition : transitions)
  {
    EXPECT_LT(deviation(mips, forPeriod(8.0, transition)).error, 0.02);
  }
}

TEST(ToneTable, TransitionOnlyKeepsTheLookAtScale1)
{
  const std::vector<PatternTile> tiles = builtInTiles();
  for (const PatternTile& tile : { tiles[0], tiles[5] })
  {
    const std::vector<PatternTile> mips = mipChain(tile);
    for (const LodTransition transition : transitions)
    {
      const ToneTableOptions off = forPeriod(8.0, transition, ToneCorrection::off);
      const ToneTableOptions only = forPeriod(8.0, transition, ToneCorrection::transitionOnly);
      EXPECT_GT(deviation(mips, off).swing, 0.005);
      EXPECT_LT(deviation(mips, only).swing, 0.002);
      const std::vector<double> look = meanInks(mips, buildToneTable(mips, off), 1.0);
      const std::vector<double> kept = meanInks(mips, buildToneTable(mips, only), 1.5);
      for (std::size_t k = 0; k < look.size(); ++k)
      {
        EXPECT_NEAR(kept[k], look[k], 0.002) << someTones[k];
      }
      EXPECT_GT(std::abs(look[0] - someTones[0]), 0.005); // not the tone
    }
  }
}

// The picture just before an octave is complete is the picture at its beginning.
TEST(ToneTable, NothingJumpsWhereTheScaleWraps)
{
  for (const PatternTile& tile : builtInTiles())
  {
    const std::vector<PatternTile> mips = mipChain(tile);
    for (const LodTransition transition : transitions)
    {
      const ToneTable table = buildToneTable(mips, forPeriod(8.0, transition));
      for (int i = 0; i < 300; ++i)
      {
        const double u = std::fmod(i * 0.7548776662466927, 1.0);
        const double v = std::fmod(i * 0.5698402909980532, 1.0);
        const double tone = 0.03 + 0.94 * std::fmod(i * 0.618, 1.0);
        const double before = drawnInk(mips, table, tone, u, v, 2.0 - 1e-6);
        const double after = drawnInk(mips, table, tone, 2.0 * u, 2.0 * v, 1.0 + 1e-6);
        EXPECT_NEAR(before, after, 1.0 / 255.0) << tone;
      }
    }
  }
}

TEST(ToneTable, NoToneNoInkFullToneFullInk)
{
  for (const PatternTile& tile : builtInTiles())
  {
    const std::vector<PatternTile> mips = mipChain(tile);
    const ToneTable table = buildToneTable(mips, forPeriod(8.0));
    for (double scale = 1.0; scale <= 2.0; scale += 0.09)
    {
      for (int i = 0; i < 50; ++i)
      {
        const DrawnField field = drawnField(mips, table.options, 0.02 * i, 0.3, scale);
        const auto none = static_cast<float>(toneThreshold(table, 0.0, scale));
        const auto all = static_cast<float>(toneThreshold(table, 1.0, scale));
        EXPECT_LT(glsl::inkCoverage(field.screen, none, field.width), 2e-5f);
        EXPECT_GT(glsl::inkCoverage(field.screen, all, field.width), 1.0f - 2e-5f);
        EXPECT_EQ(drawnInk(mips, table, 0.0, 0.02 * i, 0.3, scale), 0.0);
        EXPECT_EQ(drawnInk(mips, table, 1.0, 0.02 * i, 0.3, scale), 1.0);
      }
    }
  }
}

TEST(ToneTable, GrowsWithTone)
{
  const std::vector<PatternTile> mips = mipChain(builtInTiles()[4]);
  for (const LodTransition transition : transitions)
  {
    const ToneTable table = buildToneTable(mips, forPeriod(8.0, transition));
    ASSERT_EQ(table.threshold.size(), static_cast<std::size_t>(table.tones * table.steps));
    for (int step = 0; step < table.steps; ++step)
    {
      const auto row = table.threshold.begin() + step * table.tones;
      EXPECT_TRUE(std::is_sorted(row, row + table.tones));
    }
  }
}

TEST(ToneTable, UnresolvedPatternsAreFlat)
{
  const std::vector<PatternTile> mips = mipChain(hatchTile());
  for (const double period : { 1.0, 0.1 })
  {
    const ToneTable table = buildToneTable(mips, forPeriod(period));
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_FLOAT_EQ(drawnInk(mips, table, 0.3, 0.1, 0.05 * i, 1.9), 0.3f);
    }
  }
}

TEST(ToneTable, WithoutLodOnlyTheFirstOctave)
{
  const std::vector<PatternTile> mips = mipChain(hatchTile());
  const ToneTable table = buildToneTable(mips, forPeriod(8.0, LodTransition::none));
  // Between two lines, where the half-size copy has one.
  EXPECT_EQ(drawnInk(mips, table, 0.3, 0.0, 0.5 / tilePeriods, 1.99), 0.0);
}

// A fading stroke keeps its shape: at no scale is there ink where neither octave has some.
TEST(ToneTable, CrossFadeMixesTheInksOfBothOctaves)
{
  const std::vector<PatternTile> mips = mipChain(hatchTile());
  const ToneTable table = buildToneTable(mips, forPeriod(12.0, LodTransition::crossFade));
  const double quarter = glsl::lodScale(0.25f, 1.3f, 1.7f, table.contrast); // of the second octave
  for (int i = 0; i < 100; ++i)
  {
    const double v = i / 100.0;
    const double first = drawnInk(mips, table, 0.3, 0.0, v, 1.299999); // not faded yet
    const double middle = drawnInk(mips, table, 0.3, 0.0, v, quarter);
    const bool marked = first > 0.99;
    EXPECT_TRUE(!marked || middle > 0.7) << v;
    EXPECT_LE(middle, first + 0.35) << v;
  }
}

// An octave whose marks are a pixel wide looks grey beside one of two pixels.
TEST(ToneTable, FinerOctavesHaveLessContrast)
{
  const std::vector<PatternTile> mips = mipChain(hatchTile());
  const auto contrast = [&](double period, LodTransition transition, LodPace pace)
  {
    ToneTableOptions options = forPeriod(period, transition);
    options.pace = pace;
    return buildToneTable(mips, options).contrast;
  };
  const float coarse = contrast(40.0, LodTransition::crossFade, LodPace::even);
  const float fine = contrast(8.0, LodTransition::crossFade, LodPace::even);
  EXPECT_LT(coarse, 1.0f);
  EXPECT_GT(coarse, 0.9f);
  // Of strokes as wide as the space between them hardly more than the first harmonic is left.
  const double wave = glsl::quarterTurn * 4.0 / (8.0 * std::sqrt(1.3 * 1.7));
  EXPECT_NEAR(fine, std::exp(-0.5 * 13.0 / 12.0 * 3.0 * wave * wave), 0.04);
  EXPECT_EQ(contrast(8.0, LodTransition::blendScreens, LodPace::even), 1.0f);
  EXPECT_EQ(contrast(8.0, LodTransition::crossFade, LodPace::classic), 0.0f);

  ToneTableOptions drawnFinely = forPeriod(24.0, LodTransition::crossFade);
  drawnFinely.seenTexelsPerPixel = 3.0 * drawnFinely.texelsPerPixelAtScale1;
  EXPECT_NEAR(buildToneTable(mips, drawnFinely).contrast, fine, 1e-6f);
}

TEST(ToneTable, ThreadsDoNotMatter)
{
  const std::vector<PatternTile> mips = mipChain(halftoneTile());
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const ToneTable one = buildToneTable(mips);
  omp_set_num_threads(8);
  const ToneTable eight = buildToneTable(mips);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.threshold, eight.threshold);
}

TEST(ToneTable, WrongArgumentsAreNamed)
{
  const auto message = [](double footprint, double start, double end)
  {
    try
    {
      ToneTableOptions options;
      options.texelsPerPixelAtScale1 = footprint;
      options.lodStart = start;
      options.lodEnd = end;
      buildToneTable(mipChain(imageTile(std::vector<float>{ 0.0f, 1.0f }, 2, 1)), options);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message(1.0, 1.3, 1.7), "no error");
  EXPECT_NE(message(0.0, 1.3, 1.7).find("texelsPerPixelAtScale1: 0"), std::string::npos);
  EXPECT_NE(message(NAN, 1.3, 1.7).find("texelsPerPixelAtScale1: nan"), std::string::npos);
  EXPECT_NE(message(1.0, 0.5, 1.7).find("lodStart: 0.5"), std::string::npos);
  EXPECT_NE(message(1.0, 1.5, 1.4).find("lodEnd: 1.4"), std::string::npos);
  EXPECT_THROW(buildToneTable({}), std::invalid_argument);
}

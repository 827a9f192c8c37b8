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

ToneTableOptions forPeriod(double pixels)
{
  ToneTableOptions options;
  options.texelsPerPixelAtScale1 = tileSize / (tilePeriods * pixels);
  return options;
}

// Fields at places that the table was not built from, spread evenly over the tile.
std::vector<DrawnField> someFields(
  const std::vector<PatternTile>& mips, const ToneTableOptions& options, double scale)
{
  constexpr int places = 10946; // a Fibonacci number
  std::vector<DrawnField> fields;
  for (int i = 0; i < places; ++i)
  {
    // A golden-ratio lattice, which the table does not use.
    const double u = (i + 0.5) / places;
    const double v = std::fmod(0.25 + i * 0.6180339887498949, 1.0);
    fields.push_back(drawnField(mips, options, u, v, scale));
  }
  return fields;
}

double meanInk(const std::vector<DrawnField>& fields, double threshold)
{
  double sum = 0.0;
  for (const DrawnField& field : fields)
  {
    sum += glsl::inkCoverage(field.screen, static_cast<float>(threshold), field.width);
  }
  return sum / static_cast<double>(fields.size());
}

double scaleOfRow(double row)
{
  return glsl::tableScale(static_cast<float>(row), 1.3f, 1.7f);
}

// Largest difference of ink and tone over rows first, first + 1, ...
double worstError(const PatternTile& tile, double period, double first)
{
  const std::vector<PatternTile> mips = mipChain(tile);
  const ToneTableOptions options = forPeriod(period);
  const ToneTable table = buildToneTable(mips, options);
  double worst = 0.0;
  for (double row = first; row <= glsl::tableSteps - 1.0; row += 1.0)
  {
    const double scale = scaleOfRow(row);
    const std::vector<DrawnField> fields = someFields(mips, options, scale);
    for (const double tone : { 0.006, 0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.994 })
    {
      worst = std::max(worst, std::abs(meanInk(fields, toneThreshold(table, tone, scale)) - tone));
    }
    EXPECT_EQ(meanInk(fields, -10.0), 0.0);
  }
  return worst;
}

PatternTile noiseTile()
{
  std::vector<float> grey(tileSize * tileSize);
  for (std::size_t i = 0; i < grey.size(); ++i)
  {
    grey[i] = static_cast<float>(unitRandom(1, i, 0));
  }
  return imageTile(grey, tileSize, tileSize, tilePeriods);
}

std::vector<PatternTile> tiles()
{
  CrossHatchOptions ruled;
  CrossHatchOptions drawn;
  drawn.irregularity = 0.6;
  return { hatchTile(ruled), crossHatchTile(ruled), halftoneTile(ruled), hatchTile(drawn),
    crossHatchTile(drawn), noiseTile() };
}

} // namespace

TEST(ToneTable, InkEqualsToneAtEveryStep)
{
  for (const PatternTile& tile : tiles())
  {
    for (const double period : { 6.0, 8.0, 12.0 })
    {
      EXPECT_LT(worstError(tile, period, 0.0), 0.003) << period;
    }
  }
}

TEST(ToneTable, InkEqualsToneBetweenSteps)
{
  for (const PatternTile& tile : tiles())
  {
    for (const double period : { 6.0, 12.0 })
    {
      EXPECT_LT(worstError(tile, period, 0.4), 0.006) << period;
    }
  }
}

// What the table is for: the tone as its own threshold misses by far more.
TEST(ToneTable, WithoutItToneIsWrong)
{
  const std::vector<PatternTile> mips = mipChain(hatchTile());
  const std::vector<DrawnField> fields = someFields(mips, forPeriod(8.0), 1.5);
  EXPECT_GT(std::abs(meanInk(fields, 0.1) - 0.1), 0.03);
}

TEST(ToneTable, NoToneNoInkFullToneFullInk)
{
  for (const PatternTile& tile : tiles())
  {
    const std::vector<PatternTile> mips = mipChain(tile);
    const ToneTable table = buildToneTable(mips, forPeriod(8.0));
    for (double scale = 1.0; scale <= 2.0; scale += 0.05)
    {
      const std::vector<DrawnField> fields = someFields(mips, table.options, scale);
      EXPECT_LT(meanInk(fields, toneThreshold(table, 0.0, scale)), 2e-5);
      EXPECT_GT(meanInk(fields, toneThreshold(table, 1.0, scale)), 1.0 - 2e-5);
      for (int i = 0; i < 50; ++i)
      {
        EXPECT_EQ(drawnInk(mips, table, 0.0, 0.02 * i, 0.3, scale), 0.0);
        EXPECT_EQ(drawnInk(mips, table, 1.0, 0.02 * i, 0.3, scale), 1.0);
      }
    }
  }
}

TEST(ToneTable, GrowsWithTone)
{
  for (const PatternTile& tile : tiles())
  {
    const ToneTable table = buildToneTable(mipChain(tile), forPeriod(8.0));
    ASSERT_EQ(table.threshold.size(), static_cast<std::size_t>(table.tones * table.steps));
    for (int step = 0; step < table.steps; ++step)
    {
      const auto row = table.threshold.begin() + step * table.tones;
      EXPECT_TRUE(std::is_sorted(row, row + table.tones));
    }
  }
}

// The picture at scale 2 is the picture at scale 1: no jump when the scale wraps.
TEST(ToneTable, OctavesMeet)
{
  CrossHatchOptions drawn;
  drawn.irregularity = 0.5;
  const std::vector<PatternTile> mips = mipChain(crossHatchTile(drawn));
  const ToneTable table = buildToneTable(mips, forPeriod(8.0));
  for (int i = 0; i < 256; ++i)
  {
    EXPECT_NEAR(table.threshold[i], table.threshold[(table.steps - 1) * table.tones + i], 0.01f);
  }
  for (int i = 0; i < 500; ++i)
  {
    const double u = std::fmod(i * 0.7548776662466927, 1.0);
    const double v = std::fmod(i * 0.5698402909980532, 1.0);
    const DrawnField before = drawnField(mips, table.options, u, v, 2.0);
    const DrawnField after = drawnField(mips, table.options, 2.0 * u, 2.0 * v, 1.0);
    EXPECT_NEAR(before.screen, after.screen, 1e-5f);
    EXPECT_NEAR(before.width, after.width, 1e-5f);
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
  ToneTableOptions options = forPeriod(8.0);
  options.transition = LodTransition::none;
  const ToneTable table = buildToneTable(mips, options);
  const DrawnField field = drawnField(mips, options, 0.0, 0.5 / tilePeriods, 2.0);
  EXPECT_GT(field.screen, 0.9f); // between two lines, where the half-size copy has one
  const std::vector<DrawnField> fields = someFields(mips, options, 2.0);
  EXPECT_NEAR(meanInk(fields, toneThreshold(table, 0.3, 2.0)), 0.3, 0.003);
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

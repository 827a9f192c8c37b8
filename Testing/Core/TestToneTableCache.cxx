// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/ToneTableCache.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace hachure;

namespace
{

ToneTableCache::Mips smallTile()
{
  HatchOptions options;
  options.size = 32;
  options.periods = 1;
  return std::make_shared<const std::vector<PatternTile>>(mipChain(hatchTile(options)));
}

} // namespace

TEST(ToneTableCache, EqualTablesAreMeasuredOnce)
{
  ToneTableCache cache;
  const ToneTableCache::Mips mips = smallTile();
  const ToneTableCache::Table first = cache.get(mips, {});
  EXPECT_EQ(cache.get(mips, {}), first);
  EXPECT_EQ(cache.builds(), 1u);
}

TEST(ToneTableCache, EverythingThatATableDependsOnMakesANewOne)
{
  ToneTableCache cache;
  const ToneTableCache::Mips mips = smallTile();
  std::vector<ToneTableOptions> changed(9);
  changed[1].texelsPerPixelAtScale1 = 2.0;
  changed[2].lodStart = 1.2;
  changed[3].lodEnd = 1.8;
  changed[4].transition = LodTransition::crossFade;
  changed[5].correction = ToneCorrection::transitionOnly;
  changed[6] = changed[5];
  changed[6].referenceTexelsPerPixel = 1.0;
  changed[7].pace = LodPace::classic;
  changed[8].seenTexelsPerPixel = 1.0;
  std::vector<ToneTableCache::Table> held;
  for (const ToneTableOptions& options : changed)
  {
    held.push_back(cache.get(mips, options));
    EXPECT_EQ(cache.builds(), held.size());
    EXPECT_EQ(held.back()->threshold, buildToneTable(*mips, options).threshold);
  }
  held.push_back(cache.get(smallTile(), {}));
  EXPECT_EQ(cache.builds(), held.size());
  EXPECT_EQ(cache.get(mips, {}), held.front()); // still there
}

TEST(ToneTableCache, NobodysTableIsForgotten)
{
  ToneTableCache cache;
  const ToneTableCache::Mips mips = smallTile();
  cache.get(mips, {});
  cache.get(mips, {});
  EXPECT_EQ(cache.builds(), 2u);
  EXPECT_THROW(cache.get(nullptr, {}), std::invalid_argument);
}

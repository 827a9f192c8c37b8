// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PatchRuns.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace
{

using namespace hachure;

TEST(PatchRuns, CoverAllSamplesInOrder)
{
  const std::vector<std::int32_t> patches = { 2, 2, 0, 1, 1, 1, 2, 0 };
  const PatchRuns found = findPatchRuns(patches, patches.size(), 4);
  EXPECT_EQ(found.patchTotal, 4u);
  EXPECT_EQ(found.sampleTotal(), patches.size());
  std::size_t begin = 0;
  for (const PatchRun& run : found.runs)
  {
    EXPECT_EQ(run.begin, begin);
    EXPECT_GT(run.end, run.begin);
    for (std::size_t i = run.begin; i < run.end; ++i)
    {
      EXPECT_EQ(static_cast<std::size_t>(patches[i]), run.patch) << i;
    }
    begin = run.end;
  }
  EXPECT_EQ(begin, patches.size());
  EXPECT_EQ(found.runs.size(), 5u);
}

TEST(PatchRuns, OtherPatchesAreTold)
{
  const std::vector<std::int32_t> patches = { 0, 0, 1, 1 };
  const PatchRuns runs = findPatchRuns(patches, 4, 2);
  EXPECT_TRUE(areRunsOf(runs, patches, 4));
  EXPECT_FALSE(areRunsOf(runs, {}, 4));
  for (const std::vector<std::int32_t>& other :
    { std::vector<std::int32_t>{ 0, 1, 1, 1 }, { 0, 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 1, 1, 1 } })
  {
    EXPECT_FALSE(areRunsOf(runs, other, other.size()));
    EXPECT_FALSE(areRunsOf(runs, other, 4));
  }
}

TEST(PatchRuns, NoPatchesAreOnePatch)
{
  const PatchRuns runs = findPatchRuns({}, 3, 1);
  EXPECT_TRUE(areRunsOf(runs, {}, 3));
  EXPECT_TRUE(areRunsOf(runs, std::vector<std::int32_t>{ 0, 0, 0 }, 3));
  EXPECT_FALSE(areRunsOf(runs, {}, 4));
  EXPECT_TRUE(findPatchRuns({}, 0, 0).runs.empty());
  EXPECT_TRUE(areRunsOf(PatchRuns(), {}, 0));
}

TEST(PatchRuns, WrongSizesAreErrors)
{
  EXPECT_THROW(findPatchRuns(std::vector<std::int32_t>{ 0, 0 }, 3, 1), std::invalid_argument);
  EXPECT_THROW(findPatchRuns({}, 3, 0), std::invalid_argument);
}

} // namespace

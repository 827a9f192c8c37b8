// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel.h"
#include "Span.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

TEST(Parallel, EveryIndexOnce)
{
  for (const std::int64_t count : { 0, 1, 255, 257, 100003 })
  {
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
    hachure::parallelFor(count, [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
    for (const std::atomic<int>& visit : visits)
    {
      ASSERT_EQ(visit, 1) << "count " << count;
    }
  }
}

TEST(Parallel, RangesCoverWithoutOverlap)
{
  std::vector<std::pair<std::int64_t, std::int64_t>> ranges(4);
  hachure::parallelForRanges(10, 3,
    [&](std::int64_t begin, std::int64_t end) {
      ranges[static_cast<std::size_t>(begin / 3)] = { begin, end };
    });
  const std::vector<std::pair<std::int64_t, std::int64_t>> expected{ { 0, 3 }, { 3, 6 }, { 6, 9 },
    { 9, 10 } };
  EXPECT_EQ(ranges, expected);
}

TEST(Parallel, LowestFailureReachesCaller)
{
  const auto body = [](std::int64_t begin, std::int64_t)
  {
    if (begin >= 70)
    {
      throw std::runtime_error(std::to_string(begin));
    }
  };
  try
  {
    hachure::parallelForRanges(1000, 10, body);
    FAIL() << "no exception";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), "70");
  }
}

TEST(Parallel, InnerLoopStaysOnItsThread)
{
  if (hachure::maximumThreads() < 2)
  {
    GTEST_SKIP() << "one thread only";
  }
  std::atomic<int> nested{ 0 };
  hachure::parallelForRanges(
    64, 1, [&](std::int64_t, std::int64_t) { nested += hachure::maximumThreads() == 1 ? 1 : 0; });
  EXPECT_EQ(nested, 64);
}

TEST(Span, ViewsWithoutCopy)
{
  std::vector<int> values{ 1, 2, 3, 4 };
  const hachure::Span<int> writable = values;
  writable[1] = 7;
  const hachure::Span<const int> readable = writable;
  EXPECT_EQ(values[1], 7);
  EXPECT_EQ(readable.data(), values.data());
  EXPECT_EQ(readable.subspan(1, 2).size(), 2u);
  EXPECT_EQ(readable.subspan(1, 2)[1], 3);
  EXPECT_TRUE(hachure::Span<const int>().empty());
}

} // namespace

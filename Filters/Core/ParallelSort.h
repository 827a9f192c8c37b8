// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ParallelSort_h
#define hachure_ParallelSort_h

#include "Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// Sorts in ascending order: parts first, then pairs of neighbouring parts are merged. Equal for any
// number of threads where no two elements are equal.
template <class T>
void parallelSort(std::vector<T>& values)
{
  constexpr std::size_t smallestPart = 1 << 14; // below, threads cost more than they save
  const std::size_t part = std::max(smallestPart, (values.size() + 7) / 8);
  const auto at = [&values](std::size_t index)
  { return values.begin() + static_cast<std::ptrdiff_t>(std::min(index, values.size())); };
  parallelForRanges(static_cast<std::int64_t>(values.size()), static_cast<std::int64_t>(part),
    [&at](std::int64_t begin, std::int64_t end)
    { std::sort(at(static_cast<std::size_t>(begin)), at(static_cast<std::size_t>(end))); });
  for (std::size_t sorted = part; sorted < values.size(); sorted *= 2)
  {
    parallelForRanges(static_cast<std::int64_t>(values.size()),
      static_cast<std::int64_t>(2 * sorted),
      [&at, sorted](std::int64_t begin, std::int64_t end)
      {
        const auto first = static_cast<std::size_t>(begin);
        std::inplace_merge(at(first), at(first + sorted), at(static_cast<std::size_t>(end)));
      });
  }
}

} // namespace hachure

#endif

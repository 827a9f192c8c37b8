// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_Parallel_h
#define hachure_Parallel_h

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>

// The only header with OpenMP in it. Work is divided statically and bodies write to slots of their
// own, so that the result does not depend on the number of threads. Regions never nest: a loop
// inside a running loop is done by the thread that meets it.
namespace hachure
{

// Threads that the next loop may use: 1 inside a running loop.
int maximumThreads();

namespace detail
{

// Keeps the exception of the lowest index, so that the same error is reported for any number of
// threads.
class FirstException
{
public:
  void capture(std::int64_t index);
  void rethrow() const;

private:
  std::exception_ptr exception;
  std::int64_t index = 0;
};

} // namespace detail

// Calls body(begin, end) for consecutive ranges of `grain` indices (the last may be shorter) that
// cover [0, count). The ranges are the same for any number of threads. An exception thrown by a
// body reaches the caller, after all other ranges have run.
template <class Body>
void parallelForRanges(std::int64_t count, std::int64_t grain, Body&& body)
{
  const std::int64_t step = std::max<std::int64_t>(grain, 1);
  const std::int64_t ranges = count > 0 ? (count - 1) / step + 1 : 0;
  const int threads =
    static_cast<int>(std::min<std::int64_t>(maximumThreads(), std::max<std::int64_t>(ranges, 1)));
  detail::FirstException failure;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::int64_t range = 0; range < ranges; ++range)
  {
    try
    {
      body(range * step, std::min(count, (range + 1) * step));
    }
    catch (...)
    {
      failure.capture(range);
    }
  }
  failure.rethrow();
}

// Calls body(i) for every i in [0, count).
template <class Body>
void parallelFor(std::int64_t count, Body&& body)
{
  // Long enough to hide the cost of a range, short enough to share small loops.
  constexpr std::int64_t grain = 256;
  const std::int64_t shared = std::max<std::int64_t>(1, count / (4 * maximumThreads()));
  parallelForRanges(count, std::min(grain, shared),
    [&body](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        body(i);
      }
    });
}

} // namespace hachure

#endif

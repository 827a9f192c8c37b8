// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel.h"

#include <mutex>
#include <omp.h>

namespace hachure
{

int maximumThreads()
{
  return omp_in_parallel() ? 1 : omp_get_max_threads();
}

namespace detail
{

void FirstException::capture(std::int64_t failedIndex)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if (!this->exception || failedIndex < this->index)
  {
    this->exception = std::current_exception();
    this->index = failedIndex;
  }
}

void FirstException::rethrow() const
{
  if (this->exception)
  {
    std::rethrow_exception(this->exception);
  }
}

} // namespace detail

} // namespace hachure

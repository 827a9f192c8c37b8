// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchRuns.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Without a way out of the loop, so that many are compared at once.
bool allEqual(Span<const std::int32_t> patches, std::int32_t patch)
{
  std::int32_t different = 0;
  for (const std::int32_t each : patches)
  {
    different |= each ^ patch;
  }
  return different == 0;
}

} // namespace

PatchRuns findPatchRuns(
  Span<const std::int32_t> patches, std::size_t sampleTotal, std::size_t patchTotal)
{
  if (!patches.empty() && patches.size() != sampleTotal)
  {
    throw std::invalid_argument("findPatchRuns: patches has " + std::to_string(patches.size()) +
      " elements, expected " + std::to_string(sampleTotal) + ", one per sample, or none");
  }
  PatchRuns result;
  result.patchTotal = patchTotal;
  for (std::size_t begin = 0; begin < sampleTotal;)
  {
    const std::int32_t patch = patches.empty() ? 0 : patches[begin];
    if (patch < 0 || static_cast<std::size_t>(patch) >= patchTotal)
    {
      throw std::invalid_argument("findPatchRuns: patches[" + std::to_string(begin) + "] is " +
        std::to_string(patch) + ", expected 0 to " + std::to_string(patchTotal) + " - 1");
    }
    std::size_t end = patches.empty() ? sampleTotal : begin + 1;
    while (end < sampleTotal && patches[end] == patch)
    {
      ++end;
    }
    result.runs.push_back({ static_cast<std::size_t>(patch), begin, end });
    begin = end;
  }
  return result;
}

bool areRunsOf(const PatchRuns& runs, Span<const std::int32_t> patches, std::size_t sampleTotal)
{
  if (runs.sampleTotal() != sampleTotal || (!patches.empty() && patches.size() != sampleTotal))
  {
    return false;
  }
  return std::all_of(runs.runs.begin(), runs.runs.end(),
    [&](const PatchRun& run)
    {
      return patches.empty() ? run.patch == 0
                             : allEqual(patches.subspan(run.begin, run.end - run.begin),
                                 static_cast<std::int32_t>(run.patch));
    });
}

} // namespace hachure

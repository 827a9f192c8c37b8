// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatchRuns_h
#define hachure_PatchRuns_h

#include "Span.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// Which samples belong to which patch: ranges of successive samples of one patch. Samples come
// patch by patch, so that there are few of them, and sums stay in registers over a range.
namespace hachure
{

struct PatchRun
{
  std::size_t patch;
  std::size_t begin;
  std::size_t end;
};

struct PatchRuns
{
  std::vector<PatchRun> runs; // in the order of the samples
  std::size_t patchTotal = 0;

  std::size_t sampleTotal() const { return this->runs.empty() ? 0 : this->runs.back().end; }
};

// The patches of the samples; all of them 0 where there are no `patches`. Throws
// std::invalid_argument on patches outside [0, patchTotal) and on other sizes.
PatchRuns findPatchRuns(
  Span<const std::int32_t> patches, std::size_t sampleTotal, std::size_t patchTotal);

// Whether these are the runs of the patches, without looking for them anew.
bool areRunsOf(const PatchRuns& runs, Span<const std::int32_t> patches, std::size_t sampleTotal);

} // namespace hachure

#endif

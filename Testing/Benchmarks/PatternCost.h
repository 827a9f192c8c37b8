// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Pattern and plain drawing by turns.

#ifndef PatternCost_h
#define PatternCost_h

#include "BenchmarkOptions.h"

#include <vtkPolyData.h>

#include <cstdint>
#include <optional>

namespace hachure::benchmark
{
/// Medians over the runs.
struct PatternCost
{
  double plainCpu = 0.0;   ///< milliseconds per frame
  double patternCpu = 0.0; ///< milliseconds per frame
  double cpuRatio = 0.0;
  double wallRatio = 0.0;
  std::optional<double> gpu; ///< milliseconds per pattern frame; nothing without such a processor
  std::int64_t memory = 0;   ///< bytes
  double coverage = 0.0;     ///< part of the picture that the surface covers
};

/// Throws UserError when there is no such style.
void checkStyle(const std::string& style);

/// Throws UserError when there is no display or the style cannot be drawn.
PatternCost measure(
  vtkPolyData* surface, const LayerConfiguration& configuration, const BenchmarkOptions& options);
} // namespace hachure::benchmark

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef hachure_benchmark_BenchmarkViews_h
#define hachure_benchmark_BenchmarkViews_h

class vtkPatternStyle;
class vtkPolyData;

namespace hachure::benchmark
{
/// Gives layers of view-dependent texture that have no views some of the surface: six independent
/// ones along its axes, and a dependent one from each of the four sides.
void addViews(vtkPatternStyle* style, vtkPolyData* surface);
} // namespace hachure::benchmark

#endif

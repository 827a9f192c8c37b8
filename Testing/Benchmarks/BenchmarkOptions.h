// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The command line of hachure-benchmark.

#ifndef BenchmarkOptions_h
#define BenchmarkOptions_h

#include <array>
#include <string>
#include <vector>

namespace hachure::benchmark
{
/// A type of layer and the style that is its stated default configuration.
struct LayerConfiguration
{
  std::string layer;
  std::string style; ///< name of a preset, or a .json file
};

struct BenchmarkOptions
{
  bool help = false;
  std::vector<LayerConfiguration> layers; ///< one row each, per number of triangles
  std::vector<int> triangles = { 500000 };
  std::array<int, 2> size = { 1280, 720 };
  int patches = 1;  ///< of the surface, blended near their borders where there are several
  int frames = 10;  ///< measured frames of each kind in each run
  std::string json; ///< file to write besides stdout; empty for none
};

/// Throws hachure::program::UserError with one line for the user.
BenchmarkOptions parseOptions(int argumentCount, char* const* arguments);

const char* helpText();
} // namespace hachure::benchmark

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TileTests_h
#define TileTests_h

// What holds for every tile.

#include "CallTests.h"
#include "Core/PatternTile.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace hachure
{

// The values of a uniform screen, sorted, are the centres of equal steps; texels that share a value
// share the centre of their steps.
inline void expectUniform(const PatternTile& tile)
{
  std::vector<float> sorted = tile.screen;
  std::sort(sorted.begin(), sorted.end());
  const auto count = static_cast<double>(sorted.size());
  double worst = 0.0;
  for (std::size_t begin = 0; begin < sorted.size();)
  {
    std::size_t end = begin;
    while (end < sorted.size() && sorted[end] == sorted[begin])
    {
      ++end;
    }
    const double centre = 0.5 * static_cast<double>(begin + end) / count;
    worst = std::max(worst, std::abs(sorted[begin] - centre));
    begin = end;
  }
  EXPECT_LT(worst, 0.5 / count);
  EXPECT_GT(*std::min_element(tile.gradient.begin(), tile.gradient.end()), 0.0f);
}

// Mean change of the screen from one row (column) of texels to the next.
inline double rowChange(const PatternTile& tile, int row)
{
  double sum = 0.0;
  for (int x = 0; x < tile.width; ++x)
  {
    const int next = (row + 1) % tile.height;
    sum += std::abs(tile.screen[row * tile.width + x] - tile.screen[next * tile.width + x]);
  }
  return sum / tile.width;
}

inline double columnChange(const PatternTile& tile, int column)
{
  double sum = 0.0;
  for (int y = 0; y < tile.height; ++y)
  {
    const int next = (column + 1) % tile.width;
    sum += std::abs(tile.screen[y * tile.width + column] - tile.screen[y * tile.width + next]);
  }
  return sum / tile.height;
}

inline void expectSeamless(const PatternTile& tile)
{
  double highestRow = 0.0;
  double highestColumn = 0.0;
  for (int i = 0; i + 1 < tile.width; ++i)
  {
    highestRow = std::max(highestRow, rowChange(tile, i));
    highestColumn = std::max(highestColumn, columnChange(tile, i));
  }
  EXPECT_LE(rowChange(tile, tile.height - 1), 1.15 * highestRow);
  EXPECT_LE(columnChange(tile, tile.width - 1), 1.15 * highestColumn);
}

// What `make` returns must not depend on the number of threads.
template <class Make>
auto withOneAndEightThreads(Make&& make)
{
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  auto one = make();
  omp_set_num_threads(8);
  auto eight = make();
  omp_set_num_threads(threads);
  return std::make_pair(std::move(one), std::move(eight));
}

} // namespace hachure

#endif

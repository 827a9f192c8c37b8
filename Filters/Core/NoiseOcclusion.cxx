// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseOcclusion.h"

#include "Kernels.h"
#include "NoiseFieldTiles.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace hachure
{

namespace
{

struct Cells
{
  std::size_t columns, rows;
  std::vector<float> values;
};

// The farthest depth that is seen in every cell of the rectangle.
Cells farthestInCells(const NoiseSurroundings& surroundings, std::size_t cellSize)
{
  const auto width = static_cast<std::size_t>(surroundings.rectangle[2]);
  const auto height = static_cast<std::size_t>(surroundings.rectangle[3]);
  Cells cells{ (width + cellSize - 1) / cellSize, (height + cellSize - 1) / cellSize, {} };
  cells.values.assign(cells.columns * cells.rows, 0.0f);
  parallelForRanges(static_cast<std::int64_t>(cells.rows), 4,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<float> line(cells.columns * cellSize);
      for (auto row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row)
      {
        std::fill(line.begin(), line.end(), 0.0f);
        for (std::size_t y = row * cellSize; y < std::min((row + 1) * cellSize, height); ++y)
        {
          const float* depth = surroundings.depth.data() + y * width;
          for (std::size_t x = 0; x < width; ++x)
          {
            const float seen = depth[x] < 1.0f ? depth[x] : 0.0f;
            line[x] = line[x] < seen ? seen : line[x];
          }
        }
        for (std::size_t column = 0; column < cells.columns; ++column)
        {
          const float* first = line.data() + column * cellSize;
          cells.values[row * cells.columns + column] = *std::max_element(first, first + cellSize);
        }
      }
    });
  return cells;
}

// The highest value within so many cells to both sides, along one direction.
std::vector<float> spread(const std::vector<float>& values, std::size_t lines,
  std::size_t lineStride, std::size_t count, std::size_t stride, std::size_t reach)
{
  std::vector<float> result(values.size(), 0.0f);
  for (std::size_t line = 0; line < lines; ++line)
  {
    const std::size_t start = line * lineStride;
    for (std::size_t i = 0; i < count; ++i)
    {
      float highest = 0.0f;
      const std::size_t last = std::min(i + reach, count - 1);
      for (std::size_t k = i > reach ? i - reach : 0; k <= last; ++k)
      {
        highest = std::max(highest, values[start + k * stride]);
      }
      result[start + i * stride] = highest;
    }
  }
  return result;
}

} // namespace

NoiseOcclusion::NoiseOcclusion(const NoiseSurroundings& surroundings, float radius)
{
  noise::checkNoiseInput(surroundings, {});
  if (surroundings.depth.empty() || !(surroundings.depthTest || surroundings.partialVisibility))
  {
    return;
  }
  const float reach = radius + 0.5f * glsl::noiseSampleStep(radius) + 1.0f;
  this->left = static_cast<float>(surroundings.rectangle[0]);
  this->bottom = static_cast<float>(surroundings.rectangle[1]);
  this->width = static_cast<float>(surroundings.rectangle[2]) / cellSize;
  this->height = static_cast<float>(surroundings.rectangle[3]) / cellSize;
  // Of a plane and its tolerance, which both grow with the distance from the centre.
  this->steepening = 1.001f * reach * (1.0f + 2.0f * glsl::noiseSlopeTolerance * reach / radius);
  this->tolerance = 2.001f * surroundings.depthTolerance + 1e-6f;
  Cells cells = farthestInCells(surroundings, static_cast<std::size_t>(cellSize));
  this->columns = cells.columns;
  const auto far = static_cast<std::size_t>(std::ceil(reach / cellSize));
  cells.values = spread(cells.values, cells.rows, cells.columns, cells.columns, 1, far);
  this->farthest = spread(cells.values, cells.columns, 1, cells.rows, cells.columns, far);
}

} // namespace hachure

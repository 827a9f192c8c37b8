// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of a rectangle's tiles: every pixel finds every kernel over it, and few others.

#include "Kernels.h"
#include "NoiseTileLists.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace hachure;

namespace
{

constexpr std::array<int, 4> rectangle = { 37, -5, 101, 70 };

// Kernels in the rectangle and around it.
std::vector<NoiseKernel> someKernels(float radius, int count = 200)
{
  std::vector<NoiseKernel> kernels;
  kernels.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const auto random = [i](std::uint32_t dimension) { return unitRandom(3, i, dimension); };
    NoiseKernel kernel;
    kernel.center = { rectangle[0] + rectangle[2] * (1.6 * random(0) - 0.3),
      rectangle[1] + rectangle[3] * (1.6 * random(1) - 0.3) };
    kernel.bandwidth = glsl::kernelBandwidth(radius * static_cast<float>(0.5 + random(2)));
    kernels.push_back(kernel);
  }
  return kernels;
}

// Kernels of the tile of a pixel of the rectangle.
std::vector<std::uint32_t> listAt(const NoiseTileLists& lists, int column, int row)
{
  const int tile = row / lists.tileSize * lists.columns + column / lists.tileSize;
  const auto* begin = lists.kernels.data();
  return { begin + lists.starts[static_cast<std::size_t>(tile)],
    begin + lists.starts[static_cast<std::size_t>(tile) + 1] };
}

TEST(NoiseTileLists, holdEveryKernelOverAPixel)
{
  for (const float radius : { 3.0f, 11.0f, 40.0f, 300.0f })
  {
    const std::vector<NoiseKernel> kernels = someKernels(radius);
    const NoiseTileLists lists = noiseTileLists(kernels, rectangle);
    for (int row = 0; row < rectangle[3]; ++row)
    {
      for (int column = 0; column < rectangle[2]; ++column)
      {
        const std::vector<std::uint32_t> found = listAt(lists, column, row);
        ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
        const glm::vec2 pixel(
          rectangle[0] + column + 0.5f, rectangle[1] + static_cast<float>(row) + 0.5f);
        for (std::uint32_t i = 0; i < kernels.size(); ++i)
        {
          const bool over =
            glm::length(pixel - kernels[i].center) <= glsl::kernelRadius(kernels[i].bandwidth);
          ASSERT_TRUE(!over || std::binary_search(found.begin(), found.end(), i));
        }
      }
    }
  }
}

TEST(NoiseTileLists, haveTilesAboutAsLargeAsKernels)
{
  const float radii[] = { 3.0f, 15.0f, 25.0f, 300.0f };
  const int sizes[] = { 16, 16, 32, 64 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(noiseTileLists(someKernels(radii[i]), rectangle).tileSize, sizes[i]);
  }
}

TEST(NoiseTileLists, areNotMuchLongerThanNeeded)
{
  const std::vector<NoiseKernel> kernels = someKernels(8.0f);
  const NoiseTileLists lists = noiseTileLists(kernels, rectangle);
  double needed = 0.0;
  for (const NoiseKernel& kernel : kernels)
  {
    // A disc meets at most the tiles within its radius and a tile's diagonal.
    const double reach = static_cast<double>(glsl::kernelRadius(kernel.bandwidth)) + 23.0;
    needed += 3.1416 * reach * reach / 256.0;
  }
  EXPECT_LT(static_cast<double>(lists.kernels.size()), needed);
}

TEST(NoiseTileLists, leaveOutWhatCannotBeDrawn)
{
  std::vector<NoiseKernel> kernels(4);
  for (NoiseKernel& kernel : kernels)
  {
    kernel.center = { 60.0f, 20.0f };
  }
  kernels[0].bandwidth = 0.0f;
  kernels[1].weight = 0.0f;
  kernels[2].depth = std::numeric_limits<float>::quiet_NaN();
  const NoiseTileLists lists = noiseTileLists(kernels, rectangle);
  ASSERT_FALSE(lists.kernels.empty());
  for (const std::uint32_t kernel : lists.kernels)
  {
    EXPECT_EQ(kernel, 3u);
  }
}

TEST(NoiseTileLists, takeEmptyInput)
{
  EXPECT_TRUE(noiseTileLists({}, rectangle).kernels.empty());
  const std::vector<NoiseKernel> kernels = someKernels(8.0f);
  EXPECT_TRUE(noiseTileLists(kernels, { 3, 4, 0, 10 }).kernels.empty());
  EXPECT_THROW(noiseTileLists(kernels, { 0, 0, 5, -1 }), std::invalid_argument);
}

} // namespace

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Kernels that the depth hides for certain need not be made: the noise is the same without them.

#include "CallTests.h"
#include "NoiseOcclusion.h"
#include "NoiseScene.h"
#include "NoiseScenes.h"

#include <gtest/gtest.h>

using namespace hachure;
using namespace hachure::testing;

namespace
{

// A wavy sheet and, over its left part, a level one before it; between them and to the right
// nothing.
struct Sheets
{
  static constexpr int width = 240, height = 180;
  Surface surface;
  NoiseView view = parallelView({ width, height });
  std::vector<float> depth;

  static double heightOf(double x, double y)
  {
    return -60.0 + 2.0 * x + 10.0 * std::sin(0.07 * x) * std::cos(0.05 * y);
  }
  float depthOf(double x, double y, double z) const
  {
    const glm::dvec4 clip = this->view.modelToClip * glm::dvec4(x, y, z, 1.0);
    return static_cast<float>(0.5 * clip.z / clip.w + 0.5);
  }

  Sheets()
  {
    addGrid(this->surface, { -120, -90, 0 }, { 200, 0, 0 }, { 0, 180, 0 }, 60);
    for (glm::dvec3& point : this->surface.points)
    {
      point.z = heightOf(point.x, point.y);
    }
    addGrid(this->surface, { -120, -90, 40 }, { 110, 0, 0 }, { 0, 180, 0 }, 12);
    this->depth = imageOf<float>({ -width / 2, -height / 2, width, height },
      [&](double x, double y)
      {
        const float behind = x < 80.0 ? this->depthOf(x, y, heightOf(x, y)) : 1.0f;
        return x < -10.0 ? std::min(behind, this->depthOf(x, y, 40.0)) : behind;
      });
  }
  NoiseSurroundings surroundings() const
  {
    NoiseSurroundings result;
    result.rectangle = { 0, 0, width, height };
    result.depth = this->depth;
    result.depthTolerance = 2e-4f;
    return result;
  }
};

struct Counts
{
  std::size_t all, left;
};

Counts expectSameNoise(
  const Sheets& sheets, const NoiseSurroundings& surroundings, const NoiseKernelOptions& options)
{
  NoiseSurface noise(sheets.surface.mesh());
  const std::vector<NoiseKernel> all = noise.kernels(sheets.view, options);
  const double largest = options.control ? 1.0 / options.bandwidthRange.x : 1.0;
  const NoiseOcclusion hidden(surroundings, static_cast<float>(largest * options.radius));
  std::vector<NoiseKernel> left;
  noise.kernels(sheets.view, options, left, nullptr, &hidden);
  const NoiseSums expected = noiseSums(all, surroundings, {});
  const NoiseSums found = noiseSums(left, surroundings, {});
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.z, expected.z);
  return { all.size(), left.size() };
}

} // namespace

TEST(NoiseOcclusion, TheNoiseIsTheSame)
{
  const Sheets sheets;
  for (const double radius : { 2.0, 5.0, 8.0, 20.0 })
  {
    NoiseKernelOptions options;
    options.radius = radius;
    NoiseSurroundings surroundings = sheets.surroundings();
    const Counts counts = expectSameNoise(sheets, surroundings, options);
    // The back sheet is hidden over 110 of 310 columns of both.
    EXPECT_LT(counts.left, counts.all);
    EXPECT_LT(radius > 10.0 ? 0 : counts.left, 4 * counts.all / 5) << radius;
    surroundings.everyPixel = true;
    expectSameNoise(sheets, surroundings, options);
    surroundings.everyPixel = false;
    surroundings.partialVisibility = false;
    expectSameNoise(sheets, surroundings, options);
  }
}

TEST(NoiseOcclusion, ControlledKernelsReachFarther)
{
  const Sheets sheets;
  NoiseKernelOptions options;
  options.radius = 6.0;
  options.control = [](const NoisePoint& point)
  {
    NoiseKernelOptions::Control control;
    control.bandwidth = point.triangle % 2 == 0 ? 0.5 : 2.0;
    return control;
  };
  const Counts counts = expectSameNoise(sheets, sheets.surroundings(), options);
  EXPECT_LT(counts.left, counts.all);
}

TEST(NoiseOcclusion, NothingIsHiddenWithoutTests)
{
  const Sheets sheets;
  NoiseSurroundings surroundings = sheets.surroundings();
  surroundings.depthTest = false;
  surroundings.partialVisibility = false;
  const Counts counts = expectSameNoise(sheets, surroundings, {});
  EXPECT_EQ(counts.left, counts.all);
  surroundings = sheets.surroundings();
  surroundings.depth = Span<const float>();
  const Counts unknown = expectSameNoise(sheets, surroundings, {});
  EXPECT_EQ(unknown.left, unknown.all);
}

TEST(NoiseOcclusion, OddRectangles)
{
  NoiseSurroundings empty;
  EXPECT_FALSE(NoiseOcclusion(empty, 8.0f).hides(0.0f, 0.0f, 0.5f, 0.0f));
  const std::vector<float> nothing(9 * 3, 1.0f);
  NoiseSurroundings small;
  small.rectangle = { 5, 7, 9, 3 };
  small.depth = nothing;
  const NoiseOcclusion hidden(small, 8.0f);
  EXPECT_TRUE(hidden.hides(13.5f, 9.5f, 0.5f, 0.0f)) << "where nothing is, nothing is seen";
  EXPECT_FALSE(hidden.hides(14.5f, 9.5f, 0.5f, 0.0f)) << "outside nothing is known";
  EXPECT_FALSE(hidden.hides(4.5f, 9.5f, 0.5f, 0.0f));
  small.rectangle[2] = 8;
  EXPECT_NE(
    messageOf([&] { NoiseOcclusion(small, 8.0f); }).find("depth has 27 elements, expected 24"),
    std::string::npos);
}

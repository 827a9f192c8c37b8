// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoiseScenes.h"

#include "Core/NoiseVisibility.h"

#include <gtest/gtest.h>

using namespace hachure;
using namespace hachure::testing;

namespace
{

constexpr float radius = 8.0f;

// A plane on the left in front of another one on the right.
struct Step
{
  std::array<int, 4> rectangle{ 0, 0, 64, 48 };
  std::vector<float> depth =
    imageOf<float>(rectangle, [](double x, double) { return x < 32.0 ? 0.4 : 0.7; });

  NoiseSurroundings surroundings() const
  {
    NoiseSurroundings result;
    result.rectangle = this->rectangle;
    result.depth = this->depth;
    result.depthTolerance = 1e-3f;
    return result;
  }
  static NoiseKernel kernelAt(double x, double y, float depth)
  {
    NoiseKernel kernel;
    kernel.center = { x, y };
    kernel.bandwidth = glsl::kernelBandwidth(radius);
    kernel.frequency = 0.0f;
    kernel.depth = depth;
    return kernel;
  }
};

struct SphereScene
{
  std::array<int, 4> rectangle{ 0, 0, 300, 300 };
  Sphere sphere{ 150.0, 150.0, 130.0, 1e-3, 0.5 };
  std::vector<float> depth =
    imageOf<float>(rectangle, [this](double x, double y) { return this->sphere.depthAt(x, y); });
  std::vector<NoiseKernel> kernels;

  explicit SphereScene(std::uint32_t seed = 1)
  {
    FlatNoise noise;
    noise.rectangle = this->rectangle;
    noise.spread = 0.5 * pi;
    noise.seed = seed;
    noise.radius = radius;
    this->kernels = noise.kernels();
    for (NoiseKernel& kernel : this->kernels)
    {
      this->sphere.place(kernel);
    }
  }
  NoiseSurroundings surroundings() const
  {
    NoiseSurroundings result;
    result.rectangle = this->rectangle;
    result.depth = this->depth;
    result.depthTolerance = noiseDepthToleranceFor(radius, 1e-3f);
    return result;
  }
  double distance(std::size_t pixel) const
  {
    return glm::distance(
      centerOf(this->rectangle, pixel), glm::dvec2(this->sphere.x, this->sphere.y));
  }
};

} // namespace

TEST(NoiseVisibility, ShareOfTheDiscInFrontOfAnEdge)
{
  const Step step;
  const std::vector<NoiseKernel> kernels = { Step::kernelAt(16.2, 20.4, 0.4f) };
  const NoiseVisibility visibility(step.surroundings(), kernels);
  const auto shareAt = [&](double x, double y, float depth)
  { return visibility.share(Step::kernelAt(x, y, depth), radius); };
  EXPECT_EQ(shareAt(16.2, 20.4, 0.4f).seen, 1.0f);
  EXPECT_TRUE(shareAt(16.2, 20.4, 0.4f).complete);
  EXPECT_NEAR(shareAt(32.0, 20.4, 0.4f).seen, 0.5f, 0.15f);
  EXPECT_NEAR(shareAt(32.0, 20.4, 0.7f).seen, 0.5f, 0.15f);
  EXPECT_FALSE(shareAt(32.0, 20.4, 0.7f).complete);
  EXPECT_EQ(shareAt(50.0, 20.4, 0.4f).seen, 0.0f);
  EXPECT_EQ(shareAt(16.2, 20.4, 0.7f).seen, 0.0f);
  // What lies outside the picture is not known: the kernel counts as what is seen of it.
  EXPECT_EQ(shareAt(1.0, 20.4, 0.4f).seen, 1.0f);
}

TEST(NoiseVisibility, ToleranceFadesFromOnceToTwice)
{
  const Step step;
  const std::vector<NoiseKernel> kernels = { Step::kernelAt(16.2, 20.4, 0.4f) };
  const NoiseVisibility visibility(step.surroundings(), kernels);
  EXPECT_EQ(visibility.share(Step::kernelAt(16.0, 20.0, 0.4009f), radius).seen, 1.0f);
  // Of which a tenth is not drawn.
  EXPECT_NEAR(
    visibility.share(Step::kernelAt(16.0, 20.0, 0.4015f), radius).seen, 0.4f / 0.9f, 1e-3f);
  EXPECT_EQ(visibility.share(Step::kernelAt(16.0, 20.0, 0.4021f), radius).seen, 0.0f);
}

TEST(NoiseVisibility, NothingIsSeenAtTheFarEndOfTheDepths)
{
  const std::vector<float> depth(64 * 48, 1.0f);
  NoiseSurroundings surroundings = Step().surroundings();
  surroundings.depth = depth;
  const std::vector<NoiseKernel> kernels = { Step::kernelAt(16.2, 20.4, 1.0f) };
  const NoiseShare share = NoiseVisibility(surroundings, kernels).share(kernels[0], radius);
  EXPECT_EQ(share.seen, 0.0f);
}

// A kernel that moves across an edge fades without a jump, and nowhere does it cross the edge.
TEST(NoiseVisibility, KernelsAreTrimmedAndFadeAtAnEdge)
{
  const Step step;
  for (const float depth : { 0.4f, 0.7f })
  {
    NoiseSums before;
    double most = 0.0, drawn = 0.0;
    for (double x = 20.0; x < 44.0; x += 0.1)
    {
      const std::vector<NoiseKernel> kernels = { Step::kernelAt(x, 20.3, depth) };
      const NoiseSums sums = noiseSums(kernels, step.surroundings(), {});
      for (std::size_t i = 0; i < sums.x.size(); ++i)
      {
        const bool own = (i % 64 < 32) == (depth == 0.4f);
        ASSERT_TRUE(own || sums.x[i] == 0.0f) << "x " << x << " pixel " << i;
        drawn = std::max(drawn, static_cast<double>(sums.x[i]));
        // At its rim a kernel ends at 5 %.
        const double change = before.x.empty() ? 0.0 : std::abs(sums.x[i] - before.x[i]);
        most = std::max(most, change);
      }
      before = sums;
    }
    EXPECT_GT(drawn, 0.99);
    EXPECT_LT(most, 0.055) << depth;
  }
}

TEST(NoiseVisibility, WithoutTheDepthTestKernelsCrossAnEdgeWithTheirShare)
{
  const Step step;
  const std::vector<NoiseKernel> kernels = { Step::kernelAt(30.0, 20.3, 0.4f) };
  NoiseSurroundings surroundings = step.surroundings();
  surroundings.depthTest = false;
  const NoiseSums sums = noiseSums(kernels, surroundings, {});
  const float share = NoiseVisibility(surroundings, kernels).share(kernels[0], radius).seen;
  EXPECT_GT(share, 0.5f);
  EXPECT_LT(share, 0.95f);
  const glm::vec2 offset = glm::vec2(34.5f, 20.5f) - kernels[0].center;
  EXPECT_NEAR(sums.x[20 * 64 + 34],
    share * glsl::noiseEnvelope(glm::dot(offset, offset), kernels[0].bandwidth), 1e-5);
  surroundings.partialVisibility = false;
  EXPECT_NEAR(
    noiseSums(kernels, surroundings, {}).x[20 * 64 + 34] * share, sums.x[20 * 64 + 34], 1e-6);
}

TEST(NoiseVisibility, NothingCrossesFromOneObjectToAnother)
{
  FlatNoise noise;
  noise.rectangle = { 7, 9, 90, 70 };
  auto kernels = noise.kernels();
  const auto objects = imageOf<std::int32_t>(
    noise.rectangle, [](double x, double y) { return x + 0.4 * y > 60.0 ? 5 : 2; });
  const auto ofTwo = [&](std::int32_t other)
  {
    auto all = kernels;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      all[i].object = i % 2 == 0 ? 2 : other;
    }
    NoiseSurroundings surroundings = noise.surroundings();
    surroundings.objects = objects;
    return noiseSums(all, surroundings, {}).x;
  };
  const auto both = ofTwo(5);
  const auto alone = ofTwo(8); // which is nowhere to be seen
  int different = 0;
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    if (objects[i] == 2)
    {
      ASSERT_EQ(both[i], alone[i]) << i;
    }
    else
    {
      ASSERT_EQ(alone[i], 0.0f) << i;
      different += both[i] != 0.0f ? 1 : 0;
    }
  }
  EXPECT_GT(different, 100);
}

TEST(NoiseVisibility, CurvedSurfacesHideNothingOfTheirOwn)
{
  // As curved as the tolerance is made for.
  SphereScene scene;
  const NoiseVisibility visibility(scene.surroundings(), scene.kernels);
  Sphere small{ 40.0, 40.0, 4.0 * radius, 1e-3, 0.5 };
  const auto depth =
    imageOf<float>({ 0, 0, 80, 80 }, [&](double x, double y) { return small.depthAt(x, y); });
  NoiseSurroundings curved = scene.surroundings();
  curved.rectangle = { 0, 0, 80, 80 };
  curved.depth = depth;
  const NoiseVisibility smallVisibility(curved, scene.kernels);
  for (const NoiseKernel& kernel : scene.kernels)
  {
    const double place = glm::length(glm::dvec2(kernel.center) - glm::dvec2(150.0));
    if (place < 130.0 - 2.0 * radius)
    {
      EXPECT_EQ(visibility.share(kernel, radius).seen, 1.0f) << place;
      EXPECT_TRUE(visibility.share(kernel, radius).complete) << place;
    }
    NoiseKernel moved = kernel;
    moved.weight = 1.0f;
    moved.center = kernel.center * 0.25f;
    small.place(moved);
    const double distance = glm::length(glm::dvec2(moved.center) - glm::dvec2(40.0));
    if (distance < 3.0 * radius)
    {
      EXPECT_GT(smallVisibility.share(moved, radius).seen, 0.999f) << distance;
    }
  }
}

TEST(NoiseVisibility, DeviationIsOneUpToASilhouette)
{
  std::array<double, 7> sums{};
  constexpr int seeds = 4;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed)
  {
    const SphereScene scene(seed);
    const NoiseSums noise = noiseSums(scene.kernels, scene.surroundings(), {});
    for (int ring = 0; ring < 7; ++ring)
    {
      const double outer = 130.0 - 3.0 * ring;
      const double deviation = normalisedDeviation(noise,
        [&](std::size_t i)
        { return scene.distance(i) < outer && scene.distance(i) >= outer - 3.0; });
      sums[ring] += deviation * deviation / seeds;
    }
  }
  for (const double square : sums)
  {
    EXPECT_NEAR(std::sqrt(square), 1.0, 0.05);
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoiseScenes.h"

#include <gtest/gtest.h>

#include <limits>
#include <omp.h>
#include <stdexcept>
#include <string>

using namespace hachure;
using namespace hachure::testing;

namespace
{

NoiseSpot leaf()
{
  return { 5, 4, { 0, 0, 1, 0, 0, 0, 2, 3, 1, 0, 1, 3, 5, 2, 1, 0, 0, 1, 0, -2 } };
}

// A sphere in front of a plane of another object, with a rim where nothing is.
struct MixedScene
{
  std::array<int, 4> rectangle{ 1003, -37, 150, 111 };
  Sphere sphere{ 1070.0, 20.0, 45.0, 1e-3, 0.5 };
  std::vector<float> depth;
  std::vector<std::int32_t> objects, triangles;
  std::vector<NoiseKernel> kernels;

  double planeDepth(double x, double y) const { return 0.6 + 2e-4 * (x - 1003.0) + 1e-4 * y; }
  bool isPlane(double x, double y) const { return x < 1100.0 + 0.2 * y; }

  MixedScene()
  {
    this->depth = imageOf<float>(this->rectangle,
      [&](double x, double y)
      {
        const double behind = this->isPlane(x, y) ? this->planeDepth(x, y) : 1.0;
        return std::min(behind, this->sphere.depthAt(x, y));
      });
    this->objects = imageOf<std::int32_t>(this->rectangle,
      [&](double x, double y) { return this->sphere.heightSquare(x, y) > 0.0 ? 3 : 7; });
    this->triangles = imageOf<std::int32_t>(
      this->rectangle, [&](double x, double y) { return x + 0.3 * y > 1080.0 ? 1 : 0; });
    FlatNoise noise;
    noise.rectangle = this->rectangle;
    noise.spread = 1.5;
    noise.overlap = 12.0;
    this->kernels = noise.kernels();
    for (std::size_t i = 0; i < this->kernels.size(); ++i)
    {
      this->place(i, this->kernels[i]);
    }
  }
  void place(std::size_t i, NoiseKernel& kernel) const
  {
    kernel.bandwidth *= static_cast<float>(0.4 + unitRandom(5, i, 0));
    kernel.weight = static_cast<float>(unitRandom(5, i, 1));
    kernel.triangle = static_cast<std::int32_t>(i % 2);
    if (i % 3 == 0)
    {
      kernel.object = 3;
      this->sphere.place(kernel);
      return;
    }
    kernel.object = 7;
    kernel.depth = static_cast<float>(this->planeDepth(kernel.center.x, kernel.center.y));
    kernel.depthSlope = { 2e-4f, 1e-4f };
  }
  NoiseSurroundings surroundings() const
  {
    NoiseSurroundings result;
    result.rectangle = this->rectangle;
    result.depth = this->depth;
    result.depthTolerance = 2e-3f;
    return result;
  }
  // Whether a pixel's centre is so near to the rim of a kernel that rounding decides.
  bool onRim(std::size_t pixel) const
  {
    const glm::dvec2 place = centerOf(this->rectangle, pixel);
    return std::any_of(this->kernels.begin(), this->kernels.end(),
      [&](const NoiseKernel& kernel)
      {
        const double distance = glm::distance(place, glm::dvec2(kernel.center));
        return std::abs(distance - glsl::kernelRadius(kernel.bandwidth)) < 1e-4;
      });
  }
};

double rootMeanSquare(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value * value;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void expectNear(const MixedScene& scene, const std::vector<float>& found,
  const std::vector<double>& expected, const std::string& what)
{
  ASSERT_EQ(found.size(), expected.size()) << what;
  if (expected.empty())
  {
    return;
  }
  const double scale = rootMeanSquare(expected);
  EXPECT_GT(scale, 0.1) << what;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (std::abs(found[i] - expected[i]) > 1e-5 * scale)
    {
      ASSERT_TRUE(scene.onRim(i)) << what << " at pixel " << i << ": " << found[i] << ", expected "
                                  << expected[i];
    }
  }
}

} // namespace

TEST(NoiseField, EqualsTheDefinition)
{
  const MixedScene scene;
  const NoiseSpot spot = leaf();
  for (const NoiseKind kind : { NoiseKind::gabor, NoiseKind::phasor, NoiseKind::spot })
  {
    for (int tests = 0; tests < 16; tests += 3)
    {
      NoiseSurroundings surroundings = scene.surroundings();
      surroundings.depthTest = (tests & 1) != 0;
      surroundings.partialVisibility = (tests & 2) != 0;
      surroundings.objects =
        tests & 4 ? Span<const std::int32_t>(scene.objects) : surroundings.objects;
      surroundings.triangles =
        tests & 8 ? Span<const std::int32_t>(scene.triangles) : surroundings.triangles;
      const NoiseFieldOptions options = { kind, 12.0, &spot };
      const NoiseSums found = noiseSums(scene.kernels, surroundings, options);
      const NoiseReference expected = noiseReference(scene.kernels, surroundings, options);
      const std::string what =
        "kind " + std::to_string(static_cast<int>(kind)) + " tests " + std::to_string(tests);
      expectNear(scene, found.x, expected.x, what + " x");
      expectNear(scene, found.y, expected.y, what + " y");
      expectNear(scene, found.z, expected.z, what + " z");
    }
  }
}

TEST(NoiseField, OneKernelIsTheKernel)
{
  NoiseKernel kernel;
  kernel.center = { 20.3f, 19.1f };
  kernel.phase = 0.7f;
  kernel.orientation = 0.4f;
  kernel.frequency = 0.11f;
  NoiseSurroundings surroundings;
  surroundings.rectangle = { 0, 0, 40, 40 };
  const std::vector<NoiseKernel> kernels = { kernel };
  const NoiseSums gabor = noiseSums(kernels, surroundings, {});
  const NoiseSums phasor = noiseSums(kernels, surroundings, { NoiseKind::phasor, 32.0, nullptr });
  const double radius = glsl::kernelRadius(kernel.bandwidth);
  EXPECT_NEAR(glsl::noiseEnvelope(static_cast<float>(radius * radius) * 0.999f, kernel.bandwidth),
    0.05, 2e-4);
  for (std::size_t i = 0; i < 1600; ++i)
  {
    const glm::vec2 offset = glm::vec2(centerOf(surroundings.rectangle, i)) - kernel.center;
    const glm::vec2 expected = glsl::phasorKernel(
      offset, kernel.frequency, kernel.bandwidth, kernel.orientation, kernel.phase);
    EXPECT_NEAR(gabor.x[i], expected.x, 2e-6);
    EXPECT_NEAR(phasor.y[i], expected.y, 2e-6);
    const float envelope = glsl::noiseEnvelope(glm::dot(offset, offset), kernel.bandwidth);
    EXPECT_NEAR(gabor.z[i], 0.5f * envelope * envelope, 2e-6);
  }
}

TEST(NoiseField, SameBytesForAnyNumberOfThreads)
{
  const MixedScene scene;
  NoiseSurroundings surroundings = scene.surroundings();
  surroundings.objects = scene.objects;
  const NoiseSpot spot = leaf();
  const int before = omp_get_max_threads();
  for (const NoiseKind kind : { NoiseKind::gabor, NoiseKind::phasor, NoiseKind::spot })
  {
    omp_set_num_threads(1);
    const NoiseField one = noiseField(scene.kernels, surroundings, { kind, 12.0, &spot });
    omp_set_num_threads(4);
    const NoiseField four = noiseField(scene.kernels, surroundings, { kind, 12.0, &spot });
    EXPECT_EQ(one.value, four.value);
    EXPECT_EQ(one.width, four.width);
  }
  omp_set_num_threads(before);
}

TEST(NoiseField, WidthIsTheChangeAcrossAPixel)
{
  FlatNoise noise;
  noise.rectangle = { 3, 5, 140, 130 }; // of several tiles
  for (const NoiseKind kind : { NoiseKind::gabor, NoiseKind::phasor })
  {
    const NoiseField field =
      noiseField(noise.kernels(), noise.surroundings(), { kind, noise.overlap, nullptr });
    double change = 0.0, width = 0.0;
    for (int row = 1; row < 129; ++row)
    {
      for (int column = 1; column < 139; ++column)
      {
        const float* value = &field.value[static_cast<std::size_t>(row) * 140 + column];
        const float own = field.width[static_cast<std::size_t>(row) * 140 + column];
        const double length = 0.5 * std::hypot(value[1] - value[-1], value[140] - value[-140]);
        // Away from where the phase wraps around.
        if (*value > 0.35f && *value < 0.65f && own < 0.5f)
        {
          change += length;
          width += own;
        }
        if (kind == NoiseKind::gabor)
        {
          ASSERT_NEAR(own, std::max(length, 3e-4), 3e-4) << row << " " << column;
        }
      }
    }
    EXPECT_GT(change, 100.0);
    EXPECT_NEAR(width / change, 1.0, 0.03) << static_cast<int>(kind);
  }
}

// What shaders do with the sums is what is done here.
TEST(NoiseField, IsMadeOfItsSumsByTheShadersFunctions)
{
  FlatNoise noise;
  noise.rectangle = { -20, 30, 140, 40 };
  auto kernels = noise.kernels();
  for (NoiseKernel& kernel : kernels)
  {
    kernel.weight = kernel.center.x > 60.0f ? 0.01f : 1.0f; // hardly any
  }
  const auto distribution = noiseDistribution(32.0);
  const auto range = static_cast<float>(distribution->range);
  const auto steps = static_cast<float>(distribution->share.size() - 1);
  const NoiseFieldOptions phasor = { NoiseKind::phasor, 32.0, nullptr };
  const NoiseSums sums = noiseSums(kernels, noise.surroundings(), {});
  const NoiseSums parts = noiseSums(kernels, noise.surroundings(), phasor);
  const NoiseField field = noiseField(kernels, noise.surroundings(), {});
  const NoiseField lines = noiseField(kernels, noise.surroundings(), phasor);
  const auto part = [&parts](std::size_t i) { return glm::vec2(parts.x[i], parts.y[i]); };
  for (std::size_t i = 141; i < 140 * 39 - 1; ++i)
  {
    const float scaled = glsl::normalisedNoise(sums.x[i], sums.z[i], glsl::noiseVarianceFloor);
    const float place = glsl::noiseTablePosition(scaled, range, steps);
    const auto step = static_cast<std::size_t>(place);
    const float share = glm::mix(
      distribution->share[step], distribution->share[step + 1], place - static_cast<float>(step));
    ASSERT_NEAR(field.value[i], share, 1e-5) << i;
    ASSERT_GE(field.width[i], glsl::noiseFlatWidth(sums.z[i], glsl::noiseVarianceFloor));
    ASSERT_NEAR(lines.value[i], glsl::phasorValue(part(i)), 1e-5) << i;
    const float x = glsl::phasorChange(part(i), 0.5f * (part(i + 1) - part(i - 1)));
    const float y = glsl::phasorChange(part(i), 0.5f * (part(i + 140) - part(i - 140)));
    const float least = glsl::noiseFlatWidth(glm::dot(part(i), part(i)), glsl::phasorFloor);
    const float width = std::min(std::max(std::hypot(x, y), least), 1.0f);
    if (i % 140 > 0 && i % 140 < 139)
    {
      ASSERT_NEAR(lines.width[i], width, 1e-4 + 1e-3 * width) << i;
    }
  }
}

TEST(NoiseField, DeviationIsOneUpToABorderOfTheKernels)
{
  FlatNoise noise;
  noise.rectangle = { 0, 0, 60, 1600 };
  noise.spread = 0.5 * pi;
  auto kernels = noise.kernels();
  kernels.erase(std::remove_if(kernels.begin(), kernels.end(),
                  [](const NoiseKernel& kernel) { return kernel.center.x > 40.0f; }),
    kernels.end());
  const NoiseSums sums = noiseSums(kernels, noise.surroundings(), {});
  for (int column = 0; column < 40; column += 4)
  {
    const double deviation = normalisedDeviation(sums,
      [column](std::size_t i)
      { return static_cast<int>(i % 60) >= column && static_cast<int>(i % 60) < column + 4; });
    EXPECT_NEAR(deviation, 1.0, 0.05) << column;
  }
}

TEST(NoiseField, FlatWhereThereIsNoKernel)
{
  FlatNoise noise;
  noise.rectangle = { 0, 0, 100, 20 };
  auto kernels = noise.kernels();
  for (NoiseKernel& kernel : kernels)
  {
    kernel.weight = kernel.center.x < 50.0f ? 1.0f : 0.0f;
  }
  for (const NoiseKind kind : { NoiseKind::gabor, NoiseKind::phasor })
  {
    const NoiseField field = noiseField(kernels, noise.surroundings(), { kind, 32.0, nullptr });
    for (std::size_t i = 0; i < field.value.size(); ++i)
    {
      EXPECT_TRUE(field.value[i] >= 0.0f && field.value[i] <= 1.0f);
      EXPECT_TRUE(field.width[i] > 0.0f && field.width[i] <= 1.0f);
      if (i % 100 > 60)
      {
        // Ink is the tone.
        EXPECT_EQ(field.value[i], 0.5f);
        EXPECT_NEAR(glsl::inkCoverage(field.value[i], 0.3f, field.width[i]), 0.3f, 1e-5f);
      }
    }
  }
}

TEST(NoiseField, OddInput)
{
  FlatNoise noise;
  noise.rectangle = { 10, 20, 33, 21 };
  const auto kernels = noise.kernels();
  const NoiseField plain = noiseField(kernels, noise.surroundings(), {});
  auto more = kernels;
  NoiseKernel broken = kernels[0];
  broken.center = { 20.0f, 30.0f };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (float NoiseKernel::*member : { &NoiseKernel::weight, &NoiseKernel::phase,
         &NoiseKernel::bandwidth, &NoiseKernel::orientation, &NoiseKernel::depth })
  {
    more.push_back(broken);
    more.back().*member = nan;
  }
  more.push_back(broken);
  more.back().bandwidth = 0.0f;
  more.push_back(broken);
  more.back().center = { 1e30f, -1e30f };
  more.push_back(broken);
  more.back().center = { 500.0f, 30.0f };
  EXPECT_EQ(noiseField(more, noise.surroundings(), {}).value, plain.value);

  // One pixel of the same picture; its differences are not known.
  NoiseSurroundings pixel;
  pixel.rectangle = { 12, 23, 1, 1 };
  EXPECT_EQ(noiseField(kernels, pixel, {}).value[0], plain.value[3 * 33 + 2]);
  EXPECT_GT(noiseField(kernels, pixel, {}).width[0], 0.0f);
  const std::vector<float> nothing(33 * 21, 1.0f);
  NoiseSurroundings empty = noise.surroundings();
  empty.depth = nothing;
  EXPECT_EQ(noiseField(kernels, empty, {}).value, std::vector<float>(33 * 21, 0.0f));
  EXPECT_TRUE(noiseField(kernels, NoiseSurroundings(), {}).value.empty());
  EXPECT_EQ(noiseField({}, noise.surroundings(), {}).value, std::vector<float>(33 * 21, 0.5f));
}

TEST(NoiseField, WrongInputIsRefused)
{
  const auto message = [](const NoiseSurroundings& surroundings, const NoiseFieldOptions& options)
  {
    try
    {
      noiseField({}, surroundings, options);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::vector<float> five(5, 0.5f);
  const std::vector<std::int32_t> ids(7, 0);
  NoiseSurroundings surroundings;
  surroundings.rectangle = { 0, 0, 3, 2 };
  EXPECT_EQ(message(surroundings, {}), "accepted");
  NoiseSurroundings wrong = surroundings;
  wrong.depth = five;
  EXPECT_NE(message(wrong, {}).find("depth has 5 elements, expected 6"), std::string::npos);
  wrong = surroundings;
  wrong.objects = ids;
  EXPECT_NE(message(wrong, {}).find("objects has 7 elements"), std::string::npos);
  wrong = surroundings;
  wrong.triangles = ids;
  EXPECT_NE(message(wrong, {}).find("triangles has 7 elements"), std::string::npos);
  wrong = surroundings;
  wrong.rectangle[2] = -3;
  EXPECT_NE(message(wrong, {}).find("rectangle is -3 x 2"), std::string::npos);
  wrong = surroundings;
  wrong.depthTolerance = 0.0f;
  EXPECT_NE(message(wrong, {}).find("depthTolerance is 0"), std::string::npos);
  EXPECT_NE(message(surroundings, { NoiseKind::gabor, -1.0, nullptr }).find("overlap is -1"),
    std::string::npos);
  EXPECT_NE(message(surroundings, { NoiseKind::spot, 8.0, nullptr }).find("spot is missing"),
    std::string::npos);
  const NoiseSpot spot = { 2, 2, { 1.0f } };
  EXPECT_NE(message(surroundings, { NoiseKind::spot, 8.0, &spot }).find("1 values for 2 x 2"),
    std::string::npos);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is made of tones, how colours separate into inks, and how light falls.

#include "Kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
namespace glsl = hachure::glsl;

constexpr int levels = 256;
const glm::vec3 unchanged(0.0f);

TEST(ToneCurve, GammaAfterInversion)
{
  for (const float tone : { 0.0f, 0.25f, 0.6f, 1.0f })
  {
    EXPECT_FLOAT_EQ(glsl::toneCurve(tone, 1.0f, 0.0f, unchanged), tone);
    EXPECT_NEAR(glsl::toneCurve(tone, 2.0f, 0.0f, unchanged), tone * tone, 1e-6f);
    const float light = 1.0f - tone;
    EXPECT_NEAR(glsl::toneCurve(tone, 2.0f, 1.0f, unchanged), light * light, 1e-6f);
  }
}

TEST(ToneCurve, StepsAreFlatEqualAndReachBothEnds)
{
  for (int steps = 2; steps <= 16; ++steps)
  {
    const glm::vec3 remap(glsl::remapSteps, static_cast<float>(steps), 0.0f);
    std::map<float, int> found;
    float before = 0.0f;
    for (int i = 0; i < levels * steps; ++i)
    {
      const float tone = (static_cast<float>(i) + 0.5f) / static_cast<float>(levels * steps);
      const float stepped = glsl::toneCurve(tone, 1.0f, 0.0f, remap);
      EXPECT_GE(stepped, before);
      EXPECT_LE(std::abs(stepped - tone), 1.0f / static_cast<float>(steps));
      before = stepped;
      ++found[stepped];
    }
    EXPECT_EQ(found.size(), static_cast<std::size_t>(steps));
    for (const auto& step : found)
    {
      EXPECT_EQ(step.second, levels) << "step " << step.first << " of " << steps;
    }
    EXPECT_EQ(glsl::toneCurve(0.0f, 1.0f, 0.0f, remap), 0.0f);
    EXPECT_EQ(glsl::toneCurve(1.0f, 1.0f, 0.0f, remap), 1.0f);
  }
  EXPECT_FLOAT_EQ(glsl::toneCurve(0.5f, 1.0f, 0.0f, glm::vec3(glsl::remapSteps, 5.0f, 0.0f)), 0.5f);
}

TEST(ToneCurve, StepsFollowGamma)
{
  const glm::vec3 remap(glsl::remapSteps, 2.0f, 0.0f);
  EXPECT_EQ(glsl::toneCurve(0.7f, 1.0f, 0.0f, remap), 1.0f);
  EXPECT_EQ(glsl::toneCurve(0.7f, 2.0f, 0.0f, remap), 0.0f);
}

TEST(ToneCurve, SmoothStepHasItsEndsMiddleAndSlope)
{
  const glm::vec3 remap(glsl::remapSmoothStep, 0.2f, 0.6f);
  const auto at = [&](float tone) { return glsl::toneCurve(tone, 1.0f, 0.0f, remap); };
  EXPECT_EQ(at(0.1f), 0.0f);
  EXPECT_EQ(at(0.2f), 0.0f);
  EXPECT_NEAR(at(0.4f), 0.5f, 1e-6f);
  EXPECT_NEAR(at(0.3f), 0.15625f, 1e-6f);
  EXPECT_EQ(at(0.6f), 1.0f);
  EXPECT_EQ(at(0.9f), 1.0f);
  EXPECT_LT(at(0.201f), 1e-4f) << "not level where it begins";
  EXPECT_GT(at(0.599f), 1.0f - 1e-4f) << "not level where it ends";
}

TEST(ToneCurve, SmoothStepFallsOrJumps)
{
  for (const float tone : { 0.0f, 0.25f, 0.3f, 0.55f, 1.0f })
  {
    EXPECT_NEAR(
      glsl::smoothRemap(tone, 0.6f, 0.2f), 1.0f - glsl::smoothRemap(tone, 0.2f, 0.6f), 1e-6f);
  }
  EXPECT_EQ(glsl::smoothRemap(0.499f, 0.5f, 0.5f), 0.0f);
  EXPECT_EQ(glsl::smoothRemap(0.5f, 0.5f, 0.5f), 1.0f);
}

TEST(ProcessInks, MultiplyBackToTheColour)
{
  for (const float share : { 0.0f, 0.4f, 1.0f })
  {
    for (int i = 0; i < 6 * 6 * 6; ++i)
    {
      const int red = i % 6;
      const int green = i / 6 % 6;
      const int blue = i / 36;
      const glm::vec3 color = glm::vec3(red, green, blue) / 5.0f;
      const glm::vec4 inks = glsl::processInks(color, share);
      const glm::vec3 printed = (1.0f - inks.w) * (glm::vec3(1.0f) - glm::vec3(inks));
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(printed[c], color[c], 1e-6f) << "colour " << i << ", black " << share;
        EXPECT_TRUE(inks[c] >= 0.0f && inks[c] <= 1.0f);
      }
      const float lightest = std::max(color.x, std::max(color.y, color.z));
      EXPECT_NEAR(inks.w, share * (1.0f - lightest), 1e-6f);
    }
  }
}

TEST(SurfaceLight, FadesWithDistanceAndOutsideItsCone)
{
  const glm::vec4 position(0.0f, 0.0f, 2.0f, 3.0f);
  const glm::vec3 attenuation(0.5f, 0.25f, 0.125f);
  const glm::vec4 open(0.0f, 0.0f, -1.0f, -1.0f);
  const glm::vec4 below = glsl::lightRays(glm::vec3(0.0f), open, position, attenuation, 1.0f);
  EXPECT_NEAR(below.w, 1.0f / (0.5f + 0.25f * 2.0f + 0.125f * 4.0f), 1e-6f);
  const float half = std::cos(0.5f);
  const glm::vec4 cone(0.0f, 0.0f, -1.0f, half);
  const glm::vec3 constant(1.0f, 0.0f, 0.0f);
  const auto strength = [&](float angle)
  {
    const glm::vec3 point(2.0f * std::tan(angle), 0.0f, 0.0f);
    return glsl::lightRays(point, cone, position, constant, 1.0f).w;
  };
  EXPECT_NEAR(strength(0.3f), std::pow(std::cos(0.3f), 3.0f), 1e-5f);
  EXPECT_GT(strength(0.499f), 0.6f);
  EXPECT_EQ(strength(0.501f), 0.0f);
  const glm::vec4 far = glsl::lightRays(glm::vec3(5.0f), open, position, attenuation, 0.0f);
  EXPECT_EQ(far, glm::vec4(0.0f, 0.0f, -1.0f, 1.0f));
}

TEST(SurfaceLight, ShinesWhereTheMirroredRayMeetsTheEye)
{
  const glm::vec3 normal(0.0f, 0.0f, 1.0f);
  const glm::vec3 point(-1.0f, 0.0f, -1.0f);
  const glm::vec4 mirrored(glm::normalize(glm::vec3(1.0f, 0.0f, -1.0f)), 1.0f);
  EXPECT_NEAR(glsl::highlightShare(normal, mirrored, point, 50.0f), 1.0f, 1e-4f);
  const glm::vec4 aside(0.0f, 0.0f, -1.0f, 1.0f);
  EXPECT_NEAR(glsl::highlightShare(normal, aside, point, 2.0f), 0.5f, 1e-5f);
  EXPECT_NEAR(glsl::diffuseShare(normal, mirrored), std::sqrt(0.5f), 1e-6f);
  const glm::vec4 behind(0.0f, 0.0f, 1.0f, 1.0f);
  EXPECT_EQ(glsl::highlightShare(normal, behind, point, 2.0f), 0.0f);
  EXPECT_EQ(glsl::diffuseShare(normal, behind), 0.0f);
}
} // namespace

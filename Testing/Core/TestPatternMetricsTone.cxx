// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/PatternMetricsTone.h"
#include "MetricClips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hachure;
using namespace hachure::test;

namespace
{

constexpr int size = 96;

Clip constantClip()
{
  return planeClip(size, 4, {}, [](int) { return noiseInk(8.0, 1); }, {});
}

// Squares of 16 pixels, numbered from 1.
std::vector<std::int32_t> squares()
{
  std::vector<std::int32_t> labels;
  labels.reserve(static_cast<std::size_t>(size) * size);
  for (int i = 0; i < size * size; ++i)
  {
    labels.push_back(1 + (i % size) / 16 + 6 * ((i / size) / 16));
  }
  return labels;
}

} // namespace

TEST(PatternMetricsTone, AConstantClipDoesNotFlicker)
{
  const Clip clip = constantClip();
  const std::vector<std::int32_t> cells = squares();
  const std::vector<LabelView> labels(4, { size, size, cells });
  EXPECT_EQ(toneFlicker(clip.view().frames, labels), 0.0);
}

TEST(PatternMetricsTone, FlickerIsTheDeviationOverTime)
{
  Clip clip = constantClip();
  for (std::size_t t = 0; t < 4; ++t)
  {
    clip.inks[t].assign(size * size, t % 2 == 0 ? 0.4f : 0.6f);
  }
  const std::vector<std::int32_t> cells = squares();
  const std::vector<LabelView> labels(4, { size, size, cells });
  EXPECT_NEAR(toneFlicker(clip.view().frames, labels), 0.1, 1e-6);
  // Cells that are too small in all frames but one say nothing.
  EXPECT_TRUE(std::isnan(toneFlicker(clip.view().frames, labels, 257)));
}

TEST(PatternMetricsTone, DeviationSeesTheContrastThatCorrelationDoesNot)
{
  Clip clip = constantClip();
  for (float& value : clip.inks[2])
  {
    value = 0.5f + 0.5f * (value - 0.5f);
  }
  const std::vector<double> deviations = inkDeviations(clip.view(), 0.3);
  ASSERT_EQ(deviations.size(), 3u);
  EXPECT_NEAR(deviations[2] / deviations[0], 0.5, 1e-6);
  EXPECT_EQ(deviations[1], deviations[0]);
  EXPECT_NEAR(inkDeviation(clip.view().frames[0]), deviations[0], 1e-12);
}

TEST(PatternMetricsTone, RampOfAnExactScreenAndOfAWrongOne)
{
  constexpr int side = 256;
  std::vector<float> tone, exact, darker, falling;
  for (int i = 0; i < side * side; ++i)
  {
    const double g = std::clamp((i % side - 40) / 175.0, 0.0, 1.0);
    // Eight rows of a screen: of every column the share g is inked, the last row in part.
    const double row = (i / side + 3 * (i % side)) % 8;
    const auto ink = [&](double value) { return float(std::clamp(8.0 * value - row, 0.0, 1.0)); };
    tone.push_back(static_cast<float>(g));
    exact.push_back(ink(g));
    darker.push_back(ink(std::min(1.0, g + 0.1 * std::sin(std::acos(-1.0) * g))));
    falling.push_back(ink(g < 0.5 ? g : g - 0.4));
  }
  const ImageView wanted{ side, side, tone };
  const ToneError good = measureTone({ side, side, exact }, wanted, 8.0);
  EXPECT_LT(good.largest, 0.003);
  EXPECT_LT(good.drop, 1e-3);
  EXPECT_NEAR(measureTone({ side, side, darker }, wanted, 8.0).largest, 0.1, 0.005);
  const ToneError drop = measureTone({ side, side, falling }, wanted, 8.0);
  // The window, of deviation s = 12 / 175, leaves .4 erf(1.3 / sqrt 2) - 2.6 s of the fall.
  EXPECT_NEAR(drop.drop, 0.144, 0.02);
  EXPECT_NEAR(drop.largest, 0.4, 0.01);
}

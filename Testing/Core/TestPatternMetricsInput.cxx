// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wrong clips and their messages.

#include "CallTests.h"
#include "Core/PatternMetricsFlatness.h"
#include "Core/PatternMetricsMotion.h"
#include "Core/PatternMetricsTone.h"
#include "MetricClips.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

using namespace hachure;
using namespace hachure::test;

namespace
{

const float notANumber = std::numeric_limits<float>::quiet_NaN();

Clip goodClip()
{
  return planeClip(64, 3, {}, [](int) { return noiseInk(8.0, 1); }, {});
}

void expectMessage(const PatternClip& clip, const std::string& part)
{
  const std::string message = messageOf([&] { measureMotion(clip); });
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

} // namespace

TEST(PatternMetricsInput, WrongNumbersOfImages)
{
  const Clip clip = goodClip();
  PatternClip view = clip.view();
  view.motions.pop_back();
  expectMessage(view, "motions: 1 for 3 frames, expected one for every step");
  view.motions.clear();
  expectMessage(view, "motions: none");
  view.frames.resize(1);
  expectMessage(view, "frames: 1, expected at least 2");
}

TEST(PatternMetricsInput, WrongSizes)
{
  const Clip clip = goodClip();
  PatternClip view = clip.view();
  view.frames[2].width = 32;
  expectMessage(view, "frame 2: 32 x 64 pixels, expected the size of frame 0, 64 x 64");
  view = clip.view();
  view.frames[1].values = view.frames[1].values.subspan(0, 10);
  expectMessage(view, "frame 1: 10 values, expected 4096");
  view = clip.view();
  view.motions[1].height = 65;
  expectMessage(view, "motion 1: 64 x 65 pixels, expected the size of frame 0");
  view = clip.view();
  view.motions[1].facing = view.motions[1].u.subspan(0, 3);
  expectMessage(view, "motion 1: expected 4096 values of every component");
}

TEST(PatternMetricsInput, WrongNumbers)
{
  Clip clip = goodClip();
  clip.inks[1][65] = notANumber;
  expectMessage(clip.view(), "frame 1: ink nan at pixel (1, 1), expected a number from 0 to 1");
  clip.inks[1][65] = 255.0f;
  expectMessage(clip.view(), "frame 1: ink 255");
  clip = goodClip();
  clip.motions[0].v[130] = notANumber;
  expectMessage(clip.view(), "motion 0: motion nan at pixel (2, 2), expected finite pixels");
  clip = goodClip();
  clip.motions[1].visible[0] = notANumber;
  expectMessage(clip.view(), "motion 1: visible nan at pixel (0, 0), expected 0 or 1");
  clip = goodClip();
  clip.motions[1].distance.assign(64 * 64, 0.0f);
  expectMessage(clip.view(), "motion 1: distance 0.000000 at pixel (0, 0)");
  clip = goodClip();
  clip.motions[1].facing.assign(64 * 64, notANumber);
  expectMessage(clip.view(), "motion 1: facing nan at pixel (0, 0)");
}

TEST(PatternMetricsInput, NothingToMeasure)
{
  Clip clip = goodClip();
  clip.motions[1].visible.assign(64 * 64, 0.0f);
  expectMessage(clip.view(), "motion 1: no pixel is visible");
  clip.motions[1].visible[100] = 1.0f;
  clip.motions[0] = clip.motions[1];
  expectMessage(clip.view(), "holds no block of 16 x 16 pixels");
}

TEST(PatternMetricsInput, WrongOptions)
{
  const Clip clip = goodClip();
  MotionMetricsOptions options;
  options.wavelength = 1.0;
  EXPECT_NE(messageOf([&] { measureMotion(clip.view(), options); }).find("wavelength: 1.0"),
    std::string::npos);
  FlatnessOptions flatness;
  flatness.window = 8;
  const auto none = [](std::vector<std::complex<double>>&) {};
  EXPECT_NE(messageOf([&] { measureFlatness(clip.view(), none, flatness); }).find("window: 8"),
    std::string::npos);
}

TEST(PatternMetricsInput, WrongLabelsAndTones)
{
  const Clip clip = goodClip();
  const PatternClip view = clip.view();
  const std::vector<std::int32_t> cells(64 * 64, 1);
  const std::vector<LabelView> labels(2, { 64, 64, cells });
  EXPECT_NE(messageOf([&] { toneFlicker(view.frames, labels); }).find("labels: 2 images for 3"),
    std::string::npos);
  const std::vector<float> outside(64 * 64, -1.0f);
  const ImageView tone{ 64, 64, outside };
  EXPECT_NE(messageOf([&] { measureTone(view.frames[0], tone, 8.0); }).find("tone: no Gaussian"),
    std::string::npos);
}

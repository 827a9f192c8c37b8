// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Averaging keeps the light of a picture, whatever the sizes.

#include "LinearImage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

using namespace hachure::program;

namespace
{
double light(const Picture& picture)
{
  double sum = 0.0;
  for (const std::uint8_t value : picture.pixels)
  {
    sum += std::pow(value / 255.0, 2.2);
  }
  return sum / static_cast<double>(picture.pixels.size());
}

Picture scattered(int width, int height)
{
  Picture picture{ width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 3) };
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
  {
    picture.pixels[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 24);
  }
  return picture;
}
} // namespace

TEST(LinearImage, EveryValueSurvives)
{
  for (int value = 0; value < 256; ++value)
  {
    const auto byte = static_cast<std::uint8_t>(value);
    const Picture plain{ 4, 4, std::vector<std::uint8_t>(48, byte) };
    EXPECT_EQ(averagedDown(plain, 2, 2).pixels, std::vector<std::uint8_t>(12, byte));
  }
}

TEST(LinearImage, HalfBlackHalfWhiteIsHalfTheLight)
{
  Picture stripes{ 2, 1, { 0, 0, 0, 255, 255, 255 } };
  const auto half = static_cast<std::uint8_t>(std::lround(255.0 * std::pow(0.5, 1.0 / 2.2)));
  EXPECT_EQ(averagedDown(stripes, 1, 1).pixels, std::vector<std::uint8_t>(3, half));
}

TEST(LinearImage, LightIsKeptAtAnySize)
{
  const Picture source = scattered(97, 61);
  for (const auto& [width, height] : { std::pair{ 97, 61 }, { 48, 30 }, { 40, 61 }, { 7, 5 } })
  {
    EXPECT_NEAR(light(averagedDown(source, width, height)), light(source), 0.001)
      << width << "x" << height;
  }
}

TEST(LinearImage, EnlargingIsRefused)
{
  EXPECT_THROW(averagedDown(scattered(4, 4), 5, 4), std::invalid_argument);
  EXPECT_THROW(averagedDown(scattered(4, 4), 0, 4), std::invalid_argument);
}

TEST(LinearImage, ContactFramesAreSpreadEvenly)
{
  EXPECT_EQ(contactFrames(3), (std::vector<int>{ 0, 1, 2 }));
  const std::vector<int> frames = contactFrames(96);
  ASSERT_EQ(frames.size(), std::size_t(ContactPictures));
  for (int i = 0; i < ContactPictures; ++i)
  {
    EXPECT_EQ(frames[i], 8 * i);
  }
}

TEST(LinearImage, ContactSheetReadsFromTheTopLeft)
{
  const auto plain = [](std::uint8_t value) {
    return Picture{ 2, 2, std::vector<std::uint8_t>(12, value) };
  };
  const Picture sheet = contactSheet({ plain(10), plain(20), plain(30), plain(40), plain(50) });
  std::vector<std::uint8_t> seen;
  for (int y = sheet.height - 1; y >= 0; --y)
  {
    for (int x = 0; x < sheet.width; ++x)
    {
      const std::uint8_t value = sheet.pixels[(std::size_t(y) * sheet.width + x) * 3];
      if (value != 255 && (seen.empty() || seen.back() < value))
      {
        seen.push_back(value);
      }
    }
  }
  EXPECT_EQ(seen, (std::vector<std::uint8_t>{ 10, 20, 30, 40, 50 }));
  EXPECT_THROW(contactSheet({}), std::invalid_argument);
}

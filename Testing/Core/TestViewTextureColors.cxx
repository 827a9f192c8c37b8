// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/ViewTextureColors.h"

#include <gtest/gtest.h>

using namespace hachure;

namespace
{
// Two nodes of four directions a side.
ViewTextureColors twoNodes()
{
  ViewTextureColors colors;
  colors.hemisphere = 4;
  colors.independent = { { 200, 100, 0, 255 }, { 255, 255, 255, 0 } };
  colors.dependent.assign(32, glm::u8vec4(0));
  return colors;
}
} // namespace

TEST(ViewTextureColors, WhatNobodyKnowsIsGrey)
{
  ViewTextureColors colors = twoNodes();
  colors.independent.emplace_back(255, 255, 255, 128);
  paintUnknown(colors);
  EXPECT_EQ(colors.independent[0], glm::u8vec4(200, 100, 0, 255));
  EXPECT_EQ(colors.independent[1], glm::u8vec4(128, 128, 128, 255));
  // Half white, half grey in linear light: .608.
  EXPECT_NEAR(colors.independent[2].r, 204, 1);
}

TEST(ViewTextureColors, TheBaseIsBelowWhatIsSeenFromSomewhere)
{
  ViewTextureColors colors = twoNodes();
  paintUnknown(colors);
  colors.dependent[0] = { 10, 20, 30, 255 }; // all
  // Half of white: linear .5 is 188 of sRGB.
  colors.dependent[1] = { 188, 188, 188, 128 };
  paintBelow(colors);
  EXPECT_TRUE(colors.independent.empty());
  EXPECT_EQ(colors.dependent[0], glm::u8vec4(10, 20, 30, 255));
  EXPECT_EQ(colors.dependent[2], glm::u8vec4(200, 100, 0, 255)); // nothing
  EXPECT_EQ(colors.dependent[16], glm::u8vec4(128, 128, 128, 255));
  // .5 and half of 200's .578: .789 is 229.
  EXPECT_NEAR(colors.dependent[1].r, 229, 2);
  EXPECT_NEAR(colors.dependent[1].b, 188, 2);
}

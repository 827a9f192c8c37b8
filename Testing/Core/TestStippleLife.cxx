// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StippleLife.h"

#include "CallTests.h"
#include "StippleScene.h"

using namespace hachure;

namespace
{

LivingStipples livingOn(const Surface& surface, std::int64_t count)
{
  StippleOptions options;
  options.count = count;
  LivingStipples living;
  living.hierarchy = stippleSurface(surface.mesh(), options);
  return living;
}

LivingStipples carried(
  const Surface& from, const LivingStipples& before, const Surface& to, int life)
{
  StippleOptions options;
  options.count = static_cast<std::int64_t>(before.hierarchy.points.size());
  return carryLiving(from.mesh(), before, to.mesh(), life, options, 0.05);
}

// Of all stipples, those that leave too.
double totalShare(const LivingStipples& living)
{
  double sum = 0.0;
  for (const float share : living.shares)
  {
    sum += static_cast<double>(share);
  }
  for (const float share : living.leavingShares)
  {
    sum += static_cast<double>(share);
  }
  return sum;
}

Surface grown(const Surface& surface, double factor)
{
  Surface result = surface;
  for (glm::dvec3& point : result.points)
  {
    point *= factor;
  }
  return result;
}

} // namespace

TEST(StippleLife, WhatComesGrowsAndWhatGoesShrinks)
{
  const Surface first = unitSphere(12);
  const LivingStipples before = livingOn(first, 1500);
  Surface surface = first;
  LivingStipples living = before;
  for (int change = 1; change <= 6; ++change)
  {
    const Surface next = grown(unitSphere(12 + change % 3), 1.0 + 0.01 * change);
    const LivingStipples after = carried(surface, living, next, 4);
    ASSERT_EQ(after.shares.size(), after.hierarchy.points.size());
    ASSERT_EQ(after.leaving.size(), after.leavingShares.size());
    // The ink stays: what is lost of those that go has those that come.
    EXPECT_NEAR(totalShare(after), 1500.0, 120.0) << change;
    surface = next;
    living = after;
  }
  std::size_t young = 0;
  for (const float share : living.shares)
  {
    EXPECT_GT(share, 0.0f);
    EXPECT_LE(share, 1.0f);
    young += share < 1.0f ? 1 : 0;
  }
  EXPECT_LT(young, 600u);
  EXPECT_FALSE(living.leaving.empty());
  for (std::size_t i = 0; i < living.leaving.size(); ++i)
  {
    EXPECT_LT(living.leavingShares[i], 1.0f);
    EXPECT_GT(living.leavingDensities[i], 0.0);
    EXPECT_NEAR(glm::length(stipplePosition(surface.mesh(), living.leaving[i])), 1.06, 0.02);
  }
}

TEST(StippleLife, OfOneChangeNothingIsLeft)
{
  const Surface sphere = unitSphere(12);
  const LivingStipples living =
    carried(sphere, livingOn(sphere, 800), grown(unitSphere(13), 1.02), 1);
  EXPECT_TRUE(living.leaving.empty());
  for (const float share : living.shares)
  {
    EXPECT_EQ(share, 1.0f);
  }
}

TEST(StippleLife, NothingBeforeAndNothingAfter)
{
  const Surface sphere = unitSphere(8), nothing;
  StippleOptions options;
  options.count = 500;
  const LivingStipples begun = carryLiving(nothing.mesh(), {}, sphere.mesh(), 8, options, 0.0);
  EXPECT_FALSE(begun.hierarchy.points.empty());
  EXPECT_EQ(*std::min_element(begun.shares.begin(), begun.shares.end()), 1.0f);
  const LivingStipples ended = carried(sphere, livingOn(sphere, 500), nothing, 8);
  EXPECT_TRUE(ended.hierarchy.points.empty());
  EXPECT_TRUE(ended.leaving.empty());
}

TEST(StippleLife, WrongLivesAreRefused)
{
  const Surface sphere = unitSphere(4);
  EXPECT_NE(messageOf([&] { carried(sphere, livingOn(sphere, 50), sphere, 0); }).find("life: 0"),
    std::string::npos);
}

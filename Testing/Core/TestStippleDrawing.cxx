// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "StippleScene.h"

#include "StippleCanvas.h"
#include "StippleDrawing.h"
#include "StippleTone.h"

#include <glm/gtc/matrix_transform.hpp>

#include <map>
#include <memory>

using namespace hachure;

namespace
{

constexpr int side = 360; // pixels of the picture

// A plane from 0 to 1 that is looked at from straight above, `pixels` wide, turned away by an
// angle.
struct PlanePicture
{
  explicit PlanePicture(std::int64_t count)
    : plane(unitPlane(1))
  {
    StippleOptions options;
    options.count = count;
    hierarchy = stippleSurface(plane.mesh(), options);
    tree = std::make_unique<StippleTree>(plane.mesh(), hierarchy);
  }

  static StippleScene scene(double pixels, double tilt, float tone)
  {
    StippleScene scene;
    const glm::dmat4 center = glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5, -0.5, 0.0));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), tilt, glm::dvec3(1.0, 0.0, 0.0));
    const double half = 0.5 * side / pixels;
    scene.view.modelToClip = glm::ortho(-half, half, -half, half, -2.0, 2.0) * turn * center;
    scene.view.viewportSize = glm::dvec2(side);
    scene.rectangle = { 0, 0, side, side };
    scene.toneOf.fill(tone);
    return scene;
  }

  std::vector<DrawnStipple> draw(const StippleScene& scene, const StippleLook& look) const
  {
    std::vector<DrawnStipple> drawn;
    drawStipples(*tree, StippleDrawing(scene, look), false, drawn);
    return drawn;
  }

  Surface plane;
  StippleHierarchy hierarchy;
  std::unique_ptr<StippleTree> tree;
};

// Of the middle of the picture, which a plane of `height` pixels fills.
double inkOf(const std::vector<DrawnStipple>& drawn, double height)
{
  std::vector<StippleDisc> discs;
  discs.reserve(drawn.size());
  for (const DrawnStipple& stipple : drawn)
  {
    discs.push_back(stipple.disc);
  }
  StippleCanvas canvas;
  std::vector<std::uint8_t> covered;
  canvas.draw(discs, side, side, covered);
  const int columns = side / 2 - 20,
            rows = static_cast<int>(0.5 * std::min<double>(side, height)) - 15;
  double sum = 0.0;
  for (int row = side / 2 - rows; row < side / 2 + rows; ++row)
  {
    for (int column = side / 2 - columns; column < side / 2 + columns; ++column)
    {
      sum += covered[static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column)];
    }
  }
  return sum / (4.0 * rows * columns * StippleCanvas::samplesPerPixel);
}

// Of a plane of `pixels` in the middle, all of it.
double inkWithin(const std::vector<DrawnStipple>& drawn, double pixels)
{
  double sum = 0.0;
  std::vector<StippleDisc> discs;
  discs.reserve(drawn.size());
  for (const DrawnStipple& stipple : drawn)
  {
    discs.push_back(stipple.disc);
  }
  StippleCanvas canvas;
  std::vector<std::uint8_t> covered;
  canvas.draw(discs, side, side, covered);
  for (const std::uint8_t places : covered)
  {
    sum += places;
  }
  return sum / (pixels * pixels * StippleCanvas::samplesPerPixel);
}

const PlanePicture& manyStipples()
{
  static const PlanePicture picture(40000);
  return picture;
}

} // namespace

TEST(StippleDrawing, InkIsTheTone)
{
  for (const bool bySize : { false, true })
  {
    for (const float diameter : { 1.7f, 2.4f, 6.0f })
    {
      for (const float tone : { 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f })
      {
        StippleLook look;
        look.diameter = diameter;
        look.toneBySize = bySize;
        const auto drawn = manyStipples().draw(PlanePicture::scene(side, 0.0, tone), look);
        EXPECT_NEAR(inkOf(drawn, side), tone, 0.012) << diameter << " by size: " << bySize;
      }
    }
  }
}

TEST(StippleDrawing, InkIsTheToneOfTiltedSurfaces)
{
  for (const double facing : { 0.8, 0.5, 0.25 })
  {
    for (const float tone : { 0.1f, 0.3f, 0.6f, 0.85f })
    {
      const auto drawn =
        manyStipples().draw(PlanePicture::scene(side, std::acos(facing), tone), StippleLook());
      EXPECT_NEAR(inkOf(drawn, side * facing), tone, 0.015) << facing;
    }
  }
}

TEST(StippleDrawing, InkIsTheToneForAnyGrowth)
{
  for (const float growth : { 0.05f, 0.5f, 1.0f })
  {
    StippleLook look;
    look.growth = growth;
    const auto drawn = manyStipples().draw(PlanePicture::scene(side, 0.0, 0.6f), look);
    EXPECT_NEAR(inkOf(drawn, side), 0.6, 0.015) << growth;
  }
}

TEST(StippleDrawing, WhereStipplesRunOutTheyGrow)
{
  const PlanePicture few(3000);
  for (const float tone : { 0.2f, 0.5f, 0.8f })
  {
    const auto drawn = few.draw(PlanePicture::scene(side, 0.0, tone), StippleLook());
    EXPECT_NEAR(inkOf(drawn, side), tone, 0.02);
  }
}

TEST(StippleDrawing, InkIsTheToneAtAnyZoom)
{
  PlanePicture picture(1000);
  for (const double zoom : { 0.125, 0.5, 4.0, 64.0 })
  {
    for (const float tone : { 0.05f, 0.4f, 0.9f })
    {
      const double pixels = 300.0 * zoom;
      const StippleScene scene = PlanePicture::scene(pixels, 0.0, tone);
      std::vector<DrawnStipple> drawn;
      EXPECT_TRUE(drawStipples(*picture.tree, StippleDrawing(scene, {}), true, drawn));
      // A plane of few pixels is seen as a whole, where its ends would be.
      const double ink = pixels < 200.0 ? inkWithin(drawn, pixels) : inkOf(drawn, pixels);
      EXPECT_NEAR(ink, tone, 0.02) << zoom;
    }
  }
}

TEST(StippleDrawing, PicturesDoNotDependOnThoseBefore)
{
  const auto draw = [](PlanePicture& picture, double pixels)
  {
    std::map<std::uint64_t, float> radii;
    std::vector<DrawnStipple> drawn;
    const StippleScene scene = PlanePicture::scene(pixels, 0.4, 0.4f);
    drawStipples(*picture.tree, StippleDrawing(scene, {}), true, drawn);
    for (const DrawnStipple& stipple : drawn)
    {
      radii[picture.tree->identity(stipple.node, stipple.index)] = stipple.disc.radius;
    }
    return radii;
  };
  PlanePicture first(1000), second(1000);
  const auto near = draw(first, 4000.0);
  draw(second, 900.0);
  draw(second, 9000.0);
  EXPECT_EQ(draw(second, 4000.0), near);
}

TEST(StippleDrawing, WhereTheBudgetEndsStipplesGrow)
{
  PlanePicture picture(1000);
  picture.tree->setBudget(1500000);
  const StippleScene scene = PlanePicture::scene(3000.0, 0.0, 0.5f);
  std::vector<DrawnStipple> drawn;
  EXPECT_FALSE(drawStipples(*picture.tree, StippleDrawing(scene, {}), true, drawn));
  EXPECT_LE(picture.tree->refinedMemory(), 1505000u);
  EXPECT_NEAR(inkOf(drawn, side), 0.5, 0.03);
  // What another view has spent is at hand again.
  const StippleScene modest = PlanePicture::scene(400.0, 0.0, 0.1f);
  EXPECT_TRUE(drawStipples(*picture.tree, StippleDrawing(modest, {}), true, drawn));
  EXPECT_NEAR(inkOf(drawn, side), 0.1, 0.02);
}

TEST(StippleDrawing, ZoomingInAndDarkeningOnlyAdd)
{
  const StippleLook look;
  std::map<std::uint64_t, float> before;
  for (int step = 0; step < 12; ++step)
  {
    const float tone = 0.2f + 0.02f * static_cast<float>(step);
    const double pixels = 200.0 * std::pow(1.03, step);
    const auto drawn = manyStipples().draw(PlanePicture::scene(pixels, 0.0, tone), look);
    std::map<std::uint64_t, float> radii;
    for (const DrawnStipple& stipple : drawn)
    {
      radii[manyStipples().tree->identity(stipple.node, stipple.index)] = stipple.disc.radius;
    }
    for (const auto& old : before)
    {
      ASSERT_EQ(radii.count(old.first), 1u);
      EXPECT_GE(radii[old.first], old.second - 1e-4f);
    }
    EXPECT_GT(radii.size(), before.size());
    before = radii;
  }
}

TEST(StippleDrawing, StipplesStayOnTheirSurface)
{
  const StippleScene scene = PlanePicture::scene(431.0, 0.7, 0.3f);
  for (const DrawnStipple& stipple : manyStipples().draw(scene, StippleLook()))
  {
    const glm::dvec3 place = stipplePosition(manyStipples().plane.mesh(),
      manyStipples().hierarchy.points[manyStipples().tree->identity(stipple.node, stipple.index)]);
    const glm::dvec4 clip = scene.view.modelToClip * glm::dvec4(place, 1.0);
    EXPECT_NEAR(stipple.disc.x, (0.5 * clip.x / clip.w + 0.5) * side, 1e-3);
    EXPECT_NEAR(stipple.disc.y, (0.5 * clip.y / clip.w + 0.5) * side, 1e-3);
  }
}

TEST(StippleDrawing, HiddenStipplesAreNotDrawn)
{
  StippleScene scene = PlanePicture::scene(side, 0.0, 0.4f);
  std::vector<float> depth(static_cast<std::size_t>(side) * side, 0.5f); // of the plane
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    depth[i] = i % side < side / 2 ? 0.4f : 0.5f; // something is in front of its left half
  }
  scene.depth = depth;
  const auto drawn = manyStipples().draw(scene, StippleLook());
  EXPECT_GT(drawn.size(), 1000u);
  for (const DrawnStipple& stipple : drawn)
  {
    EXPECT_GT(stipple.disc.x, 0.5f * side - 0.5f);
    // Beyond half a pixel from the edge nothing has shrunk.
    const bool near = stipple.disc.x < 0.5f * side + 0.5f;
    EXPECT_LE(
      stipple.disc.radius, near ? 1.2f * (stipple.disc.x - 0.5f * side + 0.5f) + 1e-4f : 1.2f);
  }
}

TEST(StippleDrawing, BackOfAThinSheetIsHidden)
{
  // The depth of something half a pixel before the plane.
  StippleScene scene = PlanePicture::scene(side, 0.0, 0.4f);
  scene.depthPerPixel = 1.0f / (4.0f * side);
  const std::vector<float> depth(
    static_cast<std::size_t>(side) * side, 0.5f - 0.5f * scene.depthPerPixel);
  scene.depth = depth;
  EXPECT_GT(manyStipples().draw(scene, StippleLook()).size(), 1000u);
  scene.view.modelToClip = PlanePicture::scene(side, 3.14159265, 0.4f).view.modelToClip;
  EXPECT_TRUE(manyStipples().draw(scene, StippleLook()).empty());
  // And for an eye.
  for (const double height : { 2.0, -2.0 })
  {
    scene.view.modelToClip = glm::perspective(0.5, 1.0, 1.0, 3.0) *
      glm::lookAt(
        glm::dvec3(0.5, 0.5, height), glm::dvec3(0.5, 0.5, 0.0), glm::dvec3(0.0, 1.0, 0.0));
    const std::vector<float> nearer(depth.size(), 0.75f - 0.5f * scene.depthPerPixel);
    scene.depth = nearer;
    EXPECT_EQ(manyStipples().draw(scene, StippleLook()).empty(), height < 0.0);
  }
}

TEST(StippleDrawing, NothingWantsMoreThanTheBound)
{
  const StippleScene scene = PlanePicture::scene(side, 0.6, 0.7f);
  const StippleLook look;
  const StippleDrawing drawing(scene, look);
  const auto around = [](double x)
  {
    StippleBounds bounds;
    bounds.low = { x - 0.5, 0.0, 0.0 };
    bounds.high = { x + 0.5, 1.0, 0.0 };
    bounds.radius = 0.75;
    return bounds;
  };
  const double most = drawing.mostWanted(around(0.5));
  const double facing = std::cos(0.6);
  const double wanted = stippleCrowd(0.7f, static_cast<float>(facing), look.growth) * facing *
    side * side / (look.diameter * look.diameter);
  EXPECT_GE(most, wanted);
  EXPECT_LT(most, 2.0 * wanted);
  EXPECT_EQ(drawing.mostWanted(around(5.0)), 0.0);
  // All normals are known to be those of the plane.
  StippleBounds plane = around(0.5);
  plane.axis = { 0.0f, 0.0f, 1.0f };
  plane.cosine = 1.0f;
  EXPECT_GE(drawing.mostWanted(plane), wanted);
  EXPECT_LT(drawing.mostWanted(plane), 1.1 * wanted);
}

TEST(StippleDrawing, WhatIsHiddenWantsNothing)
{
  StippleScene scene = PlanePicture::scene(side, 0.0, 0.4f);
  scene.depthPerPixel = 1.0f / (4.0f * side);
  std::vector<float> depth(static_cast<std::size_t>(side) * side, 0.4f); // before the plane
  scene.depth = depth;
  EXPECT_TRUE(manyStipples().draw(scene, StippleLook()).empty());
  const StippleDrawing drawing(scene, {});
  EXPECT_EQ(drawing.mostWanted(manyStipples().tree->nodes().back().bounds), 0.0);
  std::fill(depth.begin(), depth.end(), 0.5f);
  const StippleDrawing other(scene, {});
  EXPECT_GT(other.mostWanted(manyStipples().tree->nodes().back().bounds), 0.0);
}

TEST(StippleDrawing, WrongScenesAreRefused)
{
  const auto refusal = [](StippleScene scene, StippleLook look)
  { return messageOf([&] { StippleDrawing(scene, look); }); };
  const StippleScene good = PlanePicture::scene(side, 0.0, 0.4f);
  StippleLook look;
  look.diameter = 0.0f;
  EXPECT_NE(refusal(good, look).find("look.diameter is 0"), std::string::npos);
  look = StippleLook();
  look.growth = -1.0f;
  EXPECT_NE(refusal(good, look).find("look.growth is -1"), std::string::npos);
  StippleScene scene = good;
  const std::vector<float> depth(7, 1.0f);
  scene.depth = depth;
  EXPECT_NE(refusal(scene, {}).find("scene.depth.size() is 7"), std::string::npos);
  scene = good;
  const std::vector<std::uint8_t> tones(7, 1);
  scene.tones = tones;
  EXPECT_NE(refusal(scene, {}).find("scene.tones.size() is 7"), std::string::npos);
  scene = good;
  scene.view.modelToClip[1][1] = std::nan("");
  EXPECT_NE(refusal(scene, {}).find("modelToClip"), std::string::npos);
}

TEST(StippleCanvas, DiscsCoverTheirArea)
{
  StippleCanvas canvas;
  std::vector<std::uint8_t> covered;
  constexpr double pi = 3.14159265358979;
  for (const float radius : { 0.3f, 1.2f, 7.0f, 40.0f })
  {
    double sum = 0.0;
    for (int i = 0; i < 50; ++i)
    {
      const auto step = static_cast<float>(i);
      canvas.draw(
        std::vector<StippleDisc>{ { 50.0f + 0.137f * step, 50.0f + 0.073f * step, radius } }, 110,
        103, covered);
      for (const std::uint8_t places : covered)
      {
        ASSERT_LE(places, StippleCanvas::samplesPerPixel);
        sum += places;
      }
    }
    sum /= 50.0 * StippleCanvas::samplesPerPixel;
    EXPECT_NEAR(sum, pi * radius * radius, 0.01 * pi * radius * radius) << radius;
  }
}

TEST(StippleCanvas, OverlapsCountOnceAndOddDiscsDoNothing)
{
  StippleCanvas canvas;
  std::vector<std::uint8_t> one, two;
  const StippleDisc disc = { 10.3f, 11.1f, 4.0f };
  canvas.draw(std::vector<StippleDisc>{ disc }, 33, 20, one);
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<StippleDisc> more = { disc, disc, { 10.3f, 11.1f, 3.0f },
    { std::nanf(""), 3.0f, 2.0f }, { 3.0f, infinite, 2.0f }, { 3.0f, 3.0f, 0.0f },
    { 3.0f, 3.0f, -1.0f }, { -1e9f, 5.0f, 2.0f }, { 5.0f, 1e9f, 2.0f } };
  canvas.draw(more, 33, 20, two);
  EXPECT_EQ(one, two);
  canvas.draw(std::vector<StippleDisc>{ { 0.0f, 0.0f, 1e6f } }, 33, 20, two);
  EXPECT_EQ(two, std::vector<std::uint8_t>(33u * 20u, 64));
  canvas.draw(more, 0, 0, two);
  EXPECT_TRUE(two.empty());
}

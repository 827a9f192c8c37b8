// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourScene.h"

#include <gtest/gtest.h>

namespace
{

using namespace hachure;

constexpr double pictureSize = 400.0;
const glm::dvec2 middle(0.5 * pictureSize);

// Radius in the picture of a sphere's outline around the middle.
double outlineRadius(double radius, double distance, double halfAngle = 0.3)
{
  const double tangent = radius / std::sqrt(distance * distance - radius * radius);
  return 0.5 * pictureSize * tangent / std::tan(halfAngle);
}

void expectCircle(const ContourLine& line, const glm::dvec2& center, double radius, double error)
{
  for (const glm::dvec2& point : line.points)
  {
    ASSERT_NEAR(glm::distance(point, center), radius, error);
  }
}

TEST(ContourLines, SphereIsOneCircle)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  const double radius = outlineRadius(1.0, 6.0);
  for (const double angle : { 0.0, 0.3, 1.1 })
  {
    const Surface surface = turned(sphere(24), angle, { 1.0, 2.0, 3.0 });
    const DepthPicture picture = DepthPicture(view).draw(surface);
    const auto lines = contourLines(surface.mesh(), view, picture.depth());
    ASSERT_EQ(lines.size(), 1u) << angle;
    EXPECT_TRUE(lines[0].closed);
    expectCircle(lines[0], middle, radius, 0.5);
    EXPECT_NEAR(lengthOf(lines) / (fullCircle * radius), 1.0, 0.01);
  }
}

TEST(ContourLines, MeshEdgesZigzagAroundSphere)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  const double radius = outlineRadius(1.0, 6.0);
  ContourOptions options;
  options.smooth = false;
  const Surface surface = turned(sphere(24), 0.3, { 1.0, 2.0, 3.0 });
  const auto lines = contourLines(surface.mesh(), view, {}, options);
  ASSERT_FALSE(lines.empty());
  for (const ContourLine& line : lines)
  {
    expectCircle(line, middle, radius, 1.0);
  }
  // Diagonals of its quads may be hollows, in which lines are hidden.
  const DepthPicture picture = DepthPicture(view).draw(surface);
  EXPECT_NEAR(
    lengthOf(contourLines(surface.mesh(), view, picture.depth(), options)) / (fullCircle * radius),
    1.0, 0.1);
}

TEST(ContourLines, ParallelViewOfSphere)
{
  const ViewProjection view = parallelView(1.25, pictureSize);
  const Surface surface = turned(sphere(24), 0.2, { 1.0, 0.0, 0.0 });
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto lines = contourLines(surface.mesh(), view, picture.depth());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  expectCircle(lines[0], middle, pictureSize / 2.5, 0.5);
}

TEST(ContourLines, CoarseSphereIsSeenAllAround)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  for (const int n : { 3, 5, 8 })
  {
    const Surface surface = turned(sphere(n), 0.4, { 3.0, 1.0, 2.0 });
    const DepthPicture picture = DepthPicture(view).draw(surface);
    const auto lines = contourLines(surface.mesh(), view, picture.depth());
    ASSERT_EQ(lines.size(), 1u) << n;
    EXPECT_TRUE(lines[0].closed) << n;
  }
}

TEST(ContourLines, HiddenArcIsMissing)
{
  // The circles of two spheres meet at right angles or nearly so.
  const ViewProjection view = parallelView(2.0, pictureSize);
  const Surface nearer = sphere(32, 1.0, { -0.5, 0.0, 1.2 });
  const Surface farther = sphere(32, 0.8, { 0.6, 0.0, -1.2 });
  const DepthPicture picture = DepthPicture(view).draw(nearer).draw(farther);
  const auto front = contourLines(nearer.mesh(), view, picture.depth());
  ASSERT_EQ(front.size(), 1u);
  EXPECT_TRUE(front[0].closed);

  const auto lines = contourLines(farther.mesh(), view, picture.depth());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  const double scale = 0.25 * pictureSize;
  const glm::dvec2 center = middle + scale * glm::dvec2(0.6, 0.0);
  const glm::dvec2 hider = middle + scale * glm::dvec2(-0.5, 0.0);
  expectCircle(lines[0], center, 0.8 * scale, 0.5);
  for (const glm::dvec2& point : lines[0].points)
  {
    EXPECT_GT(glm::distance(point, hider), scale - 1.0);
  }
  // It ends where the nearer sphere begins.
  EXPECT_NEAR(glm::distance(lines[0].points.front(), hider), scale, 1.5);
  EXPECT_NEAR(glm::distance(lines[0].points.back(), hider), scale, 1.5);
  const double half = std::acos((1.0 - 1.1 * 1.1 - 0.8 * 0.8) / (2.0 * 1.1 * 0.8));
  EXPECT_NEAR(lengthOf(lines), 2.0 * half * 0.8 * scale, 3.0);
}

TEST(ContourLines, NothingHidesWithoutDepth)
{
  const ViewProjection view = parallelView(2.0, pictureSize);
  const Surface surface = torus(1.0, 0.4, 96, 48);
  // Seen along its axis: two circles. Depth hides neither.
  const auto lines = contourLines(surface.mesh(), view);
  ASSERT_EQ(lines.size(), 2u);
  const double scale = 0.25 * pictureSize;
  for (const ContourLine& line : lines)
  {
    EXPECT_TRUE(line.closed);
    const bool outer = glm::distance(line.points[0], middle) > scale;
    expectCircle(line, middle, (outer ? 1.4 : 0.6) * scale, 0.5);
  }
}

TEST(ContourLines, TorusHidesItsOwnFolds)
{
  // From the side, the far rim of the hole is seen through it, and the near rim is hidden at its
  // ends.
  const ViewProjection view = perspectiveView(8.0, pictureSize, 0.2);
  const Surface surface = turned(torus(1.0, 0.4, 160, 80), 1.1, { 1.0, 0.0, 0.0 });
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto all = contourLines(surface.mesh(), view);
  const auto seen = contourLines(surface.mesh(), view, picture.depth());
  std::size_t closed = 0;
  for (const ContourLine& line : seen)
  {
    closed += line.closed ? 1 : 0;
  }
  EXPECT_EQ(closed, 1u);      // the outline
  EXPECT_EQ(seen.size(), 3u); // and two arcs of the hole
  EXPECT_LT(lengthOf(seen), 0.95 * lengthOf(all));
}

TEST(ContourLines, CubeHasHexagonAndCreases)
{
  const ViewProjection view = parallelView(2.0, pictureSize);
  // Along a diagonal of space.
  const Surface surface =
    turned(turned(cube(5), 0.785398163397, { 0, 1, 0 }), 0.615479708670, { 1, 0, 0 });
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const double side = std::sqrt(8.0 / 3.0) * 0.25 * pictureSize;
  for (const bool smooth : { true, false })
  {
    ContourOptions options;
    options.smooth = smooth;
    const auto lines = contourLines(surface.mesh(), view, picture.depth(), options);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].closed);
    EXPECT_NEAR(lengthOf(lines), 6.0 * side, 0.1);

    options.creases = true;
    const auto creases = contourLines(surface.mesh(), view, picture.depth(), options);
    EXPECT_NEAR(lengthOf(creases), 9.0 * side, 4.0);

    options.creaseAngle = 100.0;
    if (!smooth)
    {
      const auto blunt = contourLines(surface.mesh(), view, picture.depth(), options);
      EXPECT_NEAR(lengthOf(blunt), 6.0 * side, 0.1);
    }
  }
}

TEST(ContourLines, PlaneHasItsBorder)
{
  const ViewProjection view = parallelView(2.0, pictureSize);
  Surface surface;
  addGrid(surface, { -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 4);
  surface = turned(surface, 0.5, { 0, 1, 0 });
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto lines = contourLines(surface.mesh(), view, picture.depth());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_NEAR(lengthOf(lines), pictureSize * (1.0 + std::cos(0.5)), 0.1);

  ContourOptions options;
  options.borders = false;
  EXPECT_TRUE(contourLines(surface.mesh(), view, picture.depth(), options).empty());
}

TEST(ContourLines, BowlSeenFromInside)
{
  // The same sheet with either side as its outside has the same contours.
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  Surface surface = sphere(24);
  surface.triangles.erase(std::remove_if(surface.triangles.begin(), surface.triangles.end(),
                            [&](const glm::ivec3& t) { return surface.points[t.x].z < -0.4; }),
    surface.triangles.end());
  surface.patches.clear();
  surface = turned(surface, 1.2, { 1, 0, 0 });
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto lines = contourLines(surface.mesh(), view, picture.depth());
  for (glm::ivec3& corners : surface.triangles)
  {
    std::swap(corners.y, corners.z);
  }
  const auto inside = contourLines(surface.mesh(), view, picture.depth());
  ASSERT_FALSE(lines.empty());
  EXPECT_NEAR(lengthOf(inside), lengthOf(lines), 3.0);
}

// The border of a square, behind a fence of columns that hide everything.
std::vector<ContourLine> behindFence(int firstColumn, int columns, bool hidesOthers)
{
  const ViewProjection view = parallelView(2.0, pictureSize);
  Surface surface;
  addGrid(surface, { -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 1);
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto width = static_cast<int>(pictureSize);
  std::vector<float> values(picture.depth().values.begin(), picture.depth().values.end());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const int column = static_cast<int>(i) % width;
    const bool inside = column >= firstColumn && column < firstColumn + columns;
    values[i] = inside != hidesOthers ? 0.0f : values[i];
  }
  return contourLines(surface.mesh(), view, { { 0, 0, width, width }, values });
}

TEST(ContourLines, ShortGapsAndRemaindersAreMended)
{
  const double whole = 2.0 * pictureSize;
  const auto mended = behindFence(200, 1, false);
  ASSERT_EQ(mended.size(), 1u);
  EXPECT_TRUE(mended[0].closed);
  EXPECT_NEAR(lengthOf(mended), whole, 0.1);
  const auto cut = behindFence(200, 6, false);
  EXPECT_EQ(cut.size(), 2u);
  EXPECT_NEAR(lengthOf(cut), whole - 2.0 * 6.0, 2.0);

  EXPECT_TRUE(behindFence(200, 1, true).empty());
  const auto left = behindFence(200, 6, true);
  EXPECT_EQ(left.size(), 2u);
  EXPECT_NEAR(lengthOf(left), 2.0 * 6.0, 2.0);
}

TEST(ContourLines, FanOfThreeSheets)
{
  // A flat sheet with a fin under it: a silhouette where the fin's outer side is turned away.
  const ViewProjection view = parallelView(2.0, pictureSize);
  ContourOptions options;
  options.borders = false;
  for (const bool turnedAway : { false, true })
  {
    Surface surface;
    addGrid(surface, { 0, -1, 0 }, { 1, 0, -0.2 }, { 0, 2, 0 }, 2);
    addGrid(surface, { -1, -1, 0 }, { 1, 0, 0 }, { 0, 2, 0 }, 2);
    if (turnedAway)
    {
      addGrid(surface, { 0, -1, 0 }, { 0, 2, 0 }, { 0.2, 0, -1 }, 2);
    }
    else
    {
      addGrid(surface, { 0, -1, 0 }, { 0.2, 0, -1 }, { 0, 2, 0 }, 2);
    }
    for (const bool smooth : { true, false })
    {
      options.smooth = smooth;
      EXPECT_NEAR(lengthOf(contourLines(surface.mesh(), view, {}, options)),
        turnedAway ? 0.5 * pictureSize : 0.0, 0.1);
    }
  }
}

TEST(ContourLines, ClippedAtViewportAndEye)
{
  // A tunnel around the eye: most of it is behind, none of it is drawn outside of the viewport.
  const ViewProjection view = perspectiveView(5.0, pictureSize, 0.8);
  Surface tunnel;
  addGrid(tunnel, { -1, -1, -20 }, { 2, 0, 0 }, { 0, 0, 40 }, 3);
  ContourOptions options;
  const auto lines = contourLines(tunnel.mesh(), view, {}, options);
  for (const ContourLine& line : lines)
  {
    for (const glm::dvec2& point : line.points)
    {
      EXPECT_TRUE(point.x > -1e-6 && point.y > -1e-6 && point.x < pictureSize + 1e-6 &&
        point.y < pictureSize + 1e-6)
        << point.x << " " << point.y;
    }
  }
  // The far end is beyond the clipping range: two lines that run towards the eye are left.
  EXPECT_LE(lines.size(), 2u);

  Surface behind = sphere(8, 0.2, { 0, 0, 7 });
  EXPECT_TRUE(contourLines(behind.mesh(), view).empty());
  Surface cut = sphere(16, 1.0, { 0.6, 0.0, 0.0 });
  const ViewProjection part = parallelView(1.0, pictureSize);
  const auto open = contourLines(cut.mesh(), part);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_FALSE(open[0].closed);
  EXPECT_NEAR(open[0].points.front().x, pictureSize, 1e-6);
  EXPECT_NEAR(open[0].points.back().x, pictureSize, 1e-6);
}

} // namespace

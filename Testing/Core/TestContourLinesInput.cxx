// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourScene.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using namespace hachure;

constexpr double pictureSize = 200.0;

bool equal(const std::vector<ContourLine>& a, const std::vector<ContourLine>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](const ContourLine& first, const ContourLine& second)
      { return first.closed == second.closed && first.points == second.points; });
}

TEST(ContourLinesInput, EmptyMesh)
{
  EXPECT_TRUE(contourLines({}, parallelView(2.0, pictureSize)).empty());
}

TEST(ContourLinesInput, OneTriangle)
{
  Surface surface;
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  surface.triangles = { { 0, 1, 2 } };
  const ViewProjection view = parallelView(2.0, pictureSize);
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto lines = contourLines(surface.mesh(), view, picture.depth());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].points.size(), 3u);
  EXPECT_NEAR(lengthOf(lines), (2.0 + std::sqrt(2.0)) * 0.25 * pictureSize, 1e-6);
}

TEST(ContourLinesInput, WhatHasNoAreaOrPlaceIsLeftOut)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  Surface surface = sphere(12);
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto clean = contourLines(surface.mesh(), view, picture.depth());
  const auto count = static_cast<int>(surface.triangles.size());
  for (int i = 0; i < count; i += 7)
  {
    const glm::ivec3 corners = surface.triangles[i];
    surface.triangles.push_back(corners);                            // again
    surface.triangles.emplace_back(corners.z, corners.y, corners.x); // turned over
    surface.triangles.emplace_back(corners.x, corners.y, corners.y); // no area
    surface.triangles.emplace_back(corners.x, corners.y, static_cast<int>(surface.points.size()));
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  surface.points.emplace_back(0.0, none, 0.0);
  EXPECT_TRUE(
    equal(clean, contourLines({ surface.points, surface.triangles, {} }, view, picture.depth())));
}

TEST(ContourLinesInput, TrianglesOfAnyOrientation)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  Surface surface = sphere(12);
  const auto clean = contourLines(surface.mesh(), view);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (i % 3 == 1 || i % 7 == 2)
    {
      std::swap(surface.triangles[i].y, surface.triangles[i].z);
    }
  }
  const auto mixed = contourLines(surface.mesh(), view);
  ASSERT_EQ(mixed.size(), 1u);
  EXPECT_TRUE(mixed[0].closed);
  EXPECT_NEAR(lengthOf(mixed), lengthOf(clean), 1e-6);
}

TEST(ContourLinesInput, SeamsOfRoundedPointsAreNoBorders)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  Surface surface = sphere(12);
  const auto clean = contourLines(surface.mesh(), view);
  for (std::size_t i = 0; i < surface.points.size(); i += 2)
  {
    surface.points[i].x += 1e-7;
  }
  const auto rounded = contourLines(surface.mesh(), view);
  ASSERT_EQ(rounded.size(), 1u);
  EXPECT_TRUE(rounded[0].closed);
  EXPECT_NEAR(lengthOf(rounded), lengthOf(clean), 0.01);
  // A gap that is there is drawn.
  for (std::size_t i = 0; i < surface.points.size(); i += 2)
  {
    surface.points[i].x += 1e-3;
  }
  EXPECT_GT(lengthOf(contourLines(surface.mesh(), view)), 2.0 * lengthOf(clean));
}

TEST(ContourLinesInput, SameBytesAgain)
{
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  const Surface surface = turned(torus(1.0, 0.4, 60, 30), 0.9, { 1.0, 0.2, 0.0 });
  const DepthPicture picture = DepthPicture(view).draw(surface);
  const auto lines = contourLines(surface.mesh(), view, picture.depth());
  EXPECT_TRUE(equal(lines, contourLines(surface.mesh(), view, picture.depth())));
}

std::string errorOf(const Surface& surface, const ViewProjection& view, const ContourDepth& depth,
  const ContourOptions& options = {})
{
  try
  {
    contourLines(surface.mesh(), view, depth, options);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(ContourLinesInput, ErrorsNameArgumentAndValue)
{
  Surface surface = sphere(2);
  const ViewProjection view = perspectiveView(6.0, pictureSize);
  const std::vector<float> values(12, 1.0f);
  EXPECT_EQ(errorOf(surface, view, {}), "");
  EXPECT_EQ(
    errorOf(surface, view, { { 0, 0, 5, 4 }, values }), "depth.values: 12 values for 5 x 4 pixels");
  ContourOptions options;
  options.creaseAngle = -1.0;
  EXPECT_NE(errorOf(surface, view, {}, options).find("options.creaseAngle: -1"), std::string::npos);
  ViewProjection empty = view;
  empty.viewportSize.x = 0.0;
  EXPECT_NE(errorOf(surface, empty, {}).find("viewportSize is 0"), std::string::npos);
  surface.triangles[1].y = 1000;
  EXPECT_NE(errorOf(surface, view, {}).find("mesh.triangles[1]: corner 1000"), std::string::npos);
}

} // namespace

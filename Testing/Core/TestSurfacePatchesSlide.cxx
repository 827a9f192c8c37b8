// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatchesSlide.h"

#include "TestSurfaces.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace hachure;

namespace
{
/// An ellipsoid with half axes 3, 1, 1, its triangles facing outward or inward.
Surface makeEllipsoid(int n, bool outward = true)
{
  const double pi = 3.14159265358979323846;
  Surface surface;
  addGrid(surface, {}, { 1, 0, 0 }, { 0, 1, 0 }, n);
  for (glm::dvec3& point : surface.points)
  {
    const double phi = pi * point.x;
    const double theta = 2.0 * pi * point.y;
    point = { 3.0 * std::cos(phi), std::sin(phi) * std::cos(theta),
      std::sin(phi) * std::sin(theta) };
  }
  for (glm::ivec3& triangle : surface.triangles)
  {
    outward ? void() : std::swap(triangle.x, triangle.y);
  }
  surface.patches.clear();
  return surface;
}

/// The worst case of the paper's Figure 4: a turn about an axis in the plane of the film.
std::vector<ViewProjection> makePath(int frames, double degrees, glm::dvec3 axis)
{
  std::vector<ViewProjection> path(static_cast<std::size_t>(frames));
  for (int i = 0; i < frames; ++i)
  {
    path[i].modelToView = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -12.0)),
      glm::radians(degrees * i), axis);
    path[i].viewToClip = glm::perspective(glm::radians(30.0), 4.0 / 3.0, 1.0, 100.0);
    path[i].viewportSize = { 640, 480 };
  }
  return path;
}

double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}
} // namespace

TEST(SurfacePatchesSlide, ARollSlidesNotAtAll)
{
  const Surface ellipsoid = makeEllipsoid(30);
  const std::vector<std::int32_t> one(ellipsoid.triangles.size(), 0);
  const FaceSurface surface{ ellipsoid.mesh(), {}, {} };
  EXPECT_LT(largest(predictSlides(surface, one, makePath(4, 3.0, { 0, 0, 1 }), {})), 1e-6);
  EXPECT_GT(largest(predictSlides(surface, one, makePath(4, 3.0, { 0, 1, 0 }), {})), 0.5);
}

TEST(SurfacePatchesSlide, SplitsUntilUnderTheLimit)
{
  const Surface ellipsoid = makeEllipsoid(50);
  const auto vertices = joinPoints(ellipsoid.points);
  const FaceSurface surface{ ellipsoid.mesh(), {}, vertices };
  const std::vector<std::int32_t> one(ellipsoid.triangles.size(), 0);
  const auto path = makePath(12, 3.0, { 0, 1, 0 });
  const double before = largest(predictSlides(surface, one, path, {}));
  SlideOptions options;
  options.maximumSlide = 0.5 * before;
  const SlideSplit split = splitSlidingPatches(surface, one, path, options);
  EXPECT_GT(split.slides.size(), 1u);
  EXPECT_LT(split.slides.size(), 40u);
  EXPECT_LE(largest(split.slides), options.maximumSlide);
  EXPECT_EQ(predictSlides(surface, split.patches, path, options), split.slides);

  options.maximumPatches = 2;
  options.maximumSlide = 1e-3;
  EXPECT_EQ(splitSlidingPatches(surface, one, path, options).slides.size(), 2u);
  options.maximumSlide = 2.0 * before;
  EXPECT_EQ(splitSlidingPatches(surface, one, path, options).patches, one);
}

TEST(SurfacePatchesSlide, ASurfaceTurnedInsideOutSlidesTheSame)
{
  const std::vector<std::int32_t> one(2 * 40 * 40, 0);
  const auto path = makePath(3, 5.0, { 0.3, 0.8, 0.1 });
  const Surface outside = makeEllipsoid(40);
  const Surface inside = makeEllipsoid(40, false);
  const double expected = predictSlides({ outside.mesh(), {}, {} }, one, path, {})[0];
  EXPECT_NEAR(predictSlides({ inside.mesh(), {}, {} }, one, path, {})[0], expected,
    0.1 * expected); // other random samples
}

TEST(SurfacePatchesSlide, NoPatchesAndBadPaths)
{
  const Surface ellipsoid = makeEllipsoid(4);
  const std::vector<std::int32_t> none(ellipsoid.triangles.size(), -1);
  const FaceSurface surface{ ellipsoid.mesh(), {}, {} };
  EXPECT_TRUE(predictSlides(surface, none, makePath(2, 1.0, { 0, 1, 0 }), {}).empty());
  EXPECT_EQ(splitSlidingPatches(surface, none, makePath(2, 1.0, { 0, 1, 0 }), {}).patches, none);
  try
  {
    predictSlides(surface, none, makePath(1, 1.0, { 0, 1, 0 }), {});
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("views: 1"), std::string::npos) << error.what();
  }
}

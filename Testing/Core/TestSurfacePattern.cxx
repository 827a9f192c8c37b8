// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a pixel sees of a pattern on the surface, against rays that are traced.
#include "Core/Kernels.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hachure;

namespace
{
// The point of the plane (point, normal) that is seen at a normalised device position.
glm::dvec3 seen(const glm::dmat4& clip, glm::dvec3 point, glm::dvec3 normal, glm::dvec2 at)
{
  const glm::dmat4 inverse = glm::inverse(clip);
  const glm::dvec4 nearEnd = inverse * glm::dvec4(at, -1.0, 1.0);
  const glm::dvec4 farEnd = inverse * glm::dvec4(at, 1.0, 1.0);
  const glm::dvec3 start = glm::dvec3(nearEnd) / nearEnd.w;
  const glm::dvec3 ray = glm::dvec3(farEnd) / farEnd.w - start;
  return start + ray * (glm::dot(point - start, normal) / glm::dot(ray, normal));
}

glm::vec4 row(const glm::dmat4& matrix, int index)
{
  return glm::vec4(glm::row(matrix, index));
}
} // namespace

TEST(SurfacePattern, SlopesAreThoseOfTracedRays)
{
  const glm::dmat4 model =
    glm::lookAt(glm::dvec3(2.0, 1.0, 4.0), glm::dvec3(0.1, 0.2, 0.0), glm::dvec3(0.2, 1.0, 0.0));
  const glm::dvec3 point(0.3, -0.4, 0.2);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.2, 0.9));
  for (const glm::dmat4& projection :
    { glm::perspective(0.6, 1.3, 0.5, 20.0), glm::ortho(-2.0, 2.0, -1.0, 1.0, 0.5, 20.0) })
  {
    const glm::dmat4 clip = projection * model;
    const glm::dvec4 at = clip * glm::dvec4(point, 1.0);
    const glm::dvec2 device(at.x / at.w, at.y / at.w);
    const glsl::SurfaceSlopes slopes = glsl::surfaceSlopes(
      glm::vec3(point), glm::vec3(normal), row(clip, 0), row(clip, 1), row(clip, 3));
    const double step = 1e-5;
    const glm::dvec3 x = (seen(clip, point, normal, device + glm::dvec2(step, 0.0)) - point) / step;
    const glm::dvec3 y = (seen(clip, point, normal, device + glm::dvec2(0.0, step)) - point) / step;
    EXPECT_LT(glm::length(glm::dvec3(slopes.alongX) - x), 1e-3 * glm::length(x));
    EXPECT_LT(glm::length(glm::dvec3(slopes.alongY) - y), 1e-3 * glm::length(y));
    // A normal that points away is the same plane.
    const glsl::SurfaceSlopes back = glsl::surfaceSlopes(
      glm::vec3(point), glm::vec3(-normal), row(clip, 0), row(clip, 1), row(clip, 3));
    EXPECT_LT(glm::length(back.alongX - slopes.alongX), 1e-5f * glm::length(slopes.alongX));
  }
}

TEST(SurfacePattern, GrazingViewsStayFinite)
{
  const glm::vec4 x(1.0f, 0.0f, 0.0f, 0.0f);
  const glm::vec4 y(0.0f, 1.0f, 0.0f, 0.0f);
  const glm::vec4 w(0.0f, 0.0f, 0.0f, 1.0f);
  const glsl::SurfaceSlopes slopes =
    glsl::surfaceSlopes(glm::vec3(0.0f), glm::vec3(1.0f, 0.0f, 0.0f), x, y, w);
  EXPECT_LE(glm::length(slopes.alongX), 1.01f / glsl::grazingCosine);
}

TEST(SurfacePattern, ProjectionsShareTheirWeight)
{
  for (int i = 0; i < 1000; ++i)
  {
    const float longitude = 0.37f * static_cast<float>(i);
    const float height = -1.0f + 0.002f * static_cast<float>(i);
    const float ring = std::sqrt(std::max(0.0f, 1.0f - height * height));
    const glm::vec3 weights =
      glsl::triplanarWeights({ ring * std::cos(longitude), ring * std::sin(longitude), height });
    EXPECT_NEAR(weights.x + weights.y + weights.z, 1.0f, 1e-5f);
    EXPECT_GE(std::min(weights.x, std::min(weights.y, weights.z)), 0.0f);
  }
  EXPECT_EQ(glsl::triplanarWeights(glm::vec3(0.0f, 0.0f, -1.0f)), glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST(SurfacePattern, FootprintOfAStretchedPixel)
{
  // 6 by 2, turned.
  const glm::vec2 dx = 6.0f * glm::vec2(0.6f, 0.8f);
  const glm::vec2 dy = 2.0f * glm::vec2(-0.8f, 0.6f);
  const glm::vec2 axes = glsl::footprintAxes(dx, dy);
  EXPECT_NEAR(axes.x, std::sqrt(12.0f), 1e-4f);
  EXPECT_NEAR(axes.y, 6.0f, 1e-4f);
  EXPECT_NEAR(glsl::footprintAcross(dx, dy, 0.3f * dx, axes.x), 6.0f, 1e-4f);
  EXPECT_NEAR(glsl::footprintAcross(dx, dy, 0.3f * dy, axes.x), 2.0f, 1e-4f);
  EXPECT_EQ(glsl::footprintAcross(dx, dy, glm::vec2(0.0f), axes.x), axes.x);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/SurfaceCharts.h"
#include "Core/SurfaceFrames.h"
#include "TestSurfaces.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

using namespace hachure;

namespace
{
const glm::vec3 xAxis(1.0f, 0.0f, 0.0f);
const glm::vec3 yAxis(0.0f, 1.0f, 0.0f);

Surface sphere(int rings)
{
  Surface surface;
  addSphere(surface, glm::dvec3(0.0), 1.0, rings);
  return surface;
}

Surface cube()
{
  Surface surface;
  for (int i = 0; i < 8; ++i)
  {
    surface.points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  surface.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return surface;
}

glm::vec3 normalOf(const SurfaceFrames& frames, std::int32_t frame)
{
  return frames.turns.at(static_cast<std::size_t>(frame)) * yAxis;
}

float difference(const glm::quat& one, const glm::quat& other)
{
  return glm::length(one * xAxis - other * xAxis) + glm::length(one * yAxis - other * yAxis);
}
} // namespace

TEST(SurfaceFrames, NormalsAreThoseOfASphere)
{
  const Surface surface = sphere(40);
  const SurfaceFrames frames = surfaceFrames(surface.mesh(), trianglesAsCells(surface.mesh()));
  for (std::size_t frame = 0; frame < frames.points.size(); ++frame)
  {
    const glm::vec3 normal(surface.points[static_cast<std::size_t>(frames.points[frame])]);
    EXPECT_GT(glm::dot(normal, frames.turns[frame] * yAxis), 0.999f);
    EXPECT_NEAR(glm::length(frames.turns[frame]), 1.0f, 1e-6f);
  }
}

TEST(SurfaceFrames, TurnTheShortestWayAndSmoothlyInEveryChart)
{
  const Surface surface = sphere(40);
  const SurfaceCells cells = trianglesAsCells(surface.mesh());
  const SurfaceFrames frames = surfaceFrames(surface.mesh(), cells);
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const bool isDown =
      triangleAreaVector(surface.mesh(), static_cast<std::int64_t>(triangle)).y < 0;
    for (int corner = 0; corner < 3 && cells.chartOfTriangle[triangle] >= 0; ++corner)
    {
      const auto frame = static_cast<std::size_t>(frames.corners[triangle][corner]);
      const auto point = static_cast<std::size_t>(surface.triangles[triangle][corner]);
      const auto own = static_cast<std::size_t>(frames.points[frame]);
      EXPECT_LT(glm::length(surface.points[own] - surface.points[point]), 1e-9);
      const glm::quat start = isDown ? glm::quat(0.0f, 1.0f, 0.0f, 0.0f) : glm::quat(1, 0, 0, 0);
      const glm::quat turn = frames.turns[frame] * glm::conjugate(start);
      const float cosine = glm::dot(start * yAxis, frames.turns[frame] * yAxis);
      EXPECT_NEAR(2.0f * turn.w * turn.w - 1.0f, cosine, 1e-5f);
      const auto next = static_cast<std::size_t>(frames.corners[triangle][(corner + 1) % 3]);
      EXPECT_LT(difference(frames.turns[frame], frames.turns[next]), 0.4f);
    }
  }
  // One for every place, and a second one where charts of both kinds meet.
  EXPECT_GT(frames.points.size(), surface.points.size() - 158);
  EXPECT_LT(frames.points.size(), 1.1 * static_cast<double>(surface.points.size()));
}

// Where a triangle reaches into a chart of the other family its corners have frames of that one
// too.
TEST(SurfaceFrames, OfBothFamiliesWhereTrianglesReachOverTheRim)
{
  const Surface surface = sphere(60);
  SurfaceCellOptions options;
  options.baseCells = 40;
  const SurfaceCells cells = surfaceCells(surface.mesh(), options);
  const SurfaceFrames frames = surfaceFrames(surface.mesh(), cells);
  ASSERT_EQ(frames.facesDown.size(), cells.charts.size());
  int reaching = 0;
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const std::int32_t own = cells.chartOfTriangle[triangle];
    bool reaches = false;
    for (const glm::vec2& place : cells.places[triangle])
    {
      reaches = reaches || std::min({ place.x, place.y, 1.0f - place.x - place.y }) < -1e-5f;
    }
    for (std::int32_t chart = 0;
         own >= 0 && reaches && chart < static_cast<std::int32_t>(cells.charts.size()); ++chart)
    {
      const glm::ivec3 corners = cornerFrames(frames, triangle, own, chart);
      const bool isDown = frames.facesDown[static_cast<std::size_t>(chart)] != 0;
      const glm::quat start = isDown ? glm::quat(0.0f, 1.0f, 0.0f, 0.0f) : glm::quat(1, 0, 0, 0);
      for (int corner = 0; corner < 3; ++corner)
      {
        const auto frame = static_cast<std::size_t>(corners[corner]);
        EXPECT_LT(glm::distance(surface.points[static_cast<std::size_t>(frames.points[frame])],
                    surface.points[static_cast<std::size_t>(surface.triangles[triangle][corner])]),
          1e-9);
        const glm::quat turn = frames.turns[frame] * glm::conjugate(start);
        const float cosine = glm::dot(start * yAxis, frames.turns[frame] * yAxis);
        EXPECT_NEAR(2.0f * turn.w * turn.w - 1.0f, cosine, 1e-5f);
      }
      ++reaching;
    }
  }
  EXPECT_GT(reaching, 1000);
  EXPECT_LT(frames.points.size(), 2 * surface.points.size());
}

TEST(SurfaceFrames, CreasesHaveAFrameOnEachSide)
{
  const Surface surface = cube();
  const SurfaceCells cells = trianglesAsCells(surface.mesh());
  const SurfaceFrames frames = surfaceFrames(surface.mesh(), cells);
  EXPECT_EQ(frames.points.size(), 24u);
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
  {
    const glm::vec3 normal(
      glm::normalize(triangleAreaVector(surface.mesh(), static_cast<std::int64_t>(triangle))));
    for (int corner = 0; corner < 3; ++corner)
    {
      EXPECT_LT(glm::length(normalOf(frames, frames.corners[triangle][corner]) - normal), 1e-6f);
    }
  }
  // No edge of it is a crease for a wider angle.
  const SurfaceFrames round = surfaceFrames(surface.mesh(), cells, 1.6);
  EXPECT_EQ(std::set<std::int32_t>(round.sheets.begin(), round.sheets.end()).size(), 8u);
  const glm::vec3 outward = glm::normalize(glm::vec3(-1.0f));
  EXPECT_LT(glm::length(normalOf(round, round.corners[0].x) - outward), 1e-6f);
}

TEST(SurfaceFrames, GoAlongWithMotions)
{
  for (Surface surface : { sphere(16), cube() })
  {
    const SurfaceFrames rest = surfaceFrames(surface.mesh(), trianglesAsCells(surface.mesh()));
    SurfaceFrames same = rest;
    moveFrames(same, surface.mesh(), surface.points);
    const glm::dmat3 rotation(
      glm::rotate(glm::dmat4(1.0), 2.5, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))));
    std::vector<glm::dvec3> moved = surface.points;
    for (glm::dvec3& point : moved)
    {
      point = 1.7 * (rotation * point) + glm::dvec3(3.0, -1.0, 2.0);
    }
    SurfaceFrames turned = rest;
    moveFrames(turned, surface.mesh(), moved);
    const glm::quat rotated(glm::quat_cast(rotation));
    for (std::size_t frame = 0; frame < rest.turns.size(); ++frame)
    {
      EXPECT_LT(difference(same.turns[frame], rest.turns[frame]), 1e-5f);
      EXPECT_LT(difference(turned.turns[frame], rotated * rest.turns[frame]), 1e-5f);
    }
  }
}

// A floor that is sheared within its plane, then lifted to a ramp.
TEST(SurfaceFrames, AxesAreCarriedByTheDeformation)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, 4);
  SurfaceFrames frames = surfaceFrames(surface.mesh(), trianglesAsCells(surface.mesh()));
  ASSERT_EQ(frames.points.size(), surface.points.size());
  EXPECT_LT(glm::length(frames.turns[0] * yAxis - yAxis), 1e-6f);
  EXPECT_LT(glm::length(frames.turns[0] * xAxis - xAxis), 1e-6f);
  std::vector<glm::dvec3> moved = surface.points;
  for (glm::dvec3& point : moved)
  {
    point = glm::dvec3(point.x, point.x, point.z + 0.5 * point.x);
  }
  moveFrames(frames, surface.mesh(), moved);
  for (const glm::quat& turn : frames.turns)
  {
    EXPECT_LT(glm::length(turn * xAxis - glm::normalize(glm::vec3(1.0f, 1.0f, 0.5f))), 1e-6f);
    EXPECT_LT(glm::length(turn * yAxis - glm::normalize(glm::vec3(-1.0f, 1.0f, 0.0f))), 1e-6f);
  }
}

TEST(SurfaceFrames, OddMeshes)
{
  EXPECT_TRUE(surfaceFrames({ {}, {}, {} }, trianglesAsCells({ {}, {}, {} })).points.empty());
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, 1);
  surface.patches.clear();
  // Without area; the same again; the same, turned over.
  surface.triangles.insert(surface.triangles.end(),
    { { 0, 0, 1 }, surface.triangles[0],
      { surface.triangles[0].x, surface.triangles[0].z, surface.triangles[0].y } });
  const SurfaceFrames frames = surfaceFrames(surface.mesh(), trianglesAsCells(surface.mesh()));
  EXPECT_EQ(frames.corners[2], glm::ivec3(-1));
  for (const int triangle : { 0, 1, 3, 4 })
  {
    const glm::vec3 normal = triangle == 4 ? -yAxis : yAxis;
    const std::int32_t frame = frames.corners[static_cast<std::size_t>(triangle)].x;
    EXPECT_LT(glm::length(normalOf(frames, frame) - normal), 1e-6f);
  }
  // All in one place: nothing turns.
  SurfaceFrames moved = frames;
  moveFrames(moved, surface.mesh(), std::vector<glm::dvec3>(4, glm::dvec3(1.0)));
  EXPECT_EQ(moved.turns, frames.turns);
}

TEST(SurfaceFrames, RefusesWrongInput)
{
  Surface surface = cube();
  const SurfaceCells cells = trianglesAsCells(surface.mesh());
  EXPECT_THROW(surfaceFrames(surface.mesh(), cells, -0.1), std::invalid_argument);
  EXPECT_THROW(surfaceFrames(surface.mesh(), cells, std::nan("")), std::invalid_argument);
  SurfaceFrames frames = surfaceFrames(surface.mesh(), cells);
  std::vector<glm::dvec3> moved = surface.points;
  moved[0].x = std::nan("");
  EXPECT_THROW(moveFrames(frames, surface.mesh(), moved), std::invalid_argument);
  moved.pop_back();
  EXPECT_THROW(moveFrames(frames, surface.mesh(), moved), std::invalid_argument);
  surface.triangles.pop_back();
  EXPECT_THROW(moveFrames(frames, surface.mesh(), surface.points), std::invalid_argument);
  EXPECT_THROW(surfaceFrames(surface.mesh(), cells), std::invalid_argument);
  surface.points[0].x = std::nan("");
  EXPECT_THROW(surfaceFrames(surface.mesh(), cells), std::invalid_argument);
}

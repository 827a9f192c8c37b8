// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCurvature.h"

#include "DirectionSurfaces.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace hachure;

namespace
{
VertexGraph graphOf(const Surface& surface)
{
  return makeVertexGraph(surface.mesh(), joinPoints(surface.points));
}

std::vector<VertexCurvature> curvaturesOf(const VertexGraph& graph, double radius = -1.0)
{
  CurvatureOptions options;
  options.radius = radius < 0.0 ? defaultCurvatureRadius(graph) : radius;
  return vertexCurvatures(graph, options);
}

/// Angles of the direction of the larger curvature with the true one, in degrees.
std::vector<double> errorsOf(const ParameterSurface& surface, glm::dvec3 (*truth)(glm::dvec2))
{
  const VertexGraph graph = graphOf(surface.surface);
  const std::vector<VertexCurvature> curvatures = curvaturesOf(graph);
  std::vector<double> errors;
  for (std::size_t i = 0; i < surface.size(); ++i)
  {
    errors.push_back(lineAngle(curvatures[i].direction, truth(surface.parameters[i])));
  }
  return errors;
}

ParameterSurface makeCylinder(ParameterGrid grid)
{
  grid.isClosed[1] = false;
  return makeGrid(grid,
    [](glm::dvec2 p)
    { return glm::dvec3(std::cos(2.0 * pi * p.x), std::sin(2.0 * pi * p.x), 4.0 * p.y); });
}

glm::dvec3 aroundCylinder(glm::dvec2 p)
{
  return { -std::sin(2.0 * pi * p.x), std::cos(2.0 * pi * p.x), 0.0 };
}

ParameterGrid makeOptions(bool isIrregular, double noise)
{
  ParameterGrid grid;
  grid.columns = 80;
  grid.rows = 40;
  grid.isIrregular = isIrregular;
  grid.noise = noise;
  return grid;
}

/// The surface with its triangles in another order, each starting at another corner.
Surface reordered(const Surface& surface)
{
  Surface result = surface;
  std::reverse(result.triangles.begin(), result.triangles.end());
  std::rotate(result.triangles.begin(), result.triangles.begin() + 17, result.triangles.end());
  for (glm::ivec3& corners : result.triangles)
  {
    corners = { corners.z, corners.x, corners.y };
  }
  return result;
}
} // namespace

TEST(SurfaceCurvature, DirectionsOfTorusAndCylinder)
{
  // Median and 90 % of the errors, in degrees, by the noise in mean edges.
  const struct
  {
    double noise, median, most;
  } bounds[] = { { 0.0, 1.0, 2.5 }, { 0.05, 3.0, 6.0 }, { 0.2, 10.0, 22.0 } };
  for (const auto& bound : bounds)
  {
    for (const bool isIrregular : { false, true })
    {
      const ParameterGrid grid = makeOptions(isIrregular, bound.noise);
      const std::vector<double> torus = errorsOf(makeTorus(grid), torusTube);
      EXPECT_LT(quantile(torus, 0.5), bound.median) << bound.noise << " " << isIrregular;
      EXPECT_LT(quantile(torus, 0.9), bound.most) << bound.noise << " " << isIrregular;
      const std::vector<double> tube = errorsOf(makeCylinder(grid), aroundCylinder);
      EXPECT_LT(quantile(tube, 0.5), bound.median) << bound.noise << " " << isIrregular;
      EXPECT_LT(quantile(tube, 0.9), bound.most) << bound.noise << " " << isIrregular;
    }
  }
}

TEST(SurfaceCurvature, ValuesOnTheTorus)
{
  const double tube = 0.4;
  for (const bool isIrregular : { false, true })
  {
    const ParameterSurface torus = makeTorus(makeOptions(isIrregular, 0.0), tube);
    const std::vector<VertexCurvature> curvatures = curvaturesOf(graphOf(torus.surface));
    std::vector<double> first, second;
    for (std::size_t i = 0; i < torus.size(); ++i)
    {
      const double cosine = std::cos(2.0 * pi * torus.parameters[i].y);
      first.push_back(std::abs(curvatures[i].largest - 1.0 / tube));
      second.push_back(std::abs(curvatures[i].smallest - cosine / (1.0 + tube * cosine)));
    }
    EXPECT_LT(quantile(first, 0.9), 0.15 / tube) << isIrregular;
    EXPECT_LT(quantile(second, 0.5), 0.1) << isIrregular;
    EXPECT_LT(quantile(second, 0.9), 0.25) << isIrregular; // of up to 1.67, within
  }
}

TEST(SurfaceCurvature, EllipsoidAwayFromUmbilics)
{
  // Principal directions of an implicit surface: eigenvectors of the Hessian in the tangent plane.
  const glm::dvec3 axes(1.6, 1.0, 0.7);
  ParameterGrid grid = makeOptions(true, 0.0);
  grid.isClosed[1] = false;
  const ParameterSurface ellipsoid = makeGrid(grid,
    [&](glm::dvec2 p)
    {
      const double a = pi * (0.05 + 0.9 * p.y), u = 2.0 * pi * p.x;
      return axes * glm::dvec3(-std::cos(a), std::cos(u) * std::sin(a), std::sin(u) * std::sin(a));
    });
  const std::vector<VertexCurvature> curvatures = curvaturesOf(graphOf(ellipsoid.surface));
  std::vector<double> errors;
  for (std::size_t i = 0; i < ellipsoid.size(); ++i)
  {
    const glm::dvec3 gradient = ellipsoid.surface.points[i] / (axes * axes);
    const glm::dvec3 normal = glm::normalize(gradient);
    const glm::dvec3 s = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.8)));
    const glm::dvec3 t = glm::cross(normal, s);
    const double ss = glm::dot(s / (axes * axes), s), tt = glm::dot(t / (axes * axes), t);
    const double st = glm::dot(s / (axes * axes), t);
    const double anisotropy = std::hypot(ss - tt, 2.0 * st) / (ss + tt);
    const double y = ellipsoid.parameters[i].y;
    if (anisotropy > 0.15 && y > 0.08 && y < 0.92) // not at umbilics, nor at the two borders
    {
      const double angle = 0.5 * std::atan2(2.0 * st, ss - tt);
      errors.push_back(
        lineAngle(curvatures[i].direction, std::cos(angle) * s + std::sin(angle) * t));
    }
  }
  ASSERT_GT(errors.size(), ellipsoid.size() / 2);
  EXPECT_LT(quantile(errors, 0.5), 2.0);
  EXPECT_LT(quantile(errors, 0.95), 8.0);
}

TEST(SurfaceCurvature, SaddleBendsBothWays)
{
  ParameterGrid grid = makeOptions(true, 0.0);
  grid.isClosed[0] = grid.isClosed[1] = false;
  const ParameterSurface saddle = makeGrid(grid,
    [](glm::dvec2 p)
    {
      const double x = p.x - 0.5, y = p.y - 0.5;
      return glm::dvec3(x, y, 0.5 * (y * y - x * x));
    });
  const std::vector<VertexCurvature> curvatures = curvaturesOf(graphOf(saddle.surface));
  for (std::size_t i = 0; i < saddle.size(); ++i)
  {
    if (glm::length(saddle.parameters[i] - 0.5) < 0.15)
    {
      EXPECT_NEAR(curvatures[i].largest, 1.0, 0.15); // falls along x, away from the normal
      EXPECT_NEAR(curvatures[i].smallest, -1.0, 0.15);
      EXPECT_LT(lineAngle(curvatures[i].direction, { 1.0, 0.0, 0.0 }), 10.0);
    }
  }
}

TEST(SurfaceCurvature, OrderRotationAndUnitsDoNotMatter)
{
  const ParameterSurface torus = makeTorus(makeOptions(true, 0.1));
  const std::vector<VertexCurvature> plain = curvaturesOf(graphOf(torus.surface));
  const std::vector<VertexCurvature> other = curvaturesOf(graphOf(reordered(torus.surface)));
  const double unit = 1e-200; // squares of lengths are 0
  const glm::dmat3 rotation(0.48, 0.64, -0.6, -0.8, 0.6, 0.0, 0.36, 0.48, 0.8);
  Surface moved = torus.surface;
  for (glm::dvec3& point : moved.points)
  {
    point = unit * (rotation * point);
  }
  const std::vector<VertexCurvature> turned = curvaturesOf(graphOf(moved));
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    EXPECT_NEAR(other[i].largest, plain[i].largest, 1e-9);
    EXPECT_NEAR(turned[i].largest * unit, plain[i].largest, 1e-6);
    EXPECT_NEAR(turned[i].smallest * unit, plain[i].smallest, 1e-6);
    EXPECT_LT(lineAngle(other[i].direction, plain[i].direction), 1e-6);
    EXPECT_LT(lineAngle(turned[i].direction, rotation * plain[i].direction), 1e-4);
  }
}

TEST(SurfaceCurvature, RepeatedTurnedAndFlatTrianglesDoNotMatter)
{
  ParameterSurface torus = makeTorus(makeOptions(false, 0.0));
  const std::vector<VertexCurvature> plain = curvaturesOf(graphOf(torus.surface));
  Surface broken = torus.surface;
  const std::size_t count = broken.triangles.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    glm::ivec3& corners = broken.triangles[i];
    if (i % 3 == 0)
    {
      std::swap(corners.x, corners.y);
    }
    const glm::ivec3 copy = corners;
    broken.triangles.push_back({ copy.y, copy.x, copy.z });
    broken.triangles.push_back({ copy.x, copy.y, copy.y });
  }
  const VertexGraph graph = graphOf(broken);
  EXPECT_EQ(graph.triangles.size(), count);
  const std::vector<VertexCurvature> mended = curvaturesOf(graph);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    EXPECT_NEAR(mended[i].largest, plain[i].largest, 1e-6);
    EXPECT_LT(lineAngle(mended[i].direction, plain[i].direction), 1e-4);
  }
}

TEST(SurfaceCurvature, SheetsFoldedBackAndFans)
{
  // Two triangles on top of each other along one edge, and three about another.
  const Surface fold{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, 1, 1e-9 }, { 0, -1, 1 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, {} };
  for (const VertexCurvature& curvature : curvaturesOf(graphOf(fold), 10.0))
  {
    EXPECT_TRUE(std::isfinite(curvature.largest + curvature.smallest + curvature.bending));
  }
}

TEST(SurfaceCurvature, StopsAndRefuses)
{
  const VertexGraph graph = graphOf(makeTorus(makeOptions(false, 0.0)).surface);
  CurvatureOptions options;
  double last = -1.0;
  options.progress = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.4;
  };
  EXPECT_TRUE(vertexCurvatures(graph, options).empty());
  EXPECT_NEAR(last, 0.4, 0.11);
  for (const double radius : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    options.radius = radius;
    try
    {
      vertexCurvatures(graph, options);
      ADD_FAILURE() << radius;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find("options.radius"), std::string::npos);
    }
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDirections.h"

#include "DirectionSurfaces.h"
#include "TangentFrame.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

using namespace hachure;

namespace
{
/// A surface, its vertices and its graph.
struct Field
{
  explicit Field(Surface someSurface)
    : surface(std::move(someSurface))
    , vertices(joinPoints(surface.points))
    , graph(makeVertexGraph(surface.mesh(), vertices))
  {
  }

  std::vector<glm::dvec2> principal(CurvatureLine which, double radius = 0.0) const
  {
    CurvatureOptions options;
    options.radius = radius > 0.0 ? radius : defaultCurvatureRadius(graph);
    return curvatureLines(graph, vertexCurvatures(graph, options), which);
  }
  DirectionField smooth(
    const std::vector<glm::dvec2>& lines, int iterations, glm::dvec3 axis = glm::dvec3(0.0)) const
  {
    SmoothingOptions options;
    options.iterations = iterations;
    options.axis = axis;
    return directionsAtPoints(
      graph, surface.mesh(), vertices, smoothDirections(graph, lines, options));
  }

  Surface surface;
  std::vector<std::int32_t> vertices;
  VertexGraph graph;
};

/// A sphere around 0, of points from pole to pole with a seam: both ends of every row coincide.
Surface makeSphere(int columns = 48, int rows = 24)
{
  Surface sphere;
  for (int i = 0; i <= columns; ++i)
  {
    for (int j = 0; j <= rows; ++j)
    {
      const double u = 2.0 * pi * (i % columns) / columns;
      const double a = pi * j / rows;
      const double ring = j == 0 || j == rows ? 0.0 : std::sin(a);
      sphere.points.push_back({ std::cos(u) * ring, std::sin(u) * ring, -std::cos(a) });
    }
  }
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      const int a = i * (rows + 1) + j, b = a + rows + 1;
      sphere.triangles.push_back({ a, b, b + 1 });
      sphere.triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return sphere;
}

void expectUnitTangents(const Field& field, const DirectionField& result)
{
  for (std::size_t i = 0; i < result.directions.size(); ++i)
  {
    EXPECT_NEAR(glm::length(result.directions[i]), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(result.directions[i], field.graph.normals[field.vertices[i]]), 0.0, 1e-12);
    EXPECT_TRUE(result.reliabilities[i] >= 0.0 && result.reliabilities[i] <= 1.0);
  }
}

/// Largest angle, in degrees, between two fields as lines.
double largestAngle(const DirectionField& a, const DirectionField& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.directions.size(); ++i)
  {
    largest = std::max(largest, lineAngle(a.directions[i], b.directions[i]));
  }
  return largest;
}

glm::dvec3 projected(const glm::dvec3& vector, const glm::dvec3& normal)
{
  return vector - glm::dot(vector, normal) * normal;
}

ParameterSurface makeBumpyTorus()
{
  ParameterGrid grid;
  grid.columns = 80;
  grid.rows = 40;
  grid.isIrregular = true;
  grid.noise = 0.1;
  return makeTorus(grid);
}

void expectRefused(const std::function<void()>& call, const std::string& name)
{
  try
  {
    call();
    ADD_FAILURE() << name;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}
} // namespace

TEST(SurfaceDirections, GradientOfHeightOnASphere)
{
  const Field field(makeSphere());
  std::vector<double> heights;
  for (const glm::dvec3& point : field.surface.points)
  {
    heights.push_back(3.0 + 1e-3 * point.z);
  }
  for (const int iterations : { 0, 20 })
  {
    const auto lines = gradientLines(field.graph, field.surface.mesh(), heights);
    const DirectionField result = field.smooth(lines, iterations);
    expectUnitTangents(field, result);
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      const glm::dvec3 point = field.surface.points[i];
      if (std::abs(point.z) < 0.9)
      {
        const glm::dvec3 truth = projected({ 0, 0, 1 }, glm::normalize(point));
        EXPECT_LT(lineAngle(result.directions[i], truth), iterations ? 1.0 : 0.8);
        EXPECT_GT(result.reliabilities[i], iterations ? 0.7 : 0.9);
      }
    }
  }
}

TEST(SurfaceDirections, PlacesWithoutValuesTakeThoseAround)
{
  const Field field(makeSphere());
  std::vector<double> heights;
  for (const glm::dvec3& point : field.surface.points)
  {
    const bool isHole = point.x > 0.8;
    heights.push_back(isHole ? std::numeric_limits<double>::quiet_NaN() : point.z);
  }
  const auto lines = gradientLines(field.graph, field.surface.mesh(), heights);
  const DirectionField result = field.smooth(lines, 0);
  expectUnitTangents(field, result);
  int holes = 0;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const glm::dvec3 point = field.surface.points[i];
    if (point.x > 0.95)
    {
      ++holes;
      EXPECT_EQ(result.reliabilities[i], 0.0);
      EXPECT_LT(lineAngle(result.directions[i], projected({ 0, 0, 1 }, point)), 10.0);
    }
  }
  EXPECT_GT(holes, 10);
}

TEST(SurfaceDirections, SignsOfVectorsDoNotMatter)
{
  const Field field(makeBumpyTorus().surface);
  std::vector<glm::dvec3> vectors, flipped;
  for (std::size_t i = 0; i < field.surface.points.size(); ++i)
  {
    const glm::dvec3 p = field.surface.points[i];
    vectors.push_back(glm::dvec3(p.y, 1.0 - p.x, 0.3 + p.z) * (1.0 + 3.0 * unitRandom(1, i, 0)));
    flipped.push_back(unitRandom(1, i, 1) < 0.5 ? -vectors.back() : vectors.back());
  }
  for (const int iterations : { 0, 20 })
  {
    const auto smooth = [&](const std::vector<glm::dvec3>& given)
    { return field.smooth(pointVectorLines(field.graph, field.vertices, given), iterations); };
    const DirectionField result = smooth(vectors);
    expectUnitTangents(field, result);
    EXPECT_LT(largestAngle(result, smooth(flipped)), 1e-6);
    for (std::size_t i = 0; iterations == 0 && i < vectors.size(); ++i)
    {
      const glm::dvec3 normal = field.graph.normals[field.vertices[i]];
      EXPECT_LT(lineAngle(result.directions[i], projected(vectors[i], normal)), 1e-6);
    }
  }
}

TEST(SurfaceDirections, VectorsOfTriangles)
{
  const Field field(makeSphere());
  std::vector<glm::dvec3> vectors;
  for (std::size_t i = 0; i < field.surface.triangles.size(); ++i)
  {
    const glm::ivec3 c = field.surface.triangles[i];
    const glm::dvec3 middle =
      field.surface.points[c.x] + field.surface.points[c.y] + field.surface.points[c.z];
    vectors.push_back(glm::cross(glm::dvec3(0, 0, i % 2 == 0 ? 1 : -5), middle));
  }
  const DirectionField result = field.smooth(triangleVectorLines(field.graph, vectors), 0);
  for (std::size_t i = 0; i < field.surface.points.size(); ++i)
  {
    const glm::dvec3 p = field.surface.points[i];
    if (std::abs(p.z) < 0.9)
    {
      EXPECT_LT(lineAngle(result.directions[i], glm::cross(glm::dvec3(0, 0, 1), p)), 1.0);
    }
  }
}

TEST(SurfaceDirections, WhatIsNotKnownTakesTheAxis)
{
  const Field sphere(makeSphere());
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3));
  const DirectionField round =
    sphere.smooth(sphere.principal(CurvatureLine::LargestMagnitude), 20, 7.0 * axis);
  expectUnitTangents(sphere, round);
  for (std::size_t i = 0; i < round.directions.size(); ++i)
  {
    const glm::dvec3 normal = sphere.graph.normals[sphere.vertices[i]];
    EXPECT_EQ(round.reliabilities[i], 0.0);
    if (glm::length(projected(axis, normal)) > 0.2)
    {
      EXPECT_LT(lineAngle(round.directions[i], projected(axis, normal)), 1e-6);
    }
  }
  Surface plane;
  addGrid(plane, { 5, 0, 0 }, { 1, 0, 0 }, { 0, 3, 0 }, 8);
  const Field flat(plane);
  const auto none = flat.principal(CurvatureLine::Largest);
  EXPECT_LT(lineAngle(flat.smooth(none, 3).directions[20], { 0, 1, 0 }), 1e-6); // longest side
  const DirectionField across = flat.smooth(none, 3, { 0, 0, 1 }); // all across the plane
  expectUnitTangents(flat, across);
  EXPECT_LT(lineAngle(across.directions.front(), across.directions.back()), 1e-6);
}

TEST(SurfaceDirections, FlatPlacesTakeThoseAround)
{
  // A sheet bent down along x on both sides of a flat middle, which the axis would turn by 90
  // degrees.
  ParameterGrid grid;
  grid.isClosed[0] = grid.isClosed[1] = false;
  const Field sheet(makeGrid(grid,
    [](glm::dvec2 p)
    {
      const double x = 4.0 * (p.x - 0.5), bend = std::max(0.0, std::abs(x) - 1.0);
      return glm::dvec3(x, 4.0 * p.y, -bend * bend);
    }).surface);
  const auto lines = sheet.principal(CurvatureLine::LargestMagnitude);
  const DirectionField result = sheet.smooth(lines, 20, { 0, 1, 0 });
  expectUnitTangents(sheet, result);
  int filled = 0;
  for (std::size_t i = 0; i < result.directions.size(); ++i)
  {
    filled += result.reliabilities[i] == 0.0 ? 1 : 0;
    EXPECT_LT(std::abs(result.directions[i].y), 0.03);
  }
  EXPECT_GT(filled, 200);
}

TEST(SurfaceDirections, PrincipalDirectionsBySignAndMagnitude)
{
  // A groove along y: it bends towards its normal, so that the curvature across is below 0.
  ParameterGrid grid;
  grid.isClosed[0] = grid.isClosed[1] = false;
  const Field groove(makeGrid(grid,
    [](glm::dvec2 p) {
      return glm::dvec3(p.x - 0.5, p.y, (p.x - 0.5) * (p.x - 0.5));
    }).surface);
  const struct
  {
    CurvatureLine which;
    glm::dvec3 truth;
  } cases[] = { { CurvatureLine::LargestMagnitude, { 1, 0, 0 } },
    { CurvatureLine::SmallestMagnitude, { 0, 1, 0 } }, { CurvatureLine::Largest, { 0, 1, 0 } },
    { CurvatureLine::Smallest, { 1, 0, 0 } } };
  for (const auto& one : cases)
  {
    const DirectionField result = groove.smooth(groove.principal(one.which), 0);
    const std::size_t middle = 30 * 61 + 30;
    EXPECT_LT(lineAngle(result.directions[middle], one.truth), 0.5);
    EXPECT_GT(result.reliabilities[middle], 0.9);
  }
}

TEST(SurfaceDirections, TurnsWithTheSurfaceAndIgnoresTheOrder)
{
  const glm::dmat3 rotation(0.48, 0.64, -0.6, -0.8, 0.6, 0.0, 0.36, 0.48, 0.8);
  const Surface torus = makeBumpyTorus().surface;
  Surface other = torus;
  std::reverse(other.triangles.begin(), other.triangles.end());
  for (glm::dvec3& point : other.points)
  {
    point = 100.0 * (rotation * point);
  }
  const Field field(torus), turnedField(other);
  DirectionField first = field.smooth(field.principal(CurvatureLine::LargestMagnitude), 20);
  const DirectionField second =
    turnedField.smooth(turnedField.principal(CurvatureLine::LargestMagnitude), 20);
  for (std::size_t i = 0; i < first.directions.size(); ++i)
  {
    EXPECT_NEAR(first.reliabilities[i], second.reliabilities[i], 1e-6);
    first.directions[i] = rotation * first.directions[i];
  }
  const double degrees = 180.0 / pi;
  EXPECT_LT(largestAngle(first, second), 1e-6 * degrees);
}

TEST(SurfaceDirections, SignsAgreeWhereTheyCan)
{
  const Field field(makeBumpyTorus().surface); // lines around its tube can all have one sense
  const DirectionField result = field.smooth(field.principal(CurvatureLine::LargestMagnitude), 20);
  for (const glm::ivec3& c : field.surface.triangles)
  {
    EXPECT_GT(glm::dot(result.directions[c.x], result.directions[c.y]), 0.0);
  }
}

TEST(SurfaceDirections, SeamsAndPointNormals)
{
  const Field field(makeSphere());
  std::vector<glm::dvec2> lines;
  std::vector<glm::dvec3> vectors(field.surface.points.size(), glm::dvec3(0, 0, 1)), normals;
  for (const glm::dvec3& point : field.surface.points)
  {
    normals.push_back(-2.0 * (point + glm::dvec3(0.3, 0.0, 0.0))); // tilted, inwards, not unit
  }
  lines = pointVectorLines(field.graph, field.vertices, vectors);
  const DirectionField joined = field.smooth(lines, 20);
  EXPECT_EQ(joined.directions[10], joined.directions[48 * 25 + 10]); // both sides of the seam
  const DirectionField tilted = directionsAtPoints(field.graph, field.surface.mesh(),
    field.vertices, smoothDirections(field.graph, lines, {}), normals);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    EXPECT_NEAR(glm::length(tilted.directions[i]), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(tilted.directions[i], normals[i]), 0.0, 1e-9);
  }
}

TEST(SurfaceDirections, StopsAndRefuses)
{
  const Field field(makeSphere());
  const std::vector<glm::dvec2> lines(field.graph.vertexCount(), glm::dvec2(1.0, 0.0));
  SmoothingOptions options;
  options.progress = [](double fraction) { return fraction < 0.5; };
  EXPECT_TRUE(smoothDirections(field.graph, lines, options).directions.empty());
  options.progress = nullptr;
  options.iterations = -1;
  expectRefused([&] { smoothDirections(field.graph, lines, options); }, "options.iterations is -1");
  options.iterations = 1;
  options.axis.y = std::numeric_limits<double>::infinity();
  expectRefused([&] { smoothDirections(field.graph, lines, options); }, "options.axis");
  expectRefused([&] { smoothDirections(field.graph, {}, {}); }, "lines has 0");
  expectRefused(
    [&] { gradientLines(field.graph, field.surface.mesh(), {}); }, "scalars has 0 elements");
  expectRefused([&] { pointVectorLines(field.graph, field.vertices, {}); }, "vectors has 0");
  expectRefused([&] { triangleVectorLines(field.graph, {}); }, "vectors has 0");
  expectRefused(
    [&] { curvatureLines(field.graph, {}, CurvatureLine::Largest); }, "curvatures has 0");
}

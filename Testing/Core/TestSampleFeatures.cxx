// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which samples stand out, and how weights by that hold a pattern on the hills of a landscape.

#include "CallTests.h"
#include "Core/SampleFeatures.h"
#include "TrackerScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace hachure;
using hachure::testing::Spheres;

// A plain of 80 x 90 units with three hills at its far end, seen from a man's height.
struct Landscape
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<double> spacing;
  std::vector<double> features;

  static double height(double x, double y)
  {
    const glm::dvec3 hills[] = { { -14.0, 70.0, 6.0 }, { 3.0, 78.0, 8.0 }, { 17.0, 72.0, 5.0 } };
    double sum = 0.0;
    for (const glm::dvec3& hill : hills)
    {
      const double squared = (x - hill.x) * (x - hill.x) + (y - hill.y) * (y - hill.y);
      sum += hill.z * std::exp(-squared / 18.0);
    }
    return sum;
  }

  explicit Landscape(double size = 1.0)
    : spacing{ 1.5 * size }
  {
    constexpr double step = 1e-4;
    for (int i = -26; i <= 26; ++i)
    {
      for (int k = -6; k <= 54; ++k)
      {
        const double x = 1.5 * (i + 0.3 * std::sin(12.9 * i + 78.2 * k));
        const double y = 1.5 * (k + 0.3 * std::sin(39.3 * i + 11.1 * k));
        this->positions.push_back(size * glm::dvec3(x, y, height(x, y)));
        const double alongX = (height(x + step, y) - height(x - step, y)) / (2.0 * step);
        const double alongY = (height(x, y + step) - height(x, y - step)) / (2.0 * step);
        this->normals.push_back(glm::normalize(glm::dvec3(-alongX, -alongY, 1.0)));
      }
    }
  }

  TrackedSamples samples() const
  {
    return { this->positions, this->normals, {}, this->spacing, this->features };
  }

  bool isHill(std::size_t i) const { return this->positions[i].z > 0.5; }
};

std::vector<double> curvatureFactors(const TrackedSamples& samples)
{
  return featureFactors(
    normalVariation(samples.normals, nearestSamples(samples)), samples.patches, 1e-4);
}

ViewProjection walker(double way)
{
  const glm::dvec3 eye(0.15 * way, way, 1.8);
  const glm::dmat4 view =
    glm::lookAt(eye, eye + glm::dvec3(0.0, 1.0, -0.02), glm::dvec3(0.0, 0.0, 1.0));
  const glm::dvec2 size(800.0, 600.0);
  return { view, glm::perspective(0.8, size.x / size.y, 0.1, 200.0), size };
}

// Mean slide in pixels per frame over the visible sides of the hills.
double slideOnHills(const Landscape& land, WeightScheme scheme)
{
  PatternTracker tracker;
  TrackerOptions options;
  options.scheme = scheme;
  tracker.setOptions(options);
  double slid = 0.0, weight = 0.0;
  ProjectedSamples before;
  PatternFrame old;
  for (int frame = 0; frame <= 30; ++frame)
  {
    const ViewProjection view = walker(0.5 * frame);
    tracker.advance(land.samples(), view);
    TrackedSamples plain = land.samples();
    plain.features = {};
    const auto after = projectSamples(plain, view, FacingRule::FrontOnly);
    const PatternFrame now = tracker.drawn()[0];
    const glm::dvec2 z = complexProduct(now.u, { old.u.x, -old.u.y }) / glm::dot(old.u, old.u);
    for (std::size_t i = 0; frame > 0 && i < after.size(); ++i)
    {
      const double common = land.isHill(i) ? std::sqrt(before[i].weight * after[i].weight) : 0.0;
      const glm::dvec2 moved = now.origin + complexProduct(z, before[i].position - old.origin);
      slid += common > 0.0 ? common * glm::length(moved - after[i].position) : 0.0;
      weight += common;
    }
    before = after;
    old = now;
  }
  return slid / weight;
}

} // namespace

TEST(SampleFeatures, NeighboursAreTheNearest)
{
  const Spheres scene({ { 0.0, 0.0, 0.0 }, { 0.9, 0.0, 0.0 } }, 300, true);
  const auto found = nearestSamples(scene.samples());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    std::vector<double> expected;
    for (std::size_t j = 0; j < found.size(); ++j)
    {
      const double distance = glm::length(scene.positions[j] - scene.positions[i]);
      if (j != i && scene.patches[j] == scene.patches[i] && distance <= 2.0 * scene.spacing[0])
      {
        expected.push_back(distance);
      }
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_GE(expected.size(), 8u);
    for (std::size_t k = 0; k < 8; ++k)
    {
      const auto j = static_cast<std::size_t>(found[i][k]);
      ASSERT_EQ(scene.patches[j], scene.patches[i]);
      ASSERT_EQ(glm::length(scene.positions[j] - scene.positions[i]), expected[k]) << i;
    }
  }
}

TEST(SampleFeatures, HillsStandOutWhateverTheirSize)
{
  const Landscape land, large(1000.0);
  const auto factors = curvatureFactors(land.samples());
  const auto largeFactors = curvatureFactors(large.samples());
  for (std::size_t i = 0; i < factors.size(); ++i)
  {
    ASSERT_NEAR(factors[i], largeFactors[i], 1e-6);
    if (land.positions[i].y < 50.0)
    {
      ASSERT_NEAR(factors[i], 0.01, 1e-3);
    }
    else if (land.positions[i].z > 2.0)
    {
      ASSERT_GT(factors[i], 3.0);
    }
  }
}

TEST(SampleFeatures, EvenSurfacesAreEven)
{
  const Spheres scene({ { 0.0, 0.0, 0.0 } }, 500, false);
  for (const double factor : curvatureFactors(scene.samples()))
  {
    ASSERT_NEAR(factor, 1.01, 0.25);
  }
  // Two sides of a thin sheet.
  Landscape sheet;
  for (glm::dvec3& position : sheet.positions)
  {
    position.z = 0.0;
  }
  sheet.normals.assign(sheet.positions.size(), glm::dvec3(0.0, 0.0, 1.0));
  for (std::size_t i = 0; i < sheet.positions.size(); i += 2)
  {
    sheet.positions[i].z = -0.1;
    sheet.normals[i].z = -1.0;
  }
  const auto factors = curvatureFactors(sheet.samples());
  EXPECT_EQ(std::set<double>(factors.begin(), factors.end()), std::set<double>{ 1.0 });
}

TEST(SampleFeatures, FactorsAreRelativeToThePatch)
{
  const std::vector<double> strengths = { 1.0, 3.0, 0.0, 0.0, 10.0, 30.0 };
  const std::vector<std::int32_t> patches = { 0, 0, 1, 1, 2, 2 };
  const std::vector<double> expected = { 0.51, 1.51, 1.0, 1.0, 0.51, 1.51 };
  const auto factors = featureFactors(strengths, patches, 0.0);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(factors[i], expected[i], 1e-12);
  }
}

TEST(SampleFeatures, HillsOfALandscapeSlideLess)
{
  Landscape land;
  const double paper = slideOnHills(land, WeightScheme::Classic);
  const double symmetric = slideOnHills(land, WeightScheme::Symmetric);
  const double unweighted = slideOnHills(land, WeightScheme::Unweighted);
  land.features = curvatureFactors(land.samples());
  const double perceptual = slideOnHills(land, WeightScheme::Symmetric);
  std::printf("slide on the hills, pixels per frame: paper %.3f, symmetric %.3f, unweighted %.3f, "
              "perceptual %.3f\n",
    paper, symmetric, unweighted, perceptual);
  EXPECT_LT(perceptual, 0.2 * paper);
  EXPECT_LT(perceptual, 0.2 * symmetric);
  EXPECT_LT(perceptual, 1.1 * unweighted);
}

TEST(SampleFeatures, WrongInputIsNamed)
{
  Landscape land;
  const auto project = [&] { projectSamples(land.samples(), walker(0.0), FacingRule::FrontOnly); };
  land.features.assign(3, 1.0);
  EXPECT_NE(messageOf(project).find("features has 3 elements"), std::string::npos);
  land.features.assign(land.positions.size(), 1.0);
  land.features[7] = -2.0;
  EXPECT_NE(messageOf(project).find("features[7] is -2.0"), std::string::npos);
  const std::vector<double> wrong = { 1.0, std::nan("") };
  EXPECT_NE(messageOf([&] { featureFactors(wrong, {}, 0.0); }).find("strengths[1] is nan"),
    std::string::npos);
  EXPECT_NE(messageOf([&] { localContrast(wrong, {}); }).find("values has 2"), std::string::npos);
}

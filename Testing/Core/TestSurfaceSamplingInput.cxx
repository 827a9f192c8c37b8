// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CallTests.h"
#include "TestSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace hachure;

namespace
{
void expectMessage(const TriangleMesh& mesh, const SamplingOptions& options, const char* message)
{
  try
  {
    sampleSurface(mesh, options);
    ADD_FAILURE() << "no error; expected " << message;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}
} // namespace

TEST(SurfaceSamplingInput, OddInputIsSampledSilently)
{
  Surface surface;
  EXPECT_TRUE(sampleSurface(surface.mesh()).patchSpacing.empty());

  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 1e6, 1e-4, 0 } };
  surface.triangles = { { 0, 1, 3 }, { 0, 0, 2 } }; // neither has area
  const SurfaceSamples none = sampleSurface(surface.mesh());
  EXPECT_TRUE(none.triangles.empty());
  EXPECT_EQ(none.patchSpacing, std::vector<double>{ 0.0 });

  surface.triangles = { { 0, 1, 2 } };
  EXPECT_GT(sampleSurface(surface.mesh()).triangles.size(), 450u);

  surface.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 2 }, { 0, 2, 1 } }; // repeated, turned
  EXPECT_GT(sampleSurface(surface.mesh()).triangles.size(), 300u);

  surface.triangles = { { 0, 1, 2 }, { 0, 1, 4 } }; // a needle of 50 times the area, 1e6 long
  EXPECT_GT(sampleSurface(surface.mesh()).triangles.size(), 300u);
}

TEST(SurfaceSamplingInput, NeedlesCostNoMoreThanTriangles)
{
  // With voxels as small as the spacing, this would be cut into 1e9 pieces.
  Surface surface;
  const int needles = 3000;
  for (int i = 0; i < needles; ++i)
  {
    surface.points.insert(
      surface.points.end(), { { i * 1e-3, 0, 0 }, { i * 1e-3 + 1e-9, 0, 0 }, { i * 1e-3, 1, 1 } });
    surface.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  EXPECT_GT(sampleSurface(surface.mesh()).triangles.size(), 480u);
}

TEST(SurfaceSamplingInput, ExtentBeyondTheRangeOfDoublesGivesNoSamples)
{
  Surface surface;
  addGrid(surface, { -1.5e308, 0, 0 }, { 1e307, 0, 0 }, { 0, 1e307, 0 }, 1);
  addGrid(surface, { 1.5e308, 0, 0 }, { 1e307, 0, 0 }, { 0, 1e307, 0 }, 1);
  const SurfaceSamples samples = sampleSurface(surface.mesh());
  EXPECT_TRUE(samples.triangles.empty());
  EXPECT_EQ(samples.patchSpacing, std::vector<double>{ 0.0 });
}

TEST(SurfaceSamplingInput, WrongInputIsNamed)
{
  Surface quad;
  addGrid(quad, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  SamplingOptions options;
  options.samplesPerPatch = 0;
  expectMessage(quad.mesh(), options, "samplesPerPatch: 0");
  options = SamplingOptions();
  options.minimumDistance = std::nan("");
  expectMessage(quad.mesh(), options, "minimumDistance: nan");
  options = SamplingOptions();
  options.regularity = -1;
  expectMessage(quad.mesh(), options, "regularity: -1");
  options = SamplingOptions();

  Surface bad = quad;
  bad.triangles[1].y = 4;
  expectMessage(bad.mesh(), options, "mesh.triangles[1]: corner 4 is not one of the 4 points");
  bad = quad;
  bad.points[2].z = std::numeric_limits<double>::infinity();
  expectMessage(bad.mesh(), options, "mesh.points[2]: a coordinate is not finite");
  bad = quad;
  bad.patches.pop_back();
  expectMessage(bad.mesh(), options, "mesh.patches: 1 values for 2 triangles");
  bad = quad;
  bad.patches[0] = maximumPatchCount;
  expectMessage(bad.mesh(), options, "mesh.patches: id 16777216");
}

TEST(SurfaceSamplingInput, ProgressRisesAndCanStop)
{
  Surface surface;
  addGrid(surface, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  SamplingOptions options;
  options.samplesPerPatch = 20000;
  StoppingProgress progress{ 3 };
  options.progress = [&](double fraction) { return progress.report(fraction); };
  EXPECT_TRUE(sampleSurface(surface.mesh(), options).triangles.empty());
  EXPECT_EQ(progress.calls, 3);
}

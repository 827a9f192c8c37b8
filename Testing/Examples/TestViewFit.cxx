// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// A fitted turntable shows everything at every azimuth, and could not come nearer.

#include "ViewFit.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hachure::program;

namespace
{
constexpr double Aspect = 4.0 / 3.0;

/// A lopsided set: a long box with a spike on one side.
std::vector<glm::dvec3> lopsided()
{
  std::vector<glm::dvec3> points = { { 9.0, 3.0, 1.0 } };
  for (int corner = 0; corner < 8; ++corner)
  {
    points.push_back({ corner & 1 ? 2.0 : -1.0, corner & 2 ? 7.0 : 0.0, corner & 4 ? 3.0 : -3.0 });
  }
  return points;
}

/// Largest |x| or |y| of the points in the picture, whose border is 1.
double farthestFromMiddle(vtkCamera* camera, const std::vector<glm::dvec3>& points)
{
  camera->SetClippingRange(0.01, 1000.0);
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(Aspect, -1, 1);
  double farthest = 0.0;
  for (const glm::dvec3& point : points)
  {
    const double in[4] = { point.x, point.y, point.z, 1.0 };
    double out[4];
    matrix->MultiplyPoint(in, out);
    farthest = std::max({ farthest, std::abs(out[0] / out[3]), std::abs(out[1] / out[3]) });
  }
  return farthest;
}
} // namespace

TEST(ViewFit, EverythingIsSeenAndTouchesTheMargin)
{
  std::vector<double> azimuths;
  for (int i = 0; i < 12; ++i)
  {
    azimuths.push_back(30.0 * i);
  }
  const auto points = lopsided();
  for (const char* up : { "x", "y", "-z" })
  {
    Turntable turntable = makeTurntable(up, "z");
    TurntableView view;
    fitTurntable(turntable, points, azimuths, view.elevation, Aspect);
    double farthest = 0.0;
    for (const double azimuth : azimuths)
    {
      vtkNew<vtkCamera> camera;
      view.azimuth = azimuth;
      placeCamera(camera, turntable, view);
      farthest = std::max(farthest, farthestFromMiddle(camera, points));
    }
    EXPECT_NEAR(farthest, 0.96, 1e-6) << up;
  }
}

TEST(ViewFit, ZoomMagnifiesAndAzimuthWalksRight)
{
  Turntable turntable = makeTurntable("y", "z");
  TurntableView view;
  view.azimuth = 0.0;
  view.elevation = 0.0;
  fitTurntable(turntable, lopsided(), { 0.0 }, 0.0, Aspect);
  vtkNew<vtkCamera> camera;
  placeCamera(camera, turntable, view);
  const std::vector<glm::dvec3> corner = { { 2.0, 7.0, 3.0 } };
  const double plain = farthestFromMiddle(camera, corner);
  view.zoom = 1.6;
  placeCamera(camera, turntable, view);
  EXPECT_NEAR(farthestFromMiddle(camera, corner) / plain, 1.6, 1e-9);
  view.azimuth = 90.0;
  placeCamera(camera, turntable, view);
  EXPECT_NEAR(camera->GetPosition()[0] - turntable.centre.x, turntable.distance, 1e-9);
}

TEST(ViewFit, OnePointAndFlatSetsAreDefined)
{
  Turntable turntable = makeTurntable("z", "z");
  fitTurntable(turntable, { { 1.0, 2.0, 3.0 } }, { 0.0 }, 12.0, Aspect);
  EXPECT_TRUE(std::isfinite(turntable.distance));
  EXPECT_GT(turntable.distance, 0.0);
  fitTurntable(turntable, { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 5.0 } }, { 0.0 }, 90.0, Aspect);
  EXPECT_TRUE(std::isfinite(turntable.distance));
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The cameras of the views that hachure-views makes.

#ifndef ViewCameras_h
#define ViewCameras_h

#include "SurfaceInput.h"
#include "ViewsOptions.h"

#include <vtkCamera.h>
#include <vtkSmartPointer.h>
#include <vtkTextureViews.h>

#include <array>
#include <string>
#include <vector>

namespace hachure::program
{
struct ViewCamera
{
  std::string name; ///< of letters, digits and "-", no other view's
  vtkSmartPointer<vtkCamera> camera;
  std::array<int, 2> size; ///< pixels of its image
  int source = -1;         ///< its view in the given manifest
};

/// Reads the manifest whose cameras are wanted; null without one. Throws UserError.
vtkSmartPointer<vtkTextureViews> readSource(const ViewsOptions& options);

/// All cameras in the order of the options: given ones, orbit, hemisphere, manifest. Throws
/// UserError: no point with finite coordinates, a camera that is none, a matrix in the manifest.
std::vector<ViewCamera> viewCameras(
  const ViewsOptions& options, const Surface& surface, vtkTextureViews* source);

/// Positions at an angle from the camera above, right of, below and left of it, as far from the
/// focal point.
std::array<std::array<double, 3>, 4> extremePoints(vtkCamera* camera, double angle);
} // namespace hachure::program

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The turntable camera: which way is up, and how far away a view shows all of a surface.

#ifndef ViewFit_h
#define ViewFit_h

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkCamera;

namespace hachure::program
{
/// A view of the turntable, degrees. Azimuth 0 looks at the front; growing, the viewer walks to
/// the right. Zoom is the magnification about the middle of the picture.
struct TurntableView
{
  double azimuth = 25.0;
  double elevation = 12.0;
  double roll = 0.0;
  double zoom = 1.0;
};

/// World directions of the object's upright standing.
struct Turntable
{
  glm::dvec3 up;
  glm::dvec3 front;
  glm::dvec3 right;
  glm::dvec3 centre{ 0.0 }; ///< the camera looks here, and turns about up through here
  double distance = 1.0;    ///< from the camera to the centre
};

/// Directions for axes such as "z" and "-y"; a front along up is replaced by a free axis.
Turntable makeTurntable(const std::string& up, const std::string& front);

/// Sets centre and distance so that at all azimuths every point is in the picture and at least one
/// touches its margin. aspect = width / height.
void fitTurntable(Turntable& turntable, const std::vector<glm::dvec3>& points,
  const std::vector<double>& azimuths, double elevation, double aspect);

/// Places the camera, clipping range left alone.
void placeCamera(vtkCamera* camera, const Turntable& turntable, const TurntableView& view);
} // namespace hachure::program

#endif

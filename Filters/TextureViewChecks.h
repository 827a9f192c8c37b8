// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureViewChecks_h
#define hachure_TextureViewChecks_h

#include "HachureFiltersModule.h" // for the export macro

#include <string>

class vtkImageData;
class vtkMatrix4x4;

// Why something cannot be part of a view of a view-dependent texture: a reason that names the
// value, empty where it can.
namespace hachure
{

// A camera by its numbers, in the coordinates of the surface.
struct ViewCamera
{
  double position[3] = { 0.0, 0.0, 1.0 };
  double focalPoint[3] = { 0.0, 0.0, 0.0 };
  double viewUp[3] = { 0.0, 1.0, 0.0 };
  bool parallel = false;
  double viewAngle = 30.0;    // vertical, 1e-6 to 179 degrees; of perspective cameras
  double parallelScale = 1.0; // half the height of the picture, above 0; of parallel cameras
};

HACHUREFILTERS_EXPORT std::string cameraFault(const ViewCamera& camera);

// Of a matrix from the coordinates of the surface to clip coordinates.
HACHUREFILTERS_EXPORT std::string matrixFault(vtkMatrix4x4* matrix);

// Of a picture: one slice of 8 bits with one to four components.
HACHUREFILTERS_EXPORT std::string imageFault(vtkImageData* image);

// Of a depth image: one slice of 16 bits with one component.
HACHUREFILTERS_EXPORT std::string depthFault(vtkImageData* depth);

// Of another image: it must have the size of the first, whose name in the message this is. Where
// one is null there is no fault.
HACHUREFILTERS_EXPORT std::string sizeFault(
  const std::string& name, vtkImageData* first, vtkImageData* other);

// Width over height.
double aspect(vtkImageData* image);

// Of a place or a direction: three finite numbers.
HACHUREFILTERS_EXPORT std::string vectorFault(const double vector[3]);
// Of a direction: longer than nothing, too.
HACHUREFILTERS_EXPORT std::string directionFault(const double direction[3]);

} // namespace hachure

#endif

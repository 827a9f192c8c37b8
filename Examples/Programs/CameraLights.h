// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Lights that stay where they are as seen by the viewer.

#ifndef CameraLights_h
#define CameraLights_h

#include <array>
#include <vector>

class vtkRenderer;

namespace hachure::program
{
/// A light that moves with the viewer.
struct CameraLight
{
  double azimuth = 0.0;   ///< degrees right of the viewer
  double elevation = 0.0; ///< degrees above
  double intensity = 1.0; ///< 0 or more
  double color[3] = { 1.0, 1.0, 1.0 };
};

/// The default lighting: a key light from the given direction and a weak fill opposite.
std::vector<CameraLight> keyAndFill(const std::array<double, 2>& direction);

/// Replaces the lights of a renderer.
void lightFrom(vtkRenderer* renderer, const std::vector<CameraLight>& lights);
} // namespace hachure::program

#endif

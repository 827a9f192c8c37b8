// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CameraLights.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace hachure::program
{
namespace
{
/// Strength and place of the fill relative to the key light: shade stays readable, form is kept.
constexpr double FillIntensity = 0.25;
constexpr double FillElevation = -10.0;
} // namespace

//----------------------------------------------------------------------------
std::vector<CameraLight> keyAndFill(const std::array<double, 2>& direction)
{
  CameraLight key;
  key.azimuth = direction[0];
  key.elevation = direction[1];
  CameraLight fill;
  fill.azimuth = -direction[0];
  fill.elevation = FillElevation;
  fill.intensity = FillIntensity;
  return { key, fill };
}

//----------------------------------------------------------------------------
void lightFrom(vtkRenderer* renderer, const std::vector<CameraLight>& lights)
{
  renderer->RemoveAllLights();
  for (const CameraLight& one : lights)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetDirectionAngle(one.elevation, one.azimuth);
    light->SetIntensity(std::max(0.0, one.intensity));
    light->SetColor(one.color);
    renderer->AddLight(light);
  }
}
} // namespace hachure::program

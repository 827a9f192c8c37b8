// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternLights.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPatternTone.h"
#include "vtkPatternToneChannels.h"
#include "vtkShaderProgram.h"
#include "vtkTransform.h"

#include <cmath>
#include <string>

namespace
{
// From this angle on, in degrees, VTK's positional lights shine everywhere.
constexpr double openCone = 90.0;

std::array<float, 4> Packed(const double vector[3], double last)
{
  return { static_cast<float>(vector[0]), static_cast<float>(vector[1]),
    static_cast<float>(vector[2]), static_cast<float>(last) };
}
} // namespace

void vtkPatternLights::Collect(vtkRenderer* renderer)
{
  this->Colors.clear();
  this->Directions.clear();
  this->Positions.clear();
  this->Attenuations.clear();
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator position;
  lights->InitTraversal(position);
  while (vtkLight* light = lights->GetNextLight(position))
  {
    this->Add(renderer, light);
  }
}

void vtkPatternLights::Add(vtkRenderer* renderer, vtkLight* light)
{
  vtkTransform* toView = renderer->GetActiveCamera()->GetModelViewTransformObject();
  double focalPoint[3];
  double position[3];
  double direction[3];
  light->GetTransformedFocalPoint(focalPoint);
  light->GetTransformedPosition(position);
  vtkMath::Subtract(focalPoint, position, direction);
  vtkMath::Normalize(direction);
  toView->TransformNormal(direction, direction);
  toView->TransformPoint(position, position);
  auto* openGL = vtkOpenGLRenderer::SafeDownCast(renderer);
  vtkTransform* user = openGL ? openGL->GetUserLightTransform() : nullptr;
  if (user && !light->LightTypeIsSceneLight())
  {
    user->TransformNormal(direction, direction);
    user->TransformPoint(position, position);
  }

  double color[3];
  light->GetDiffuseColor(color);
  vtkMath::MultiplyScalar(color, light->GetSwitch() ? light->GetIntensity() : 0.0);
  const bool positional = light->GetPositional() != 0;
  const double angle = light->GetConeAngle();
  const bool cone = positional && angle < openCone;
  const double* attenuation = light->GetAttenuationValues();
  this->Colors.push_back(Packed(color, positional ? 1.0 : 0.0));
  this->Directions.push_back(
    Packed(direction, cone ? std::cos(vtkMath::RadiansFromDegrees(angle)) : -1.0));
  this->Positions.push_back(Packed(position, light->GetExponent()));
  this->Attenuations.push_back({ static_cast<float>(attenuation[0]),
    static_cast<float>(attenuation[1]), static_cast<float>(attenuation[2]) });
}

void vtkPatternLights::SetUniforms(
  vtkShaderProgram* program, const vtkPatternToneChannels& channels) const
{
  if (!channels.UseLights())
  {
    return;
  }
  const auto count = static_cast<int>(this->GetCount());
  if (count > 0)
  {
    program->SetUniform4fv("hachureLightColor", count, this->Colors.front().data());
    program->SetUniform4fv("hachureLightDirection", count, this->Directions.front().data());
    program->SetUniform4fv("hachureLightPosition", count, this->Positions.front().data());
    program->SetUniform3fv("hachureLightAttenuation", count, this->Attenuations.front().data());
  }
  for (std::size_t i = 0; i < channels.Get().size(); ++i)
  {
    const vtkPatternToneChannel& channel = channels.Get()[i];
    if (channel.Source == vtkPatternTone::HIGHLIGHT)
    {
      program->SetUniformf(
        ("hachurePower" + std::to_string(i)).c_str(), static_cast<float>(channel.HighlightPower));
    }
  }
}

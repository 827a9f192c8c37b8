// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternFeatures.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewport.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
// Normals that vary by less than this, in radians, and tones in shades of 1 are rounding errors.
constexpr double flat = 1e-4;
// Weights of red, green and blue in brightness (ITU-R BT.709).
constexpr glm::dvec3 luma(0.2126, 0.7152, 0.0722);

struct Light
{
  glm::dvec3 Position; // in the world
  glm::dvec3 TowardsLight;
  bool Positional;
  double Brightness;
};

std::vector<Light> LightsOf(vtkRenderer* renderer)
{
  std::vector<Light> lights;
  vtkLightCollection* collection = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  collection->InitTraversal(iterator);
  while (vtkLight* source = collection->GetNextLight(iterator))
  {
    if (!source->GetSwitch())
    {
      continue;
    }
    Light light;
    glm::dvec3 target;
    glm::dvec3 color;
    source->GetTransformedPosition(&light.Position[0]);
    source->GetTransformedFocalPoint(&target[0]);
    source->GetDiffuseColor(&color[0]);
    const glm::dvec3 arm = light.Position - target;
    light.TowardsLight = glm::length(arm) > 0.0 ? glm::normalize(arm) : glm::dvec3(0.0, 0.0, 1.0);
    light.Positional = source->GetPositional() != 0;
    light.Brightness = source->GetIntensity() * glm::dot(color, luma);
    lights.push_back(light);
  }
  return lights;
}

// Diffuse light on a white surface at every sample, at most 1.
std::vector<double> LitBrightness(
  const hachure::TrackedSamples& samples, vtkRenderer* renderer, vtkActor* actor)
{
  const std::vector<Light> lights = LightsOf(renderer);
  const glm::dmat4 modelToWorld = vtkPattern::ToGlm(actor->GetMatrix());
  const glm::dmat3 normalToWorld = glm::transpose(glm::inverse(glm::dmat3(modelToWorld)));
  std::vector<double> result(samples.positions.size(), 0.0);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const glm::dvec3 position(modelToWorld * glm::dvec4(samples.positions[i], 1.0));
    const glm::dvec3 normal = normalToWorld * samples.normals[i];
    const double length = glm::length(normal);
    for (const Light& light : lights)
    {
      const glm::dvec3 arm = light.Positional ? light.Position - position : light.TowardsLight;
      const double lengths = length * glm::length(arm);
      const double cosine = lengths > 0.0 ? glm::dot(normal, arm) / lengths : 0.0;
      result[i] += light.Brightness * std::max(0.0, cosine);
    }
    result[i] = std::min(1.0, result[i]);
  }
  return result;
}
} // namespace

void vtkPatternFeatures::UpdateNeighbours(const vtkPatternSamples& samples)
{
  if (this->NeighbourVersion != samples.GetSetVersion())
  {
    this->Neighbours = hachure::nearestSamples(samples.Tracked());
    this->NeighbourVersion = samples.GetSetVersion();
  }
}

std::string vtkPatternFeatures::ReadArray(const std::string& name, const vtkPatternSamples& samples)
{
  this->Factors.clear();
  std::string role = "features";
  try
  {
    samples.Read(role, name, 1, vtkPatternSamples::Association::PointsOrCells, this->Array);
    role += ": array '" + name + "': ";
    this->Factors = hachure::featureFactors(this->Array.Numbers, samples.Tracked().patches, 0.0);
  }
  catch (const std::invalid_argument& problem)
  {
    return role == "features" ? problem.what() : role + problem.what();
  }
  return std::string();
}

const std::vector<double>& vtkPatternFeatures::Update(vtkPatternStyle* style,
  const vtkPatternSamples& samples, vtkRenderer* renderer, vtkActor* actor, std::string& error)
{
  const hachure::TrackedSamples tracked = samples.Tracked();
  const bool wanted = style->GetWeightScheme() == vtkPatternStyle::PERCEPTUAL;
  const int source = wanted ? style->GetFeatureSource() : -1;
  const bool sameSet = source == this->Source && this->FactorVersion == samples.GetSetVersion();
  this->Source = source;
  this->FactorVersion = samples.GetSetVersion();
  if (!wanted)
  {
    this->Factors.clear();
  }
  else if (source == vtkPatternStyle::ARRAY)
  {
    error = this->ReadArray(style->GetFeatureArrayName(), samples);
  }
  else if (source == vtkPatternStyle::TONE)
  {
    this->UpdateNeighbours(samples);
    this->Factors = hachure::featureFactors(
      hachure::localContrast(LitBrightness(tracked, renderer, actor), this->Neighbours),
      tracked.patches, flat);
  }
  else if (!sameSet)
  {
    this->UpdateNeighbours(samples);
    this->Factors = hachure::featureFactors(
      hachure::normalVariation(tracked.normals, this->Neighbours), tracked.patches, flat);
    this->Neighbours = std::vector<hachure::SampleNeighbours>(); // gives its memory back
    this->NeighbourVersion = 0;
  }
  return this->Factors;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseControl.h"

#include "vtkNoiseLayer.h"
#include "vtkPatternSurface.h"
#include "vtkPatternToneCurve.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{
double Factor(const double* factors, double share)
{
  return factors[0] * std::pow(factors[1] / factors[0], share);
}

// Lowest and highest factor of the bandwidth, which is 1 / (size * regularity).
glm::dvec2 BandwidthRange(const double* sizes, const double* regularities)
{
  const double ends[] = { 1.0, 1.0 / (sizes[0] * regularities[0]),
    1.0 / (sizes[1] * regularities[1]) };
  return { *std::min_element(ends, ends + 3), *std::max_element(ends, ends + 3) };
}
} // namespace

vtkNoiseControl::vtkNoiseControl(
  vtkNoiseLayer* layer, const vtkPatternLayerPainter::FieldScene& scene, int channel)
  : Layer(layer)
  , Scene(scene)
  , Channel(channel)
{
  constexpr int vector = 3;
  const std::string directions = layer->GetDirectionArrayName();
  if (!directions.empty())
  {
    this->Directions = this->Find("direction ", directions, vector);
  }
  if (layer->GetControl() == vtkNoiseLayer::ARRAY)
  {
    this->FindNumbers();
  }
  if (layer->GetControl() == vtkNoiseLayer::TONE && channel >= 0 && scene.LookAtTones)
  {
    this->Tones = &scene.LookAtTones();
  }
}

const vtkPatternSurfaceArray* vtkNoiseControl::Find(
  const char* what, const std::string& name, int components)
{
  try
  {
    return &this->Scene.Surface->Array(name, components);
  }
  catch (const std::invalid_argument& problem)
  {
    this->Problem = what;
    this->Problem += problem.what();
    return nullptr;
  }
}

void vtkNoiseControl::FindNumbers()
{
  const double* range = this->Layer->GetControlRange();
  if (!(std::isfinite(range[0]) && std::isfinite(range[1])) || range[0] == range[1])
  {
    this->Problem = "control range is [" + std::to_string(range[0]);
    this->Problem += ", " + std::to_string(range[1]);
    this->Problem += "]; expected two different finite numbers";
    return;
  }
  this->Numbers = this->Find("control ", this->Layer->GetControlArrayName(), 1);
}

void vtkNoiseControl::Apply(hachure::NoiseKernelOptions& options) const
{
  const bool sizes = this->Layer->GetControl() != vtkNoiseLayer::NO_CONTROL;
  if (!this->Directions && !sizes)
  {
    return;
  }
  options.turning = options.turning && !this->Directions;
  options.control = [this](const hachure::NoisePoint& point) { return this->At(point); };
  options.bandwidthRange = sizes
    ? BandwidthRange(this->Layer->GetSizeFactors(), this->Layer->GetRegularityFactors())
    : glm::dvec2(1.0);
}

hachure::NoiseKernelOptions::Control vtkNoiseControl::At(const hachure::NoisePoint& point) const
{
  hachure::NoiseKernelOptions::Control control;
  if (this->Directions)
  {
    control.direction = this->Directions->Line(point.triangle, point.weights);
  }
  const double share = this->ControlAt(point);
  if (std::isfinite(share))
  {
    const double size = Factor(this->Layer->GetSizeFactors(), share);
    control.frequency = 1.0 / size;
    control.bandwidth = 1.0 / (size * Factor(this->Layer->GetRegularityFactors(), share));
  }
  return control;
}

// 0 to 1, NaN where there is no control.
double vtkNoiseControl::ControlAt(const hachure::NoisePoint& point) const
{
  double share = std::numeric_limits<double>::quiet_NaN();
  if (this->Numbers)
  {
    const double* range = this->Layer->GetControlRange();
    share =
      (this->Numbers->Number(point.triangle, point.weights) - range[0]) / (range[1] - range[0]);
  }
  else if (this->Layer->GetControl() == vtkNoiseLayer::TONE)
  {
    share = this->ToneAt(point);
  }
  return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : share;
}

// At the pixel where the point is, or would be seen; of a point outside at the nearest one.
double vtkNoiseControl::ToneAt(const hachure::NoisePoint& point) const
{
  vtkPatternTone* tone = this->Layer->GetTone();
  if (!this->Tones)
  {
    return this->Channel < 0 ? vtkPattern::CurvedTone(tone, tone->GetConstant())
                             : std::numeric_limits<double>::quiet_NaN();
  }
  const hachure::TriangleMesh mesh = this->Scene.Surface->Mesh();
  const glm::ivec3 corners = mesh.triangles[static_cast<std::size_t>(point.triangle)];
  const auto corner = [&](int i) { return mesh.points[static_cast<std::size_t>(corners[i])]; };
  const glm::dvec3 place = (1.0 - point.weights.x - point.weights.y) * corner(0) +
    point.weights.x * corner(1) + point.weights.y * corner(2);
  const glm::dvec4 clip = this->Scene.ModelToClip * glm::dvec4(place, 1.0);
  if (!(clip.w > 0.0))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::array<int, 4>& all = this->Scene.Viewport;
  const std::array<int, 4>& part = this->Scene.Rectangle;
  const glm::dvec2 pixel = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * glm::dvec2(all[2], all[3]) +
    glm::dvec2(all[0] - part[0], all[1] - part[1]);
  const glm::dvec2 inside =
    glm::clamp(glm::floor(pixel), glm::dvec2(0.0), glm::dvec2(part[2] - 1, part[3] - 1));
  const auto index = static_cast<std::size_t>(inside.y) * static_cast<std::size_t>(part[2]) +
    static_cast<std::size_t>(inside.x);
  return vtkPattern::CurvedTone(tone, this->ToneAtPixel(index, 0.5 * clip.z / clip.w + 0.5));
}

// Of several layers that of the one next to the point.
double vtkNoiseControl::ToneAtPixel(std::size_t pixel, double depth) const
{
  double tone = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& image : *this->Tones)
  {
    const bool known = image.Depth.empty() || image.Depth[pixel] < 1.0f;
    const double away = image.Depth.empty() ? 0.0 : std::abs(image.Depth[pixel] - depth);
    if (known && away < least)
    {
      constexpr double full = 255.0;
      tone = image.Tones[4 * pixel + static_cast<std::size_t>(this->Channel)] / full;
      least = away;
    }
  }
  return tone;
}

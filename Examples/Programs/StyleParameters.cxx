// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StyleParameters.h"

#include "UserError.h"

#include <vtkImagePatternLayer.h>
#include <vtkNoiseLayer.h>
#include <vtkPatternLayer.h>
#include <vtkPatternStyle.h>
#include <vtkPatternTone.h>
#include <vtkSmartPointer.h>
#include <vtkStippleLayer.h>

#include <map>

namespace hachure::program
{
namespace
{
using Kind = StyleParameter::Kind;
using Parameters = std::map<std::string, StyleParameter>;

constexpr double LargestSize = 10000.0;
constexpr double LargestOutline = 100.0;

/// A parameter of one number; the object is kept alive by the setter.
template <class Object>
StyleParameter number(Object* object, void (Object::*setter)(double), double least, double greatest)
{
  const vtkSmartPointer<Object> kept = object;
  return { Kind::Number, least, greatest,
    [kept, setter](const double* values) { (kept->*setter)(values[0]); } };
}

void addLayer(Parameters& all, vtkPatternLayer* layer, const std::string& path)
{
  const vtkSmartPointer<vtkPatternLayer> kept = layer;
  const vtkSmartPointer<vtkPatternTone> tone = layer->GetTone();
  all[path + "ink.opacity"] = number(layer, &vtkPatternLayer::SetOpacity, 0.0, 1.0);
  all[path + "ink.color"] = { Kind::Color, 0.0, 1.0,
    [kept](const double* v) { kept->SetColor(v[0], v[1], v[2]); } };
  all[path + "tone.constant"] = number(tone.Get(), &vtkPatternTone::SetConstant, 0.0, 1.0);
  all[path + "tone.gamma"] = number(tone.Get(), &vtkPatternTone::SetGamma, 0.01, 100.0);
  all[path + "tone.range"] = { Kind::Range, 0.0, 0.0,
    [tone](const double* v) { tone->SetRange(v[0], v[1]); } };
  if (auto* image = vtkImagePatternLayer::SafeDownCast(layer))
  {
    all[path + "field.size"] = number(image, &vtkImagePatternLayer::SetSize, 0.01, LargestSize);
    all[path + "field.angle"] = number(image, &vtkImagePatternLayer::SetAngle, -360.0, 360.0);
    all[path + "field.irregularity"] =
      number(image, &vtkImagePatternLayer::SetIrregularity, 0.0, 1.0);
  }
  if (auto* noise = vtkNoiseLayer::SafeDownCast(layer))
  {
    all[path + "field.size"] = number(noise, &vtkNoiseLayer::SetSize, 0.01, LargestSize);
    all[path + "field.angle"] = number(noise, &vtkNoiseLayer::SetAngle, -360.0, 360.0);
    all[path + "field.spread"] = number(noise, &vtkNoiseLayer::SetSpread, 0.0, 90.0);
    all[path + "field.regularity"] = number(noise, &vtkNoiseLayer::SetRegularity, 0.25, 8.0);
    all[path + "field.smoothness"] = number(noise, &vtkNoiseLayer::SetSmoothness, 0.0, 1.0);
  }
  if (auto* stipples = vtkStippleLayer::SafeDownCast(layer))
  {
    all[path + "field.size"] = number(stipples, &vtkStippleLayer::SetSize, 0.01, LargestSize);
    all[path + "field.growth"] = number(stipples, &vtkStippleLayer::SetGrowth, 0.01, 4.0);
  }
}

Parameters allParameters(vtkPatternStyle* style)
{
  const vtkSmartPointer<vtkPatternStyle> kept = style;
  Parameters all;
  all["paper.color"] = { Kind::Color, 0.0, 1.0,
    [kept](const double* v) { kept->SetPaperColor(v[0], v[1], v[2]); } };
  all["outline.color"] = { Kind::Color, 0.0, 1.0,
    [kept](const double* v) { kept->SetOutlineColor(v[0], v[1], v[2]); } };
  all["outline.width"] = { Kind::Number, 0.0, LargestOutline,
    [kept](const double* v) { kept->SetOutlineWidth(v[0]); } };
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    addLayer(all, style->GetLayer(i), "layers[" + std::to_string(i) + "].");
  }
  return all;
}
} // namespace

//----------------------------------------------------------------------------
StyleParameter styleParameter(vtkPatternStyle* style, const std::string& path)
{
  const Parameters all = allParameters(style);
  const auto found = all.find(path);
  if (found != all.end())
  {
    return found->second;
  }
  std::string known;
  for (const auto& [name, parameter] : all)
  {
    known += (known.empty() ? "" : ", ") + name;
  }
  throw UserError("unknown key; this style can animate: " + known);
}
} // namespace hachure::program

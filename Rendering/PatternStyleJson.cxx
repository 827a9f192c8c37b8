// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternStyleJson.h"

#include "PatternStyleArchive.h"
#include "vtkImagePatternLayer.h"
#include "vtkNew.h"
#include "vtkNoiseLayer.h"
#include "vtkPatternStyle.h"
#include "vtkStippleLayer.h"
#include "vtkViewTextureLayer.h"

#include <limits>

namespace
{

using hachure::StyleArchive;
using hachure::StyleSession;
using LayerPointer = vtkSmartPointer<vtkPatternLayer>;

constexpr int formatVersion = 1;
constexpr hachure::NumberRange anySeed = { 0.0, std::numeric_limits<vtkTypeUInt32>::max() };

struct LayerType
{
  std::string name;
  LayerPointer (*create)();
};

template <class Layer>
LayerPointer create()
{
  return vtkSmartPointer<Layer>::New();
}

/** Every type of layer that style files can hold. */
const std::vector<LayerType>& layerTypes()
{
  static const std::vector<LayerType> types = { { "image", create<vtkImagePatternLayer> },
    { "noise", create<vtkNoiseLayer> }, { "stipple", create<vtkStippleLayer> },
    { "view", create<vtkViewTextureLayer> } };
  return types;
}

//------------------------------------------------------------------------------
void describeTone(StyleArchive& archive, vtkPatternTone* tone)
{
  using Tone = vtkPatternTone;
  archive.choice("source", tone, &Tone::GetSource, &Tone::SetSource,
    { "lit", "litColor", "array", "constant", "light", "highlight", "luminance", "cyan", "magenta",
      "yellow", "black" });
  archive.text("arrayName", tone, &Tone::GetArrayName, &Tone::SetArrayName);
  archive.choice("arrayAssociation", tone, &Tone::GetArrayAssociation, &Tone::SetArrayAssociation,
    { "pointsThenCells", "points", "cells" });
  archive.integer("component", tone, &Tone::GetComponent, &Tone::SetComponent,
    { -1.0, static_cast<double>(tone->GetComponentMaxValue()) });
  archive.pair("range", tone, &Tone::GetRange, &Tone::SetRange);
  archive.number("constant", tone, &Tone::GetConstant, &Tone::SetConstant,
    { tone->GetConstantMinValue(), tone->GetConstantMaxValue() });
  archive.number("gamma", tone, &Tone::GetGamma, &Tone::SetGamma,
    { tone->GetGammaMinValue(), tone->GetGammaMaxValue() });
  archive.boolean("invert", tone, &Tone::GetInvert, &Tone::SetInvert);
  archive.choice(
    "remap", tone, &Tone::GetRemap, &Tone::SetRemap, { "none", "steps", "smoothstep" });
  archive.integer("steps", tone, &Tone::GetSteps, &Tone::SetSteps,
    { static_cast<double>(tone->GetStepsMinValue()),
      static_cast<double>(tone->GetStepsMaxValue()) });
  archive.pair("remapRange", tone, &Tone::GetRemapRange, &Tone::SetRemapRange);
  archive.integer("lightIndex", tone, &Tone::GetLightIndex, &Tone::SetLightIndex,
    { static_cast<double>(tone->GetLightIndexMinValue()),
      static_cast<double>(tone->GetLightIndexMaxValue()) });
  archive.number("highlightPower", tone, &Tone::GetHighlightPower, &Tone::SetHighlightPower,
    { tone->GetHighlightPowerMinValue(), tone->GetHighlightPowerMaxValue() });
  archive.number("blackGeneration", tone, &Tone::GetBlackGeneration, &Tone::SetBlackGeneration,
    { tone->GetBlackGenerationMinValue(), tone->GetBlackGenerationMaxValue() });
}

//------------------------------------------------------------------------------
void describeInk(StyleArchive& archive, vtkPatternLayer* layer)
{
  using Layer = vtkPatternLayer;
  archive.color("color", layer, &Layer::GetColor, &Layer::SetColor);
  archive.choice(
    "colorSource", layer, &Layer::GetColorSource, &Layer::SetColorSource, { "ink", "surface" });
  archive.number("opacity", layer, &Layer::GetOpacity, &Layer::SetOpacity,
    { layer->GetOpacityMinValue(), layer->GetOpacityMaxValue() });
  archive.choice("blendMode", layer, &Layer::GetBlendMode, &Layer::SetBlendMode,
    { "over", "multiply", "overlay", "screen" });
}

/** A layer of a type; null where there is none of that name. */
LayerPointer newLayer(const std::string& type)
{
  LayerPointer layer;
  for (const LayerType& known : layerTypes())
  {
    layer = known.name == type ? known.create() : layer;
  }
  return layer;
}

//------------------------------------------------------------------------------
void describeLayer(StyleArchive& archive, LayerPointer& layer)
{
  if (archive.isReading())
  {
    if (!archive.has("type"))
    {
      archive.fail("type", "missing; a layer needs one");
    }
    const std::string name = archive.readText("type");
    std::string known;
    for (const LayerType& type : layerTypes())
    {
      known += (known.empty() ? "\"" : ", \"") + type.name + "\"";
    }
    layer = layer ? layer : newLayer(name); // there already where layers are copied
    if (!layer)
    {
      archive.fail("type", "unknown \"" + name + "\"; expected one of " + known);
    }
  }
  else
  {
    archive.writeText("type", layer->GetTypeName());
  }
  archive.boolean(
    "enabled", layer.Get(), &vtkPatternLayer::GetEnabled, &vtkPatternLayer::SetEnabled);
  archive.integer(
    "seed", layer.Get(), &vtkPatternLayer::GetSeed, &vtkPatternLayer::SetSeed, anySeed);
  archive.group("field", [&](StyleArchive& field) { layer->DescribeField(field); });
  archive.group("tone", [&](StyleArchive& tone) { describeTone(tone, layer->GetTone()); });
  archive.group("ink", [&](StyleArchive& ink) { describeInk(ink, layer); });
}

//------------------------------------------------------------------------------
void describeOutline(StyleArchive& archive, vtkPatternStyle* style)
{
  using Style = vtkPatternStyle;
  archive.boolean("enabled", style, &Style::GetOutline, &Style::SetOutline);
  archive.color("color", style, &Style::GetOutlineColor, &Style::SetOutlineColor);
  archive.length("width", style, &Style::GetOutlineWidth, &Style::SetOutlineWidth,
    &Style::GetOutlineWidthUnit, &Style::SetOutlineWidthUnit,
    { style->GetOutlineWidthMinValue(), style->GetOutlineWidthMaxValue() });
  archive.boolean("silhouette", style, &Style::GetOutlineSilhouette, &Style::SetOutlineSilhouette);
  archive.boolean("creases", style, &Style::GetOutlineCreases, &Style::SetOutlineCreases);
  archive.boolean("borders", style, &Style::GetOutlineBorders, &Style::SetOutlineBorders);
  archive.number("creaseAngle", style, &Style::GetOutlineCreaseAngle, &Style::SetOutlineCreaseAngle,
    { style->GetOutlineCreaseAngleMinValue(), style->GetOutlineCreaseAngleMaxValue() });
}

//------------------------------------------------------------------------------
void describeTracking(StyleArchive& archive, vtkPatternStyle* style)
{
  using Style = vtkPatternStyle;
  archive.choice(
    "mode", style, &Style::GetTrackingMode, &Style::SetTrackingMode, { "tracked", "anchored" });
  archive.choice("weightScheme", style, &Style::GetWeightScheme, &Style::SetWeightScheme,
    { "symmetric", "classic", "unweighted", "perceptual" });
  archive.choice("featureSource", style, &Style::GetFeatureSource, &Style::SetFeatureSource,
    { "curvature", "tone", "array" });
  archive.text("featureArrayName", style, &Style::GetFeatureArrayName, &Style::SetFeatureArrayName);
  archive.boolean("lockRotation", style, &Style::GetLockRotation, &Style::SetLockRotation);
  archive.boolean("lockScale", style, &Style::GetLockScale, &Style::SetLockScale);
  archive.integer("samplesPerPatch", style, &Style::GetSamplesPerPatch, &Style::SetSamplesPerPatch,
    { static_cast<double>(style->GetSamplesPerPatchMinValue()),
      static_cast<double>(style->GetSamplesPerPatchMaxValue()) });
}

//------------------------------------------------------------------------------
void describePaper(StyleArchive& archive, vtkPatternStyle* style)
{
  using Style = vtkPatternStyle;
  archive.choice("source", style, &Style::GetPaperSource, &Style::SetPaperSource,
    { "constant", "surface", "flat", "none" });
  archive.color("color", style, &Style::GetPaperColor, &Style::SetPaperColor);
  archive.resolution("dotsPerInch");
}

//------------------------------------------------------------------------------
void describeSettings(StyleArchive& archive, vtkPatternStyle* style)
{
  archive.version("hachure", formatVersion);
  archive.group("paper", [&](StyleArchive& paper) { describePaper(paper, style); });
  archive.group("outline", [&](StyleArchive& outline) { describeOutline(outline, style); });
  archive.group("tracking", [&](StyleArchive& tracking) { describeTracking(tracking, style); });
}

//------------------------------------------------------------------------------
/** Runs what `describe` lists of one object over to another. */
template <class Object, class Describe>
void copy(StyleSession& session, Object& source, Object& target, Describe&& describe)
{
  Json::Value content(Json::objectValue);
  session.reading = false;
  StyleArchive writer(session, content, "");
  describe(writer, source);
  session.reading = true;
  StyleArchive reader(session, content, "");
  describe(reader, target);
}

//------------------------------------------------------------------------------
void copySettings(vtkPatternStyle* source, vtkPatternStyle* target)
{
  StyleSession session;
  session.copying = true;
  session.dotsPerInch = source->GetDotsPerInch();
  copy(session, source, target, describeSettings);
  target->SetDotsPerInch(source->GetDotsPerInch());
}

//------------------------------------------------------------------------------
/** Gives a style layers of the types that another one has, and keeps those that are of them. */
void matchLayers(vtkPatternStyle* source, vtkPatternStyle* target)
{
  const int count = source->GetNumberOfLayers();
  for (int i = 0; i < count; ++i)
  {
    const std::string type = source->GetLayer(i)->GetTypeName();
    const bool exists = i < target->GetNumberOfLayers();
    if (!exists || target->GetLayer(i)->GetTypeName() != type)
    {
      if (exists)
      {
        target->RemoveLayer(target->GetLayer(i));
      }
      target->InsertLayer(i, newLayer(type));
    }
  }
  while (target->GetNumberOfLayers() > count)
  {
    target->RemoveLayer(target->GetLayer(count));
  }
}

} // namespace

namespace hachure
{

//------------------------------------------------------------------------------
void readStyle(const std::string& text, const std::string& folder, vtkPatternStyle* style)
{
  StyleSession session;
  Json::Value root = parseJson(text, session.name);
  session.folder = folder;
  StyleArchive archive(session, root, "");
  // Everything is read into a new style first: keys that are absent mean the defaults, and an
  // error leaves the given style alone.
  vtkNew<vtkPatternStyle> fresh;
  session.dotsPerInch = fresh->GetDotsPerInch();
  std::vector<LayerPointer> layers;
  archive.describe(
    [&](StyleArchive& top)
    {
      describeSettings(top, fresh);
      top.list("layers", layers, describeLayer);
    });
  fresh->SetDotsPerInch(session.dotsPerInch);
  copySettings(fresh, style);
  style->RemoveAllLayers();
  for (const LayerPointer& layer : layers)
  {
    style->AddLayer(layer);
  }
}

//------------------------------------------------------------------------------
std::string writeStyle(vtkPatternStyle* style, const std::string& folder)
{
  std::vector<LayerPointer> layers;
  layers.reserve(style->GetNumberOfLayers());
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    layers.emplace_back(style->GetLayer(i));
  }
  StyleSession session;
  session.reading = false;
  session.folder = folder;
  session.dotsPerInch = style->GetDotsPerInch();
  Json::Value root(Json::objectValue);
  StyleArchive archive(session, root, "");
  describeSettings(archive, style);
  archive.list("layers", layers, describeLayer);
  return jsonText(root, session.digits);
}

//------------------------------------------------------------------------------
void copyStyle(vtkPatternStyle* source, vtkPatternStyle* target)
{
  copySettings(source, target);
  matchLayers(source, target);
  for (int i = 0; i < source->GetNumberOfLayers(); ++i)
  {
    StyleSession session;
    session.copying = true;
    session.dotsPerInch = source->GetDotsPerInch();
    LayerPointer from = source->GetLayer(i);
    LayerPointer to = target->GetLayer(i);
    copy(session, from, to, describeLayer);
  }
}

} // namespace hachure

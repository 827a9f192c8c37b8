// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scene.h"

#include "DrawingWindow.h"
#include "ErrorCollector.h"
#include "UserError.h"

#include <vtkCamera.h>
#include <vtkPatternLayer.h>
#include <vtkPatternMapper.h>
#include <vtkPatternStyle.h>
#include <vtkPatternTone.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkViewTextureLayer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hachure::program
{
namespace
{
constexpr int FitAzimuths = 36;

std::string joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

bool isFileName(const std::string& style)
{
  return style.find('/') != std::string::npos ||
    (style.size() > 5 && style.compare(style.size() - 5, 5, ".json") == 0);
}

void readViews(vtkPatternStyle* style, const std::string& manifest)
{
  const ErrorCollector errors;
  bool any = false;
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    if (auto* layer = vtkViewTextureLayer::SafeDownCast(style->GetLayer(i)))
    {
      any = true;
      if (!layer->ReadManifest(manifest))
      {
        throw UserError("cannot use views '" + manifest + "': " + errors.first());
      }
    }
  }
  if (!any)
  {
    throw UserError("--views: the style has no layer of view-dependent texture; see --style view");
  }
}

void toneFollowsArray(vtkPatternStyle* style, const std::string& name, const ToneArray& array)
{
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    vtkPatternTone* tone = style->GetLayer(i)->GetTone();
    tone->SetSource(vtkPatternTone::ARRAY);
    tone->SetArrayName(name.c_str());
    tone->SetComponent(array.component);
    tone->SetRange(array.range[0], array.range[1]);
  }
}
} // namespace

//----------------------------------------------------------------------------
std::vector<std::string> styleNames()
{
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(vtkPatternStyle::GetNumberOfPresets()));
  for (int i = 0; i < vtkPatternStyle::GetNumberOfPresets(); ++i)
  {
    names.emplace_back(vtkPatternStyle::GetPresetName(i));
  }
  return names;
}

//----------------------------------------------------------------------------
Scene::Scene(const RenderOptions& options)
  : pictureWidth(options.size[0] * options.supersample)
  , pictureHeight(options.size[1] * options.supersample)
{
  this->makeStyle(options);
  this->makeSurface(options);
  this->fitView(options);
  this->renderer->SetBackground(1.0, 1.0, 1.0);
  this->renderer->AutomaticLightCreationOff();
  this->renderer->AddActor(this->actor);
  this->setLights(keyAndFill(options.light));
  this->setView({});
}

//----------------------------------------------------------------------------
Scene::~Scene() = default;

//----------------------------------------------------------------------------
vtkCamera* Scene::camera() const
{
  return this->renderer->GetActiveCamera();
}

//----------------------------------------------------------------------------
void Scene::makeStyle(const RenderOptions& options)
{
  const ErrorCollector errors;
  this->patternStyle = vtkSmartPointer<vtkPatternStyle>::New();
  if (isFileName(options.style))
  {
    if (!this->patternStyle->LoadFile(options.style.c_str()))
    {
      throw UserError("cannot use style file '" + options.style + "': " + errors.first());
    }
  }
  else
  {
    const auto names = styleNames();
    if (std::find(names.begin(), names.end(), options.style) == names.end())
    {
      throw UserError("unknown style '" + options.style + "'; known: " + joined(names));
    }
    if (!this->patternStyle->LoadPreset(options.style.c_str()))
    {
      throw std::runtime_error("style '" + options.style + "' is broken: " + errors.first());
    }
  }
  if (!options.views.empty())
  {
    readViews(this->patternStyle, options.views);
  }
  this->patternStyle->SetPixelScale(options.supersample);
  this->patternStyle->SetFinalQuality(options.finalQuality);
}

//----------------------------------------------------------------------------
void Scene::makeSurface(const RenderOptions& options)
{
  this->surface = readSurface(options.input, options.isovalue);
  if (!options.array.empty())
  {
    const ToneArray array = toneArray(this->surface.data, options.array);
    toneFollowsArray(this->patternStyle, options.array, array);
  }
  vtkNew<vtkPatternMapper> mapper;
  mapper->SetInputDataObject(this->surface.data);
  mapper->SetStyle(this->patternStyle);
  mapper->ScalarVisibilityOff();
  this->actor->SetMapper(mapper);
  this->actor->GetProperty()->SetAmbient(0.0);
  this->actor->GetProperty()->SetDiffuse(1.0);
  this->actor->GetProperty()->SetSpecular(0.0);
}

//----------------------------------------------------------------------------
void Scene::fitView(const RenderOptions& options)
{
  const std::string up = options.up.empty() ? this->surface.up : options.up;
  const std::string front = options.front.empty() ? this->surface.front : options.front;
  this->turntable = makeTurntable(up, front);
  const auto points = fitPoints(this->surface.data, options.input);
  const TurntableView standard;
  std::vector<double> azimuths = { standard.azimuth };
  if (options.orbit > 1 || !options.animation.empty())
  {
    azimuths.clear();
    for (int i = 0; i < FitAzimuths; ++i)
    {
      azimuths.push_back(standard.azimuth + 360.0 * i / FitAzimuths);
    }
  }
  const double aspect = static_cast<double>(this->pictureWidth) / this->pictureHeight;
  fitTurntable(this->turntable, points, azimuths, standard.elevation, aspect);
}

//----------------------------------------------------------------------------
void Scene::setView(const TurntableView& view)
{
  placeCamera(this->camera(), this->turntable, view);
}

//----------------------------------------------------------------------------
void Scene::setTime(double time)
{
  if (auto* mapper = vtkPatternMapper::SafeDownCast(this->actor->GetMapper()))
  {
    mapper->SetAnimationTime(time);
  }
}

//----------------------------------------------------------------------------
void Scene::openWindow()
{
  this->window = makeDrawingWindow();
  this->window->SetSize(this->pictureWidth, this->pictureHeight);
  this->window->AddRenderer(this->renderer);
}

//----------------------------------------------------------------------------
Picture Scene::draw()
{
  const ErrorCollector errors;
  if (!this->window)
  {
    this->openWindow();
  }
  this->renderer->ResetCameraClippingRange();
  this->window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int right = this->pictureWidth - 1;
  const int top = this->pictureHeight - 1;
  this->window->GetPixelData(0, 0, right, top, 0, pixels);
  if (!errors.first().empty())
  {
    throw std::runtime_error("drawing failed: " + errors.first());
  }
  const auto* begin = pixels->GetPointer(0);
  return { this->pictureWidth, this->pictureHeight,
    std::vector<std::uint8_t>(begin, begin + pixels->GetNumberOfValues()) };
}
} // namespace hachure::program

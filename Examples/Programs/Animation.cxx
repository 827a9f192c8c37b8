// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Animation.h"

#include "JsonReading.h"
#include "Scene.h"
#include "UserError.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPatternMapper.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hachure::program
{
namespace
{
constexpr double LongestSeconds = 3600.0;
constexpr double LargestRate = 240.0;
constexpr double FullTurns = 360000.0; // degrees
constexpr double LargestZoom = 1000.0;
constexpr double LargestIntensity = 100.0;

/// Interpolators of VTK want two keys: a single one is repeated this much later.
constexpr double RepeatSeconds = 1.0;

vtkSmartPointer<vtkCamera> readCameraKey(const JsonNode& key)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  for (const char* required : { "position", "focalPoint" })
  {
    if (!key.has(required))
    {
      key.at(required).fail("missing");
    }
  }
  const auto up = key.has("viewUp") ? key.at("viewUp").vector() : std::array<double, 3>{ 0, 1, 0 };
  camera->SetPosition(key.at("position").vector().data());
  camera->SetFocalPoint(key.at("focalPoint").vector().data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(key.number("viewAngle", 30.0, 0.01, 170.0));
  return camera;
}

vtkSmartPointer<vtkTransform> readActorKey(const JsonNode& key)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  if (key.has("position"))
  {
    transform->Translate(key.at("position").vector().data());
  }
  if (key.has("rotation"))
  {
    const auto angles = key.at("rotation").vector();
    transform->RotateZ(angles[2]);
    transform->RotateX(angles[0]);
    transform->RotateY(angles[1]);
  }
  const double scale = key.number("scale", 1.0, 1e-6, 1e6);
  transform->Scale(scale, scale, scale);
  return transform;
}

std::vector<double> readStyleValue(const JsonNode& node, const StyleParameter& parameter)
{
  if (parameter.kind == StyleParameter::Kind::Color)
  {
    const auto color = node.color();
    return { color.begin(), color.end() };
  }
  if (parameter.kind == StyleParameter::Kind::Range)
  {
    const auto range = node.pair();
    return { range.begin(), range.end() };
  }
  return { node.number(parameter.least, parameter.greatest) };
}

int components(StyleParameter::Kind kind)
{
  return kind == StyleParameter::Kind::Color ? 3 : kind == StyleParameter::Kind::Range ? 2 : 1;
}
} // namespace

//----------------------------------------------------------------------------
Track::Track(int componentCount, bool spline)
  : interpolator(vtkSmartPointer<vtkTupleInterpolator>::New())
{
  this->interpolator->SetInterpolationType(spline
      ? vtkTupleInterpolator::INTERPOLATION_TYPE_SPLINE
      : vtkTupleInterpolator::INTERPOLATION_TYPE_LINEAR);
  // After the type, whose setter forgets the number.
  this->interpolator->SetNumberOfComponents(componentCount);
}

//----------------------------------------------------------------------------
void Track::add(double time, const std::vector<double>& values)
{
  std::vector<double> copy = values;
  this->interpolator->AddTuple(time, copy.data());
  this->first = this->keys == 0 ? values : this->first;
  ++this->keys;
}

//----------------------------------------------------------------------------
std::vector<double> Track::at(double time) const
{
  std::vector<double> values = this->first;
  if (this->keys > 1)
  {
    this->interpolator->InterpolateTuple(time, values.data());
  }
  return values;
}

//----------------------------------------------------------------------------
Animation::Animation(const std::string& file, const Scene& scene)
{
  const JsonNode root{ readJsonFile(file), "" };
  try
  {
    this->read(root, scene);
  }
  catch (const UserError& error)
  {
    throw UserError("cannot use animation '" + file + "': " + error.what());
  }
}

//----------------------------------------------------------------------------
void Animation::read(const JsonNode& root, const Scene& scene)
{
  root.allowOnly({ "hachureAnimation", "frameRate", "duration", "interpolation", "camera", "lights",
    "actor", "style" });
  if (root.at("hachureAnimation").value != Json::Value(1))
  {
    root.at("hachureAnimation").fail("expected 1, the version of this format");
  }
  const double rate = root.number("frameRate", 24.0, 1.0, LargestRate);
  if (rate != std::floor(rate))
  {
    root.at("frameRate").fail("expected a whole number");
  }
  this->framesPerSecond = static_cast<int>(rate);
  const auto interpolation = root.at("interpolation");
  if (root.has("interpolation") && interpolation.value != Json::Value("spline") &&
    interpolation.value != Json::Value("linear"))
  {
    interpolation.fail("expected \"spline\" or \"linear\"");
  }
  this->spline = interpolation.value != Json::Value("linear");
  this->readTracks(root, scene);
  const double duration = root.number("duration", this->lastKey, 0.0, LongestSeconds);
  this->frames = static_cast<int>(std::floor(duration * rate + 1e-6)) + 1;
}

//----------------------------------------------------------------------------
void Animation::readTracks(const JsonNode& root, const Scene& scene)
{
  if (root.has("camera"))
  {
    this->readCamera(root.at("camera"));
  }
  if (root.has("lights"))
  {
    const JsonNode list = root.at("lights");
    list.requireArray();
    for (Json::ArrayIndex i = 0; i < list.value.size(); ++i)
    {
      this->readLight(list.at(i));
    }
  }
  if (root.has("actor"))
  {
    this->readActor(root.at("actor"));
  }
  if (root.has("style"))
  {
    this->readStyle(root.at("style"), scene);
  }
}

//----------------------------------------------------------------------------
void Animation::forEachKey(
  const JsonNode& keys, const std::function<void(double time, const JsonNode& key)>& visit)
{
  keys.requireArray();
  double previous = -1.0;
  for (Json::ArrayIndex i = 0; i < keys.value.size(); ++i)
  {
    const JsonNode key = keys.at(i);
    key.requireObject();
    const double time = key.at("time").number(0.0, LongestSeconds);
    if (time <= previous)
    {
      key.at("time").fail("times must grow from key to key");
    }
    previous = time;
    visit(time, key);
  }
  this->lastKey = std::max(this->lastKey, previous);
}

//----------------------------------------------------------------------------
void Animation::readCamera(const JsonNode& keys)
{
  keys.requireArray();
  keys.at(0).requireObject();
  if (!keys.at(0).has("position"))
  {
    this->readTurntable(keys);
    return;
  }
  this->camera = vtkSmartPointer<vtkCameraInterpolator>::New();
  this->camera->SetInterpolationType(this->spline
      ? vtkCameraInterpolator::INTERPOLATION_TYPE_SPLINE
      : vtkCameraInterpolator::INTERPOLATION_TYPE_LINEAR);
  this->forEachKey(keys,
    [&](double time, const JsonNode& key)
    {
      key.allowOnly({ "time", "position", "focalPoint", "viewUp", "viewAngle" });
      const auto view = readCameraKey(key);
      this->camera->AddCamera(time, view);
      if (keys.value.size() == 1)
      {
        this->camera->AddCamera(time + RepeatSeconds, view);
      }
    });
}

//----------------------------------------------------------------------------
void Animation::readTurntable(const JsonNode& keys)
{
  const TurntableView standard;
  Track track(4, this->spline);
  this->forEachKey(keys,
    [&](double time, const JsonNode& key)
    {
      key.allowOnly({ "time", "azimuth", "elevation", "roll", "zoom" });
      track.add(time,
        { key.number("azimuth", standard.azimuth, -FullTurns, FullTurns),
          key.number("elevation", standard.elevation, -90.0, 90.0),
          key.number("roll", standard.roll, -FullTurns, FullTurns),
          std::log(key.number("zoom", standard.zoom, 1.0 / LargestZoom, LargestZoom)) });
    });
  this->turntable = { track };
}

//----------------------------------------------------------------------------
void Animation::readLight(const JsonNode& keys)
{
  Track track(6, this->spline);
  this->forEachKey(keys,
    [&](double time, const JsonNode& key)
    {
      key.allowOnly({ "time", "azimuth", "elevation", "intensity", "color" });
      const auto color =
        key.has("color") ? key.at("color").color() : std::array<double, 3>{ 1.0, 1.0, 1.0 };
      track.add(time,
        { key.at("azimuth").number(-FullTurns, FullTurns), key.at("elevation").number(-90.0, 90.0),
          key.number("intensity", 1.0, 0.0, LargestIntensity), color[0], color[1], color[2] });
    });
  this->lights.push_back(track);
}

//----------------------------------------------------------------------------
void Animation::readActor(const JsonNode& keys)
{
  this->actor = vtkSmartPointer<vtkTransformInterpolator>::New();
  this->actor->SetInterpolationType(this->spline
      ? vtkTransformInterpolator::INTERPOLATION_TYPE_SPLINE
      : vtkTransformInterpolator::INTERPOLATION_TYPE_LINEAR);
  this->forEachKey(keys,
    [&](double time, const JsonNode& key)
    {
      key.allowOnly({ "time", "position", "rotation", "scale" });
      const auto transform = readActorKey(key);
      this->actor->AddTransform(time, transform);
      if (keys.value.size() == 1)
      {
        this->actor->AddTransform(time + RepeatSeconds, transform);
      }
    });
}

//----------------------------------------------------------------------------
void Animation::readStyle(const JsonNode& keys, const Scene& scene)
{
  std::map<std::string, std::size_t> known;
  this->forEachKey(keys,
    [&](double time, const JsonNode& key)
    {
      for (const std::string& path : key.value.getMemberNames())
      {
        if (path == "time")
        {
          continue;
        }
        const JsonNode node = key.at(path);
        if (known.count(path) == 0)
        {
          const StyleParameter parameter = this->findParameter(node, path, scene);
          known[path] = this->styleTracks.size();
          this->styleTracks.push_back(
            { parameter, Track(components(parameter.kind), this->spline) });
        }
        StyleTrack& track = this->styleTracks[known[path]];
        track.track.add(time, readStyleValue(node, track.parameter));
      }
    });
}

//----------------------------------------------------------------------------
StyleParameter Animation::findParameter(
  const JsonNode& node, const std::string& path, const Scene& scene) const
{
  try
  {
    return styleParameter(scene.style(), path);
  }
  catch (const UserError& error)
  {
    node.fail(error.what());
  }
}

//----------------------------------------------------------------------------
void Animation::apply(int frame, Scene& scene) const
{
  const double time = static_cast<double>(frame) / this->framesPerSecond;
  scene.setTime(time);
  if (this->camera)
  {
    this->camera->InterpolateCamera(time, scene.camera());
    // Patterns of anchored styles are tracked along the path, whichever frame is drawn first.
    auto* mapper = vtkPatternMapper::SafeDownCast(scene.surfaceActor()->GetMapper());
    if (mapper && mapper->GetCameraPath() != this->camera)
    {
      mapper->SetCameraPath(this->camera);
      mapper->RemoveAllKeyTimes();
      mapper->AddKeyTime(0.0);
      mapper->SetReplayStep(1.0 / this->framesPerSecond);
    }
  }
  for (const Track& track : this->turntable)
  {
    const auto view = track.at(time);
    scene.setView({ view[0], view[1], view[2], std::exp(view[3]) });
  }
  if (!this->lights.empty())
  {
    std::vector<CameraLight> lit;
    for (const Track& track : this->lights)
    {
      const auto v = track.at(time);
      lit.push_back({ v[0], v[1], v[2], { v[3], v[4], v[5] } });
    }
    scene.setLights(lit);
  }
  if (this->actor)
  {
    vtkNew<vtkTransform> transform;
    this->actor->InterpolateTransform(time, transform);
    scene.surfaceActor()->SetUserTransform(transform);
  }
  for (const StyleTrack& one : this->styleTracks)
  {
    auto values = one.track.at(time);
    if (one.parameter.least < one.parameter.greatest)
    {
      for (double& value : values) // splines overshoot
      {
        value = std::clamp(value, one.parameter.least, one.parameter.greatest);
      }
    }
    one.parameter.set(values.data());
  }
}
} // namespace hachure::program

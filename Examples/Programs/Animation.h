// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Key frames of camera, lights, actor and style; animation.schema.md describes the file.

#ifndef Animation_h
#define Animation_h

#include "StyleParameters.h"

#include <vtkCameraInterpolator.h>
#include <vtkSmartPointer.h>
#include <vtkTransformInterpolator.h>
#include <vtkTupleInterpolator.h>

#include <functional>
#include <string>
#include <vector>

namespace hachure::program
{
class Scene;
struct JsonNode;

/// Values over time, constant before the first and after the last key.
class Track
{
public:
  Track(int components, bool spline);
  void add(double time, const std::vector<double>& values);
  std::vector<double> at(double time) const;

private:
  vtkSmartPointer<vtkTupleInterpolator> interpolator;
  std::vector<double> first;
  int keys = 0;
};

class Animation
{
public:
  /// Throws UserError with the file's name, the path of the value, and the reason.
  Animation(const std::string& file, const Scene& scene);

  int numberOfFrames() const { return this->frames; }
  int frameRate() const { return this->framesPerSecond; }

  /// Puts the scene into the state of a frame, counted from 0.
  void apply(int frame, Scene& scene) const;

private:
  struct StyleTrack
  {
    StyleParameter parameter;
    Track track;
  };

  void read(const JsonNode& root, const Scene& scene);
  void readTracks(const JsonNode& root, const Scene& scene);
  void forEachKey(
    const JsonNode& keys, const std::function<void(double time, const JsonNode& key)>& visit);
  void readCamera(const JsonNode& keys);
  void readTurntable(const JsonNode& keys);
  void readLight(const JsonNode& keys);
  void readActor(const JsonNode& keys);
  void readStyle(const JsonNode& keys, const Scene& scene);
  StyleParameter findParameter(
    const JsonNode& node, const std::string& path, const Scene& scene) const;

  bool spline = true;
  int frames = 1;
  int framesPerSecond = 24;
  double lastKey = 0.0;
  vtkSmartPointer<vtkCameraInterpolator> camera;
  vtkSmartPointer<vtkTransformInterpolator> actor;
  std::vector<Track> turntable; ///< one, or none
  std::vector<Track> lights;
  std::vector<StyleTrack> styleTracks;
};
} // namespace hachure::program

#endif

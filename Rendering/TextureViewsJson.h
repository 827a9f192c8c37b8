// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextureViewsJson_h
#define TextureViewsJson_h

#include "TextureViewChecks.h"

#include <array>
#include <string>
#include <vector>

namespace hachure
{

/** A view as a manifest states it; files by their names relative to the manifest. */
struct ManifestView
{
  std::string name;
  std::string image;
  std::string mask;                             // empty: none
  std::string depth;                            // empty: none
  std::array<double, 2> depthRange{ 0.0, 0.0 }; // of the depth image
  int kind = 0;                                 // vtkTextureViews::Kinds
  bool hasMatrix = false;                       // instead of the camera
  ViewCamera camera;
  std::array<double, 16> matrix{}; // row by row
  std::vector<std::array<double, 3>> extremes;
  int fadeMode = 0; // vtkTextureViews::FadeModes
  std::vector<std::array<double, 2>> fadeCurve{ { 0.0, 1.0 }, { 0.5, 1.0 }, { 1.0, 0.0 } };
};

struct ManifestBlendPoint
{
  std::array<double, 3> position{};
  std::array<double, 3> direction{};
  double percentage = 0.0;
};

struct ViewsManifest
{
  int baseCells = 144;
  int finestLevel = 4;
  int hemisphere = 8;
  int map = 0; // vtkTextureViews::HemisphereMaps
  std::vector<ManifestView> views;
  std::vector<ManifestBlendPoint> blendPoints;
};

/** Where a view stands in a manifest, as "views[2]". */
std::string manifestPath(std::size_t view);

/**
 * What a JSON text states. Throws StyleError, whose text starts with the path in the JSON: where it
 * is no such text, a key is unknown or missing, a value is of another type, out of its range or no
 * camera. No file is looked at.
 */
ViewsManifest readManifest(const std::string& text);

/** The JSON text that reads back to the same; throws StyleError where a number is not finite. */
std::string writeManifest(ViewsManifest manifest);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewsJson.h"

#include "PatternStyleArchive.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkTextureViews.h"

#include <cstddef>

namespace
{

using hachure::ManifestBlendPoint;
using hachure::ManifestView;
using hachure::StyleArchive;
using hachure::StyleSession;
using hachure::ViewCamera;
using hachure::ViewsManifest;

constexpr int formatVersion = 1;
constexpr hachure::NumberRange share = { 0.0, 1.0 };
constexpr hachure::NumberRange percent = { 0.0, 100.0 };

//------------------------------------------------------------------------------
/** Fails under a key with a fault that is not empty. */
void refuse(const StyleArchive& archive, const std::string& key, const std::string& fault)
{
  if (!fault.empty())
  {
    archive.fail(key, fault);
  }
}

//------------------------------------------------------------------------------
void describeCells(StyleArchive& archive, ViewsManifest& manifest)
{
  vtkNew<vtkTextureViews> views;
  archive.value("baseCells", manifest.baseCells,
    { static_cast<double>(views->GetBaseCellsMinValue()),
      static_cast<double>(views->GetBaseCellsMaxValue()) });
  archive.value("finestLevel", manifest.finestLevel,
    { static_cast<double>(views->GetFinestLevelMinValue()),
      static_cast<double>(views->GetFinestLevelMaxValue()) });
  archive.value("hemisphere", manifest.hemisphere, { 4.0, 16.0 });
  if (manifest.hemisphere != 4 && manifest.hemisphere != 8 && manifest.hemisphere != 16)
  {
    archive.fail("hemisphere", "expected 4, 8 or 16, got " + std::to_string(manifest.hemisphere));
  }
  archive.value("map", manifest.map, { "octahedral", "disk" });
}

//------------------------------------------------------------------------------
void describeMatrix(StyleArchive& archive, ManifestView& view)
{
  archive.value("matrix", view.matrix);
  view.hasMatrix = true;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(view.matrix.data());
  refuse(archive, "matrix", hachure::matrixFault(matrix));
}

//------------------------------------------------------------------------------
void describeCamera(StyleArchive& archive, ManifestView& view)
{
  if (archive.isReading() ? archive.has("matrix") : view.hasMatrix)
  {
    describeMatrix(archive, view);
    return;
  }
  ViewCamera& camera = view.camera;
  archive.require("position");
  archive.numbers("position", camera.position, 3);
  archive.require("focalPoint");
  archive.numbers("focalPoint", camera.focalPoint, 3);
  archive.numbers("viewUp", camera.viewUp, 3);
  if (archive.isReading())
  {
    camera.parallel = archive.has("parallelScale");
    if (camera.parallel && archive.has("viewAngle"))
    {
      archive.fail("viewAngle", "a camera with a parallelScale has none");
    }
  }
  if (camera.parallel)
  {
    archive.value("parallelScale", camera.parallelScale);
  }
  else
  {
    archive.value("viewAngle", camera.viewAngle);
  }
  refuse(archive, "", hachure::cameraFault(camera));
}

//------------------------------------------------------------------------------
void describeFade(StyleArchive& archive, ManifestView& view)
{
  archive.value("mode", view.fadeMode, { "curve", "middle", "even" });
  archive.value("curve", view.fadeCurve, share);
  for (std::size_t i = 1; i < view.fadeCurve.size(); ++i)
  {
    if (view.fadeCurve[i][0] < view.fadeCurve[i - 1][0])
    {
      archive.fail("curve[" + std::to_string(i) + "][0]", "angles must not become less");
    }
  }
}

//------------------------------------------------------------------------------
/** The name of a file that need not be given. */
void describeFile(StyleArchive& archive, const char* key, std::string& name)
{
  if (archive.isReading() || !name.empty())
  {
    archive.value(key, name);
  }
}

//------------------------------------------------------------------------------
void describeView(StyleArchive& archive, ManifestView& view)
{
  archive.value("name", view.name);
  archive.require("image");
  archive.value("image", view.image);
  describeFile(archive, "mask", view.mask);
  describeFile(archive, "depth", view.depth);
  if (!view.depth.empty())
  {
    archive.require("depthRange");
    archive.value("depthRange", view.depthRange);
    if (!(view.depthRange[0] < view.depthRange[1]))
    {
      archive.fail("depthRange", "expected two distances, the lesser first");
    }
  }
  archive.value("kind", view.kind, { "independent", "dependent" });
  archive.require("camera");
  archive.group("camera", [&](StyleArchive& camera) { describeCamera(camera, view); });
  archive.value("extremes", view.extremes);
  archive.group("fade", [&](StyleArchive& fade) { describeFade(fade, view); });
}

//------------------------------------------------------------------------------
void describeBlendPoint(StyleArchive& archive, ManifestBlendPoint& point)
{
  for (const char* key : { "position", "direction", "percentage" })
  {
    archive.require(key);
  }
  archive.value("position", point.position);
  archive.value("direction", point.direction);
  refuse(archive, "direction", hachure::directionFault(point.direction.data()));
  archive.value("percentage", point.percentage, percent);
}

//------------------------------------------------------------------------------
void describeManifest(StyleArchive& archive, ViewsManifest& manifest)
{
  archive.version("hachureViews", formatVersion);
  archive.group("cells", [&](StyleArchive& cells) { describeCells(cells, manifest); });
  archive.list("views", manifest.views, describeView);
  archive.list("blendPoints", manifest.blendPoints, describeBlendPoint);
}

} // namespace

namespace hachure
{

//------------------------------------------------------------------------------
std::string manifestPath(std::size_t view)
{
  return "views[" + std::to_string(view) + "]";
}

//------------------------------------------------------------------------------
ViewsManifest readManifest(const std::string& text)
{
  StyleSession session;
  session.name = "manifest";
  Json::Value root = parseJson(text, session.name);
  StyleArchive archive(session, root, "");
  ViewsManifest manifest;
  archive.describe([&](StyleArchive& top) { describeManifest(top, manifest); });
  return manifest;
}

//------------------------------------------------------------------------------
std::string writeManifest(ViewsManifest manifest)
{
  StyleSession session;
  session.name = "manifest";
  session.reading = false;
  Json::Value root(Json::objectValue);
  StyleArchive archive(session, root, "");
  describeManifest(archive, manifest);
  return jsonText(root, session.digits);
}

} // namespace hachure

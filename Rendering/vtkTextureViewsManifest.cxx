// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureViewsManifest.h"

#include "JsonText.h"
#include "PatternImageFile.h"
#include "TextureViewsFolder.h"
#include "TextureViewsJson.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextureViews.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkTextureViewsManifest);

namespace
{

using hachure::ManifestBlendPoint;
using hachure::ManifestView;
using hachure::TextureViewsFolder;
using hachure::ViewCamera;
using hachure::ViewsManifest;
using ImagePointer = vtkSmartPointer<vtkImageData>;

/** What follows a view's name in the names of its other images. */
const char* const maskEnding = "-mask";
const char* const depthEnding = "-depth";

/** An image of a view and the file that it is in. */
struct ImageInFile
{
  ImagePointer image;
  std::string fileName;
};

//------------------------------------------------------------------------------
/** Reads an image that must pass a check; `path` is that of the name in the manifest. */
template <class Check>
ImageInFile readImage(
  const TextureViewsFolder& folder, const std::string& name, const std::string& path, Check&& check)
{
  ImageInFile result;
  std::string fault;
  try
  {
    result.fileName = folder.find(name);
    result.image = hachure::readPatternImage(result.fileName);
    fault = check(result.image.Get());
    fault = fault.empty() ? "" : "\"" + name + "\": " + fault;
  }
  catch (const std::runtime_error& error)
  {
    fault = error.what();
  }
  if (!fault.empty())
  {
    throw hachure::StyleError(path + ": " + fault);
  }
  return result;
}

//------------------------------------------------------------------------------
void addCamera(const ManifestView& view, vtkImageData* image, vtkTextureViews* views)
{
  if (view.hasMatrix)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(view.matrix.data());
    views->AddView(view.name, matrix, image);
    return;
  }
  vtkNew<vtkCamera> camera;
  camera->SetPosition(view.camera.position);
  camera->SetFocalPoint(view.camera.focalPoint);
  camera->SetViewUp(view.camera.viewUp);
  camera->SetParallelProjection(view.camera.parallel);
  camera->SetParallelScale(view.camera.parallelScale);
  camera->SetViewAngle(view.camera.viewAngle);
  const int index = views->AddView(view.name, camera, image);
  views->SetViewUp(index, view.camera.viewUp); // VTK's camera has changed its length
}

//------------------------------------------------------------------------------
void addRange(const ManifestView& view, int index, vtkTextureViews* views)
{
  views->SetViewKind(index, view.kind);
  for (const auto& point : view.extremes)
  {
    views->AddExtremePoint(index, point.data());
  }
  views->SetFadeMode(index, view.fadeMode);
  views->RemoveAllFadePoints(index);
  for (const auto& point : view.fadeCurve)
  {
    views->AddFadePoint(index, point[0], point[1]);
  }
}

//------------------------------------------------------------------------------
void addView(const TextureViewsFolder& folder, const ManifestView& view, vtkTextureViews* views)
{
  const int index = views->GetNumberOfViews();
  const std::string path = hachure::manifestPath(static_cast<std::size_t>(index));
  const ImageInFile picture = readImage(folder, view.image, path + ".image", hachure::imageFault);
  addCamera(view, picture.image, views);
  views->SetViewImageFileName(index, picture.fileName);
  const auto fits = [&](vtkImageData* image, const std::string& fault)
  { return fault.empty() ? hachure::sizeFault("image", picture.image, image) : fault; };
  if (!view.mask.empty())
  {
    const ImageInFile mask = readImage(folder, view.mask, path + ".mask",
      [&](vtkImageData* image) { return fits(image, hachure::imageFault(image)); });
    views->SetViewMask(index, mask.image);
    views->SetViewMaskFileName(index, mask.fileName);
  }
  if (!view.depth.empty())
  {
    const ImageInFile depth = readImage(folder, view.depth, path + ".depth",
      [&](vtkImageData* image) { return fits(image, hachure::depthFault(image)); });
    views->SetViewDepth(index, depth.image, view.depthRange[0], view.depthRange[1]);
    views->SetViewDepthFileName(index, depth.fileName);
  }
  addRange(view, index, views);
}

//------------------------------------------------------------------------------
void readViews(const TextureViewsFolder& folder, vtkTextureViews* views)
{
  const ViewsManifest manifest = hachure::readManifest(folder.readText());
  vtkNew<vtkTextureViews> fresh;
  fresh->SetBaseCells(manifest.baseCells);
  fresh->SetFinestLevel(manifest.finestLevel);
  fresh->SetHemisphere(manifest.hemisphere);
  fresh->SetHemisphereMap(manifest.map);
  for (const ManifestView& view : manifest.views)
  {
    addView(folder, view, fresh);
  }
  for (const ManifestBlendPoint& point : manifest.blendPoints)
  {
    fresh->AddBlendPoint(point.position.data(), point.direction.data(), point.percentage);
  }
  views->ShallowCopy(fresh);
}

//------------------------------------------------------------------------------
ViewCamera cameraOf(vtkTextureViews* views, int index)
{
  vtkCamera* camera = views->GetViewCamera(index);
  ViewCamera result;
  camera->GetPosition(result.position);
  camera->GetFocalPoint(result.focalPoint);
  views->GetViewUp(index, result.viewUp);
  result.parallel = camera->GetParallelProjection() != 0;
  result.parallelScale = camera->GetParallelScale();
  result.viewAngle = camera->GetViewAngle();
  return result;
}

//------------------------------------------------------------------------------
/** All of a view but its files. */
ManifestView manifestView(vtkTextureViews* views, int index)
{
  ManifestView view;
  view.name = views->GetViewName(index);
  view.kind = views->GetViewKind(index);
  views->GetViewDepthRange(index, view.depthRange.data());
  vtkMatrix4x4* matrix = views->GetViewMatrix(index);
  view.hasMatrix = matrix != nullptr;
  if (matrix)
  {
    std::copy_n(matrix->GetData(), view.matrix.size(), view.matrix.begin());
  }
  else
  {
    view.camera = cameraOf(views, index);
  }
  view.extremes.resize(static_cast<std::size_t>(views->GetNumberOfExtremePoints(index)));
  for (std::size_t i = 0; i < view.extremes.size(); ++i)
  {
    views->GetExtremePoint(index, static_cast<int>(i), view.extremes[i].data());
  }
  view.fadeMode = views->GetFadeMode(index);
  view.fadeCurve.resize(static_cast<std::size_t>(views->GetNumberOfFadePoints(index)));
  for (std::size_t i = 0; i < view.fadeCurve.size(); ++i)
  {
    views->GetFadePoint(index, static_cast<int>(i), view.fadeCurve[i].data());
  }
  return view;
}

//------------------------------------------------------------------------------
ViewsManifest manifestOf(vtkTextureViews* views)
{
  ViewsManifest manifest;
  manifest.baseCells = views->GetBaseCells();
  manifest.finestLevel = views->GetFinestLevel();
  manifest.hemisphere = views->GetHemisphere();
  manifest.map = views->GetHemisphereMap();
  manifest.views.reserve(static_cast<std::size_t>(views->GetNumberOfViews()));
  for (int i = 0; i < views->GetNumberOfViews(); ++i)
  {
    manifest.views.push_back(manifestView(views, i));
  }
  manifest.blendPoints.resize(static_cast<std::size_t>(views->GetNumberOfBlendPoints()));
  for (std::size_t i = 0; i < manifest.blendPoints.size(); ++i)
  {
    ManifestBlendPoint& point = manifest.blendPoints[i];
    const int index = static_cast<int>(i);
    views->GetBlendPointPosition(index, point.position.data());
    views->GetBlendPointDirection(index, point.direction.data());
    point.percentage = views->GetBlendPointPercentage(index);
  }
  return manifest;
}

//------------------------------------------------------------------------------
/** The file of an image in the folder, written where there is none; empty without an image. */
std::string fileIn(TextureViewsFolder& folder, const ImageInFile& image, const std::string& view,
  const std::string& what)
{
  if (!image.image || !folder.nameOf(image.fileName).empty())
  {
    return image.image ? image.fileName : "";
  }
  // It may have been changed in place since the views have checked it.
  const std::string fault =
    what == depthEnding ? hachure::depthFault(image.image) : hachure::imageFault(image.image);
  if (!fault.empty())
  {
    throw std::runtime_error("the image of the view \"" + view + "\": " + fault);
  }
  return folder.write(image.image, view, what);
}

//------------------------------------------------------------------------------
void writeViews(TextureViewsFolder& folder, vtkTextureViews* views)
{
  struct Files
  {
    std::string picture;
    std::string mask;
    std::string depth;
  };
  ViewsManifest manifest = manifestOf(views);
  std::vector<Files> files(manifest.views.size());
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const int index = static_cast<int>(i);
    ManifestView& view = manifest.views[i];
    files[i].picture = fileIn(
      folder, { views->GetViewImage(index), views->GetViewImageFileName(index) }, view.name, "");
    files[i].mask = fileIn(folder, { views->GetViewMask(index), views->GetViewMaskFileName(index) },
      view.name, maskEnding);
    files[i].depth = fileIn(folder,
      { views->GetViewDepth(index), views->GetViewDepthFileName(index) }, view.name, depthEnding);
    view.image = folder.nameOf(files[i].picture);
    view.mask = folder.nameOf(files[i].mask);
    view.depth = folder.nameOf(files[i].depth);
  }
  folder.finish(hachure::writeManifest(manifest));
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const int index = static_cast<int>(i);
    views->SetViewImageFileName(index, files[i].picture);
    views->SetViewMaskFileName(index, files[i].mask);
    views->SetViewDepthFileName(index, files[i].depth);
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkTextureViewsManifest::vtkTextureViewsManifest() = default;

//------------------------------------------------------------------------------
vtkTextureViewsManifest::~vtkTextureViewsManifest() = default;

//------------------------------------------------------------------------------
template <class Work>
bool vtkTextureViewsManifest::Try(
  const char* caller, const char* fileName, vtkTextureViews* views, Work&& work)
{
  this->Error.clear();
  try
  {
    if (!fileName || !views)
    {
      throw std::runtime_error("expected the name of a file and views, got null");
    }
    TextureViewsFolder folder(fileName);
    work(folder);
    return true;
  }
  catch (const hachure::StyleError& error)
  {
    this->Error = std::string(fileName) + ": " + error.what();
  }
  catch (const std::exception& error)
  {
    this->Error = error.what();
  }
  vtkErrorMacro(<< caller << ": " << this->Error);
  return false;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsManifest::Read(const char* fileName, vtkTextureViews* views)
{
  return this->Try(
    "Read", fileName, views, [&](const TextureViewsFolder& folder) { readViews(folder, views); });
}

//------------------------------------------------------------------------------
bool vtkTextureViewsManifest::Write(const char* fileName, vtkTextureViews* views)
{
  return this->Try(
    "Write", fileName, views, [&](TextureViewsFolder& folder) { writeViews(folder, views); });
}

//------------------------------------------------------------------------------
void vtkTextureViewsManifest::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Error: " << this->Error << "\n";
}

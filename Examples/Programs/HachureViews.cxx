// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-views: draws a file's surface from some cameras as pictures to be painted over, with a
/// manifest from which a view-dependent texture is made of them.

#include "ErrorCollector.h"
#include "OutputFolder.h"
#include "UserError.h"
#include "ViewCameras.h"
#include "ViewDrawing.h"
#include "ViewsOptions.h"

#include <vtkNew.h>
#include <vtkTextureViews.h>
#include <vtkTextureViewsManifest.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace hachure::program
{
namespace
{
const char* const ManifestName = "views.json";

/// Kind, extreme points and fade of another object's view.
void copyRange(vtkTextureViews* from, int source, vtkTextureViews* to, int view)
{
  to->SetViewKind(view, from->GetViewKind(source));
  for (int i = 0; i < from->GetNumberOfExtremePoints(source); ++i)
  {
    double point[3];
    from->GetExtremePoint(source, i, point);
    to->AddExtremePoint(view, point);
  }
  to->SetFadeMode(view, from->GetFadeMode(source));
  to->RemoveAllFadePoints(view);
  for (int i = 0; i < from->GetNumberOfFadePoints(source); ++i)
  {
    double point[2];
    from->GetFadePoint(source, i, point);
    to->AddFadePoint(view, point[0], point[1]);
  }
}

void addView(const ViewsOptions& options, const ViewCamera& camera, const DrawnView& drawn,
  vtkTextureViews* source, vtkTextureViews* views)
{
  const int view = views->AddView(camera.name, camera.camera, drawn.picture);
  if (view < 0)
  {
    throw UserError("the camera of '" + camera.name + "' cannot be used");
  }
  if (camera.source >= 0)
  {
    double viewUp[3]; // as it stands there; cameras have changed its length
    source->GetViewUp(camera.source, viewUp);
    views->SetViewUp(view, viewUp);
  }
  views->SetViewMask(view, drawn.mask);
  views->SetViewDepth(view, drawn.depth, drawn.depthRange[0], drawn.depthRange[1]);
  if (camera.source >= 0 && !options.dependent)
  {
    copyRange(source, camera.source, views, view);
  }
  else if (options.dependent.value_or(false))
  {
    views->SetViewKind(view, vtkTextureViews::DEPENDENT);
    for (const auto& point : extremePoints(camera.camera, *options.extremeAngle))
    {
      views->AddExtremePoint(view, point.data());
    }
  }
}

/// What is written first into a folder of its own and then put into place, or goes again.
class NewFiles
{
public:
  explicit NewFiles(const fs::path& outputFolder)
    : output(outputFolder)
    , part(outputFolder / ".views.part")
    , madeOutput(makeWritableFolder(outputFolder))
  {
    fs::remove_all(this->part);
    fs::create_directory(this->part);
  }
  ~NewFiles()
  {
    std::error_code ignored;
    fs::remove_all(this->part, ignored);
    if (this->madeOutput)
    {
      fs::remove(this->output, ignored); // only succeeds when it is empty
    }
  }
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;

  void write(vtkTextureViews* views) const
  {
    const ErrorCollector errors;
    vtkNew<vtkTextureViewsManifest> manifest;
    if (!manifest->Write((this->part / ManifestName).c_str(), views))
    {
      throw std::runtime_error(manifest->GetError());
    }
  }

  /// The manifest last, so that it names no file that is not there.
  void publish(bool overwrite) const
  {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(this->part))
    {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    const auto isManifest = [](const fs::path& name) { return name == ManifestName; };
    std::stable_partition(names.begin(), names.end(), std::not_fn(isManifest));
    for (const fs::path& name : names)
    {
      if (!overwrite)
      {
        refuseExisting(this->output / name);
      }
    }
    for (const fs::path& name : names)
    {
      fs::rename(this->part / name, this->output / name);
    }
  }

  static void refuseExisting(const fs::path& file)
  {
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(file, ignored)))
    {
      throw UserError(
        "'" + file.string() + "' is there already: --overwrite replaces it, with what was painted");
    }
  }

private:
  fs::path output;
  fs::path part;
  bool madeOutput;
};

void exportViews(const ViewsOptions& options)
{
  checkWritableFolder(options.output);
  const fs::path output = options.output;
  if (!options.overwrite)
  {
    NewFiles::refuseExisting(output / ManifestName);
  }
  const auto source = readSource(options);
  const Surface surface = readSurface(options.input, options.isovalue);
  const auto cameras = viewCameras(options, surface, source);
  ViewDrawing drawing(surface, options.light);
  vtkNew<vtkTextureViews> views;
  for (const ViewCamera& camera : cameras)
  {
    const DrawnView drawn = drawing.draw(camera.camera, camera.size);
    if (drawn.isEmpty)
    {
      std::fprintf(stderr, "note: '%s' sees nothing of the surface\n", camera.name.c_str());
    }
    addView(options, camera, drawn, source, views);
  }
  const NewFiles files(output);
  files.write(views);
  files.publish(options.overwrite);
  std::fprintf(stderr, "%zu views in %s\n", cameras.size(), options.output.c_str());
}

void run(const ViewsOptions& options)
{
  switch (options.action)
  {
    case ViewsAction::Help:
      std::fputs(viewsHelpText(), stdout);
      break;
    case ViewsAction::Version:
      std::printf("hachure-views %s\n", HACHURE_VERSION);
      break;
    case ViewsAction::Export:
      exportViews(options);
      break;
  }
}
} // namespace
} // namespace hachure::program

//----------------------------------------------------------------------------
int main(int argumentCount, char** arguments)
{
  try
  {
    hachure::program::run(hachure::program::parseViewsOptions(argumentCount, arguments));
    return 0;
  }
  catch (const hachure::program::UserError& error)
  {
    std::fprintf(stderr, "hachure-views: %s\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "hachure-views: %s\n", error.what());
    return 1;
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatternCost.h"

#include "BenchmarkViews.h"
#include "DeviceMemory.h"
#include "DrawingWindow.h"
#include "ErrorCollector.h"
#include "FrameCost.h"
#include "UserError.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPatternMapper.h>
#include <vtkPatternStyle.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace hachure::benchmark
{
using hachure::program::ErrorCollector;
using hachure::program::UserError;

namespace
{
constexpr int Runs = 5;
/// Frames before measuring: buffers, shaders and textures are made, and the visibility of the
/// samples has come back.
constexpr int WarmFrames = 3;
constexpr double DegreesPerFrame = 0.5;
constexpr double WantedCoverage = 0.28;
constexpr int CoverageSteps = 6;

/// A window with one actor in front of a camera of its own.
class View
{
public:
  View(const BenchmarkOptions& options, vtkMapper* mapper)
    : window(hachure::program::makeDrawingWindow())
  {
    this->window->SetSize(options.size[0], options.size[1]);
    this->window->AddRenderer(this->renderer);
    this->renderer->SetBackground(1.0, 1.0, 1.0);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->renderer->AddActor(actor);
    this->renderer->ResetCamera();
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->Azimuth(30.0);
    camera->Elevation(20.0);
    camera->OrthogonalizeViewUp();
  }

  /// Part of the picture that is not background.
  double coverage()
  {
    this->window->Render();
    const int* size = this->window->GetSize();
    const std::size_t count = static_cast<std::size_t>(size[0]) * size[1];
    std::vector<float> depth(count);
    this->window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth.data());
    const auto drawn =
      std::count_if(depth.begin(), depth.end(), [](float value) { return value < 1.0f; });
    return static_cast<double>(drawn) / static_cast<double>(count);
  }

  void fill(double wanted)
  {
    for (int step = 0; step < CoverageSteps; ++step)
    {
      const double factor = std::sqrt(wanted / std::max(this->coverage(), 1e-3));
      this->renderer->GetActiveCamera()->Zoom(factor);
    }
  }

  void look(vtkCamera* camera)
  {
    this->renderer->GetActiveCamera()->DeepCopy(camera);
    this->renderer->ResetCameraClippingRange();
  }
  vtkCamera* camera() { return this->renderer->GetActiveCamera(); }
  vtkRenderWindow* drawn() { return this->window; }

private:
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

/// The camera's path, the same for both views.
class Path
{
public:
  explicit Path(vtkCamera* first) { this->camera->DeepCopy(first); }
  void step() { this->camera->Azimuth(DegreesPerFrame); }
  vtkNew<vtkCamera> camera;
};

void warm(View& view)
{
  for (int frame = 0; frame < WarmFrames; ++frame)
  {
    drawFrame(view.drawn(), false);
  }
}

/// One frame with the path's camera; its cost is added.
void addFrame(View& view, const Path& path, bool timeGpu, FrameCost& sum)
{
  view.look(path.camera);
  const FrameCost cost = drawFrame(view.drawn(), timeGpu);
  sum.cpu += cost.cpu;
  sum.wall += cost.wall;
  sum.gpu += cost.gpu;
}

vtkSmartPointer<vtkPatternStyle> makeStyle(const std::string& name)
{
  auto style = vtkSmartPointer<vtkPatternStyle>::New();
  const bool file = name.size() > 5 && name.substr(name.size() - 5) == ".json";
  const ErrorCollector errors;
  if (file ? !style->LoadFile(name.c_str()) : !style->LoadPreset(name.c_str()))
  {
    throw UserError("cannot use style '" + name + "': " + errors.first());
  }
  return style;
}

/// Sets the style and returns the bytes of OpenGL's objects that drawing with it takes.
std::int64_t addPattern(View& view, vtkPatternMapper* mapper, vtkPatternStyle* style)
{
  const ErrorCollector errors;
  mapper->SetStyle(nullptr);
  warm(view); // as VTK draws, with the mapper's own buffers
  const std::int64_t before = deviceBytes(view.drawn());
  mapper->SetStyle(style);
  warm(view);
  const std::int64_t after = deviceBytes(view.drawn());
  if (!errors.first().empty())
  {
    throw UserError("cannot draw the style: " + errors.first());
  }
  return after - before;
}

PatternCost compare(View& plain, View& pattern, int frames)
{
  const bool timeGpu = hasGraphicsProcessor(pattern.drawn());
  Path path(plain.camera());
  std::vector<double> plainCpu;
  std::vector<double> patternCpu;
  std::vector<double> gpu;
  std::vector<double> cpuRatio;
  std::vector<double> wallRatio;
  for (int run = 0; run < Runs; ++run)
  {
    FrameCost plainSum;
    FrameCost patternSum;
    for (int frame = 0; frame < frames; ++frame)
    {
      path.step();
      addFrame(plain, path, false, plainSum);
      addFrame(pattern, path, timeGpu, patternSum);
    }
    plainCpu.push_back(plainSum.cpu / frames);
    patternCpu.push_back(patternSum.cpu / frames);
    gpu.push_back(patternSum.gpu / frames);
    cpuRatio.push_back(patternSum.cpu / plainSum.cpu);
    wallRatio.push_back(patternSum.wall / plainSum.wall);
  }
  PatternCost cost;
  cost.plainCpu = median(plainCpu);
  cost.patternCpu = median(patternCpu);
  cost.cpuRatio = median(cpuRatio);
  cost.wallRatio = median(wallRatio);
  if (timeGpu)
  {
    cost.gpu = median(gpu);
  }
  return cost;
}
} // namespace

//----------------------------------------------------------------------------
void checkStyle(const std::string& style)
{
  makeStyle(style);
}

//----------------------------------------------------------------------------
PatternCost measure(
  vtkPolyData* surface, const LayerConfiguration& configuration, const BenchmarkOptions& options)
{
  vtkNew<vtkPolyDataMapper> plainMapper;
  plainMapper->SetInputDataObject(surface);
  vtkNew<vtkPatternMapper> patternMapper;
  patternMapper->SetInputDataObject(surface);
  const auto style = makeStyle(configuration.style);
  addViews(style, surface);

  View plain(options, plainMapper);
  plain.fill(WantedCoverage);
  const double coverage = plain.coverage();
  View pattern(options, patternMapper);
  pattern.look(plain.camera());
  warm(plain);
  const std::int64_t memory = addPattern(pattern, patternMapper, style);

  PatternCost cost = compare(plain, pattern, options.frames);
  cost.memory = memory;
  cost.coverage = coverage;
  return cost;
}
} // namespace hachure::benchmark

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// Processes that draw parts of a surface: patterns move in all of them bit for bit as on the
// surface in one process, also where a process has nothing, and their pictures together are the
// picture of one.

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkExtractCells.h>
#include <vtkFloatArray.h>
#include <vtkGeometryFilter.h>
#include <vtkIdList.h>
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkPatternMapper.h>
#include <vtkPatternStyle.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkSurfacePart.h>
#include <vtkSurfacePatches.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWholeSurface.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{
constexpr int side = 200;
constexpr int patches = 3;
constexpr int frames = 4;

// A large ball with a small one in front of it.
vtkSmartPointer<vtkPolyData> Surface()
{
  vtkNew<vtkAppendPolyData> all;
  for (const double radius : { 1.0, 0.3 })
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(radius);
    ball->SetThetaResolution(40);
    ball->SetPhiResolution(40);
    ball->SetCenter(0.0, 0.2, radius < 1.0 ? 1.6 : 0.0);
    ball->Update();
    all->AddInputData(ball->GetOutput());
  }
  all->Update();
  return all->GetOutput();
}

// The first process has the small ball and the left of the large one, the second the right, the
// others nothing.
vtkSmartPointer<vtkPolyData> Part(vtkPolyData* surface, int process)
{
  vtkNew<vtkIdList> cells;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    surface->GetCellBounds(cell, bounds);
    const int owner = bounds[5] > 1.2 || bounds[0] + bounds[1] < 0.2 ? 0 : 1;
    if (owner == process)
    {
      cells->InsertNextId(cell);
    }
  }
  vtkNew<vtkExtractCells> chosen;
  chosen->SetInputData(surface);
  chosen->SetCellList(cells);
  vtkNew<vtkGeometryFilter> polygons;
  polygons->SetInputConnection(chosen->GetOutputPort());
  polygons->Update();
  return polygons->GetOutput();
}

struct Picture
{
  std::vector<unsigned char> Colors; // three a pixel
  std::vector<float> Depth;
  std::array<double, 6 * patches> Frames{}; // of the patches
};

struct Scene
{
  vtkNew<vtkSurfacePatches> Patches;
  vtkNew<vtkWholeSurface> Whole;
  vtkNew<vtkSurfacePart> Part;
  vtkNew<vtkPatternMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;

  Scene(vtkPolyData* surface, const std::string& style, vtkMultiProcessController* controller)
  {
    this->Patches->SetMethod(vtkSurfacePatches::AUTOMATIC);
    this->Patches->SetNumberOfPatches(patches);
    this->Whole->SetController(controller);
    this->Whole->SetFilter(this->Patches);
    this->Whole->SetInputData(surface);
    this->Part->SetInputConnection(0, this->Whole->GetOutputPort(0));
    this->Part->SetInputConnection(1, this->Whole->GetOutputPort(1));
    this->Part->SetMaximumNumberOfCells(0); // as for a large surface
    this->Part->Update();
    this->Mapper->GetStyle()->LoadPreset(style);
    this->Mapper->SetInputConnection(this->Part->GetOutputPort());
    this->Mapper->SetWholeSurface(this->Whole->GetOutputDataObject(1));
    this->Mapper->SetController(controller);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(side, side);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 8.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetClippingRange(4.0, 12.0);
  }

  Picture Draw(int frame)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->Azimuth(frame > 0 ? 9.0 : 0.0);
    camera->Roll(frame > 0 ? 2.0 : 0.0);
    this->Window->Render();
    Picture picture;
    vtkNew<vtkUnsignedCharArray> colors;
    vtkNew<vtkFloatArray> depth;
    this->Window->GetPixelData(0, 0, side - 1, side - 1, 0, colors);
    this->Window->GetZbufferData(0, 0, side - 1, side - 1, depth);
    picture.Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + 3 * side * side);
    picture.Depth.assign(depth->GetPointer(0), depth->GetPointer(0) + side * side);
    for (int patch = 0; patch < patches; ++patch)
    {
      this->Mapper->GetDrawnFrame(this->Renderer, patch, &picture.Frames[6 * patch]);
    }
    return picture;
  }
};

// What is nearest of all processes' pictures.
std::vector<unsigned char> PutTogether(const Picture& own, vtkMultiProcessController* controller)
{
  const auto processes = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  std::vector<unsigned char> colors(processes * own.Colors.size());
  std::vector<float> depths(processes * own.Depth.size());
  controller->AllGather(own.Colors.data(), colors.data(), 3 * side * side);
  controller->AllGather(own.Depth.data(), depths.data(), side * side);
  std::vector<unsigned char> picture(own.Colors.size());
  for (std::size_t pixel = 0; pixel < own.Depth.size(); ++pixel)
  {
    std::size_t nearest = 0;
    for (std::size_t process = 1; process < processes; ++process)
    {
      const bool nearer =
        depths[process * own.Depth.size() + pixel] < depths[nearest * own.Depth.size() + pixel];
      nearest = nearer ? process : nearest;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      picture[3 * pixel + i] = colors[nearest * own.Colors.size() + 3 * pixel + i];
    }
  }
  return picture;
}

bool Check(const std::string& style, vtkMultiProcessController* controller)
{
  const vtkSmartPointer<vtkPolyData> surface = Surface();
  Scene alone(surface, style, nullptr);
  Scene parts(Part(surface, controller->GetLocalProcessId()), style, controller);
  bool good = true;
  for (int frame = 0; frame < frames; ++frame)
  {
    const Picture wanted = alone.Draw(frame);
    const Picture own = parts.Draw(frame);
    if (own.Frames != wanted.Frames)
    {
      std::cerr << style << ", frame " << frame << ", process " << controller->GetLocalProcessId()
                << ": the pattern lies elsewhere than on the surface in one process\n";
      good = false;
    }
    const std::vector<unsigned char> picture = PutTogether(own, controller);
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      sum += std::abs(static_cast<double>(picture[i]) - wanted.Colors[i]);
    }
    const double mean = sum / static_cast<double>(picture.size());
    constexpr double most = 0.25;
    if (!(mean < most))
    {
      std::cerr << style << ", frame " << frame << ": pictures differ by " << mean
                << ", expected less than " << most << "\n";
      good = false;
    }
  }
  return good;
}
} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  bool good = controller->GetNumberOfProcesses() == 3;
  for (const char* style : { "cross-hatch", "gabor" })
  {
    good = Check(style, controller) && good;
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

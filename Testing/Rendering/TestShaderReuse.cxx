// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shaders are built once: not again while the camera moves or values of the style change.

#include "vtkHachureCompatibility.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImagePatternLayer.h>
#include <vtkNew.h>
#include <vtkPatternMapper.h>
#include <vtkPatternStyle.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <functional>
#include <iostream>

namespace
{

struct Scene
{
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkPatternMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkPatternStyle* Style = nullptr;

  explicit Scene(double opacity)
  {
    this->Mapper->SetInputConnection(this->Sphere->GetOutputPort());
    this->Style = this->Mapper->GetStyle();
    this->Style->LoadPreset("cross-hatch");
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(128, 128);
    this->Window->AddRenderer(this->Renderer);
    this->Window->Render();
    this->Move();
    this->Window->Render();
  }

  void Move()
  {
    this->Renderer->GetActiveCamera()->Azimuth(10.0);
    this->Renderer->ResetCameraClippingRange();
  }

  // Programs that exist: VTK keeps all that it has built.
  int Programs()
  {
    this->Window->MakeCurrent();
    int programs = 0;
    const GLuint next = glCreateProgram(); // above all names in use
    for (GLuint name = 1; name < next; ++name)
    {
      programs += glIsProgram(name) == GL_TRUE ? 1 : 0;
    }
    glDeleteProgram(next);
    return programs;
  }
};

bool passed = true;

void check(Scene& scene, const char* what, bool builds, const std::function<void()>& change)
{
  const int before = scene.Programs();
  for (int frame = 0; frame < 3; ++frame)
  {
    change();
    scene.Window->Render();
  }
  const int built = scene.Programs() - before;
  if ((built > 0) != builds)
  {
    std::cerr << what << ": " << built << " shader programs were built\n";
    passed = false;
  }
}

void testScene(double opacity)
{
  Scene scene(opacity);
  auto* layer = vtkImagePatternLayer::SafeDownCast(scene.Style->GetLayer(0));
  double value = 0.0;
  check(scene, "camera", false, [&] { scene.Move(); });
  check(scene, "zoom", false, [&] { scene.Renderer->GetActiveCamera()->Zoom(1.3); });
  check(scene, "size", false, [&] { layer->SetSize(7.0 + (value += 1.0)); });
  check(scene, "angle", false, [&] { layer->SetAngle(value += 1.0); });
  check(scene, "colours", false,
    [&]
    {
      layer->SetColor(0.2, 0.01 * (value += 1.0), 0.0);
      scene.Style->SetPaperColor(1.0, 1.0, 0.01 * value);
      scene.Style->SetOutlineColor(0.01 * value, 0.0, 0.0);
    });
  check(scene, "pattern", false, [&] { layer->SetPattern(vtkImagePatternLayer::HALFTONE); });
  check(scene, "gamma", false, [&] { layer->GetTone()->SetGamma(value += 1.0); });
  check(scene, "actor", false, [&] { scene.Actor->AddPosition(0.1, 0.0, 0.0); });
  check(scene, "window", false,
    [&] { scene.Window->SetSize(100 + static_cast<int>(value += 1.0), 90); });
  // The check sees shaders that are built.
  check(scene, "second layer", true,
    [&]
    {
      if (scene.Style->GetNumberOfLayers() == 1)
      {
        scene.Style->AddLayer(vtkNew<vtkImagePatternLayer>());
      }
    });
}

} // namespace

int TestShaderReuse(int, char*[])
{
  testScene(1.0);
  testScene(0.5);
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

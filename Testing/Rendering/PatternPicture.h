// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternPicture_h
#define PatternPicture_h

#include "StrictImageComparison.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPatternMapper.h>
#include <vtkPatternStyle.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

// Draws a torus in one of the built-in styles after a turn of the camera and compares the picture
// strictly with that of -V.
inline int testPatternPicture(const char* preset, int argc, char* argv[])
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(1.0);
  torus->SetCrossSectionRadius(0.45);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  vtkNew<vtkPatternMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  if (!mapper->GetStyle()->LoadPreset(preset))
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(256, 256);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -4.4, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  for (int step = 0; step < 6; ++step)
  {
    camera->Azimuth(4.0);
    camera->Zoom(1.02);
    renderer->ResetCameraClippingRange();
    window->Render();
  }
  // A few pixels that rounding puts on the other side; strokes elsewhere make thousands.
  constexpr double allowedError = 10.0;
  return strict::regressionTest(window, argc, argv, allowedError);
}

#endif

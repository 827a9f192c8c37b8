// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// What is drawn: one window, one surface in a style, camera lights, white paper.

#ifndef Scene_h
#define Scene_h

#include "CameraLights.h"
#include "LinearImage.h"
#include "RenderOptions.h"
#include "SurfaceInput.h"
#include "ViewFit.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPatternStyle.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace hachure::program
{
class Scene
{
public:
  /// Reads style and surface and checks the array. Throws UserError. Opens no window.
  explicit Scene(const RenderOptions& options);
  ~Scene();

  vtkPatternStyle* style() const { return this->patternStyle; }
  vtkActor* surfaceActor() const { return this->actor; }
  vtkCamera* camera() const;

  void setView(const TurntableView& view);
  /// Of the animation, in seconds: what patterns do little by little goes by it.
  void setTime(double time);
  void setLights(const std::vector<CameraLight>& lights) { lightFrom(this->renderer, lights); }

  /// Draws and reads the picture back, the supersampling factor larger than the output.
  Picture draw();

private:
  void makeStyle(const RenderOptions& options);
  void makeSurface(const RenderOptions& options);
  void fitView(const RenderOptions& options);
  void openWindow();

  int pictureWidth;
  int pictureHeight;
  Surface surface;
  Turntable turntable;
  vtkSmartPointer<vtkPatternStyle> patternStyle;
  vtkNew<vtkActor> actor;
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkRenderWindow> window;
};

/// Names of all styles, in their stable order.
std::vector<std::string> styleNames();
} // namespace hachure::program

#endif

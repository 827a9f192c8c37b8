// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Draws a surface as a picture to be painted over, with its mask and its depth.

#ifndef ViewDrawing_h
#define ViewDrawing_h

#include "SurfaceInput.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkCamera;

namespace hachure::program
{
struct DrawnView
{
  vtkSmartPointer<vtkImageData> picture; ///< RGBA of 8 bits; alpha: 255 on the surface, else 0
  vtkSmartPointer<vtkImageData> mask;    ///< 8 bits: 255 on the surface, else 0
  vtkSmartPointer<vtkImageData> depth;   ///< 16 bits, as vtkTextureViews has them
  std::array<double, 2> depthRange;      ///< of the depth, in units of the surface
  bool isEmpty = false;                  ///< the camera sees nothing of the surface
};

class ViewDrawing
{
public:
  /// light: degrees right of and above the viewer. Opens a window; throws UserError without
  /// display.
  ViewDrawing(const Surface& surface, const std::array<double, 2>& light);

  /// Throws std::runtime_error when drawing fails.
  DrawnView draw(vtkCamera* camera, const std::array<int, 2>& size);

private:
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkRenderWindow> window;
};
} // namespace hachure::program

#endif

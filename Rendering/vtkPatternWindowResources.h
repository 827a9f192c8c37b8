// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Images that all pattern mappers of one window share: the attribute images of the object that is
 * being drawn, and a copy of the finished picture's depth.
 */
#ifndef vtkPatternWindowResources_h
#define vtkPatternWindowResources_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <array>
#include <memory>

class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkPatternWindowResources
{
public:
  /// The resources of a window; they live as long as someone holds them.
  static std::shared_ptr<vtkPatternWindowResources> Get(vtkOpenGLRenderWindow* window);

  /// Makes the attribute images as large as the window's framebuffer. False where the framebuffer
  /// cannot be made.
  bool Prepare(vtkOpenGLRenderWindow* window);

  /// Copies a rectangle (x, y, width, height) of the depth of the framebuffer that is drawn to.
  vtkTextureObject* CaptureDepth(
    vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle);

  void ReleaseGraphicsResources(vtkWindow* window);

  static constexpr unsigned int AttributeCount = 3; ///< colour attachments
  vtkNew<vtkOpenGLFramebufferObject> AttributeFramebuffer;
  vtkNew<vtkTextureObject> SurfaceColor;  ///< display-referred colour; alpha: 1 - half drawn edge
  vtkNew<vtkTextureObject> SurfaceTone;   ///< tones of three channels; alpha: 0 without data
  vtkNew<vtkTextureObject> SurfaceNormal; ///< normal in view coordinates, packed into one float
  vtkNew<vtkTextureObject> SurfaceDepth;  ///< window depth

private:
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  std::array<int, 2> DepthSize = { 0, 0 };
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternWindowResources.h

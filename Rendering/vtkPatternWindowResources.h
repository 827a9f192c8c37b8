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
#include "vtkPatternLayerPainter.h"
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

  /// Makes the attribute images, with those that layers on the surface need, as large as the
  /// window's framebuffer. False where the framebuffer cannot be made.
  bool Prepare(vtkOpenGLRenderWindow* window, vtkPatternLayerPainter::SurfaceNeed need);

  /// Copies a rectangle (x, y, width, height) of the depth of the framebuffer that is drawn to.
  vtkTextureObject* CaptureDepth(
    vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle);

  void ReleaseGraphicsResources(vtkWindow* window);

  /// Colour attachments that are drawn to.
  static unsigned int AttributeCount(vtkPatternLayerPainter::SurfaceNeed need);
  vtkNew<vtkOpenGLFramebufferObject> AttributeFramebuffer;
  vtkNew<vtkTextureObject> SurfaceColor;  ///< display-referred colour; alpha: 1 - half drawn edge
  vtkNew<vtkTextureObject> SurfaceTone;   ///< tones of three channels; alpha: 0 without data
  vtkNew<vtkTextureObject> SurfaceNormal; ///< normal in view coordinates, packed into one float
  vtkNew<vtkTextureObject> SurfaceDepth;  ///< window depth

  vtkNew<vtkTextureObject> SurfacePoint;   ///< model coordinates; w: packed normal of the triangle
  vtkNew<vtkTextureObject> SurfaceTexture; ///< texture coordinates; z: 1 where there are some
  vtkNew<vtkTextureObject> SurfaceTextureSlopes; ///< their change along x (xy) and y (zw)

private:
  vtkPatternLayerPainter::SurfaceNeed Need = vtkPatternLayerPainter::NOTHING; // of the images made
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  std::array<int, 2> DepthSize = { 0, 0 };
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternWindowResources.h

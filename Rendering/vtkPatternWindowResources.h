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
#include "vtkPatternAttributes.h"
#include "vtkTextureObject.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkPatternWindowResources
{
public:
  /// The resources of a window; they live as long as someone holds them.
  static std::shared_ptr<vtkPatternWindowResources> Get(vtkOpenGLRenderWindow* window);

  /// Makes the attribute images that are needed as large as the window's framebuffer, and the
  /// framebuffer of them. False where it cannot be made.
  bool Prepare(vtkOpenGLRenderWindow* window, const vtkPatternAttributes& attributes);

  /// Makes AttributeFramebuffer the one that is drawn to. The caller keeps the bindings.
  void BeginAttributes();

  /// Makes DrawnFramebuffer the one that is drawn to, with the depth of the attribute stage in a
  /// rectangle (x, y, width, height). The caller keeps the bindings.
  void BeginLayers(vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle);

  /// Copies a rectangle (x, y, width, height) of the depth of the framebuffer that is drawn to.
  vtkTextureObject* CaptureDepth(
    vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle);

  /// Window depth of the attribute stage in a rectangle, row by row from the bottom.
  std::vector<float> ReadDepth(vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle);
  /// The four bytes of its pixels in COLOR or TONE.
  std::vector<std::uint8_t> ReadBytes(vtkOpenGLRenderWindow* window,
    const std::array<int, 4>& rectangle, vtkPatternAttributes::Image image);

  void ReleaseGraphicsResources(vtkWindow* window);

  vtkTextureObject* GetImage(vtkPatternAttributes::Image image) { return this->Images[image]; }
  vtkNew<vtkOpenGLFramebufferObject> AttributeFramebuffer;
  vtkNew<vtkTextureObject> SurfaceDepth; ///< window depth

  /// Layers are drawn to a colour image under a depth of their own, a copy of SurfaceDepth, so that
  /// the depth test finds what is covered.
  vtkNew<vtkOpenGLFramebufferObject> DrawnFramebuffer;
  vtkNew<vtkTextureObject> DrawnColor;

private:
  bool Attach(vtkOpenGLRenderWindow* window, const vtkPatternAttributes& attributes);
  bool AttachDrawn(vtkOpenGLRenderWindow* window);

  vtkNew<vtkTextureObject> DrawnDepth;
  std::array<vtkNew<vtkTextureObject>, vtkPatternAttributes::IMAGE_COUNT> Images;
  vtkPatternAttributes Attached;
  std::array<int, 2> Size = { 0, 0 }; // of the images made
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  std::array<int, 2> DepthSize = { 0, 0 };
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternWindowResources.h

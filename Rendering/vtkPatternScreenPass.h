// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The second stage of drawing an opaque object: evaluates the layers and the outline once per pixel
 * that the attribute images cover, and writes colour and depth under the normal depth test.
 */
#ifndef vtkPatternScreenPass_h
#define vtkPatternScreenPass_h

#include "PatternTracker.h"
#include "vtkPatternQuad.h"

#include <array>
#include <string>
#include <vector>

class vtkActor;
class vtkOpenGLRenderWindow;
class vtkPatternCompositor;
class vtkPatternStyle;
class vtkPatternWindowResources;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;
struct vtkPatternViewport;

class vtkPatternScreenPass
{
public:
  vtkPatternScreenPass();
  ~vtkPatternScreenPass();

  struct Scene
  {
    vtkRenderer* Renderer;
    vtkActor* Actor;
    vtkOpenGLRenderWindow* Window;
    vtkPatternStyle* Style;
    const vtkPatternViewport& Viewport;
    std::array<int, 4> Rectangle;                     // x, y, width, height in the framebuffer
    const std::vector<hachure::PatternFrame>& Frames; // per patch
    std::array<double, 3> NanColor;
    vtkTextureObject* PatchRecords; // null where there are no patches
    vtkTextureObject* PatchWeights; // of the records
  };

  /// False where the shader of the style does not compile.
  bool Draw(
    const Scene& scene, vtkPatternWindowResources& resources, vtkPatternCompositor& compositor);
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Width of a style's outline in framebuffer pixels, 0 without outline.
  static double OutlineWidth(vtkPatternStyle* style, const vtkPatternViewport& viewport);

private:
  vtkShaderProgram* Prepare(const Scene& scene, vtkPatternCompositor& compositor);
  static std::string TextOf(vtkPatternStyle* style, vtkPatternCompositor& compositor, bool outline);
  static void SetOutline(const Scene& scene, vtkShaderProgram* program);
  static void SetUnprojection(const Scene& scene, vtkShaderProgram* program);
  void DrawLayers(const Scene& scene, vtkPatternWindowResources& resources);
  bool Place(const Scene& scene, vtkPatternWindowResources& resources);

  vtkPatternQuad Quad;
  std::string Text;
  std::string VertexText; // made of it, as is the next one
  std::string FragmentText;
  vtkPatternQuad PlaceQuad;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternScreenPass.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tones of a translucent surface, layer by layer from the front, for what must know them before
 * it is drawn: every pass draws its attributes behind those of the pass before.
 */
#ifndef vtkPatternTonePeel_h
#define vtkPatternTonePeel_h

#include "vtkNew.h"
#include "vtkPatternLayerPainter.h"
#include "vtkTextureObject.h"

#include <array>
#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternWindowResources;
class vtkShaderProgram;
class vtkWindow;

class vtkPatternTonePeel
{
public:
  using Image = vtkPatternLayerPainter::FieldScene::ToneImage;

  /// More layers are not looked at; a sphere has two.
  static constexpr std::size_t MostLayers = 8;

  /// draw: draws the attributes of a rectangle (x, y, width, height) into the images of
  /// `resources`, with a shader that leaves out what SetUniforms() asks it to.
  std::vector<Image> Peel(vtkOpenGLRenderWindow* window, vtkPatternWindowResources& resources,
    const std::array<int, 4>& rectangle, const std::function<void()>& draw);
  void SetUniforms(vtkShaderProgram* program) const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Upload(vtkOpenGLRenderWindow* window, std::vector<float> depth);

  vtkNew<vtkTextureObject> Before; // window depth of the layer before
  std::array<int, 4> Rectangle = { 0, 0, 0, 0 };
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternTonePeel.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Between the attribute stage and the layers of an opaque surface: fields that are made for the
 * pixels that show it.
 */
#ifndef vtkPatternFieldStage_h
#define vtkPatternFieldStage_h

#include "vtkPatternLayerPainter.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternCompositor;
class vtkPatternNoiseHistory;
class vtkPatternStippleHistory;
class vtkPatternSurface;
class vtkPatternWindowResources;

struct vtkPatternFieldStage
{
  vtkOpenGLRenderWindow* Window;
  vtkPatternWindowResources& Resources; // the attribute images of the surface
  vtkPatternSurface& Surface;
  vtkPatternSurface& Steering; // as FieldScene has it
  bool CarriesStipples;
  vtkPatternNoiseHistory* History;          // null: nothing is remembered
  vtkPatternStippleHistory* StippleHistory; // the same
  bool LookOn;                              // what is remembered stays
  bool SecondEye;                           // of one picture
  glm::dmat4 ModelToClip;
  std::array<int, 4> Viewport;  // x, y, width, height in the framebuffer
  std::array<int, 4> Rectangle; // that the attribute stage has drawn
  glm::dvec3 Center;            // of the surface's bounds
  int NoiseBackEnd;             // as vtkNoiseBackEnd takes it
  unsigned long Frame;          // of the renderer
  /// Tones of a translucent surface, from the front; draws it to find them.
  std::function<const std::vector<vtkPatternLayerPainter::FieldScene::ToneImage>&()> PeelTones;

  /// Draws the fields of all layers that need it. Returns what is wrong with the data, empty where
  /// all is well. Throws std::exception with the reason where nothing can be drawn.
  std::string Draw(vtkPatternCompositor& compositor) const;
  /// The same before a translucent surface is drawn: without attribute images.
  std::string DrawForward(vtkPatternCompositor& compositor) const;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternFieldStage.h

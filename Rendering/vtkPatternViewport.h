// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a renderer's picture lies in the framebuffer and in the logical picture.
 *
 * Logical pixels are those of the picture as the user sees it: y up, origin at the lower left
 * corner of the renderer's viewport. Tiles of a large screenshot, supersampling and HiDPI windows
 * only change how many framebuffer pixels a logical pixel has.
 */
#ifndef vtkPatternViewport_h
#define vtkPatternViewport_h

#include "SampleProjection.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

class vtkMatrix4x4;
class vtkProp3D;
class vtkRenderer;

struct vtkPatternViewport
{
  vtkPatternViewport(vtkRenderer* renderer, double pixelScale);

  /// Lower left corner and size of the drawn part, framebuffer pixels.
  std::array<int, 4> Drawn;
  /// Logical position of a fragment: fragment * xy + zw.
  glm::dvec4 FragmentToLogical;
  /// Whole viewport, logical pixels.
  glm::dvec2 LogicalSize;
  /// Framebuffer pixels per logical pixel.
  double PixelsPerLogical;
  /// Part of a picture that is drawn in tiles.
  bool IsTile;

  /// Puts the drawn part elsewhere in the framebuffer.
  void MoveTo(int left, int bottom);

  /// What the renderer's camera sees of a prop, with the whole (untiled) viewport as clip space.
  /// In stereo the view of the middle between the eyes, the same as without stereo.
  hachure::ViewProjection View(vtkRenderer* renderer, vtkProp3D* prop) const;
  /// The same for the eye that is being drawn.
  hachure::ViewProjection EyeView(vtkRenderer* renderer, vtkProp3D* prop) const;

private:
  hachure::ViewProjection Whole(const glm::dmat4& modelToView, glm::dmat4 projection) const;
  glm::dvec4 TileToWhole; // whole clip xy = tile clip xy * xy + w * zw
};

namespace vtkPattern
{
glm::dmat4 ToGlm(vtkMatrix4x4* matrix);
/// The camera's projection as drawn, depth in [-1, 1].
glm::dmat4 DrawnProjection(vtkRenderer* renderer);
/// Pixels (x, y, width, height) of a viewport that a box can cover, and a margin around them; all
/// of the viewport where the box reaches behind the camera.
std::array<int, 4> CoveredRectangle(const double bounds[6], const glm::dmat4& modelToClip,
  const std::array<int, 4>& viewport, int margin);
/// The smallest rectangle (x, y, width, height) around two others.
std::array<int, 4> Union(const std::array<int, 4>& a, const std::array<int, 4>& b);
/// Model to view coordinates.
glm::dmat4 ModelView(vtkRenderer* renderer, vtkProp3D* prop);
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternViewport.h

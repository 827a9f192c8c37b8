// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws the swatches of a legend: a flat surface whose values are those of the swatches, which the
 * pattern mapper draws into a picture of its own, in the OpenGL context of a window.
 */
#ifndef hachure_PatternLegendPicture_h
#define hachure_PatternLegendPicture_h

#include "PatternLegendKey.h"
#include "PatternLegendLayout.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkActor;
class vtkImageData;
class vtkLookupTable;
class vtkOpenGLRenderWindow;
class vtkPatternLegendWindow;
class vtkPatternMapper;
class vtkPatternStyle;
class vtkPolyData;
class vtkRenderer;

namespace hachure
{

struct LegendPictureScene
{
  std::vector<LegendSwatch> swatches;
  LegendLayout layout;
  bool vertical = true;
  double pixelsPerLogical = 1.0;
};

/// Logical pixels of surface around all swatches, on which no mark is missing.
constexpr int legendMargin = 24;

/// The flat surface, a model unit per logical pixel, the lower left corner of the layout at the
/// origin.
vtkSmartPointer<vtkPolyData> legendSurface(
  const PatternLegendKey& key, const LegendPictureScene& scene);

class PatternLegendPicture
{
public:
  PatternLegendPicture();
  ~PatternLegendPicture();
  PatternLegendPicture(const PatternLegendPicture&) = delete;
  PatternLegendPicture& operator=(const PatternLegendPicture&) = delete;

  /// Draws the swatches in the window's context, and leaves the window's state as it was. The
  /// picture, of four bytes a pixel, reaches legendMargin beyond the swatches. Null where OpenGL
  /// cannot draw it.
  vtkSmartPointer<vtkImageData> draw(vtkOpenGLRenderWindow* window, vtkPatternStyle* style,
    const PatternLegendKey& key, const LegendPictureScene& scene);
  void releaseGraphicsResources();

private:
  void UpdateStyle(
    vtkPatternStyle* style, const PatternLegendKey& key, double area, double pixelsPerLogical);
  void Look(const std::array<int, 4>& area);
  vtkSmartPointer<vtkImageData> Render(vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkPatternLegendWindow> Window;
  vtkWeakPointer<vtkOpenGLRenderWindow> Owner;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPatternMapper> Mapper;
  vtkNew<vtkPatternStyle> Style;
  vtkNew<vtkLookupTable> NoTable; // where the surface has none
};

/// Lower left corner and size of the picture, logical pixels.
std::array<int, 4> legendArea(const LegendLayout& layout);

} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: PatternLegendPicture.h

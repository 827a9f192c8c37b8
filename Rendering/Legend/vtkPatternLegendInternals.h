// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the parts of vtkPatternLegendActor's implementation share. Internal.
#ifndef vtkPatternLegendInternals_h
#define vtkPatternLegendInternals_h

#include "PatternLegendKey.h"
#include "PatternLegendLayout.h"
#include "PatternLegendPicture.h"
#include "PatternLegendSheet.h"
#include "vtkPatternLegendActor.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

namespace hachure
{
/// Style, colours and lookup table of an actor that a vtkPatternMapper draws; null: of none.
LegendSurface legendSurfaceOf(vtkActor* actor);
} // namespace hachure

struct vtkPatternLegendActor::Internals
{
  /// What draws in a window: textures that go from one to another are released in the wrong one.
  /// Drawn: pictures of swatches with all that they depend on; a few, for views of several sizes
  /// and for screenshots.
  struct WindowPart
  {
    hachure::PatternLegendPicture Painter;
    hachure::PatternLegendSheet Sheet;
    std::vector<std::pair<std::string, vtkSmartPointer<vtkImageData>>> Drawn;
  };

  std::vector<hachure::LegendSwatch> Categories; // of the user
  std::map<vtkWindow*, std::unique_ptr<WindowPart>> Pictures;
  WindowPart& PartOf(vtkWindow* window)
  {
    std::unique_ptr<WindowPart>& part = this->Pictures[window];
    part = part ? std::move(part) : std::make_unique<WindowPart>();
    return *part;
  }
  std::string Reported;
  std::vector<hachure::LegendSwatch> ShownSwatches;
  std::vector<hachure::LegendRectangle> ShownPlaces; // pixels
  std::vector<hachure::LegendLabel> ShownLabels;
};

/// One picture of a legend.
struct vtkPatternLegendActor::Drawing
{
  Drawing(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, Internals::WindowPart& part,
    const hachure::LegendSurface& surface);

  hachure::LegendRectangle InPixels(const hachure::LegendRectangle& logical) const;
  std::array<int, 2> InPixels(double x, double y) const;
  /// Height of a line, and about the width of a text, logical pixels.
  int LineHeight(vtkTextProperty* font) const;
  int TextWidth(vtkTextProperty* font, const std::string& text) const;

  vtkRenderer* Renderer;
  vtkOpenGLRenderWindow* Window;
  Internals::WindowPart& Part;
  hachure::LegendSurface Surface;
  hachure::PatternLegendKey Key;
  int Resolution; // of texts, dots per inch, before the pixels of the picture count
  hachure::LegendPictureScene Scene;
  int Mode = CONTINUOUS;
  bool Nan = false;            // the last swatch is for no number
  std::vector<double> Borders; // values where steps meet
  std::vector<hachure::LegendLabel> Labels;
  bool Ticks = false;
  std::array<int, 2> Corner{}; // of the box, logical pixels of the viewport
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternLegendInternals.h

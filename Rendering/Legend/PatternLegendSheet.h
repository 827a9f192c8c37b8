// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pieces of a picture, even rectangles and texts, drawn over a viewport at pixels.
 */
#ifndef hachure_PatternLegendSheet_h
#define hachure_PatternLegendSheet_h

#include "PatternLegendLayout.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkActor2D;
class vtkImageData;
class vtkPolyData;
class vtkTextActor;
class vtkTextProperty;
class vtkTexture;
class vtkTexturedActor2D;
class vtkViewport;
class vtkWindow;

namespace hachure
{

/// Rectangles in pixels; those of the picture's pieces count from its lower left corner.
struct LegendPiece
{
  LegendRectangle from;
  std::array<int, 2> to;
};

class PatternLegendSheet
{
public:
  PatternLegendSheet();
  ~PatternLegendSheet();

  void drawPicture(
    vtkViewport* viewport, vtkImageData* picture, const std::vector<LegendPiece>& pieces);
  void drawRectangles(vtkViewport* viewport, const std::vector<LegendRectangle>& rectangles,
    const std::array<double, 3>& color);
  /// index: of the texts of a picture, so that those of the picture before serve again.
  /// scale: factor on the font's size.
  void drawText(vtkViewport* viewport, std::size_t index, const std::string& text,
    vtkTextProperty* font, const std::array<int, 2>& place, double scale);
  void releaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkPolyData> Pieces;
  vtkNew<vtkTexture> Texture;
  vtkNew<vtkTexturedActor2D> Picture;
  vtkNew<vtkPolyData> Rectangles;
  vtkNew<vtkActor2D> Even;
  std::vector<vtkSmartPointer<vtkTextActor>> Texts;
};

} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: PatternLegendSheet.h

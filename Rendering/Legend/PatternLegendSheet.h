// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pieces of a picture, even rectangles and texts, drawn over a viewport at pixels.
 */
#ifndef hachure_PatternLegendSheet_h
#define hachure_PatternLegendSheet_h

#include "PatternLegendLayout.h"
#include "vtkNew.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkActor2D;
class vtkImageData;
class vtkPolyData;
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
  /// At a place that the font's justification tells of, whatever the window says of its resolution.
  /// index: of the texts of a picture, so that those of the picture before serve again.
  void drawText(vtkViewport* viewport, std::size_t index, const std::string& text,
    vtkTextProperty* font, const std::array<int, 2>& place, int dotsPerInch);
  void releaseGraphicsResources(vtkWindow* window);

private:
  // What draws pieces of a picture.
  struct Pieces
  {
    Pieces();
    void Draw(vtkViewport* viewport, vtkImageData* picture, const std::vector<LegendPiece>& pieces);
    vtkNew<vtkPolyData> Quads;
    vtkNew<vtkTexture> Texture;
    vtkNew<vtkTexturedActor2D> Actor;
  };
  struct Text
  {
    std::string Key; // all that it depends on
    vtkNew<vtkImageData> Picture;
    std::array<int, 2> Size{};
    Pieces Drawn;
  };

  Pieces Swatches;
  vtkNew<vtkPolyData> Rectangles;
  vtkNew<vtkActor2D> Even;
  std::vector<std::unique_ptr<Text>> Texts;
};

} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: PatternLegendSheet.h

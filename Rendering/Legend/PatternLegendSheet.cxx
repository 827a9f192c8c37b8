// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternLegendSheet.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkTexture.h"
#include "vtkTexturedActor2D.h"
#include "vtkViewport.h"

#include <sstream>

namespace hachure
{
namespace
{
void addRectangle(vtkPoints* points, vtkCellArray* cells, const LegendRectangle& rectangle)
{
  const vtkIdType first = points->GetNumberOfPoints();
  for (int corner = 0; corner < 4; ++corner)
  {
    const int right = corner == 1 || corner == 2 ? 1 : 0;
    const int up = corner / 2;
    points->InsertNextPoint(
      rectangle[0] + right * rectangle[2], rectangle[1] + up * rectangle[3], 0.0);
  }
  const vtkIdType ids[] = { first, first + 1, first + 2, first + 3 };
  cells->InsertNextCell(4, ids);
}

void addTextureRectangle(
  vtkFloatArray* coordinates, const LegendRectangle& rectangle, const int* size)
{
  for (int corner = 0; corner < 4; ++corner)
  {
    const int right = corner == 1 || corner == 2 ? 1 : 0;
    const int up = corner / 2;
    coordinates->InsertNextTuple2(
      static_cast<double>(rectangle[0] + right * rectangle[2]) / size[0],
      static_cast<double>(rectangle[1] + up * rectangle[3]) / size[1]);
  }
}

void prepare(vtkActor2D* actor)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
}

void draw(vtkActor2D* actor, vtkPolyData* data, vtkViewport* viewport)
{
  auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper());
  if (mapper->GetInput() != data)
  {
    mapper->SetInputData(data);
  }
  actor->RenderOverlay(viewport);
}

std::string textKey(const std::string& text, vtkTextProperty* font, int dotsPerInch)
{
  const double* color = font->GetColor();
  std::ostringstream key;
  key << font->GetFontFamily() << ' ' << (font->GetFontFile() ? font->GetFontFile() : "") << ' '
      << font->GetFontSize() << ' ' << font->GetBold() << font->GetItalic() << font->GetShadow()
      << ' ' << color[0] << ' ' << color[1] << ' ' << color[2] << ' ' << font->GetOpacity() << ' '
      << dotsPerInch << ' ' << text;
  return key.str();
}

// Before a place of this justification, which is one of left, centred and right, or the same
// upwards.
int before(int justification, int centered, int first, int extent)
{
  return justification == first ? 0 : justification == centered ? extent / 2 : extent;
}
} // namespace

PatternLegendSheet::Pieces::Pieces()
{
  prepare(this->Actor);
  this->Texture->InterpolateOff(); // a texel is a pixel
  this->Texture->RepeatOff();
  this->Actor->SetTexture(this->Texture);
}

void PatternLegendSheet::Pieces::Draw(
  vtkViewport* viewport, vtkImageData* picture, const std::vector<LegendPiece>& pieces)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  const int* size = picture->GetDimensions();
  for (const LegendPiece& piece : pieces)
  {
    addRectangle(points, cells, { piece.to[0], piece.to[1], piece.from[2], piece.from[3] });
    addTextureRectangle(coordinates, piece.from, size);
  }
  this->Quads->SetPoints(points);
  this->Quads->SetPolys(cells);
  this->Quads->GetPointData()->SetTCoords(coordinates);
  if (this->Texture->GetInput() != picture)
  {
    this->Texture->SetInputData(picture);
  }
  draw(this->Actor, this->Quads, viewport);
}

PatternLegendSheet::PatternLegendSheet()
{
  prepare(this->Even);
}

PatternLegendSheet::~PatternLegendSheet() = default;

void PatternLegendSheet::drawPicture(
  vtkViewport* viewport, vtkImageData* picture, const std::vector<LegendPiece>& pieces)
{
  this->Swatches.Draw(viewport, picture, pieces);
}

void PatternLegendSheet::drawRectangles(vtkViewport* viewport,
  const std::vector<LegendRectangle>& rectangles, const std::array<double, 3>& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const LegendRectangle& rectangle : rectangles)
  {
    addRectangle(points, cells, rectangle);
  }
  this->Rectangles->SetPoints(points);
  this->Rectangles->SetPolys(cells);
  this->Even->GetProperty()->SetColor(color[0], color[1], color[2]);
  if (!rectangles.empty())
  {
    draw(this->Even, this->Rectangles, viewport);
  }
}

// vtkTextActor takes the scale of tiles for the size of fonts in some versions of VTK.
void PatternLegendSheet::drawText(vtkViewport* viewport, std::size_t index, const std::string& text,
  vtkTextProperty* font, const std::array<int, 2>& place, int dotsPerInch)
{
  while (this->Texts.size() <= index)
  {
    this->Texts.push_back(std::make_unique<Text>());
  }
  Text& own = *this->Texts[index];
  vtkTextRenderer* const writer = vtkTextRenderer::GetInstance();
  const std::string key = textKey(text, font, dotsPerInch);
  if (own.Key != key && writer)
  {
    vtkNew<vtkTextProperty> plain;
    plain->ShallowCopy(font);
    plain->SetJustificationToLeft();
    plain->SetVerticalJustificationToBottom();
    const bool written =
      writer->RenderString(plain, text, own.Picture, own.Size.data(), dotsPerInch);
    own.Key = written ? key : std::string();
  }
  if (!own.Key.empty() && own.Size[0] > 0 && own.Size[1] > 0)
  {
    const int x =
      place[0] - before(font->GetJustification(), VTK_TEXT_CENTERED, VTK_TEXT_LEFT, own.Size[0]);
    const int y = place[1] -
      before(font->GetVerticalJustification(), VTK_TEXT_CENTERED, VTK_TEXT_BOTTOM, own.Size[1]);
    own.Drawn.Draw(viewport, own.Picture, { { { 0, 0, own.Size[0], own.Size[1] }, { x, y } } });
  }
}

void PatternLegendSheet::releaseGraphicsResources(vtkWindow* window)
{
  this->Swatches.Actor->ReleaseGraphicsResources(window);
  this->Even->ReleaseGraphicsResources(window);
  for (const auto& text : this->Texts)
  {
    text->Drawn.Actor->ReleaseGraphicsResources(window);
  }
}

} // namespace hachure

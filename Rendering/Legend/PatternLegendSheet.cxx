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
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTexturedActor2D.h"
#include "vtkViewport.h"

#include <cmath>

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
    coordinates->InsertNextTuple2(static_cast<double>(rectangle[0] + right * rectangle[2]) / size[0],
      static_cast<double>(rectangle[1] + up * rectangle[3]) / size[1]);
  }
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
} // namespace

PatternLegendSheet::PatternLegendSheet()
{
  for (vtkActor2D* actor : { static_cast<vtkActor2D*>(this->Picture), this->Even.GetPointer() })
  {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  }
  this->Texture->InterpolateOff(); // a texel is a pixel
  this->Texture->RepeatOff();
  this->Picture->SetTexture(this->Texture);
}

PatternLegendSheet::~PatternLegendSheet() = default;

void PatternLegendSheet::drawPicture(
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
  this->Pieces->SetPoints(points);
  this->Pieces->SetPolys(cells);
  this->Pieces->GetPointData()->SetTCoords(coordinates);
  if (this->Texture->GetInput() != picture)
  {
    this->Texture->SetInputData(picture);
  }
  draw(this->Picture, this->Pieces, viewport);
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

void PatternLegendSheet::drawText(vtkViewport* viewport, std::size_t index, const std::string& text,
  vtkTextProperty* font, const std::array<int, 2>& place, double scale)
{
  while (this->Texts.size() <= index)
  {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetTextScaleModeToNone();
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    this->Texts.push_back(actor);
  }
  vtkTextActor* const actor = this->Texts[index];
  actor->SetInput(text.c_str());
  vtkTextProperty* const own = actor->GetTextProperty();
  own->ShallowCopy(font);
  own->SetFontSize(static_cast<int>(std::lround(scale * font->GetFontSize())));
  actor->SetPosition(place[0], place[1]);
  actor->RenderOpaqueGeometry(viewport);
  actor->RenderOverlay(viewport);
}

void PatternLegendSheet::releaseGraphicsResources(vtkWindow* window)
{
  this->Picture->ReleaseGraphicsResources(window);
  this->Even->ReleaseGraphicsResources(window);
  for (const auto& text : this->Texts)
  {
    text->ReleaseGraphicsResources(window);
  }
}

} // namespace hachure

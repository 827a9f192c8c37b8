// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewActors.h"

#include "RegionLineOffset.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace hachure
{
namespace
{
constexpr MarkColor selectedColor{ 1.0, 0.85, 0.1 };
constexpr float lineWidth = 1.5f; // pixels
constexpr float selectedLineWidth = 3.5f;
constexpr int fontSize = 14;   // points
constexpr int labelOffset = 8; // pixels, away from what is named
constexpr int sphereSides = 24;

void color(vtkActor* actor, const MarkStyle& style)
{
  const MarkColor& shown = style.selected ? selectedColor : style.color;
  actor->GetProperty()->SetColor(shown[0], shown[1], shown[2]);
}

// "$" would make VTK look for mathematics.
std::string plainText(const std::string& text)
{
  std::string result;
  result.reserve(text.size());
  for (const char letter : text)
  {
    if (letter == '$')
    {
      result += '\\';
    }
    result += letter;
  }
  return result;
}

void setPoints(vtkPolyData* data, const glm::dvec3* points, std::size_t count)
{
  vtkNew<vtkPoints> placed;
  placed->SetDataTypeToDouble();
  placed->SetNumberOfPoints(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    placed->SetPoint(static_cast<vtkIdType>(i), glm::value_ptr(points[i]));
  }
  data->SetPoints(placed);
}
} // namespace

//------------------------------------------------------------------------------
LabelMark::LabelMark()
{
  vtkTextProperty* property = this->actor->GetTextProperty();
  property->SetFontSize(fontSize);
  property->SetBold(true);
  property->SetShadow(true);
  this->actor->SetDisplayOffset(labelOffset, labelOffset);
}

//------------------------------------------------------------------------------
void LabelMark::place(const std::string& text, const glm::dvec3& at, const MarkStyle& style)
{
  this->actor->SetInput(vtkTextRenderer::GetInstance() ? plainText(text).c_str() : "");
  this->actor->SetPosition(at.x, at.y, at.z);
  const MarkColor& shown = style.selected ? selectedColor : style.color;
  this->actor->GetTextProperty()->SetColor(shown[0], shown[1], shown[2]);
}

//------------------------------------------------------------------------------
LinesMark::LinesMark()
{
  this->mapper->SetInputData(this->data);
  this->actor->SetMapper(this->mapper);
  this->actor->GetProperty()->LightingOff();
}

//------------------------------------------------------------------------------
RegionsMark::RegionsMark()
{
  constexpr float width = 2.0f; // pixels
  this->mapper->SetInputConnection(this->filter->GetOutputPort(1));
  this->mapper->ScalarVisibilityOff();
  this->actor->SetMapper(this->mapper);
  this->actor->GetProperty()->LightingOff();
  this->actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  this->actor->GetProperty()->SetLineWidth(width);
  this->actor->GetShaderProperty()->AddVertexShaderReplacement(
    "//VTK::PositionVC::Impl", true, RegionLineOffset, false);
  this->actor->VisibilityOff();
}

//------------------------------------------------------------------------------
bool RegionsMark::setSurface(vtkDataObject* surface)
{
  if (surface == this->filter->GetInputDataObject(0, 0))
  {
    return false;
  }
  this->filter->SetInputDataObject(surface);
  this->actor->SetVisibility(surface != nullptr);
  return true;
}

//------------------------------------------------------------------------------
void RegionsMark::place(vtkTextureViews* views, vtkMatrix4x4* modelToWorld)
{
  this->filter->SetViews(views);
  this->actor->SetUserMatrix(modelToWorld);
}

//------------------------------------------------------------------------------
void LinesMark::place(const std::vector<glm::dvec3>& points,
  const std::vector<std::vector<int>>& lines, const MarkStyle& style)
{
  setPoints(this->data, points.data(), points.size());
  vtkNew<vtkCellArray> cells;
  for (const std::vector<int>& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const int point : line)
    {
      cells->InsertCellPoint(point);
    }
  }
  this->data->SetLines(cells);
  color(this->actor, style);
  this->actor->GetProperty()->SetLineWidth(style.selected ? selectedLineWidth : lineWidth);
}

//------------------------------------------------------------------------------
HandleMark::HandleMark()
{
  this->source->SetThetaResolution(sphereSides);
  this->source->SetPhiResolution(sphereSides);
  this->mapper->SetInputConnection(this->source->GetOutputPort());
  this->actor->SetMapper(this->mapper);
}

//------------------------------------------------------------------------------
void HandleMark::place(const glm::dvec3& at, double ofRadius, const MarkStyle& style)
{
  this->position = at;
  this->radius = ofRadius;
  this->source->SetRadius(ofRadius);
  this->actor->SetPosition(at.x, at.y, at.z);
  color(this->actor, style);
}

//------------------------------------------------------------------------------
ViewMark::ViewMark()
{
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  this->quad->SetPolys(polys);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const auto& corner : { std::array<double, 2>{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
  {
    coordinates->InsertNextTuple(corner.data());
  }
  this->quad->GetPointData()->SetTCoords(coordinates);
  this->mapper->SetInputData(this->quad);
  this->texture->InterpolateOn();
  this->texture->EdgeClampOn();
  this->pictureActor->SetMapper(this->mapper);
  this->pictureActor->GetProperty()->LightingOff();
  this->pictureActor->GetProperty()->SetColor(1.0, 1.0, 1.0);
}

//------------------------------------------------------------------------------
void ViewMark::place(const ViewPyramid& ofPyramid, const std::string& name, const MarkStyle& style)
{
  this->pyramid = ofPyramid;
  const auto& bases = ofPyramid.bases;
  const auto& corners = ofPyramid.corners;
  std::vector<glm::dvec3> points(bases.begin(), bases.end());
  points.insert(points.end(), corners.begin(), corners.end());
  // A triangle over the upper side, as usual, tells where up is.
  const glm::dvec3 above = 0.5 * (corners[3] - corners[0]);
  points.push_back(corners[3]);
  points.push_back(0.5 * (corners[3] + corners[2]) + 0.5 * above);
  points.push_back(corners[2]);
  this->lines.place(points,
    { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 }, { 8, 9, 10 } },
    style);
  setPoints(this->quad, corners.data(), corners.size());
  this->label.place(name, points[9], style);
}

//------------------------------------------------------------------------------
void ViewMark::setPicture(vtkImageData* image)
{
  this->texture->SetInputData(image);
  this->pictureActor->SetTexture(image ? this->texture.Get() : nullptr);
}

//------------------------------------------------------------------------------
BlendMark::BlendMark()
{
  this->source->SetShaftRadius(0.015);
  this->source->SetTipRadius(0.06);
  this->source->SetTipLength(0.2);
  this->source->SetTipResolution(sphereSides);
  this->source->SetShaftResolution(sphereSides);
  this->mapper->SetInputConnection(this->source->GetOutputPort());
  this->arrowActor->SetMapper(this->mapper);
}

//------------------------------------------------------------------------------
void BlendMark::place(const glm::dvec3& direction, double length, const MarkStyle& style)
{
  // The source points along x.
  const glm::dvec3 along = glm::normalize(direction);
  const glm::dvec3 axis = std::abs(along.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 side = glm::normalize(glm::cross(along, axis));
  const glm::dmat3 columns(length * along, length * side, length * glm::cross(along, side));
  vtkNew<vtkMatrix4x4> matrix;
  for (int column = 0; column < 3; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      matrix->SetElement(row, column, columns[column][row]);
    }
    matrix->SetElement(column, 3, this->handle.position[column]);
  }
  this->arrowActor->SetUserMatrix(matrix);
  color(this->arrowActor, style);
}

} // namespace hachure

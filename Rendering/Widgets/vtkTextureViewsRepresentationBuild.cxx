// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What is drawn, and where.

#include "TextureViewChecks.h"
#include "TextureViewThumbnail.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureViewsRepresentationInternals.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

/** Pixels a side of a small picture at most. */
constexpr int mostThumbnailPixels = 256;
constexpr hachure::MarkColor handleColor{ 1.0, 1.0, 1.0 };

/** As many marks as things to mark. */
template <class Mark>
void resize(std::vector<std::unique_ptr<Mark>>& marks, int count)
{
  marks.resize(static_cast<std::size_t>(count));
  for (std::unique_ptr<Mark>& mark : marks)
  {
    if (!mark)
    {
      mark = std::make_unique<Mark>();
    }
  }
}

std::string percentText(double percentage)
{
  std::ostringstream out;
  out << std::round(10.0 * percentage) / 10.0 << " %";
  return out.str();
}

} // namespace

//------------------------------------------------------------------------------
/** False where nothing can be drawn or moved. */
bool vtkTextureViewsRepresentation::MakeScene()
{
  this->ForgetLost();
  hachure::ViewScene& scene = this->Internal->scene;
  scene.views = this->Internal->views;
  scene.modelToWorld = hachure::matrixOf(this->Internal->modelToWorld);
  const double determinant = glm::determinant(scene.modelToWorld);
  if (!scene.views || !std::isfinite(determinant) || determinant == 0.0)
  {
    return false;
  }
  scene.worldToModel = glm::inverse(scene.modelToWorld);
  double length = this->Placed ? this->InitialLength : 0.0;
  scene.middle = glm::dvec3(0.0);
  if (this->Placed)
  {
    glm::dvec3 middle;
    vtkBoundingBox(this->InitialBounds).GetCenter(glm::value_ptr(middle));
    scene.middle = hachure::movedPoint(scene.worldToModel, middle);
  }
  // What cameras look at is about as large as their distance.
  if (length <= 0.0 && scene.views->GetNumberOfViews() > 0)
  {
    const hachure::ViewPlace place = hachure::viewPlace(scene, 0);
    length = 0.5 * glm::length(hachure::movedVector(scene.modelToWorld, place.eye - place.focus));
  }
  length = length > 0.0 ? length : 1.0;
  scene.pictureSize = this->PictureSize * length;
  scene.modelLength = length / std::cbrt(std::abs(determinant));
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::IsBuilt()
{
  vtkMTimeType time = this->GetMTime();
  if (this->Renderer)
  {
    vtkWindow* window = this->Renderer->GetVTKWindow();
    time = std::max(time, this->Renderer->GetActiveCamera()->GetMTime());
    time = window ? std::max(time, window->GetMTime()) : time;
  }
  return this->BuildTime.GetMTime() > time;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::BuildRepresentation()
{
  if (this->IsBuilt())
  {
    return;
  }
  Internals& internal = *this->Internal;
  internal.border.prop()->VisibilityOff();
  if (this->MakeScene())
  {
    internal.regions.place(internal.views, internal.modelToWorld);
    this->BuildViews();
    this->BuildRange();
    this->BuildBlendPoints();
  }
  else
  {
    internal.viewMarks.clear();
    internal.extremeMarks.clear();
    internal.blendMarks.clear();
  }
  internal.props = internal.allProps();
  internal.props.erase(std::remove_if(internal.props.begin(), internal.props.end(),
                         [](vtkProp* prop) { return !prop->GetVisibility(); }),
    internal.props.end());
  this->BuildTime.Modified();
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::BuildViews()
{
  Internals& internal = *this->Internal;
  resize(internal.viewMarks, internal.views->GetNumberOfViews());
  for (int i = 0; i < internal.views->GetNumberOfViews(); ++i)
  {
    hachure::ViewMark& mark = *internal.viewMarks[i];
    const bool selected = internal.selected.kind == VIEW && internal.selected.view == i;
    std::string name = internal.views->GetViewName(i);
    name = name.empty() ? "view " + std::to_string(i) : name;
    const hachure::ViewPyramid pyramid = hachure::viewPyramid(internal.scene, i);
    mark.place(pyramid, name, { hachure::viewColor(i), selected });
    const glm::dvec3 base =
      0.25 * (pyramid.bases[0] + pyramid.bases[1] + pyramid.bases[2] + pyramid.bases[3]);
    const double depth = glm::distance(base, 0.5 * (pyramid.corners[0] + pyramid.corners[2]));
    const bool visible = !this->IsAtCamera(glm::value_ptr(base), depth);
    mark.lines.prop()->SetVisibility(visible);
    mark.label.prop()->SetVisibility(visible && this->ShowLabels);
    mark.picture()->SetVisibility(visible && this->ShowPictures);
    this->UsePicture(i);
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::UsePicture(int view)
{
  hachure::ViewMark& mark = *this->Internal->viewMarks[view];
  vtkTextureViews* views = this->Internal->views;
  const vtkMTimeType time = views->GetViewImageMTime(view);
  if (!this->ShowPictures || mark.pictureTime == time)
  {
    return;
  }
  mark.pictureTime = time;
  vtkImageData* image = views->GetViewImage(view);
  vtkImageData* mask = views->GetViewMask(view);
  // They may have been changed in place since the views have checked them.
  const bool valid = hachure::imageFault(image).empty() &&
    (!mask || (hachure::imageFault(mask).empty() && hachure::sizeFault("", image, mask).empty()));
  mark.setPicture(valid ? hachure::viewThumbnail(image, mask, mostThumbnailPixels) : nullptr);
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::BuildRange()
{
  Internals& internal = *this->Internal;
  const int view = internal.selected.view;
  std::vector<glm::dvec3> extremes;
  if (view >= 0)
  {
    extremes = hachure::extremePoints(internal.views, view);
  }
  resize(internal.extremeMarks, static_cast<int>(extremes.size()));
  for (std::size_t i = 0; i < extremes.size(); ++i)
  {
    const bool selected =
      internal.selected.kind == EXTREME_POINT && internal.selected.point == static_cast<int>(i);
    const glm::dvec3 world = hachure::movedPoint(internal.scene.modelToWorld, extremes[i]);
    const double radius = this->HandleRadius(glm::value_ptr(world));
    hachure::HandleMark& mark = *internal.extremeMarks[i];
    mark.place(world, radius, { hachure::viewColor(view), selected });
    mark.prop()->SetVisibility(!this->IsAtCamera(glm::value_ptr(world), radius));
  }
  if (extremes.empty())
  {
    return;
  }
  std::vector<glm::dvec3> points =
    hachure::rangeBorder(hachure::viewPlace(internal.scene, view), extremes);
  std::vector<int> line(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = hachure::movedPoint(internal.scene.modelToWorld, points[i]);
    line[i] = static_cast<int>(i);
  }
  internal.border.place(points, { line }, { hachure::viewColor(view), false });
  internal.border.prop()->VisibilityOn();
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::BuildBlendPoints()
{
  Internals& internal = *this->Internal;
  resize(internal.blendMarks, internal.views->GetNumberOfBlendPoints());
  for (int i = 0; i < internal.views->GetNumberOfBlendPoints(); ++i)
  {
    hachure::BlendMark& mark = *internal.blendMarks[i];
    glm::dvec3 position;
    glm::dvec3 direction;
    internal.views->GetBlendPointPosition(i, glm::value_ptr(position));
    internal.views->GetBlendPointDirection(i, glm::value_ptr(direction));
    position = hachure::movedPoint(internal.scene.modelToWorld, position);
    direction = hachure::movedVector(internal.scene.modelToWorld, direction);
    const hachure::MarkStyle style{ handleColor,
      internal.selected.kind == BLEND_POINT && internal.selected.point == i };
    mark.handle.place(position, this->HandleRadius(glm::value_ptr(position)), style);
    mark.place(direction, internal.scene.pictureSize, style);
    mark.label.place(percentText(internal.views->GetBlendPointPercentage(i)), position, style);
    const bool visible = !this->IsAtCamera(glm::value_ptr(position), internal.scene.pictureSize);
    mark.handle.prop()->SetVisibility(visible);
    mark.arrow()->SetVisibility(visible);
    mark.label.prop()->SetVisibility(visible && this->ShowLabels);
  }
}

//------------------------------------------------------------------------------
double vtkTextureViewsRepresentation::HandleRadius(const double world[3])
{
  constexpr double shareOfPicture = 0.05; // where nothing tells the size of pixels
  const double pixel =
    this->Renderer ? hachure::pixelSize(this->Renderer, glm::make_vec3(world)) : 0.0;
  return pixel > 0.0 ? 0.5 * this->HandleSize * pixel
                     : shareOfPicture * this->Internal->scene.pictureSize;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsRepresentation::IsAtCamera(const double world[3], double length)
{
  if (!this->Renderer)
  {
    return false;
  }
  glm::dvec3 eye;
  this->Renderer->GetActiveCamera()->GetPosition(glm::value_ptr(eye));
  return glm::distance(eye, glm::make_vec3(world)) < length;
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkTextureViewsRepresentation::Internals::allProps() const
{
  std::vector<vtkProp*> all;
  all.reserve(
    3 * (this->viewMarks.size() + this->blendMarks.size()) + this->extremeMarks.size() + 1);
  for (const auto& mark : this->viewMarks)
  {
    all.insert(all.end(), { mark->lines.prop(), mark->picture(), mark->label.prop() });
  }
  for (const auto& mark : this->extremeMarks)
  {
    all.push_back(mark->prop());
  }
  all.push_back(this->border.prop());
  all.push_back(this->regions.prop());
  for (const auto& mark : this->blendMarks)
  {
    all.insert(all.end(), { mark->handle.prop(), mark->arrow(), mark->label.prop() });
  }
  return all;
}

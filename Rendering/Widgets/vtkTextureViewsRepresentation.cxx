// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureViewsRepresentation.h"

#include "TextureViewChecks.h"
#include "TextureViewThumbnail.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureViewsRepresentationInternals.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkTextureViewsRepresentation);

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
vtkTextureViewsRepresentation::vtkTextureViewsRepresentation()
  : Internal(new Internals)
{
  this->HandleSize = 12.0; // pixels across
}

//------------------------------------------------------------------------------
vtkTextureViewsRepresentation::~vtkTextureViewsRepresentation() = default;

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SetViews(vtkTextureViews* views)
{
  if (this->Internal->views != views)
  {
    this->Internal->views = views;
    this->Internal->viewMarks.clear();
    this->SelectNothing();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTextureViews* vtkTextureViewsRepresentation::GetViews()
{
  return this->Internal->views;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::SetModelToWorld(vtkMatrix4x4* matrix)
{
  if (this->Internal->modelToWorld != matrix)
  {
    this->Internal->modelToWorld = matrix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkTextureViewsRepresentation::GetModelToWorld()
{
  return this->Internal->modelToWorld;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTextureViewsRepresentation::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part :
    std::initializer_list<vtkObject*>{ this->Internal->views, this->Internal->modelToWorld })
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::PlaceWidget(double bounds[6])
{
  std::copy_n(bounds, 6, this->InitialBounds);
  const vtkBoundingBox box(bounds);
  this->InitialLength = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  this->Placed = box.IsValid();
  this->Modified();
}

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
  for (const auto& mark : this->blendMarks)
  {
    all.insert(all.end(), { mark->handle.prop(), mark->arrow(), mark->label.prop() });
  }
  return all;
}

//------------------------------------------------------------------------------
double* vtkTextureViewsRepresentation::GetBounds()
{
  this->BuildRepresentation();
  vtkBoundingBox box;
  for (vtkProp* prop : this->Internal->props)
  {
    // Where text is depends on the camera, and so would its bounds.
    if (double* bounds = vtkActor::SafeDownCast(prop) ? prop->GetBounds() : nullptr)
    {
      box.AddBounds(bounds);
    }
  }
  if (!box.IsValid())
  {
    return nullptr;
  }
  box.GetBounds(this->Internal->bounds.data());
  return this->Internal->bounds.data();
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::GetActors(vtkPropCollection* actors)
{
  this->BuildRepresentation();
  for (vtkProp* prop : this->Internal->props)
  {
    prop->GetActors(actors);
  }
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkProp* prop : this->Internal->allProps())
  {
    prop->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
/** Not where things are selected by drawing them: these marks have their own way. */
bool vtkTextureViewsRepresentation::IsDrawnIn(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || renderer->GetSelector())
  {
    return false;
  }
  if (!this->Renderer)
  {
    this->SetRenderer(renderer);
  }
  this->BuildRepresentation();
  // Passes, as those for translucent surfaces, tell the props of the renderer how to be drawn.
  for (vtkProp* prop : this->Internal->props)
  {
    prop->SetPropertyKeys(this->GetPropertyKeys());
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  if (this->IsDrawnIn(viewport))
  {
    for (vtkProp* prop : this->Internal->props)
    {
      drawn += prop->RenderOpaqueGeometry(viewport);
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
int vtkTextureViewsRepresentation::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  if (this->IsDrawnIn(viewport))
  {
    for (vtkProp* prop : this->Internal->props)
    {
      drawn += prop->RenderTranslucentPolygonalGeometry(viewport);
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkTextureViewsRepresentation::HasTranslucentPolygonalGeometry()
{
  this->BuildRepresentation();
  const auto& props = this->Internal->props;
  return std::any_of(props.begin(), props.end(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

//------------------------------------------------------------------------------
void vtkTextureViewsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Views: " << this->Internal->views.Get() << "\n";
  os << indent << "ModelToWorld: " << this->Internal->modelToWorld.Get() << "\n";
  os << indent << "PictureSize: " << this->PictureSize << "\n";
  os << indent << "ShowPictures: " << this->ShowPictures << "\n";
  os << indent << "ShowLabels: " << this->ShowLabels << "\n";
  os << indent << "MovesDistance: " << this->MovesDistance << "\n";
  os << indent << "SelectedItem: " << this->Internal->selected.kind << "\n";
  os << indent << "SelectedView: " << this->Internal->selected.view << "\n";
  os << indent << "SelectedPoint: " << this->Internal->selected.point << "\n";
}

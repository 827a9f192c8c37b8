// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the widget does to views, and how that is undone.

#include "vtkTextureViewsWidget.h"

#include "RendererView.h"
#include "TextureViewShapes.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextureViews.h"
#include "vtkTextureViewsManifest.h"
#include "vtkTextureViewsRepresentation.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace
{

using FadePoint = std::array<double, 2>;
using Representation = vtkTextureViewsRepresentation;

/** Actions that can be undone. */
constexpr std::size_t mostActions = 32;
/** The part of a fade curve after its plateau is at least so wide. */
constexpr double leastFade = 0.01;

std::vector<FadePoint> fadeCurve(vtkTextureViews* views, int view)
{
  std::vector<FadePoint> curve(static_cast<std::size_t>(views->GetNumberOfFadePoints(view)));
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    views->GetFadePoint(view, static_cast<int>(i), curve[i].data());
  }
  // Without points all is seen up to the border.
  return curve.empty() ? std::vector<FadePoint>{ { 0.0, 1.0 }, { 1.0, 1.0 } } : curve;
}

/** The curve with its first level part longer or shorter. */
std::vector<FadePoint> withPlateau(const std::vector<FadePoint>& curve, double difference)
{
  const double share = curve.front()[1];
  const auto rest = std::find_if(
    curve.begin(), curve.end(), [&](const FadePoint& point) { return point[1] != share; });
  const double before = (rest - 1)->front();
  std::vector<FadePoint> result;
  result.reserve(curve.size() + 2);
  result.push_back({ 0.0, share });
  const double most = (rest == curve.end() ? 1.0 : rest->front()) - leastFade;
  const double plateau = std::clamp(before + difference, 0.0, std::max(most, 0.0));
  if (plateau > 0.0)
  {
    result.push_back({ plateau, share });
  }
  result.insert(result.end(), rest, curve.end());
  if (rest == curve.end())
  {
    result.push_back({ 1.0, 0.0 });
  }
  return result;
}

/** By image the file that holds it. */
using FileNames = std::map<vtkImageData*, std::string>;

FileNames fileNames(vtkTextureViews* views)
{
  FileNames names;
  for (int i = 0; i < views->GetNumberOfViews(); ++i)
  {
    names[views->GetViewImage(i)] = views->GetViewImageFileName(i);
    names[views->GetViewMask(i)] = views->GetViewMaskFileName(i);
    names[views->GetViewDepth(i)] = views->GetViewDepthFileName(i);
  }
  names.erase(nullptr);
  return names;
}

void setFileNames(vtkTextureViews* views, const FileNames& names)
{
  const auto use =
    [&](vtkImageData* image, int view, void (vtkTextureViews::*set)(int, const std::string&))
  {
    const auto found = names.find(image);
    if (found != names.end())
    {
      (views->*set)(view, found->second);
    }
  };
  for (int i = 0; i < views->GetNumberOfViews(); ++i)
  {
    use(views->GetViewImage(i), i, &vtkTextureViews::SetViewImageFileName);
    use(views->GetViewMask(i), i, &vtkTextureViews::SetViewMaskFileName);
    use(views->GetViewDepth(i), i, &vtkTextureViews::SetViewDepthFileName);
  }
}

} // namespace

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::HasViews(const char* caller)
{
  if (!this->GetViews())
  {
    vtkErrorMacro(<< caller << ": there are no views, see SetViews().");
  }
  return this->GetViews() != nullptr;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::HasRenderer(const char* caller)
{
  if (!this->CurrentRenderer)
  {
    vtkErrorMacro(<< caller << ": there is no renderer; the widget must be enabled.");
  }
  return this->CurrentRenderer != nullptr;
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::Remember()
{
  auto copy = vtkSmartPointer<vtkTextureViews>::New();
  copy->ShallowCopy(this->GetViews());
  if (!this->CanUndo())
  {
    this->History.clear(); // that of other views
    this->HistoryOf = this->GetViews();
  }
  if (this->History.size() == mostActions)
  {
    this->History.erase(this->History.begin());
  }
  this->History.push_back(copy);
}

//------------------------------------------------------------------------------
/** After an action that has changed nothing. */
void vtkTextureViewsWidget::ForgetLast()
{
  this->History.pop_back();
}

//------------------------------------------------------------------------------
void vtkTextureViewsWidget::Changed()
{
  this->InvokeEvent(vtkCommand::StartInteractionEvent, nullptr);
  this->InvokeEvent(vtkCommand::InteractionEvent, nullptr);
  this->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
  this->Render();
}

//------------------------------------------------------------------------------
std::string vtkTextureViewsWidget::FreeName()
{
  int number = 1;
  while (this->GetViews()->FindView("view " + std::to_string(number)) >= 0)
  {
    ++number;
  }
  return "view " + std::to_string(number);
}

//------------------------------------------------------------------------------
int vtkTextureViewsWidget::AddCurrentCamera(const std::string& name)
{
  if (!this->HasViews("AddCurrentCamera") || !this->HasRenderer("AddCurrentCamera"))
  {
    return -1;
  }
  const vtkSmartPointer<vtkImageData> image = this->Picture == RENDERED
    ? hachure::rendererPicture(this->CurrentRenderer, this->WidgetRep)
    : hachure::emptyPicture(this->CurrentRenderer);
  return this->AddView(name, image);
}

//------------------------------------------------------------------------------
int vtkTextureViewsWidget::AddCurrentCamera(const std::string& name, vtkImageData* image)
{
  return this->HasViews("AddCurrentCamera") && this->HasRenderer("AddCurrentCamera")
    ? this->AddView(name, image)
    : -1;
}

//------------------------------------------------------------------------------
int vtkTextureViewsWidget::AddView(const std::string& name, vtkImageData* image)
{
  Representation* representation = this->GetTextureViewsRepresentation();
  this->Remember();
  const int view =
    hachure::addRendererView(this->GetViews(), name.empty() ? this->FreeName() : name,
      this->CurrentRenderer, hachure::matrixOf(representation->GetModelToWorld()), image);
  if (view < 0)
  {
    this->ForgetLast();
    return view;
  }
  representation->SelectView(view);
  this->Changed();
  return view;
}

//------------------------------------------------------------------------------
int vtkTextureViewsWidget::AddExtremePoint(double x, double y)
{
  Representation* representation = this->GetTextureViewsRepresentation();
  const int view = representation->GetSelectedView();
  const double display[2] = { x, y };
  double place[3];
  if (!representation->ComputePlaceOnSphere(view, display, place))
  {
    return -1;
  }
  this->Remember();
  const int point = this->GetViews()->AddExtremePoint(view, place);
  this->GetViews()->SetViewKind(view, vtkTextureViews::DEPENDENT);
  representation->SelectExtremePoint(view, point);
  this->Changed();
  return point;
}

//------------------------------------------------------------------------------
int vtkTextureViewsWidget::AddBlendPoint(double percentage)
{
  if (!this->HasViews("AddBlendPoint") || !this->HasRenderer("AddBlendPoint"))
  {
    return -1;
  }
  Representation* representation = this->GetTextureViewsRepresentation();
  const glm::dmat4 worldToModel =
    glm::inverse(hachure::matrixOf(representation->GetModelToWorld()));
  vtkCamera* camera = this->CurrentRenderer->GetActiveCamera();
  const glm::dvec3 position =
    hachure::movedPoint(worldToModel, glm::make_vec3(camera->GetPosition()));
  const glm::dvec3 direction =
    hachure::movedVector(worldToModel, glm::make_vec3(camera->GetDirectionOfProjection()));
  this->Remember();
  const int point = this->GetViews()->AddBlendPoint(
    glm::value_ptr(position), glm::value_ptr(direction), percentage);
  if (point < 0)
  {
    this->ForgetLast();
    return point;
  }
  representation->SelectBlendPoint(point);
  this->Changed();
  return point;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::RemoveSelected()
{
  Representation* representation = this->GetTextureViewsRepresentation();
  const int item = representation->GetSelectedItem();
  const int view = representation->GetSelectedView();
  const int point = representation->GetSelectedPoint();
  if (item == Representation::NOTHING)
  {
    return false;
  }
  this->EndDrag();
  this->Remember();
  if (item == Representation::EXTREME_POINT)
  {
    this->GetViews()->RemoveExtremePoint(view, point);
    representation->SelectView(view);
  }
  else
  {
    item == Representation::VIEW ? this->GetViews()->RemoveView(view)
                                 : this->GetViews()->RemoveBlendPoint(point);
    representation->SelectNothing();
  }
  this->Changed();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::ChangePercentage(double difference)
{
  Representation* representation = this->GetTextureViewsRepresentation();
  if (representation->GetSelectedItem() != Representation::BLEND_POINT)
  {
    return false;
  }
  const int point = representation->GetSelectedPoint();
  double position[3];
  double direction[3];
  this->GetViews()->GetBlendPointPosition(point, position);
  this->GetViews()->GetBlendPointDirection(point, direction);
  const double percentage =
    std::clamp(this->GetViews()->GetBlendPointPercentage(point) + difference, 0.0, 100.0);
  this->Remember();
  this->GetViews()->SetBlendPoint(point, position, direction, percentage);
  this->Changed();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::ChangePlateau(double difference)
{
  const int view = this->GetTextureViewsRepresentation()->GetSelectedView();
  if (view < 0)
  {
    return false;
  }
  this->Remember();
  const std::vector<FadePoint> curve = withPlateau(fadeCurve(this->GetViews(), view), difference);
  this->GetViews()->RemoveAllFadePoints(view);
  for (const FadePoint& point : curve)
  {
    this->GetViews()->AddFadePoint(view, point[0], point[1]);
  }
  this->Changed();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::SwitchFadeMode()
{
  constexpr int modes = vtkTextureViews::EVEN + 1;
  const int view = this->GetTextureViewsRepresentation()->GetSelectedView();
  if (view < 0)
  {
    return false;
  }
  this->Remember();
  this->GetViews()->SetFadeMode(view, (this->GetViews()->GetFadeMode(view) + 1) % modes);
  this->Changed();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::Save()
{
  if (!this->HasViews("Save"))
  {
    return false;
  }
  if (this->ManifestFileName.empty())
  {
    vtkErrorMacro(<< "Save: there is no file name, see SetManifestFileName().");
    return false;
  }
  vtkNew<vtkTextureViewsManifest> manifest;
  vtkNew<vtkCallbackCommand> silence; // what it says is said here
  manifest->AddObserver(vtkCommand::ErrorEvent, silence);
  if (!manifest->Write(this->ManifestFileName.c_str(), this->GetViews()))
  {
    vtkErrorMacro(<< "Save: " << manifest->GetError());
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::CanUndo()
{
  return !this->History.empty() && this->HistoryOf == this->GetViews();
}

//------------------------------------------------------------------------------
bool vtkTextureViewsWidget::Undo()
{
  if (!this->CanUndo())
  {
    return false;
  }
  this->EndDrag();
  // Which files hold the images is not undone: they have been saved, or painted, since.
  const FileNames names = fileNames(this->GetViews());
  this->GetViews()->ShallowCopy(this->History.back());
  setFileNames(this->GetViews(), names);
  this->History.pop_back();
  this->Changed();
  return true;
}

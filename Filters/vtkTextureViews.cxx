// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureViews.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTextureViewsInternals.h"

#include <algorithm>
#include <cstring>
#include <utility>

vtkStandardNewMacro(vtkTextureViews);

namespace
{

using Data = vtkSmartPointer<vtkImageData>;

/** Whether two images, or none, are equal pixel by pixel. */
bool same(vtkImageData* one, vtkImageData* other)
{
  if (one == other || !one || !other || !hachure::sizeFault("", one, other).empty())
  {
    return one == other;
  }
  vtkDataArray* first = one->GetPointData()->GetScalars();
  vtkDataArray* second = other->GetPointData()->GetScalars();
  return first->GetDataType() == second->GetDataType() &&
    first->GetNumberOfComponents() == second->GetNumberOfComponents() &&
    std::memcmp(first->GetVoidPointer(0), second->GetVoidPointer(0),
      static_cast<std::size_t>(first->GetNumberOfValues()) *
        static_cast<std::size_t>(first->GetDataTypeSize())) == 0;
}

Data copied(vtkImageData* image, bool deep)
{
  if (!image || !deep)
  {
    return image;
  }
  auto result = Data::New();
  result->DeepCopy(image);
  return result;
}

} // namespace

//------------------------------------------------------------------------------
void vtkTextureViews::View::takeImages(const View* before, bool deep)
{
  Image& one = this->picture;
  if (before && same(one.data, before->picture.data) && same(this->mask.data, before->mask.data))
  {
    one.data = before->picture.data;
    this->mask.data = before->mask.data;
    this->imageTime = before->imageTime;
  }
  else
  {
    one.data = copied(one.data, deep);
    this->mask.data = copied(this->mask.data, deep);
    this->imageTime.Modified();
  }
  this->depth.data = copied(this->depth.data, deep);
}

//------------------------------------------------------------------------------
void vtkTextureViews::View::becomeOwn(const View* before, bool deep)
{
  this->shownCamera = nullptr;
  this->shownMatrix = nullptr;
  if (before && this->sameCamera(*before))
  {
    this->cameraTime = before->cameraTime;
  }
  else
  {
    this->cameraTime.Modified();
  }
  if (before && this->sameRange(*before))
  {
    this->rangeTime = before->rangeTime;
  }
  else
  {
    this->rangeTime.Modified();
  }
  this->takeImages(before, deep);
}

//------------------------------------------------------------------------------
vtkTextureViews::vtkTextureViews()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTextureViews::~vtkTextureViews() = default;

//------------------------------------------------------------------------------
bool vtkTextureViews::IsIn(int index, std::size_t count, const char* what, const char* caller)
{
  if (index >= 0 && index < static_cast<int>(count))
  {
    return true;
  }
  if (count == 0)
  {
    vtkErrorMacro(<< caller << ": " << what << " " << index << " is out of range; there are none.");
    return false;
  }
  vtkErrorMacro(<< caller << ": " << what << " " << index << " is out of range; expected 0 to "
                << count - 1 << ".");
  return false;
}

//------------------------------------------------------------------------------
bool vtkTextureViews::Refuses(const char* caller, const std::string& fault)
{
  if (!fault.empty())
  {
    vtkErrorMacro(<< caller << ": " << fault << ".");
  }
  return !fault.empty();
}

//------------------------------------------------------------------------------
vtkTextureViews::View* vtkTextureViews::ViewAt(int view, const char* caller)
{
  auto& views = this->Internal->views;
  return this->IsIn(view, views.size(), "view", caller) ? &views[view] : nullptr;
}

//------------------------------------------------------------------------------
int vtkTextureViews::Append(View view, vtkImageData* image)
{
  if (this->Refuses("AddView", hachure::imageFault(image)))
  {
    return -1;
  }
  view.picture.data = image;
  view.imageTime.Modified();
  view.cameraTime.Modified();
  view.rangeTime.Modified();
  this->Internal->views.push_back(std::move(view));
  this->Modified();
  return this->GetNumberOfViews() - 1;
}

//------------------------------------------------------------------------------
int vtkTextureViews::AddView(const std::string& name, vtkCamera* camera, vtkImageData* image)
{
  View view;
  view.name = name;
  return this->TakeCamera(view, camera, "AddView") ? this->Append(std::move(view), image) : -1;
}

//------------------------------------------------------------------------------
int vtkTextureViews::AddView(
  const std::string& name, vtkMatrix4x4* modelToClip, vtkImageData* image)
{
  View view;
  view.name = name;
  return this->TakeMatrix(view, modelToClip, "AddView") ? this->Append(std::move(view), image) : -1;
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveView(int view)
{
  auto& views = this->Internal->views;
  if (this->IsIn(view, views.size(), "view", "RemoveView"))
  {
    views.erase(views.begin() + view);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveAllViews()
{
  if (!this->Internal->views.empty())
  {
    this->Internal->views.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkTextureViews::GetNumberOfViews()
{
  return static_cast<int>(this->Internal->views.size());
}

//------------------------------------------------------------------------------
void vtkTextureViews::MoveView(int from, int to)
{
  auto& views = this->Internal->views;
  if (!this->IsIn(from, views.size(), "view", "MoveView") ||
    !this->IsIn(to, views.size(), "view", "MoveView") || from == to)
  {
    return;
  }
  const auto first = views.begin() + std::min(from, to);
  const auto last = views.begin() + std::max(from, to) + 1;
  std::rotate(first, from < to ? first + 1 : last - 1, last);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTextureViews::FindView(const std::string& name)
{
  const auto& views = this->Internal->views;
  const auto found =
    std::find_if(views.begin(), views.end(), [&](const View& view) { return view.name == name; });
  return found == views.end() ? -1 : static_cast<int>(found - views.begin());
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewName(int view, const std::string& name)
{
  View* found = this->ViewAt(view, "SetViewName");
  if (found && found->name != name)
  {
    found->name = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkTextureViews::GetViewName(int view)
{
  const View* found = this->ViewAt(view, "GetViewName");
  return found ? found->name : "";
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTextureViews::GetViewImageMTime(int view)
{
  const View* found = this->ViewAt(view, "GetViewImageMTime");
  if (!found)
  {
    return 0;
  }
  const vtkMTimeType mask = found->mask.data ? found->mask.data->GetMTime() : 0;
  return std::max({ found->imageTime.GetMTime(), found->picture.data->GetMTime(), mask });
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTextureViews::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const View& view : this->Internal->views)
  {
    for (vtkImageData* image : { view.picture.data, view.mask.data, view.depth.data })
    {
      time = image ? std::max(time, image->GetMTime()) : time;
    }
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkTextureViews::DeepCopy(vtkTextureViews* source)
{
  this->Copy(source, true);
}

//------------------------------------------------------------------------------
void vtkTextureViews::ShallowCopy(vtkTextureViews* source)
{
  this->Copy(source, false);
}

//------------------------------------------------------------------------------
void vtkTextureViews::Copy(vtkTextureViews* source, bool deep)
{
  if (!source || source == this)
  {
    this->Refuses("Copy", source ? "" : "expected views to copy, got null");
    return;
  }
  auto& views = this->Internal->views;
  std::vector<View> taken = source->Internal->views;
  for (std::size_t i = 0; i < taken.size(); ++i)
  {
    taken[i].becomeOwn(i < views.size() ? &views[i] : nullptr, deep);
  }
  views = std::move(taken);
  this->Internal->blendPoints = source->Internal->blendPoints;
  this->BaseCells = source->BaseCells;
  this->FinestLevel = source->FinestLevel;
  this->Hemisphere = source->Hemisphere;
  this->HemisphereMap = source->HemisphereMap;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTextureViews::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BaseCells: " << this->BaseCells << "\n";
  os << indent << "FinestLevel: " << this->FinestLevel << "\n";
  os << indent << "Hemisphere: " << this->Hemisphere << "\n";
  os << indent << "HemisphereMap: " << this->HemisphereMap << "\n";
  os << indent << "Views: " << this->Internal->views.size() << "\n";
  for (const View& view : this->Internal->views)
  {
    os << indent.GetNextIndent() << view.name << "\n";
  }
  os << indent << "BlendPoints: " << this->Internal->blendPoints.size() << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// From where views are seen: kinds, extreme points, fades and blend points.

#include "vtkTextureViewsInternals.h"

#include <algorithm>
#include <sstream>

namespace
{

/** What is wrong with a number that has a range. */
std::string numberFault(const char* name, double value, double least, double greatest)
{
  std::ostringstream out;
  if (!(value >= least && value <= greatest))
  {
    out << name << " " << value << " is out of range; expected " << least << " to " << greatest;
  }
  return out.str();
}

std::string blendFault(const double position[3], const double direction[3], double percentage)
{
  std::string fault = hachure::vectorFault(position);
  fault = fault.empty() ? hachure::directionFault(direction) : fault;
  return fault.empty() ? numberFault("percentage", percentage, 0.0, 100.0) : fault;
}

std::array<double, 3> copied(const double vector[3])
{
  return { vector[0], vector[1], vector[2] };
}

} // namespace

//------------------------------------------------------------------------------
bool vtkTextureViews::View::sameRange(const View& other) const
{
  return this->kind == other.kind && this->extremePoints == other.extremePoints &&
    this->fadeMode == other.fadeMode && this->fadePoints == other.fadePoints;
}

//------------------------------------------------------------------------------
void vtkTextureViews::RangeModified(View& view)
{
  view.rangeTime.Modified();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTextureViews::GetViewRangeMTime(int view)
{
  const View* found = this->ViewAt(view, "GetViewRangeMTime");
  return found ? found->rangeTime.GetMTime() : 0;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewKind(int view, int kind)
{
  View* found = this->ViewAt(view, "SetViewKind");
  if (found && !this->Refuses("SetViewKind", numberFault("kind", kind, INDEPENDENT, DEPENDENT)) &&
    found->kind != kind)
  {
    found->kind = kind;
    this->RangeModified(*found);
  }
}

//------------------------------------------------------------------------------
int vtkTextureViews::GetViewKind(int view)
{
  const View* found = this->ViewAt(view, "GetViewKind");
  return found ? found->kind : INDEPENDENT;
}

//------------------------------------------------------------------------------
std::array<double, 3>* vtkTextureViews::ExtremePointAt(int view, int point, const char* caller)
{
  View* found = this->ViewAt(view, caller);
  return found && this->IsIn(point, found->extremePoints.size(), "extreme point", caller)
    ? &found->extremePoints[point]
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkTextureViews::AddExtremePoint(int view, const double position[3])
{
  View* found = this->ViewAt(view, "AddExtremePoint");
  if (!found || this->Refuses("AddExtremePoint", hachure::vectorFault(position)))
  {
    return -1;
  }
  found->extremePoints.push_back(copied(position));
  this->RangeModified(*found);
  return static_cast<int>(found->extremePoints.size()) - 1;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetExtremePoint(int view, int point, const double position[3])
{
  auto* found = this->ExtremePointAt(view, point, "SetExtremePoint");
  if (found && !this->Refuses("SetExtremePoint", hachure::vectorFault(position)) &&
    *found != copied(position))
  {
    *found = copied(position);
    this->RangeModified(this->Internal->views[view]);
  }
}

//------------------------------------------------------------------------------
void vtkTextureViews::GetExtremePoint(int view, int point, double position[3])
{
  const auto* found = this->ExtremePointAt(view, point, "GetExtremePoint");
  const std::array<double, 3> none{ 0.0, 0.0, 0.0 };
  std::copy_n((found ? *found : none).data(), 3, position);
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveExtremePoint(int view, int point)
{
  if (this->ExtremePointAt(view, point, "RemoveExtremePoint"))
  {
    View& found = this->Internal->views[view];
    found.extremePoints.erase(found.extremePoints.begin() + point);
    this->RangeModified(found);
  }
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveAllExtremePoints(int view)
{
  View* found = this->ViewAt(view, "RemoveAllExtremePoints");
  if (found && !found->extremePoints.empty())
  {
    found->extremePoints.clear();
    this->RangeModified(*found);
  }
}

//------------------------------------------------------------------------------
int vtkTextureViews::GetNumberOfExtremePoints(int view)
{
  const View* found = this->ViewAt(view, "GetNumberOfExtremePoints");
  return found ? static_cast<int>(found->extremePoints.size()) : 0;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetFadeMode(int view, int mode)
{
  View* found = this->ViewAt(view, "SetFadeMode");
  if (found && !this->Refuses("SetFadeMode", numberFault("mode", mode, CURVE, EVEN)) &&
    found->fadeMode != mode)
  {
    found->fadeMode = mode;
    this->RangeModified(*found);
  }
}

//------------------------------------------------------------------------------
int vtkTextureViews::GetFadeMode(int view)
{
  const View* found = this->ViewAt(view, "GetFadeMode");
  return found ? found->fadeMode : CURVE;
}

//------------------------------------------------------------------------------
int vtkTextureViews::AddFadePoint(int view, double angle, double share)
{
  View* found = this->ViewAt(view, "AddFadePoint");
  if (!found || this->Refuses("AddFadePoint", numberFault("angle", angle, 0.0, 1.0)) ||
    this->Refuses("AddFadePoint", numberFault("share", share, 0.0, 1.0)))
  {
    return -1;
  }
  auto& points = found->fadePoints;
  const auto after = std::find_if(points.begin(), points.end(),
    [&](const std::array<double, 2>& point) { return point[0] > angle; });
  const auto added = points.insert(after, { angle, share });
  this->RangeModified(*found);
  return static_cast<int>(added - points.begin());
}

//------------------------------------------------------------------------------
void vtkTextureViews::GetFadePoint(int view, int point, double angleAndShare[2])
{
  const View* found = this->ViewAt(view, "GetFadePoint");
  const bool valid =
    found && this->IsIn(point, found->fadePoints.size(), "fade point", "GetFadePoint");
  angleAndShare[0] = valid ? found->fadePoints[point][0] : 0.0;
  angleAndShare[1] = valid ? found->fadePoints[point][1] : 0.0;
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveAllFadePoints(int view)
{
  View* found = this->ViewAt(view, "RemoveAllFadePoints");
  if (found && !found->fadePoints.empty())
  {
    found->fadePoints.clear();
    this->RangeModified(*found);
  }
}

//------------------------------------------------------------------------------
int vtkTextureViews::GetNumberOfFadePoints(int view)
{
  const View* found = this->ViewAt(view, "GetNumberOfFadePoints");
  return found ? static_cast<int>(found->fadePoints.size()) : 0;
}

//------------------------------------------------------------------------------
vtkTextureViews::BlendPoint* vtkTextureViews::BlendPointAt(int point, const char* caller)
{
  auto& points = this->Internal->blendPoints;
  return this->IsIn(point, points.size(), "blend point", caller) ? &points[point] : nullptr;
}

//------------------------------------------------------------------------------
int vtkTextureViews::AddBlendPoint(
  const double position[3], const double direction[3], double percentage)
{
  if (this->Refuses("AddBlendPoint", blendFault(position, direction, percentage)))
  {
    return -1;
  }
  this->Internal->blendPoints.push_back({ copied(position), copied(direction), percentage });
  this->Modified();
  return this->GetNumberOfBlendPoints() - 1;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetBlendPoint(
  int point, const double position[3], const double direction[3], double percentage)
{
  BlendPoint* found = this->BlendPointAt(point, "SetBlendPoint");
  if (found && !this->Refuses("SetBlendPoint", blendFault(position, direction, percentage)))
  {
    *found = { copied(position), copied(direction), percentage };
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTextureViews::GetBlendPointPosition(int point, double position[3])
{
  const BlendPoint* found = this->BlendPointAt(point, "GetBlendPointPosition");
  const BlendPoint none{};
  std::copy_n((found ? found : &none)->position.data(), 3, position);
}

//------------------------------------------------------------------------------
void vtkTextureViews::GetBlendPointDirection(int point, double direction[3])
{
  const BlendPoint* found = this->BlendPointAt(point, "GetBlendPointDirection");
  const BlendPoint none{};
  std::copy_n((found ? found : &none)->direction.data(), 3, direction);
}

//------------------------------------------------------------------------------
double vtkTextureViews::GetBlendPointPercentage(int point)
{
  const BlendPoint* found = this->BlendPointAt(point, "GetBlendPointPercentage");
  return found ? found->percentage : 0.0;
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveBlendPoint(int point)
{
  if (this->BlendPointAt(point, "RemoveBlendPoint"))
  {
    auto& points = this->Internal->blendPoints;
    points.erase(points.begin() + point);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTextureViews::RemoveAllBlendPoints()
{
  if (!this->Internal->blendPoints.empty())
  {
    this->Internal->blendPoints.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkTextureViews::GetNumberOfBlendPoints()
{
  return static_cast<int>(this->Internal->blendPoints.size());
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetHemisphere(int hemisphere)
{
  if (hemisphere != 4 && hemisphere != 8 && hemisphere != 16)
  {
    vtkErrorMacro(<< "SetHemisphere: expected 4, 8 or 16, got " << hemisphere << ".");
    return;
  }
  if (this->Hemisphere != hemisphere)
  {
    this->Hemisphere = hemisphere;
    this->Modified();
  }
}

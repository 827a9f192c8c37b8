// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The images of views and the files they are in.

#include "vtkTextureViewsInternals.h"

#include <cmath>

namespace
{

std::string rangeFault(double nearest, double farthest)
{
  const bool valid = std::isfinite(nearest) && std::isfinite(farthest) && nearest < farthest;
  return valid ? ""
               : "expected two distances, the lesser first, got " + std::to_string(nearest) +
      " and " + std::to_string(farthest);
}

} // namespace

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewImage(int view, vtkImageData* image)
{
  View* found = this->ViewAt(view, "SetViewImage");
  if (!found || this->Refuses("SetViewImage", hachure::imageFault(image)) ||
    this->Refuses("SetViewImage", hachure::sizeFault("mask", found->mask.data, image)) ||
    this->Refuses("SetViewImage", hachure::sizeFault("depth image", found->depth.data, image)))
  {
    return;
  }
  if (hachure::aspect(image) != hachure::aspect(found->picture.data))
  {
    found->cameraTime.Modified();
  }
  found->picture = { image, "" };
  found->imageTime.Modified();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkImageData* vtkTextureViews::GetViewImage(int view)
{
  const View* found = this->ViewAt(view, "GetViewImage");
  return found ? found->picture.data.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewMask(int view, vtkImageData* mask)
{
  View* found = this->ViewAt(view, "SetViewMask");
  if (!found || (mask && this->Refuses("SetViewMask", hachure::imageFault(mask))) ||
    this->Refuses("SetViewMask", hachure::sizeFault("image", found->picture.data, mask)))
  {
    return;
  }
  found->mask = { mask, "" };
  found->imageTime.Modified();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkImageData* vtkTextureViews::GetViewMask(int view)
{
  const View* found = this->ViewAt(view, "GetViewMask");
  return found ? found->mask.data.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewDepth(int view, vtkImageData* depth, double nearest, double farthest)
{
  View* found = this->ViewAt(view, "SetViewDepth");
  if (!found || (depth && this->Refuses("SetViewDepth", hachure::depthFault(depth))) ||
    this->Refuses("SetViewDepth", hachure::sizeFault("image", found->picture.data, depth)) ||
    this->Refuses("SetViewDepth", depth ? rangeFault(nearest, farthest) : ""))
  {
    return;
  }
  found->depth = { depth, "" };
  found->depthRange = { nearest, farthest };
  this->Modified();
}

//------------------------------------------------------------------------------
vtkImageData* vtkTextureViews::GetViewDepth(int view)
{
  const View* found = this->ViewAt(view, "GetViewDepth");
  return found ? found->depth.data.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkTextureViews::GetViewDepthRange(int view, double range[2])
{
  const View* found = this->ViewAt(view, "GetViewDepthRange");
  range[0] = found ? found->depthRange[0] : 0.0;
  range[1] = found ? found->depthRange[1] : 0.0;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewImageFileName(int view, const std::string& fileName)
{
  View* found = this->ViewAt(view, "SetViewImageFileName");
  if (found && found->picture.fileName != fileName)
  {
    found->picture.fileName = fileName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkTextureViews::GetViewImageFileName(int view)
{
  const View* found = this->ViewAt(view, "GetViewImageFileName");
  return found ? found->picture.fileName : "";
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewMaskFileName(int view, const std::string& fileName)
{
  View* found = this->ViewAt(view, "SetViewMaskFileName");
  if (found && found->mask.fileName != fileName)
  {
    found->mask.fileName = fileName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkTextureViews::GetViewMaskFileName(int view)
{
  const View* found = this->ViewAt(view, "GetViewMaskFileName");
  return found ? found->mask.fileName : "";
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewDepthFileName(int view, const std::string& fileName)
{
  View* found = this->ViewAt(view, "SetViewDepthFileName");
  if (found && found->depth.fileName != fileName)
  {
    found->depth.fileName = fileName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkTextureViews::GetViewDepthFileName(int view)
{
  const View* found = this->ViewAt(view, "GetViewDepthFileName");
  return found ? found->depth.fileName : "";
}

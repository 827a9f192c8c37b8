// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// How a representation draws the part of a surface that its process holds.

#include "vtkPatternRepresentation.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkPatternPartMapper.h"
#include "vtkWholeSurface.h"

namespace
{
constexpr int wholePort = 1;

bool HasCells(vtkDataObject* surface)
{
  return surface && surface->GetNumberOfElements(vtkDataObject::CELL) > 0;
}

vtkSmartPointer<vtkDataObject> Copy(vtkDataObject* surface)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(surface->NewInstance());
  copy->ShallowCopy(surface);
  return copy;
}

// The same without data: what processes send is put together only where structures match.
vtkSmartPointer<vtkDataObject> Structure(vtkDataObject* surface)
{
  auto empty = vtkSmartPointer<vtkDataObject>::Take(surface->NewInstance());
  auto* composite = vtkCompositeDataSet::SafeDownCast(surface);
  if (composite)
  {
    vtkCompositeDataSet::SafeDownCast(empty)->CopyStructure(composite);
  }
  return empty;
}

// Of the data's processes; the client of a server is alone.
bool IsFirstProcess()
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}
} // namespace

//------------------------------------------------------------------------------
int vtkPatternRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  const bool renders = request == vtkPVView::REQUEST_RENDER() && this->GetVisibility();
  auto* mapper = static_cast<vtkPatternPartMapper*>(this->Mapper);
  const bool attributesChanged = this->BlockAttrChanged;
  vtkDataObject* const before = mapper->GetInputDataObject(0, 0);
  if (renders)
  {
    mapper->SetWholeOfNext(this->FindWhole(inInfo));
  }
  const int processed = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  if (processed != 0 && request == vtkPVView::REQUEST_UPDATE())
  {
    this->SendWhole(inInfo);
  }
  if (processed != 0 && renders)
  {
    this->UpdateController();
    vtkDataObject* const drawn = mapper->GetInputDataObject(0, 0);
    if (mapper->GetWholeSurface() && drawn && (attributesChanged || drawn != before))
    {
      this->PopulateBlockAttributes(mapper->GetCompositeDataDisplayAttributes(), drawn);
    }
  }
  return processed;
}

// Processes that hold parts of the surface know it as a whole; a client that is sent the parts gets
// it from the first one.
void vtkPatternRepresentation::SendWhole(vtkInformation* inInfo)
{
  vtkDataObject* const whole = this->Whole->GetOutputDataObject(1);
  if (!this->SentWhole || whole->GetMTime() != this->SentTime)
  {
    this->SentWhole = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    if (HasCells(whole))
    {
      this->SentWhole->SetBlock(0, IsFirstProcess() ? Copy(whole) : Structure(whole));
    }
    this->SentTime = whole->GetMTime();
  }
  constexpr unsigned long aside = 1; // kilobytes: not to decide where pictures are made
  vtkPVView::SetPiece(inInfo, this, this->SentWhole, aside, wholePort);
}

//------------------------------------------------------------------------------
vtkDataObject* vtkPatternRepresentation::FindWhole(vtkInformation* inInfo)
{
  vtkDataObject* const part = vtkPVView::GetDeliveredPiece(inInfo, this);
  if (!part)
  {
    return nullptr;
  }
  if (vtkDataObject* const whole = vtkWholeSurface::GetWhole(part))
  {
    return whole;
  }
  auto* sent =
    vtkMultiBlockDataSet::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this, wholePort));
  if (sent && sent->GetNumberOfBlocks() > 0 && HasCells(sent->GetBlock(0)))
  {
    return sent->GetBlock(0);
  }
  // Parts that were moved from process to process.
  vtkDataObject* const own = this->Whole->GetOutputDataObject(1);
  return HasCells(own) ? own : nullptr;
}

// Processes that draw into one picture.
void vtkPatternRepresentation::UpdateController()
{
  auto* mapper = static_cast<vtkPatternMapper*>(this->Mapper);
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const bool together = view && view->GetUseDistributedRenderingForRender() && controller &&
    controller->GetNumberOfProcesses() > 1 && mapper->GetWholeSurface();
  mapper->SetController(together ? controller : nullptr);
}

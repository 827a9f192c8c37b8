// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the mapper tells of the motion of its patterns.

#include "vtkPatternMapperInternals.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewContext.h"
#include "vtkTable.h"

#include <algorithm>
#include <stdexcept>

void vtkPatternMapper::Reanchor(vtkRenderer* renderer)
{
  if (vtkPatternViewContext* context = vtkPatternViewContext::Find(renderer))
  {
    context->Reanchor(this);
  }
}

void vtkPatternMapper::Reanchor()
{
  ++this->Internal->AnchorVersion;
}

unsigned long vtkPatternMapper::GetAnchorVersion() const
{
  return this->Internal->AnchorVersion;
}

void vtkPatternMapper::AnchorSurface()
{
  this->Internal->Surface.BeginAnew();
  this->Internal->PatchesBeginAnew = true;
}

namespace
{
void Store(const hachure::PatternFrame& from, double frame[6])
{
  const double values[6] = { from.origin.x, from.origin.y, from.u.x, from.u.y, from.v.x, from.v.y };
  std::copy(values, values + 6, frame);
}

void Store(const std::vector<hachure::PatchResidual>& from, vtkTable* table)
{
  vtkNew<vtkIntArray> patches;
  vtkNew<vtkDoubleArray> residuals;
  vtkNew<vtkDoubleArray> weights;
  patches->SetName("PatchId");
  residuals->SetName("Residual");
  weights->SetName("Weight");
  for (std::size_t patch = 0; patch < from.size(); ++patch)
  {
    patches->InsertNextValue(static_cast<int>(patch));
    residuals->InsertNextValue(from[patch].residual);
    weights->InsertNextValue(from[patch].weight);
  }
  for (vtkDataArray* column : { static_cast<vtkDataArray*>(patches),
         static_cast<vtkDataArray*>(residuals), static_cast<vtkDataArray*>(weights) })
  {
    table->AddColumn(column);
  }
}
} // namespace

bool vtkPatternMapper::GetDrawnFrame(vtkRenderer* renderer, double frame[6])
{
  vtkPatternViewContext* context = vtkPatternViewContext::Find(renderer);
  const auto* track = context ? context->FindTrack(this, nullptr) : nullptr;
  if (!track || track->Frames.empty())
  {
    return false;
  }
  Store(track->Frames[0], frame);
  return true;
}

bool vtkPatternMapper::GetDrawnFrame(vtkRenderer* renderer, int patch, double frame[6])
{
  vtkPatternViewContext* context = vtkPatternViewContext::Find(renderer);
  const auto* track = context ? context->FindTrack(this, nullptr) : nullptr;
  if (!track || patch < 0 || static_cast<std::size_t>(patch) >= track->Frames.size())
  {
    return false;
  }
  Store(track->Frames[static_cast<std::size_t>(patch)], frame);
  return true;
}

bool vtkPatternMapper::GetCommittedFrame(vtkRenderer* renderer, double frame[6])
{
  vtkPatternViewContext* context = vtkPatternViewContext::Find(renderer);
  auto* track = context ? context->FindTrack(this, nullptr) : nullptr;
  if (!track || track->Tracker.drawn().empty())
  {
    return false;
  }
  Store(track->Tracker.committed()[0], frame);
  return true;
}

double vtkPatternMapper::GetResidual(vtkRenderer* renderer)
{
  vtkPatternViewContext* context = vtkPatternViewContext::Find(renderer);
  auto* track = context ? context->FindTrack(this, nullptr) : nullptr;
  if (!track || track->Tracker.residual().empty())
  {
    return -1.0;
  }
  const auto residuals = track->Tracker.residual();
  const auto weights = track->Tracker.residualWeight();
  double sum = 0.0;
  double weight = 0.0;
  for (std::size_t patch = 0; patch < residuals.size(); ++patch)
  {
    sum += weights[patch] * residuals[patch];
    weight += weights[patch];
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

bool vtkPatternMapper::GetPatchResiduals(
  vtkRenderer* renderer, double minimumFacing, vtkTable* residuals)
{
  residuals->Initialize();
  vtkPatternViewContext* context = vtkPatternViewContext::Find(renderer);
  const auto* track = context ? context->FindTrack(this, nullptr) : nullptr;
  if (!track || !this->Style || track->Tracker.drawn().empty() ||
    track->SetVersion != track->Samples.GetSetVersion() ||
    this->Style->GetTrackingMode() == vtkPatternStyle::ANCHORED)
  {
    return false;
  }
  try
  {
    Store(track->Tracker.residualOver(track->Samples.Tracked(), minimumFacing), residuals);
  }
  catch (const std::invalid_argument& problem)
  {
    vtkErrorMacro(<< problem.what());
    return false;
  }
  return true;
}

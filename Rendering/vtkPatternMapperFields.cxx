// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of vtkPatternMapper's layers: what is drawn before the layers read it.
#include "vtkPatternMapperInternals.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkNoiseBackEnd.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternFieldStage.h"
#include "vtkPatternNoiseHistory.h"
#include "vtkPatternStippleHistory.h"
#include "vtkPatternStyle.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <exception>

namespace
{
bool IsSecondEye(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  return window->GetStereoRender() && window->GetStereoType() != VTK_STEREO_RIGHT &&
    !renderer->GetActiveCamera()->GetLeftEye();
}
} // namespace

void vtkPatternMapper::UpdatePrimitiveIds(bool needed)
{
  const unsigned long cells = this->Internal->Surface.GetCellVersion();
  if (needed && (!this->Internal->UsesPrimitiveIds || this->Internal->IdentifiedCells != cells))
  {
    this->Internal->UsesPrimitiveIds = true;
    this->Internal->IdentifiedCells = cells;
    this->Internal->ChannelTime.Modified();
    this->Modified();
  }
}

bool vtkPatternMapper::GetUsesPrimitiveIds() const
{
  return this->Internal->UsesPrimitiveIds;
}

void vtkPatternMapper::UpdateRuns(bool needed)
{
  if (!needed)
  {
    return;
  }
  this->TryUpdateSurface();
  const unsigned long cells = this->Internal->Surface.GetCellVersion();
  if (!this->Internal->UsesRuns || this->Internal->CellsOfRuns != cells)
  {
    this->Internal->UsesRuns = true;
    this->Internal->CellsOfRuns = cells;
    this->Internal->ChannelTime.Modified();
    this->Modified();
  }
}

bool vtkPatternMapper::GetUsesRuns() const
{
  return this->Internal->UsesRuns;
}

void vtkPatternMapper::UpdateSurface()
{
  vtkDataObject* input = this->GetSurfaceData();
  vtkAlgorithm* origin = this->InputOrigin;
  this->Internal->Surface.Update(input,
    { origin ? origin : this->GetInputAlgorithm(), this->GetInputConnection(0, 0)->GetIndex(),
      vtkPatternViewContext::DataTimeOf(input), this->AnimationTime });
}

void vtkPatternMapper::TryUpdateSurface()
{
  try
  {
    this->UpdateSurface();
  }
  catch (const std::exception&)
  {
    // Reported where fields are drawn; the surface is empty.
  }
}

void vtkPatternMapper::AppendPrimitiveIds(
  vtkPolyData* block, const std::vector<vtkIdType>& cells, std::vector<float>& ids)
{
  this->TryUpdateSurface();
  this->Internal->Surface.AppendPrimitiveIds(block, cells, ids);
}

void vtkPatternMapper::AppendRuns(vtkPolyData* block, std::vector<float>& records)
{
  this->TryUpdateSurface();
  this->Internal->Surface.AppendRuns(block, records);
}

// Of the object in this renderer; null for stand-ins of lower detail and anchored patterns.
vtkPatternNoiseHistory* vtkPatternMapper::NoiseHistory(Drawing& drawing)
{
  if (this->TrackedMapper)
  {
    return nullptr;
  }
  if (this->Style->GetTrackingMode() == vtkPatternStyle::ANCHORED)
  {
    drawing.Track->Noise.Forget();
    return nullptr;
  }
  drawing.Track->Noise.Keep(this->Style);
  return &drawing.Track->Noise;
}

// The same.
vtkPatternStippleHistory* vtkPatternMapper::StippleHistory(Drawing& drawing)
{
  if (this->TrackedMapper)
  {
    return nullptr;
  }
  if (this->Style->GetTrackingMode() == vtkPatternStyle::ANCHORED)
  {
    drawing.Track->Stipples.Forget();
    return nullptr;
  }
  drawing.Track->Stipples.Keep(this->Style);
  return &drawing.Track->Stipples;
}

// Returns whether all could be drawn.
bool vtkPatternMapper::DrawFields(Drawing& drawing, const glm::dmat4& modelToClip, bool forward)
{
  if (!drawing.Part.Compositor.NeedsFields())
  {
    return true;
  }
  double bounds[6];
  this->GetBounds(bounds);
  const vtkBoundingBox box(bounds);
  double center[3];
  box.GetCenter(center);
  std::string note;
  const int backEnd =
    forward ? GATHER : vtkNoiseBackEnd::Choose(drawing.Window, this->NoiseBackEnd, note);
  if (!note.empty() && note != this->Internal->ReportedBackEnd)
  {
    vtkWarningMacro(<< note);
    this->Internal->ReportedBackEnd = note;
  }
  try
  {
    this->UpdateSurface();
    vtkPatternMapper* steering = this->GetSteeringMapper();
    if (steering != this)
    {
      steering->UpdateSurface();
    }
    const bool carries = this->Style->GetTrackingMode() != vtkPatternStyle::ANCHORED;
    const vtkPatternFieldStage stage = { drawing.Window, *drawing.Part.Resources,
      this->Internal->Surface, steering->Internal->Surface, carries, this->NoiseHistory(drawing),
      this->StippleHistory(drawing), drawing.Viewport.IsTile, IsSecondEye(drawing.Renderer),
      modelToClip, drawing.Viewport.Drawn, drawing.Rectangle, { center[0], center[1], center[2] },
      backEnd, vtkPatternViewContext::Get(drawing.Renderer)->GetFrameNumber(),
      [&]() -> const std::vector<vtkPatternTonePeel::Image>&
      {
        this->PeelTones(drawing);
        return drawing.Tones;
      } };
    this->Report(
      forward ? stage.DrawForward(drawing.Part.Compositor) : stage.Draw(drawing.Part.Compositor),
      this->Internal->ReportedField);
    return true;
  }
  catch (const std::exception& problem)
  {
    this->Report(problem.what(), this->Internal->ReportedField);
    return false;
  }
}

void vtkPatternMapper::PeelTones(Drawing& drawing)
{
  const vtkPatternAttributes tonesAlone;
  if (drawing.Rectangle[2] < 1 || drawing.Rectangle[3] < 1 ||
    !drawing.Part.Resources->Prepare(drawing.Window, tonesAlone))
  {
    return;
  }
  vtkPatternTonePeel& peel = drawing.Part.TonePeel;
  vtkPatternShaderInjector* injector = this->Internal->PeelInjector;
  injector->Configure(vtkPatternShaderInjector::PEEL, this->Internal->Channels,
    this->Internal->Lights.GetCount(), this->Style->GetPaperSource() == vtkPatternStyle::FLAT,
    tonesAlone, std::string());
  injector->UniformSetter = [&](vtkShaderProgram* program)
  {
    this->Internal->Lights.SetUniforms(program, this->Internal->Channels);
    peel.SetUniforms(program);
  };
  drawing.Tones = peel.Peel(drawing.Window, *drawing.Part.Resources, drawing.Rectangle,
    [&]() { this->DrawAttributes(drawing, injector); });
  injector->UniformSetter = nullptr;
}

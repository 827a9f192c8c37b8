// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternViewContext.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternMapper.h"
#include "vtkPatternPatches.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewport.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkPatternViewContext);

namespace
{
// After everyone who moves the camera when a frame starts, before everyone who ends it.
constexpr float startPriority = -1000.0f;
constexpr float endPriority = 1000.0f;

vtkInformationObjectBaseKey* ContextKey()
{
  static vtkInformationObjectBaseKey* key =
    vtkInformationObjectBaseKey::MakeKey("CONTEXT", "vtkPatternViewContext");
  return key;
}

hachure::TrackerOptions OptionsOf(vtkPatternStyle* style)
{
  hachure::TrackerOptions options;
  switch (style->GetWeightScheme())
  {
    case vtkPatternStyle::CLASSIC:
      options.scheme = hachure::WeightScheme::Classic;
      break;
    case vtkPatternStyle::UNWEIGHTED:
      options.scheme = hachure::WeightScheme::Unweighted;
      break;
    default:
      options.scheme = hachure::WeightScheme::Symmetric;
  }
  return options;
}

// Whoever takes a screenshot hands back cameras that have lost their last digits.
constexpr double sameViewTolerance = 2e-6;
constexpr double sameTileTolerance = 1e-5;

bool NearlyEqual(
  const hachure::ViewProjection& a, const hachure::ViewProjection& b, double tolerance)
{
  const glm::dmat4 first = a.viewToClip * a.modelToView;
  const glm::dmat4 second = b.viewToClip * b.modelToView;
  double largest = 0.0;
  double difference = 0.0;
  for (int i = 0; i < 16; ++i)
  {
    largest = std::max(largest, std::abs(first[i / 4][i % 4]));
    difference = std::max(difference, std::abs(first[i / 4][i % 4] - second[i / 4][i % 4]));
  }
  return difference <= tolerance * largest && glm::length(a.viewportSize - b.viewportSize) < 0.5;
}
} // namespace

vtkPatternViewContext::vtkPatternViewContext() = default;
vtkPatternViewContext::~vtkPatternViewContext() = default;

vtkPatternViewContext* vtkPatternViewContext::Find(vtkRenderer* renderer)
{
  vtkInformation* information = renderer->GetInformation();
  return information ? vtkPatternViewContext::SafeDownCast(information->Get(ContextKey()))
                     : nullptr;
}

vtkPatternViewContext* vtkPatternViewContext::Get(vtkRenderer* renderer)
{
  vtkPatternViewContext* found = vtkPatternViewContext::Find(renderer);
  if (found)
  {
    return found;
  }
  if (!renderer->GetInformation())
  {
    vtkNew<vtkInformation> information;
    renderer->SetInformation(information);
  }
  vtkNew<vtkPatternViewContext> context;
  context->Attach(renderer);
  renderer->GetInformation()->Set(ContextKey(), context);
  return context;
}

void vtkPatternViewContext::Attach(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  renderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkPatternViewContext::StartFrame, startPriority);
  renderer->AddObserver(vtkCommand::EndEvent, this, &vtkPatternViewContext::EndFrame, endPriority);
}

vtkPatternViewContext::Track* vtkPatternViewContext::FindTrack(
  vtkPatternMapper* mapper, vtkActor* actor)
{
  for (auto& track : this->Tracks)
  {
    if (track->Mapper == mapper && (!actor || track->Actor == actor))
    {
      return track.get();
    }
  }
  return nullptr;
}

void vtkPatternViewContext::Reanchor(vtkPatternMapper* mapper)
{
  for (auto& track : this->Tracks)
  {
    if (track->Mapper == mapper)
    {
      track->Tracker.reanchor();
      track->View = hachure::ViewProjection();
      track->Visibility.Forget();
    }
  }
}

void vtkPatternViewContext::StartFrame()
{
  ++this->FrameNumber;
  const auto gone = [](const std::unique_ptr<Track>& track)
  { return !track->Mapper || !track->Actor; };
  this->Tracks.erase(
    std::remove_if(this->Tracks.begin(), this->Tracks.end(), gone), this->Tracks.end());
}

vtkPatternViewContext::Track* vtkPatternViewContext::Advance(
  vtkPatternMapper* mapper, vtkActor* actor, const vtkPatternViewport& viewport, bool lowDetail)
{
  Track* track = this->FindTrack(mapper, actor);
  if (!track)
  {
    this->Tracks.push_back(std::make_unique<Track>());
    track = this->Tracks.back().get();
    track->Mapper = mapper;
    track->Actor = actor;
  }
  try
  {
    this->Predict(*track, viewport, lowDetail || viewport.IsTile);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro("The pattern cannot follow the surface: " << problem.what());
    track->Frames.assign(1, hachure::PatternFrame());
  }
  return track;
}

void vtkPatternViewContext::Predict(Track& track, const vtkPatternViewport& viewport, bool lookOn)
{
  vtkPatternStyle* style = track.Mapper->GetStyle();
  vtkPatternSamples::Options options;
  options.SamplesPerPatch = style->GetSamplesPerPatch();
  const vtkPatternPatches& patches = track.Mapper->GetPatches();
  if (patches.IsActive())
  {
    options.PatchArrayName = patches.GetArrayName();
    options.PatchHash = patches.GetHash();
  }
  const bool changed = track.Samples.Update(track.Mapper->GetInputDataObject(0, 0), options);
  const hachure::TrackedSamples samples = track.Samples.Tracked();
  if (samples.positions.empty())
  {
    track.Frames.assign(1, hachure::PatternFrame());
    return;
  }
  const hachure::ViewProjection view = viewport.View(this->Renderer, track.Actor);
  if (style->GetTrackingMode() == vtkPatternStyle::ANCHORED)
  {
    track.Frames = track.Mapper->AnchoredFrames(samples, view, this->Renderer);
    return;
  }
  const bool stereo = this->Renderer->GetRenderWindow()->GetStereoRender() != 0;
  if (lookOn && !track.Tracker.drawn().empty())
  {
    const auto drawn = track.Tracker.drawn();
    track.Frames = !changed && NearlyEqual(view, track.View, sameTileTolerance)
      ? std::vector<hachure::PatternFrame>(drawn.begin(), drawn.end())
      : track.Tracker.preview(samples, view);
    return;
  }
  if (track.Frame != this->FrameNumber)
  {
    this->AdvanceTracker(track, view, changed);
  }
  if (stereo)
  {
    track.Frames =
      track.Tracker.previewFromDrawn(samples, viewport.EyeView(this->Renderer, track.Actor));
    return;
  }
  const auto drawn = track.Tracker.drawn();
  track.Frames.assign(drawn.begin(), drawn.end());
}

void vtkPatternViewContext::AdvanceTracker(
  Track& track, const hachure::ViewProjection& view, bool changed)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  const std::vector<std::uint8_t> visibility = track.Visibility.Read(window);
  const hachure::TrackedSamples samples = track.Samples.Tracked();
  if (track.SetVersion != track.Samples.GetSetVersion())
  {
    track.Tracker.replaceSamples(samples);
    track.SetVersion = track.Samples.GetSetVersion();
  }
  else if (!visibility.empty())
  {
    track.Tracker.setVisibility(visibility);
  }
  track.Tracker.setOptions(OptionsOf(track.Mapper->GetStyle()));
  track.Moved =
    changed || track.Tracker.drawn().empty() || !NearlyEqual(view, track.View, sameViewTolerance);
  track.Frame = this->FrameNumber;
  if (track.Moved)
  {
    track.Tracker.advance(samples, view);
    track.View = view;
  }
}

void vtkPatternViewContext::EndFrame()
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (!window || this->Renderer->GetSelector())
  {
    return;
  }
  vtkTextureObject* depth = nullptr;
  for (auto& track : this->Tracks)
  {
    if (!track->Mapper || !track->Visibility.IsOwnMeasured())
    {
      continue;
    }
    if (!depth)
    {
      this->Resources = vtkPatternWindowResources::Get(window);
      const vtkPatternViewport viewport(this->Renderer, 1.0);
      depth = this->Resources->CaptureDepth(window, viewport.Drawn);
    }
    track->Visibility.MeasureScene(window, depth);
  }
}

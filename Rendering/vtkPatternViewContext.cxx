// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternViewContext.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkImagePatternLayer.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternMapper.h"
#include "vtkPatternPatches.h"
#include "vtkPatternSharedVisibility.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewport.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

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

unsigned long NextFrameNumber()
{
  static unsigned long last = 0;
  return ++last;
}

// Time that has passed between two moments, by the data's clock where both have one; it may stand.
double TimeBetween(
  const vtkPatternViewContext::Moment& before, const vtkPatternViewContext::Moment& after)
{
  const double data = after.DataTime - before.DataTime;
  return std::isfinite(data) ? data : after.AnimationTime - before.AnimationTime;
}

// The same by the clock of AnimationTime where that of the data stands.
double TimeBetweenMoving(
  const vtkPatternViewContext::Moment& before, const vtkPatternViewContext::Moment& after)
{
  const double data = TimeBetween(before, after);
  return data != 0.0 ? data : after.AnimationTime - before.AnimationTime;
}

// Since the last advance, for what moves with the data.
double TimePassed(const vtkPatternViewContext::Track& track)
{
  return TimeBetween(track.Advanced, vtkPatternViewContext::MomentOf(track.Mapper));
}

// The same for what takes a time. The clock of data that stand would stop it.
double TransitionTimePassed(const vtkPatternViewContext::Track& track)
{
  const auto now = vtkPatternViewContext::MomentOf(track.Mapper);
  return track.DataMoves ? TimeBetween(track.Advanced, now)
                         : TimeBetweenMoving(track.Advanced, now);
}

// Gives a tracker the present samples of a surface. Where the velocity of those before is known,
// the pattern first follows them to where they are now.
void HandOver(const vtkPatternViewContext::Track& track, const hachure::TrackedSamples& samples,
  const hachure::ViewProjection& view, hachure::PatternTracker& tracker)
{
  const std::size_t count = track.Before.Positions.size();
  const double passed = TimePassed(track);
  if (count > 0 && track.VelocityBefore.size() == 3 * count && passed != 0.0)
  {
    std::vector<glm::dvec3> carried = track.Before.Positions;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double* velocity = &track.VelocityBefore[3 * i];
      carried[i] += passed * glm::dvec3(velocity[0], velocity[1], velocity[2]);
    }
    tracker.advance({ carried, track.Before.Normals, track.Before.Patches,
                      track.Before.PatchSpacing, track.FeaturesBefore },
      view);
  }
  tracker.replaceSamples(samples);
}

// Octaves of the layers whose transitions take a time, after `passed` of it; still: those that are
// known stay as they are. Those of layers that the style no longer has are forgotten.
vtkPatternViewContext::Track::LayerOctaves Advanced(
  const vtkPatternViewContext::Track::LayerOctaves& known, vtkPatternStyle* style,
  hachure::Span<const hachure::PatternFrame> frames, double passed, bool still)
{
  vtkPatternViewContext::Track::LayerOctaves octaves;
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    auto* layer = vtkImagePatternLayer::SafeDownCast(style->GetLayer(i));
    if (!layer || !(layer->GetTransitionTime() > 0.0))
    {
      continue;
    }
    const hachure::TimedOctaveOptions options{ layer->GetLodStart(),
      std::max(layer->GetLodStart(), layer->GetLodEnd()), layer->GetTransitionTime() };
    const auto found = known.find(layer);
    std::vector<hachure::TimedOctave>& patches = octaves[layer];
    if (found != known.end())
    {
      patches = found->second;
    }
    const std::size_t first = still ? std::min(patches.size(), frames.size()) : 0;
    patches.resize(frames.size());
    for (std::size_t patch = first; patch < frames.size(); ++patch)
    {
      patches[patch] =
        hachure::advanceOctave(patches[patch], glm::length(frames[patch].u), passed, options);
    }
  }
  return octaves;
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

double vtkPatternViewContext::DataTimeOf(vtkDataObject* input)
{
  vtkInformation* information = input->GetInformation();
  return information->Has(vtkDataObject::DATA_TIME_STEP())
    ? information->Get(vtkDataObject::DATA_TIME_STEP())
    : std::numeric_limits<double>::quiet_NaN();
}

vtkPatternViewContext::Moment vtkPatternViewContext::MomentOf(vtkPatternMapper* mapper)
{
  return { DataTimeOf(mapper->GetSurfaceData()), mapper->GetAnimationTime() };
}

vtkPatternViewContext::vtkPatternViewContext() = default;
vtkPatternViewContext::~vtkPatternViewContext() = default;

hachure::TrackerOptions vtkPatternViewContext::OptionsOf(vtkPatternStyle* style)
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
    default: // perceptual weights are symmetric ones of samples with features
      options.scheme = hachure::WeightScheme::Symmetric;
  }
  options.lockRotation = style->GetLockRotation();
  options.lockScale = style->GetLockScale();
  return options;
}

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
  this->FrameNumber = NextFrameNumber();
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
      this->Forget(*track);
    }
  }
}

void vtkPatternViewContext::Forget(Track& track)
{
  track.Tracker.reanchor();
  track.KnownOctaves.clear();
  track.Noise.Forget();
  track.Stipples.Forget();
  track.View = hachure::ViewProjection();
  track.Visibility.Forget();
  track.Samples.BeginAnew();
  track.SetVersion = 0;
  track.Before = vtkPatternSamples::Surface();
  track.VelocityBefore.clear();
  track.FeaturesBefore.clear();
  track.DataMoves = false;
  track.Advanced = MomentOf(track.Mapper);
  track.First = track.Advanced;
  track.Mapper->AnchorSurface();
}

// Whether time has come back to when the patterns began: from a later one, as where an animation
// begins again. Who goes back from there on is followed, unless nothing follows.
bool vtkPatternViewContext::IsBack(const Track& track, const Moment& now)
{
  if (TimeBetweenMoving(track.Last, now) >= 0.0 || TimeBetweenMoving(track.First, now) > 0.0)
  {
    return false;
  }
  const bool anchored = track.Mapper->GetStyle()->GetTrackingMode() == vtkPatternStyle::ANCHORED;
  return anchored || TimeBetweenMoving(track.First, track.Last) > 0.0;
}

void vtkPatternViewContext::BeginFrame(vtkPatternMapper* mapper, vtkActor* actor)
{
  Track* track = this->FindTrack(mapper, actor);
  if (!track)
  {
    return;
  }
  const Moment now = MomentOf(mapper);
  if (IsBack(*track, now) || track->AnchorVersion != mapper->GetAnchorVersion())
  {
    this->Forget(*track);
  }
  if (TimeBetweenMoving(track->First, now) < 0.0)
  {
    track->First = now;
  }
  track->AnchorVersion = mapper->GetAnchorVersion();
  track->Last = now;
}

void vtkPatternViewContext::StartFrame()
{
  this->FrameNumber = NextFrameNumber();
  const auto gone = [](const std::unique_ptr<Track>& track)
  { return !track->Mapper || !track->Actor; };
  this->Tracks.erase(
    std::remove_if(this->Tracks.begin(), this->Tracks.end(), gone), this->Tracks.end());
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (window && !this->Renderer->GetSelector())
  {
    this->ShareVisibility(window);
  }
}

// Together, once a frame: a rank may skip any later step that another one takes.
void vtkPatternViewContext::ShareVisibility(vtkOpenGLRenderWindow* window)
{
  std::map<vtkMultiProcessController*, std::vector<Track*>> shared;
  for (auto& track : this->Tracks)
  {
    if (vtkMultiProcessController* controller = track->Mapper->GetController())
    {
      shared[controller].push_back(track.get());
    }
  }
  for (const auto& group : shared)
  {
    vtkPattern::SharedVisibility sharing(group.first);
    for (Track* track : group.second)
    {
      sharing.Add(track->Visibility.ReadNearest(window), track->Visibility.GetCount());
    }
    if (sharing.Exchange())
    {
      for (std::size_t i = 0; i < group.second.size(); ++i)
      {
        group.second[i]->Shared = sharing.Get(i);
      }
    }
  }
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
    track->Advanced = track->First = track->Last = MomentOf(mapper);
    track->AnchorVersion = mapper->GetAnchorVersion();
  }
  try
  {
    this->Predict(*track, viewport, lowDetail);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro("The pattern cannot follow the surface: " << problem.what());
    track->Frames.assign(1, hachure::PatternFrame());
  }
  return track;
}

// Returns true where the samples have changed.
bool vtkPatternViewContext::UpdateSamples(Track& track)
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
  const std::uint64_t known = track.Samples.GetSetVersion();
  vtkPatternSamples::Surface replaced;
  const bool changed = track.Samples.Update(track.Mapper->GetSurfaceData(), options, &replaced);
  if (track.Samples.GetSetVersion() != known && known == track.SetVersion)
  {
    track.Before = std::move(replaced);
    track.VelocityBefore = std::move(track.Velocity.Numbers);
    track.FeaturesBefore = track.Features.GetFactors();
  }
  track.Problem.clear();
  const std::string velocity = track.Mapper->GetVelocityArrayName();
  try
  {
    if (velocity.empty())
    {
      track.Velocity = vtkPatternSamples::Values();
    }
    else
    {
      track.Samples.Read(
        "velocity", velocity, 3, vtkPatternSamples::Association::Points, track.Velocity);
    }
  }
  catch (const std::invalid_argument& problem)
  {
    track.Problem = problem.what();
    track.Velocity = vtkPatternSamples::Values();
  }
  return changed;
}

void vtkPatternViewContext::Predict(
  Track& track, const vtkPatternViewport& viewport, bool lowDetail)
{
  vtkPatternStyle* style = track.Mapper->GetStyle();
  const bool changed = this->UpdateSamples(track);
  hachure::TrackedSamples samples = track.Samples.Tracked();
  if (samples.positions.empty())
  {
    track.Frames.assign(1, hachure::PatternFrame());
    return;
  }
  samples.features =
    track.Features.Update(style, track.Samples, this->Renderer, track.Actor, track.Problem);
  const hachure::ViewProjection view = viewport.View(this->Renderer, track.Actor);
  if (style->GetTrackingMode() == vtkPatternStyle::ANCHORED)
  {
    track.Frames = track.Mapper->AnchoredFrames(samples, view, this->Renderer);
    track.KnownOctaves.clear();
    track.Octaves.clear();
    return;
  }
  const bool stereo = this->Renderer->GetRenderWindow()->GetStereoRender() != 0;
  if (lowDetail || (viewport.IsTile && !track.Tracker.drawn().empty()))
  {
    this->LookOn(track, samples, view, changed);
    return;
  }
  if (track.Frame != this->FrameNumber)
  {
    this->AdvanceTracker(track, samples, view, changed);
  }
  track.Octaves = track.KnownOctaves;
  if (stereo)
  {
    track.Frames =
      track.Tracker.previewFromDrawn(samples, viewport.EyeView(this->Renderer, track.Actor));
    return;
  }
  const auto drawn = track.Tracker.drawn();
  track.Frames.assign(drawn.begin(), drawn.end());
}

// What an advance would give.
void vtkPatternViewContext::LookOn(Track& track, const hachure::TrackedSamples& samples,
  const hachure::ViewProjection& view, bool changed)
{
  const bool replaced = track.SetVersion != track.Samples.GetSetVersion();
  if (!changed && !replaced && NearlyEqual(view, track.View, sameTileTolerance))
  {
    const auto drawn = track.Tracker.drawn();
    track.Frames.assign(drawn.begin(), drawn.end());
    track.Octaves = track.KnownOctaves;
    return;
  }
  hachure::PatternTracker copy(track.Tracker);
  copy.setOptions(vtkPatternViewContext::OptionsOf(track.Mapper->GetStyle()));
  if (replaced)
  {
    HandOver(track, samples, view, copy);
  }
  track.Frames = copy.preview(samples, view);
  track.Octaves = Advanced(
    track.KnownOctaves, track.Mapper->GetStyle(), track.Frames, TransitionTimePassed(track), false);
}

void vtkPatternViewContext::AdvanceTracker(Track& track, const hachure::TrackedSamples& samples,
  const hachure::ViewProjection& view, bool changed)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  const std::vector<std::uint8_t> visibility =
    track.Mapper->GetController() ? std::move(track.Shared) : track.Visibility.Read(window);
  track.Shared.clear();
  const bool replaced = track.SetVersion != track.Samples.GetSetVersion();
  track.Tracker.setOptions(vtkPatternViewContext::OptionsOf(track.Mapper->GetStyle()));
  const std::size_t known = replaced ? track.Before.Positions.size() : samples.positions.size();
  if (!visibility.empty() && visibility.size() == known)
  {
    track.Tracker.setVisibility(visibility);
  }
  if (replaced)
  {
    HandOver(track, samples, view, track.Tracker);
    track.SetVersion = track.Samples.GetSetVersion();
    track.Before = vtkPatternSamples::Surface();
    track.VelocityBefore = std::vector<double>();
    track.FeaturesBefore = std::vector<double>();
  }
  track.Moved = changed || replaced || track.Tracker.drawn().empty() ||
    !NearlyEqual(view, track.View, sameViewTolerance);
  track.Frame = this->FrameNumber;
  const double passed = TransitionTimePassed(track);
  const double data = TimePassed(track);
  track.Advanced = MomentOf(track.Mapper);
  track.DataMoves = track.DataMoves || (std::isfinite(track.Advanced.DataTime) && data != 0.0);
  if (track.Moved)
  {
    track.Tracker.advance(samples, view);
    track.View = view;
  }
  track.KnownOctaves = Advanced(track.KnownOctaves, track.Mapper->GetStyle(), track.Tracker.drawn(),
    passed, !track.Moved && passed == 0.0);
}

void vtkPatternViewContext::EndFrame()
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (!window || this->Renderer->GetSelector())
  {
    return;
  }
  // The part of the picture in which samples are looked for.
  std::array<int, 4> area = { 0, 0, 0, 0 };
  std::vector<Track*> measured;
  for (auto& track : this->Tracks)
  {
    if (track->Mapper && track->Visibility.IsOwnMeasured())
    {
      area = measured.empty() ? track->Rectangle : vtkPattern::Union(area, track->Rectangle);
      measured.push_back(track.get());
    }
  }
  if (measured.empty())
  {
    return;
  }
  this->Resources = vtkPatternWindowResources::Get(window);
  vtkTextureObject* depth = this->Resources->CaptureDepth(window, area);
  for (Track* track : measured)
  {
    track->Visibility.MeasureScene(window, depth);
  }
}

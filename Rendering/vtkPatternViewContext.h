// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What patterns must remember from frame to frame in one renderer.
 *
 * The state of a pattern belongs to (renderer, mapper, actor): two views of one object move their
 * patterns independently. It lives in the renderer's information. The renderer's StartEvent opens
 * a frame; in it the first full drawing of an object advances its pattern, and every further
 * drawing (the other eye, depth peeling) finds it there. Tiles of a screenshot and stand-ins of
 * lower detail never advance it: they draw what an advance would give. The renderer's EndEvent
 * measures which samples the finished picture shows. In stereo the state is that of the view from
 * between the eyes, and each eye draws it moved to its own view.
 */
#ifndef vtkPatternViewContext_h
#define vtkPatternViewContext_h

#include "PatternTracker.h"
#include "TimedOctave.h"
#include "vtkObject.h"
#include "vtkPatternFeatures.h"
#include "vtkPatternNoiseHistory.h"
#include "vtkPatternSamples.h"
#include "vtkPatternStippleHistory.h"
#include "vtkPatternVisibility.h"
#include "vtkPatternWindowResources.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkOpenGLRenderWindow;
class vtkPatternLayer;
class vtkPatternMapper;
class vtkPatternStyle;
class vtkRenderer;
struct vtkPatternViewport;

class vtkPatternViewContext : public vtkObject
{
public:
  static vtkPatternViewContext* New();
  vtkTypeMacro(vtkPatternViewContext, vtkObject);

  /// The context of a renderer, made where there is none.
  static vtkPatternViewContext* Get(vtkRenderer* renderer);
  /// The context of a renderer, null where there is none.
  static vtkPatternViewContext* Find(vtkRenderer* renderer);

  /// When a frame is drawn.
  struct Moment
  {
    double DataTime = std::numeric_limits<double>::quiet_NaN(); // where the data have one
    double AnimationTime = 0.0;
  };
  static Moment MomentOf(vtkPatternMapper* mapper);

  struct Track
  {
    vtkWeakPointer<vtkPatternMapper> Mapper;
    vtkWeakPointer<vtkActor> Actor;
    vtkPatternSamples Samples;
    hachure::PatternTracker Tracker;
    hachure::ViewProjection View; // of the last advance
    std::uint64_t SetVersion = 0;
    unsigned long Frame = 0; // the frame of the last advance
    bool Moved = true;       // that advance saw another view or surface than the one before
    vtkPatternVisibility Visibility;
    std::vector<std::uint8_t> Shared; // visibility of the last frame, found out with others
    std::array<int, 4> Rectangle{}; ///< x, y, width, height of what was drawn, where it is measured
    vtkPatternFeatures Features;
    vtkPatternSamples::Values Velocity; // of the samples, where an array is named
    vtkPatternSamples::Surface Before;  // samples that the tracker knows and that were replaced
    std::vector<double> VelocityBefore; // theirs, and their features
    std::vector<double> FeaturesBefore;
    Moment Advanced;                           // the last time
    bool DataMoves = false;                    // their time has changed since the patterns began
    Moment First, Last;                        // that were drawn since
    unsigned long AnchorVersion = 0;           // of the mapper, then
    std::vector<hachure::PatternFrame> Frames; // to draw
    /// Of every patch, for the layers whose transitions take a time: as of the last advance, and to
    /// draw.
    using LayerOctaves =
      std::map<vtkSmartPointer<vtkPatternLayer>, std::vector<hachure::TimedOctave>>;
    LayerOctaves KnownOctaves;
    LayerOctaves Octaves;
    vtkPatternNoiseHistory Noise;
    vtkPatternStippleHistory Stipples;
    std::string Problem; // with an array of the input, empty where there is none
  };

  /// Time of a data set, not a number where it has none.
  static double DataTimeOf(vtkDataObject* input);

  /// How a style wants its patterns tracked.
  static hachure::TrackerOptions OptionsOf(vtkPatternStyle* style);
  /// The track of an object; `lowDetail` for a stand-in that only looks on.
  Track* Advance(
    vtkPatternMapper* mapper, vtkActor* actor, const vtkPatternViewport& viewport, bool lowDetail);
  /// Before an object is drawn as a whole: where its mapper asks for it, or time has come back to
  /// when its patterns began, it is drawn as if it were the first time.
  void BeginFrame(vtkPatternMapper* mapper, vtkActor* actor);
  /// The track of an object where there is one.
  Track* FindTrack(vtkPatternMapper* mapper, vtkActor* actor);
  /// Number of the frame that is drawn: no other frame of any renderer has it.
  unsigned long GetFrameNumber() const { return this->FrameNumber; }
  /// Forgets how the patterns of a mapper have moved.
  void Reanchor(vtkPatternMapper* mapper);

protected:
  vtkPatternViewContext();
  ~vtkPatternViewContext() override;

private:
  void Attach(vtkRenderer* renderer);
  void StartFrame();
  void EndFrame();
  static bool IsBack(const Track& track, const Moment& now);
  void Forget(Track& track);
  void ShareVisibility(vtkOpenGLRenderWindow* window);
  void Predict(Track& track, const vtkPatternViewport& viewport, bool lowDetail);
  bool UpdateSamples(Track& track);
  void LookOn(Track& track, const hachure::TrackedSamples& samples,
    const hachure::ViewProjection& view, bool changed);
  void AdvanceTracker(Track& track, const hachure::TrackedSamples& samples,
    const hachure::ViewProjection& view, bool changed);

  vtkRenderer* Renderer = nullptr; // owns this object
  std::vector<std::unique_ptr<Track>> Tracks;
  std::shared_ptr<vtkPatternWindowResources> Resources;
  unsigned long FrameNumber = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternViewContext.h

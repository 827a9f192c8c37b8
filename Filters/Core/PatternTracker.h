// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternTracker_h
#define hachure_PatternTracker_h

#include "PatchFit.h"
#include "SampleProjection.h"
#include "Similarity.h"
#include "Span.h"

#include <cstdint>
#include <vector>

// Moves the pattern of every patch of a surface from frame to frame (Breslav et al. 2007, section
// 3).
//
// Which samples are visible is measured in the drawn picture, hence known only after drawing. So a
// step is made twice. Before drawing frame t it is *predicted*, with the visibility of frame t-1
// for both frames, and drawn. When the visibility of frame t has arrived the step is fitted again,
// every frame weighted by its own visibility, and *committed*; the next prediction starts there.
// Only commits accumulate. As the weights of a frame then depend on that frame alone, and the fit
// is symmetric, a movement there and back returns the pattern exactly.
namespace hachure
{

struct TrackerOptions
{
  WeightScheme scheme = WeightScheme::Symmetric;
  bool lockRotation = false; // the pattern keeps its direction in the image
  bool lockScale = false;    // the pattern keeps its size in the image
  // A step is a cut, after which the pattern is anchored anew, where ...
  double minimumCommonWeight =
    0.05; // ... less of the smaller frame's weight is common to both frames
  double maximumDisplacement = 1.0; // ... it moves further, in diagonals of the viewport
  double minimumCorrelation = 0.25; // ... it resembles no similarity (SimilarityFit::correlation)
};

class PatternTracker
{
public:
  // Throws std::invalid_argument on thresholds out of range: fractions in [0, 1], a displacement >
  // 0.
  void setOptions(const TrackerOptions& options);

  // Once per frame, before drawing. True if a drawn transform changed. An equal view of equal
  // samples keeps the drawn frames bit for bit. Throws as projectSamples does.
  bool advance(const TrackedSamples& samples, const ViewProjection& view);
  // The visibility of the samples in the picture of the last advance, 0 to 255. May be repeated;
  // the last one counts. Throws std::invalid_argument on a number of values other than that of
  // samples.
  void setVisibility(Span<const std::uint8_t> visibility);

  // Other samples of the same surface as it was when last advanced, as after a change of its
  // connectivity: the patterns stay where they were drawn and follow the new samples from there.
  // Without a frame drawn before it does nothing. Throws as projectSamples does.
  void replaceSamples(const TrackedSamples& samples);

  // What advance() would draw for this view; changes nothing.
  std::vector<PatternFrame> preview(
    const TrackedSamples& samples, const ViewProjection& view) const;
  // The frame drawn last, moved to another view of the same instant (the other eye).
  std::vector<PatternFrame> previewFromDrawn(
    const TrackedSamples& samples, const ViewProjection& view) const;

  // Per patch.
  Span<const PatternFrame> drawn() const { return this->now.frames; }
  Span<const PatternFrame> committed() const;
  // Weighted mean distance in pixels by which the pattern slid over the surface in the drawn step.
  Span<const double> residual() const { return this->stepResidual; }
  // The weight of the samples that the residual of each patch is the mean over.
  Span<const double> residualWeight() const { return this->stepWeight; }
  // The same over the samples that are turned to the eye by at least minimumFacing in the drawn
  // frame; -1 = all of them, else n.v. `samples` are those of the last advance. Empty before the
  // first frame. Throws std::invalid_argument on other samples and a limit outside [-1, 1].
  std::vector<PatchResidual> residualOver(
    const TrackedSamples& samples, double minimumFacing) const;
  Span<const FitStatus> status() const { return this->stepStatus; }
  // 1 where the drawn frame was anchored, 0 where it continues the frame before.
  Span<const std::uint8_t> anchored() const { return this->now.anchored; }

  // Forgets everything; the next advance anchors.
  void reanchor();

private:
  struct Picture
  {
    ProjectedSamples samples;             // signed weights
    std::vector<double> weights;          // by `visibility`, until measured by that of the base
    std::vector<std::uint8_t> visibility; // empty until measured
    std::vector<double> frontWeights;     // per patch
    std::vector<PatternFrame> frames;
    std::vector<std::uint8_t> anchored;
    glm::dvec2 viewportSize{ 0.0 };
  };
  struct Step
  {
    PatchFits patches;
    std::vector<std::uint8_t> cut; // per patch
    bool weak = false;             // some patch has lost half of its common weight
  };

  static void project(const TrackedSamples& samples, const ViewProjection& view, Picture& picture);
  void weigh(Picture& picture, Span<const std::uint8_t> visibility) const;
  Span<const std::uint8_t> drawnVisibility() const;
  bool isCut(const PatchFits& fits, std::size_t patch, double diagonal) const;
  Step fitStep(const Picture& previous, const Picture& current) const;
  std::vector<PatternFrame> framesAfter(
    const Picture& previous, const Picture& current, const Step& step) const;
  PatternFrame follow(const PatternFrame& frame, const SimilarityFit& fit) const;
  bool matches(const TrackedSamples& samples) const;
  void adopt(const TrackedSamples& samples);
  void start(const TrackedSamples& samples);
  void markSeen(const Picture& picture);
  bool settle();
  void predict(bool settled);
  void measureStep(const Step& step);

  TrackerOptions options;
  PatchRuns patches;
  ViewProjection view;
  Picture base; // the committed state that the drawn step starts from
  Picture now;  // the frame drawn last
  Picture next; // the frame to be drawn, in the memory of one before
  std::vector<PatternFrame>
    commitment;                   // frames of `now` with its own visibility; empty until known
  std::vector<std::uint8_t> seen; // per patch
  std::vector<double> stepResidual;
  std::vector<double> stepWeight;
  std::vector<FitStatus> stepStatus;
  bool started = false;
};

} // namespace hachure

#endif

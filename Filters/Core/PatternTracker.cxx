// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternTracker.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

// Without a measured visibility for the drawn frame steps start from the last commit, until one of
// them has less than this part of its weight in common with it.
constexpr double weakCommonWeight = 0.5;

void checkFraction(const char* name, double value)
{
  if (!(value >= 0.0 && value <= 1.0))
  {
    throw std::invalid_argument("PatternTracker::setOptions: " + std::string(name) + " is " +
      std::to_string(value) + ", expected 0 to 1");
  }
}

} // namespace

void PatternTracker::setOptions(const TrackerOptions& newOptions)
{
  checkFraction("minimumCommonWeight", newOptions.minimumCommonWeight);
  checkFraction("minimumCorrelation", newOptions.minimumCorrelation);
  if (!(newOptions.maximumDisplacement > 0.0))
  {
    throw std::invalid_argument("PatternTracker::setOptions: maximumDisplacement is " +
      std::to_string(newOptions.maximumDisplacement) + ", expected more than 0");
  }
  const bool otherWeights = this->options.scheme != newOptions.scheme;
  this->options = newOptions;
  if (otherWeights)
  {
    this->weigh(this->base, this->base.visibility);
    this->weigh(this->now, this->drawnVisibility());
  }
}

void PatternTracker::reanchor()
{
  this->started = false;
}

bool PatternTracker::matches(const TrackedSamples& samples) const
{
  return this->started && this->patches.patchTotal == samples.patchSpacing.size() &&
    areRunsOf(this->patches, samples.patches, samples.positions.size());
}

void PatternTracker::project(
  const TrackedSamples& samples, const ViewProjection& newView, Picture& picture)
{
  projectSamples(samples, newView, FacingRule::Signed, picture.samples);
  picture.viewportSize = newView.viewportSize;
  picture.visibility.clear();
}

void PatternTracker::weigh(Picture& picture, Span<const std::uint8_t> visibility) const
{
  weighSamples(
    picture.samples, picture.viewportSize, visibility, this->options.scheme, picture.weights);
}

// What is known of the visibility in the frame drawn last: until it is measured, that of the frame
// that it was predicted from.
Span<const std::uint8_t> PatternTracker::drawnVisibility() const
{
  return this->now.visibility.empty() ? this->base.visibility : this->now.visibility;
}

// A patch hidden in one of the frames waits; one seen in both frames must have moved as one.
bool PatternTracker::isCut(const PatchFits& fits, std::size_t patch, double diagonal) const
{
  const SimilarityFit& fit = fits.fits[patch];
  const double smaller = std::min(fits.previousWeights[patch], fits.currentWeights[patch]);
  return smaller > 0.0 &&
    (fit.weight < this->options.minimumCommonWeight * smaller ||
      fit.correlation < this->options.minimumCorrelation ||
      glm::length(fit.transform.to - fit.transform.from) >
        this->options.maximumDisplacement * diagonal);
}

PatternTracker::Step PatternTracker::fitStep(const Picture& previous, const Picture& current) const
{
  Step step;
  step.patches = fitPatches({ previous.samples, previous.weights },
    { current.samples, current.weights }, this->patches, this->options.scheme);
  const double diagonal =
    std::max(glm::length(previous.viewportSize), glm::length(current.viewportSize));
  for (std::size_t patch = 0; patch < this->patches.patchTotal; ++patch)
  {
    const double smaller =
      std::min(step.patches.previousWeights[patch], step.patches.currentWeights[patch]);
    step.cut.push_back(this->isCut(step.patches, patch, diagonal) ? 1 : 0);
    step.weak = step.weak || step.cut.back() != 0 ||
      step.patches.fits[patch].weight < weakCommonWeight * smaller;
  }
  return step;
}

// The frames of the previous picture moved by the step, and anchored anew at a cut or where a patch
// was never seen: together with the patch that covers most of the picture, where one goes on.
std::vector<PatternFrame> PatternTracker::framesAfter(
  const Picture& previous, const Picture& current, const Step& step) const
{
  const std::size_t total = this->patches.patchTotal;
  const auto continues = [&](std::size_t patch)
  { return step.cut[patch] == 0 && this->seen[patch] != 0; };
  std::vector<PatternFrame> frames(total);
  std::size_t widest = total;
  bool allContinue = true;
  for (std::size_t patch = 0; patch < total; ++patch)
  {
    if (continues(patch))
    {
      frames[patch] = this->follow(previous.frames[patch], step.patches.fits[patch]);
      const bool wider =
        widest == total || current.frontWeights[patch] > current.frontWeights[widest];
      widest = wider ? patch : widest;
    }
    else
    {
      allContinue = false;
    }
  }
  if (!allContinue)
  {
    const PatternFrame fresh = widest < total ? frames[widest] : anchorPattern(current.samples);
    for (std::size_t patch = 0; patch < total; ++patch)
    {
      frames[patch] = continues(patch) ? frames[patch] : fresh;
    }
  }
  return frames;
}

PatternFrame PatternTracker::follow(const PatternFrame& frame, const SimilarityFit& fit) const
{
  Similarity transform = fit.transform;
  if (this->options.lockRotation)
  {
    transform.z = { transform.scale(), 0.0 };
  }
  if (this->options.lockScale)
  {
    transform.z /= transform.scale();
  }
  return hachure::advance(frame, transform);
}

// The samples of the next picture replace those before, whose visibility tells nothing of them.
void PatternTracker::adopt(const TrackedSamples& samples)
{
  const std::size_t total = samples.patchSpacing.size();
  this->patches = findPatchRuns(samples.patches, samples.positions.size(), total);
  this->seen.resize(total, 0); // patches that are new anchor when they are seen
  this->stepResidual.resize(total, 0.0);
  this->stepWeight.resize(total, 0.0);
  this->stepStatus.resize(total, FitStatus::NoSamples);
  this->commitment.clear();
  this->weigh(this->next, {});
  this->next.frontWeights = frontWeights(this->next.samples, this->patches);
}

void PatternTracker::start(const TrackedSamples& samples)
{
  this->seen.clear();
  this->stepResidual.clear();
  this->stepWeight.clear();
  this->stepStatus.clear();
  this->adopt(samples);
  this->markSeen(this->next);
  this->next.frames.assign(this->patches.patchTotal, anchorPattern(this->next.samples));
  this->next.anchored.assign(this->patches.patchTotal, 1);
  this->now = std::move(this->next);
  this->base = this->now;
  this->started = true;
}

void PatternTracker::replaceSamples(const TrackedSamples& samples)
{
  if (!this->started)
  {
    return;
  }
  PatternTracker::project(samples, this->view, this->next);
  this->adopt(samples);
  this->next.frames = this->now.frames;
  this->next.frames.resize(this->patches.patchTotal);
  this->next.anchored.assign(this->patches.patchTotal, 0);
  this->now = std::move(this->next);
  this->base = this->now;
}

void PatternTracker::markSeen(const Picture& picture)
{
  for (std::size_t patch = 0; patch < this->patches.patchTotal; ++patch)
  {
    this->seen[patch] = this->seen[patch] != 0 || picture.frontWeights[patch] > 0.0 ? 1 : 0;
  }
}

// Makes the drawn frame the start of the next step, if its own weights are known. Before the first
// visibility is measured they are: facing alone decides. Whether it did.
bool PatternTracker::settle()
{
  const bool measured = !this->now.visibility.empty();
  if (!measured && !this->base.visibility.empty())
  {
    return false;
  }
  std::swap(this->base, this->now);
  if (measured)
  {
    this->base.frames = std::move(this->commitment);
    this->commitment.clear();
  }
  return true;
}

void PatternTracker::predict(bool settled)
{
  this->weigh(this->next, this->base.visibility);
  Step step = this->fitStep(this->base, this->next);
  if (step.weak && !settled)
  {
    // The drawn frame was never measured: give up on its own weights rather than on the surface.
    std::swap(this->base, this->now);
    std::swap(this->base.visibility, this->now.visibility);
    step = this->fitStep(this->base, this->next);
  }
  this->next.frontWeights = frontWeights(this->next.samples, this->patches);
  this->next.frames = this->framesAfter(this->base, this->next, step);
  this->next.anchored = step.cut;
  for (std::size_t patch = 0; patch < this->patches.patchTotal; ++patch)
  {
    if (this->seen[patch] == 0)
    {
      this->next.anchored[patch] = 1;
    }
  }
  this->markSeen(this->next);
  this->measureStep(step);
  std::swap(this->now, this->next);
}

void PatternTracker::measureStep(const Step& step)
{
  const std::vector<PatchResidual> slides =
    measureResiduals(step.patches.fits, { this->base.samples, this->base.weights },
      { this->next.samples, this->next.weights }, this->patches, this->options.scheme);
  for (std::size_t patch = 0; patch < this->patches.patchTotal; ++patch)
  {
    this->stepResidual[patch] = slides[patch].residual;
    this->stepWeight[patch] = slides[patch].weight;
    this->stepStatus[patch] = step.patches.fits[patch].status;
  }
}

std::vector<PatchResidual> PatternTracker::residualOver(
  const TrackedSamples& samples, double minimumFacing) const
{
  if (!(minimumFacing >= -1.0 && minimumFacing <= 1.0))
  {
    throw std::invalid_argument("PatternTracker::residualOver: minimumFacing is " +
      std::to_string(minimumFacing) + ", expected -1 to 1");
  }
  if (!this->started)
  {
    return {};
  }
  if (!this->matches(samples))
  {
    throw std::invalid_argument("PatternTracker::residualOver: samples has " +
      std::to_string(samples.positions.size()) +
      " elements or other patches, expected those of the last advance, " +
      std::to_string(this->now.samples.size()));
  }
  // The drawn step was predicted with the visibility of the frame that it starts from.
  std::vector<double> predicted;
  weighSamples(this->now.samples, this->now.viewportSize, this->base.visibility,
    this->options.scheme, predicted);
  const WeightedFrame current{ this->now.samples, predicted };
  const PatchFits fits = fitPatches(
    { this->base.samples, this->base.weights }, current, this->patches, this->options.scheme);
  std::vector<double> turned = this->base.weights;
  const std::vector<double> facing = sampleFacing(samples, this->view);
  for (std::size_t i = 0; i < facing.size(); ++i)
  {
    turned[i] = facing[i] < minimumFacing ? 0.0 : turned[i];
  }
  return measureResiduals(
    fits.fits, { this->base.samples, turned }, current, this->patches, this->options.scheme);
}

bool PatternTracker::advance(const TrackedSamples& samples, const ViewProjection& newView)
{
  PatternTracker::project(samples, newView, this->next);
  if (!this->matches(samples))
  {
    this->start(samples);
    this->view = newView;
    return true;
  }
  if (newView == this->view && this->next.samples == this->now.samples)
  {
    return false;
  }
  const std::vector<PatternFrame> before = this->now.frames;
  this->predict(this->settle());
  this->view = newView;
  return this->now.frames != before;
}

void PatternTracker::setVisibility(Span<const std::uint8_t> visibility)
{
  if (!this->started || visibility.size() != this->now.samples.size())
  {
    throw std::invalid_argument("PatternTracker::setVisibility: visibility has " +
      std::to_string(visibility.size()) + " elements, expected " +
      std::to_string(this->started ? this->now.samples.size() : 0) +
      ", the samples of the last advance");
  }
  this->now.visibility.assign(visibility.begin(), visibility.end());
  this->weigh(this->now, this->now.visibility);
  this->commitment = this->framesAfter(this->base, this->now, this->fitStep(this->base, this->now));
  for (std::size_t patch = 0; patch < this->patches.patchTotal; ++patch)
  {
    if (this->now.anchored[patch] != 0)
    {
      this->commitment[patch] = this->now.frames[patch];
    }
  }
}

Span<const PatternFrame> PatternTracker::committed() const
{
  return this->commitment.empty() ? this->base.frames : this->commitment;
}

std::vector<PatternFrame> PatternTracker::preview(
  const TrackedSamples& samples, const ViewProjection& otherView) const
{
  PatternTracker copy(*this);
  copy.advance(samples, otherView);
  return copy.now.frames;
}

std::vector<PatternFrame> PatternTracker::previewFromDrawn(
  const TrackedSamples& samples, const ViewProjection& otherView) const
{
  if (!this->matches(samples))
  {
    return this->preview(samples, otherView);
  }
  Picture picture;
  PatternTracker::project(samples, otherView, picture);
  if (otherView == this->view && picture.samples == this->now.samples)
  {
    return this->now.frames;
  }
  this->weigh(picture, this->drawnVisibility());
  picture.frontWeights = frontWeights(picture.samples, this->patches);
  return this->framesAfter(this->now, picture, this->fitStep(this->now, picture));
}

} // namespace hachure

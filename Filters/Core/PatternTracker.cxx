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

constexpr double fullVisibility = 255.0;
// The unweighted scheme counts a sample from half visible on.
constexpr std::uint8_t halfVisible = 128;
// Without a measured visibility for the drawn frame steps start from the last commit, until one of
// them has less than this part of its weight in common with it.
constexpr double weakCommonWeight = 0.5;

bool equalSamples(const std::vector<ProjectedSample>& a, const std::vector<ProjectedSample>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const ProjectedSample& left, const ProjectedSample& right)
    { return left.position == right.position && left.weight == right.weight; });
}

bool isOutside(glm::dvec2 position, glm::dvec2 size)
{
  return position.x < 0.0 || position.y < 0.0 || position.x > size.x || position.y > size.y;
}

std::vector<std::int32_t> patchPerSample(const TrackedSamples& samples)
{
  if (samples.patches.empty())
  {
    return std::vector<std::int32_t>(samples.positions.size(), 0);
  }
  return { samples.patches.begin(), samples.patches.end() };
}

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
  this->options = newOptions;
}

void PatternTracker::reanchor()
{
  this->started = false;
}

bool PatternTracker::matches(const TrackedSamples& samples) const
{
  return this->started && this->patches == patchPerSample(samples) &&
    this->patchTotal == std::max(patchCount(samples), samples.patchSpacing.size());
}

// What each sample weighs in this frame. The visibility of a sample outside the picture cannot be
// measured: there the front sides count, as everywhere as long as no visibility is known.
std::vector<double> PatternTracker::weights(
  const Picture& picture, const std::vector<std::uint8_t>& visibility) const
{
  std::vector<double> result = facingWeights(picture.samples, this->options.scheme);
  const bool unweighted = this->options.scheme == WeightScheme::Unweighted;
  for (std::size_t i = 0; i < visibility.size(); ++i)
  {
    const ProjectedSample& sample = picture.samples[i];
    if (isOutside(sample.position, picture.viewportSize))
    {
      continue;
    }
    if (unweighted)
    {
      result[i] = visibility[i] >= halfVisible && sample.weight != 0.0 ? 1.0 : 0.0;
    }
    else
    {
      result[i] = std::abs(sample.weight) * visibility[i] / fullVisibility;
    }
  }
  return result;
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

PatternTracker::Step PatternTracker::fitStep(const Picture& previous,
  const std::vector<std::uint8_t>& previousVisibility, const Picture& current,
  const std::vector<std::uint8_t>& currentVisibility) const
{
  const std::vector<double> previousWeights = this->weights(previous, previousVisibility);
  const std::vector<double> currentWeights = this->weights(current, currentVisibility);
  Step step;
  step.patches = fitPatches({ previous.samples, previousWeights },
    { current.samples, currentWeights }, this->patches, this->patchTotal, this->options.scheme);
  const double diagonal =
    std::max(glm::length(previous.viewportSize), glm::length(current.viewportSize));
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
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
  const PatternAnchors anchors = anchorPatterns(current.samples, this->patches, this->patchTotal);
  std::vector<PatternFrame> frames = anchors.frames;
  const auto continues = [&](std::size_t patch)
  { return step.cut[patch] == 0 && this->seen[patch] != 0; };
  std::size_t widest = this->patchTotal;
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    if (continues(patch))
    {
      frames[patch] = this->follow(previous.frames[patch], step.patches.fits[patch]);
      const bool wider =
        widest == this->patchTotal || anchors.frontWeights[patch] > anchors.frontWeights[widest];
      widest = wider ? patch : widest;
    }
  }
  for (std::size_t patch = 0; patch < this->patchTotal && widest < this->patchTotal; ++patch)
  {
    frames[patch] = continues(patch) ? frames[patch] : frames[widest];
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

void PatternTracker::start(const TrackedSamples& samples, Picture picture)
{
  this->patches = patchPerSample(samples);
  this->patchTotal = std::max(patchCount(samples), samples.patchSpacing.size());
  PatternAnchors anchors = anchorPatterns(picture.samples, this->patches, this->patchTotal);
  picture.frames = std::move(anchors.frames);
  picture.anchored.assign(this->patchTotal, 1);
  this->seen.assign(this->patchTotal, 0);
  this->markSeen(anchors.frontWeights);
  this->stepResidual.assign(this->patchTotal, 0.0);
  this->stepWeight.assign(this->patchTotal, 0.0);
  this->stepStatus.assign(this->patchTotal, FitStatus::NoSamples);
  this->commitment.clear();
  this->now = std::move(picture);
  this->base = this->now;
  this->started = true;
}

void PatternTracker::replaceSamples(const TrackedSamples& samples)
{
  if (!this->started)
  {
    return;
  }
  Picture picture;
  picture.samples = projectSamples(samples, this->view, FacingRule::Signed);
  picture.viewportSize = this->now.viewportSize;
  picture.frames = this->now.frames;
  this->patches = patchPerSample(samples);
  this->patchTotal = std::max(patchCount(samples), samples.patchSpacing.size());
  picture.frames.resize(this->patchTotal);
  picture.anchored.assign(this->patchTotal, 0);
  this->seen.resize(this->patchTotal, 0); // patches that are new anchor when they are seen
  this->stepResidual.resize(this->patchTotal, 0.0);
  this->stepWeight.resize(this->patchTotal, 0.0);
  this->stepStatus.resize(this->patchTotal, FitStatus::NoSamples);
  this->commitment.clear();
  this->now = std::move(picture);
  this->base = this->now;
}

void PatternTracker::markSeen(const std::vector<double>& frontWeights)
{
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    this->seen[patch] = this->seen[patch] != 0 || frontWeights[patch] > 0.0 ? 1 : 0;
  }
}

// Makes the drawn frame the start of the next step, if its own weights are known. Before the first
// visibility is measured they are: facing alone decides.
void PatternTracker::settle()
{
  if (!this->now.visibility.empty())
  {
    this->base = std::move(this->now);
    this->base.frames = std::move(this->commitment);
    this->commitment.clear();
  }
  else if (this->base.visibility.empty())
  {
    this->base = std::move(this->now);
  }
}

void PatternTracker::predict(Picture picture)
{
  const std::vector<std::uint8_t> known = this->base.visibility;
  Step step = this->fitStep(this->base, known, picture, known);
  if (step.weak && !this->now.samples.empty())
  {
    // The drawn frame was never measured: give up on its own weights rather than on the surface.
    this->base = std::move(this->now);
    this->base.visibility = known;
    step = this->fitStep(this->base, known, picture, known);
  }
  const PatternAnchors anchors = anchorPatterns(picture.samples, this->patches, this->patchTotal);
  picture.frames = this->framesAfter(this->base, picture, step);
  picture.anchored = step.cut;
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    if (this->seen[patch] == 0)
    {
      picture.anchored[patch] = 1;
    }
  }
  this->markSeen(anchors.frontWeights);
  this->measureStep(picture, step);
  this->now = std::move(picture);
}

void PatternTracker::measureStep(const Picture& picture, Step& step)
{
  measureResiduals(
    step.patches, { this->base.samples, {} }, { picture.samples, {} }, this->patches);
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    this->stepResidual[patch] = step.patches.fits[patch].residual;
    this->stepWeight[patch] = step.patches.fits[patch].weight;
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
  const std::vector<std::uint8_t>& known = this->base.visibility;
  PatchFits fits = this->fitStep(this->base, known, this->now, known).patches;
  for (SimilarityFit& fit : fits.fits)
  {
    fit.weight = 0.0;
  }
  const std::vector<double> facing = sampleFacing(samples, this->view);
  for (std::size_t i = 0; i < facing.size(); ++i)
  {
    fits.weights[i] = facing[i] < minimumFacing ? 0.0 : fits.weights[i];
    fits.fits[static_cast<std::size_t>(this->patches[i])].weight += fits.weights[i];
  }
  measureResiduals(fits, { this->base.samples, {} }, { this->now.samples, {} }, this->patches);
  std::vector<PatchResidual> result;
  for (const SimilarityFit& fit : fits.fits)
  {
    result.push_back({ fit.residual, fit.weight });
  }
  return result;
}

bool PatternTracker::advance(const TrackedSamples& samples, const ViewProjection& newView)
{
  Picture picture;
  picture.samples = projectSamples(samples, newView, FacingRule::Signed);
  picture.viewportSize = newView.viewportSize;
  if (!this->matches(samples))
  {
    this->start(samples, std::move(picture));
    this->view = newView;
    return true;
  }
  if (newView == this->view && equalSamples(picture.samples, this->now.samples))
  {
    return false;
  }
  const std::vector<PatternFrame> before = this->now.frames;
  this->settle();
  this->predict(std::move(picture));
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
  const Step step =
    this->fitStep(this->base, this->base.visibility, this->now, this->now.visibility);
  this->commitment = this->framesAfter(this->base, this->now, step);
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
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
  picture.samples = projectSamples(samples, otherView, FacingRule::Signed);
  picture.viewportSize = otherView.viewportSize;
  if (otherView == this->view && equalSamples(picture.samples, this->now.samples))
  {
    return this->now.frames;
  }
  const std::vector<std::uint8_t>& known =
    this->now.visibility.empty() ? this->base.visibility : this->now.visibility;
  return this->framesAfter(this->now, picture, this->fitStep(this->now, known, picture, known));
}

} // namespace hachure

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

double commonWeight(WeightScheme scheme, double previous, double current)
{
  switch (scheme)
  {
    case WeightScheme::Symmetric:
      return std::sqrt(previous * current);
    case WeightScheme::Classic:
      return previous > 0.0 ? current : 0.0;
    case WeightScheme::Unweighted:
      break;
  }
  return previous * current; // each is 0 or 1
}

std::vector<std::int32_t> patchPerSample(const TrackedSamples& samples)
{
  if (samples.patches.empty())
  {
    return std::vector<std::int32_t>(samples.positions.size(), 0);
  }
  return { samples.patches.begin(), samples.patches.end() };
}

// Upright frames of scale 1 at the weighted centroids of the patches' front sides, or of the whole
// patches where no front is in sight. `weight` receives the weight of the front sides.
std::vector<PatternFrame> anchorFrames(const std::vector<ProjectedSample>& samples,
  const std::vector<std::int32_t>& patches, std::size_t patchTotal, std::vector<double>& weight)
{
  std::vector<PatternFrame> frames(patchTotal);
  std::vector<glm::dvec2> front(patchTotal, glm::dvec2(0.0));
  std::vector<glm::dvec2> both(patchTotal, glm::dvec2(0.0));
  std::vector<double> weightOfBoth(patchTotal, 0.0);
  weight.assign(patchTotal, 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const auto patch = static_cast<std::size_t>(patches[i]);
    const double area = std::abs(samples[i].weight);
    both[patch] += area * samples[i].position;
    weightOfBoth[patch] += area;
    if (samples[i].weight > 0.0)
    {
      front[patch] += area * samples[i].position;
      weight[patch] += area;
    }
  }
  for (std::size_t patch = 0; patch < patchTotal; ++patch)
  {
    if (weight[patch] > 0.0)
    {
      frames[patch].origin = front[patch] / weight[patch];
    }
    else if (weightOfBoth[patch] > 0.0)
    {
      frames[patch].origin = both[patch] / weightOfBoth[patch];
    }
  }
  return frames;
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
  const bool unweighted = this->options.scheme == WeightScheme::Unweighted;
  std::vector<double> result(picture.samples.size());
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const ProjectedSample& sample = picture.samples[i];
    if (visibility.empty() || isOutside(sample.position, picture.viewportSize))
    {
      result[i] = std::max(0.0, sample.weight);
    }
    else if (unweighted)
    {
      result[i] = visibility[i] >= halfVisible ? std::abs(sample.weight) : 0.0;
    }
    else
    {
      result[i] = std::abs(sample.weight) * visibility[i] / fullVisibility;
    }
    if (unweighted && result[i] > 0.0)
    {
      result[i] = 1.0;
    }
  }
  return result;
}

PatternTracker::Step PatternTracker::fitStep(const Picture& previous,
  const std::vector<double>& previousWeights, const Picture& current,
  const std::vector<double>& currentWeights) const
{
  std::vector<SimilarityMoments> moments(this->patchTotal);
  std::vector<glm::dvec2> totals(this->patchTotal, glm::dvec2(0.0));
  Step step;
  step.weights.resize(currentWeights.size());
  for (std::size_t i = 0; i < currentWeights.size(); ++i)
  {
    const double w = commonWeight(this->options.scheme, previousWeights[i], currentWeights[i]);
    const auto patch = static_cast<std::size_t>(this->patches[i]);
    step.weights[i] = w;
    totals[patch] += glm::dvec2(previousWeights[i], currentWeights[i]);
    if (w > 0.0)
    {
      SimilarityMoments& sum = moments[patch];
      if (sum.weight == 0.0)
      {
        sum.previousOrigin = previous.samples[i].position;
        sum.currentOrigin = current.samples[i].position;
      }
      sum.add(w, previous.samples[i].position, current.samples[i].position);
    }
  }
  const double diagonal =
    std::max(glm::length(previous.viewportSize), glm::length(current.viewportSize));
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    const SimilarityFit fit = fitSimilarity(moments[patch]);
    // A patch hidden in one of the frames waits; one seen in both frames must have common samples.
    const double smaller = std::min(totals[patch].x, totals[patch].y);
    const bool cut = smaller > 0.0 &&
      (fit.weight < this->options.minimumCommonWeight * smaller ||
        fit.correlation < this->options.minimumCorrelation ||
        glm::length(fit.transform.to - fit.transform.from) >
          this->options.maximumDisplacement * diagonal);
    step.weak = step.weak || cut || fit.weight < weakCommonWeight * smaller;
    step.cut.push_back(cut ? 1 : 0);
    step.fits.push_back(fit);
  }
  return step;
}

PatternFrame PatternTracker::follow(const PatternFrame& frame, const SimilarityFit& fit) const
{
  if (fit.status == FitStatus::NoSamples)
  {
    return frame;
  }
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
  std::vector<double> weight;
  picture.frames = anchorFrames(picture.samples, this->patches, this->patchTotal, weight);
  picture.anchored.assign(this->patchTotal, 1);
  this->seen.assign(this->patchTotal, 0);
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    this->seen[patch] = weight[patch] > 0.0 ? 1 : 0;
  }
  this->stepResidual.assign(this->patchTotal, 0.0);
  this->stepStatus.assign(this->patchTotal, FitStatus::NoSamples);
  this->commitment.clear();
  this->now = std::move(picture);
  this->base = this->now;
  this->started = true;
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

PatternTracker::Step PatternTracker::predictStep(const Picture& picture) const
{
  const std::vector<std::uint8_t>& known = this->base.visibility;
  return this->fitStep(
    this->base, this->weights(this->base, known), picture, this->weights(picture, known));
}

void PatternTracker::predict(Picture picture)
{
  Step step = this->predictStep(picture);
  if (step.weak && !this->now.samples.empty())
  {
    // The drawn frame was never measured: give up on its own weights rather than on the surface.
    std::vector<std::uint8_t> known = std::move(this->base.visibility);
    this->base = std::move(this->now);
    this->base.visibility = std::move(known);
    step = this->predictStep(picture);
  }
  std::vector<double> weight;
  picture.frames = anchorFrames(picture.samples, this->patches, this->patchTotal, weight);
  picture.anchored.assign(this->patchTotal, 1);
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    if (this->seen[patch] != 0 && step.cut[patch] == 0)
    {
      picture.frames[patch] = this->follow(this->base.frames[patch], step.fits[patch]);
      picture.anchored[patch] = 0;
    }
    if (weight[patch] > 0.0)
    {
      this->seen[patch] = 1;
    }
  }
  this->measureResidual(picture, step);
  this->now = std::move(picture);
}

void PatternTracker::measureResidual(const Picture& picture, const Step& step)
{
  this->stepResidual.assign(this->patchTotal, 0.0);
  this->stepStatus.resize(this->patchTotal);
  for (std::size_t i = 0; i < step.weights.size(); ++i)
  {
    const auto patch = static_cast<std::size_t>(this->patches[i]);
    if (step.weights[i] > 0.0)
    {
      this->stepResidual[patch] += step.weights[i] / step.fits[patch].weight *
        residualLength(
          step.fits[patch].transform, this->base.samples[i].position, picture.samples[i].position);
    }
  }
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    this->stepStatus[patch] = step.fits[patch].status;
  }
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
  this->commitment = this->now.frames;
  const Step step = this->fitStep(this->base, this->weights(this->base, this->base.visibility),
    this->now, this->weights(this->now, this->now.visibility));
  std::vector<double> weight;
  const std::vector<PatternFrame> anchors =
    anchorFrames(this->now.samples, this->patches, this->patchTotal, weight);
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    if (this->now.anchored[patch] == 0)
    {
      this->commitment[patch] = step.cut[patch] != 0
        ? anchors[patch]
        : this->follow(this->base.frames[patch], step.fits[patch]);
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
  const std::vector<std::uint8_t>& known =
    this->now.visibility.empty() ? this->base.visibility : this->now.visibility;
  const Step step = this->fitStep(
    this->now, this->weights(this->now, known), picture, this->weights(picture, known));
  std::vector<double> weight;
  std::vector<PatternFrame> frames =
    anchorFrames(picture.samples, this->patches, this->patchTotal, weight);
  for (std::size_t patch = 0; patch < this->patchTotal; ++patch)
  {
    if (step.cut[patch] == 0)
    {
      frames[patch] = this->follow(this->now.frames[patch], step.fits[patch]);
    }
  }
  return frames;
}

} // namespace hachure

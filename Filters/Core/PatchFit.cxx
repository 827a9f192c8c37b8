// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchFit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

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

void checkArrays(const WeightedFrame& previous, const WeightedFrame& current,
  Span<const std::int32_t> patches, std::size_t patchTotal)
{
  const std::size_t count = patches.size();
  for (const WeightedFrame* frame : { &previous, &current })
  {
    if (frame->samples.size() != count || frame->weights.size() != count)
    {
      throw std::invalid_argument("fitPatches: a frame has " +
        std::to_string(frame->samples.size()) + " samples and " +
        std::to_string(frame->weights.size()) + " weights, expected " + std::to_string(count) +
        " as in patches");
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (patches[i] < 0 || static_cast<std::size_t>(patches[i]) >= patchTotal)
    {
      throw std::invalid_argument("fitPatches: patches[" + std::to_string(i) + "] is " +
        std::to_string(patches[i]) + ", expected 0 to " + std::to_string(patchTotal) + " - 1");
    }
  }
}

// Calls body(patch, begin, end) for every range of successive samples of one patch: sums stay in
// registers over a range.
template <class Body>
void forEachRun(Span<const std::int32_t> patches, Body&& body)
{
  for (std::size_t begin = 0; begin < patches.size();)
  {
    std::size_t end = begin + 1;
    while (end < patches.size() && patches[end] == patches[begin])
    {
      ++end;
    }
    body(static_cast<std::size_t>(patches[begin]), begin, end);
    begin = end;
  }
}

void joinWeights(Span<const double> previous, Span<const double> current, WeightScheme scheme,
  std::size_t begin, std::size_t end, PatchFits& result, std::size_t patch)
{
  double previousSum = result.previousWeights[patch];
  double currentSum = result.currentWeights[patch];
  for (std::size_t i = begin; i < end; ++i)
  {
    result.weights[i] = commonWeight(scheme, previous[i], current[i]);
    previousSum += previous[i];
    currentSum += current[i];
  }
  result.previousWeights[patch] = previousSum;
  result.currentWeights[patch] = currentSum;
}

// Samples of weight 0 add exact zeros, which is faster than a branch that no one can foretell.
void addRun(SimilarityMoments& moments, Span<const ProjectedSample> previous,
  Span<const ProjectedSample> current, const std::vector<double>& weights, std::size_t begin,
  std::size_t end)
{
  if (moments.weight == 0.0)
  {
    while (begin < end && !(weights[begin] > 0.0))
    {
      ++begin;
    }
    if (begin == end)
    {
      return;
    }
    moments.previousOrigin = previous[begin].position;
    moments.currentOrigin = current[begin].position;
  }
  SimilarityMoments sum = moments;
  for (std::size_t i = begin; i < end; ++i)
  {
    sum.add(weights[i], previous[i].position, current[i].position);
  }
  moments = sum;
}

} // namespace

PatchFits fitPatches(const WeightedFrame& previous, const WeightedFrame& current,
  Span<const std::int32_t> patches, std::size_t patchTotal, WeightScheme scheme)
{
  checkArrays(previous, current, patches, patchTotal);
  PatchFits result;
  result.weights.resize(patches.size());
  result.previousWeights.assign(patchTotal, 0.0);
  result.currentWeights.assign(patchTotal, 0.0);
  std::vector<SimilarityMoments> moments(patchTotal);
  forEachRun(patches,
    [&](std::size_t patch, std::size_t begin, std::size_t end)
    {
      joinWeights(previous.weights, current.weights, scheme, begin, end, result, patch);
      addRun(moments[patch], previous.samples, current.samples, result.weights, begin, end);
    });
  for (const SimilarityMoments& sum : moments)
  {
    result.fits.push_back(fitSimilarity(sum));
  }
  return result;
}

void measureResiduals(PatchFits& fits, const WeightedFrame& previous, const WeightedFrame& current,
  Span<const std::int32_t> patches)
{
  for (SimilarityFit& fit : fits.fits)
  {
    fit.residual = 0.0;
  }
  forEachRun(patches,
    [&](std::size_t patch, std::size_t begin, std::size_t end)
    {
      SimilarityFit& fit = fits.fits[patch];
      const Similarity transform = fit.transform;
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i)
      {
        sum += fits.weights[i] *
          residualLength(transform, previous.samples[i].position, current.samples[i].position);
      }
      fit.residual += fit.weight > 0.0 ? sum / fit.weight : 0.0;
    });
}

std::vector<double> facingWeights(Span<const ProjectedSample> samples, WeightScheme scheme)
{
  std::vector<double> weights;
  weights.reserve(samples.size());
  for (const ProjectedSample& sample : samples)
  {
    const double front = std::max(0.0, sample.weight);
    weights.push_back(scheme == WeightScheme::Unweighted && front > 0.0 ? 1.0 : front);
  }
  return weights;
}

PatternAnchors anchorPatterns(
  Span<const ProjectedSample> samples, Span<const std::int32_t> patches, std::size_t patchTotal)
{
  PatternAnchors anchors;
  anchors.frontWeights.assign(patchTotal, 0.0);
  double bothWeight = 0.0;
  double frontWeight = 0.0;
  glm::dvec2 front(0.0);
  glm::dvec2 both(0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double area = std::abs(samples[i].weight);
    both += area * samples[i].position;
    bothWeight += area;
    if (samples[i].weight > 0.0)
    {
      front += area * samples[i].position;
      frontWeight += area;
      anchors.frontWeights[static_cast<std::size_t>(patches[i])] += area;
    }
  }
  PatternFrame frame;
  if (frontWeight > 0.0)
  {
    frame.origin = front / frontWeight;
  }
  else if (bothWeight > 0.0)
  {
    frame.origin = both / bothWeight;
  }
  anchors.frames.assign(patchTotal, frame);
  return anchors;
}

} // namespace hachure

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

// Sums run in four lanes, whatever the processor: the same bytes everywhere, and no sum waits for
// the one before.
constexpr std::size_t lanes = 4;
#if defined(__GNUC__)
typedef double Lanes __attribute__((vector_size(lanes * sizeof(double))));
#else
struct Lanes
{
  double values[lanes];
  double operator[](std::size_t lane) const { return this->values[lane]; }
};
inline Lanes operator+(const Lanes& a, const Lanes& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] } };
}
inline Lanes operator-(const Lanes& a, const Lanes& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] } };
}
inline Lanes operator*(const Lanes& a, const Lanes& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
#endif

// Compiled for wider registers too, chosen when the program starts. Without fused multiplication
// and addition: its rounding differs.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define HACHURE_WIDE_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define HACHURE_WIDE_CLONES
#endif

struct LaneSums
{
  Lanes weight = {}, xBefore = {}, yBefore = {}, xAfter = {}, yAfter = {};
  Lanes dot = {}, cross = {}, previousSquared = {}, currentSquared = {};
  Lanes previousWeight = {}, currentWeight = {};
};

// Successive samples of one patch. Their common weights are written.
struct SampleRange
{
  const ProjectedSample* previous;
  const ProjectedSample* current;
  const double* previousWeights;
  const double* currentWeights;
  double* common;
  std::size_t count;
};

double total(const Lanes& sums)
{
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

void checkArrays(
  const WeightedFrame& previous, const WeightedFrame& current, Span<const std::int32_t> patches)
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
}

void checkPatch(Span<const std::int32_t> patches, std::size_t i, std::size_t patchTotal)
{
  if (patches[i] < 0 || static_cast<std::size_t>(patches[i]) >= patchTotal)
  {
    throw std::invalid_argument("fitPatches: patches[" + std::to_string(i) + "] is " +
      std::to_string(patches[i]) + ", expected 0 to " + std::to_string(patchTotal) + " - 1");
  }
}

// The end of the successive samples of one patch that begin at `begin`.
std::size_t endOfRun(Span<const std::int32_t> patches, std::size_t begin)
{
  constexpr std::size_t stride = 32; // samples that are compared at once
  const std::int32_t patch = patches[begin];
  std::size_t end = begin + 1;
  while (end + stride <= patches.size())
  {
    std::int32_t different = 0;
    for (std::size_t i = 0; i < stride; ++i)
    {
      different |= patches.data()[end + i] ^ patch;
    }
    if (different != 0)
    {
      break;
    }
    end += stride;
  }
  while (end < patches.size() && patches[end] == patch)
  {
    ++end;
  }
  return end;
}

// Calls body(patch, begin, end) for every range of successive samples of one patch: sums stay in
// registers over a range.
template <class Body>
void forEachRun(Span<const std::int32_t> patches, Body&& body)
{
  for (std::size_t begin = 0; begin < patches.size();)
  {
    const std::size_t end = endOfRun(patches, begin);
    body(static_cast<std::size_t>(patches[begin]), begin, end);
    begin = end;
  }
}

HACHURE_WIDE_CLONES
void joinWeights(const SampleRange& range, WeightScheme scheme)
{
  const double* previous = range.previousWeights;
  const double* current = range.currentWeights;
  double* common = range.common;
  const std::size_t count = range.count;
  switch (scheme)
  {
    case WeightScheme::Symmetric:
      for (std::size_t i = 0; i < count; ++i)
      {
        common[i] = std::sqrt(previous[i] * current[i]);
      }
      break;
    case WeightScheme::Classic:
      for (std::size_t i = 0; i < count; ++i)
      {
        common[i] = previous[i] > 0.0 ? current[i] : 0.0;
      }
      break;
    case WeightScheme::Unweighted:
      for (std::size_t i = 0; i < count; ++i)
      {
        common[i] = previous[i] * current[i]; // each is 0 or 1
      }
      break;
  }
}

// Samples of weight 0 add exact zeros, which is faster than a branch that no one can foretell. The
// number of samples is a multiple of `lanes`.
HACHURE_WIDE_CLONES
void addSums(const SampleRange& range, const SimilarityMoments& moments, LaneSums& result)
{
  const glm::dvec2 p = moments.previousOrigin;
  const glm::dvec2 c = moments.currentOrigin;
  const Lanes originPx = { p.x, p.x, p.x, p.x };
  const Lanes originPy = { p.y, p.y, p.y, p.y };
  const Lanes originCx = { c.x, c.x, c.x, c.x };
  const Lanes originCy = { c.y, c.y, c.y, c.y };
  LaneSums sum = result;
  for (std::size_t i = 0; i < range.count; i += lanes)
  {
    const ProjectedSample* a = range.previous + i;
    const ProjectedSample* b = range.current + i;
    const double* wp = range.previousWeights + i;
    const double* wc = range.currentWeights + i;
    const double* wj = range.common + i;
    const Lanes px =
      Lanes{ a[0].position.x, a[1].position.x, a[2].position.x, a[3].position.x } - originPx;
    const Lanes py =
      Lanes{ a[0].position.y, a[1].position.y, a[2].position.y, a[3].position.y } - originPy;
    const Lanes cx =
      Lanes{ b[0].position.x, b[1].position.x, b[2].position.x, b[3].position.x } - originCx;
    const Lanes cy =
      Lanes{ b[0].position.y, b[1].position.y, b[2].position.y, b[3].position.y } - originCy;
    const Lanes w = { wj[0], wj[1], wj[2], wj[3] };
    const Lanes wpx = w * px;
    const Lanes wpy = w * py;
    const Lanes wcx = w * cx;
    const Lanes wcy = w * cy;
    sum.weight = sum.weight + w;
    sum.xBefore = sum.xBefore + wpx;
    sum.yBefore = sum.yBefore + wpy;
    sum.xAfter = sum.xAfter + wcx;
    sum.yAfter = sum.yAfter + wcy;
    sum.dot = sum.dot + (wpx * cx + wpy * cy);
    sum.cross = sum.cross + (wpx * cy - wpy * cx);
    sum.previousSquared = sum.previousSquared + (wpx * px + wpy * py);
    sum.currentSquared = sum.currentSquared + (wcx * cx + wcy * cy);
    sum.previousWeight = sum.previousWeight + Lanes{ wp[0], wp[1], wp[2], wp[3] };
    sum.currentWeight = sum.currentWeight + Lanes{ wc[0], wc[1], wc[2], wc[3] };
  }
  result = sum;
}

// The samples behind the last full set of lanes, with weights of 0 in the lanes that stay empty.
void addRemainder(const SampleRange& range, const SimilarityMoments& moments, LaneSums& result)
{
  const std::size_t rest = range.count % lanes;
  if (rest == 0)
  {
    return;
  }
  const std::size_t start = range.count - rest;
  ProjectedSample previous[lanes], current[lanes];
  double previousWeights[lanes] = {}, currentWeights[lanes] = {}, common[lanes] = {};
  std::copy_n(range.previous + start, rest, previous);
  std::copy_n(range.current + start, rest, current);
  std::copy_n(range.previousWeights + start, rest, previousWeights);
  std::copy_n(range.currentWeights + start, rest, currentWeights);
  std::copy_n(range.common + start, rest, common);
  addSums({ previous, current, previousWeights, currentWeights, common, lanes }, moments, result);
}

SimilarityMoments momentsOf(const LaneSums& sums)
{
  SimilarityMoments moments;
  moments.weight = total(sums.weight);
  moments.previous = { total(sums.xBefore), total(sums.yBefore) };
  moments.current = { total(sums.xAfter), total(sums.yAfter) };
  moments.dot = total(sums.dot);
  moments.cross = total(sums.cross);
  moments.previousSquared = total(sums.previousSquared);
  moments.currentSquared = total(sums.currentSquared);
  return moments;
}

// Origins near the points: the first sample of a patch that counts.
void placeOrigins(const SampleRange& range, SimilarityMoments& moments)
{
  std::size_t first = 0;
  while (first < range.count && !(range.common[first] > 0.0))
  {
    ++first;
  }
  if (first < range.count)
  {
    moments.previousOrigin = range.previous[first].position;
    moments.currentOrigin = range.current[first].position;
  }
}

// Adds successive samples of one patch to its moments.
void addRun(SampleRange range, WeightScheme scheme, PatchFits& result, std::size_t patch,
  SimilarityMoments& moments)
{
  joinWeights(range, scheme);
  if (moments.weight == 0.0)
  {
    placeOrigins(range, moments);
  }
  LaneSums sums;
  addRemainder(range, moments, sums);
  range.count -= range.count % lanes;
  addSums(range, moments, sums);
  result.previousWeights[patch] += total(sums.previousWeight);
  result.currentWeights[patch] += total(sums.currentWeight);
  SimilarityMoments added = momentsOf(sums);
  added.previousOrigin = moments.previousOrigin;
  added.currentOrigin = moments.currentOrigin;
  moments += added;
}

} // namespace

PatchFits fitPatches(const WeightedFrame& previous, const WeightedFrame& current,
  Span<const std::int32_t> patches, std::size_t patchTotal, WeightScheme scheme)
{
  checkArrays(previous, current, patches);
  PatchFits result;
  result.weights.resize(patches.size());
  result.previousWeights.assign(patchTotal, 0.0);
  result.currentWeights.assign(patchTotal, 0.0);
  std::vector<SimilarityMoments> moments(patchTotal);
  forEachRun(patches,
    [&](std::size_t patch, std::size_t begin, std::size_t end)
    {
      checkPatch(patches, begin, patchTotal);
      const SampleRange range = { &previous.samples[begin], &current.samples[begin],
        &previous.weights[begin], &current.weights[begin], &result.weights[begin], end - begin };
      addRun(range, scheme, result, patch, moments[patch]);
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

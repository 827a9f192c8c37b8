// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchFit.h"

#include "Lanes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

struct LaneSums
{
  Lanes weight = {}, xBefore = {}, yBefore = {}, xAfter = {}, yAfter = {};
  Lanes dot = {}, cross = {}, previousSquared = {}, currentSquared = {};
};

struct LaneResiduals
{
  Lanes weight = {}, slide = {};
};

// Successive samples of one frame.
struct FrameRange
{
  const double* x;
  const double* y;
  const double* weights;
};

// Successive samples of one patch in both frames.
struct SampleRange
{
  FrameRange previous;
  FrameRange current;
  std::size_t count;
};

void checkArrays(
  const WeightedFrame& previous, const WeightedFrame& current, const PatchRuns& patches)
{
  const std::size_t count = patches.sampleTotal();
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

FrameRange rangeFrom(const WeightedFrame& frame, std::size_t begin)
{
  return { &frame.samples.x[begin], &frame.samples.y[begin], &frame.weights[begin] };
}

// The weights that are common to both frames.
inline void join(const double* previous, const double* current, WeightScheme scheme, Lanes& common)
{
  Lanes before;
  load(previous, before);
  load(current, common);
  if (scheme == WeightScheme::Classic)
  {
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      common[lane] = before[lane] > 0.0 ? common[lane] : 0.0;
    }
    return;
  }
  common = common * before;
  if (scheme == WeightScheme::Symmetric) // unweighted, each is 0 or 1
  {
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      common[lane] = std::sqrt(common[lane]);
    }
  }
}

// Samples of weight 0 add exact zeros, which is faster than a branch that no one can foretell. The
// number of samples is a multiple of `lanes`.
HACHURE_WIDE_CLONES
void addSums(
  const SampleRange& range, const SimilarityMoments& moments, WeightScheme scheme, LaneSums& result)
{
  Lanes originPx, originPy, originCx, originCy;
  fill(moments.previousOrigin.x, originPx);
  fill(moments.previousOrigin.y, originPy);
  fill(moments.currentOrigin.x, originCx);
  fill(moments.currentOrigin.y, originCy);
  LaneSums sum = result;
  for (std::size_t i = 0; i < range.count; i += lanes)
  {
    Lanes w, px, py, cx, cy;
    join(range.previous.weights + i, range.current.weights + i, scheme, w);
    load(range.previous.x + i, px);
    load(range.previous.y + i, py);
    load(range.current.x + i, cx);
    load(range.current.y + i, cy);
    px = px - originPx;
    py = py - originPy;
    cx = cx - originCx;
    cy = cy - originCy;
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
  }
  result = sum;
}

// As residualLength does, of many samples. Their number is a multiple of `lanes`.
HACHURE_WIDE_CLONES
void addResiduals(
  const SampleRange& range, const Similarity& transform, WeightScheme scheme, LaneResiduals& result)
{
  Lanes zx, zy, fromX, fromY, toX, toY;
  fill(transform.z.x, zx);
  fill(transform.z.y, zy);
  fill(transform.from.x, fromX);
  fill(transform.from.y, fromY);
  fill(transform.to.x, toX);
  fill(transform.to.y, toY);
  LaneResiduals sum = result;
  for (std::size_t i = 0; i < range.count; i += lanes)
  {
    Lanes w, px, py, cx, cy;
    join(range.previous.weights + i, range.current.weights + i, scheme, w);
    load(range.previous.x + i, px);
    load(range.previous.y + i, py);
    load(range.current.x + i, cx);
    load(range.current.y + i, cy);
    px = px - fromX;
    py = py - fromY;
    const Lanes dx = toX + (zx * px - zy * py) - cx;
    const Lanes dy = toY + (zx * py + zy * px) - cy;
    Lanes length = dx * dx + dy * dy;
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      length[lane] = std::sqrt(length[lane]);
    }
    sum.weight = sum.weight + w;
    sum.slide = sum.slide + w * length;
  }
  result = sum;
}

// The samples behind the last full set of lanes, with weights of 0 in the lanes that stay empty.
struct Remainder
{
  double x[lanes] = {};
  double y[lanes] = {};
  double weights[lanes] = {};

  Remainder(const FrameRange& frame, std::size_t begin, std::size_t count)
  {
    std::copy_n(frame.x + begin, count, this->x);
    std::copy_n(frame.y + begin, count, this->y);
    std::copy_n(frame.weights + begin, count, this->weights);
  }
  FrameRange range() const { return { this->x, this->y, this->weights }; }
};

// Calls add(range) for ranges of whole lanes.
template <class Add>
void addInLanes(const SampleRange& range, Add&& add)
{
  const std::size_t rest = range.count % lanes;
  const std::size_t whole = range.count - rest;
  if (rest > 0)
  {
    const Remainder previous(range.previous, whole, rest);
    const Remainder current(range.current, whole, rest);
    add(SampleRange{ previous.range(), current.range(), lanes });
  }
  add(SampleRange{ range.previous, range.current, whole });
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
  const FrameRange& p = range.previous;
  const FrameRange& c = range.current;
  std::size_t first = 0;
  while (first < range.count && !(p.weights[first] > 0.0 && c.weights[first] > 0.0))
  {
    ++first;
  }
  if (first < range.count)
  {
    moments.previousOrigin = { p.x[first], p.y[first] };
    moments.currentOrigin = { c.x[first], c.y[first] };
  }
}

// Adds successive samples of one patch to its moments.
void addRun(const SampleRange& range, WeightScheme scheme, SimilarityMoments& moments)
{
  if (moments.weight == 0.0)
  {
    placeOrigins(range, moments);
  }
  LaneSums sums;
  addInLanes(range, [&](const SampleRange& part) { addSums(part, moments, scheme, sums); });
  SimilarityMoments added = momentsOf(sums);
  added.previousOrigin = moments.previousOrigin;
  added.currentOrigin = moments.currentOrigin;
  moments += added;
}

} // namespace

PatchFits fitPatches(const WeightedFrame& previous, const WeightedFrame& current,
  const PatchRuns& patches, WeightScheme scheme)
{
  checkArrays(previous, current, patches);
  PatchFits result;
  result.previousWeights.assign(patches.patchTotal, 0.0);
  result.currentWeights.assign(patches.patchTotal, 0.0);
  std::vector<SimilarityMoments> moments(patches.patchTotal);
  for (const PatchRun& run : patches.runs)
  {
    const std::size_t count = run.end - run.begin;
    const SampleRange range = { rangeFrom(previous, run.begin), rangeFrom(current, run.begin),
      count };
    const double before = positiveSum({ range.previous.weights, count });
    const double after = positiveSum({ range.current.weights, count });
    result.previousWeights[run.patch] += before;
    result.currentWeights[run.patch] += after;
    if (before > 0.0 && after > 0.0) // else nothing is common to both
    {
      addRun(range, scheme, moments[run.patch]);
    }
  }
  for (const SimilarityMoments& sum : moments)
  {
    result.fits.push_back(fitSimilarity(sum));
  }
  return result;
}

std::vector<PatchResidual> measureResiduals(Span<const SimilarityFit> fits,
  const WeightedFrame& previous, const WeightedFrame& current, const PatchRuns& patches,
  WeightScheme scheme)
{
  checkArrays(previous, current, patches);
  std::vector<PatchResidual> result(patches.patchTotal);
  for (const PatchRun& run : patches.runs)
  {
    const SimilarityFit& fit = fits[run.patch];
    if (fit.weight > 0.0)
    {
      LaneResiduals sums;
      addInLanes(
        { rangeFrom(previous, run.begin), rangeFrom(current, run.begin), run.end - run.begin },
        [&](const SampleRange& part) { addResiduals(part, fit.transform, scheme, sums); });
      result[run.patch].weight += total(sums.weight);
      result[run.patch].residual += total(sums.slide);
    }
  }
  for (PatchResidual& each : result)
  {
    each.residual = each.weight > 0.0 ? each.residual / each.weight : 0.0;
  }
  return result;
}

} // namespace hachure

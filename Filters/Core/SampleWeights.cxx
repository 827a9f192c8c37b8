// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleWeights.h"

#include "Lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hachure
{

namespace
{

constexpr double fullyVisible = 255.0;
constexpr double halfVisible = 128.0;

// What counts where the visibility is not known.
double frontVisibility(double signedWeight)
{
  return signedWeight > 0.0 ? fullyVisible : 0.0;
}

double seenWeight(double signedWeight, double visibility, bool unweighted)
{
  const double area = std::abs(signedWeight);
  const bool counts = (visibility >= halfVisible) & (area > 0.0);
  const double one = counts ? 1.0 : 0.0;
  const double weight = area * (visibility * (1.0 / fullyVisible));
  return unweighted ? one : weight;
}

// The loops below have no branches, so that several samples are weighed at once.
HACHURE_WIDE_CLONES
void weighFronts(const ProjectedSamples& samples, bool unweighted, double* __restrict weights)
{
  const double* signedWeights = samples.weights.data();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    weights[i] = seenWeight(signedWeights[i], frontVisibility(signedWeights[i]), unweighted);
  }
}

HACHURE_WIDE_CLONES
void weighSeen(const ProjectedSamples& samples, glm::dvec2 size, const std::uint8_t* visibility,
  bool unweighted, double* __restrict weights)
{
  const double* x = samples.x.data();
  const double* y = samples.y.data();
  const double* signedWeights = samples.weights.data();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const bool outside = (x[i] < 0.0) | (y[i] < 0.0) | (x[i] > size.x) | (y[i] > size.y);
    const double measured = visibility[i];
    const double seen = outside ? frontVisibility(signedWeights[i]) : measured;
    weights[i] = seenWeight(signedWeights[i], seen, unweighted);
  }
}

} // namespace

void weighSamples(const ProjectedSamples& samples, glm::dvec2 viewportSize,
  Span<const std::uint8_t> visibility, WeightScheme scheme, std::vector<double>& weights)
{
  assert(visibility.empty() || visibility.size() == samples.size());
  const bool unweighted = scheme == WeightScheme::Unweighted;
  weights.resize(samples.size());
  if (visibility.empty())
  {
    weighFronts(samples, unweighted, weights.data());
  }
  else
  {
    weighSeen(samples, viewportSize, visibility.data(), unweighted, weights.data());
  }
}

std::vector<double> facingWeights(const ProjectedSamples& samples, WeightScheme scheme)
{
  std::vector<double> weights;
  weighSamples(samples, glm::dvec2(0.0), {}, scheme, weights);
  return weights;
}

HACHURE_WIDE_CLONES
double positiveSum(Span<const double> weights)
{
  // w + |w| is 2w or 0, both without rounding.
  Lanes sums = {};
  const std::size_t whole = weights.size() - weights.size() % lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
  {
    Lanes both, size;
    load(weights.data() + i, both);
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      size[lane] = std::abs(both[lane]);
    }
    sums = sums + (both + size);
  }
  double sum = total(sums);
  for (std::size_t i = whole; i < weights.size(); ++i)
  {
    sum += 2.0 * std::max(0.0, weights.data()[i]);
  }
  return 0.5 * sum;
}

std::vector<double> frontWeights(const ProjectedSamples& samples, const PatchRuns& patches)
{
  std::vector<double> weights(patches.patchTotal, 0.0);
  for (const PatchRun& run : patches.runs)
  {
    weights[run.patch] += positiveSum({ &samples.weights[run.begin], run.end - run.begin });
  }
  return weights;
}

PatternFrame anchorPattern(const ProjectedSamples& samples)
{
  double bothWeight = 0.0;
  double frontWeight = 0.0;
  glm::dvec2 front(0.0);
  glm::dvec2 both(0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const ProjectedSample sample = samples[i];
    const double area = std::abs(sample.weight);
    both += area * sample.position;
    bothWeight += area;
    if (sample.weight > 0.0)
    {
      front += area * sample.position;
      frontWeight += area;
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
  return frame;
}

} // namespace hachure

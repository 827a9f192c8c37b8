// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fit of all patches at once against the fit of each patch from its own points.

#include "Core/PatchFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace hachure;

constexpr std::size_t patchTotal = 7;

// Runs of 1 to 13 samples, patches in no order, every third sample without weight.
struct Frames
{
  ProjectedSamples previous, current;
  std::vector<double> previousWeights, currentWeights;
  std::vector<std::int32_t> patches;

  explicit Frames(bool ones)
  {
    for (int run = 0; run < 60; ++run)
    {
      for (int k = 0; k <= run % 13; ++k)
      {
        const double i = static_cast<double>(this->patches.size());
        const glm::dvec2 p(1000.0 + 300.0 * std::sin(3.1 * i), 500.0 + 200.0 * std::cos(1.7 * i));
        const glm::dvec2 c(1.1 * p.x - 0.2 * p.y + std::sin(i), 0.2 * p.x + 1.1 * p.y);
        const bool seen = this->patches.size() % 3 != 0;
        add(this->previous, p);
        add(this->current, c);
        this->previousWeights.push_back(ones ? 1.0 : 2.0 + std::sin(5.0 * i));
        this->currentWeights.push_back(!seen ? 0.0 : (ones ? 1.0 : 2.0 + std::cos(7.0 * i)));
        this->patches.push_back((run * 5) % static_cast<int>(patchTotal - 1));
      }
    }
  }
  static void add(ProjectedSamples& samples, glm::dvec2 position)
  {
    samples.x.push_back(position.x);
    samples.y.push_back(position.y);
    samples.weights.push_back(0.0);
  }
  PatchFits fit(const PatchRuns& runs, WeightScheme scheme) const
  {
    return fitPatches({ this->previous, this->previousWeights },
      { this->current, this->currentWeights }, runs, scheme);
  }
  PatchRuns runs() const { return findPatchRuns(this->patches, this->patches.size(), patchTotal); }
};

double commonWeight(WeightScheme scheme, double previous, double current)
{
  if (scheme == WeightScheme::Classic)
  {
    return previous > 0.0 ? current : 0.0;
  }
  return scheme == WeightScheme::Symmetric ? std::sqrt(previous * current) : previous * current;
}

void expectFitsOfPatches(const Frames& frames, WeightScheme scheme)
{
  const PatchRuns runs = frames.runs();
  const PatchFits found = frames.fit(runs, scheme);
  const std::vector<PatchResidual> slides =
    measureResiduals(found.fits, { frames.previous, frames.previousWeights },
      { frames.current, frames.currentWeights }, runs, scheme);
  // With a patch for every sample the weight of a patch is that of a sample.
  std::vector<std::int32_t> alone(frames.patches.size());
  std::iota(alone.begin(), alone.end(), 0);
  const PatchFits single = frames.fit(findPatchRuns(alone, alone.size(), alone.size()), scheme);
  for (std::size_t patch = 0; patch < patchTotal; ++patch)
  {
    std::vector<glm::dvec2> p, c;
    std::vector<double> weights;
    double previous = 0.0, current = 0.0;
    for (std::size_t i = 0; i < frames.patches.size(); ++i)
    {
      const double common =
        commonWeight(scheme, frames.previousWeights[i], frames.currentWeights[i]);
      ASSERT_EQ(single.fits[i].weight, common);
      if (static_cast<std::size_t>(frames.patches[i]) == patch)
      {
        p.push_back(frames.previous[i].position);
        c.push_back(frames.current[i].position);
        weights.push_back(common);
        previous += frames.previousWeights[i];
        current += frames.currentWeights[i];
      }
    }
    const SimilarityFit expected = fitSimilarity(p, c, weights);
    const SimilarityFit& fit = found.fits[patch];
    EXPECT_EQ(fit.status, expected.status) << patch;
    EXPECT_NEAR(fit.weight, expected.weight, 1e-10);
    EXPECT_LT(glm::length(fit.transform.z - expected.transform.z), 1e-11);
    EXPECT_LT(glm::length(fit.transform.from - expected.transform.from), 1e-9);
    EXPECT_LT(glm::length(fit.transform.to - expected.transform.to), 1e-9);
    EXPECT_NEAR(slides[patch].residual, expected.residual, 1e-9);
    EXPECT_NEAR(slides[patch].weight, expected.weight, 1e-10);
    EXPECT_NEAR(found.previousWeights[patch], previous, 1e-10);
    EXPECT_NEAR(found.currentWeights[patch], current, 1e-10);
  }
  EXPECT_EQ(found.fits.back().status, FitStatus::NoSamples);
}

TEST(PatchFit, EqualsTheFitOfEveryPatch)
{
  expectFitsOfPatches(Frames(false), WeightScheme::Symmetric);
  expectFitsOfPatches(Frames(false), WeightScheme::Classic);
  expectFitsOfPatches(Frames(true), WeightScheme::Unweighted);
}

TEST(PatchFit, WrongPatchesAreNamed)
{
  for (const std::int32_t wrong : { -1, static_cast<std::int32_t>(patchTotal) })
  {
    Frames frames(false);
    frames.patches[40] = wrong;
    try
    {
      frames.runs();
      ADD_FAILURE() << "no error";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(std::string(error.what()),
        "findPatchRuns: patches[40] is " + std::to_string(wrong) + ", expected 0 to 7 - 1");
    }
  }
}

} // namespace

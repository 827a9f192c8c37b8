// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-fit-benchmark: CPU time per sample of following many patches from frame to frame: of the
/// fit alone, of advance() alone, and of a whole tracked frame, advance() and setVisibility().

#include "Core/PatternTracker.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace
{
using namespace hachure;

struct Scene
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<std::int32_t> patches;
  std::vector<double> spacing;

  // Bands of a golden spiral on the unit sphere, one after another.
  Scene(int patchTotal, int samplesPerPatch)
  {
    const int count = patchTotal * samplesPerPatch;
    for (int i = 0; i < count; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / count;
      const double radius = std::sqrt(1.0 - z * z);
      this->normals.emplace_back(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), z);
      this->patches.push_back(i / samplesPerPatch);
    }
    this->positions = this->normals;
    this->spacing.assign(static_cast<std::size_t>(patchTotal), std::sqrt(12.5 / count));
  }
  TrackedSamples samples() const
  {
    return { this->positions, this->normals, this->patches, this->spacing };
  }
};

ViewProjection viewAt(double angle)
{
  const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -4.0));
  return { glm::rotate(away, angle, glm::dvec3(1.0, 1.0, 0.0)),
    glm::perspective(0.6, 16.0 / 9.0, 0.1, 100.0), { 1280.0, 720.0 } };
}

double cpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The least CPU time of many calls of body(), since others only ever add to it. Nanoseconds a
// sample.
template <class Body>
double leastCost(std::size_t samples, Body&& body)
{
  constexpr double enough = 1e7;      // samples
  constexpr std::size_t least = 4000; // samples between two looks at a clock of a microsecond
  const std::size_t repeats = least / samples + 1;
  double best = 1e30;
  for (double done = 0.0; done < enough; done += static_cast<double>(samples * repeats))
  {
    const double start = cpuSeconds();
    for (std::size_t repeat = 0; repeat < repeats; ++repeat)
    {
      body();
    }
    best = std::min(best, (cpuSeconds() - start) / static_cast<double>(repeats));
  }
  return best * 1e9 / static_cast<double>(samples);
}
} // namespace

int main(int argumentCount, char** arguments)
{
  const int patches = argumentCount > 1 ? std::atoi(arguments[1]) : 1000;
  const int perPatch = argumentCount > 2 ? std::atoi(arguments[2]) : 300;
  if (patches < 1 || perPatch < 1 || argumentCount > 3)
  {
    std::fputs("usage: hachure-fit-benchmark [patches [samples per patch]]\n", stderr);
    return 2;
  }
  const Scene scene(patches, perPatch);
  const std::size_t count = scene.positions.size();
  const auto before = projectSamples(scene.samples(), viewAt(0.0), FacingRule::FrontOnly);
  const auto after = projectSamples(scene.samples(), viewAt(0.02), FacingRule::FrontOnly);
  const auto weightsBefore = facingWeights(before, WeightScheme::Symmetric);
  const auto weightsAfter = facingWeights(after, WeightScheme::Symmetric);
  const PatchRuns runs = findPatchRuns(scene.patches, count, scene.spacing.size());
  double checksum = 0.0;
  const double fit = leastCost(count,
    [&]
    {
      checksum += fitPatches(
        { before, weightsBefore }, { after, weightsAfter }, runs, WeightScheme::Symmetric)
                    .fits[0]
                    .weight;
    });
  PatternTracker tracker;
  double angle = 0.0;
  const double advance = leastCost(count,
    [&]
    {
      tracker.advance(scene.samples(), viewAt(angle += 0.01));
      checksum += tracker.drawn()[0].origin.x;
    });
  // The sphere rocks a little, so that what is visible stays about the same.
  std::vector<std::uint8_t> visibility;
  visibility.reserve(count);
  for (const double weight : weightsBefore)
  {
    visibility.push_back(weight > 0.0 ? 255 : 0);
  }
  PatternTracker rocked;
  angle = 0.0;
  const double frame = leastCost(count,
    [&]
    {
      rocked.advance(scene.samples(), viewAt(0.1 * std::sin(angle += 0.1)));
      rocked.setVisibility(visibility);
      checksum += rocked.committed()[0].origin.x;
    });
  std::printf("{\"patches\": %d, \"samples\": %zu, \"fit_ns_per_sample\": %.3f, "
              "\"advance_ns_per_sample\": %.3f, \"frame_ns_per_sample\": %.3f}\n",
    patches, count, fit, advance, frame);
  return std::isfinite(checksum) ? 0 : 1;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_MetricClips_h
#define hachure_MetricClips_h

// Synthetic clips with exact motion: a plane with a pattern, and how it is moved.

#include "Core/Parallel.h"
#include "Core/PatternMetrics.h"
#include "Core/Random.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace hachure::test
{

using Ink = std::function<double(glm::dvec2)>; // 0 to 1 at a place of the plane
using Move = std::function<glm::dvec2(glm::dvec2)>;

constexpr int pixelSplit = 4; // drawInk divides a pixel into so many squared parts

// Coverage of a part, from the distance of its centre to the edge of the ink.
inline double partCoverage(double distance)
{
  return std::min(1.0, std::max(0.0, 0.5 + pixelSplit * distance));
}

// Thresholded noise of one wavelength: waves in random directions.
inline Ink noiseInk(double wavelength, std::uint32_t seed)
{
  constexpr int waves = 24;
  const double turn = 2.0 * std::acos(-1.0);
  std::vector<glm::dvec3> phases;
  for (std::uint32_t k = 0; k < waves; ++k)
  {
    const double angle = turn * unitRandom(seed, k, 0);
    const double frequency = turn / wavelength * (0.8 + 0.4 * unitRandom(seed, k, 1));
    phases.emplace_back(
      frequency * std::cos(angle), frequency * std::sin(angle), turn * unitRandom(seed, k, 2));
  }
  return [phases](glm::dvec2 p)
  {
    double sum = 0.0;
    glm::dvec2 gradient(0.0);
    for (const glm::dvec3& wave : phases)
    {
      const double phase = wave.x * p.x + wave.y * p.y + wave.z;
      sum += std::cos(phase);
      gradient -= std::sin(phase) * glm::dvec2(wave.x, wave.y);
    }
    return partCoverage(sum / std::max(1e-9, glm::length(gradient)));
  };
}

// Straight strokes across the direction `angle`, in radians.
inline Ink hatchInk(double wavelength, double angle)
{
  return [wavelength, angle](glm::dvec2 p)
  {
    const double across = (p.x * std::cos(angle) + p.y * std::sin(angle)) / wavelength;
    const double middle = std::abs(across - std::round(across));
    return partCoverage(wavelength * (0.2 - middle));
  };
}

// Coverage of square pixels.
inline std::vector<float> drawInk(int size, const Ink& ink, const Move& toPlane)
{
  constexpr int fine = pixelSplit;
  std::vector<float> image(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  parallelFor(static_cast<std::int64_t>(image.size()),
    [&](std::int64_t i)
    {
      double sum = 0.0;
      for (int k = 0; k < fine * fine; ++k)
      {
        const int column = k % fine;
        const int row = k / fine;
        const glm::dvec2 offset((column + 0.5) / fine - 0.5, (row + 0.5) / fine - 0.5);
        sum += ink(toPlane(glm::dvec2(i % size, i / size) + offset));
      }
      image[static_cast<std::size_t>(i)] = static_cast<float>(sum / (fine * fine));
    });
  return image;
}

struct Clip
{
  int size = 0;
  std::vector<std::vector<float>> inks;
  struct Motion
  {
    std::vector<float> u, v, visible, facing, distance;
  };
  std::vector<Motion> motions;

  PatternClip view() const
  {
    PatternClip clip;
    for (const auto& ink : this->inks)
    {
      clip.frames.push_back({ this->size, this->size, ink });
    }
    for (const Motion& motion : this->motions)
    {
      clip.motions.push_back({ this->size, this->size, motion.u, motion.v, motion.visible,
        motion.facing, motion.distance });
    }
    return clip;
  }
};

// An affine motion of the plane per frame, about the centre of the picture: z is a complex number.
struct PlaneMotion
{
  glm::dvec2 shift{ 0.0 };
  double zoom = 1.0;
  double roll = 0.0; // radians
};

// Where a point of frame 0 is in frame t; t may be negative.
inline glm::dvec2 moved(const PlaneMotion& motion, glm::dvec2 point, double t, int size)
{
  const glm::dvec2 centre(0.5 * (size - 1));
  const glm::dvec2 p = (point - centre) * std::pow(motion.zoom, t);
  const double c = std::cos(motion.roll * t);
  const double s = std::sin(motion.roll * t);
  return centre + glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y) + motion.shift * t;
}

// The plane moves by `motion` per frame (shift alone, or zoom and roll alone), its pattern by
// another.
inline Clip planeClip(int size, int frames, const PlaneMotion& motion,
  const std::function<Ink(int)>& inkOfFrame, const PlaneMotion& patternMotion)
{
  Clip clip;
  clip.size = size;
  for (int t = 0; t < frames; ++t)
  {
    clip.inks.push_back(drawInk(
      size, inkOfFrame(t), [&](glm::dvec2 p) { return moved(patternMotion, p, -t, size); }));
  }
  Clip::Motion step;
  for (int i = 0; i < size * size; ++i)
  {
    const glm::dvec2 p(i % size, i / size);
    const glm::dvec2 next = moved(motion, p, 1.0, size) - p;
    step.u.push_back(static_cast<float>(next.x));
    step.v.push_back(static_cast<float>(next.y));
    step.visible.push_back(1.0f);
  }
  clip.motions.assign(static_cast<std::size_t>(frames - 1), step);
  return clip;
}

} // namespace hachure::test

#endif

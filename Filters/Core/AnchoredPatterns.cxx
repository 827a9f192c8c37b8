// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnchoredPatterns.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Pixels that a patch measures across when its pattern has scale 1.
constexpr double referenceDiameter = 512.0;
// An axis whose image is shorter than this part of its length points at the camera.
constexpr double shortestAxis = 1e-6;
// More steps than this in one replay are taken for a mistake in the times.
constexpr double mostSteps = 1e7;

// The shape of a patch: samples are uniform on it, so all of them count alike.
struct PatchShape
{
  double count = 0.0;
  glm::dvec3 centroid{ 0.0 };
  glm::dmat3 covariance{ 0.0 };
  double diameter = 0.0; // twice the largest distance from the centroid
};

std::vector<PatchShape> patchShapes(const TrackedSamples& samples)
{
  std::vector<PatchShape> shapes(std::max(patchCount(samples), samples.patchSpacing.size()));
  const auto shapeOf = [&](std::size_t i) -> PatchShape&
  { return shapes[samples.patches.empty() ? 0 : static_cast<std::size_t>(samples.patches[i])]; };
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
  {
    PatchShape& shape = shapeOf(i);
    shape.count += 1.0;
    shape.centroid += samples.positions[i];
  }
  for (PatchShape& shape : shapes)
  {
    shape.centroid /= std::max(1.0, shape.count);
  }
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
  {
    PatchShape& shape = shapeOf(i);
    const glm::dvec3 arm = samples.positions[i] - shape.centroid;
    shape.covariance += glm::outerProduct(arm, arm);
    shape.diameter = std::max(shape.diameter, 2.0 * glm::length(arm));
  }
  return shapes;
}

// One Jacobi rotation that makes the element (p, q) of the symmetric matrix 0.
void rotate(glm::dmat3& matrix, glm::dmat3& axes, int p, int q)
{
  if (matrix[q][p] == 0.0)
  {
    return;
  }
  const double angle = 0.5 * std::atan2(2.0 * matrix[q][p], matrix[q][q] - matrix[p][p]);
  glm::dmat3 rotation(1.0);
  rotation[p][p] = rotation[q][q] = std::cos(angle);
  rotation[q][p] = std::sin(angle);
  rotation[p][q] = -std::sin(angle);
  matrix = glm::transpose(rotation) * matrix * rotation;
  axes = axes * rotation;
}

// The two longest axes of the shape, each with its largest component positive.
void principalAxes(glm::dmat3 covariance, glm::dvec3& first, glm::dvec3& second)
{
  constexpr int sweeps = 12; // convergence is quadratic: doubles are exact after about six
  glm::dmat3 axes(1.0);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    rotate(covariance, axes, 0, 1);
    rotate(covariance, axes, 0, 2);
    rotate(covariance, axes, 1, 2);
  }
  int order[3] = { 0, 1, 2 };
  std::stable_sort(
    order, order + 3, [&](int a, int b) { return covariance[a][a] > covariance[b][b]; });
  for (int k = 0; k < 2; ++k)
  {
    glm::dvec3 axis = axes[order[k]];
    const glm::dvec3 size = glm::abs(axis);
    const int largest = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    axis *= axis[largest] < 0.0 ? -1.0 : 1.0;
    (k == 0 ? first : second) = axis;
  }
}

PatternFrame anchoredFrame(const PatchShape& shape, const ViewProjection& view)
{
  const glm::dmat4 modelToClip = view.viewToClip * view.modelToView;
  const glm::dvec4 clip = modelToClip * glm::dvec4(shape.centroid, 1.0);
  if (!(clip.w > 0.0) || !(shape.diameter > 0.0))
  {
    return {};
  }
  // Image gradients at the centroid.
  const glm::dmat4 rows = glm::transpose(modelToClip);
  const glm::dvec2 image = glm::dvec2(clip) / clip.w;
  const glm::dvec2 half = 0.5 * view.viewportSize;
  const glm::dvec3 w(rows[3]);
  const glm::dvec3 alongX = half.x / clip.w * (glm::dvec3(rows[0]) - image.x * w);
  const glm::dvec3 alongY = half.y / clip.w * (glm::dvec3(rows[1]) - image.y * w);
  const double pixelsPerUnit = std::sqrt(glm::length(glm::cross(alongX, alongY)));
  if (!std::isfinite(pixelsPerUnit) || !(pixelsPerUnit > 0.0))
  {
    return {};
  }

  glm::dvec3 first(0.0), second(0.0);
  principalAxes(shape.covariance, first, second);
  glm::dvec2 direction(glm::dot(alongX, first), glm::dot(alongY, first));
  if (glm::length(direction) <= shortestAxis * pixelsPerUnit)
  {
    direction = { glm::dot(alongY, second), -glm::dot(alongX, second) };
  }
  const double scale = pixelsPerUnit * shape.diameter / referenceDiameter;
  const glm::dvec2 u = scale * glm::normalize(direction);
  return { half * (image + 1.0), u, { -u.y, u.x } };
}

double keyBefore(Span<const double> keyTimes, double time)
{
  double key = -std::numeric_limits<double>::infinity();
  for (const double candidate : keyTimes)
  {
    if (candidate <= time)
    {
      key = std::max(key, candidate);
    }
  }
  return std::isfinite(key) ? key : time;
}

void checkTimes(Span<const double> keyTimes, double time, double step)
{
  for (std::size_t i = 0; i < keyTimes.size(); ++i)
  {
    if (!std::isfinite(keyTimes[i]))
    {
      throw std::invalid_argument(
        "replayFrames: keyTimes[" + std::to_string(i) + "] is not finite");
    }
  }
  if (!std::isfinite(time))
  {
    throw std::invalid_argument("replayFrames: time is not finite");
  }
  if (!std::isfinite(step) || step <= 0.0)
  {
    throw std::invalid_argument(
      "replayFrames: step is " + std::to_string(step) + ", expected a duration above 0");
  }
}

} // namespace

std::vector<PatternFrame> anchoredFrames(
  const TrackedSamples& samples, const ViewProjection& view, const TrackerOptions& options)
{
  checkSamples(samples);
  checkView(view);
  std::vector<PatternFrame> frames;
  for (const PatchShape& shape : patchShapes(samples))
  {
    PatternFrame frame = anchoredFrame(shape, view);
    if (options.lockRotation)
    {
      frame.u = { glm::length(frame.u), 0.0 };
    }
    if (options.lockScale)
    {
      frame.u = glm::normalize(frame.u);
    }
    frame.v = { -frame.u.y, frame.u.x };
    frames.push_back(frame);
  }
  return frames;
}

std::vector<PatternFrame> replayFrames(const ScenePath& path, Span<const double> keyTimes,
  double time, double step, const TrackerOptions& options)
{
  if (!path)
  {
    throw std::invalid_argument("replayFrames: path is empty, expected a function of time");
  }
  checkTimes(keyTimes, time, step);
  const double key = keyBefore(keyTimes, time);
  // Times that miss a step by rounding alone lie on it.
  constexpr double rounding = 1e-9;
  const double steps = std::floor((time - key) / step + rounding);
  if (steps > mostSteps)
  {
    throw std::invalid_argument("replayFrames: step is " + std::to_string(step) +
      ", expected fewer than ten million steps from the key to the time");
  }
  PatternTracker tracker;
  tracker.setOptions(options);
  const auto advanceTo = [&](double moment)
  {
    const TrackedScene scene = path(moment);
    tracker.advance(scene.samples, scene.view);
  };
  for (double k = 0.0; k <= steps; k += 1.0)
  {
    advanceTo(key + k * step);
  }
  if (time - (key + steps * step) > rounding * step)
  {
    advanceTo(time);
  }
  return { tracker.drawn().begin(), tracker.drawn().end() };
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleProjection.h"

#include "Parallel.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Waking a thread costs as much as projecting this many samples.
constexpr std::int64_t samplesPerThread = 8192;
constexpr double quarterOfPi = 0.78539816339744830962;

bool isFinite(const glm::dvec3& value)
{
  return std::isfinite(value.x + value.y + value.z);
}

bool isFinite(const glm::dmat4& matrix)
{
  double sum = 0.0;
  for (int column = 0; column < 4; ++column)
  {
    sum += glm::dot(matrix[column], glm::dvec4(1.0));
  }
  return std::isfinite(sum);
}

[[noreturn]] void refuse(const std::string& what)
{
  throw std::invalid_argument("projectSamples: " + what);
}

void checkSizes(const TrackedSamples& samples)
{
  const std::size_t count = samples.positions.size();
  if (samples.normals.size() != count)
  {
    refuse("normals has " + std::to_string(samples.normals.size()) + " elements, expected " +
      std::to_string(count) + " as in positions");
  }
  if (!samples.patches.empty() && samples.patches.size() != count)
  {
    refuse("patches has " + std::to_string(samples.patches.size()) + " elements, expected " +
      std::to_string(count) + " as in positions, or none");
  }
  if (!samples.features.empty() && samples.features.size() != count)
  {
    refuse("features has " + std::to_string(samples.features.size()) + " elements, expected " +
      std::to_string(count) + " as in positions, or none");
  }
}

void checkPatches(const TrackedSamples& samples)
{
  for (std::size_t i = 0; i < samples.patches.size(); ++i)
  {
    if (samples.patches[i] < 0)
    {
      refuse("patches[" + std::to_string(i) + "] is " + std::to_string(samples.patches[i]) +
        ", expected 0 or more");
    }
  }
  const std::size_t patches = patchCount(samples);
  if (samples.patchSpacing.size() < patches)
  {
    refuse("patchSpacing has " + std::to_string(samples.patchSpacing.size()) +
      " elements, expected " + std::to_string(patches) + " or more, one per patch");
  }
  for (std::size_t patch = 0; patch < patches; ++patch)
  {
    const double spacing = samples.patchSpacing[patch];
    if (!std::isfinite(spacing) || spacing < 0.0)
    {
      refuse("patchSpacing[" + std::to_string(patch) + "] is " + std::to_string(spacing) +
        ", expected a finite length");
    }
  }
}

// The projection, ready for many points. With rows x, y and w of the matrix from model to clip
// space, the image gradients are (x - X w)/W and (y - Y w)/W at the point with normalised
// coordinates (X, Y). Their cross product is, up to the factor 1/W^2, x cross y + X (y cross w) + Y
// (w cross x): it lies along the line of sight, and its product with a normal is the image area of
// a unit of surface.
struct AreaProjection
{
  glm::dmat4 modelToClip;
  glm::dvec3 constant, alongX, alongY;
  glm::dvec2 halfSize;
  glm::dvec4 viewZ;
  bool parallel;

  explicit AreaProjection(const ViewProjection& view)
    : modelToClip(view.viewToClip * view.modelToView)
    , halfSize(0.5 * view.viewportSize)
  {
    const glm::dmat4 rows = glm::transpose(this->modelToClip);
    const glm::dvec3 x(rows[0]), y(rows[1]), w(rows[3]);
    // The determinant of the whole projection tells mirrored models, whose normals point inwards.
    const double towardsViewer = glm::determinant(this->modelToClip) > 0.0 ? -1.0 : 1.0;
    const double pixels = towardsViewer * this->halfSize.x * this->halfSize.y;
    this->constant = pixels * glm::cross(x, y);
    this->alongX = pixels * glm::cross(y, w);
    this->alongY = pixels * glm::cross(w, x);
    this->viewZ = glm::transpose(view.modelToView)[2];
    this->parallel = w == glm::dvec3(0.0);
  }

  // The sample's position, and the signed image area of a unit of surface there.
  ProjectedSample operator()(const glm::dvec3& position, const glm::dvec3& normal) const
  {
    const glm::dvec4 clip = this->modelToClip * glm::dvec4(position, 1.0);
    const bool behind = this->parallel && glm::dot(this->viewZ, glm::dvec4(position, 1.0)) > 0.0;
    if (!(clip.w > 0.0) || behind)
    {
      return {};
    }
    const double limit = frustumMargin * clip.w;
    if (!(std::abs(clip.x) <= limit && std::abs(clip.y) <= limit))
    {
      return {};
    }
    const double perspective = 1.0 / clip.w;
    const glm::dvec2 image = glm::dvec2(clip) * perspective;
    const glm::dvec3 area = this->constant + image.x * this->alongX + image.y * this->alongY;
    return { this->halfSize * (image + 1.0), glm::dot(area, normal) * perspective * perspective };
  }
};

double facingWeight(double area, FacingRule facing)
{
  switch (facing)
  {
    case FacingRule::FrontOnly:
      return std::max(0.0, area);
    case FacingRule::BothSides:
      return std::abs(area);
    case FacingRule::Signed:
      break;
  }
  return area;
}

} // namespace

bool ViewProjection::operator==(const ViewProjection& other) const
{
  return this->modelToView == other.modelToView && this->viewToClip == other.viewToClip &&
    this->viewportSize == other.viewportSize;
}

std::size_t patchCount(const TrackedSamples& samples)
{
  if (samples.patches.empty())
  {
    return samples.positions.empty() ? 0 : 1;
  }
  return 1 +
    static_cast<std::size_t>(*std::max_element(samples.patches.begin(), samples.patches.end()));
}

void checkSamples(const TrackedSamples& samples)
{
  checkSizes(samples);
  checkPatches(samples);
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
  {
    if (!isFinite(samples.positions[i]) || !isFinite(samples.normals[i]))
    {
      refuse((isFinite(samples.positions[i]) ? "normals[" : "positions[") + std::to_string(i) +
        "] is not finite");
    }
  }
  for (std::size_t i = 0; i < samples.features.size(); ++i)
  {
    if (!(samples.features[i] >= 0.0 && std::isfinite(samples.features[i])))
    {
      refuse("features[" + std::to_string(i) + "] is " + std::to_string(samples.features[i]) +
        ", expected a finite number of 0 or more");
    }
  }
}

void checkView(const ViewProjection& view)
{
  if (!isFinite(view.modelToView) || !isFinite(view.viewToClip))
  {
    refuse(std::string(isFinite(view.modelToView) ? "viewToClip" : "modelToView") +
      " has elements that are not finite");
  }
  const glm::dvec2 size = view.viewportSize;
  if (!(std::isfinite(size.x + size.y) && size.x > 0.0 && size.y > 0.0))
  {
    refuse("viewportSize is " + std::to_string(size.x) + " x " + std::to_string(size.y) +
      ", expected more than 0 pixels");
  }
}

std::vector<double> sampleFacing(const TrackedSamples& samples, const ViewProjection& view)
{
  checkSamples(samples);
  checkView(view);
  const glm::dmat3 normalToView = glm::transpose(glm::inverse(glm::dmat3(view.modelToView)));
  const glm::dmat4 rows = glm::transpose(view.viewToClip);
  const bool parallel = glm::dvec3(rows[3]) == glm::dvec3(0.0);
  std::vector<double> facing(samples.positions.size());
  parallelForRanges(static_cast<std::int64_t>(facing.size()), samplesPerThread,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const glm::dvec3 normal = normalToView * samples.normals[i];
        const glm::dvec3 place(view.modelToView * glm::dvec4(samples.positions[i], 1.0));
        const glm::dvec3 toEye = parallel ? glm::dvec3(0.0, 0.0, 1.0) : -place;
        const double lengths = glm::length(normal) * glm::length(toEye);
        facing[i] = lengths > 0.0 ? glm::dot(normal, toEye) / lengths : 0.0;
      }
    });
  return facing;
}

std::vector<ProjectedSample> projectSamples(
  const TrackedSamples& samples, const ViewProjection& view, FacingRule facing)
{
  checkSamples(samples);
  checkView(view);
  const AreaProjection project(view);
  const double wholeImage = view.viewportSize.x * view.viewportSize.y;
  std::vector<ProjectedSample> projected(samples.positions.size());
  const auto projectRange = [&](std::int64_t begin, std::int64_t end)
  {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      const std::size_t patch =
        samples.patches.empty() ? 0 : static_cast<std::size_t>(samples.patches[i]);
      const double spacing = samples.patchSpacing[patch];
      ProjectedSample sample = project(samples.positions[i], samples.normals[i]);
      const double area = quarterOfPi * spacing * spacing * facingWeight(sample.weight, facing);
      // Next to the eye the tangent disc grows without bound; no sample fills more than the image.
      sample.weight = std::isfinite(area) ? std::clamp(area, -wholeImage, wholeImage) : 0.0;
      sample.weight *= samples.features.empty() ? 1.0 : samples.features[i];
      projected[i] = sample;
    }
  };
  parallelForRanges(static_cast<std::int64_t>(projected.size()), samplesPerThread, projectRange);
  return projected;
}

} // namespace hachure

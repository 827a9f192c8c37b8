// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleProjection.h"

#include "Lanes.h"
#include "Parallel.h"

#include <glm/geometric.hpp>
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

// Waking a thread, which then waits awake for a while, costs as much as projecting this many
// samples.
constexpr std::int64_t samplesPerThread = 1 << 20;
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

// Negative numbers are the highest of all.
HACHURE_WIDE_CLONES
std::uint32_t highestPatch(const std::int32_t* patches, std::size_t count)
{
  std::uint32_t highest = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    highest = std::max(highest, static_cast<std::uint32_t>(patches[i]));
  }
  return highest;
}

void checkPatches(const TrackedSamples& samples)
{
  const std::size_t patches = patchCount(samples);
  if (patches > std::size_t{ std::numeric_limits<std::int32_t>::max() } + 1)
  {
    const auto* wrong = std::find_if(
      samples.patches.begin(), samples.patches.end(), [](std::int32_t patch) { return patch < 0; });
    refuse("patches[" + std::to_string(wrong - samples.patches.begin()) + "] is " +
      std::to_string(*wrong) + ", expected 0 or more");
  }
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

void checkFeatures(const TrackedSamples& samples)
{
  for (std::size_t i = 0; i < samples.features.size(); ++i)
  {
    if (!(samples.features[i] >= 0.0 && std::isfinite(samples.features[i])))
    {
      refuse("features[" + std::to_string(i) + "] is " + std::to_string(samples.features[i]) +
        ", expected a finite number of 0 or more");
    }
  }
}

// All but the positions and normals.
void checkLayout(const TrackedSamples& samples)
{
  checkSizes(samples);
  checkPatches(samples);
  checkFeatures(samples);
}

void checkFinite(const TrackedSamples& samples, std::size_t begin, std::size_t end)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    if (!isFinite(samples.positions[i]) || !isFinite(samples.normals[i]))
    {
      refuse((isFinite(samples.positions[i]) ? "normals[" : "positions[") + std::to_string(i) +
        "] is not finite");
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
  glm::dvec4 clipX, clipY, clipW;
  glm::dvec4 behind; // above 0 behind a parallel view, where clipW does not tell
  glm::dvec3 constant, alongX, alongY;
  glm::dvec2 halfSize;

  explicit AreaProjection(const ViewProjection& view)
    : halfSize(0.5 * view.viewportSize)
  {
    const glm::dmat4 modelToClip = view.viewToClip * view.modelToView;
    const glm::dmat4 rows = glm::transpose(modelToClip);
    this->clipX = rows[0];
    this->clipY = rows[1];
    this->clipW = rows[3];
    const glm::dvec3 x(rows[0]), y(rows[1]), w(rows[3]);
    // The determinant of the whole projection tells mirrored models, whose normals point inwards.
    const double towardsViewer = glm::determinant(modelToClip) > 0.0 ? -1.0 : 1.0;
    const double pixels = towardsViewer * this->halfSize.x * this->halfSize.y;
    this->constant = pixels * glm::cross(x, y);
    this->alongX = pixels * glm::cross(y, w);
    this->alongY = pixels * glm::cross(w, x);
    const bool parallel = w == glm::dvec3(0.0);
    this->behind = parallel ? glm::transpose(view.modelToView)[2] : glm::dvec4(0.0);
  }
};

// Successive samples that are projected while they are in the fastest cache.
constexpr std::size_t blockSize = 256;
struct SampleBlock
{
  std::size_t begin;
  std::size_t count;
  double* x;
  double* y;
  double areas[blockSize]; // signed, of the images of a unit of surface; 0 out of sight
};

// Whether all samples are finite, or false where large ones could not be told from infinite ones.
// Without branches and on plain numbers, so that several samples are projected at once.
HACHURE_WIDE_CLONES
bool projectBlock(
  const AreaProjection& projection, const TrackedSamples& samples, SampleBlock& block)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const AreaProjection to = projection;
  const auto row = [](const glm::dvec4& r, double px, double py, double pz)
  { return (r.x * px + r.y * py) + (r.z * pz + r.w); };
  const double* positions = &samples.positions[block.begin].x;
  const double* normals = &samples.normals[block.begin].x;
  double* __restrict x = block.x;
  double* __restrict y = block.y;
  double* __restrict areas = block.areas;
  std::int64_t strange = 0;
  for (std::size_t i = 0; i < block.count; ++i)
  {
    const double px = positions[3 * i], py = positions[3 * i + 1], pz = positions[3 * i + 2];
    const double nx = normals[3 * i], ny = normals[3 * i + 1], nz = normals[3 * i + 2];
    const double clipX = row(to.clipX, px, py, pz);
    const double clipY = row(to.clipY, px, py, pz);
    const double clipW = row(to.clipW, px, py, pz);
    const double behind = row(to.behind, px, py, pz);
    const double offX = std::abs(clipX);
    const double offY = std::abs(clipY);
    const double limit = frustumMargin * clipW;
    const bool inside = (clipW > 0.0) & (behind <= 0.0) & (offX <= limit) & (offY <= limit);
    const double perspective = inside ? 1.0 / clipW : 0.0;
    const double imageX = inside ? clipX * perspective : 0.0;
    const double imageY = inside ? clipY * perspective : 0.0;
    const double area = (to.constant.x + imageX * to.alongX.x + imageY * to.alongY.x) * nx +
      (to.constant.y + imageX * to.alongX.y + imageY * to.alongY.y) * ny +
      (to.constant.z + imageX * to.alongX.z + imageY * to.alongY.z) * nz;
    x[i] = to.halfSize.x * (imageX + 1.0);
    y[i] = to.halfSize.y * (imageY + 1.0);
    areas[i] = area * perspective * perspective;
    const double sum = (clipX + clipY + clipW) + (nx + ny + nz);
    strange |= std::abs(sum) <= largest ? 0 : 1;
  }
  return strange == 0;
}

// Areas as weights: one that is not finite counts 0, all others at most `largest`.
HACHURE_WIDE_CLONES
void boundAreas(const double* areas, std::size_t count, double smallest, double largest,
  double* __restrict weights)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double area = std::isfinite(areas[i]) ? areas[i] : 0.0;
    weights[i] = std::min(std::max(area, smallest), largest);
  }
}

// The weights of a block, from the area of a disc of the spacing of every patch.
void weighBlock(SampleBlock& block, const TrackedSamples& samples, Span<const double> discs,
  double wholeImage, FacingRule facing, double* weights)
{
  for (std::size_t i = 0; i < block.count; ++i)
  {
    block.areas[i] *= samples.patches.empty()
      ? discs[0]
      : discs[static_cast<std::size_t>(samples.patches[block.begin + i])];
  }
  if (facing == FacingRule::BothSides)
  {
    std::transform(block.areas, block.areas + block.count, block.areas,
      [](double area) { return std::abs(area); });
  }
  // Next to the eye the tangent disc grows without bound; no sample fills more than the image.
  boundAreas(block.areas, block.count, facing == FacingRule::FrontOnly ? 0.0 : -wholeImage,
    wholeImage, weights);
  for (std::size_t i = 0; i < block.count && !samples.features.empty(); ++i)
  {
    weights[i] *= samples.features[block.begin + i];
  }
}

} // namespace

bool ProjectedSamples::operator==(const ProjectedSamples& other) const
{
  return this->x == other.x && this->y == other.y && this->weights == other.weights;
}

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
  return 1 + std::size_t{ highestPatch(samples.patches.data(), samples.patches.size()) };
}

void checkSamples(const TrackedSamples& samples)
{
  checkLayout(samples);
  checkFinite(samples, 0, samples.positions.size());
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

void projectSamples(const TrackedSamples& samples, const ViewProjection& view, FacingRule facing,
  ProjectedSamples& projected)
{
  checkLayout(samples);
  checkView(view);
  const AreaProjection projection(view);
  std::vector<double> discs;
  for (const double spacing : samples.patchSpacing)
  {
    discs.push_back(quarterOfPi * spacing * spacing);
  }
  const double wholeImage = view.viewportSize.x * view.viewportSize.y;
  const std::size_t count = samples.positions.size();
  projected.x.resize(count);
  projected.y.resize(count);
  projected.weights.resize(count);
  const auto projectRange = [&](std::int64_t begin, std::int64_t rangeEnd)
  {
    SampleBlock block;
    const auto end = static_cast<std::size_t>(rangeEnd);
    for (block.begin = static_cast<std::size_t>(begin); block.begin < end;
         block.begin += block.count)
    {
      block.count = std::min(blockSize, end - block.begin);
      block.x = &projected.x[block.begin];
      block.y = &projected.y[block.begin];
      // The error of the first block reaches the caller, whatever the number of threads.
      if (!projectBlock(projection, samples, block))
      {
        checkFinite(samples, block.begin, block.begin + block.count);
      }
      weighBlock(block, samples, discs, wholeImage, facing, &projected.weights[block.begin]);
    }
  };
  parallelForRanges(static_cast<std::int64_t>(count), samplesPerThread, projectRange);
}

ProjectedSamples projectSamples(
  const TrackedSamples& samples, const ViewProjection& view, FacingRule facing)
{
  ProjectedSamples projected;
  projectSamples(samples, view, facing, projected);
  return projected;
}

} // namespace hachure

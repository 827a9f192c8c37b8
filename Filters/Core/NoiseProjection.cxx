// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseProjection.h"

#include "NoiseProcess.h"

#include <glm/common.hpp>
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

constexpr double pi = 3.14159265358979323846;

double length3(const glm::dvec4& row)
{
  return glm::length(glm::dvec3(row));
}

// A half space at unit distances; the whole space for a plane at infinity.
glm::dvec4 unitPlane(const glm::dvec4& plane)
{
  const double length = length3(plane);
  return length > 0.0 ? plane / length : glm::dvec4(0.0, 0.0, 0.0, 1.0);
}

double at(const glm::dvec4& row, const glm::dvec3& point)
{
  return (row.x * point.x + row.y * point.y) + (row.z * point.z + row.w);
}

double along(const glm::dvec4& row, const glm::dvec3& direction)
{
  return row.x * direction.x + row.y * direction.y + row.z * direction.z;
}

// A row for places of a frame.
glm::dvec4 inFrame(const glm::dvec4& row, const NoiseFrame& frame)
{
  return glm::dvec4(glm::dvec3(row) * frame.unit, at(row, frame.origin));
}

double largestOf(const glm::dvec4& row)
{
  const glm::dvec4 size = glm::abs(row);
  return std::max(std::max(size.x, size.y), std::max(size.z, size.w));
}

// The value of w on the near plane, where it has but one.
double nearestW(const glm::dvec4& z, const glm::dvec4& w)
{
  const glm::dvec3 normalZ(z), normalW(w);
  const double square = glm::dot(normalW, normalW);
  if (square == 0.0)
  {
    return w.w;
  }
  const double skew = glm::length(glm::cross(normalZ, normalW));
  const double factor = glm::dot(normalZ, normalW) / square;
  if (skew > 1e-9 * glm::length(normalZ) * std::sqrt(square) || factor <= -1.0)
  {
    return 0.0;
  }
  // z + w = (1 + factor) w + (z.w - factor w.w) is 0 on the plane.
  return std::max(0.0, (factor * w.w - z.w) / (1.0 + factor));
}

[[noreturn]] void refuse(const std::string& name, double value, const std::string& expected)
{
  std::string message = name;
  message += " is ";
  message += std::to_string(value);
  message += ", expected ";
  message += expected;
  throw std::invalid_argument(message);
}

void require(bool isGood, const char* name, double value, const char* expected)
{
  if (!isGood || !std::isfinite(value))
  {
    refuse(name, value, expected);
  }
}

} // namespace

void checkNoiseView(const NoiseView& view)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      require(true, "view.modelToClip", view.modelToClip[column][row], "finite elements");
    }
  }
  require(true, "view.viewportOrigin.x", view.viewportOrigin.x, "a finite number");
  require(true, "view.viewportOrigin.y", view.viewportOrigin.y, "a finite number");
  require(view.viewportSize.x > 0.0, "view.viewportSize.x", view.viewportSize.x, "more than 0");
  require(view.viewportSize.y > 0.0, "view.viewportSize.y", view.viewportSize.y, "more than 0");
}

void checkNoiseOptions(const NoiseKernelOptions& options)
{
  require(options.overlap >= 1.0, "options.overlap", options.overlap, "1 or more");
  require(options.radius > 0.0, "options.radius", options.radius, "more than 0");
  require(options.frequency >= 0.0, "options.frequency", options.frequency, "0 or more");
  require(true, "options.orientation", options.orientation, "a finite number");
  // A little more than pi / 2, for those who give it rounded.
  require(options.spread >= 0.0 && options.spread < 0.50001 * pi, "options.spread", options.spread,
    "0 to pi / 2");
  require(options.fade > 0.0 && options.fade <= 64.0, "options.fade", options.fade,
    "more than 0, and 64 at most");
  const glm::dvec2 range = options.bandwidthRange;
  require(range.x > 0.0 && range.x <= 1.0, "options.bandwidthRange.x", range.x,
    "more than 0, and 1 at most");
  require(range.y >= 1.0, "options.bandwidthRange.y", range.y, "1 or more");
}

NoiseProjection::NoiseProjection(const NoiseView& view, const NoiseKernelOptions& kernelOptions)
  : options(kernelOptions)
  , origin(view.viewportOrigin)
  , size(view.viewportSize)
{
  const glm::dmat4 rows = glm::transpose(view.modelToClip);
  this->rowX = rows[0];
  this->rowY = rows[1];
  this->rowZ = rows[2];
  this->rowW = rows[3];
  const bool controlled = static_cast<bool>(this->options.control);
  const glm::dvec2 range = controlled ? this->options.bandwidthRange : glm::dvec2(1.0);
  this->largestRadius = this->options.radius / range.x;
  this->highestDensityFactor = range.y * range.y;
  this->densityPerMagnification = this->options.overlap /
    (pi * this->options.radius * this->options.radius * noiseFadeShare(this->options.fade));

  const glm::dvec2 margin = 1.0 + 2.0 * this->largestRadius / this->size;
  this->planes = { unitPlane(margin.x * this->rowW + this->rowX),
    unitPlane(margin.x * this->rowW - this->rowX), unitPlane(margin.y * this->rowW + this->rowY),
    unitPlane(margin.y * this->rowW - this->rowY), unitPlane(this->rowZ + this->rowW),
    unitPlane(this->rowW) };
  this->nearest = nearestW(this->rowZ, this->rowW);
  this->rowWLength = length3(this->rowW);

  // The image of an area vector A at (X, Y) is A . (x cross y + X (y cross w) + Y (w cross x)) /
  // w^2 for rows x, y, w; see SampleProjection. The norm of a linear function is highest at a
  // corner.
  const glm::dvec3 x(this->rowX), y(this->rowY), w(this->rowW);
  for (const glm::dvec2 corner :
    { margin, -margin, glm::dvec2(margin.x, -margin.y), glm::dvec2(-margin.x, margin.y) })
  {
    const glm::dvec3 image =
      glm::cross(x, y) + corner.x * glm::cross(y, w) + corner.y * glm::cross(w, x);
    this->normLimit =
      std::max(this->normLimit, 0.25 * this->size.x * this->size.y * glm::length(image));
  }
}

bool NoiseProjection::misses(const NoiseSphere& sphere) const
{
  return std::any_of(this->planes.begin(), this->planes.end(),
    [&](const glm::dvec4& plane) { return at(plane, sphere.center) < -sphere.radius; });
}

double NoiseProjection::magnificationBound(const NoiseSphere& sphere) const
{
  const double w =
    std::max(at(this->rowW, sphere.center) - sphere.radius * this->rowWLength, this->nearest);
  return w > 0.0 ? this->normLimit / (w * w) : std::numeric_limits<double>::infinity();
}

double NoiseProjection::densityBound(const NoiseSphere& sphere, double stretch) const
{
  const double looseness = 1.0 + 1e-9; // the rounding of the points' own densities
  return looseness * stretch * this->magnificationBound(sphere) * this->densityPerMagnification *
    this->highestDensityFactor;
}

bool NoiseProjection::meetsViewport(const glm::vec2& center, double radius) const
{
  const glm::dvec2 local = glm::dvec2(center) - this->origin;
  const glm::dvec2 beyond = local - glm::clamp(local, glm::dvec2(0.0), this->size);
  return glm::dot(beyond, beyond) < radius * radius;
}

NoiseBlockView NoiseProjection::blockView(const NoiseFrame& frame) const
{
  glm::dvec4 x = inFrame(this->rowX, frame), y = inFrame(this->rowY, frame);
  glm::dvec4 z = inFrame(this->rowZ, frame), w = inFrame(this->rowW, frame);
  const double scale =
    1.0 / std::max(std::max(largestOf(x), largestOf(y)), std::max(largestOf(w), 1e-300));
  const double square = glm::dot(glm::dvec3(w), glm::dvec3(w));
  const double offset = square > 0.0 ? glm::dot(glm::dvec3(z), glm::dvec3(w)) / square : 0.0;
  z -= offset * w;
  x *= scale;
  y *= scale;
  z *= scale;
  w *= scale;
  NoiseBlockView view;
  view.rowX = x;
  view.rowY = y;
  view.rowZ = z;
  view.rowW = w;
  view.scale = scale;
  view.depthOffset = offset;
  view.origin = this->origin;
  view.size = this->size;
  view.reach = static_cast<float>(this->largestRadius);
  view.densityFactor =
    static_cast<float>(this->densityPerMagnification * 0.25 * this->size.x * this->size.y);
  view.inverseFade = static_cast<float>(1.0 / this->options.fade);
  view.highestDensity = static_cast<float>(this->highestDensityFactor);
  view.turning = this->options.turning;
  const glm::dvec3 a(x), b(y), c(z), d(w);
  view.xy = glm::cross(a, b);
  view.yw = glm::cross(b, d);
  view.wx = glm::cross(d, a);
  view.zy = glm::cross(c, b);
  view.wz = glm::cross(d, c);
  view.xz = glm::cross(a, c);
  return view;
}

double NoiseProjection::radiusAt(const glm::dvec3& point) const
{
  const double w = at(this->rowW, point);
  return w > 0.0 ? this->options.radius * w / std::sqrt(this->normLimit)
                 : std::numeric_limits<double>::infinity();
}

NoiseKernelOptions::Control NoiseProjection::control(const NoisePoint& point) const
{
  NoiseKernelOptions::Control result;
  if (this->options.control)
  {
    result = this->options.control(point);
    const glm::dvec2 range = this->options.bandwidthRange;
    result.bandwidth =
      std::isfinite(result.bandwidth) ? std::clamp(result.bandwidth, range.x, range.y) : 1.0;
    result.frequency =
      result.frequency > 0.0 && std::isfinite(result.frequency) ? result.frequency : 1.0;
  }
  return result;
}

NoiseBlockView NoiseProjection::movedTo(NoiseBlockView view, const NoiseFrame& frame) const
{
  const double w = at(this->rowW, frame.origin);
  view.rowX.w = static_cast<float>(view.scale * at(this->rowX, frame.origin));
  view.rowY.w = static_cast<float>(view.scale * at(this->rowY, frame.origin));
  view.rowZ.w =
    static_cast<float>(view.scale * (at(this->rowZ, frame.origin) - view.depthOffset * w));
  view.rowW.w = static_cast<float>(view.scale * w);
  return view;
}

double NoiseProjection::orientation(
  const NoiseImages& images, int lane, const glm::dvec3& direction) const
{
  if (direction != glm::dvec3(0.0))
  {
    const glm::dvec2 center(images.x[lane], images.y[lane]);
    const glm::dvec2 clip = (center - this->origin) / this->size * 2.0 - 1.0;
    const double w = along(this->rowW, direction);
    const glm::dvec2 lines = this->size *
      glm::dvec2(
        along(this->rowX, direction) - clip.x * w, along(this->rowY, direction) - clip.y * w);
    if (std::isfinite(lines.x + lines.y) && lines != glm::dvec2(0.0))
    {
      return std::atan2(lines.y, lines.x) + this->options.lineAngle;
    }
  }
  return this->options.orientation + static_cast<double>(images.orientation[lane]);
}

double NoiseProjection::weight(const NoiseImages& images, const NoiseBlock& block, int lane,
  const NoiseKernelOptions::Control& control) const
{
  const double own =
    static_cast<double>(images.density[lane]) * control.bandwidth * control.bandwidth;
  return noiseFadeWeight(own, static_cast<double>(block.birth[lane]), this->options.fade);
}

bool NoiseProjection::placeKernel(const NoiseImages& images, int lane, const NoisePoint& point,
  const NoiseKernelOptions::Control& control, double weight, NoiseKernel& kernel) const
{
  const double radius = this->options.radius / control.bandwidth;
  kernel.center = { images.x[lane], images.y[lane] };
  if (!this->meetsViewport(kernel.center, radius))
  {
    return false;
  }
  // The halves of the id are independent.
  const double first = static_cast<double>(point.id >> 32) / 4294967296.0;                  // 2^32
  const double second = static_cast<double>(point.id & 0xffffffffull) / 2147483648.0 - 1.0; // 2^31
  kernel.weight = static_cast<float>(weight);
  kernel.phase =
    static_cast<float>(this->options.signs ? (first < 0.5 ? 0.0 : pi) : 2.0 * pi * first);
  kernel.frequency = static_cast<float>(this->options.frequency * control.frequency);
  kernel.bandwidth = noiseBandwidth(static_cast<float>(radius));
  kernel.orientation = static_cast<float>(
    this->orientation(images, lane, control.direction) + this->options.spread * second);
  kernel.depth = images.depth[lane];
  kernel.depthSlope = { images.slopeX[lane], images.slopeY[lane] };
  kernel.triangle = point.triangle;
  kernel.id = point.id;
  return true;
}

bool NoiseProjection::makeKernel(
  const NoiseTriangle& triangle, const NoisePoint& point, NoiseKernel& kernel) const
{
  const NoiseFrame frame{ triangle.origin + point.weights.x * triangle.u +
      point.weights.y * triangle.v,
    powerOfTwo(binaryExponent(std::max(glm::length(triangle.u), 1e-300))) };
  NoiseBlock block{};
  block.count = 1;
  block.place(0, triangle, point.weights, frame);
  block.birth[0] = static_cast<float>(point.birth * frame.unit * frame.unit);
  NoiseImages images;
  projectNoiseBlock(this->blockView(frame), block, images);
  const NoiseKernelOptions::Control control = this->control(point);
  const double weight = this->weight(images, block, 0, control);
  return !std::signbit(images.seen[0]) && weight > 0.0 &&
    this->placeKernel(images, 0, point, control, weight, kernel);
}

void NoiseOutputs::restart(std::int64_t count, bool wantsPoints)
{
  this->parts.resize(static_cast<std::size_t>(count));
  for (NoiseOutput& part : this->parts)
  {
    part.wantsPoints = wantsPoints;
    part.kernels.clear();
    part.points.clear();
  }
}

void NoiseOutputs::join(std::vector<NoiseKernel>& kernels, std::vector<NoisePoint>* points) const
{
  kernels.clear();
  std::size_t count = 0;
  for (const NoiseOutput& part : this->parts)
  {
    count += part.kernels.size();
  }
  kernels.reserve(count);
  for (const NoiseOutput& part : this->parts)
  {
    kernels.insert(kernels.end(), part.kernels.begin(), part.kernels.end());
  }
  if (points)
  {
    points->clear();
    for (const NoiseOutput& part : this->parts)
    {
      points->insert(points->end(), part.points.begin(), part.points.end());
    }
  }
}

} // namespace hachure

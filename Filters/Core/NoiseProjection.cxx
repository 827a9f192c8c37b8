// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseProjection.h"

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

// A triangle seen edge-on crosses the whole range of depths within one pixel; it is no steeper.
constexpr double steepest = 1.0;

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

double NoiseProjection::densityBound(const NoiseSphere& sphere, double stretch) const
{
  const double w =
    std::max(at(this->rowW, sphere.center) - sphere.radius * this->rowWLength, this->nearest);
  const double looseness = 1.0 + 1e-9; // the rounding of the points' own densities
  const double highest = looseness * stretch * this->normLimit * this->densityPerMagnification *
    this->highestDensityFactor;
  return w > 0.0 ? highest / (w * w) : std::numeric_limits<double>::infinity();
}

bool NoiseProjection::meetsViewport(const glm::dvec2& center, double radius) const
{
  const glm::dvec2 local = center - this->origin;
  const glm::dvec2 beyond = local - glm::clamp(local, glm::dvec2(0.0), this->size);
  return glm::dot(beyond, beyond) < radius * radius;
}

bool NoiseProjection::project(
  const NoiseTriangle& triangle, const glm::dvec2& weights, NoiseImage& image) const
{
  const glm::dvec3 place = triangle.origin + weights.x * triangle.u + weights.y * triangle.v;
  const double w = at(this->rowW, place);
  const double z = at(this->rowZ, place);
  if (!(w > 0.0) || z < -w)
  {
    return false;
  }
  const double perspective = 1.0 / w;
  const glm::dvec3 clip = glm::dvec3(at(this->rowX, place), at(this->rowY, place), z) * perspective;
  image.place = clip;
  image.w = w;
  image.center = this->origin + (0.5 * glm::dvec2(clip) + 0.5) * this->size;
  if (!this->meetsViewport(image.center, this->largestRadius))
  {
    return false;
  }
  // Change of the image along the edges.
  const double uw = along(this->rowW, triangle.u), vw = along(this->rowW, triangle.v);
  const glm::dvec3 u = (glm::dvec3(along(this->rowX, triangle.u), along(this->rowY, triangle.u),
                          along(this->rowZ, triangle.u)) -
                         clip * uw) *
    perspective;
  const glm::dvec3 v = (glm::dvec3(along(this->rowX, triangle.v), along(this->rowY, triangle.v),
                          along(this->rowZ, triangle.v)) -
                         clip * vw) *
    perspective;
  const double determinant = u.x * v.y - u.y * v.x;
  if (determinant == 0.0)
  {
    return false;
  }
  image.magnification =
    std::abs(determinant) * 0.25 * this->size.x * this->size.y / (2.0 * triangle.area);
  image.depth = 0.5 * clip.z + 0.5;
  // The halves of depth and of the viewport's size cancel out.
  glm::dvec2 slope =
    glm::dvec2(u.z * v.y - u.y * v.z, u.x * v.z - u.z * v.x) / (determinant * this->size);
  const double steepness = glm::length(slope);
  if (!(steepness <= steepest))
  {
    slope = std::isfinite(steepness) ? slope * (steepest / steepness) : glm::dvec2(0.0);
  }
  image.depthSlope = slope;
  if (this->options.turning)
  {
    image.turn = turn(triangle, this->size * glm::dvec2(u), this->size * glm::dvec2(v));
  }
  return true;
}

// The rotation that is closest to the change of the image over the surface, both without units:
// that of its polar decomposition. u, v: images of the edges.
glm::dvec2 NoiseProjection::turn(
  const NoiseTriangle& triangle, const glm::dvec2& u, const glm::dvec2& v)
{
  const double side = glm::length(triangle.u);
  const double along = glm::dot(triangle.v, triangle.u) / side;
  const double across = glm::length(glm::cross(triangle.u, triangle.v)) / side;
  const glm::dvec2 first = u / side;
  const glm::dvec2 second = (v - along * first) / across;
  const double facing = u.x * v.y - u.y * v.x < 0.0 ? -1.0 : 1.0;
  return { first.x + facing * second.y, first.y - facing * second.x };
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

double NoiseProjection::orientation(const NoiseImage& image, const glm::dvec3& direction) const
{
  const double w = along(this->rowW, direction);
  const glm::dvec2 lines = this->size *
    glm::dvec2(along(this->rowX, direction) - image.place.x * w,
      along(this->rowY, direction) - image.place.y * w);
  const bool isSeen = std::isfinite(lines.x + lines.y) && lines != glm::dvec2(0.0);
  if (isSeen)
  {
    return std::atan2(lines.y, lines.x) + this->options.lineAngle;
  }
  const double turned = this->options.turning ? std::atan2(image.turn.y, image.turn.x) : 0.0;
  return this->options.orientation + (std::isfinite(turned) ? turned : 0.0);
}

bool NoiseProjection::placeKernel(const NoiseImage& image, const NoisePoint& point,
  const NoiseKernelOptions::Control& control, double weight, NoiseKernel& kernel) const
{
  const double radius = this->options.radius / control.bandwidth;
  if (!this->meetsViewport(image.center, radius))
  {
    return false;
  }
  // The halves of the id are independent.
  const double first = static_cast<double>(point.id >> 32) / 4294967296.0;                  // 2^32
  const double second = static_cast<double>(point.id & 0xffffffffull) / 2147483648.0 - 1.0; // 2^31
  kernel.center = glm::vec2(image.center);
  kernel.weight = static_cast<float>(weight);
  kernel.phase =
    static_cast<float>(this->options.signs ? (first < 0.5 ? 0.0 : pi) : 2.0 * pi * first);
  kernel.frequency = static_cast<float>(this->options.frequency * control.frequency);
  kernel.bandwidth = noiseBandwidth(static_cast<float>(radius));
  kernel.orientation =
    static_cast<float>(this->orientation(image, control.direction) + this->options.spread * second);
  kernel.depth = static_cast<float>(image.depth);
  kernel.depthSlope = glm::vec2(image.depthSlope);
  kernel.triangle = point.triangle;
  kernel.id = point.id;
  return true;
}

bool NoiseProjection::makeKernel(
  const NoiseTriangle& triangle, const NoisePoint& point, NoiseKernel& kernel) const
{
  NoiseImage image;
  if (!this->project(triangle, point.weights, image))
  {
    return false;
  }
  const double density = this->densityPerMagnification * image.magnification;
  if (!(density * this->highestDensityFactor > point.birth))
  {
    return false;
  }
  const NoiseKernelOptions::Control control = this->control(point);
  const double own = density * control.bandwidth * control.bandwidth;
  const double weight = noiseFadeWeight(own, point.birth, this->options.fade);
  return weight > 0.0 && this->placeKernel(image, point, control, weight, kernel);
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

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFade.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hachure
{
namespace
{
constexpr double pi = 3.14159265358979323846;
// Radians: extreme directions that are nearer than that to the centre say nothing.
constexpr float leastAngle = 1e-6f;

glm::dvec3 unitOf(const glm::dvec3& vector, const glm::dvec3& otherwise)
{
  const double length = glm::length(vector);
  return length > 0.0 && std::isfinite(length) ? vector / length : otherwise;
}

// Of (x, y), 0 to pi, for y >= 0; within 1e-5. Most of the time of making a texture is spent here.
float upperAngle(float y, float x)
{
  const float across = std::abs(x);
  const float t = std::min(y, across) / std::max(std::max(y, across), 1e-30f);
  const float s = t * t;
  const float octant = t *
    (0.99997726f +
      s *
        (-0.33262347f +
          s * (0.19354346f + s * (-0.11643287f + s * (0.05265332f - s * 0.01172120f)))));
  const float quarter = y > across ? static_cast<float>(0.5 * pi) - octant : octant;
  return x < 0.0f ? static_cast<float>(pi) - quarter : quarter;
}

// Rises with the angle of (x, y), -2 to 2.
float angleOrder(float y, float x)
{
  const float along = x / std::max(std::abs(x) + std::abs(y), 1e-30f);
  return y >= 0.0f ? 1.0f - along : along - 1.0f;
}

// At right angles to a unit vector.
glm::dvec3 sideOf(const glm::dvec3& direction)
{
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z
    ? glm::dvec3(1.0, 0.0, 0.0)
    : (size.y <= size.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
  return glm::normalize(glm::cross(direction, axis));
}
} // namespace

FadeRegion::FadeRegion(const glm::dvec3& towards, Span<const glm::dvec3> extremes)
  : isEverywhere(extremes.empty())
{
  const glm::dvec3 middle = unitOf(towards, glm::dvec3(0.0, 0.0, 1.0));
  this->centre = middle;
  this->side = sideOf(middle);
  this->up = glm::cross(middle, glm::dvec3(this->side));
  this->sectors.reserve(extremes.size());
  float least = 1.0f; // cosine
  for (const glm::dvec3& extreme : extremes)
  {
    Sector sector;
    sector.direction = unitOf(extreme, middle);
    sector.cosine = glm::dot(this->centre, sector.direction);
    sector.sine = glm::length(glm::cross(this->centre, sector.direction));
    if (sector.sine > leastAngle || sector.cosine < 0.0f)
    {
      sector.order =
        angleOrder(glm::dot(sector.direction, this->up), glm::dot(sector.direction, this->side));
      this->sectors.push_back(sector);
      least = std::min(least, sector.cosine);
    }
  }
  if (this->sectors.size() <= 1)
  {
    this->cone = this->sectors.empty()
      ? 0.0f
      : upperAngle(this->sectors.front().sine, this->sectors.front().cosine);
    return;
  }
  std::sort(this->sectors.begin(), this->sectors.end(),
    [](const Sector& a, const Sector& b)
    { return a.order != b.order ? a.order < b.order : a.cosine > b.cosine; });
  for (std::size_t i = 0; i < this->sectors.size(); ++i)
  {
    this->closeSector(this->sectors[i], this->sectors[(i + 1) % this->sectors.size()]);
  }
  // Great circles between directions on one half of the sphere stay as near to its centre.
  this->leastCosine = least > 0.0f ? least - 1e-6f : -2.0f;
}

void FadeRegion::closeSector(Sector& sector, const Sector& next) const
{
  constexpr float leastHeight = 1e-6f; // of half a turn around the centre, and of none
  sector.normal = glm::cross(sector.direction, next.direction);
  sector.height = glm::dot(sector.normal, this->centre);
  sector.isGreatCircle = sector.height > leastHeight * sector.sine * next.sine;
  if (!sector.isGreatCircle)
  {
    sector.begin = this->aroundOf(sector.direction);
    sector.width = this->aroundOf(next.direction) - sector.begin;
    // Of two the second one's sector goes on to the first one.
    sector.width += next.order <= sector.order ? static_cast<float>(2.0 * pi) : 0.0f;
    sector.angle = upperAngle(sector.sine, sector.cosine);
    sector.nextAngle = upperAngle(next.sine, next.cosine);
  }
}

float FadeRegion::aroundOf(const glm::vec3& direction) const
{
  return std::atan2(glm::dot(direction, this->up), glm::dot(direction, this->side));
}

const FadeRegion::Sector& FadeRegion::sectorAt(const glm::vec3& direction) const
{
  const float order = angleOrder(glm::dot(direction, this->up), glm::dot(direction, this->side));
  for (std::size_t i = this->sectors.size(); i > 0; --i)
  {
    if (this->sectors[i - 1].order <= order)
    {
      return this->sectors[i - 1];
    }
  }
  return this->sectors.back();
}

float FadeRegion::borderAt(const glm::vec3& direction, float cosine, float sine) const
{
  if (this->cone >= 0.0f)
  {
    return this->cone;
  }
  const Sector& sector = this->sectorAt(direction);
  if (sector.isGreatCircle)
  {
    // Where the half circle from the centre through the direction meets the great circle.
    return upperAngle(
      sector.height * sine, cosine * sector.height - glm::dot(sector.normal, direction));
  }
  float along = this->aroundOf(direction) - sector.begin;
  along += along < 0.0f ? static_cast<float>(2.0 * pi) : 0.0f;
  return glm::mix(
    sector.angle, sector.nextAngle, std::clamp(along / std::max(sector.width, 1e-6f), 0.0f, 1.0f));
}

float FadeRegion::relativeAngle(const glm::vec3& direction) const
{
  constexpr float beyond = 2.0f;
  if (this->isEverywhere)
  {
    return 0.0f;
  }
  const float cosine = glm::dot(direction, this->centre);
  if (this->cone < 0.0f && cosine < this->leastCosine)
  {
    return beyond;
  }
  const float sine = glm::length(glm::cross(this->centre, direction));
  const float angle = upperAngle(sine, cosine);
  constexpr float rounding = 1e-6f; // radians: of float directions, for regions without extent
  if (angle <= rounding)
  {
    return 0.0f; // towards no side
  }
  return std::min(angle / std::max(this->borderAt(direction, cosine, sine), rounding), 1e6f);
}

float fadeCurveAt(Span<const glm::dvec2> curve, float relativeAngle)
{
  const double angle = relativeAngle;
  if (curve.empty() || angle > 1.0)
  {
    return 0.0f;
  }
  std::size_t next = 0;
  while (next < curve.size() && curve[next].x <= angle)
  {
    ++next;
  }
  if (next == 0 || next == curve.size())
  {
    return static_cast<float>(next == 0 ? curve.front().y : curve.back().y);
  }
  const glm::dvec2& from = curve[next - 1];
  const glm::dvec2& to = curve[next];
  return static_cast<float>(glm::mix(from.y, to.y, (angle - from.x) / (to.x - from.x)));
}

ViewFade::ViewFade(const TextureView& ofView)
  : view(&ofView)
  , even(this->regionOf(ofView.focus))
{
}

// As seen from a place; of parallel views directions are the same everywhere.
FadeRegion ViewFade::regionOf(const glm::dvec3& from) const
{
  const glm::dvec3& place = this->view->parallel ? this->view->focus : from;
  std::vector<glm::dvec3> extremes;
  extremes.reserve(this->view->extremes.size());
  for (const glm::dvec3& extreme : this->view->extremes)
  {
    extremes.push_back(extreme - place);
  }
  return { this->view->eye - place, extremes };
}

float ViewFade::shareOf(float relativeAngle, float fromMiddle) const
{
  float angle = relativeAngle;
  if (this->view->fadeMode == FadeMode::Middle && angle <= 1.0f)
  {
    angle = 1.0f - std::clamp(2.0f * (1.0f - angle) - fromMiddle, 0.0f, 1.0f);
  }
  return fadeCurveAt(this->view->fadeCurve, angle);
}

// The direction, from the focus, of the camera that looks along a direction at a cell, at the
// view's own distance from the focus; where the ray passes further away its closest point is taken.
glm::vec3 ViewFade::fromFocus(const glm::dvec3& cell, const glm::vec3& direction) const
{
  if (this->view->parallel)
  {
    return direction;
  }
  const glm::dvec3 along(direction);
  const glm::dvec3 from = cell - this->view->focus;
  const glm::dvec3 eye = this->view->eye - this->view->focus;
  const double closest = -glm::dot(from, along);
  const double squared = glm::dot(eye, eye) - glm::dot(from, from) + closest * closest;
  const double distance = std::max(closest + std::sqrt(std::max(squared, 0.0)), 0.0);
  return unitOf(from + distance * along, along);
}

void ViewFade::shares(const glm::dvec3& cell, float fromMiddle, Span<const glm::vec3> directions,
  Span<float> shares) const
{
  assert(shares.size() == directions.size());
  if (this->view->extremes.empty())
  {
    std::fill(shares.begin(), shares.end(), 1.0f);
    return;
  }
  const bool isEven = this->view->fadeMode == FadeMode::Even;
  const FadeRegion region = isEven ? this->even : this->regionOf(cell);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const glm::vec3 direction = isEven ? this->fromFocus(cell, directions[i]) : directions[i];
    shares[i] = this->shareOf(region.relativeAngle(direction), fromMiddle);
  }
}

} // namespace hachure

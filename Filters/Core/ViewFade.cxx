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
constexpr double leastAngle = 1e-6;

glm::dvec3 unitOf(const glm::dvec3& vector, const glm::dvec3& otherwise)
{
  const double length = glm::length(vector);
  return length > 0.0 && std::isfinite(length) ? vector / length : otherwise;
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
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
  const glm::dvec3 first = sideOf(middle);
  this->centre = middle;
  this->side = first;
  this->up = glm::cross(middle, first);
  struct Extreme
  {
    float around;
    double angle;
    glm::dvec3 direction;
  };
  std::vector<Extreme> border;
  border.reserve(extremes.size());
  double most = 0.0;
  for (const glm::dvec3& extreme : extremes)
  {
    const glm::dvec3 direction = unitOf(extreme, middle);
    const double angle = angleBetween(middle, direction);
    if (angle > leastAngle)
    {
      border.push_back({ this->aroundOf(direction), angle, direction });
      most = std::max(most, angle);
    }
  }
  if (border.size() <= 1)
  {
    this->cone = static_cast<float>(most);
    return;
  }
  std::sort(border.begin(), border.end(),
    [](const Extreme& a, const Extreme& b)
    { return a.around != b.around ? a.around < b.around : a.angle < b.angle; });
  this->sectors.reserve(border.size());
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const Extreme& next = border[(i + 1) % border.size()];
    Sector sector = this->sectorBetween(border[i].direction, next.direction);
    const double turn = i + 1 < border.size() ? 0.0 : 2.0 * pi;
    sector.begin = border[i].around;
    sector.width = static_cast<float>(next.around + turn - border[i].around);
    sector.isGreatCircle =
      sector.width > 0.0f && sector.width < static_cast<float>(pi - 1e-6) && sector.height > 0.0f;
    this->sectors.push_back(sector);
  }
  // Great circles between directions on one half of the sphere stay as near to its centre.
  this->leastCosine = most < 0.5 * pi ? static_cast<float>(std::cos(most) - 1e-6) : -2.0f;
}

FadeRegion::Sector FadeRegion::sectorBetween(const glm::dvec3& from, const glm::dvec3& to) const
{
  Sector sector;
  const glm::dvec3 middle(this->centre);
  const glm::dvec3 normal = glm::cross(from, to);
  sector.normal = normal;
  sector.height = static_cast<float>(glm::dot(normal, middle));
  sector.angle = static_cast<float>(angleBetween(middle, from));
  sector.nextAngle = static_cast<float>(angleBetween(middle, to));
  return sector;
}

float FadeRegion::aroundOf(const glm::vec3& direction) const
{
  return std::atan2(glm::dot(direction, this->up), glm::dot(direction, this->side));
}

const FadeRegion::Sector& FadeRegion::sectorAt(float around) const
{
  for (std::size_t i = this->sectors.size(); i > 0; --i)
  {
    if (this->sectors[i - 1].begin <= around)
    {
      return this->sectors[i - 1];
    }
  }
  return this->sectors.back();
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
  const float angle = std::atan2(sine, cosine);
  float border = this->cone;
  if (border < 0.0f)
  {
    const float around = this->aroundOf(direction);
    const Sector& sector = this->sectorAt(around);
    if (sector.isGreatCircle)
    {
      // Where the half circle from the centre through the direction meets the great circle.
      border = std::atan2(
        sector.height * sine, cosine * sector.height - glm::dot(sector.normal, direction));
    }
    else
    {
      float along = around - sector.begin;
      along += along < 0.0f ? static_cast<float>(2.0 * pi) : 0.0f;
      border = glm::mix(sector.angle, sector.nextAngle,
        std::clamp(along / std::max(sector.width, 1e-6f), 0.0f, 1.0f));
    }
    // In the centre no side is meant.
    border = sine > 0.0f || cosine < 0.0f ? border : 1.0f;
  }
  constexpr float rounding = 1e-6f; // radians: of float directions, for regions without extent
  return angle <= rounding ? 0.0f : std::min(angle / std::max(border, rounding), 1e6f);
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

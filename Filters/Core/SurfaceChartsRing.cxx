// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsRing.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double twiceRootThree = 3.4641016151377544;

double cross(const glm::dvec2& one, const glm::dvec2& other)
{
  return one.x * other.y - one.y * other.x;
}

// 1 for a triangle of equal sides, 0 for one without area.
double qualityOf(const glm::dvec3& apex, const glm::dvec3& one, const glm::dvec3& other)
{
  const glm::dvec3 first = one - apex;
  const glm::dvec3 second = other - apex;
  const double squares =
    glm::dot(first, first) + glm::dot(second, second) + glm::dot(second - first, second - first);
  return squares > 0.0 ? twiceRootThree * glm::length(glm::cross(first, second)) / squares : 0.0;
}

// Negative for one that is turned over.
double flatQualityOf(const glm::dvec2& apex, const glm::dvec2& one, const glm::dvec2& other)
{
  const glm::dvec2 first = one - apex;
  const glm::dvec2 second = other - apex;
  const double squares =
    glm::dot(first, first) + glm::dot(second, second) + glm::dot(second - first, second - first);
  return squares > 0.0 ? twiceRootThree * cross(first, second) / squares : 0.0;
}
} // namespace

glm::dvec3 FlatTriangle::weightsOf(const glm::dvec2& point) const
{
  glm::dvec3 weights(cross(this->second - point, this->third - point),
    cross(this->third - point, this->first - point),
    cross(this->first - point, this->second - point));
  weights = glm::max(weights, glm::dvec3(0.0));
  const double sum = weights.x + weights.y + weights.z;
  return sum > 0.0 ? weights / sum : glm::dvec3(1.0 / 3.0);
}

bool FlatRing::lay(const CornerMesh& mesh, std::int32_t vertex, const VertexRing& ring)
{
  constexpr std::size_t mostTriangles = 32; // vertices with more get less when others go
  const std::size_t triangles = ring.corners.size();
  if (triangles > mostTriangles || triangles < (ring.isClosed ? 3u : 2u))
  {
    return false;
  }
  this->isClosed = ring.isClosed;
  this->centre = mesh.position(vertex);
  this->corners.resize(ring.ends.size());
  this->angles.resize(triangles);
  std::transform(ring.ends.begin(), ring.ends.end(), this->corners.begin(),
    [&](std::int32_t end) { return mesh.position(end); });
  double sum = 0.0;
  for (std::size_t place = 0; place < triangles; ++place)
  {
    const glm::dvec3 one = this->corners[place] - this->centre;
    const glm::dvec3 other = this->corners[(place + 1) % this->corners.size()] - this->centre;
    this->angles[place] = std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
    sum += this->angles[place];
  }
  if (!(sum > 0.0))
  {
    return false;
  }
  this->borderTurn = this->isClosed ? 0.0 : std::abs(sum - pi);
  const double scale = (this->isClosed ? 2.0 * pi : pi) / sum;
  this->flatten(scale);
  this->rate();
  constexpr double mostAngle = 0.95 * pi; // of a triangle; with more it would be turned over
  return scale * *std::max_element(this->angles.begin(), this->angles.end()) < mostAngle;
}

void FlatRing::flatten(double scale)
{
  constexpr double mostPower = 3.0; // of distances
  const double power = std::min(scale, mostPower);
  double radius = 0.0;
  for (const glm::dvec3& corner : this->corners)
  {
    radius += glm::length(corner - this->centre) / static_cast<double>(this->corners.size());
  }
  double angle = 0.0;
  this->places.resize(this->corners.size());
  for (std::size_t end = 0; end < this->corners.size(); ++end)
  {
    const double distance =
      std::pow(glm::length(this->corners[end] - this->centre) / radius, power);
    this->places[end] = distance * glm::dvec2(std::cos(angle), std::sin(angle));
    angle += end < this->angles.size() ? scale * this->angles[end] : 0.0;
  }
}

void FlatRing::rate()
{
  this->worstNow = 1.0;
  this->worstFlat = 1.0;
  for (std::size_t place = 0; place < this->angles.size(); ++place)
  {
    const std::size_t next = (place + 1) % this->corners.size();
    this->worstNow =
      std::min(this->worstNow, qualityOf(this->centre, this->corners[place], this->corners[next]));
    this->worstFlat = std::min(
      this->worstFlat, flatQualityOf(glm::dvec2(0.0), this->places[place], this->places[next]));
  }
}

template <class Visit>
void FlatRing::visitFan(int target, Visit&& visit) const
{
  const int count = static_cast<int>(this->places.size());
  const int triangles = static_cast<int>(this->angles.size());
  // At a border it starts or ends with the target.
  const int first = this->isClosed ? target + 1 : (target == 0 ? 1 : 0);
  const int number = this->isClosed ? triangles - 2 : triangles - 1;
  for (int i = first; i < first + number; ++i)
  {
    visit(static_cast<std::size_t>(i % count), static_cast<std::size_t>((i + 1) % count));
  }
}

bool FlatRing::keepsNormal(
  std::size_t apex, std::size_t one, std::size_t other, double cosine) const
{
  const glm::dvec3 after = glm::cross(
    this->corners[one] - this->corners[apex], this->corners[other] - this->corners[apex]);
  const glm::dvec3 before =
    glm::cross(this->corners[one] - this->centre, this->corners[other] - this->centre);
  return glm::dot(after, before) >= cosine * glm::length(after) * glm::length(before);
}

double FlatRing::score(const RingLimits& limits, int target, double mostShare) const
{
  if (this->borderTurn > limits.borderTurn)
  {
    return 0.0;
  }
  const auto apex = static_cast<std::size_t>(target);
  double worst = 1.0;
  double sum = 0.0;
  double largest = 0.0;
  bool isFine = true;
  this->visitFan(target,
    [&](std::size_t one, std::size_t other)
    {
      const double flat = flatQualityOf(this->places[apex], this->places[one], this->places[other]);
      const double quality =
        qualityOf(this->corners[apex], this->corners[one], this->corners[other]);
      // Slivers may become better ones.
      isFine = isFine && flat > std::min(limits.flatQuality, this->worstFlat) &&
        quality > std::min(limits.quality, this->worstNow) &&
        this->keepsNormal(apex, one, other, limits.cosine);
      worst = std::min(worst, std::min(quality, flat));
      const double area =
        cross(this->places[one] - this->places[apex], this->places[other] - this->places[apex]);
      sum += area;
      largest = std::max(largest, area);
    });
  return isFine && largest <= mostShare * sum ? worst : 0.0;
}

void FlatRing::makeFan(int target)
{
  this->fan.clear();
  double sum = 0.0;
  this->visitFan(target,
    [&](std::size_t one, std::size_t other)
    {
      const glm::dvec2& first = this->places[static_cast<std::size_t>(target)];
      const double area = cross(this->places[one] - first, this->places[other] - first);
      this->fan.push_back({ one, area, first, this->places[one], this->places[other] });
      sum += area;
    });
  for (FlatTriangle& triangle : this->fan)
  {
    triangle.share /= sum;
  }
}

const FlatTriangle& FlatRing::under(const glm::dvec2& place) const
{
  // Seen from the vertex that is kept, triangles lie side by side.
  const FlatTriangle* nearest = &this->fan.front();
  double best = -1.0;
  for (const FlatTriangle& triangle : this->fan)
  {
    const double from = cross(triangle.second - triangle.first, place - triangle.first);
    const double to = cross(place - triangle.first, triangle.third - triangle.first);
    if (from >= 0.0 && to >= 0.0)
    {
      return triangle;
    }
    // By rounding it is in none of them.
    const double missing =
      std::min(from, to) / cross(triangle.second - triangle.first, triangle.third - triangle.first);
    if (missing > best)
    {
      best = missing;
      nearest = &triangle;
    }
  }
  return *nearest;
}

} // namespace hachure

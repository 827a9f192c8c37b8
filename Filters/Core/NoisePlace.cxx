// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoisePlace.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure
{

NoisePlace::NoisePlace(const NoiseSurface& surface, const NoiseFacet& facet)
{
  const Span<const glm::dvec3> positions = surface.positions();
  this->origin = positions[facet.corners.x];
  this->u = positions[facet.corners.y] - this->origin;
  this->v = positions[facet.corners.z] - this->origin;
  const glm::dvec3 vector = glm::cross(this->u, this->v);
  const double length = glm::length(vector);
  this->area = 0.5 * length;
  this->normal = length > 0.0 ? vector / length : glm::dvec3(0.0);
}

glm::dvec2 NoisePlace::inEdges(const glm::dvec3& direction) const
{
  const double uu = glm::dot(this->u, this->u);
  const double uv = glm::dot(this->u, this->v);
  const double vv = glm::dot(this->v, this->v);
  const double alongU = glm::dot(direction, this->u);
  const double alongV = glm::dot(direction, this->v);
  const glm::dvec2 edges =
    glm::dvec2(alongU * vv - alongV * uv, alongV * uu - alongU * uv) / (uu * vv - uv * uv);
  const bool isGood = std::isfinite(edges.x + edges.y) && edges != glm::dvec2(0.0);
  return isGood ? edges : glm::dvec2(1.0, 0.0);
}

glm::dvec3 NoisePlace::fromEdges(const glm::dvec2& edges) const
{
  return glm::normalize(edges.x * this->u + edges.y * this->v);
}

bool makeCarriedKernel(const NoiseSurface& surface, const NoiseProjection& projection,
  const NoiseFacet& facet, const NoisePoint& point, const glm::dvec2& direction,
  NoiseKernel& kernel)
{
  const NoisePlace place(surface, facet);
  if (!(place.area > 0.0))
  {
    return false;
  }
  // The same plane and the same growth since the reference in unit edges.
  NoiseTriangle triangle;
  triangle.u = place.fromEdges(direction);
  triangle.v = glm::cross(place.normal, triangle.u);
  triangle.origin =
    place.at(point.weights) - point.weights.x * triangle.u - point.weights.y * triangle.v;
  triangle.area = 0.5 * facet.area / place.area;
  if (!projection.makeKernel(triangle, point, kernel))
  {
    return false;
  }
  kernel.object = surface.objects().empty() ? 0 : surface.objects()[facet.index];
  return true;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleShape.h"

#include <glm/geometric.hpp>

#include <limits>

namespace hachure
{

namespace
{

glm::dvec3 unitOrZero(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

} // namespace

StippleShape::StippleShape(const TriangleMesh& mesh)
  : isMesh(true)
  , reference(mesh.points.begin(), mesh.points.end())
  , triangles(mesh.triangles.begin(), mesh.triangles.end())
{
}

StippleShape::StippleShape(Span<const glm::dvec3> points, Span<const glm::dvec3> someNormals)
  : isMesh(false)
  , reference(points.begin(), points.end())
  , normals(someNormals.begin(), someNormals.end())
{
}

void StippleShape::move(Span<const glm::dvec3> points, Span<const glm::dvec3> someNormals)
{
  this->present.assign(points.begin(), points.end());
  if (!someNormals.empty())
  {
    this->normals.assign(someNormals.begin(), someNormals.end());
  }
}

glm::dvec3 StippleShape::areaVector(
  const std::vector<glm::dvec3>& points, std::int32_t triangle) const
{
  const glm::ivec3 ids = this->triangles[static_cast<std::size_t>(triangle)];
  const glm::dvec3& first = points[static_cast<std::size_t>(ids.x)];
  return glm::cross(points[static_cast<std::size_t>(ids.y)] - first,
    points[static_cast<std::size_t>(ids.z)] - first);
}

glm::vec3 StippleShape::referenceNormal(std::int32_t triangle) const
{
  return glm::vec3(unitOrZero(this->areaVector(this->reference, triangle)));
}

glm::vec3 StippleShape::presentNormal(std::int32_t triangle) const
{
  if (this->isMesh)
  {
    return glm::vec3(
      unitOrZero(this->areaVector(this->isMoved() ? this->present : this->reference, triangle)));
  }
  return this->normals.empty()
    ? glm::vec3(0.0f)
    : glm::vec3(unitOrZero(this->normals[static_cast<std::size_t>(triangle)]));
}

double StippleShape::densityRatio(std::int32_t triangle) const
{
  if (!this->isMesh || !this->isMoved())
  {
    return 1.0;
  }
  const double now = glm::length(this->areaVector(this->present, triangle));
  return now > 0.0 ? glm::length(this->areaVector(this->reference, triangle)) / now
                   : std::numeric_limits<double>::infinity();
}

std::size_t StippleShape::memory() const
{
  return sizeof(*this) +
    sizeof(glm::dvec3) *
    (this->reference.capacity() + this->present.capacity() + this->normals.capacity()) +
    sizeof(glm::ivec3) * this->triangles.capacity();
}

} // namespace hachure

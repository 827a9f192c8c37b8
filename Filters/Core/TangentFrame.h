// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TangentFrame_h
#define hachure_TangentFrame_h

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

// Tangents, and lines in tangent planes: directions without a sign. A line at the angle a is the
// vector (cos 2a, sin 2a), times how much it counts: both directions along it are the same vector,
// those across it the opposite one, and lines are averaged by adding their vectors.
namespace hachure
{
/// Two unit tangents that make a right-handed frame with a unit normal (Duff et al., Building an
/// orthonormal basis, revisited, 2017). It jumps with the normal: compare frames by transport only.
struct TangentFrame
{
  glm::dvec3 first;
  glm::dvec3 second;

  explicit TangentFrame(const glm::dvec3& normal)
  {
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    first = glm::dvec3(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    second = glm::dvec3(b, sign + normal.y * normal.y * a, -normal.y);
  }

  /// The vector of a line; of the tangential part of `direction`, by its squared length.
  glm::dvec2 lineVector(const glm::dvec3& direction) const
  {
    const double x = glm::dot(direction, first);
    const double y = glm::dot(direction, second);
    return { x * x - y * y, 2.0 * x * y };
  }
  /// The unit tangent along a line, which must not be 0.
  glm::dvec3 line(const glm::dvec2& vector) const
  {
    const double angle = 0.5 * std::atan2(vector.y, vector.x);
    return std::cos(angle) * first + std::sin(angle) * second;
  }
};

/// The turn of the shortest rotation that takes one unit normal to another. Opposite normals have
/// none; then a vector stays as it is, which suits a sheet folded back on itself.
inline glm::dvec3 transport(
  const glm::dvec3& vector, const glm::dvec3& fromNormal, const glm::dvec3& toNormal)
{
  const double cosine = glm::dot(fromNormal, toNormal);
  const glm::dvec3 axis = glm::cross(fromNormal, toNormal);
  const double smallest = 1e-9;
  if (!(1.0 + cosine > smallest))
  {
    return vector;
  }
  return vector * cosine + glm::cross(axis, vector) +
    axis * (glm::dot(axis, vector) / (1.0 + cosine));
}

/// How line vectors turn from the frame of one normal into that of another.
inline glm::dvec2 transportTurn(const glm::dvec3& fromNormal, const glm::dvec3& toNormal)
{
  const glm::dvec2 turn = TangentFrame(toNormal).lineVector(
    transport(TangentFrame(fromNormal).first, fromNormal, toNormal));
  const double length = glm::length(turn);
  return length > 0.0 ? turn / length : glm::dvec2(1.0, 0.0);
}

/// Product of complex numbers: a line vector turned by another of unit length.
inline glm::dvec2 turned(const glm::dvec2& line, const glm::dvec2& turn)
{
  return { line.x * turn.x - line.y * turn.y, line.x * turn.y + line.y * turn.x };
}
} // namespace hachure

#endif

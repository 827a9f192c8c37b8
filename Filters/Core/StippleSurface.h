// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleSurface_h
#define hachure_StippleSurface_h

#include "StippleHierarchy.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

// A mesh made ready for points to be spread on it: moved and scaled to the unit cube around the
// origin, so that neither tiny nor huge ones leave the range of a float.
namespace hachure
{

// The middle of the bounds goes to the origin, their diagonal to 1.
struct StippleFrame
{
  glm::dvec3 middle{ 0.0 };
  double size = 0.0; // 0: nothing can be on it

  glm::dvec3 place(const glm::dvec3& point) const { return (point - this->middle) / this->size; }
};

struct StippleBorder
{
  std::array<glm::vec3, 2> ends;
  glm::vec3 normal; // of the triangle, of unit length
};

struct StippleSurface
{
  TriangleMesh mesh;
  StippleFrame frame;
  // Those with an area, equal ones once, along a curve through space.
  std::vector<std::int32_t> triangles;
  // Area of all before it, scaled; and that of all as the last.
  std::vector<double> areaBefore;
  std::vector<StippleBorder> borders; // sides of one triangle only
  // The same: three times the triangle and the corner that the side begins with.
  std::vector<std::int64_t> openSides;

  double area() const { return this->areaBefore.back(); }
  std::array<glm::dvec3, 3> corners(std::int32_t triangle) const
  {
    const glm::ivec3 ids = this->mesh.triangles[static_cast<std::size_t>(triangle)];
    return { this->frame.place(this->mesh.points[static_cast<std::size_t>(ids.x)]),
      this->frame.place(this->mesh.points[static_cast<std::size_t>(ids.y)]),
      this->frame.place(this->mesh.points[static_cast<std::size_t>(ids.z)]) };
  }
};

// The triangles of a checked mesh that have an area, equal ones (the same places in the same
// direction of rotation) once, as they come.
std::vector<std::int32_t> distinctTriangles(const TriangleMesh& mesh);

// Throws std::invalid_argument naming the option and its value.
void checkStippleOptions(const StippleOptions& options);

// Of a checked mesh.
StippleSurface makeStippleSurface(const TriangleMesh& mesh);

// The bounds of some points; size 0 if there are none, they are all in one place, or too far apart.
StippleFrame stippleFrame(Span<const glm::dvec3> points);

} // namespace hachure

#endif

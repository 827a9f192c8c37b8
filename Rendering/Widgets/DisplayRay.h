// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_DisplayRay_h
#define hachure_DisplayRay_h

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

class vtkRenderer;

// What is under a place of a renderer, and where in it something is. Display coordinates are pixels
// of the window from its lower left corner, with a depth of 0 to 1.
namespace hachure
{

// Half of a straight line, or all of it where a camera without perspective looks along it.
struct DisplayRay
{
  glm::dvec3 origin{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 }; // of unit length
};

// The points that are seen at a place, in the coordinates that the matrix leads to from the
// world's.
DisplayRay displayRay(
  vtkRenderer* renderer, const glm::dvec2& display, const glm::dmat4& fromWorld);

// Where the ray goes through a sphere; of its two points the one nearer to `preferred`, or to the
// ray's origin where there is none. A ray beside the sphere has the point of it that is nearest.
glm::dvec3 pointOnSphere(
  const DisplayRay& ray, const glm::dvec3& center, double radius, const glm::dvec3* preferred);

// How far along a line, given by a point and a direction of unit length, the ray passes closest to
// it; `otherwise` where they are parallel.
double placeOnLine(
  const DisplayRay& ray, const glm::dvec3& point, const glm::dvec3& direction, double otherwise);

glm::dvec3 worldToDisplay(vtkRenderer* renderer, const glm::dvec3& world);
glm::dvec3 displayToWorld(vtkRenderer* renderer, const glm::dvec3& display);

// How far in front of the renderer's camera, along its direction of view, a point is.
double depthInView(vtkRenderer* renderer, const glm::dvec3& world);

// Whether the renderer's camera can see a point: it is not behind it.
bool isInFront(vtkRenderer* renderer, const glm::dvec3& world);

// The size of a pixel at a point, world coordinates.
double pixelSize(vtkRenderer* renderer, const glm::dvec3& world);

// From a place to a segment in display coordinates, in pixels; `nearest` is where it is nearest.
// Segments behind the camera, also in part, are infinitely far away.
double distanceToSegment(vtkRenderer* renderer, const glm::dvec2& display, const glm::dvec3& from,
  const glm::dvec3& to, glm::dvec3& nearest);

} // namespace hachure

#endif

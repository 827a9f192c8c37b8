// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureViewShapes_h
#define hachure_TextureViewShapes_h

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

class vtkMatrix4x4;
class vtkTextureViews;

// Where the marks of views, their ranges and their cameras are. Model coordinates are those of the
// surface, in which views are given; world coordinates are those of the renderer.
namespace hachure
{

glm::dmat4 matrixOf(vtkMatrix4x4* matrix); // null: identity
glm::dvec3 movedPoint(const glm::dmat4& matrix, const glm::dvec3& point);
glm::dvec3 movedVector(const glm::dmat4& matrix, const glm::dvec3& vector);

// What the marks of views are made for.
struct ViewScene
{
  vtkTextureViews* views = nullptr;
  glm::dmat4 modelToWorld{ 1.0 };
  glm::dmat4 worldToModel{ 1.0 };
  glm::dvec3 middle{ 0.0 }; // of the surface, model coordinates
  double modelLength = 1.0; // of the diagonal of the surface's box, model coordinates
  double pictureSize = 0.2; // of the longer side of a picture, world coordinates
};

// A camera and what it looks at. Views with a matrix look at the middle of the surface, and those
// without perspective among them are the length of the surface away from it.
struct ViewPlace
{
  glm::dvec3 eye{ 0.0 };
  glm::dvec3 focus{ 0.0 };
};

ViewPlace viewPlace(const ViewScene& scene, int view); // model coordinates

// A small picture in front of its camera, seen from there as the whole picture is. World
// coordinates, from the lower left corner anticlockwise as seen by the camera.
struct ViewPyramid
{
  std::array<glm::dvec3, 4> bases; // all at the eye, or those of a camera without perspective
  std::array<glm::dvec3, 4> corners;
};

// The picture is never further away than half the distance of what the camera looks at.
ViewPyramid viewPyramid(const ViewScene& scene, int view);

// From the focus, where a camera on the border of the range may be: closed, through all extreme
// points that lie on the border, at distances between theirs. Model coordinates; empty without any.
std::vector<glm::dvec3> rangeBorder(
  const ViewPlace& place, const std::vector<glm::dvec3>& extremes);

// The extreme points of a view, model coordinates.
std::vector<glm::dvec3> extremePoints(vtkTextureViews* views, int view);

// The nearest rotation that takes one direction to another, applied to a vector. Opposite or zero
// directions leave it as it is.
glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& from, const glm::dvec3& to);

} // namespace hachure

#endif

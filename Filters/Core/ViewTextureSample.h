// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureSample_h
#define hachure_ViewTextureSample_h

#include "CellLayers.h"
#include "NodePlaces.h"
#include "Span.h"
#include "SurfaceCells.h"
#include "SurfaceFrames.h"
#include "TriangleMesh.h"
#include "ViewTextureColors.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

// The colours that a camera sees of a view-dependent texture, at single places of its surface and
// without a picture: what is drawn, from the same functions (Kernels/ViewCells.glsl).
namespace hachure
{

struct ViewTextureCamera
{
  glm::dmat4 modelToClip{ 1.0 };          // OpenGL's clip space
  glm::dvec2 pictureSize{ 800.0, 600.0 }; // logical pixels
  double independentShare = 0.0;          // 0 to 1: see BlendFunction
};

// Where the camera of a matrix is, in model coordinates: w is 1, or 0 where it has no perspective
// and the rest is the direction to it.
glm::dvec4 viewerOf(const glm::dmat4& modelToClip);

// A place on the surface, and the turn from the frame in which its directions are stored to model
// coordinates. The chart is -1 on a triangle without area.
struct ViewTexturePlace
{
  ChartPlace place;
  glm::quat turn{ 1.0f, 0.0f, 0.0f, 0.0f };
};
ViewTexturePlace viewTexturePlace(
  const SurfaceCells& cells, const SurfaceFrames& frames, const NodePlace& place);

// Linear colour, not times alpha, and alpha: 1, or 0 where there are no colours and in no chart.
// direction: to the viewer, in model coordinates, of any length but 0; level: between two, clamped
// to those that there are. The arguments must belong together.
glm::vec4 viewTextureColorAt(const SurfaceCells& cells, const ViewTextureColors& colors,
  const ViewTexturePlace& place, const glm::vec3& direction, float level,
  float independentShare = 0.0f);

// sRGB with straight alpha of every point of the mesh; alpha is 0 where no triangle with an area
// is. Of the triangles around a point with several normals the one that faces the camera most
// counts. Throws std::invalid_argument for a wrong mesh, cells, frames or colours of another one,
// and a camera with a number that is not finite, a picture without area or a matrix that cannot be
// inverted.
std::vector<glm::u8vec4> viewTexturePointColors(const TriangleMesh& mesh, const SurfaceCells& cells,
  const SurfaceFrames& frames, const ViewTextureColors& colors, const ViewTextureCamera& camera);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceFrames_h
#define hachure_SurfaceFrames_h

#include "Span.h"
#include "SurfaceCells.h"
#include "TriangleMesh.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// The frames in which the directions of a view-dependent texture are stored: y along the normal.
// They belong to the corners of triangles; inside a triangle a frame is the normalised sum of its
// corners' quaternions by their weights, all with the sign that agrees with the first one's.
//
// No field of tangents is smooth all over a closed surface. Directions are only mixed within a
// chart and between the charts around a node, so that two families are enough: charts that face up
// (+Y) have frames that are singular at -Y, the others frames that are singular at +Y.
namespace hachure
{

struct SurfaceFrames
{
  std::vector<glm::ivec3> corners;   // of every triangle: the frames at its corners; -1: no chart
  std::vector<std::int32_t> points;  // of every frame: its mesh point
  std::vector<glm::quat> turns;      // of every frame: from the frame's to model coordinates
  std::vector<std::int32_t> sheets;  // of every frame: those of one number share their normal
  std::vector<glm::quat> otherTurns; // of every frame: as charts of the other kind have it
  std::vector<std::uint8_t> chartsDown; // of every chart its kind: 1 where it faces down
};

// Whether the frames of a triangle are not those of a chart that it reaches into.
inline bool areOtherFrames(const SurfaceFrames& frames, std::int32_t ownChart, std::int32_t chart)
{
  return frames.chartsDown[static_cast<std::size_t>(ownChart)] !=
    frames.chartsDown[static_cast<std::size_t>(chart)];
}

constexpr double defaultFeatureAngle = 0.5235987755982988; // radians: 30 degrees

// The normal is the mean of the triangles around a point by their angles there, but only of those
// that hang together with the frame's triangle over edges that turn by less than the feature angle
// (radians, 0 to pi). Throws std::invalid_argument for a wrong mesh, an angle that is not in its
// range, and cells of another number of triangles.
SurfaceFrames surfaceFrames(
  const TriangleMesh& mesh, const SurfaceCells& cells, double featureAngle = defaultFeatureAngle);

// Of the same triangles with their points elsewhere: `frames` are those of the reference and become
// those of the moved ones. Normals are taken anew, x-axes go along with the deformation; a rigid
// motion turns frames by its rotation. Where nothing is left of the triangles around, frames stay.
// Throws std::invalid_argument for a wrong mesh, another number of points, moved points that are
// not finite and frames of another mesh.
void moveFrames(SurfaceFrames& frames, const TriangleMesh& reference, Span<const glm::dvec3> moved);

} // namespace hachure

#endif

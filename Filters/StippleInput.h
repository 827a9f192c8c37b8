// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleInput_h
#define hachure_StippleInput_h

#include "Core/StippleHierarchy.h"
#include "SurfaceTriangles.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

class vtkDataObject;

namespace hachure
{

// All that stipples can be on: the triangles of an input or, of one that has no polygons, its
// points.
struct StippleInput
{
  SurfaceTriangles surface;
  bool hasPointsOnly = false;
  // Of points only: the finite ones.
  std::vector<glm::dvec3> positions, normals;
  std::vector<vtkIdType> pointIds; // within the block
  std::vector<std::int32_t> pointBlocks;
  bool isMissingNormals = false; // some of the points have none

  StippleHierarchy hierarchy(const StippleOptions& options) const;
  // Of a stipple: the input cell or -1, and the three points that its weights refer to; both within
  // the block.
  vtkIdType cellOf(const StipplePoint& point) const;
  std::int32_t blockOf(const StipplePoint& point) const;
  glm::ivec3 pointsOf(const StipplePoint& point) const;
  glm::dvec3 placeOf(const StipplePoint& point) const;
  // Of unit length, as the input is oriented; 0 for a point without a normal.
  glm::dvec3 normalOf(const StipplePoint& point) const;
};

// Throws as extractSurfaceTriangles does.
StippleInput readStippleInput(vtkDataObject* input);

} // namespace hachure

#endif

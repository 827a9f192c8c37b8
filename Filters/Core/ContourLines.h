// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ContourLines_h
#define hachure_ContourLines_h

#include "SampleProjection.h"
#include "Span.h"
#include "TriangleMesh.h"

#include <glm/vec2.hpp>

#include <array>
#include <vector>

// The lines that bound a surface in a picture, for drawing them as strokes.
namespace hachure
{

struct ContourOptions
{
  bool silhouettes = true; // where the surface turns away from the viewer
  bool borders = true;     // edges of a single triangle
  bool creases = false;    // edges at which the surface bends by more than creaseAngle
  // Degrees between the normals on both sides, 0 to 180. Smooth silhouettes do not run across such
  // edges, but along them.
  double creaseAngle = 40.0;
  // Silhouettes run across the triangles, where normals interpolated between the vertices are at
  // right angles to the line of sight (Hertzmann and Zorin 2000, section 3.1). Otherwise they run
  // along mesh edges between triangles that face the viewer and such that do not, in zigzags on a
  // curved surface, but exactly around what is drawn with flat shading.
  bool smooth = true;
};

// Window depth of all that hides contours, 0 (near) to 1; empty: nothing does.
struct ContourDepth
{
  std::array<int, 4> rectangle{ 0, 0, 0, 0 }; // x, y, width, height in pixels of the viewport
  Span<const float> values;                   // row by row from the bottom
};

struct ContourLine
{
  std::vector<glm::dvec2> points; // pixels of the viewport, y up
  bool closed = false;            // from the last point back to the first
};

// The contours of a surface as far as they are seen. What lies outside of the viewport or of the
// clipping range is cut off, and so is what lies behind the depth image, which may hold the surface
// itself. Gaps and remainders of less than two pixels are mended. Lines are as long as they can be;
// points less than a tenth of a pixel apart are thinned out.
//
// Triangles without area and with a corner that is not finite are left out, and of equal triangles
// one is taken. An edge of three or more triangles is a silhouette where some of them face the
// viewer and others do not. The result is the same for any number of threads. Throws
// std::invalid_argument for a corner that is no point, a bad view, another number of depths than
// the rectangle has pixels, and an angle out of range.
std::vector<ContourLine> contourLines(const TriangleMesh& mesh, const ViewProjection& view,
  const ContourDepth& depth = {}, const ContourOptions& options = {});

} // namespace hachure

#endif

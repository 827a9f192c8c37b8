// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ContourSegments_h
#define hachure_ContourSegments_h

#include "ContourLines.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

// The contours of a mesh before anything is hidden or cut off: pieces in view space, and how they
// hang together.
namespace hachure
{

// Where the picture beside a piece shows something other than the surface that it bounds.
enum class ContourSide
{
  Along,  // in the direction of `away`
  Across, // on that side of the line which `away` points to
  Both    // on neither side: the surface goes on
};

struct ContourSegment
{
  std::array<std::int64_t, 2> nodes{}; // equal numbers are the same place
  std::array<glm::dvec3, 2> ends{};
  ContourSide side = ContourSide::Both;
  glm::dvec3 away{ 0.0 };
  // How far the line may lie inside the outline of its own triangles, units of view space.
  double inset = 0.0;
  // Of the first triangles that meet in a mesh edge; 0: none.
  std::array<glm::dvec3, 2> planeNormals{ glm::dvec3(0.0), glm::dvec3(0.0) };
};

// Corners of triangles must be points; the rest is as contourLines says.
std::vector<ContourSegment> contourSegments(
  const TriangleMesh& mesh, const ViewProjection& view, const ContourOptions& options);

// Pieces one after the other.
struct ContourChain
{
  struct Link
  {
    std::int32_t segment = 0;
    bool reversed = false;
  };
  std::vector<Link> links;
  bool closed = false;
};

// As long as can be. Where more than two pieces meet, those go on that turn by less than 60
// degrees.
std::vector<ContourChain> chainContours(const std::vector<ContourSegment>& segments);

} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TriangleRuns_h
#define hachure_TriangleRuns_h

#include "Span.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// The triangles that a shader may draw where it knows only the *last* vertex of the triangle
// (OpenGL's provoking vertex): a run of records for every point. See TrianglePatches.h for why that
// is all it knows.
struct TriangleRuns
{
  std::vector<std::int32_t> firstOfPoint; // record; -1 where no triangle ends
  std::vector<std::int32_t> triangles;    // of every record
  std::vector<std::uint8_t> goesOn;       // whether the next record is of the same point
};

// Triangles that follow each other with the same number in `facets` are parts of one polygon, which
// may be drawn in other parts: every corner has all of them. Empty: all are drawn as they are.
TriangleRuns triangleRuns(
  std::size_t pointCount, Span<const glm::ivec3> triangles, Span<const std::int32_t> facets);

} // namespace hachure

#endif

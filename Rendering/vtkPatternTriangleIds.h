// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which triangle is seen at every pixel: draws triangles into an image of their indices.
 */
#ifndef vtkPatternTriangleIds_h
#define vtkPatternTriangleIds_h

#include "Span.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vtkPattern
{
/// Indices of the triangles seen, rows from the bottom up, -1 where there is none. Corners are in
/// clip coordinates and must be finite. Needs the window's context to be current; leaves no GL
/// object behind. Throws std::runtime_error where the window cannot draw it.
std::vector<std::int32_t> DrawTriangleIds(vtkOpenGLRenderWindow* window,
  hachure::Span<const glm::dvec4> corners, hachure::Span<const glm::ivec3> triangles,
  const glm::ivec2& size);
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternTriangleIds.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An array of a mapper's input on the triangles of its surface.
 */
#ifndef vtkPatternSurfaceArray_h
#define vtkPatternSurfaceArray_h

#include "SurfaceTriangles.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkDataObject;

class vtkPatternSurfaceArray
{
public:
  /// Reads a point array, or where there is none a cell array, of every block. Throws
  /// std::invalid_argument that names the array where it is missing, not numeric, or has another
  /// number of components.
  vtkPatternSurfaceArray(vtkDataObject* input, const hachure::SurfaceTriangles& surface,
    const std::string& name, int components);

  /// At a place in a triangle; weights are those of its second and third corner. NaN where the data
  /// have none.
  double Number(std::int32_t triangle, const glm::dvec2& weights) const;

  /// A direction without sign there: those of the corners are turned to one side before they are
  /// mixed. 0 where the data have none.
  glm::dvec3 Line(std::int32_t triangle, const glm::dvec2& weights) const;

private:
  struct Part
  {
    bool OfPoints = true;
    std::vector<double> Values;
  };
  glm::dvec3 Vector(const Part& part, std::size_t tuple) const;

  const hachure::SurfaceTriangles* Surface;
  int Components;
  std::vector<Part> Parts; // by block
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternSurfaceArray.h

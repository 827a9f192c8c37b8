// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All surfaces of vtkPatternMotion as one set of triangles in two states.
 */
#ifndef vtkPatternMotionGeometry_h
#define vtkPatternMotionGeometry_h

#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

struct vtkPatternMotionGeometry
{
  static constexpr int Before = 0;
  static constexpr int After = 1;

  struct Surface
  {
    std::string Name; // for messages
    int Label;        // 0: an occluder
    std::array<vtkSmartPointer<vtkDataObject>, 2> Data;
    std::array<glm::dmat4, 2> ToView;
  };

  // In view coordinates of each state.
  std::array<std::vector<glm::dvec3>, 2> Points;
  std::vector<glm::dvec3> Normals; // before; 0 where the data has none
  std::vector<glm::ivec3> Triangles;
  std::vector<std::int32_t> Labels; // per triangle

  /// Throws std::invalid_argument naming the surface, what is wrong, and what was expected.
  void Append(const Surface& surface);

private:
  void AppendBlock(
    const Surface& surface, const std::string& name, vtkPolyData* before, vtkPolyData* after);
  void AppendPoints(const Surface& surface, const std::string& name, int state, vtkPolyData* data);
  void AppendNormals(const Surface& surface, vtkPolyData* data);
  void AppendTriangles(const std::string& name, int label, int firstPoint, vtkPolyData* data);
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternMotionGeometry.h

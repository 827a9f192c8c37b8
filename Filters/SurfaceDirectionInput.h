// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceDirectionInput_h
#define hachure_SurfaceDirectionInput_h

#include "SurfaceTriangles.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

// Blocks of VTK as the algorithms about directions need them.
namespace hachure
{
/// One block: triangles of its own points, and which of the points are joined.
struct DirectionBlock
{
  vtkPolyData* data = nullptr;
  unsigned int flatIndex = 0;
  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;
  std::vector<vtkIdType> cells;       ///< per triangle
  std::vector<std::int32_t> vertices; ///< per point
  std::vector<glm::dvec3> normals;    ///< active normals of the points, or empty

  TriangleMesh mesh() const { return { this->points, this->triangles, {} }; }
};

/// The blocks of a vtkPolyData or a composite of them. Throws as extractSurfaceTriangles does.
std::vector<DirectionBlock> readDirectionBlocks(vtkDataObject* input);

/// A number per point. Throws std::invalid_argument naming the array when it is missing or has
/// not one number per point.
std::vector<double> readScalars(const DirectionBlock& block, const std::string& name);

/// Three numbers per point, or per triangle from those of the cells where no point array has the
/// name. Throws as readScalars does.
struct DirectionVectors
{
  std::vector<glm::dvec3> values;
  bool ofPoints = true;
};
DirectionVectors readVectors(const DirectionBlock& block, const std::string& name);
} // namespace hachure

#endif

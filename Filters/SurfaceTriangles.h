// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceTriangles_h
#define hachure_SurfaceTriangles_h

#include "Core/TriangleMesh.h"
#include "HachureFiltersModule.h" // for the export macro

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;

namespace hachure
{
/// Where the patch id of a triangle comes from.
struct PatchSource
{
  std::string cellArray; ///< cell array of integers with one component; empty: all in patch 0
  bool byBlock = false;  ///< the flat index of the block instead; the array is then not read
};

/// Which cells are cut into triangles.
enum class TriangleChoice
{
  Drawable, ///< none that are hidden, a ghost or not finite, and no triangle without area
  Finite,   ///< none that are hidden or not finite; ghosts, which continue the surface, are there
  All       ///< all polygons and strips; a corner that is not finite is an error
};

/// All triangles of a vtkPolyData, or of all vtkPolyData blocks of a composite one after the other.
/// Polygons (concave ones too) and strips are cut into triangles; vertices and lines are left out.
/// Unless others are chosen, so are ghost and hidden cells, triangles without area and those with a
/// non-finite corner.
struct SurfaceTriangles
{
  struct Block
  {
    unsigned int flatIndex = 0;     ///< 0 for a plain vtkPolyData
    std::int32_t firstPoint = 0;    ///< the block's point i is points[firstPoint + i]
    std::int32_t firstTriangle = 0; ///< its triangles start here, and end where the next starts
  };

  std::vector<glm::dvec3> points; ///< all input points, in order
  std::vector<glm::ivec3> triangles;
  std::vector<std::int32_t> patches;      ///< per triangle; empty without a patch source
  std::vector<vtkIdType> cells;           ///< per triangle: input cell within its block
  std::vector<std::int32_t> blockIndices; ///< per triangle: index into blocks
  std::vector<Block> blocks;
  std::int64_t nonFinitePoints = 0; ///< input points with an infinite or NaN coordinate

  TriangleMesh mesh() const { return { this->points, this->triangles, this->patches }; }
  /// The triangles of one block alone; the corners still index all points.
  HACHUREFILTERS_EXPORT TriangleMesh blockMesh(std::size_t block) const;
};

/// Throws std::invalid_argument, with a message for the user, when the patch array is missing or is
/// not one integer per cell, when a cell refers to a point that does not exist, and when a block is
/// not a vtkPolyData. A null input gives no triangles.
HACHUREFILTERS_EXPORT SurfaceTriangles extractSurfaceTriangles(vtkDataObject* input,
  const PatchSource& source = {}, TriangleChoice choice = TriangleChoice::Drawable);
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfacePatchesInput_h
#define hachure_SurfacePatchesInput_h

#include "Core/SurfacePatchesMesh.h"
#include "SurfaceTriangles.h"

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkSelection;

// Surfaces of VTK as the algorithms about patches need them.
namespace hachure
{
/// How cells become faces.
enum class StripFaces
{
  Whole,    ///< a strip is one face, as it has one cell value
  Triangles ///< every triangle of a strip is a face, as it has neighbours of its own
};

struct PatchSurface
{
  struct FaceCell
  {
    std::int32_t block = 0; ///< index into triangles.blocks
    vtkIdType cell = 0;     ///< within the block
  };

  SurfaceTriangles triangles;
  std::vector<std::int32_t> faces;    ///< per triangle
  std::vector<std::int32_t> vertices; ///< per point: equal where points coincide
  std::vector<FaceCell> cells;        ///< per face

  FaceSurface surface() const { return { this->triangles.mesh(), this->faces, this->vertices }; }
};

/// All polygons and strips of a vtkPolyData or a composite of them. Throws as
/// extractSurfaceTriangles does. With `joinBlocks` points that coincide are joined across blocks.
PatchSurface readPatchSurface(
  vtkDataObject* input, const PatchSource& source, bool joinBlocks, StripFaces strips);

/// The vtkPolyData, or those in a composite, in the order of SurfaceTriangles::blocks.
std::vector<vtkPolyData*> polyDataBlocks(vtkDataObject* data);

/// Makes the output a shallow copy of the input with blocks of its own, to which arrays can be
/// added.
void copyBlocks(vtkDataObject* input, vtkDataObject* output);

/// The value of an integer or string array for every face: of its cell, or the most frequent one
/// (the lowest of several) at its points. Strings are numbered in alphabetical order. A cell array
/// goes before a point array of this name. Throws std::invalid_argument naming the array when it is
/// missing or not of that kind.
std::vector<std::int64_t> labelsFromArray(
  const PatchSurface& surface, vtkDataObject* input, const std::string& name);

/// For every face 1 + the index of the first node of the selection that holds it, 0 where none
/// does. Selected points select the cells around them.
std::vector<std::int64_t> labelsFromSelection(
  const PatchSurface& surface, vtkDataObject* input, vtkSelection* selection);
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureOutput_h
#define hachure_ViewTextureOutput_h

#include "Core/CellLayers.h"
#include "Core/CellMesh.h"
#include "Core/ViewTextureColors.h"
#include "SurfaceTriangles.h"

#include <glm/gtc/type_precision.hpp>

#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkTextureViews;

// The outputs of vtkViewDependentTexture.
namespace hachure
{

/// A level of cells, and what is known of all nodes.
struct ViewTextureCells
{
  const CellLayer& layer;
  const CellMesh& mesh;
  const ViewTextureColors& colors;
  const std::vector<std::vector<float>>& shares; ///< of every view
};

/// Of every cell the view with the largest share; -1: none.
std::vector<std::int32_t> mainViews(const ViewTextureCells& cells);

void attachCells(const ViewTextureCells& cells, vtkTextureViews* views,
  const std::vector<std::int32_t>& labels, vtkPolyData* output);
void attachBorders(
  const ViewTextureCells& cells, const std::vector<std::int32_t>& labels, vtkPolyData* output);
/// colors: of all points of the surface that was extracted from the input.
void attachPointColors(vtkDataObject* input, const SurfaceTriangles& surface,
  const std::vector<glm::u8vec4>& colors, vtkDataObject* output);

} // namespace hachure

#endif

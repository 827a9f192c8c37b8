// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// How a mapper draws the part of a surface that its process holds.

#include "vtkPatternMapper.h"

#include "vtkHachureCompatibility.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPatternBlocks.h"
#include "vtkPatternLayer.h"
#include "vtkPatternMapperInternals.h"
#include "vtkPatternStyle.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSurfacePart.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

void vtkPatternMapper::SetWholeSurface(vtkDataObject* surface)
{
  if (surface != this->WholeSurface)
  {
    this->WholeSurface = surface;
    this->Modified();
  }
}

vtkDataObject* vtkPatternMapper::GetWholeSurface()
{
  return this->WholeSurface;
}

vtkDataObject* vtkPatternMapper::GetSurfaceData()
{
  return this->WholeSurface ? this->WholeSurface.Get() : this->GetInputDataObject(0, 0);
}

void vtkPatternMapper::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkPatternMapper::GetController()
{
  return this->Controller;
}

double* vtkPatternMapper::GetBounds()
{
  if (!this->WholeSurface)
  {
    return this->Superclass::GetBounds();
  }
  vtkBoundingBox box;
  for (const vtkPattern::Block& block : vtkPattern::Blocks(this->WholeSurface))
  {
    if (block.Data->GetNumberOfPoints() > 0)
    {
      box.AddBounds(block.Data->GetBounds());
    }
  }
  vtkMath::UninitializeBounds(this->Bounds);
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkPatternMapper::UpdateSurroundings()
{
  this->Internal->Surroundings.clear();
  for (const vtkPattern::Block& block : vtkPattern::Blocks(this->GetInputDataObject(0, 0)))
  {
    if (vtkSurfacePart::IsSurroundings(block.Data))
    {
      this->Internal->Surroundings.emplace_back(block.Data);
    }
  }
  this->ShowSurroundings(false);
}

bool vtkPatternMapper::GetHasSurroundings() const
{
  return !this->Internal->Surroundings.empty();
}

// They are seen in the attribute images alone, where the block is that they go on with.
void vtkPatternMapper::ShowSurroundings(bool shown)
{
  if (this->Internal->Surroundings.empty())
  {
    return;
  }
  vtkCompositeDataDisplayAttributes* attributes = this->GetCompositeDataDisplayAttributes();
  if (!attributes)
  {
    vtkNew<vtkCompositeDataDisplayAttributes> own;
    this->SetCompositeDataDisplayAttributes(own);
    attributes = own;
  }
  const std::vector<bool> visible = shown
    ? vtkPattern::VisibleLeaves(this->GetInputDataObject(0, 0), attributes)
    : std::vector<bool>();
  for (vtkPolyData* block : this->Internal->Surroundings)
  {
    const auto leaf = static_cast<std::size_t>(vtkSurfacePart::GetSurroundedBlock(block));
    const bool show = leaf < visible.size() && visible[leaf];
    if (!attributes->HasBlockVisibility(block) || attributes->GetBlockVisibility(block) != show)
    {
      attributes->SetBlockVisibility(block, show);
      attributes->SetBlockPickability(block, false);
    }
  }
}

// Of the part of the surface that this process draws, with its surroundings.
const double* vtkPatternMapper::DrawnBounds()
{
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  if (!this->WholeSurface)
  {
    return this->GetBounds();
  }
  Internals& internal = *this->Internal;
  if (internal.DrawnInput != input || internal.DrawnTime != input->GetMTime())
  {
    vtkBoundingBox box;
    for (const vtkPattern::Block& block : vtkPattern::Blocks(input))
    {
      double bounds[6];
      block.Data->GetCellsBounds(bounds); // other parts have the same points
      if (vtkBoundingBox::IsValid(bounds))
      {
        box.AddBounds(bounds);
      }
    }
    vtkMath::UninitializeBounds(internal.DrawnBounds);
    if (box.IsValid())
    {
      box.GetBounds(internal.DrawnBounds);
    }
    internal.DrawnInput = input;
    internal.DrawnTime = input->GetMTime();
  }
  return internal.DrawnBounds;
}

double vtkPatternMapper::GetReach(vtkRenderer* renderer, vtkActor* actor)
{
  constexpr double outline = 8.0; // logical pixels, of a wide one
  double pixels = outline;
  for (int i = 0; this->Style && i < this->Style->GetNumberOfLayers(); ++i)
  {
    const double reach = this->Style->GetLayer(i)->GetReach(this->Style->GetDotsPerInch());
    pixels = std::max(pixels, reach);
  }
  const vtkBoundingBox box(this->GetBounds());
  if (!box.IsValid() || box.GetDiagonalLength() <= 0.0)
  {
    return 1.0;
  }
  glm::dvec4 center(1.0);
  box.GetCenter(&center[0]);
  const vtkPatternViewport viewport(renderer, this->Style ? this->Style->GetPixelScale() : 1.0);
  const hachure::ViewProjection view = viewport.View(renderer, actor);
  const double width = (view.viewToClip * view.modelToView * center).w; // 1 in parallel projection
  const double pixelsPerUnit = 0.5 * view.viewportSize.y * std::abs(view.viewToClip[1][1]) *
    std::cbrt(std::abs(glm::determinant(glm::dmat3(view.modelToView)))) / width;
  const double reach = pixels / (pixelsPerUnit * box.GetDiagonalLength());
  return reach > 0.0 ? std::min(reach, 1.0) : 1.0; // 1 where the camera is in the middle of it
}

// Pixels that a box can cover with what is drawn on it.
std::array<int, 4> vtkPatternMapper::Covered(
  const Drawing& drawing, const double bounds[6], int margin) const
{
  if (!vtkBoundingBox::IsValid(bounds))
  {
    return { 0, 0, 0, 0 };
  }
  const glm::dmat4 modelToClip = vtkPattern::DrawnProjection(drawing.Renderer) *
    vtkPattern::ModelView(drawing.Renderer, drawing.Actor);
  return vtkPattern::CoveredRectangle(bounds, modelToClip, drawing.Viewport.Drawn, margin);
}

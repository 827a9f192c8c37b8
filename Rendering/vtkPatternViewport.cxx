// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternViewport.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkProp3D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// The share of a window that both a viewport and a tile cover, as (min, max) along an axis.
glm::dvec2 Overlap(const double* viewport, const double* tile, int axis)
{
  const double lower = std::clamp(viewport[axis], tile[axis], tile[axis + 2]);
  const double upper = std::clamp(viewport[axis + 2], tile[axis], tile[axis + 2]);
  return { lower, upper };
}
} // namespace

vtkPatternViewport::vtkPatternViewport(vtkRenderer* renderer, double pixelScale)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  this->Drawn = { origin[0], origin[1], size[0], size[1] };

  const int* tileScale = window->GetTileScale();
  this->IsTile = tileScale[0] > 1 || tileScale[1] > 1;
  this->PixelsPerLogical = pixelScale * std::max(tileScale[0], tileScale[1]);

  const int* whole = window->GetSize(); // all tiles together
  const double* viewport = renderer->GetViewport();
  const double* tile = window->GetTileViewport();
  this->TileToWhole = glm::dvec4(1.0, 1.0, 0.0, 0.0);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double extent = viewport[axis + 2] - viewport[axis];
    const double corner = std::round(viewport[axis] * whole[axis]);
    const double tileCorner = std::round(tile[axis] * whole[axis]);
    this->FragmentToLogical[axis] = 1.0 / this->PixelsPerLogical;
    this->FragmentToLogical[axis + 2] = (tileCorner - corner) / this->PixelsPerLogical;
    this->LogicalSize[axis] = std::max(1.0, extent * whole[axis] / this->PixelsPerLogical);
    if (this->IsTile && extent > 0.0)
    {
      // Whoever draws tiles hands over a camera that sees the tile alone.
      const glm::dvec2 seen = Overlap(viewport, tile, axis);
      this->TileToWhole[axis] = (seen.y - seen.x) / extent;
      this->TileToWhole[axis + 2] =
        (seen.x + seen.y - viewport[axis] - viewport[axis + 2]) / extent;
    }
  }
}

void vtkPatternViewport::MoveTo(int left, int bottom)
{
  this->FragmentToLogical.z += this->FragmentToLogical.x * (this->Drawn[0] - left);
  this->FragmentToLogical.w += this->FragmentToLogical.y * (this->Drawn[1] - bottom);
  this->Drawn[0] = left;
  this->Drawn[1] = bottom;
}

hachure::ViewProjection vtkPatternViewport::Whole(
  const glm::dmat4& modelToView, glm::dmat4 projection) const
{
  for (int column = 0; column < 4; ++column)
  {
    glm::dvec4& entry = projection[column];
    entry.x = entry.x * this->TileToWhole.x + entry.w * this->TileToWhole.z;
    entry.y = entry.y * this->TileToWhole.y + entry.w * this->TileToWhole.w;
    // Samples have no use for depth, and the clipping range must not look like motion.
    entry.z = 0.0;
  }
  return { modelToView, projection, this->LogicalSize };
}

hachure::ViewProjection vtkPatternViewport::View(vtkRenderer* renderer, vtkProp3D* prop) const
{
  // The camera leaves stereo out of this matrix alone; always taken, so that switching stereo on
  // does not change a bit.
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 composite = vtkPattern::ToGlm(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  const glm::dmat4 view = vtkPattern::ToGlm(camera->GetViewTransformMatrix());
  return this->Whole(vtkPattern::ModelView(renderer, prop), composite * glm::inverse(view));
}

hachure::ViewProjection vtkPatternViewport::EyeView(vtkRenderer* renderer, vtkProp3D* prop) const
{
  return this->Whole(vtkPattern::ModelView(renderer, prop), vtkPattern::DrawnProjection(renderer));
}

namespace vtkPattern
{
glm::dmat4 ToGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

glm::dmat4 DrawnProjection(vtkRenderer* renderer)
{
  return ToGlm(renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0));
}

glm::dmat4 ModelView(vtkRenderer* renderer, vtkProp3D* prop)
{
  glm::dmat4 view = ToGlm(renderer->GetActiveCamera()->GetModelViewTransformMatrix());
  vtkMatrix4x4* model = prop ? prop->GetMatrix() : nullptr;
  return model ? view * ToGlm(model) : view;
}

std::array<int, 4> CoveredRectangle(const double bounds[6], const glm::dmat4& modelToClip,
  const std::array<int, 4>& viewport, int margin)
{
  glm::dvec2 lower(1.0);
  glm::dvec2 upper(-1.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 clip = modelToClip *
      glm::dvec4(
        bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + ((corner >> 2) & 1)], 1.0);
    if (clip.w <= 0.0)
    {
      return viewport;
    }
    const glm::dvec2 position(clip.x / clip.w, clip.y / clip.w);
    lower = glm::min(lower, position);
    upper = glm::max(upper, position);
  }
  lower = glm::clamp(lower, -1.0, 1.0);
  upper = glm::clamp(upper, -1.0, 1.0);
  if (lower.x >= upper.x || lower.y >= upper.y)
  {
    return { viewport[0], viewport[1], 0, 0 };
  }
  std::array<int, 4> rectangle;
  for (int axis = 0; axis < 2; ++axis)
  {
    const int size = viewport[2 + axis];
    const int begin =
      std::max(0, static_cast<int>(std::floor((lower[axis] * 0.5 + 0.5) * size)) - margin);
    const int end =
      std::min(size, static_cast<int>(std::ceil((upper[axis] * 0.5 + 0.5) * size)) + margin);
    rectangle[axis] = viewport[axis] + begin;
    rectangle[2 + axis] = end - begin;
  }
  return rectangle;
}

std::array<int, 4> Union(const std::array<int, 4>& a, const std::array<int, 4>& b)
{
  std::array<int, 4> both;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    both[axis] = std::min(a[axis], b[axis]);
    both[2 + axis] = std::max(a[axis] + a[2 + axis], b[axis] + b[2 + axis]) - both[axis];
  }
  return both;
}
} // namespace vtkPattern

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraView.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

namespace hachure
{
namespace
{
glm::dmat4 toMatrix(vtkMatrix4x4* matrix)
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
} // namespace

ViewProjection cameraView(vtkCamera* camera, const double viewportSize[2])
{
  ViewProjection view;
  view.modelToView = toMatrix(camera->GetModelViewTransformMatrix());
  view.viewToClip =
    toMatrix(camera->GetProjectionTransformMatrix(viewportSize[0] / viewportSize[1], -1.0, 1.0));
  view.viewportSize = { viewportSize[0], viewportSize[1] };
  return view;
}
} // namespace hachure

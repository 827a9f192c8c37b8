// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RendererView.h"

#include "TextureViewShapes.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureViews.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
// The factor by which a matrix makes everything longer; 0 where that depends on the direction, or
// where it mirrors.
double scaleOf(const glm::dmat4& matrix)
{
  const glm::dmat3 linear(matrix);
  const double scale = std::cbrt(glm::determinant(linear));
  const glm::dmat3 product = glm::transpose(linear) * linear;
  double error = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      error = std::max(error, std::abs(product[i][j] - (i == j ? scale * scale : 0.0)));
    }
  }
  return scale > 0.0 && error <= 1e-9 * scale * scale ? scale : 0.0;
}

// Whether position, focal point, view up and angle or scale say all of a camera.
bool isPlain(vtkCamera* camera)
{
  const double* center = camera->GetWindowCenter();
  double shear[3];
  camera->GetViewShear(shear);
  return center[0] == 0.0 && center[1] == 0.0 && shear[0] == 0.0 && shear[1] == 0.0 &&
    !camera->GetUseHorizontalViewAngle() && !camera->GetUseOffAxisProjection() &&
    !camera->GetUseExplicitProjectionTransformMatrix() && !camera->GetUserViewTransform() &&
    !camera->GetUserTransform();
}

vtkSmartPointer<vtkCamera> modelCamera(vtkCamera* camera, const glm::dmat4& worldToModel)
{
  auto result = vtkSmartPointer<vtkCamera>::New();
  const glm::dvec3 position = movedPoint(worldToModel, glm::make_vec3(camera->GetPosition()));
  const glm::dvec3 focus = movedPoint(worldToModel, glm::make_vec3(camera->GetFocalPoint()));
  const glm::dvec3 up = movedVector(worldToModel, glm::make_vec3(camera->GetViewUp()));
  result->SetPosition(glm::value_ptr(position));
  result->SetFocalPoint(glm::value_ptr(focus));
  result->SetViewUp(glm::value_ptr(up));
  result->SetViewAngle(camera->GetViewAngle());
  result->SetParallelProjection(camera->GetParallelProjection());
  result->SetParallelScale(camera->GetParallelScale() * scaleOf(worldToModel));
  return result;
}
} // namespace

vtkSmartPointer<vtkImageData> emptyPicture(vtkRenderer* renderer)
{
  const int* size = renderer->GetVTKWindow() ? renderer->GetSize() : nullptr;
  if (!size || size[0] < 1 || size[1] < 1)
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(bytes, 4 * image->GetNumberOfPoints(), static_cast<unsigned char>(0));
  return image;
}

vtkSmartPointer<vtkImageData> rendererPicture(vtkRenderer* renderer, vtkProp* without)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  vtkSmartPointer<vtkImageData> image = window ? emptyPicture(renderer) : nullptr;
  if (!image)
  {
    return image;
  }
  const bool visible = without && without->GetVisibility();
  if (visible)
  {
    without->VisibilityOff();
  }
  window->Render();
  const int* size = image->GetDimensions();
  const int* origin = renderer->GetOrigin();
  const int corner[2] = { origin[0] + size[0] - 1, origin[1] + size[1] - 1 };
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkFloatArray> depths;
  window->GetPixelData(origin[0], origin[1], corner[0], corner[1], 0, colors);
  window->GetZbufferData(origin[0], origin[1], corner[0], corner[1], depths);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  const vtkIdType count = std::min(
    { image->GetNumberOfPoints(), colors->GetNumberOfTuples(), depths->GetNumberOfTuples() });
  for (vtkIdType i = 0; i < count; ++i, bytes += 4)
  {
    if (depths->GetValue(i) < 1.0f)
    {
      std::copy_n(colors->GetPointer(3 * i), 3, bytes);
      bytes[3] = 255;
    }
  }
  if (visible)
  {
    without->VisibilityOn();
  }
  return image;
}

int addRendererView(vtkTextureViews* views, const std::string& name, vtkRenderer* renderer,
  const glm::dmat4& modelToWorld, vtkImageData* image)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (isPlain(camera) && scaleOf(modelToWorld) > 0.0)
  {
    return views->AddView(name, modelCamera(camera, glm::inverse(modelToWorld)), image);
  }
  vtkNew<vtkMatrix4x4> toClip;
  toClip->DeepCopy(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  const glm::dmat4 product = glm::transpose(matrixOf(toClip) * modelToWorld);
  toClip->DeepCopy(glm::value_ptr(product));
  return views->AddView(name, toClip, image);
}

} // namespace hachure

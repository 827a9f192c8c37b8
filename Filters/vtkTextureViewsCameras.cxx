// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// The cameras and matrices of views.

#include "vtkTextureViewsInternals.h"

#include <algorithm>
#include <cmath>

namespace
{

/** Clipping ranges of cameras, in distances of the focal point. */
constexpr double nearest = 0.01;
constexpr double farthest = 100.0;

hachure::ViewCamera numbersOf(vtkCamera* camera)
{
  hachure::ViewCamera result;
  camera->GetPosition(result.position);
  camera->GetFocalPoint(result.focalPoint);
  camera->GetViewUp(result.viewUp);
  result.parallel = camera->GetParallelProjection() != 0;
  result.viewAngle = camera->GetViewAngle();
  result.parallelScale = camera->GetParallelScale();
  return result;
}

vtkSmartPointer<vtkCamera> cameraOf(const hachure::ViewCamera& numbers)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(numbers.position);
  camera->SetFocalPoint(numbers.focalPoint);
  camera->SetViewUp(numbers.viewUp);
  camera->SetParallelProjection(numbers.parallel);
  camera->SetViewAngle(numbers.viewAngle);
  camera->SetParallelScale(numbers.parallelScale);
  const double distance = camera->GetDistance();
  camera->SetClippingRange(nearest * distance, farthest * distance);
  return camera;
}

bool equal(const double one[3], const double other[3])
{
  return std::equal(one, one + 3, other);
}

/** Determinant of three rows without a column. */
double minor(const double* rows[3], int without)
{
  const int c[3] = { without > 0 ? 0 : 1, without > 1 ? 1 : 2, without > 2 ? 2 : 3 };
  return rows[0][c[0]] * (rows[1][c[1]] * rows[2][c[2]] - rows[1][c[2]] * rows[2][c[1]]) -
    rows[0][c[1]] * (rows[1][c[0]] * rows[2][c[2]] - rows[1][c[2]] * rows[2][c[0]]) +
    rows[0][c[2]] * (rows[1][c[0]] * rows[2][c[1]] - rows[1][c[1]] * rows[2][c[0]]);
}

/** The point that x, y and w of a matrix take to 0. */
void eyeOf(const double* matrix, double eye[4])
{
  const double* rows[3] = { matrix, matrix + 4, matrix + 12 };
  for (int i = 0; i < 4; ++i)
  {
    eye[i] = (i % 2 == 0 ? 1.0 : -1.0) * minor(rows, i);
  }
  const bool parallel = rows[2][0] == 0.0 && rows[2][1] == 0.0 && rows[2][2] == 0.0;
  double scale = eye[3];
  if (parallel)
  {
    const double* depth = matrix + 8;
    const double deeper = (depth[0] * eye[0] + depth[1] * eye[1] + depth[2] * eye[2]) / rows[2][3];
    scale = std::copysign(std::hypot(eye[0], eye[1], eye[2]), -deeper);
    eye[3] = 0.0;
  }
  for (int i = 0; i < 4; ++i)
  {
    eye[i] /= scale;
  }
}

} // namespace

//------------------------------------------------------------------------------
bool vtkTextureViews::View::sameCamera(const View& other) const
{
  if (hachure::aspect(this->picture.data) != hachure::aspect(other.picture.data) ||
    !this->matrix != !other.matrix)
  {
    return false;
  }
  if (this->matrix)
  {
    return std::equal(
      this->matrix->GetData(), this->matrix->GetData() + 16, other.matrix->GetData());
  }
  const hachure::ViewCamera& one = this->camera;
  const hachure::ViewCamera& two = other.camera;
  return equal(one.position, two.position) && equal(one.focalPoint, two.focalPoint) &&
    equal(one.viewUp, two.viewUp) && one.parallel == two.parallel &&
    (one.parallel ? one.parallelScale == two.parallelScale : one.viewAngle == two.viewAngle);
}

//------------------------------------------------------------------------------
bool vtkTextureViews::TakeCamera(View& view, vtkCamera* camera, const char* caller)
{
  if (this->Refuses(caller, camera ? "" : "expected a camera, got null"))
  {
    return false;
  }
  const hachure::ViewCamera numbers = numbersOf(camera);
  if (this->Refuses(caller, hachure::cameraFault(numbers)))
  {
    return false;
  }
  view.camera = numbers;
  view.matrix = nullptr;
  view.cameraTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViews::TakeMatrix(View& view, vtkMatrix4x4* matrix, const char* caller)
{
  if (this->Refuses(caller, hachure::matrixFault(matrix)))
  {
    return false;
  }
  view.matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  view.matrix->DeepCopy(matrix);
  view.cameraTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewCamera(int view, vtkCamera* camera)
{
  View* found = this->ViewAt(view, "SetViewCamera");
  if (found && this->TakeCamera(*found, camera, "SetViewCamera"))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkTextureViews::GetViewCamera(int view)
{
  View* found = this->ViewAt(view, "GetViewCamera");
  if (!found || found->matrix)
  {
    return nullptr;
  }
  found->shownCamera = cameraOf(found->camera);
  return found->shownCamera;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewMatrix(int view, vtkMatrix4x4* modelToClip)
{
  View* found = this->ViewAt(view, "SetViewMatrix");
  if (found && this->TakeMatrix(*found, modelToClip, "SetViewMatrix"))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkTextureViews::GetViewMatrix(int view)
{
  View* found = this->ViewAt(view, "GetViewMatrix");
  if (!found || !found->matrix)
  {
    return nullptr;
  }
  found->shownMatrix = vtkSmartPointer<vtkMatrix4x4>::New();
  found->shownMatrix->DeepCopy(found->matrix);
  return found->shownMatrix;
}

//------------------------------------------------------------------------------
void vtkTextureViews::SetViewUp(int view, const double viewUp[3])
{
  View* found = this->ViewAt(view, "SetViewUp");
  if (!found || this->Refuses("SetViewUp", found->matrix ? "the view has a matrix" : ""))
  {
    return;
  }
  hachure::ViewCamera turned = found->camera;
  std::copy_n(viewUp, 3, turned.viewUp);
  if (!this->Refuses("SetViewUp", hachure::cameraFault(turned)) &&
    !equal(viewUp, found->camera.viewUp))
  {
    found->camera = turned;
    found->cameraTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTextureViews::GetViewUp(int view, double viewUp[3])
{
  const View* found = this->ViewAt(view, "GetViewUp");
  std::fill_n(viewUp, 3, 0.0);
  if (found && !this->Refuses("GetViewUp", found->matrix ? "the view has a matrix" : ""))
  {
    std::copy_n(found->camera.viewUp, 3, viewUp);
  }
}

//------------------------------------------------------------------------------
bool vtkTextureViews::ComputeModelToClip(int view, vtkMatrix4x4* result)
{
  View* found = this->ViewAt(view, "ComputeModelToClip");
  if (!found || this->Refuses("ComputeModelToClip", result ? "" : "expected a matrix, got null"))
  {
    return false;
  }
  if (found->matrix)
  {
    result->DeepCopy(found->matrix);
    return true;
  }
  const double aspect = hachure::aspect(found->picture.data);
  result->DeepCopy(
    cameraOf(found->camera)->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
  return true;
}

//------------------------------------------------------------------------------
bool vtkTextureViews::ComputeEye(int view, double eye[4])
{
  const View* found = this->ViewAt(view, "ComputeEye");
  std::fill_n(eye, 4, 0.0);
  if (!found)
  {
    return false;
  }
  if (found->matrix)
  {
    eyeOf(found->matrix->GetData(), eye);
  }
  else if (found->camera.parallel)
  {
    cameraOf(found->camera)->GetDirectionOfProjection(eye);
    std::for_each(eye, eye + 3, [](double& number) { number = -number; });
  }
  else
  {
    std::copy_n(found->camera.position, 3, eye);
    eye[3] = 1.0;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTextureViews::GetViewCameraMTime(int view)
{
  const View* found = this->ViewAt(view, "GetViewCameraMTime");
  return found ? found->cameraTime.GetMTime() : 0;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternMotion.h"

#include "Parallel.h"
#include "ScreenMotion.h"
#include "vtkCamera.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternMotionGeometry.h"
#include "vtkPatternTriangleIds.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPatternMotion);

namespace
{
constexpr int before = vtkPatternMotionGeometry::Before;
constexpr int after = vtkPatternMotionGeometry::After;
constexpr const char* componentNames[] = { "u", "v", "visible", "facing", "distance", "label" };
static_assert(
  sizeof(hachure::PixelMotion) == vtkPatternMotion::NUMBER_OF_COMPONENTS * sizeof(float),
  "a pixel of the core is a pixel of the image");

glm::dmat4 ToMatrix(vtkMatrix4x4* matrix)
{
  glm::dmat4 result(1.0);
  for (int i = 0; matrix && i < 16; ++i)
  {
    result[i % 4][i / 4] = matrix->GetElement(i / 4, i % 4);
  }
  return result;
}

vtkSmartPointer<vtkCamera> Copy(vtkCamera* camera)
{
  vtkSmartPointer<vtkCamera> copy;
  if (camera)
  {
    copy = vtkSmartPointer<vtkCamera>::New();
    copy->DeepCopy(camera);
  }
  return copy;
}

std::string Describe(vtkDataObject* data)
{
  return data ? data->GetClassName() : "nothing";
}

void CheckData(const std::string& name, vtkDataObject* data)
{
  if (!vtkPolyData::SafeDownCast(data) && !vtkCompositeDataSet::SafeDownCast(data))
  {
    throw std::invalid_argument(
      name + " is " + Describe(data) + ", expected vtkPolyData or a composite of it");
  }
}

vtkSmartPointer<vtkImageData> ToImage(const std::vector<hachure::PixelMotion>& pixels, int width)
{
  vtkNew<vtkFloatArray> array;
  array->SetName("Motion");
  array->SetNumberOfComponents(vtkPatternMotion::NUMBER_OF_COMPONENTS);
  array->SetNumberOfTuples(static_cast<vtkIdType>(pixels.size()));
  for (int i = 0; i < vtkPatternMotion::NUMBER_OF_COMPONENTS; ++i)
  {
    array->SetComponentName(i, componentNames[i]);
  }
  std::memcpy(array->GetPointer(0), pixels.data(), pixels.size() * sizeof(pixels[0]));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, static_cast<int>(pixels.size()) / width, 1);
  image->GetPointData()->SetScalars(array);
  return image;
}
} // namespace

struct vtkPatternMotion::Internals
{
  vtkSmartPointer<vtkCamera> Cameras[2];
  std::vector<vtkPatternMotionGeometry::Surface> Surfaces; // ToView: to the scene only
  int Labels = 0;
  int Occluders = 0;
  vtkSmartPointer<vtkImageData> Output;

  void Add(const std::string& name, int label, vtkDataObject* dataBefore, vtkDataObject* dataAfter,
    vtkMatrix4x4* matrixBefore, vtkMatrix4x4* matrixAfter)
  {
    this->Surfaces.push_back({ name, label, { dataBefore, dataAfter ? dataAfter : dataBefore },
      { ToMatrix(matrixBefore), ToMatrix(matrixAfter ? matrixAfter : matrixBefore) } });
  }

  void CheckCameras() const;
  vtkPatternMotionGeometry Gather() const;
  hachure::MotionState State(
    const vtkPatternMotionGeometry& geometry, int state, const glm::ivec2& size) const;
};

void vtkPatternMotion::Internals::CheckCameras() const
{
  for (int state : { before, after })
  {
    if (!this->Cameras[state])
    {
      throw std::invalid_argument(
        std::string(state == before ? "CameraBefore" : "CameraAfter") + " is not set");
    }
  }
}

vtkPatternMotionGeometry vtkPatternMotion::Internals::Gather() const
{
  vtkPatternMotionGeometry geometry;
  for (vtkPatternMotionGeometry::Surface surface : this->Surfaces)
  {
    CheckData(surface.Name + " before", surface.Data[before]);
    CheckData(surface.Name + " after", surface.Data[after]);
    for (int state : { before, after })
    {
      surface.ToView[state] =
        ToMatrix(this->Cameras[state]->GetModelViewTransformMatrix()) * surface.ToView[state];
    }
    geometry.Append(surface);
  }
  return geometry;
}

hachure::MotionState vtkPatternMotion::Internals::State(
  const vtkPatternMotionGeometry& geometry, int state, const glm::ivec2& size) const
{
  const double aspect = static_cast<double>(size.x) / size.y;
  hachure::MotionState result;
  result.points = geometry.Points[state];
  result.viewToClip =
    ToMatrix(this->Cameras[state]->GetProjectionTransformMatrix(aspect, -1.0, 1.0));
  return result;
}

namespace
{
vtkOpenGLRenderWindow* UsableWindow(vtkRenderWindow* window, const glm::ivec2& size)
{
  auto* usable = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!usable)
  {
    throw std::invalid_argument(std::string("window is ") +
      (window ? window->GetClassName() : "nothing") + ", expected a vtkOpenGLRenderWindow");
  }
  if (size.x < 1 || size.y < 1)
  {
    throw std::invalid_argument("Size is " + std::to_string(size.x) + " x " +
      std::to_string(size.y) + ", expected at least 1 x 1");
  }
  usable->Initialize();
  usable->MakeCurrent();
  const int largest = vtkTextureObject::GetMaximumTextureSize(usable);
  if (size.x > largest || size.y > largest)
  {
    throw std::invalid_argument("Size is " + std::to_string(size.x) + " x " +
      std::to_string(size.y) + ", expected at most " + std::to_string(largest) + " each");
  }
  return usable;
}

std::vector<std::int32_t> SeenTriangles(vtkOpenGLRenderWindow* window,
  const hachure::MotionState& state, const std::vector<glm::ivec3>& triangles,
  const glm::ivec2& size)
{
  std::vector<glm::dvec4> clip(state.points.size());
  hachure::parallelFor(static_cast<std::int64_t>(clip.size()),
    [&](std::int64_t i)
    {
      const auto point = static_cast<std::size_t>(i);
      clip[point] = state.viewToClip * glm::dvec4(state.points[point], 1.0);
    });
  return vtkPattern::DrawTriangleIds(window, clip, triangles, size);
}
} // namespace

//------------------------------------------------------------------------------
vtkPatternMotion::vtkPatternMotion()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkPatternMotion::~vtkPatternMotion() = default;

//------------------------------------------------------------------------------
void vtkPatternMotion::SetCameraBefore(vtkCamera* camera)
{
  this->Internal->Cameras[before] = Copy(camera);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkCamera* vtkPatternMotion::GetCameraBefore()
{
  return this->Internal->Cameras[before];
}

//------------------------------------------------------------------------------
void vtkPatternMotion::SetCameraAfter(vtkCamera* camera)
{
  this->Internal->Cameras[after] = Copy(camera);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkCamera* vtkPatternMotion::GetCameraAfter()
{
  return this->Internal->Cameras[after];
}

//------------------------------------------------------------------------------
int vtkPatternMotion::AddSurface(vtkDataObject* dataBefore, vtkDataObject* dataAfter,
  vtkMatrix4x4* matrixBefore, vtkMatrix4x4* matrixAfter)
{
  const int label = ++this->Internal->Labels;
  this->Internal->Add(
    "surface " + std::to_string(label), label, dataBefore, dataAfter, matrixBefore, matrixAfter);
  this->Modified();
  return label;
}

//------------------------------------------------------------------------------
void vtkPatternMotion::AddOccluder(vtkDataObject* dataBefore, vtkDataObject* dataAfter,
  vtkMatrix4x4* matrixBefore, vtkMatrix4x4* matrixAfter)
{
  const int number = ++this->Internal->Occluders;
  this->Internal->Add(
    "occluder " + std::to_string(number), 0, dataBefore, dataAfter, matrixBefore, matrixAfter);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternMotion::RemoveAllSurfaces()
{
  this->Internal->Surfaces.clear();
  this->Internal->Labels = 0;
  this->Internal->Occluders = 0;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPatternMotion::GetNumberOfSurfaces()
{
  return this->Internal->Labels;
}

//------------------------------------------------------------------------------
bool vtkPatternMotion::Compute(vtkRenderWindow* renderWindow)
{
  this->Internal->Output = nullptr;
  try
  {
    const glm::ivec2 size(this->Size[0], this->Size[1]);
    this->Internal->CheckCameras();
    vtkOpenGLRenderWindow* window = UsableWindow(renderWindow, size);
    const vtkPatternMotionGeometry geometry = this->Internal->Gather();

    hachure::MotionScene scene;
    scene.before = this->Internal->State(geometry, before, size);
    scene.after = this->Internal->State(geometry, after, size);
    scene.triangles = geometry.Triangles;
    scene.labels = geometry.Labels;
    scene.normals = geometry.Normals;
    scene.size = size;
    const auto seenBefore = SeenTriangles(window, scene.before, geometry.Triangles, size);
    const auto seenAfter = SeenTriangles(window, scene.after, geometry.Triangles, size);
    scene.before.seen = seenBefore;
    scene.after.seen = seenAfter;
    this->Internal->Output = ToImage(hachure::screenMotion(scene), size.x);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  this->Modified();
  return this->Internal->Output != nullptr;
}

//------------------------------------------------------------------------------
vtkImageData* vtkPatternMotion::GetOutput()
{
  return this->Internal->Output;
}

//------------------------------------------------------------------------------
void vtkPatternMotion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CameraBefore: " << this->GetCameraBefore() << "\n";
  os << indent << "CameraAfter: " << this->GetCameraAfter() << "\n";
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "Surfaces: " << this->Internal->Labels << "\n";
  os << indent << "Occluders: " << this->Internal->Occluders << "\n";
  os << indent << "Output: " << this->GetOutput() << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewDrawing.h"

#include "CameraLights.h"
#include "DrawingWindow.h"
#include "ErrorCollector.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace hachure::program
{
namespace
{
/// Depths from 0 to this are distances, the next one is no surface.
constexpr double Farthest = 65534.0;
constexpr std::uint16_t NoSurface = 65535;

vtkSmartPointer<vtkImageData> makeImage(const std::array<int, 2>& size, int type, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(type, components);
  return image;
}

/// Distance along the direction of view of a value of the depth buffer.
double distanceOf(double depth, vtkCamera* camera)
{
  const double near = camera->GetClippingRange()[0];
  const double far = camera->GetClippingRange()[1];
  return camera->GetParallelProjection() ? near + depth * (far - near)
                                         : near * far / (far - depth * (far - near));
}

/// Distances of pixels, negative where there is no surface.
std::vector<double> distances(vtkFloatArray* buffer, vtkCamera* camera)
{
  std::vector<double> result(static_cast<std::size_t>(buffer->GetNumberOfValues()), -1.0);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const double depth = buffer->GetValue(static_cast<vtkIdType>(i));
    result[i] = depth < 1.0 ? distanceOf(depth, camera) : -1.0;
  }
  return result;
}

/// The range of distances there are, wide enough to be divided.
std::array<double, 2> rangeOf(const std::vector<double>& distances)
{
  double least = std::numeric_limits<double>::max();
  double most = 0.0;
  for (const double distance : distances)
  {
    least = distance >= 0.0 ? std::min(least, distance) : least;
    most = std::max(most, distance);
  }
  if (least > most) // no surface
  {
    return { 0.0, 1.0 };
  }
  return { least, std::max(most, least * (1.0 + 1e-6)) };
}

void fill(DrawnView& view, const unsigned char* colors, const std::vector<double>& distances)
{
  auto* picture = static_cast<unsigned char*>(view.picture->GetScalarPointer());
  auto* mask = static_cast<unsigned char*>(view.mask->GetScalarPointer());
  auto* depth = static_cast<std::uint16_t*>(view.depth->GetScalarPointer());
  const double scale = Farthest / (view.depthRange[1] - view.depthRange[0]);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const bool covered = distances[i] >= 0.0;
    const double level = (distances[i] - view.depthRange[0]) * scale;
    std::copy_n(colors + 3 * i, 3, picture + 4 * i);
    mask[i] = covered ? 255 : 0;
    picture[4 * i + 3] = mask[i];
    depth[i] = covered ? static_cast<std::uint16_t>(std::lround(level)) : NoSurface;
  }
}
} // namespace

//----------------------------------------------------------------------------
ViewDrawing::ViewDrawing(const Surface& surface, const std::array<double, 2>& light)
  : window(makeDrawingWindow())
{
  for (vtkPolyData* leaf : surfaceLeaves(surface.data))
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(leaf);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.0);
    actor->GetProperty()->SetDiffuse(1.0);
    actor->GetProperty()->SetSpecular(0.0);
    this->renderer->AddActor(actor);
  }
  this->renderer->SetBackground(1.0, 1.0, 1.0);
  this->renderer->AutomaticLightCreationOff();
  lightFrom(this->renderer, keyAndFill(light));
  this->window->AddRenderer(this->renderer);
}

//----------------------------------------------------------------------------
DrawnView ViewDrawing::draw(vtkCamera* camera, const std::array<int, 2>& size)
{
  const ErrorCollector errors;
  this->window->SetSize(size[0], size[1]);
  this->renderer->SetActiveCamera(camera);
  this->renderer->ResetCameraClippingRange();
  this->window->Render();
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkFloatArray> buffer;
  this->window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, colors);
  this->window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, buffer);
  const vtkIdType count = static_cast<vtkIdType>(size[0]) * size[1];
  if (errors.first().empty() &&
    (colors->GetNumberOfValues() != 3 * count || buffer->GetNumberOfValues() != count))
  {
    throw std::runtime_error("drawing failed: the window has another size");
  }
  if (!errors.first().empty())
  {
    throw std::runtime_error("drawing failed: " + errors.first());
  }
  DrawnView view;
  const std::vector<double> found = distances(buffer, camera);
  view.isEmpty = std::all_of(found.begin(), found.end(), [](double one) { return one < 0.0; });
  view.depthRange = rangeOf(found);
  view.picture = makeImage(size, VTK_UNSIGNED_CHAR, 4);
  view.mask = makeImage(size, VTK_UNSIGNED_CHAR, 1);
  view.depth = makeImage(size, VTK_UNSIGNED_SHORT, 1);
  fill(view, colors->GetPointer(0), found);
  return view;
}
} // namespace hachure::program

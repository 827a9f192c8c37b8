// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BenchmarkViews.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPatternStyle.h>
#include <vtkPolyData.h>
#include <vtkTextureViews.h>
#include <vtkViewTextureLayer.h>

#include <cmath>

namespace hachure::benchmark
{
namespace
{
constexpr int ImageSize = 512;
constexpr double ExtremeAngle = 50.0; // degrees

/// Waves of another frequency for every view.
vtkSmartPointer<vtkImageData> makeImage(int view)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(ImageSize, ImageSize, 1);
  constexpr int Components = 3;
  image->AllocateScalars(VTK_UNSIGNED_CHAR, Components);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < ImageSize; ++y)
  {
    for (int x = 0; x < ImageSize; ++x)
    {
      for (int i = 0; i < Components; ++i)
      {
        const double phase = 0.05 * ((view + 1) * x + (i + 1) * y);
        *value++ = static_cast<unsigned char>(128.0 + 100.0 * std::sin(phase));
      }
    }
  }
  return image;
}

/// From a side of the surface; axis 0 to 2, in or against its direction.
vtkSmartPointer<vtkCamera> makeCamera(vtkPolyData* surface, int axis, double sign)
{
  double center[3];
  surface->GetCenter(center);
  const double distance = 2.0 * surface->GetLength();
  double position[3] = { center[0], center[1], center[2] };
  position[axis] += sign * distance;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(center);
  camera->SetPosition(position);
  camera->SetViewUp(axis == 1 ? 1.0 : 0.0, axis == 1 ? 0.0 : 1.0, 0.0);
  return camera;
}

void addExtremes(vtkTextureViews* views, int view, vtkCamera* from)
{
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkCamera> camera;
    camera->DeepCopy(from);
    const double angle = i % 2 == 0 ? ExtremeAngle : -ExtremeAngle;
    if (i < 2)
    {
      camera->Azimuth(angle);
    }
    else
    {
      camera->Elevation(angle);
    }
    views->AddExtremePoint(view, camera->GetPosition());
  }
}
} // namespace

//----------------------------------------------------------------------------
void addViews(vtkPatternStyle* style, vtkPolyData* surface)
{
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    auto* layer = vtkViewTextureLayer::SafeDownCast(style->GetLayer(i));
    vtkTextureViews* views = layer ? layer->GetViews() : nullptr;
    if (!views || views->GetNumberOfViews() > 0)
    {
      continue;
    }
    for (int side = 0; side < 6; ++side)
    {
      const auto camera = makeCamera(surface, side / 2, side % 2 == 0 ? 1.0 : -1.0);
      views->AddView("independent", camera, makeImage(side));
      if (side / 2 != 1)
      {
        const int view = views->AddView("dependent", camera, makeImage(side + 6));
        views->SetViewKind(view, vtkTextureViews::DEPENDENT);
        addExtremes(views, view, camera);
      }
    }
  }
}
} // namespace hachure::benchmark

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "WaveletSurface.h"

#include "vtkPatchBlendWeights.h"
#include "vtkSurfacePatches.h"

#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>
#include <vtkRTAnalyticSource.h>

#include <algorithm>
#include <cmath>

namespace hachure::benchmark
{
namespace
{
/// In the middle of the wavelet's values: a rich shape with holes that hides parts of itself.
constexpr double Isovalue = 157.0;
constexpr int FirstRadius = 16;
constexpr int SmallestRadius = 4;
/// Steps in which the grid is matched: the count grows with the square of the grid's fineness, but
/// only where the grid resolves the waves.
constexpr int LargestSteps = 5;
constexpr double Tolerance = 0.03;

vtkSmartPointer<vtkPolyData> surfaceOfGrid(int radius)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-radius, radius, -radius, radius, -radius, radius);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(wavelet->GetOutputPort());
  contour->SetValue(0, Isovalue);
  contour->ComputeNormalsOn();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}
} // namespace

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> waveletSurface(int triangles)
{
  int radius = FirstRadius;
  vtkSmartPointer<vtkPolyData> surface;
  for (int step = 0; step < LargestSteps; ++step)
  {
    surface = surfaceOfGrid(radius);
    const double part = static_cast<double>(triangles) / surface->GetNumberOfPolys();
    const int next =
      std::max(SmallestRadius, static_cast<int>(std::lround(radius * std::sqrt(part))));
    if (std::abs(part - 1.0) < Tolerance || next == radius)
    {
      break;
    }
    radius = next;
  }
  vtkNew<vtkPolyData> result;
  result->ShallowCopy(surface); // without the pipeline and its grid
  return result;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> inPatches(vtkPolyData* surface, int patches)
{
  vtkNew<vtkSurfacePatches> cut;
  cut->SetInputData(surface);
  cut->SetMethod(vtkSurfacePatches::AUTOMATIC);
  cut->SetNumberOfPatches(patches);
  vtkNew<vtkPatchBlendWeights> blend;
  blend->SetInputConnection(cut->GetOutputPort());
  blend->Update();
  return vtkPolyData::SafeDownCast(blend->GetOutputDataObject(0));
}
} // namespace hachure::benchmark

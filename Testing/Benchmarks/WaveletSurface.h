// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The surface that is drawn.

#ifndef WaveletSurface_h
#define WaveletSurface_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace hachure::benchmark
{
/// An isosurface of VTK's wavelet with point normals and about so many triangles. The finer the
/// grid, the more triangles; the shape stays.
vtkSmartPointer<vtkPolyData> waveletSurface(int triangles);
/// The surface with the arrays of so many patches and of their blending weights.
vtkSmartPointer<vtkPolyData> inPatches(vtkPolyData* surface, int patches);
} // namespace hachure::benchmark

#endif

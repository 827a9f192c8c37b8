// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceLeaves_h
#define hachure_SurfaceLeaves_h

#include "HachureFiltersModule.h" // for the export macro

#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace hachure
{
/// A vtkPolyData itself, or the leaves of a composite in its order; null where a leaf is missing or
/// something else. Other data have none.
HACHUREFILTERS_EXPORT std::vector<vtkPolyData*> surfaceLeaves(vtkDataObject* surface);

/// The surface with the same structure and other leaves, null ones staying empty.
HACHUREFILTERS_EXPORT vtkSmartPointer<vtkDataObject> withLeaves(
  vtkDataObject* surface, const std::vector<vtkSmartPointer<vtkPolyData>>& leaves);

/// The time of the data, where there is one.
HACHUREFILTERS_EXPORT void copyDataTime(vtkDataObject* from, vtkDataObject* to);
} // namespace hachure

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What of a mapper's input is drawn.
 */
#ifndef vtkPatternDrawnSurface_h
#define vtkPatternDrawnSurface_h

#include "vtkSmartPointer.h"

class vtkActor;
class vtkDataObject;
class vtkPatternMapper;

namespace vtkPattern
{
/// The input without hidden blocks and without what clipping planes cut off; null without an input.
vtkSmartPointer<vtkDataObject> DrawnSurface(vtkPatternMapper* mapper, vtkActor* actor);
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternDrawnSurface.h

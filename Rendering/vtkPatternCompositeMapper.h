// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The composite polydata mapper family that vtkPatternMapper derives from.
 *
 * One helper per kind of vertex layout draws the blocks: vtkCompositeMapperHelper2 until VTK 9.2.
 */
#ifndef vtkPatternCompositeMapper_h
#define vtkPatternCompositeMapper_h

#include "vtkCompositePolyDataMapper2.h"

class vtkCompositeMapperHelper2;
class vtkCompositeMapperHelperData;

using vtkPatternHelperBase = vtkCompositeMapperHelper2;
using vtkPatternHelperData = vtkCompositeMapperHelperData;

#endif

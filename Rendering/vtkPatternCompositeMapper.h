// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The composite polydata mapper family that vtkPatternMapper derives from.
 *
 * Until VTK 9.2 vtkCompositePolyDataMapper2 draws the blocks of one vertex layout with a
 * vtkCompositeMapperHelper2. From VTK 9.3 on vtkCompositePolyDataMapper hands them to a delegator,
 * which draws them with a vtkOpenGLBatchedPolyDataMapper. vtkHachureCompatibility.h has the rest.
 *
 * The superclass is a macro because VTK's wrappers see through macros but not through aliases.
 */
#ifndef vtkPatternCompositeMapper_h
#define vtkPatternCompositeMapper_h

#ifdef __VTK_WRAP__
// The wrappers know no __has_include; they pass over a header that is not there.
#include "vtkCompositePolyDataMapperDelegator.h"
#elif __has_include("vtkCompositePolyDataMapperDelegator.h")
#include "vtkCompositePolyDataMapperDelegator.h"
#endif

#ifdef vtkCompositePolyDataMapperDelegator_h
#define VTK_PATTERN_MAPPER_HAS_DELEGATOR
#define VTK_PATTERN_MAPPER_SUPERCLASS vtkCompositePolyDataMapper
#include "vtkCompositePolyDataMapper.h"
#else
#define VTK_PATTERN_MAPPER_SUPERCLASS vtkCompositePolyDataMapper2
#include "vtkCompositePolyDataMapper2.h"

class vtkCompositeMapperHelper2;
class vtkCompositeMapperHelperData;
using vtkPatternHelperBase = vtkCompositeMapperHelper2;
using vtkPatternHelperData = vtkCompositeMapperHelperData;
#endif

#endif

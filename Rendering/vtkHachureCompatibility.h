// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Every difference between VTK versions that Hachure must bridge, in one place.
 *
 * Guards test for headers, not for version numbers: the VTK inside ParaView calls itself newer
 * than the features it has.
 */
#ifndef vtkHachureCompatibility_h
#define vtkHachureCompatibility_h

// The OpenGL loader: GLEW until VTK 9.3, GLAD afterwards.
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#elif __has_include("vtk_glew.h")
#include "vtk_glew.h"
#else
#error "Hachure needs VTK's OpenGL loader: vtk_glad.h or vtk_glew.h"
#endif

// Compute shaders (OpenGL 4.3), for which VTK has no classes. The loader knows the functions;
// whether the current context has them is known when the program runs.
inline bool vtkHachureHasComputeShaders()
{
#if defined(GL_COMPUTE_SHADER) && defined(glDispatchCompute)
  int major = 0;
  int minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return 10 * major + minor >= 43 && glDispatchCompute && glMemoryBarrier && glBindImageTexture;
#else
  return false;
#endif
}

// What draws the blocks of one vertex layout, see vtkPatternCompositeMapper.h.
#if __has_include("vtkCompositePolyDataMapperDelegator.h")
#include "vtkCompositePolyDataMapper.h"
#include "vtkOpenGLBatchedPolyDataMapper.h"
#include "vtkOpenGLCompositePolyDataMapperDelegator.h"
using vtkPatternHelperBase = vtkOpenGLBatchedPolyDataMapper;
using vtkPatternHelperData = vtkOpenGLBatchedPolyDataMapper::GLBatchElement;
inline vtkPolyData* vtkPatternHelperPolyData(const vtkPatternHelperData* data)
{
  return data->Parent.PolyData;
}
#else
#include "vtkColor.h" // which the next header needs and does not include

#include "vtkCompositeMapperHelper2.h"
using vtkPatternHelperBase = vtkCompositeMapperHelper2;
using vtkPatternHelperData = vtkCompositeMapperHelperData;
inline vtkPolyData* vtkPatternHelperPolyData(const vtkPatternHelperData* data)
{
  return data->Data;
}
#endif

// Inline namespaces arrived with VTK 9.2; older versions know no macro for them.
#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif

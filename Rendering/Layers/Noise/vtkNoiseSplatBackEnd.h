// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sums of a noise as the paper makes them: a square per kernel, added up by blending. The reference
 * for the others, which are faster.
 */
#ifndef vtkNoiseSplatBackEnd_h
#define vtkNoiseSplatBackEnd_h

#include "vtkNoiseGpuBackEnd.h"
#include "vtkOpenGLVertexArrayObject.h"

class vtkNoiseSplatBackEnd : public vtkNoiseGpuBackEnd
{
public:
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  bool Sum(vtkOpenGLRenderWindow* window, const Task& task) override;

private:
  vtkNew<vtkOpenGLVertexArrayObject> Vertices; // none: squares are made in the shader
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseSplatBackEnd.h

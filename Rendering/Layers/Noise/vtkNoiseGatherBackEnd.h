// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sums of a noise by a shader in which every pixel reads the kernels of its tile from buffers
 * (OpenGL 3.2).
 */
#ifndef vtkNoiseGatherBackEnd_h
#define vtkNoiseGatherBackEnd_h

#include "vtkNoiseGpuBackEnd.h"

class vtkNoiseGatherBackEnd : public vtkNoiseGpuBackEnd
{
public:
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  bool Sum(vtkOpenGLRenderWindow* window, const Task& task) override;

private:
  vtkPatternQuad Quad;
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseGatherBackEnd.h

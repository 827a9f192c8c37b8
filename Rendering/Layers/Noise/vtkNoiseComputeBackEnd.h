// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sums of a noise by a compute shader, whose groups load the kernels of a tile into shared memory
 * (OpenGL 4.3).
 */
#ifndef vtkNoiseComputeBackEnd_h
#define vtkNoiseComputeBackEnd_h

#include "vtkNoiseGpuBackEnd.h"

class vtkNoiseComputeBackEnd : public vtkNoiseGpuBackEnd
{
public:
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  bool Sum(vtkOpenGLRenderWindow* window, const Task& task) override;

private:
  unsigned int Prepare(hachure::NoiseKind kind);

  unsigned int Program = 0;
  std::string Text; // that it was made of
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseComputeBackEnd.h

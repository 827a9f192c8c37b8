// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseGatherBackEnd.h"

#include "NoiseGatherFS.h"

bool vtkNoiseGatherBackEnd::Sum(vtkOpenGLRenderWindow* window, const Task& task)
{
  return this->DrawQuad(window, this->Quad,
    vtkNoiseKernelBuffers::Text(NoiseGatherFS, Stage::Gather, task.Field.kind), this->Inputs(task));
}

void vtkNoiseGatherBackEnd::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.ReleaseGraphicsResources(window);
  this->vtkNoiseGpuBackEnd::ReleaseGraphicsResources(window);
}

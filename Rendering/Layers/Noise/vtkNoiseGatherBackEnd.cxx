// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseGatherBackEnd.h"

#include "NoiseGatherFS.h"
#include "vtkOpenGLQuadHelper.h"

bool vtkNoiseGatherBackEnd::Sum(vtkOpenGLRenderWindow* window, const Task& task)
{
  vtkOpenGLQuadHelper* quad =
    this->Prepare(window, this->Quad, NoiseGatherFS, Stage::Gather, task.Field.kind);
  if (!quad)
  {
    return false;
  }
  this->SetInputs(quad->Program, this->Inputs(task));
  quad->Render();
  return true;
}

void vtkNoiseGatherBackEnd::ReleaseGraphicsResources(vtkWindow* window)
{
  Release(this->Quad, window);
  this->vtkNoiseGpuBackEnd::ReleaseGraphicsResources(window);
}

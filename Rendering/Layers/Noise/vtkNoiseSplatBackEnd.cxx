// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseSplatBackEnd.h"

#include "vtkHachureCompatibility.h"

#include "NoiseSplatFS.h"
#include "NoiseSplatVS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

bool vtkNoiseSplatBackEnd::Sum(vtkOpenGLRenderWindow* window, const Task& task)
{
  const std::string vertices =
    vtkNoiseKernelBuffers::Text(NoiseSplatVS, Stage::SplatVertices, task.Field.kind);
  const std::string fragments =
    vtkNoiseKernelBuffers::Text(NoiseSplatFS, Stage::Splat, task.Field.kind);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertices.c_str(), fragments.c_str(), "");
  if (!program || !program->GetCompiled())
  {
    return false;
  }
  this->SetInputs(program, this->Inputs(task));
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  constexpr int corners = 6;
  this->Vertices->Bind();
  glDrawArrays(GL_TRIANGLES, 0, corners * this->Buffers.GetCount());
  this->Vertices->Release();
  state->vtkglDisable(GL_BLEND);
  return true;
}

void vtkNoiseSplatBackEnd::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices->ReleaseGraphicsResources();
  this->vtkNoiseGpuBackEnd::ReleaseGraphicsResources(window);
}

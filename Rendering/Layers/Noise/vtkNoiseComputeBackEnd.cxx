// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseComputeBackEnd.h"

#include "vtkHachureCompatibility.h"

#include "NoiseSumsCS.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#if defined(GL_COMPUTE_SHADER) && defined(glDispatchCompute)

namespace
{
constexpr int groupSide = 16; // as in NoiseSumsCS.glsl

// The program of a compute shader, 0 with an error where it cannot be made.
unsigned int MakeProgram(const std::string& text)
{
  const unsigned int shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  unsigned int program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glDeleteShader(shader);
  int linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked)
  {
    constexpr int length = 2048;
    char log[length] = "";
    glGetShaderInfoLog(shader, length, nullptr, log);
    vtkGenericWarningMacro("the compute shader of noises cannot be made: " << log);
    glDeleteProgram(program);
    program = 0;
  }
  return program;
}

unsigned int GroupsFor(int pixels)
{
  return static_cast<unsigned int>((pixels + groupSide - 1) / groupSide);
}
} // namespace

unsigned int vtkNoiseComputeBackEnd::Prepare(hachure::NoiseKind kind)
{
  const std::string text = vtkNoiseKernelBuffers::Text(NoiseSumsCS, Stage::Compute, kind);
  if (this->Text != text)
  {
    if (this->Program)
    {
      glDeleteProgram(this->Program);
    }
    this->Program = MakeProgram(text);
    this->Text = text;
  }
  return this->Program;
}

bool vtkNoiseComputeBackEnd::Sum(vtkOpenGLRenderWindow* window, const Task& task)
{
  const unsigned int program = this->Prepare(task.Field.kind);
  if (!program)
  {
    return false;
  }
  window->GetShaderCache()->ReleaseCurrentShader(); // it would take itself for the current one
  glUseProgram(program);
  for (const auto& uniform : this->Buffers.Uniforms())
  {
    glUniform4fv(glGetUniformLocation(program, uniform.first.c_str()), 1, uniform.second.data());
  }
  for (const auto& texture : this->Inputs(task))
  {
    glUniform1i(
      glGetUniformLocation(program, texture.first.c_str()), texture.second->GetTextureUnit());
  }
  glBindImageTexture(0, this->Sums->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
  glDispatchCompute(GroupsFor(task.Rectangle[2]), GroupsFor(task.Rectangle[3]), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
  glUseProgram(0);
  return true;
}

void vtkNoiseComputeBackEnd::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Program)
  {
    glDeleteProgram(this->Program);
  }
  this->Program = 0;
  this->Text.clear();
  this->vtkNoiseGpuBackEnd::ReleaseGraphicsResources(window);
}

#else

bool vtkNoiseComputeBackEnd::Sum(vtkOpenGLRenderWindow*, const Task&)
{
  return false;
}

void vtkNoiseComputeBackEnd::ReleaseGraphicsResources(vtkWindow* window)
{
  this->vtkNoiseGpuBackEnd::ReleaseGraphicsResources(window);
}

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternQuad.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

vtkPatternQuad::vtkPatternQuad() = default;
vtkPatternQuad::~vtkPatternQuad() = default;

bool vtkPatternQuad::IsCompiled() const
{
  return this->Helper && this->Helper->Program && this->Helper->Program->GetCompiled();
}

vtkShaderProgram* vtkPatternQuad::Ready(
  vtkOpenGLRenderWindow* window, const std::string& vertices, const std::string& fragments)
{
  const bool same = this->Helper && this->Vertices == vertices && this->Fragments == fragments;
  // Windows with one OpenGL have one cache of shaders, and whichever goes first releases them all:
  // what did compile is made again. What does not is not tried for every picture.
  if (!same || (this->Compiles && !this->IsCompiled()))
  {
    this->ReleaseGraphicsResources(window);
    this->Helper = std::make_unique<vtkOpenGLQuadHelper>(
      window, vertices.empty() ? nullptr : vertices.c_str(), fragments.c_str(), "");
    this->Vertices = vertices;
    this->Fragments = fragments;
    this->Compiles = this->IsCompiled();
  }
  return this->Compiles ? window->GetShaderCache()->ReadyShaderProgram(this->Helper->Program)
                        : nullptr;
}

void vtkPatternQuad::Render()
{
  this->Helper->Render();
}

void vtkPatternQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Helper)
  {
    this->Helper->ReleaseGraphicsResources(window);
    this->Helper.reset();
  }
}

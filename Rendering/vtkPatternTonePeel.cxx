// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternTonePeel.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternWindowResources.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <utility>

void vtkPatternTonePeel::Upload(vtkOpenGLRenderWindow* window, std::vector<float> depth)
{
  this->Before->ReleaseGraphicsResources(window);
  this->Before->SetContext(window);
  this->Before->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Before->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Before->Create2DFromRaw(static_cast<unsigned int>(this->Rectangle[2]),
    static_cast<unsigned int>(this->Rectangle[3]), 1, VTK_FLOAT, depth.data());
}

std::vector<vtkPatternTonePeel::Image> vtkPatternTonePeel::Peel(vtkOpenGLRenderWindow* window,
  vtkPatternWindowResources& resources, const std::array<int, 4>& rectangle,
  const std::function<void()>& draw)
{
  this->Rectangle = rectangle;
  constexpr float beforeAll = -1.0f;
  std::vector<float> depth(
    static_cast<std::size_t>(rectangle[2]) * static_cast<std::size_t>(rectangle[3]), beforeAll);
  std::vector<Image> layers;
  while (layers.size() < MostLayers)
  {
    this->Upload(window, std::move(depth));
    this->Before->Activate();
    draw();
    this->Before->Deactivate();
    depth = resources.ReadDepth(window, rectangle);
    if (std::all_of(depth.begin(), depth.end(), [](float z) { return z >= 1.0f; }))
    {
      break;
    }
    layers.push_back({ resources.ReadBytes(window, rectangle, vtkPatternAttributes::TONE), depth });
  }
  return layers;
}

void vtkPatternTonePeel::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("hachureDepthBefore", this->Before->GetTextureUnit());
  const float origin[2] = { static_cast<float>(this->Rectangle[0]),
    static_cast<float>(this->Rectangle[1]) };
  program->SetUniform2f("hachureDepthOrigin", origin);
}

void vtkPatternTonePeel::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Before->ReleaseGraphicsResources(window);
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseGpuBackEnd.h"

#include "vtkHachureCompatibility.h"

#include "NoiseFinishFS.h"
#include "NoiseShareFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Makes a texture that is at least this large.
bool Allocate(
  vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int width, int height, int type)
{
  auto columns = static_cast<unsigned int>(std::max(width, 1));
  auto rows = static_cast<unsigned int>(std::max(height, 1));
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (texture->GetHandle())
  {
    if (texture->GetWidth() >= columns && texture->GetHeight() >= rows)
    {
      return true;
    }
    columns = std::max(columns, texture->GetWidth());
    rows = std::max(rows, texture->GetHeight());
  }
  return texture->Allocate2D(columns, rows, 2, type);
}

bool Attach(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
  vtkTextureObject* texture, int width, int height)
{
  framebuffer->SetContext(window);
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, texture);
  framebuffer->ActivateDrawBuffer(0);
  vtkOpenGLState* state = window->GetState();
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  return framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER) != 0;
}

// The state of OpenGL while the steps draw; put back at the end.
struct DrawingState
{
  explicit DrawingState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state)
    , ColorMask(state)
    , Blend(state, GL_BLEND)
    , Cull(state, GL_CULL_FACE)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
    state->PushFramebufferBindings();
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
  ~DrawingState() { this->State->PopFramebufferBindings(); }
  DrawingState(const DrawingState&) = delete;
  void operator=(const DrawingState&) = delete;

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable Cull;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};

// Textures that are active as long as it lives.
struct ActiveTextures
{
  explicit ActiveTextures(std::vector<std::pair<std::string, vtkTextureObject*>> all)
    : All(std::move(all))
  {
    for (const auto& texture : this->All)
    {
      texture.second->Activate();
    }
  }
  ~ActiveTextures()
  {
    for (const auto& texture : this->All)
    {
      texture.second->Deactivate();
    }
  }
  ActiveTextures(const ActiveTextures&) = delete;
  void operator=(const ActiveTextures&) = delete;
  std::vector<std::pair<std::string, vtkTextureObject*>> All;
};
} // namespace

vtkNoiseGpuBackEnd::vtkNoiseGpuBackEnd() = default;
vtkNoiseGpuBackEnd::~vtkNoiseGpuBackEnd() = default;

bool vtkNoiseGpuBackEnd::CanDrawFloats(vtkOpenGLRenderWindow* window)
{
  vtkNew<vtkTextureObject> texture;
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  const DrawingState drawing(window->GetState());
  const bool complete =
    Allocate(window, texture, 4, 4, VTK_FLOAT) && Attach(window, framebuffer, texture, 4, 4);
  framebuffer->ReleaseGraphicsResources(window);
  texture->ReleaseGraphicsResources(window);
  return complete;
}

bool vtkNoiseGpuBackEnd::Draw(
  vtkOpenGLRenderWindow* window, const Task& task, vtkTextureObject* field)
{
  const DrawingState drawing(window->GetState());
  return this->Upload(window, task) && this->MeasureShares(window, task) &&
    this->MakeSums(window, task) && this->Finish(window, task, field);
}

bool vtkNoiseGpuBackEnd::Upload(vtkOpenGLRenderWindow* window, const Task& task)
{
  const std::size_t pixels = std::max(task.Objects.size(), task.Triangles.size());
  this->HasIds = pixels > 0;
  if (this->HasIds)
  {
    std::vector<float> texels(2 * pixels, 0.0f);
    for (std::size_t i = 0; i < task.Objects.size(); ++i)
    {
      texels[2 * i] = static_cast<float>(task.Objects[i]);
    }
    for (std::size_t i = 0; i < task.Triangles.size(); ++i)
    {
      texels[2 * i + 1] = static_cast<float>(task.Triangles[i]);
    }
    this->Ids->SetContext(window);
    this->Ids->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Ids->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Ids->Create2DFromRaw(static_cast<unsigned int>(task.Rectangle[2]),
      static_cast<unsigned int>(task.Rectangle[3]), 2, VTK_FLOAT, texels.data());
  }
  return this->Buffers.Upload(window,
    { task.Kernels, task.Rectangle, task.DepthTolerance, task.DepthTest, task.PartialVisibility,
      !task.Objects.empty(), !task.Triangles.empty(), task.Field });
}

vtkNoiseGpuBackEnd::Textures vtkNoiseGpuBackEnd::Inputs(const Task& task) const
{
  Textures all = this->Buffers.Textures();
  all.emplace_back("hachureNoiseDepth", task.DepthImage);
  // Samplers of one type may share a texture.
  all.emplace_back("hachureNoiseIds", this->HasIds ? this->Ids.Get() : this->Shares.Get());
  all.emplace_back("hachureNoiseShares", this->Shares.Get());
  return all;
}

void vtkNoiseGpuBackEnd::SetInputs(vtkShaderProgram* program, const Textures& textures) const
{
  this->Buffers.SetUniforms(program, std::string());
  for (const auto& texture : textures)
  {
    if (program->IsUniformUsed(texture.first.c_str()))
    {
      program->SetUniformi(texture.first.c_str(), texture.second->GetTextureUnit());
    }
  }
}

bool vtkNoiseGpuBackEnd::DrawQuad(vtkOpenGLRenderWindow* window, vtkPatternQuad& quad,
  const std::string& shader, const Textures& textures) const
{
  vtkShaderProgram* program = quad.Ready(window, {}, shader);
  if (program)
  {
    this->SetInputs(program, textures);
    quad.Render();
  }
  return program != nullptr;
}

bool vtkNoiseGpuBackEnd::MeasureShares(vtkOpenGLRenderWindow* window, const Task& task)
{
  constexpr int row = vtkNoiseKernelBuffers::SharesPerRow;
  const int rows = this->Buffers.GetCount() / row + 1;
  if (!Allocate(window, this->Shares, row, rows, VTK_FLOAT) ||
    !Attach(window, this->SharesFramebuffer, this->Shares, row, rows))
  {
    return false;
  }
  Textures inputs = this->Inputs(task);
  inputs.pop_back(); // the shares themselves
  if (!this->HasIds)
  {
    inputs.back().second = task.DepthImage;
  }
  const ActiveTextures active(inputs);
  return this->DrawQuad(window, this->ShareQuad,
    vtkNoiseKernelBuffers::Text(NoiseShareFS, Stage::Share, hachure::NoiseKind::phasor), inputs);
}

bool vtkNoiseGpuBackEnd::MakeSums(vtkOpenGLRenderWindow* window, const Task& task)
{
  this->Size = { task.Rectangle[2], task.Rectangle[3] };
  if (!Allocate(window, this->Sums, this->Size[0], this->Size[1], VTK_FLOAT) ||
    !Attach(window, this->SumsFramebuffer, this->Sums, this->Size[0], this->Size[1]))
  {
    return false;
  }
  const ActiveTextures active(this->Inputs(task));
  return this->Sum(window, task);
}

bool vtkNoiseGpuBackEnd::Finish(
  vtkOpenGLRenderWindow* window, const Task& task, vtkTextureObject* field)
{
  if (!Allocate(window, field, this->Size[0], this->Size[1], VTK_UNSIGNED_SHORT) ||
    !Attach(window, this->FieldFramebuffer, field, this->Size[0], this->Size[1]))
  {
    return false;
  }
  Textures inputs = this->Inputs(task);
  inputs.emplace_back("hachureNoiseSums", this->Sums.Get());
  const ActiveTextures active(inputs);
  const bool drawn = this->DrawQuad(window, this->FinishQuad,
    vtkNoiseKernelBuffers::Text(NoiseFinishFS, Stage::Finish, task.Field.kind), inputs);
  // The field may be deleted before this is used again.
  this->FieldFramebuffer->RemoveColorAttachment(0);
  return drawn;
}

std::vector<float> vtkNoiseGpuBackEnd::ReadSums(vtkOpenGLRenderWindow* window)
{
  constexpr std::size_t components = 2;
  std::vector<float> sums(
    components * static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]));
  window->GetState()->PushFramebufferBindings();
  this->SumsFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->SumsFramebuffer->ActivateReadBuffer(0);
  glReadPixels(0, 0, this->Size[0], this->Size[1], GL_RG, GL_FLOAT, sums.data());
  window->GetState()->PopFramebufferBindings();
  return sums;
}

void vtkNoiseGpuBackEnd::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ShareQuad.ReleaseGraphicsResources(window);
  this->FinishQuad.ReleaseGraphicsResources(window);
  this->Buffers.ReleaseGraphicsResources(window);
  for (auto* texture : { this->Ids.Get(), this->Shares.Get(), this->Sums.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  for (auto* framebuffer :
    { this->SharesFramebuffer.Get(), this->SumsFramebuffer.Get(), this->FieldFramebuffer.Get() })
  {
    framebuffer->ReleaseGraphicsResources(window);
  }
}

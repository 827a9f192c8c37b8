// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternVisibility.h"

#include "vtkHachureCompatibility.h"

#include "PatternVisibilityFS.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPatternSamples.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace
{
constexpr int maximumRow = 1024;

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  float values[16];
  for (int i = 0; i < 16; ++i)
  {
    values[i] = static_cast<float>(matrix[i / 4][i % 4]);
  }
  program->SetUniformMatrix4x4(name, values);
}

void Target(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
  vtkTextureObject* texture, const std::array<int, 2>& size, int components, int type)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Allocate2D(
    static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]), components, type);
  framebuffer->SetContext(window);
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, texture);
  framebuffer->ActivateDrawBuffer(0);
}
} // namespace

vtkPatternVisibility::vtkPatternVisibility() = default;
vtkPatternVisibility::~vtkPatternVisibility() = default;

bool vtkPatternVisibility::Prepare(vtkOpenGLRenderWindow* window, const vtkPatternSamples& samples)
{
  this->Count = samples.Count();
  if (this->Count == 0)
  {
    return false;
  }
  const int count = static_cast<int>(this->Count);
  const std::array<int, 2> size = { std::min(count, maximumRow),
    (count + maximumRow - 1) / maximumRow };
  if (size != this->Size || !this->Own->GetHandle())
  {
    this->ReleaseGraphicsResources(window);
    this->Size = size;
    Target(window, this->OwnFramebuffer, this->Own, size, 2, VTK_FLOAT);
    Target(window, this->SceneFramebuffer, this->Scene, size, 1, VTK_UNSIGNED_CHAR);
  }
  if (!this->Positions->GetHandle() || this->PositionVersion != samples.GetPositionVersion() ||
    this->Source != &samples)
  {
    std::vector<float> texels(4 * static_cast<std::size_t>(size[0] * size[1]), 0.0f);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const glm::dvec3 position = samples.GetPositions()[i] - samples.GetCenter();
      texels[4 * i] = static_cast<float>(position.x);
      texels[4 * i + 1] = static_cast<float>(position.y);
      texels[4 * i + 2] = static_cast<float>(position.z);
      texels[4 * i + 3] = static_cast<float>(samples.Spacing(i));
    }
    this->Positions->ReleaseGraphicsResources(window);
    this->Positions->SetContext(window);
    this->Positions->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Positions->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Positions->Create2DFromRaw(static_cast<unsigned int>(size[0]),
      static_cast<unsigned int>(size[1]), 4, VTK_FLOAT, texels.data());
    this->PositionVersion = samples.GetPositionVersion();
    this->Source = &samples;
  }
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, PatternVisibilityFS, "");
  }
  return this->Quad->Program != nullptr;
}

bool vtkPatternVisibility::MeasureOwn(vtkOpenGLRenderWindow* window,
  const vtkPatternSamples& samples, const glm::dmat4& modelToClip,
  const std::array<int, 4>& viewport, vtkTextureObject* depth)
{
  window->GetState()->PushFramebufferBindings();
  const bool prepared = this->Prepare(window, samples);
  if (prepared)
  {
    this->ModelToClip = glm::translate(modelToClip, samples.GetCenter());
    this->Viewport = viewport;
    this->Draw(window, this->OwnFramebuffer, depth, 0);
  }
  window->GetState()->PopFramebufferBindings();
  this->OwnMeasured = prepared;
  return prepared;
}

void vtkPatternVisibility::MeasureScene(vtkOpenGLRenderWindow* window, vtkTextureObject* depth)
{
  if (!this->OwnMeasured)
  {
    return;
  }
  window->GetState()->PushFramebufferBindings();
  this->Draw(window, this->SceneFramebuffer, depth, 1);
  window->GetState()->PopFramebufferBindings();
  this->OwnMeasured = false;
  this->SceneMeasured = true;
}

void vtkPatternVisibility::Draw(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* target,
  vtkTextureObject* depth, int sceneStage)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  target->Bind();
  target->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  state->vtkglScissor(0, 0, this->Size[0], this->Size[1]);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);

  vtkShaderProgram* program = this->Quad->Program;
  window->GetShaderCache()->ReadyShaderProgram(program);
  this->Positions->Activate();
  depth->Activate();
  this->Own->Activate();
  program->SetUniformi("samplePositions", this->Positions->GetTextureUnit());
  program->SetUniformi("depthImage", depth->GetTextureUnit());
  // The own stage writes the image that the scene stage reads.
  program->SetUniformi("ownVisibility",
    sceneStage == 1 ? this->Own->GetTextureUnit() : this->Positions->GetTextureUnit());
  program->SetUniformi("sceneStage", sceneStage);
  SetMatrix(program, "modelToClip", this->ModelToClip);
  SetMatrix(program, "clipToModel", glm::inverse(this->ModelToClip));
  const float area[4] = { static_cast<float>(this->Viewport[0]),
    static_cast<float>(this->Viewport[1]), static_cast<float>(this->Viewport[2]),
    static_cast<float>(this->Viewport[3]) };
  program->SetUniform4f("viewport", area);
  this->Quad->Render();
  this->Own->Deactivate();
  depth->Deactivate();
  this->Positions->Deactivate();
}

std::vector<std::uint8_t> vtkPatternVisibility::Read(vtkOpenGLRenderWindow* window)
{
  if (!this->SceneMeasured || !this->Scene->GetHandle())
  {
    return {};
  }
  this->SceneMeasured = false;
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(this->Size[0] * this->Size[1]));
  window->GetState()->PushFramebufferBindings();
  this->SceneFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->SceneFramebuffer->ActivateReadBuffer(0);
  // Rows are full, but for a single one: none is padded.
  glReadPixels(0, 0, this->Size[0], this->Size[1], GL_RED, GL_UNSIGNED_BYTE, bytes.data());
  window->GetState()->PopFramebufferBindings();
  bytes.resize(this->Count);
  return bytes;
}

void vtkPatternVisibility::Forget()
{
  this->OwnMeasured = false;
  this->SceneMeasured = false;
}

void vtkPatternVisibility::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Positions->ReleaseGraphicsResources(window);
  this->Own->ReleaseGraphicsResources(window);
  this->Scene->ReleaseGraphicsResources(window);
  this->OwnFramebuffer->ReleaseGraphicsResources(window);
  this->SceneFramebuffer->ReleaseGraphicsResources(window);
  this->Size = { 0, 0 };
  this->Forget();
}

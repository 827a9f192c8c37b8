// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternVisibility.h"

#include "vtkHachureCompatibility.h"

#include "PatternVisibilityOwnFS.h"
#include "PatternVisibilitySceneFS.h"
#include "PatternVisibilityVS.h"
#include "vtkOpenGLRenderWindow.h"
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
    Target(window, this->OwnFramebuffer, this->Own, size, 4, VTK_FLOAT);
    Target(
      window, this->SceneFramebuffer, this->Scene, size, this->Shared ? 4 : 1, VTK_UNSIGNED_CHAR);
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
  return true;
}

bool vtkPatternVisibility::MeasureOwn(vtkOpenGLRenderWindow* window,
  const vtkPatternSamples& samples, const glm::dmat4& modelToClip,
  const std::array<int, 4>& viewport, vtkTextureObject* depth)
{
  window->GetState()->PushFramebufferBindings();
  vtkShaderProgram* program = this->Prepare(window, samples)
    ? this->OwnQuad.Ready(window, PatternVisibilityVS, PatternVisibilityOwnFS)
    : nullptr;
  if (program)
  {
    const glm::dvec3 corner(viewport[0], viewport[1], 0.0);
    const glm::dvec3 size(viewport[2], viewport[3], 1.0);
    const glm::dmat4 clipToFragment = glm::translate(
      glm::scale(glm::translate(glm::dmat4(1.0), corner), 0.5 * size), glm::dvec3(1.0));
    const glm::dmat4 toFragment = clipToFragment * glm::translate(modelToClip, samples.GetCenter());
    SetMatrix(program, "sampleToFragment", toFragment);
    SetMatrix(program, "fragmentToSample", glm::inverse(toFragment));
    const glm::vec4 pixels(glm::dvec2(corner), glm::dvec2(corner + size));
    program->SetUniform4f("viewportPixels", &pixels.x);
    this->Draw(window,
      { this->OwnQuad, program, this->OwnFramebuffer, depth, this->Positions, "samplePositions" });
  }
  window->GetState()->PopFramebufferBindings();
  this->OwnMeasured = program != nullptr;
  return this->OwnMeasured;
}

void vtkPatternVisibility::MeasureScene(vtkOpenGLRenderWindow* window, vtkTextureObject* depth)
{
  if (!this->OwnMeasured)
  {
    return;
  }
  window->GetState()->PushFramebufferBindings();
  vtkShaderProgram* program = this->SceneQuad.Ready(window, {}, PatternVisibilitySceneFS);
  if (program)
  {
    this->Draw(window,
      { this->SceneQuad, program, this->SceneFramebuffer, depth, this->Own, "ownVisibility" });
  }
  window->GetState()->PopFramebufferBindings();
  this->OwnMeasured = false;
  this->SceneMeasured = program != nullptr;
}

void vtkPatternVisibility::Draw(vtkOpenGLRenderWindow* window, const Stage& stage)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  stage.Target->Bind();
  stage.Target->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  state->vtkglScissor(0, 0, this->Size[0], this->Size[1]);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);

  stage.PerSample->Activate();
  stage.Depth->Activate();
  stage.Program->SetUniformi(stage.PerSampleName, stage.PerSample->GetTextureUnit());
  stage.Program->SetUniformi("depthImage", stage.Depth->GetTextureUnit());
  stage.Quad.Render();
  stage.Depth->Deactivate();
  stage.PerSample->Deactivate();
}

void vtkPatternVisibility::SetShared(bool shared)
{
  if (shared != this->Shared)
  {
    this->Shared = shared;
    this->Size = { 0, 0 }; // other texels
    this->Forget();
  }
}

std::vector<std::uint8_t> vtkPatternVisibility::Read(vtkOpenGLRenderWindow* window)
{
  return this->Shared ? std::vector<std::uint8_t>() : this->ReadTexels(window);
}

std::vector<std::uint32_t> vtkPatternVisibility::ReadNearest(vtkOpenGLRenderWindow* window)
{
  const std::vector<std::uint8_t> bytes =
    this->Shared ? this->ReadTexels(window) : std::vector<std::uint8_t>();
  std::vector<std::uint32_t> numbers;
  numbers.reserve(bytes.size() / 4);
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4)
  {
    numbers.push_back((static_cast<std::uint32_t>(bytes[i + 1]) << 24) |
      (static_cast<std::uint32_t>(bytes[i + 2]) << 16) |
      (static_cast<std::uint32_t>(bytes[i + 3]) << 8) | bytes[i]);
  }
  return numbers;
}

std::vector<std::uint8_t> vtkPatternVisibility::ReadTexels(vtkOpenGLRenderWindow* window)
{
  if (!this->SceneMeasured || !this->Scene->GetHandle())
  {
    return {};
  }
  this->SceneMeasured = false;
  const std::size_t size = this->Shared ? 4 : 1;
  std::vector<std::uint8_t> bytes(
    size * static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]));
  window->GetState()->PushFramebufferBindings();
  this->SceneFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->SceneFramebuffer->ActivateReadBuffer(0);
  // Rows are full, but for a single one: none is padded.
  glReadPixels(0, 0, this->Size[0], this->Size[1], this->Shared ? GL_RGBA : GL_RED,
    GL_UNSIGNED_BYTE, bytes.data());
  window->GetState()->PopFramebufferBindings();
  bytes.resize(size * this->Count);
  return bytes;
}

void vtkPatternVisibility::Forget()
{
  this->OwnMeasured = false;
  this->SceneMeasured = false;
}

void vtkPatternVisibility::ReleaseGraphicsResources(vtkWindow* window)
{
  this->OwnQuad.ReleaseGraphicsResources(window);
  this->SceneQuad.ReleaseGraphicsResources(window);
  this->Positions->ReleaseGraphicsResources(window);
  this->Own->ReleaseGraphicsResources(window);
  this->Scene->ReleaseGraphicsResources(window);
  this->OwnFramebuffer->ReleaseGraphicsResources(window);
  this->SceneFramebuffer->ReleaseGraphicsResources(window);
  this->Size = { 0, 0 };
  this->Forget();
}

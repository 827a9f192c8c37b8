// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternTriangleIds.h"

#include "vtkHachureCompatibility.h"

#include "PatternTriangleIdsFS.h"
#include "PatternTriangleIdsVS.h"
#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <stdexcept>

namespace
{
// Triangles uploaded at a time: 48 MiB.
constexpr std::size_t chunk = std::size_t{ 1 } << 20;

struct Target
{
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Ids;
  vtkNew<vtkTextureObject> Depth;
};

void Prepare(vtkOpenGLRenderWindow* window, Target& target, const glm::ivec2& size)
{
  const auto width = static_cast<unsigned int>(size.x);
  const auto height = static_cast<unsigned int>(size.y);
  for (vtkTextureObject* texture : { target.Ids.Get(), target.Depth.Get() })
  {
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  target.Framebuffer->SetContext(window);
  if (!target.Ids->Allocate2D(width, height, 4, VTK_FLOAT) ||
    !target.Depth->AllocateDepth(width, height, vtkTextureObject::Float32))
  {
    throw std::runtime_error("the window cannot make float images of this size");
  }
  target.Framebuffer->Bind();
  target.Framebuffer->AddColorAttachment(0, target.Ids);
  target.Framebuffer->AddDepthAttachment(target.Depth);
  target.Framebuffer->ActivateDrawBuffer(0);
  if (!target.Framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER))
  {
    throw std::runtime_error("the window cannot draw into float images");
  }
}

void Clear(vtkOpenGLState* state, const glm::ivec2& size)
{
  state->vtkglViewport(0, 0, size.x, size.y);
  state->vtkglScissor(0, 0, size.x, size.y);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void DrawChunk(vtkShaderProgram* program, hachure::Span<const glm::dvec4> corners,
  hachure::Span<const glm::ivec3> triangles, int first)
{
  std::vector<glm::vec4> vertices;
  vertices.reserve(3 * triangles.size());
  for (const glm::ivec3& triangle : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      vertices.emplace_back(corners[static_cast<std::size_t>(triangle[i])]);
    }
  }
  vtkNew<vtkOpenGLBufferObject> buffer;
  buffer->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  vtkNew<vtkOpenGLVertexArrayObject> array;
  array->Bind();
  const bool bound = array->AddAttributeArray(
    program, buffer, "cornerClip", 0, sizeof(glm::vec4), VTK_FLOAT, 4, false);
  if (bound)
  {
    program->SetUniformi("firstTriangle", first);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  }
  array->Release();
  array->ReleaseGraphicsResources();
  buffer->ReleaseGraphicsResources();
  if (!bound)
  {
    throw std::runtime_error("the window cannot draw triangles from a buffer");
  }
}

void DrawAll(vtkOpenGLRenderWindow* window, hachure::Span<const glm::dvec4> corners,
  hachure::Span<const glm::ivec3> triangles)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(PatternTriangleIdsVS, PatternTriangleIdsFS, "");
  if (!program || !program->GetCompiled())
  {
    throw std::runtime_error("the window does not compile the shader of triangle ids");
  }
  for (std::size_t first = 0; first < triangles.size(); first += chunk)
  {
    const std::size_t count = std::min(chunk, triangles.size() - first);
    DrawChunk(program, corners, triangles.subspan(first, count), static_cast<int>(first));
  }
}

std::vector<std::int32_t> Read(Target& target, const glm::ivec2& size)
{
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<float> texels(4 * pixels);
  target.Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  target.Framebuffer->ActivateReadBuffer(0);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
  std::vector<std::int32_t> ids(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const float* texel = &texels[4 * i];
    ids[i] = texel[2] > 0.5f ? static_cast<int>(texel[0]) + 65536 * static_cast<int>(texel[1]) : -1;
  }
  return ids;
}

// Releases on every way out, with the framebuffer that was bound before.
struct Bindings
{
  explicit Bindings(vtkOpenGLState* state)
    : State(state)
  {
    state->PushFramebufferBindings();
  }
  ~Bindings() { this->State->PopFramebufferBindings(); }
  Bindings(const Bindings&) = delete;
  void operator=(const Bindings&) = delete;
  vtkOpenGLState* State;
};
} // namespace

namespace vtkPattern
{
std::vector<std::int32_t> DrawTriangleIds(vtkOpenGLRenderWindow* window,
  hachure::Span<const glm::dvec4> corners, hachure::Span<const glm::ivec3> triangles,
  const glm::ivec2& size)
{
  vtkOpenGLState* state = window->GetState();
  Target target;
  const Bindings bindings(state);
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  Prepare(window, target, size);
  Clear(state, size);
  DrawAll(window, corners, triangles);
  return Read(target, size);
}
} // namespace vtkPattern

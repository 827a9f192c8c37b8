// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternWindowResources.h"

#include "vtkHachureCompatibility.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <map>

std::shared_ptr<vtkPatternWindowResources> vtkPatternWindowResources::Get(
  vtkOpenGLRenderWindow* window)
{
  static std::map<vtkOpenGLRenderWindow*, std::weak_ptr<vtkPatternWindowResources>> all;
  std::shared_ptr<vtkPatternWindowResources> resources = all[window].lock();
  if (!resources)
  {
    resources = std::make_shared<vtkPatternWindowResources>();
    all[window] = resources;
  }
  return resources;
}

unsigned int vtkPatternWindowResources::AttributeCount(vtkPatternLayerPainter::SurfaceNeed need)
{
  switch (need)
  {
    case vtkPatternLayerPainter::POINT:
      return 4;
    case vtkPatternLayerPainter::POINT_AND_TEXTURE:
      return 6;
    default:
      return 3;
  }
}

bool vtkPatternWindowResources::Prepare(
  vtkOpenGLRenderWindow* window, vtkPatternLayerPainter::SurfaceNeed need)
{
  const int* size = window->GetActualSize();
  const auto width = static_cast<unsigned int>(size[0]);
  const auto height = static_cast<unsigned int>(size[1]);
  if (this->SurfaceColor->GetHandle() && this->SurfaceColor->GetWidth() == width &&
    this->SurfaceColor->GetHeight() == height && need <= this->Need)
  {
    return true;
  }
  this->ReleaseGraphicsResources(window);
  this->Need = std::max(this->Need, need);
  const unsigned int count = AttributeCount(this->Need);
  vtkTextureObject* const images[] = { this->SurfaceColor, this->SurfaceTone, this->SurfaceNormal,
    this->SurfacePoint, this->SurfaceTexture, this->SurfaceTextureSlopes, this->SurfaceDepth };
  for (vtkTextureObject* texture : images)
  {
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->SurfaceColor->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR);
  this->SurfaceTone->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR);
  this->SurfaceNormal->Allocate2D(width, height, 1, VTK_FLOAT);
  for (unsigned int i = AttributeCount(vtkPatternLayerPainter::NOTHING); i < count; ++i)
  {
    images[i]->Allocate2D(width, height, 4, VTK_FLOAT);
  }
  this->SurfaceDepth->AllocateDepth(width, height, vtkTextureObject::Fixed32);

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->AttributeFramebuffer->SetContext(window);
  this->AttributeFramebuffer->Bind();
  for (unsigned int i = 0; i < count; ++i)
  {
    this->AttributeFramebuffer->AddColorAttachment(i, images[i]);
  }
  this->AttributeFramebuffer->AddDepthAttachment(this->SurfaceDepth);
  this->AttributeFramebuffer->ActivateDrawBuffers(count);
  const bool complete = this->AttributeFramebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER) != 0;
  state->PopFramebufferBindings();
  return complete;
}

vtkTextureObject* vtkPatternWindowResources::CaptureDepth(
  vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle)
{
  const int* size = window->GetActualSize();
  vtkOpenGLState* state = window->GetState();
  int source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  state->PushFramebufferBindings();
  if (!this->DepthFramebuffer->GetFBOIndex() || this->DepthSize[0] != size[0] ||
    this->DepthSize[1] != size[1])
  {
    // Depth can only be copied between equal formats: made the way the window makes its own.
    this->DepthFramebuffer->ReleaseGraphicsResources(window);
    this->DepthFramebuffer->SetContext(window);
    constexpr int depthBits = 32;
    this->DepthFramebuffer->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true,
      depthBits, 0, window->GetStencilCapable() != 0);
    this->DepthSize = { size[0], size[1] };
  }
  this->DepthFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(source));
  const int right = rectangle[0] + rectangle[2];
  const int top = rectangle[1] + rectangle[3];
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlitFramebuffer(rectangle[0], rectangle[1], right, top, rectangle[0], rectangle[1],
    right, top, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
  return this->DepthFramebuffer->GetDepthAttachmentAsTextureObject();
}

void vtkPatternWindowResources::ReleaseGraphicsResources(vtkWindow* window)
{
  this->AttributeFramebuffer->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  this->SurfaceColor->ReleaseGraphicsResources(window);
  this->SurfaceTone->ReleaseGraphicsResources(window);
  this->SurfaceNormal->ReleaseGraphicsResources(window);
  this->SurfacePoint->ReleaseGraphicsResources(window);
  this->SurfaceTexture->ReleaseGraphicsResources(window);
  this->SurfaceTextureSlopes->ReleaseGraphicsResources(window);
  this->SurfaceDepth->ReleaseGraphicsResources(window);
  this->DepthSize = { 0, 0 };
}

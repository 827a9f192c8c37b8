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

bool vtkPatternWindowResources::Prepare(
  vtkOpenGLRenderWindow* window, const vtkPatternAttributes& attributes)
{
  const int* size = window->GetActualSize();
  if (this->Size[0] != size[0] || this->Size[1] != size[1])
  {
    this->ReleaseGraphicsResources(window);
    this->Size = { size[0], size[1] };
  }
  else if (this->SurfaceDepth->GetHandle() && this->Attached == attributes)
  {
    return true;
  }
  return this->Attach(window, attributes);
}

namespace
{
// False where it was made before.
bool NewTexture(vtkOpenGLRenderWindow* window, vtkTextureObject* texture)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return !texture->GetHandle();
}

void BlitDepth(vtkOpenGLState* state, const std::array<int, 4>& rectangle)
{
  const int right = rectangle[0] + rectangle[2];
  const int top = rectangle[1] + rectangle[3];
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlitFramebuffer(rectangle[0], rectangle[1], right, top, rectangle[0], rectangle[1],
    right, top, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

// Before images are read back: after a frame without any primitive Mesa's software OpenGL has been
// seen to answer with the image from before the last drawing.
void FinishDrawing()
{
  glFinish();
}
} // namespace

bool vtkPatternWindowResources::Attach(
  vtkOpenGLRenderWindow* window, const vtkPatternAttributes& attributes)
{
  const auto width = static_cast<unsigned int>(this->Size[0]);
  const auto height = static_cast<unsigned int>(this->Size[1]);
  const auto images = attributes.Images();
  for (const vtkPatternAttributes::Image image : images)
  {
    const bool bytes = image <= vtkPatternAttributes::TONE;
    const bool single = image == vtkPatternAttributes::NORMAL ||
      image == vtkPatternAttributes::RUN || image == vtkPatternAttributes::PATCH;
    const int components = single ? 1 : 4;
    if (NewTexture(window, this->Images[image]))
    {
      this->Images[image]->Allocate2D(
        width, height, components, bytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT);
    }
  }
  if (NewTexture(window, this->SurfaceDepth))
  {
    this->SurfaceDepth->AllocateDepth(width, height, vtkTextureObject::Fixed32);
  }

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->AttributeFramebuffer->SetContext(window);
  this->AttributeFramebuffer->Bind();
  this->AttributeFramebuffer->RemoveColorAttachments(
    static_cast<unsigned int>(this->Attached.Images().size()));
  for (std::size_t output = 0; output < images.size(); ++output)
  {
    this->AttributeFramebuffer->AddColorAttachment(
      static_cast<unsigned int>(output), this->Images[images[output]]);
  }
  this->AttributeFramebuffer->AddDepthAttachment(this->SurfaceDepth);
  this->AttributeFramebuffer->ActivateDrawBuffers(static_cast<unsigned int>(images.size()));
  const bool complete = this->AttributeFramebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER) != 0;
  state->PopFramebufferBindings();
  this->Attached = attributes;
  return complete && this->AttachDrawn(window);
}

bool vtkPatternWindowResources::AttachDrawn(vtkOpenGLRenderWindow* window)
{
  if (!NewTexture(window, this->DrawnColor))
  {
    return true;
  }
  NewTexture(window, this->DrawnDepth);
  const auto width = static_cast<unsigned int>(this->Size[0]);
  const auto height = static_cast<unsigned int>(this->Size[1]);
  this->DrawnColor->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR);
  this->DrawnDepth->AllocateDepth(width, height, vtkTextureObject::Fixed32);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->DrawnFramebuffer->SetContext(window);
  this->DrawnFramebuffer->Bind();
  this->DrawnFramebuffer->AddColorAttachment(0, this->DrawnColor);
  this->DrawnFramebuffer->AddDepthAttachment(this->DrawnDepth);
  this->DrawnFramebuffer->ActivateDrawBuffer(0);
  const bool complete = this->DrawnFramebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER) != 0;
  state->PopFramebufferBindings();
  return complete;
}

void vtkPatternWindowResources::BeginAttributes()
{
  this->AttributeFramebuffer->Bind();
  const auto count = static_cast<unsigned int>(this->Attached.Images().size());
  // VTK takes the buffers of the framebuffer that was bound before for those of this one, and sets
  // none that seem to be set: another order first.
  std::vector<unsigned int> turned(count);
  for (unsigned int i = 0; i < count; ++i)
  {
    turned[i] = (i + 1) % count;
  }
  this->AttributeFramebuffer->ActivateDrawBuffers(turned.data(), static_cast<int>(count));
  this->AttributeFramebuffer->ActivateDrawBuffers(count);
}

void vtkPatternWindowResources::BeginLayers(
  vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle)
{
  this->DrawnFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->AttributeFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  BlitDepth(window->GetState(), rectangle);
  this->DrawnFramebuffer->Bind();
  this->DrawnFramebuffer->ActivateDrawBuffer(0);
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
  BlitDepth(state, rectangle);
  state->PopFramebufferBindings();
  return this->DepthFramebuffer->GetDepthAttachmentAsTextureObject();
}

std::vector<float> vtkPatternWindowResources::ReadDepth(
  vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle)
{
  std::vector<float> depth(
    static_cast<std::size_t>(rectangle[2]) * static_cast<std::size_t>(rectangle[3]));
  window->GetState()->PushFramebufferBindings();
  this->AttributeFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  FinishDrawing();
  // Whatever the alignment of rows is: those of four-byte numbers have no gaps.
  glReadPixels(rectangle[0], rectangle[1], rectangle[2], rectangle[3], GL_DEPTH_COMPONENT, GL_FLOAT,
    depth.data());
  window->GetState()->PopFramebufferBindings();
  return depth;
}

std::vector<std::uint8_t> vtkPatternWindowResources::ReadBytes(vtkOpenGLRenderWindow* window,
  const std::array<int, 4>& rectangle, vtkPatternAttributes::Image image)
{
  std::vector<std::uint8_t> bytes(
    4 * static_cast<std::size_t>(rectangle[2]) * static_cast<std::size_t>(rectangle[3]));
  window->GetState()->PushFramebufferBindings();
  this->AttributeFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->AttributeFramebuffer->ActivateReadBuffer(static_cast<unsigned int>(image));
  FinishDrawing();
  glReadPixels(rectangle[0], rectangle[1], rectangle[2], rectangle[3], GL_RGBA, GL_UNSIGNED_BYTE,
    bytes.data());
  window->GetState()->PopFramebufferBindings();
  return bytes;
}

void vtkPatternWindowResources::ReleaseGraphicsResources(vtkWindow* window)
{
  this->AttributeFramebuffer->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  for (auto& image : this->Images)
  {
    image->ReleaseGraphicsResources(window);
  }
  this->SurfaceDepth->ReleaseGraphicsResources(window);
  this->DrawnFramebuffer->ReleaseGraphicsResources(window);
  this->DrawnColor->ReleaseGraphicsResources(window);
  this->DrawnDepth->ReleaseGraphicsResources(window);
  this->Attached = {};
  this->Size = { 0, 0 };
  this->DepthSize = { 0, 0 };
}

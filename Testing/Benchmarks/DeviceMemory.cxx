// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DeviceMemory.h"

#include "vtkHachureCompatibility.h"

namespace hachure::benchmark
{
namespace
{
/// OpenGL gives out small numbers first, and does not tell which are in use.
constexpr GLuint LargestName = 1 << 14;
constexpr GLint LargestLevel = 15;
constexpr std::int64_t BitsPerByte = 8;

std::int64_t levelBytes(GLenum target, GLint level)
{
  const auto get = [&](GLenum name)
  {
    GLint value = 0;
    glGetTexLevelParameteriv(target, level, name, &value);
    return static_cast<std::int64_t>(value);
  };
  std::int64_t bits = 0;
  for (const GLenum channel : { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
         GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE })
  {
    bits += get(channel);
  }
  const std::int64_t texels =
    get(GL_TEXTURE_WIDTH) * get(GL_TEXTURE_HEIGHT) * get(GL_TEXTURE_DEPTH);
  return texels * bits / BitsPerByte;
}

/// A texture fits the one target it was made for. Buffer textures count as their buffer.
std::int64_t textureBytes(GLuint name)
{
  std::int64_t bytes = 0;
  for (const GLenum target :
    { GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_RECTANGLE })
  {
    glBindTexture(target, name);
    if (glGetError() != GL_NO_ERROR)
    {
      continue;
    }
    for (GLint level = 0; level <= LargestLevel; ++level)
    {
      bytes += levelBytes(target, level);
    }
    glBindTexture(target, 0);
    while (glGetError() != GL_NO_ERROR)
    {
      // levels that this kind of texture does not have
    }
    break;
  }
  return bytes;
}

std::int64_t renderbufferBytes(GLuint name)
{
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  const auto get = [](GLenum value)
  {
    GLint result = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, value, &result);
    return static_cast<std::int64_t>(result);
  };
  std::int64_t bits = 0;
  for (const GLenum channel :
    { GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE,
      GL_RENDERBUFFER_ALPHA_SIZE, GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE })
  {
    bits += get(channel);
  }
  const std::int64_t bytes =
    get(GL_RENDERBUFFER_WIDTH) * get(GL_RENDERBUFFER_HEIGHT) * bits / BitsPerByte;
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  return bytes;
}

std::int64_t bufferBytes(GLuint name)
{
  GLint bytes = 0;
  glBindBuffer(GL_COPY_READ_BUFFER, name);
  glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  return bytes;
}
} // namespace

//----------------------------------------------------------------------------
std::int64_t deviceBytes(vtkRenderWindow* window)
{
  window->MakeCurrent();
  std::int64_t bytes = 0;
  for (GLuint name = 1; name <= LargestName; ++name)
  {
    bytes += glIsTexture(name) ? textureBytes(name) : 0;
    bytes += glIsRenderbuffer(name) ? renderbufferBytes(name) : 0;
    bytes += glIsBuffer(name) ? bufferBytes(name) : 0;
  }
  return bytes;
}
} // namespace hachure::benchmark

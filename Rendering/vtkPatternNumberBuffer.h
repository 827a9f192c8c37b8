// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Numbers that a shader reads one by one, or in vectors: floating point ones, or fractions in
 * bytes.
 */
#ifndef vtkPatternNumberBuffer_h
#define vtkPatternNumberBuffer_h

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <vector>

struct vtkPatternNumberBuffer
{
  vtkSmartPointer<vtkOpenGLBufferObject> Buffer;
  vtkSmartPointer<vtkTextureObject> Texture; ///< null while there are no numbers

  /// components: numbers of one texel.
  template <class Value, class Number = float>
  void Upload(vtkOpenGLRenderWindow* window, const std::vector<Value>& values, int components)
  {
    this->Texture = nullptr;
    if (values.empty())
    {
      return;
    }
    this->Buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
    this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
    this->Buffer->Upload(values, vtkOpenGLBufferObject::TextureBuffer);
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    const std::size_t numbers = values.size() * sizeof(Value) / sizeof(Number);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(numbers / static_cast<std::size_t>(components)), components,
      sizeof(Number) == 1 ? VTK_UNSIGNED_CHAR : VTK_FLOAT, this->Buffer);
  }

  bool IsUsable() const { return this->Texture && this->Texture->GetHandle(); }

  void Release(vtkWindow* window)
  {
    if (this->Texture)
    {
      this->Texture->ReleaseGraphicsResources(window);
      this->Texture = nullptr;
    }
    if (this->Buffer)
    {
      this->Buffer->ReleaseGraphicsResources();
      this->Buffer = nullptr;
    }
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternNumberBuffer.h

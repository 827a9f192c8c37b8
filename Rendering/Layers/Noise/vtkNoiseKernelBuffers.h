// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Kernels of a noise for shaders: buffers, uniforms, and the texts that read them (NoiseSums.glsl).
 */
#ifndef vtkNoiseKernelBuffers_h
#define vtkNoiseKernelBuffers_h

#include "NoiseField.h"
#include "vtkPatternNumberBuffer.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkNoiseKernelBuffers
{
public:
  struct Content
  {
    hachure::Span<const hachure::NoiseKernel> Kernels;
    std::array<int, 4> Rectangle; // x, y, width, height in the framebuffer
    float DepthTolerance;
    bool DepthTest;
    bool PartialVisibility;
    bool ObjectTest;
    bool TriangleTest;
    hachure::NoiseFieldOptions Field;
  };
  /// False where they are more than this OpenGL takes.
  bool Upload(vtkOpenGLRenderWindow* window, const Content& content);

  /// Of those uploaded.
  int GetCount() const { return this->Count; }
  /// Names without the number of the layer.
  const std::vector<std::pair<std::string, std::array<float, 4>>>& Uniforms() const
  {
    return this->Values;
  }
  std::vector<std::pair<std::string, vtkTextureObject*>> Textures() const;
  void SetUniforms(vtkShaderProgram* program, const std::string& number) const;

  bool IsUsable() const { return this->Kernels.IsUsable(); }
  void Activate();
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Texels of a row in the image of shares.
  static constexpr int SharesPerRow = 1024;

  enum class Stage
  {
    Share,
    Gather,
    Compute,
    SplatVertices,
    Splat,
    Finish,
    Forward
  };
  /// `shader` with the texts that it needs at its tag. '@' stays in that of FORWARD, and the pure
  /// functions are left to others.
  static std::string Text(const char* shader, Stage stage, hachure::NoiseKind kind);

private:
  void UploadNumbers(vtkOpenGLRenderWindow* window, const hachure::NoiseFieldOptions& field);
  void SetValues(const Content& content, const std::array<float, 4>& tiles);

  vtkPatternNumberBuffer Kernels;
  vtkPatternNumberBuffer Lists;
  vtkPatternNumberBuffer Numbers;
  std::vector<float> NumbersHeld;
  std::array<float, 4> Table = { 1.0f, 1.0f, 1.0f, 0.0f };
  std::array<float, 4> Spot = { 0.0f, 0.0f, 0.0f, 0.0f };
  std::vector<std::pair<std::string, std::array<float, 4>>> Values;
  int Count = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseKernelBuffers.h

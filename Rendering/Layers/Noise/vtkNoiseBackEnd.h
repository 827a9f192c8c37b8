// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes the field of a noise for the pixels of a rectangle: kernels summed up, normalised, and made
 * uniform. What all back ends make is what noiseField() makes; they share the functions of
 * NoiseKernel.glsl.
 */
#ifndef vtkNoiseBackEnd_h
#define vtkNoiseBackEnd_h

#include "HachureRenderingModule.h"
#include "NoiseField.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class HACHURERENDERING_EXPORT vtkNoiseBackEnd
{
public:
  struct Task
  {
    hachure::Span<const hachure::NoiseKernel> Kernels;
    std::array<int, 4> Rectangle; // x, y, width, height in the framebuffer
    vtkTextureObject* DepthImage; // window depth of the whole framebuffer
    std::function<const std::vector<float>&()> LookAtDepth; // of the rectangle
    hachure::Span<const std::int32_t> Objects;   // seen in the rectangle; empty: no such test
    hachure::Span<const std::int32_t> Triangles; // the same
    float DepthTolerance;
    bool DepthTest;
    bool PartialVisibility;
    bool EveryPixel; // of a disc counts for it: on the processors alone
    hachure::NoiseFieldOptions Field;
  };

  virtual ~vtkNoiseBackEnd() = default;

  /// `field`: two fractions of 16 bits, value and width / tileGradientRange, from its first texel
  /// on; it may be larger than the rectangle. False where this OpenGL cannot do it.
  virtual bool Draw(vtkOpenGLRenderWindow* window, const Task& task, vtkTextureObject* field) = 0;
  virtual void ReleaseGraphicsResources(vtkWindow*) {}

  /// type: one of vtkPatternMapper::NoiseBackEndType, but AUTOMATIC.
  static std::unique_ptr<vtkNoiseBackEnd> New(int type);
  static bool IsAvailable(vtkOpenGLRenderWindow* window, int type);

  /// The type that a window draws with where `wanted` is asked for, and what the user should know.
  /// AUTOMATIC: see there; measured once for a kind of graphics card. Never SPLAT, the reference.
  static int Choose(vtkOpenGLRenderWindow* window, int wanted, std::string& note);
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseBackEnd.h

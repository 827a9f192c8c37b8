// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_Kernels_h
#define hachure_Kernels_h

// The pattern mathematics of the shaders, compiled as C++ through GLM: what is measured and tested
// here is what is drawn. Every .glsl file is explained in its own header.

#include <glm/glm.hpp>

#if defined(__GNUC__)
#pragma GCC diagnostic push
// Each translation unit has its own copy, of which it uses a part.
#pragma GCC diagnostic ignored "-Wunused-function"
#endif

namespace hachure::glsl
{
namespace
{
using namespace glm;

// Order matters: later files use functions of earlier ones.
// clang-format off
#include "Kernels/Hash.glsl"
#include "Kernels/Screens.glsl"
#include "Kernels/Ink.glsl"
#include "Kernels/Mix.glsl"
#include "Kernels/Lod.glsl"
#include "Kernels/NoiseKernel.glsl"
#include "Kernels/PatternField.glsl"
#include "Kernels/SurfacePattern.glsl"
#include "Kernels/PatchBlend.glsl"
#include "Kernels/ToneCurve.glsl"
#include "Kernels/ProcessInks.glsl"
#include "Kernels/SurfaceLight.glsl"
#include "Kernels/ViewCells.glsl"
// clang-format on
} // namespace
} // namespace hachure::glsl

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif

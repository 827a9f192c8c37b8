// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a layer makes of the tone of its source, as the shaders have it.
 */
#ifndef vtkPatternToneCurve_h
#define vtkPatternToneCurve_h

#include "Kernels.h"
#include "vtkPatternTone.h"

namespace vtkPattern
{
/// The remap as toneCurve() of ToneCurve.glsl takes it.
inline glm::vec3 ToneRemap(vtkPatternTone* tone)
{
  switch (tone->GetRemap())
  {
    case vtkPatternTone::STEPS:
      return glm::vec3(hachure::glsl::remapSteps, static_cast<float>(tone->GetSteps()), 0.0f);
    case vtkPatternTone::SMOOTHSTEP:
      return glm::vec3(hachure::glsl::remapSmoothStep, static_cast<float>(tone->GetRemapRange()[0]),
        static_cast<float>(tone->GetRemapRange()[1]));
    default:
      return glm::vec3(0.0f);
  }
}

/// The tone that a layer draws where its source has this one.
inline double CurvedTone(vtkPatternTone* tone, double source)
{
  return hachure::glsl::toneCurve(static_cast<float>(source), static_cast<float>(tone->GetGamma()),
    tone->GetInvert() ? 1.0f : 0.0f, ToneRemap(tone));
}
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternToneCurve.h

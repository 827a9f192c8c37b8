// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a renderer as shaders of the surface need them, for tones that follow single
 * lights.
 */
#ifndef vtkPatternLights_h
#define vtkPatternLights_h

#include <array>
#include <cstddef>
#include <vector>

class vtkLight;
class vtkPatternToneChannels;
class vtkRenderer;
class vtkShaderProgram;

class vtkPatternLights
{
public:
  /// Takes all lights in the renderer's order, as its active camera sees them now.
  void Collect(vtkRenderer* renderer);

  std::size_t GetCount() const { return this->Colors.size(); }

  /// Values of the lights and of the channels that follow them.
  void SetUniforms(vtkShaderProgram* program, const vtkPatternToneChannels& channels) const;

private:
  void Add(vtkRenderer* renderer, vtkLight* light);

  std::vector<std::array<float, 4>> Colors;
  std::vector<std::array<float, 4>> Directions;
  std::vector<std::array<float, 4>> Positions;
  std::vector<std::array<float, 3>> Attenuations;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternLights.h

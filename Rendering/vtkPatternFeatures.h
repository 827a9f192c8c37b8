// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The strength of the features around the samples of a surface, for perceptual weights.
 */
#ifndef vtkPatternFeatures_h
#define vtkPatternFeatures_h

#include "SampleFeatures.h"
#include "vtkPatternSamples.h"

#include <string>
#include <vector>

class vtkActor;
class vtkPatternStyle;
class vtkRenderer;

class vtkPatternFeatures
{
public:
  /// Factors of the samples' weights in this frame, empty where the style asks for none. `error`
  /// says what is wrong with the style's array; there are no factors then.
  const std::vector<double>& Update(vtkPatternStyle* style, const vtkPatternSamples& samples,
    vtkRenderer* renderer, vtkActor* actor, std::string& error);
  const std::vector<double>& GetFactors() const { return this->Factors; }

private:
  void UpdateNeighbours(const vtkPatternSamples& samples);
  std::string ReadArray(const std::string& name, const vtkPatternSamples& samples);

  std::vector<hachure::SampleNeighbours> Neighbours;
  std::uint64_t NeighbourVersion = 0;
  vtkPatternSamples::Values Array;
  std::vector<double> Factors;
  int Source = -1;
  std::uint64_t FactorVersion = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternFeatures.h

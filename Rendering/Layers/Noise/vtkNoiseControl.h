// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How the kernels of a noise layer differ from place to place: directions and sizes from arrays of
 * the data, or from the layer's tone.
 */
#ifndef vtkNoiseControl_h
#define vtkNoiseControl_h

#include "NoiseSurface.h"
#include "vtkPatternLayerPainter.h"

#include <string>

class vtkNoiseLayer;
class vtkPatternSurfaceArray;

class vtkNoiseControl
{
public:
  /// channel: of the layer's tone, -1 where it is constant.
  vtkNoiseControl(
    vtkNoiseLayer* layer, const vtkPatternLayerPainter::FieldScene& scene, int channel);

  /// Makes the kernels' options ask this object, which must outlive their use.
  void Apply(hachure::NoiseKernelOptions& options) const;

  /// What is wrong with the data, empty where all is well.
  const std::string& GetProblem() const { return this->Problem; }

private:
  const vtkPatternSurfaceArray* Find(const char* what, const std::string& name, int components);
  void FindNumbers();
  hachure::NoiseKernelOptions::Control At(const hachure::NoisePoint& point) const;
  double ControlAt(const hachure::NoisePoint& point) const;
  double ToneAt(const hachure::NoisePoint& point) const;
  double ToneAtPixel(std::size_t pixel, double depth) const;

  vtkNoiseLayer* Layer;
  const vtkPatternLayerPainter::FieldScene& Scene;
  int Channel;
  const vtkPatternSurfaceArray* Directions = nullptr;
  const vtkPatternSurfaceArray* Numbers = nullptr;
  const std::vector<vtkPatternLayerPainter::FieldScene::ToneImage>* Tones = nullptr;
  std::string Problem;
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseControl.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the noises on an object remember in one renderer: which points their kernels had on the
 * surface that was drawn last, so that these go on where its cells change.
 */
#ifndef vtkPatternNoiseHistory_h
#define vtkPatternNoiseHistory_h

#include "NoiseAttachment.h"
#include "vtkPatternSurface.h"
#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkNoiseLayer;
class vtkPatternStyle;

class vtkPatternNoiseHistory
{
public:
  /// The kernels of a layer. A surface that does not follow the one before starts anew; lookOn:
  /// what is remembered stays, the kernels are those of an advance.
  void Kernels(vtkNoiseLayer* layer, vtkPatternSurface& surface, const hachure::NoiseView& view,
    const hachure::NoiseKernelOptions& options, bool lookOn, const hachure::NoiseOcclusion* hidden,
    std::vector<hachure::NoiseKernel>& kernels);

  /// Forgets layers that a style does not have.
  void Keep(vtkPatternStyle* style);
  void Forget() { this->Layers.clear(); }

private:
  struct Memory
  {
    hachure::NoiseAttachment Attachment;
    std::uint32_t Seed = 0;
    std::shared_ptr<vtkPatternSurface::State> State; // that was drawn last
  };
  std::map<vtkSmartPointer<vtkNoiseLayer>, Memory> Layers;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternNoiseHistory.h

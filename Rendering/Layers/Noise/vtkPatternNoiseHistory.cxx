// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternNoiseHistory.h"

#include "vtkNoiseLayer.h"
#include "vtkPatternStyle.h"

#include <set>

void vtkPatternNoiseHistory::Kernels(vtkNoiseLayer* layer, vtkPatternSurface& surface,
  const hachure::NoiseView& view, const hachure::NoiseKernelOptions& options, bool lookOn,
  const hachure::NoiseOcclusion* hidden, std::vector<hachure::NoiseKernel>& kernels)
{
  Memory& memory = this->Layers[layer];
  Memory copy;
  if (lookOn)
  {
    copy = memory;
  }
  Memory& used = lookOn ? copy : memory;
  const std::shared_ptr<vtkPatternSurface::State>& state = surface.GetState();
  const auto seed = static_cast<std::uint32_t>(layer->GetSeed());
  used.Attachment.setLife(layer->GetLife());
  if (used.Seed != seed || (used.State && used.State != state && !state->Follows(*used.State)))
  {
    used.Attachment.reset();
  }
  used.Attachment.kernels(surface.Points(seed), view, options, kernels, hidden);
  used.Seed = seed;
  used.State = state;
}

void vtkPatternNoiseHistory::Keep(vtkPatternStyle* style)
{
  std::set<vtkPatternLayer*> kept;
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    kept.insert(style->GetLayer(i));
  }
  for (auto i = this->Layers.begin(); i != this->Layers.end();)
  {
    i = kept.count(i->first) > 0 ? std::next(i) : this->Layers.erase(i);
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the mapper has drawn, as shapes.

#include "vtkPatternMapperInternals.h"

#include "VectorPage.h"

void vtkPatternMapper::KeepStipples(bool keep)
{
  this->Internal->KeepsStipples = keep;
  this->Internal->Stipples.clear();
}

void vtkPatternMapper::StoreStipples(Drawing& drawing)
{
  if (!this->Internal->KeepsStipples)
  {
    return;
  }
  std::vector<vtkPatternLayerPainter::Disc>& stipples =
    this->Internal->Stipples[{ drawing.Renderer, drawing.Actor }];
  stipples.clear();
  drawing.Part.Compositor.CollectDiscs(stipples);
  for (vtkPatternLayerPainter::Disc& stipple : stipples)
  {
    stipple.Shape.center -= glm::dvec2(drawing.Viewport.Drawn[0], drawing.Viewport.Drawn[1]);
  }
}

void vtkPatternMapper::CollectStipples(vtkRenderer* renderer, vtkActor* actor,
  std::vector<hachure::VectorDisc>& discs, std::vector<float>& depths)
{
  for (const vtkPatternLayerPainter::Disc& stipple : this->Internal->Stipples[{ renderer, actor }])
  {
    discs.push_back(stipple.Shape);
    depths.push_back(stipple.Depth);
  }
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternLayerPainter.h"

#include "vtkImagePatternLayer.h"
#include "vtkImagePatternLayerPainter.h"
#include "vtkNoiseLayer.h"
#include "vtkNoiseLayerPainter.h"
#include "vtkStippleLayer.h"
#include "vtkStippleLayerPainter.h"
#include "vtkViewTextureLayer.h"
#include "vtkViewTextureLayerPainter.h"

std::unique_ptr<vtkPatternLayerPainter> vtkPatternLayerPainter::New(vtkPatternLayer* layer)
{
  if (auto* image = vtkImagePatternLayer::SafeDownCast(layer))
  {
    return std::make_unique<vtkImagePatternLayerPainter>(image);
  }
  if (auto* noise = vtkNoiseLayer::SafeDownCast(layer))
  {
    return std::make_unique<vtkNoiseLayerPainter>(noise);
  }
  if (auto* stipple = vtkStippleLayer::SafeDownCast(layer))
  {
    return std::make_unique<vtkStippleLayerPainter>(stipple);
  }
  if (auto* view = vtkViewTextureLayer::SafeDownCast(layer))
  {
    return std::make_unique<vtkViewTextureLayerPainter>(view);
  }
  return nullptr;
}

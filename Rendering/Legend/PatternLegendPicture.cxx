// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternLegendPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPatternLegendWindow.h"
#include "vtkPatternMapper.h"
#include "vtkPatternStyle.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkStippleLayer.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
// Stipples of a surface serve every view of it and are many; a legend needs those that are seen.
vtkSmartPointer<vtkStippleLayer> withFewerPoints(vtkStippleLayer* layer, double area, double size)
{
  constexpr double pointsPerStipple = 4.0; // more than full ink needs of this size
  constexpr int least = 1000;
  const int enough =
    std::max(least, static_cast<int>(std::min(pointsPerStipple * area / (size * size), 1e8)));
  auto copy = vtkSmartPointer<vtkStippleLayer>::New();
  copy->SetTone(layer->GetTone());
  copy->SetColor(layer->GetColor());
  copy->SetColorSource(layer->GetColorSource());
  copy->SetOpacity(layer->GetOpacity());
  copy->SetBlendMode(layer->GetBlendMode());
  copy->SetSeed(layer->GetSeed());
  copy->SetSize(layer->GetSize());
  copy->SetSizeUnit(layer->GetSizeUnit());
  copy->SetCarrier(layer->GetCarrier());
  copy->SetOrder(layer->GetOrder());
  copy->SetGrowth(layer->GetGrowth());
  copy->SetGrowthFrames(0);
  copy->SetNumberOfPoints(std::min(layer->GetNumberOfPoints(), enough));
  copy->SetRefinement(layer->GetRefinement());
  copy->SetMemoryBudget(layer->GetMemoryBudget());
  copy->SetLife(0);
  return copy;
}

// What shows through is not multiplied by its own alpha.
void divideByAlpha(vtkUnsignedCharArray* pixels)
{
  unsigned char* value = pixels->GetPointer(0);
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i, value += 4)
  {
    const int alpha = value[3];
    for (int c = 0; c < 3 && alpha > 0 && alpha < 255; ++c)
    {
      value[c] = static_cast<unsigned char>(std::min(255, (value[c] * 255 + alpha / 2) / alpha));
    }
  }
}
} // namespace

PatternLegendPicture::PatternLegendPicture()
{
  this->Mapper->SetStyle(this->Style);
  this->Mapper->SetDrawsLegend(true);
  this->Mapper->SetColorModeToDefault(); // colours are those of the points
  constexpr double grey = 0.75;          // see vtkPatternMapper
  this->NoTable->SetNanColor(grey, grey, grey, 1.0);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Renderer->SetBackgroundAlpha(0.0);
  this->Renderer->AutomaticLightCreationOff();
}

PatternLegendPicture::~PatternLegendPicture()
{
  this->releaseGraphicsResources();
}

void PatternLegendPicture::releaseGraphicsResources()
{
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Renderer); // which releases what it has drawn with
    this->Window = nullptr;
  }
}

std::array<int, 4> legendArea(const LegendLayout& layout)
{
  int lower[2] = { layout.row[0], layout.row[1] };
  int upper[2] = { 0, 0 };
  for (const LegendRectangle& swatch : layout.swatches)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      lower[axis] = std::min(lower[axis], swatch[axis]);
      upper[axis] = std::max(upper[axis], swatch[axis] + swatch[axis + 2]);
    }
  }
  return { lower[0] - legendMargin, lower[1] - legendMargin, upper[0] - lower[0] + 2 * legendMargin,
    upper[1] - lower[1] + 2 * legendMargin };
}

// The layers themselves, so that nothing is made twice; light, motion and outline are the legend's.
void PatternLegendPicture::UpdateStyle(
  vtkPatternStyle* style, const PatternLegendKey& key, double area, double pixelsPerLogical)
{
  this->Style->RemoveAllLayers();
  for (vtkPatternLayer* layer : key.layers())
  {
    auto* stipples = vtkStippleLayer::SafeDownCast(layer);
    if (stipples)
    {
      const double size = style->GetLengthInPixels(stipples->GetSize(), stipples->GetSizeUnit());
      this->Style->AddLayer(withFewerPoints(stipples, area, size));
    }
    else
    {
      this->Style->AddLayer(layer);
    }
  }
  this->Style->SetPaperSource(style->GetPaperSource());
  this->Style->SetPaperColor(style->GetPaperColor());
  this->Style->SetDotsPerInch(style->GetDotsPerInch());
  this->Style->SetFinalQuality(style->GetFinalQuality());
  this->Style->SetPixelScale(pixelsPerLogical);
}

void PatternLegendPicture::Look(const std::array<int, 4>& area)
{
  const double center[2] = { area[0] + 0.5 * area[2], area[1] + 0.5 * area[3] };
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * area[3]);
  camera->SetFocalPoint(center[0], center[1], 0.0);
  camera->SetPosition(center[0], center[1], 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.5, 1.5);
  // Another surface, whose marks lie as those of a first picture do.
  this->Mapper->Reanchor(this->Renderer);
}

vtkSmartPointer<vtkImageData> PatternLegendPicture::Render(vtkOpenGLRenderWindow* window)
{
  // Both windows believe to know what the context does.
  vtkOpenGLState* const state = window->GetState();
  window->GetShaderCache()->ReleaseCurrentShader();
  state->PushFramebufferBindings();
  this->Window->GetState()->Reset();
  this->Window->Render();
  const int* size = this->Window->GetActualSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  this->Window->GetShaderCache()->ReleaseCurrentShader();
  state->Reset();
  state->PopFramebufferBindings();
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1])
  {
    return nullptr;
  }
  divideByAlpha(pixels);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(pixels);
  return image;
}

vtkSmartPointer<vtkImageData> PatternLegendPicture::draw(vtkOpenGLRenderWindow* window,
  vtkPatternStyle* style, const PatternLegendKey& key, const LegendPictureScene& scene)
{
  if (!this->Window || this->Owner != window)
  {
    this->releaseGraphicsResources();
    this->Owner = window;
    this->Window = vtkSmartPointer<vtkPatternLegendWindow>::New();
    this->Window->SetOwner(window);
    this->Window->AddRenderer(this->Renderer);
  }
  const std::array<int, 4> area = legendArea(scene.layout);
  int size[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    size[axis] = static_cast<int>(std::lround(area[axis + 2] * scene.pixelsPerLogical));
    if (size[axis] > vtkTextureObject::GetMaximumTextureSize(window))
    {
      return nullptr;
    }
  }
  const double pixels = static_cast<double>(area[2]) * area[3];
  this->UpdateStyle(style, key, pixels, scene.pixelsPerLogical);
  this->Mapper->SetInputDataObject(legendSurface(key, scene));
  this->Mapper->SetLookupTable(key.colors() ? key.colors() : this->NoTable.Get());
  this->Window->SetSize(size[0], size[1]);
  this->Look(area);
  return this->Render(window);
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// The flat surface that swatches are pictures of.
#include "PatternLegendPicture.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImagePatternLayer.h"
#include "vtkNoiseLayer.h"
#include "vtkPatternToneChannels.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hachure
{
namespace
{
// The part of the surface that shows a swatch, along the row, with what lies around it.
struct Span
{
  const LegendSwatch* swatch;
  double begin; // of the swatch
  double end;
  double lower; // of its surroundings
  double upper;
};

std::vector<Span> spansOf(const LegendPictureScene& scene)
{
  const std::size_t along = scene.vertical ? 1 : 0;
  std::vector<std::size_t> order(scene.layout.swatches.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  const auto begin = [&](std::size_t i) { return scene.layout.swatches[i][along]; };
  std::sort(order.begin(), order.end(),
    [&begin](std::size_t a, std::size_t b) { return begin(a) < begin(b); });
  std::vector<Span> spans;
  for (const std::size_t i : order)
  {
    const double first = begin(i);
    const double last = first + scene.layout.swatches[i][along + 2];
    spans.push_back({ &scene.swatches[i], first, last, first - legendMargin, last + legendMargin });
  }
  for (std::size_t i = 0; i + 1 < spans.size(); ++i)
  {
    spans[i].upper = spans[i + 1].lower = 0.5 * (spans[i].end + spans[i + 1].begin);
  }
  return spans;
}

// Grows by pairs of points across the row.
class SurfaceBuilder
{
public:
  SurfaceBuilder(const PatternLegendKey& key, const LegendPictureScene& scene)
    : Key(key)
    , Vertical(scene.vertical)
  {
    const std::size_t across = scene.vertical ? 0 : 1;
    const LegendRectangle& row = scene.layout.row;
    this->Sides[0] = row[across] - legendMargin;
    this->Sides[1] = row[across] + row[across + 2] + legendMargin;
    this->Colors->SetNumberOfComponents(3);
    this->Colors->SetName("colors");
    for (vtkPatternLayer* layer : key.layers())
    {
      vtkPatternTone* const tone = layer->GetTone();
      const std::string name = vtkPatternToneChannels::StandIn(tone);
      if (!this->Data->GetPointData()->HasArray(name.c_str()))
      {
        vtkNew<vtkDoubleArray> values;
        values->SetName(name.c_str());
        this->Data->GetPointData()->AddArray(values);
        this->Tones.push_back({ tone, values });
      }
    }
  }

  void add(const Span& span)
  {
    // Enough for the colours of a table; all else changes evenly.
    constexpr int columnsOfRamp = 128;
    const double first = span.swatch->first;
    const double last = span.swatch->last;
    if (span.lower < span.begin)
    {
      this->AddPair(span.lower, first);
    }
    const bool straight = first == last || std::isnan(first) || !this->Key.colorsFollow();
    const int columns = straight ? 1 : columnsOfRamp;
    for (int i = 0; i <= columns; ++i)
    {
      const double share = static_cast<double>(i) / columns;
      this->AddPair(span.begin + share * (span.end - span.begin), first + share * (last - first));
    }
    if (span.upper > span.end)
    {
      this->AddPair(span.upper, last);
    }
    this->Joined = false;
  }

  vtkSmartPointer<vtkPolyData> finish()
  {
    this->Data->SetPoints(this->Points);
    this->Data->SetPolys(this->Cells);
    this->Data->GetPointData()->SetScalars(this->Colors);
    this->AddWhatLayersNeed();
    return this->Data;
  }

private:
  // Joined with the pair before, of the same swatch.
  void AddPair(double along, double value)
  {
    const std::array<double, 3> color = this->Key.colorAt(value);
    for (const double side : this->Sides)
    {
      const double x = this->Vertical ? side : along;
      const double y = this->Vertical ? along : side;
      this->Points->InsertNextPoint(x, y, 0.0);
      for (const double component : color)
      {
        this->Colors->InsertNextValue(
          static_cast<unsigned char>(std::lround(255.0 * std::clamp(component, 0.0, 1.0))));
      }
      for (const auto& tone : this->Tones)
      {
        tone.second->InsertNextValue(this->Key.standInAt(tone.first, value));
      }
    }
    const vtkIdType i = this->Points->GetNumberOfPoints() - 4;
    if (this->Joined)
    {
      const vtkIdType upright[] = { i, i + 1, i + 3, i + 2 };
      const vtkIdType level[] = { i, i + 2, i + 3, i + 1 };
      this->Cells->InsertNextCell(4, this->Vertical ? upright : level);
    }
    this->Joined = true;
  }

  void AddConstant(const char* name, std::array<double, 3> value, int components)
  {
    if (name && *name && !this->Data->GetPointData()->HasArray(name))
    {
      vtkNew<vtkFloatArray> array;
      array->SetName(name);
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(this->Points->GetNumberOfPoints());
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        array->SetTuple(i, value.data());
      }
      this->Data->GetPointData()->AddArray(array);
    }
  }

  // Strokes along an array have one direction, and marks that an array controls are midway.
  void AddWhatLayersNeed()
  {
    for (vtkPatternLayer* layer : this->Key.layers())
    {
      if (auto* noise = vtkNoiseLayer::SafeDownCast(layer))
      {
        this->AddConstant(noise->GetDirectionArrayName(), { 1.0, 0.0, 0.0 }, 3);
        const double* range = noise->GetControlRange();
        this->AddConstant(
          noise->GetControlArrayName(), { 0.5 * (range[0] + range[1]), 0.0, 0.0 }, 1);
      }
      auto* image = vtkImagePatternLayer::SafeDownCast(layer);
      if (image && image->GetMotion() == vtkImagePatternLayer::TEXTURE)
      {
        this->AddTextureCoordinates(image);
      }
    }
  }

  // A period is as large as the layer's size says.
  void AddTextureCoordinates(vtkImagePatternLayer* layer)
  {
    constexpr double wholeInPixels = 512.0; // see vtkImagePatternLayer::SetSurfacePeriod
    const double set = layer->GetSurfacePeriod();
    const double scale = set > 0.0 ? set / layer->GetSize() : 1.0 / wholeInPixels;
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
    {
      const double* point = this->Points->GetPoint(i);
      coordinates->InsertNextTuple2(scale * point[0], scale * point[1]);
    }
    this->Data->GetPointData()->SetTCoords(coordinates);
  }

  const PatternLegendKey& Key;
  bool Vertical;
  bool Joined = false;
  double Sides[2];
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
  std::vector<std::pair<vtkPatternTone*, vtkSmartPointer<vtkDoubleArray>>> Tones;
};
} // namespace

vtkSmartPointer<vtkPolyData> legendSurface(
  const PatternLegendKey& key, const LegendPictureScene& scene)
{
  SurfaceBuilder builder(key, scene);
  for (const Span& span : spansOf(scene))
  {
    builder.add(span);
  }
  return builder.finish();
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// A picture of four legends: a ramp with a swatch for no number, categories, steps and light.
#include "StrictImageComparison.h"

#include <vtkImagePatternLayer.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPatternLegendActor.h>
#include <vtkPatternStyle.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVariant.h>

namespace
{
void addLegend(vtkRenderer* renderer, vtkPatternLegendActor* legend, const char* preset,
  double left, double bottom, double width, double height)
{
  vtkNew<vtkPatternStyle> style;
  style->LoadPreset(preset);
  for (int i = 0; i < style->GetNumberOfLayers() && legend->GetTitle() != "light"; ++i)
  {
    vtkPatternTone* tone = style->GetLayer(i)->GetTone();
    tone->SetSource(vtkPatternTone::ARRAY);
    tone->SetArrayName("Depth");
    tone->SetRange(0.0, 40.0);
  }
  legend->SetStyle(style);
  legend->SetPosition(left, bottom);
  legend->SetPosition2(width, height);
  renderer->AddViewProp(legend);
}
} // namespace

int TestPatternLegendPicture(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(400, 280);
  window->AddRenderer(renderer);

  vtkNew<vtkPatternLegendActor> ramp;
  ramp->SetTitle("Depth (m)");
  ramp->DrawNanSwatchOn();
  ramp->SetNanLabel("no data");
  addLegend(renderer, ramp, "hatch", 0.04, 0.04, 0.25, 0.92);

  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(3);
  table->IndexedLookupOn();
  const char* const names[] = { "sand", "clay", "rock" };
  const double colors[][3] = { { 1.0, 0.85, 0.5 }, { 0.8, 0.5, 0.4 }, { 0.6, 0.7, 0.8 } };
  for (int i = 0; i < 3; ++i)
  {
    table->SetAnnotation(vtkVariant(10 * (i + 1)), names[i]);
    table->SetTableValue(i, colors[i][0], colors[i][1], colors[i][2], 1.0);
  }
  vtkNew<vtkPatternLegendActor> categories;
  categories->SetLookupTable(table);
  categories->SetTitle("Ground");
  addLegend(renderer, categories, "halftone", 0.36, 0.45, 0.25, 0.51);
  categories->GetStyle()->SetPaperSource(vtkPatternStyle::FLAT);

  vtkNew<vtkPatternLegendActor> light;
  light->SetTitle("light");
  addLegend(renderer, light, "phasor", 0.68, 0.45, 0.25, 0.51);
  light->DrawTitleOff();

  vtkNew<vtkPatternLegendActor> steps;
  steps->SetMode(vtkPatternLegendActor::STEPS);
  steps->SetOrientation(vtkPatternLegendActor::HORIZONTAL);
  addLegend(renderer, steps, "cross-hatch", 0.36, 0.04, 0.6, 0.32);

  window->Render();
  // A few pixels that rounding puts on the other side; strokes elsewhere make thousands.
  constexpr double allowedError = 10.0;
  return strict::regressionTest(window, argc, argv, allowedError);
}

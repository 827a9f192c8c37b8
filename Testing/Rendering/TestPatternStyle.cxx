// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// A style keeps its layers in order, knows when anything in it changed, and tells structure from
// values.

#include <vtkImageData.h>
#include <vtkImagePatternLayer.h>
#include <vtkNew.h>
#include <vtkPatternStyle.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>

namespace
{

bool passed = true;

void check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "Not so: " << what << "\n";
    passed = false;
  }
}

void checkError(vtkObject* object, const std::function<void()>& call, const char* expected)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const unsigned long tag = object->AddObserver(vtkCommand::ErrorEvent, observer);
  call();
  object->RemoveObserver(tag);
  check(observer->GetErrorMessage().find(expected) != std::string::npos, expected);
}

void testLayers()
{
  vtkNew<vtkPatternStyle> style;
  vtkNew<vtkImagePatternLayer> bottom;
  vtkNew<vtkImagePatternLayer> middle;
  vtkNew<vtkImagePatternLayer> top;
  style->AddLayer(bottom);
  style->AddLayer(top);
  style->InsertLayer(1, middle);
  check(style->GetLayer(0) == bottom && style->GetLayer(1) == middle && style->GetLayer(2) == top,
    "layers lie in the order of their index");
  checkError(
    style, [&] { style->AddLayer(nullptr); }, "expected a layer, got null");
  checkError(
    style, [&] { style->AddLayer(top); }, "the layer is in this style already");
  vtkNew<vtkImagePatternLayer> other;
  checkError(
    style, [&] { style->InsertLayer(4, other); }, "index 4 is out of range");
  checkError(
    style, [&] { style->InsertLayer(-1, other); }, "index -1 is out of range");
  checkError(
    style, [&] { style->RemoveLayer(other); }, "the layer is not in this style");
  checkError(
    style, [&] { style->GetLayer(3); }, "index 3 is out of range; the style has 3 layers");
  checkError(
    top, [&] { top->SetTone(nullptr); }, "a layer always has a tone");
  check(top->GetTone() != nullptr, "a refused tone leaves the old one");
  check(style->GetNumberOfLayers() == 3, "what was refused changed nothing");
  style->RemoveLayer(middle);
  check(style->GetNumberOfLayers() == 2 && style->GetLayer(1) == top, "a layer can be removed");
}

// A change of anything below the style shows in the style's time; the same value again does not,
// unless the change adds or removes something each time (repeats).
void checkChange(
  vtkPatternStyle* style, bool repeats, const char* what, const std::function<void()>& change)
{
  const vtkMTimeType time = style->GetMTime();
  change();
  check(style->GetMTime() > time, what);
  const vtkMTimeType changed = style->GetMTime();
  change();
  check(style->GetMTime() == changed || repeats, "the same value again is no change");
}

void testTimes()
{
  vtkNew<vtkPatternStyle> style;
  vtkNew<vtkImagePatternLayer> layer;
  vtkNew<vtkImageData> image;
  const auto add = [&] { style->AddLayer(vtkSmartPointer<vtkImagePatternLayer>::New()); };
  style->AddLayer(layer);
  checkChange(style, false, "paper", [&] { style->SetPaperColor(0.5, 0.5, 0.5); });
  checkChange(style, false, "outline", [&] { style->SetOutlineWidth(3.0); });
  checkChange(style, false, "angle", [&] { layer->SetAngle(10.0); });
  checkChange(style, false, "ink", [&] { layer->SetColor(0.1, 0.2, 0.3); });
  checkChange(style, false, "tone", [&] { layer->GetTone()->SetGamma(2.0); });
  checkChange(style, false, "array", [&] { layer->GetTone()->SetArrayName("a"); });
  checkChange(style, false, "image", [&] { layer->SetImage(image); });
  checkChange(style, false, "pixels", [&] { image->SetSpacing(2.0, 1.0, 1.0); });
  checkChange(style, true, "a layer more", add);
  checkChange(style, true, "a layer less", [&] { style->RemoveLayer(style->GetLayer(1)); });
}

void testLengthsAndRanges()
{
  vtkNew<vtkPatternStyle> style;
  style->SetDotsPerInch(300.0);
  const double pixels = style->GetLengthInPixels(25.4, vtkPatternLayer::MILLIMETRES);
  check(std::abs(pixels - 300.0) < 1e-12, "25.4 mm are one inch");
  check(style->GetLengthInPixels(7.0, vtkPatternLayer::PIXELS) == 7.0, "pixels are pixels");
  style->SetPaperColor(-1.0, 2.0, std::numeric_limits<double>::quiet_NaN());
  const double* color = style->GetPaperColor();
  check(color[0] == 0.0 && color[1] == 1.0 && color[2] == 0.0, "colours are clamped");
  vtkNew<vtkImagePatternLayer> layer;
  layer->SetIrregularity(2.0);
  check(layer->GetIrregularity() == 1.0, "irregularity is clamped to 1");
  vtkNew<vtkImageData> image;
  layer->SetImageFileName("old.png");
  layer->SetImage(image);
  check(layer->GetImageFileName()[0] == '\0', "another image forgets the file of the old one");
}

} // namespace

int TestPatternStyle(int, char*[])
{
  testLayers();
  testTimes();
  testLengthsAndRanges();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

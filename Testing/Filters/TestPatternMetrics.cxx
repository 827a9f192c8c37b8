// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPatternMetrics.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>

namespace
{

constexpr int size = 96;
constexpr double shift[2] = { 1.3, 0.7 }; // pixels per frame

bool require(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Not so: " << what << "\n";
  }
  return condition;
}

vtkSmartPointer<vtkImageData> makeImage(
  int components, const std::function<double(double, double, int)>& value, int width = size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, size, 1);
  image->AllocateScalars(VTK_FLOAT, components);
  for (int i = 0; i < width * size; ++i)
  {
    const int column = i % width;
    const int row = i / width;
    for (int k = 0; k < components; ++k)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, k, value(column, row, k));
    }
  }
  return image;
}

// Waves in two directions, 9 and 11 pixels long.
double ink(double x, double y)
{
  return 0.5 + 0.25 * std::sin(0.6 * x + 0.35 * y) + 0.25 * std::sin(0.5 * y - 0.3 * x);
}

struct Scene
{
  vtkNew<vtkPatternMetrics> metrics;
  vtkNew<vtkTest::ErrorObserver> observer;
  double speed; // of the pattern, as a share of the surface's

  explicit Scene(double patternSpeed = 1.0, int frames = 3)
    : speed(patternSpeed)
  {
    this->metrics->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->metrics->AddObserver(vtkCommand::WarningEvent, this->observer);
    this->metrics->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->metrics->SetWavelength(10.0);
    for (int t = 0; t < frames; ++t)
    {
      this->metrics->AddFrame(this->frame(t));
    }
  }
  vtkSmartPointer<vtkImageData> frame(int t) const
  {
    const double s = this->speed * t;
    return makeImage(
      1, [s](double x, double y, int) { return ink(x - s * shift[0], y - s * shift[1]); });
  }
  void addMotions(int count, int components = 5, float visible = 1.0f)
  {
    for (int t = 0; t < count; ++t)
    {
      this->metrics->AddMotion(makeImage(components,
        [=](double, double, int k) {
          return k < 2 ? shift[k] : k == 2 ? visible : k == 3 ? 0.9 : 5.0;
        }));
    }
  }
  vtkIdType rowOf(const std::string& name)
  {
    vtkTable* table = this->metrics->GetOutput();
    vtkIdType row = table->GetNumberOfRows() - 1;
    while (row >= 0 && table->GetValueByName(row, "Metric").ToString() != name)
    {
      --row;
    }
    return row;
  }
  double value(const std::string& name)
  {
    const vtkIdType row = this->rowOf(name);
    if (row < 0)
    {
      std::cerr << "No metric " << name << "\n";
      return -1e9;
    }
    return this->metrics->GetOutput()->GetValueByName(row, "Value").ToDouble();
  }
  double ofFrame(vtkIdType frame, const char* name)
  {
    return this->metrics->GetOutput(1)->GetValueByName(frame, name).ToDouble();
  }
  bool refuses(const std::string& message)
  {
    this->metrics->Update();
    const bool found = this->observer->GetError() &&
      this->observer->GetErrorMessage().find(message) != std::string::npos;
    return require(
             found, "an error with '" + message + "', but: " + this->observer->GetErrorMessage()) &&
      require(this->metrics->GetOutput()->GetNumberOfRows() == 0, "no rows after an error");
  }
};

bool measuresClips()
{
  bool good = true;
  for (const double speed : { 0.0, 1.0 })
  {
    Scene scene(speed);
    scene.addMotions(2);
    scene.metrics->Update();
    good &= require(!scene.observer->GetError() && !scene.observer->GetWarning(), "no message");
    good &= require(std::abs(scene.value("SlideRatio") - (1.0 - speed)) < 0.005, "slide ratio");
    good &= require(std::abs(scene.value("MeanMotion") - std::hypot(1.3, 0.7)) < 1e-5, "motion");
    good &= require(scene.value("BoilLargest") < 0.0005, "no boil");
    good &= require(std::abs(scene.value("Contrast") - 1.0) < 0.01, "contrast");
    good &= require(std::isnan(scene.value("FacingSlope")), "n.v is constant");
    vtkTable* frames = scene.metrics->GetOutput(1);
    good &= require(frames->GetNumberOfRows() == 2, "a row for each motion");
    good &= require(frames->GetValueByName(1, "Blocks").ToInt() > 4, "blocks");
    // The two waves have 0.1106 and 0.0928 periods per pixel.
    const double frequency = frames->GetValueByName(0, "Frequency").ToDouble();
    good &= require(std::abs(frequency - 0.1017) < 0.006, "frequency " + std::to_string(frequency));
  }
  Scene quick(1.0, 2);
  quick.addMotions(2); // one for the last frame as well
  quick.metrics->SetWavelength(3.0);
  quick.metrics->SetReference(
    makeImage(1, [](double x, double y, int) { return 0.25 + 0.5 * ink(x, y); }));
  quick.metrics->Update();
  good &= require(std::abs(quick.value("Contrast") - 2.0) < 0.02, "contrast of the reference");
  return good;
}

bool comparesWithTheReference()
{
  Scene none;
  none.addMotions(2);
  none.metrics->Update();
  bool good = require(none.rowOf("CooccurrenceError") < 0, "no error without a reference") &&
    require(std::isnan(none.ofFrame(0, "CooccurrenceError")), "nor of a frame");
  for (const double stretch : { 1.0, 2.0 })
  {
    Scene scene;
    scene.addMotions(2);
    scene.metrics->SetReference(makeImage(1,
      [stretch](double x, double y, int) { return ink(10.0 - y / stretch, x); })); // turned by 90
    scene.metrics->Update();
    const double error = scene.value("CooccurrenceError");
    good &= require(!scene.observer->GetError(), "no error message");
    good &= require(stretch > 1.0 ? error > 0.1 : error < 0.03, "error " + std::to_string(error));
    good &= require(std::abs(scene.ofFrame(1, "CooccurrenceError") - error) < 0.03, "of a frame");
  }
  return good;
}

bool measuresTones()
{
  Scene scene(0.0, 2);
  scene.metrics->AddTone(makeImage(1, [](double, double, int) { return 0.4; }));
  scene.metrics->AddCells(makeImage(1, [](double x, double, int) { return x < 48 ? 1 : 2; }));
  scene.metrics->AddCells(makeImage(1, [](double x, double, int) { return x < 48 ? 1 : 2; }));
  scene.metrics->Update();
  return require(!scene.observer->GetError(), "no error without motions") &&
    require(std::abs(scene.value("ToneError") - 0.1) < 0.01, "tone error") &&
    require(scene.value("ToneFlicker") == 0.0, "no flicker");
}

bool measuresStipples()
{
  Scene scene(0.0, 0);
  for (const int count : { 400, 200 })
  {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < count; ++i)
    {
      const int column = i % 20;
      const int row = i / 20;
      points->InsertNextPoint(column + 0.5, row + 0.5, 3.0);
    }
    vtkNew<vtkPolyData> set;
    set->SetPoints(points);
    scene.metrics->AddStipples(set);
  }
  scene.metrics->SetStippleWindow(0.0, 20.0, 0.0, 20.0);
  scene.metrics->PeriodicStipplesOn();
  scene.metrics->Update();
  // Squares of side 1: R = 2 at density 1 and sqrt 2 at density 1/2, on average.
  return require(std::abs(scene.value("ClarkEvans") - 0.5 * (2.0 + std::sqrt(2.0))) < 1e-4, "R") &&
    require(scene.value("Nesting") == 1.0, "nesting") &&
    require(scene.metrics->GetOutput(2)->GetNumberOfRows() == 16, "a spectrum of 16 rings");
}

bool wrongMotionsAreRefused()
{
  const auto steady = [](double, double, int k) { return k < 2 ? shift[k] : 1.0; };
  Scene narrow;
  narrow.addMotions(1);
  narrow.metrics->AddMotion(makeImage(3, steady, 50));
  bool good = narrow.refuses("motion 1: 50 x 96 pixels, expected the size of frame 0, 96 x 96");
  const char* const messages[] = { "motion 0: motion nan at pixel (3, 2), expected finite pixels",
    "motion 0: motion nan at pixel (3, 2)", "motion 0: visible nan at pixel (3, 2)",
    "motion 0: facing nan at pixel (3, 2)", "motion 0: distance nan at pixel (3, 2)" };
  for (int broken = 0; broken < 5; ++broken)
  {
    Scene scene(1.0, 2);
    scene.metrics->AddMotion(makeImage(5,
      [=](double x, double y, int k)
      {
        return k == broken && x == 3 && y == 2 ? std::numeric_limits<double>::quiet_NaN()
                                               : steady(x, y, k);
      }));
    good &= scene.refuses(messages[broken]);
  }
  Scene tones(0.0, 3);
  tones.metrics->AddTone(makeImage(1, [](double, double, int) { return 0.5; }));
  tones.metrics->AddTone(makeImage(1, [](double, double, int) { return 0.5; }));
  good &= tones.refuses("tones: 2 for 3 frames");
  return good;
}

bool wrongReferencesAreRefused()
{
  const auto refused = [](vtkImageData* reference, const char* message)
  {
    Scene scene;
    scene.addMotions(2);
    scene.metrics->SetReference(reference);
    return scene.refuses(message);
  };
  const auto even = [](double, double, int) { return 0.5; };
  const auto broken = [](double x, double y, int)
  { return x + y > 0 ? 0.5 : std::numeric_limits<double>::quiet_NaN(); };
  bool good = refused(vtkNew<vtkImageData>(), "reference 0: 0 x 0 x 0 pixels");
  good &= refused(makeImage(1, even, 41), "reference: 41 x 96 pixels, expected at least 42 x 42");
  good &= refused(makeImage(3, even), "reference 0: scalars 'ImageScalars' have 3 components");
  good &= refused(makeImage(1, broken), "reference: ink nan at pixel (0, 0)");
  return good;
}

bool wrongInputIsRefused()
{
  bool good = Scene(1.0, 0).refuses("Nothing to measure");
  good &= Scene(1.0, 3).refuses("motions: none");
  Scene single(1.0, 1);
  single.addMotions(1);
  good &= single.refuses("frames: 1, expected at least 2");
  Scene few(1.0, 4);
  few.addMotions(2);
  good &= few.refuses("motions: 2 for 4 frames");
  Scene thin;
  thin.addMotions(2, 2);
  good &= thin.refuses("motion 0: scalars 'ImageScalars' have 2 components, expected u, v");
  Scene hidden;
  hidden.addMotions(2, 3, 0.0f);
  good &= hidden.refuses("motion 0: no pixel is visible");
  Scene sizes;
  sizes.metrics->AddFrame(makeImage(
    1, [](double, double, int) { return 0.0; }, 50));
  sizes.addMotions(3);
  good &= sizes.refuses("frame 3: 50 x 96 pixels, expected the size of frame 0, 96 x 96");
  Scene broken;
  broken.metrics->AddFrame(makeImage(1,
    [](double x, double y, int)
    { return x == 2 && y == 1 ? std::numeric_limits<double>::quiet_NaN() : 0.5; }));
  broken.addMotions(3);
  good &= broken.refuses("frame 3: ink nan at pixel (2, 1)");
  good &= wrongMotionsAreRefused() && wrongReferencesAreRefused();
  Scene colours;
  colours.metrics->AddFrame(makeImage(3, [](double, double, int) { return 0.5; }));
  good &=
    colours.refuses("frame 3: scalars 'ImageScalars' have 3 components, expected 1 component");
  Scene stipples(1.0, 0);
  stipples.metrics->AddStipples(vtkNew<vtkPolyData>());
  good &= stipples.refuses("window: ");
  return good;
}

bool fastMotionIsNoted()
{
  Scene scene;
  scene.addMotions(2);
  scene.metrics->SetWavelength(3.0); // less than twice 1.48
  scene.metrics->Update();
  bool good = require(!scene.observer->GetWarning(), "no note at 1.48 of 1.5 pixels");
  Scene fast(1.0, 2);
  fast.metrics->SetWavelength(4.0);
  fast.metrics->AddMotion(makeImage(3, [](double, double, int k) { return k == 0 ? 2.5 : k - 1; }));
  fast.metrics->Update();
  good &= require(fast.observer->GetWarningMessage().find("up to 2.5 pixels") != std::string::npos,
    "a note at 2.5 of 2 pixels");
  return good;
}

} // namespace

int TestPatternMetrics(int, char*[])
{
  const bool good[] = { measuresClips(), comparesWithTheReference(), measuresTones(),
    measuresStipples(), wrongInputIsRefused(), fastMotionIsNoted() };
  return std::all_of(std::begin(good), std::end(good), [](bool one) { return one; }) ? EXIT_SUCCESS
                                                                                     : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPatternImageSource.h"

#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{

bool require(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Not so: " << what << "\n";
  }
  return condition;
}

// A source whose errors and warnings are kept.
struct Scene
{
  vtkNew<vtkPatternImageSource> source;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkImageData> picture;

  Scene()
  {
    this->source->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->source->AddObserver(vtkCommand::WarningEvent, this->observer);
    this->source->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->source->SetSize(64);
    this->source->SetPeriods(4);
  }

  float* giveGrey(int width, int height, int depth = 1)
  {
    this->picture->SetDimensions(width, height, depth);
    vtkNew<vtkFloatArray> grey;
    grey->SetName("grey");
    grey->SetNumberOfTuples(this->picture->GetNumberOfPoints());
    this->picture->GetPointData()->SetScalars(grey);
    for (vtkIdType i = 0; i < grey->GetNumberOfTuples(); ++i)
    {
      grey->SetValue(i, static_cast<float>(i));
    }
    this->source->SetInputData(this->picture);
    this->source->SetPatternToImage();
    return grey->GetPointer(0);
  }

  bool refuses(const std::string& message)
  {
    this->observer->Clear();
    this->source->Update();
    return require(this->observer->GetError() &&
        this->observer->GetErrorMessage().find(message) != std::string::npos,
      "an error with '" + message + "', but: " + this->observer->GetErrorMessage());
  }

  bool accepts()
  {
    this->observer->Clear();
    this->source->Update();
    return require(!this->observer->GetError(), this->observer->GetErrorMessage());
  }
};

bool uniform(vtkImageData* image)
{
  vtkDataArray* screen = image->GetPointData()->GetScalars();
  const vtkIdType count = screen ? screen->GetNumberOfTuples() : 0;
  std::vector<double> values(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    values[i] = screen->GetComponent(i, 0);
  }
  std::sort(values.begin(), values.end());
  // Sorted values are the centres of equal steps; those that share a value share the centre.
  double worst = 0.0;
  for (auto first = values.begin(); first != values.end();)
  {
    const auto last = std::upper_bound(first, values.end(), *first);
    const double centre =
      0.5 * static_cast<double>((first - values.begin()) + (last - values.begin()));
    worst = std::max(worst, std::abs(*first * static_cast<double>(count) - centre));
    first = last;
  }
  return require(count > 0 && worst < 0.5, "a uniform screen");
}

bool patternsAreUniform()
{
  Scene scene;
  bool good = true;
  for (int pattern = 0; pattern <= vtkPatternImageSource::PAPER; ++pattern)
  {
    if (pattern == vtkPatternImageSource::IMAGE)
    {
      continue;
    }
    for (const double irregularity : { 0.0, 0.7 })
    {
      scene.source->SetPattern(pattern);
      scene.source->SetIrregularity(irregularity);
      good &= scene.accepts() && uniform(scene.source->GetOutput());
      good &= require(scene.source->GetOutput()->GetNumberOfPoints() == 64 * 64, "the size");
      good &= require(
        scene.source->GetOutput()->GetPointData()->HasArray("Gradient"), "an array Gradient");
    }
  }
  return good;
}

bool picturesKeepTheirOrder()
{
  Scene scene;
  scene.giveGrey(15, 7);
  bool good = scene.accepts() && uniform(scene.source->GetOutput());
  vtkDataArray* screen = scene.source->GetOutput()->GetPointData()->GetScalars();
  good &= require(screen->GetComponent(0, 0) < screen->GetComponent(1, 0), "dark first");
  good &= require(!scene.observer->GetWarning(), "silence about many levels");
  good &= require(scene.source->GetNumberOfLevels() == 105, "105 levels");
  return good;
}

// All texels that show a dab lead to one place, which lies on the tile or one of its repetitions.
bool paintLeadsToItsDabs()
{
  Scene scene;
  scene.source->SetPatternToPaint();
  bool good = scene.accepts();
  vtkImageData* image = scene.source->GetOutput();
  for (const std::string prefix : { "Dab", "LowerDab" })
  {
    vtkDataArray* offset = image->GetPointData()->GetArray((prefix + "Offset").c_str());
    vtkDataArray* alpha = image->GetPointData()->GetArray((prefix + "Alpha").c_str());
    vtkDataArray* index = image->GetPointData()->GetArray((prefix + "Index").c_str());
    if (!require(offset && alpha && index && offset->GetNumberOfComponents() == 2, prefix))
    {
      return false;
    }
    std::vector<double> places(2 * 16, -1.0);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const int dab = static_cast<int>(index->GetComponent(i, 0));
      good &= dab >= 0 && dab < 16 && alpha->GetComponent(i, 0) >= 0.0;
      for (int axis = 0; axis < 2 && good; ++axis)
      {
        const double texel = static_cast<double>(axis == 0 ? i % 64 : i / 64) + 0.5;
        const double place = texel / 64.0 + offset->GetComponent(i, axis);
        double& known = places[2 * dab + axis];
        known = known < 0.0 ? place - std::floor(place) : known;
        good &= std::abs(place - known - std::round(place - known)) < 1e-5;
      }
    }
  }
  good &= require(image->GetPointData()->HasArray("PaintHeight"), "an array PaintHeight");
  return require(good, "texels lead to the centres of their dabs");
}

bool fewLevelsAreNoted()
{
  Scene scene;
  float* grey = scene.giveGrey(8, 8);
  for (int i = 0; i < 64; ++i)
  {
    grey[i] = static_cast<float>(i % 3);
  }
  bool good = scene.accepts();
  good &= require(scene.observer->GetWarning() &&
      scene.observer->GetWarningMessage().find("only 3 distinct values") != std::string::npos,
    "a note about 3 levels");
  return good && uniform(scene.source->GetOutput());
}

bool wrongInputIsRefused()
{
  bool good = true;
  {
    Scene scene;
    scene.source->SetPatternToImage();
    good &= scene.refuses("no image is connected");
    scene.giveGrey(4, 4);
    good &= scene.accepts(); // and it recovers
  }
  {
    Scene scene;
    scene.giveGrey(4, 4)[5] = std::numeric_limits<float>::quiet_NaN();
    good &= scene.refuses("'grey'") && scene.refuses("nan at texel 5");
  }
  {
    Scene scene;
    scene.giveGrey(4, 4, 3);
    good &= scene.refuses("3 slices");
  }
  {
    Scene scene;
    scene.source->SetInputData(scene.picture);
    scene.source->SetPatternToImage();
    good &= scene.refuses("empty");
    scene.picture->SetDimensions(4, 4, 1);
    good &= scene.refuses("no numeric point scalars");
    vtkNew<vtkStringArray> words;
    words->SetName("words");
    words->SetNumberOfValues(16);
    scene.picture->GetPointData()->AddArray(words);
    good &= scene.refuses("no numeric point scalars");
    vtkNew<vtkFloatArray> wide;
    wide->SetName("wide");
    wide->SetNumberOfComponents(9);
    wide->SetNumberOfTuples(16);
    scene.picture->GetPointData()->SetScalars(wide);
    good &= scene.refuses("'wide' has 9 components, expected 1 to 4");
  }
  {
    Scene scene;
    scene.source->SetPeriods(40);
    good &= scene.refuses("periods: 40");
    scene.source->SetPeriods(8);
    scene.source->SetDensities(3);
    good &= scene.refuses("densities: 3 make 32 lines of 8 periods");
    scene.source->SetPatternToPaper();
    scene.source->SetGrain(0.0);
    scene.source->SetFibres(0.0);
    good &= scene.refuses("grain: 0, and fibres, laid and weave are 0");
  }
  return good;
}

} // namespace

int TestPatternImageSource(int, char*[])
{
  bool good = patternsAreUniform();
  good &= picturesKeepTheirOrder();
  good &= paintLeadsToItsDabs();
  good &= fewLevelsAreNoted();
  good &= wrongInputIsRefused();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

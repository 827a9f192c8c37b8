// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPatternImageSource.h"
#include "vtkToneCorrectionTable.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

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

struct Scene
{
  vtkNew<vtkPatternImageSource> source;
  vtkNew<vtkToneCorrectionTable> table;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkImageData> tile; // a copy that can be damaged

  Scene()
  {
    this->table->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->table->AddObserver(vtkCommand::WarningEvent, this->observer);
    this->table->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->source->SetSize(128);
    this->source->SetPeriods(4);
    this->source->Update();
    this->tile->DeepCopy(this->source->GetOutput());
    this->table->SetInputData(this->tile);
  }

  bool refuses(const std::string& message)
  {
    this->observer->Clear();
    this->table->Modified();
    this->table->Update();
    return require(this->observer->GetError() &&
        this->observer->GetErrorMessage().find(message) != std::string::npos,
      "an error with '" + message + "', but: " + this->observer->GetErrorMessage());
  }
};

// At scale 1 a ruled hatch has the closed form of section 6: t' = sqrt(2 w t) - w/2 and t' = t
// between.
bool agreesWithTheClosedForm()
{
  Scene scene;
  scene.table->Update();
  vtkImageData* output = scene.table->GetOutput();
  int dimensions[3];
  output->GetDimensions(dimensions);
  vtkDataArray* threshold = output->GetPointData()->GetScalars();
  bool good = require(!scene.observer->GetError() && threshold != nullptr, "a table");
  good &= require(dimensions[0] == 256 && dimensions[1] == 96, "256 x 96");
  constexpr double width = 0.25; // 2 / (8 pixels per period)
  for (int i = 2; good && i < 254; ++i)
  {
    const double tone = i / 255.0;
    const double rest = 1.0 - tone;
    double expected = tone;
    if (tone < 0.5 * width)
    {
      expected = std::sqrt(2.0 * width * tone) - 0.5 * width;
    }
    else if (rest < 0.5 * width)
    {
      expected = 1.0 + 0.5 * width - std::sqrt(2.0 * width * rest);
    }
    good &= require(std::abs(threshold->GetComponent(i, 0) - expected) < 0.02,
      "threshold " + std::to_string(expected) + " at tone " + std::to_string(tone));
  }
  return good;
}

bool wrongInputIsRefused()
{
  bool good = true;
  {
    Scene scene;
    scene.table->SetLodStart(1.6);
    scene.table->SetLodEnd(1.2);
    good &= scene.refuses("lodEnd: 1.2");
  }
  {
    Scene scene;
    vtkFloatArray::SafeDownCast(scene.tile->GetPointData()->GetArray("Screen"))->SetValue(7, NAN);
    good &= scene.refuses("nan of point array 'Screen' at point 7");
    scene.tile->GetPointData()->RemoveArray("Gradient");
    vtkFloatArray::SafeDownCast(scene.tile->GetPointData()->GetArray("Screen"))->SetValue(7, 0.5f);
    good &= scene.refuses("no point array 'Gradient'");
    scene.tile->Initialize();
    good &= scene.refuses("0 x 0 x 0");
  }
  {
    Scene scene;
    scene.tile->GetFieldData()->RemoveArray("Periods");
    scene.table->SetPeriodInPixels(32.0);
    scene.table->Update();
    good &= require(scene.observer->GetWarning() &&
        scene.observer->GetWarningMessage().find("'Periods'") != std::string::npos,
      "a note that Periods is missing");
    good &= require(!scene.observer->GetError(), "a table without Periods");
  }
  return good;
}

} // namespace

int TestToneCorrectionTable(int, char*[])
{
  bool good = agreesWithTheClosedForm();
  good &= wrongInputIsRefused();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

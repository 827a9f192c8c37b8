// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wrong input and its messages.

#include "vtkStratifiedSurfaceSampler.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>
#include <iostream>
#include <limits>

namespace
{
vtkSmartPointer<vtkPolyData> makePlane()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(2, 1);
  plane->Update();
  return plane->GetOutput();
}

/// Runs the filter with the patch array "region"; 0 if the error is as expected and there is no
/// output.
int expectError(vtkDataObject* input, const char* message)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  vtkNew<vtkStratifiedSurfaceSampler> sampler;
  sampler->AddObserver(vtkCommand::ErrorEvent, observer);
  sampler->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  sampler->SetPatchArrayName("region");
  sampler->SetInputDataObject(input);
  sampler->Update();
  return observer->CheckErrorMessage(message) + (sampler->GetOutput()->GetNumberOfPoints() > 0);
}

template <class ArrayType>
vtkSmartPointer<ArrayType> makeRegion(int values, int components = 1)
{
  const auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName("region");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(values);
  for (int i = 0; i < values * components; ++i)
  {
    array->SetValue(i, {});
  }
  return array;
}

int testPatchArrays()
{
  auto plane = makePlane();
  int failures = expectError(plane, "Patch array 'region' is missing; expected a cell array");

  plane->GetPointData()->AddArray(makeRegion<vtkIntArray>(6));
  failures += expectError(plane, "Patch array 'region' is a point array");

  plane->GetCellData()->AddArray(makeRegion<vtkDoubleArray>(2));
  failures += expectError(plane, "Patch array 'region' has values of type double");

  plane->GetCellData()->AddArray(makeRegion<vtkStringArray>(2));
  failures += expectError(plane, "Patch array 'region' has values of type string");

  plane->GetCellData()->AddArray(makeRegion<vtkIntArray>(2, 3));
  failures += expectError(plane, "Patch array 'region' has 3 components");

  plane->GetCellData()->AddArray(makeRegion<vtkIntArray>(1));
  failures += expectError(plane, "Patch array 'region' has 1 values for 2 cells");

  auto large = makeRegion<vtkIntArray>(2);
  large->SetValue(1, 16777216);
  plane->GetCellData()->AddArray(large);
  failures += expectError(plane, "has the value 16777216; ids must be below 16777216");

  plane = makePlane();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, plane);
  return failures + expectError(blocks, "Patch array 'region' is missing in block 2");
}

int testGeometry()
{
  vtkNew<vtkImageData> image;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  int failures = expectError(blocks, "Block 1 is a vtkImageData; expected a vtkPolyData");

  auto plane = makePlane();
  plane->GetCellData()->AddArray(makeRegion<vtkIntArray>(3));
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(plane->GetPolys());
  polygons->InsertNextCell({ 0, 1, 6 });
  plane->SetPolys(polygons);
  return failures + expectError(plane, "Cell 2 refers to point 6; there are 6 points");
}

/// Cells with a NaN or an infinite corner are left out, with one warning that counts the points.
int testNonFinite()
{
  auto plane = makePlane(); // two quads; point 2 is a corner of the second alone
  vtkNew<vtkPoints> points;
  points->DeepCopy(plane->GetPoints());
  points->SetPoint(2, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  points->InsertNextPoint(0, std::numeric_limits<double>::infinity(), 0); // no cell's
  plane->SetPoints(points);

  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkStratifiedSurfaceSampler> sampler;
  sampler->AddObserver(vtkCommand::ErrorEvent, observer);
  sampler->AddObserver(vtkCommand::WarningEvent, observer);
  sampler->SetInputData(plane);
  sampler->Update();
  int failures = observer->GetError() ? 1 : 0;
  failures +=
    observer->CheckWarningMessage("2 input point(s) have a coordinate that is not finite");
  vtkPolyData* samples = sampler->GetOutput();
  failures += samples->GetNumberOfPoints() > 450 ? 0 : 1;
  failures += samples->GetPointData()->GetArray("CellId")->GetRange()[1] == 0.0 ? 0 : 1;
  return failures;
}
} // namespace

int TestStratifiedSurfaceSamplerInput(int, char*[])
{
  const int failures = testPatchArrays() + testGeometry() + testNonFinite();
  if (failures > 0)
  {
    std::cerr << failures << " checks failed\n";
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

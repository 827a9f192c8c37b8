// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wrong input of the filters about patches, and its messages.

#include "vtkPatchBlendWeights.h"
#include "vtkSurfacePatches.h"

#include <vtkCamera.h>
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

/// Runs a filter; 0 if the error is as expected and there is no output.
int expectError(vtkPassInputTypeAlgorithm* filter, vtkDataObject* input, const char* message)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  filter->SetInputDataObject(input);
  filter->Update();
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  return observer->CheckErrorMessage(message) + (output && output->GetNumberOfPoints() > 0);
}

int expectPatchError(vtkDataObject* input, int method, const char* array, const char* message)
{
  vtkNew<vtkSurfacePatches> filter;
  filter->SetMethod(method);
  filter->SetArrayName(array);
  return expectError(filter, input, message);
}

template <class ArrayType>
vtkSmartPointer<ArrayType> makeArray(int values, int components = 1)
{
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName("region");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(values);
  array->FillValue(0);
  return array;
}

int testArrays()
{
  const int method = vtkSurfacePatches::ARRAY;
  auto plane = makePlane();
  int failures = expectPatchError(plane, method, "", "ArrayName is empty");
  failures += expectPatchError(plane, method, "region", "Patch array 'region' is missing");
  plane->GetCellData()->AddArray(makeArray<vtkIntArray>(2, 3));
  failures += expectPatchError(plane, method, "region", "Patch array 'region' has 3 components");
  plane->GetCellData()->AddArray(makeArray<vtkIntArray>(5));
  failures += expectPatchError(plane, method, "region", "has 5 values for 2 cells");
  auto fraction = makeArray<vtkDoubleArray>(2);
  fraction->SetValue(1, 0.5);
  plane->GetCellData()->AddArray(fraction);
  failures += expectPatchError(plane, method, "region", "has the value 0.5 at cell 1");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePlane());
  failures += expectPatchError(blocks, method, "region", "is missing in block 1");
  return failures;
}

int testGeometry()
{
  const int method = vtkSurfacePatches::AUTOMATIC;
  auto plane = makePlane();
  vtkNew<vtkPoints> points;
  points->DeepCopy(plane->GetPoints());
  points->InsertNextPoint(0, std::numeric_limits<double>::infinity(), 0); // no cell's
  plane->SetPoints(points);
  vtkNew<vtkSurfacePatches> good;
  good->SetInputData(plane);
  good->Update();
  int failures =
    good->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL) == 2 ? 0 : 1;

  points->SetPoint(4, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const char* message = "Point 4, a corner of cell 0, has a coordinate that is not finite";
  failures += expectPatchError(plane, method, "", message);
  vtkNew<vtkPatchBlendWeights> weights;
  auto region = makeArray<vtkIntArray>(2);
  region->SetName("PatchId");
  plane->GetCellData()->AddArray(region);
  failures += expectError(weights, plane, message);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkImageData>());
  return failures + expectPatchError(blocks, method, "", "Block 1 is a vtkImageData");
}

int testOptions()
{
  auto plane = makePlane();
  const int selection = vtkSurfacePatches::SELECTION;
  int failures = expectPatchError(plane, selection, "", "There is no selection on port 1");

  vtkNew<vtkSurfacePatches> sliding;
  sliding->SetMaximumSlide(1.0);
  vtkNew<vtkCamera> camera;
  sliding->AddCamera(camera);
  failures += expectError(sliding, plane, "expected two or more cameras: AddCamera");

  vtkNew<vtkPatchBlendWeights> weights;
  failures +=
    expectError(weights, plane, "Patch array 'PatchId' is missing; expected a cell array");
  vtkNew<vtkPatchBlendWeights> nameless;
  nameless->SetPatchArrayName("");
  return failures + expectError(nameless, plane, "PatchArrayName is empty");
}

/// A limit that cannot be kept is told, and the result is as good as allowed.
int testUnreachedLimit()
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkSurfacePatches> filter;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(makePlane());
  filter->SetNumberOfPatches(1);
  filter->SetMaximumNumberOfPatches(1);
  filter->SetMaximumSlide(1e-9);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 3);
  filter->AddCamera(camera);
  camera->Azimuth(20);
  filter->AddCamera(camera);
  filter->Update();
  return observer->CheckWarningMessage("With 1 patches some still slide more than 1e-09");
}
} // namespace

int TestSurfacePatchesInput(int, char*[])
{
  const int failures = testArrays() + testGeometry() + testOptions() + testUnreachedLimit();
  if (failures > 0)
  {
    std::cerr << failures << " checks failed\n";
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

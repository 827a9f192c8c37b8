// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wrong input of the direction field, and its messages.

#include "vtkSurfaceDirectionField.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
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

template <class ArrayType>
vtkSmartPointer<ArrayType> makeArray(const char* name, int tuples, int components = 1)
{
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// 0 if the error is as expected and there is no output.
int expectError(vtkDataObject* input, int method, const char* array, const char* message)
{
  vtkNew<vtkSurfaceDirectionField> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  filter->SetInputDataObject(input);
  filter->SetMethod(method);
  filter->SetArrayName(array);
  filter->Update();
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  return observer->CheckErrorMessage(message) + (output && output->GetNumberOfPoints() > 0);
}

int testScalars()
{
  const int method = vtkSurfaceDirectionField::GRADIENT;
  auto plane = makePlane();
  int failures = expectError(plane, method, "", "ArrayName is empty; expected the name");
  failures += expectError(plane, method, "heat",
    "Array 'heat' is missing; expected a point array of numbers with one component");
  plane->GetCellData()->AddArray(makeArray<vtkFloatArray>("heat", 2));
  failures += expectError(plane, method, "heat", "Array 'heat' is a cell array; expected a point");
  plane->GetPointData()->AddArray(makeArray<vtkStringArray>("heat", 6));
  failures += expectError(plane, method, "heat", "Array 'heat' has values of type string");
  plane->GetPointData()->AddArray(makeArray<vtkFloatArray>("heat", 6, 3));
  failures += expectError(plane, method, "heat", "Array 'heat' has 3 components");
  plane->GetPointData()->AddArray(makeArray<vtkFloatArray>("heat", 5));
  failures += expectError(plane, method, "heat", "Array 'heat' has 5 tuples for 6");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>()); // without polygons no array is missed
  blocks->SetBlock(1, makePlane());
  return failures + expectError(blocks, method, "heat", "Array 'heat' is missing in block 2");
}

int testVectors()
{
  const int method = vtkSurfaceDirectionField::VECTORS;
  auto plane = makePlane();
  int failures = expectError(plane, method, "flow",
    "Array 'flow' is missing; expected a point or cell array of numbers with three components");
  plane->GetCellData()->AddArray(makeArray<vtkFloatArray>("flow", 2, 1));
  failures += expectError(plane, method, "flow", "Array 'flow' has 1 component;");
  plane->GetPointData()->AddArray(makeArray<vtkFloatArray>("flow", 6, 2));
  return failures + expectError(plane, method, "flow", "Array 'flow' has 2 components;");
}

int testOthers()
{
  const int method = vtkSurfaceDirectionField::CURVATURE;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkImageData>());
  int failures = expectError(blocks, method, "", "Block 1 is a vtkImageData");
  vtkNew<vtkSurfaceDirectionField> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  filter->SetInputData(makePlane());
  filter->SetReferenceAxis(0.0, std::numeric_limits<double>::infinity(), 0.0);
  filter->Update();
  return failures + observer->CheckErrorMessage("options.axis is not finite");
}
} // namespace

int TestSurfaceDirectionFieldInput(int, char*[])
{
  const int failures = testScalars() + testVectors() + testOthers();
  if (failures > 0)
  {
    std::cerr << failures << " checks failed\n";
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

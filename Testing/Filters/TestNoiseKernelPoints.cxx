// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Kernels of valid input: where they lie, what they refer to, whose ids they have; wrong input.

#include "vtkNoiseKernelPoints.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTypeUInt64Array.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <set>
#include <string>

namespace
{
int failures = 0;

void check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Failed: " << what << "\n";
    ++failures;
  }
}

vtkSmartPointer<vtkPolyData> makePlane(int resolution = 4)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(resolution, resolution);
  plane->Update();
  return plane->GetOutput();
}

void addGlobalIds(vtkPolyData* surface, int first)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(first + i);
  }
  surface->GetCellData()->SetGlobalIds(ids);
}

// A viewport of 400 x 400 pixels that the unit square about the origin fills.
struct Filter
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkNoiseKernelPoints> points;

  Filter()
  {
    this->camera->SetPosition(0.0, 0.0, 4.0);
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(0.5);
    this->points->SetCamera(this->camera);
    this->points->SetViewportSize(400.0, 400.0);
    this->points->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->points->AddObserver(vtkCommand::WarningEvent, this->observer);
    this->points->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->executiveObserver);
  }

  vtkPolyData* run(vtkDataObject* input)
  {
    this->points->SetInputDataObject(input);
    this->points->Update();
    check(!this->observer->GetError() && !this->observer->GetWarning(), "valid input is silent");
    return this->points->GetOutput();
  }
};

double value(vtkPolyData* output, const char* name, vtkIdType i, int component = 0)
{
  return output->GetPointData()->GetArray(name)->GetComponent(i, component);
}

std::set<vtkTypeUInt64> idsOf(vtkPolyData* output)
{
  std::set<vtkTypeUInt64> ids;
  auto* array =
    vtkTypeUInt64Array::SafeDownCast(output->GetPointData()->GetAbstractArray("KernelId"));
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.insert(array->GetValue(i));
  }
  return ids;
}

void testPlaces()
{
  Filter filter;
  filter.points->SetOrientation(30.0);
  filter.points->SetSpread(10.0);
  vtkPolyData* output = filter.run(makePlane());
  // 32 kernels of pi 16^2 pixels in the sum of squares of 160000 pixels and the border.
  double squares = 0.0;
  double largestError = 0.0;
  bool inRange = true;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* place = output->GetPoint(i);
    for (int axis = 0; axis < 2; ++axis)
    {
      largestError = std::max(
        largestError, std::abs(400.0 * (place[axis] + 0.5) - value(output, "Center", i, axis)));
    }
    squares += std::pow(value(output, "Weight", i), 2.0);
    const double orientation = value(output, "Orientation", i);
    inRange = inRange && orientation >= 19.999 && orientation <= 40.001;
    inRange = inRange && std::abs(value(output, "Radius", i) - 16.0) < 1e-3;
    inRange = inRange && value(output, "Frequency", i) == 0.125;
    inRange = inRange && std::abs(value(output, "Bandwidth", i) * 16.0 - 0.9765) < 1e-3;
    inRange = inRange && value(output, "Phase", i) >= 0.0 && value(output, "Phase", i) <= 360.0;
    const auto cell = static_cast<int>(value(output, "CellId", i)); // 4 x 4 squares
    inRange = inRange && std::abs((cell % 4 + 0.5) / 4.0 - 0.5 - place[0]) < 0.1251;
    inRange = inRange && value(output, "BlockIndex", i) == 0.0;
  }
  check(largestError < 1e-3, "the centre is the image of the point");
  check(inRange, "parameters are those that were set");
  check(std::abs(squares / (32.0 * 160000.0 / 804.25) - 1.0) < 0.05, "overlap");
  check(output->GetNumberOfVerts() == output->GetNumberOfPoints(), "one vertex per kernel");
  check(static_cast<vtkIdType>(idsOf(output).size()) == output->GetNumberOfPoints(), "unique ids");
}

void testLevels()
{
  Filter filter;
  vtkPolyData* output = filter.run(makePlane());
  // All points come in below the density of the picture: 160000 pixels in one unit of area.
  const double highest = std::log2(160000.0 * 32.0 / 804.25 / 0.6);
  double top = -100.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    top = std::max(top, value(output, "Level", i));
  }
  check(top <= highest && top >= highest - 2.0, "the highest level is that of the picture");
  const std::set<vtkTypeUInt64> before = idsOf(output);
  filter.camera->SetParallelScale(0.25); // the camera must be noticed
  std::size_t kept = 0;
  for (const vtkTypeUInt64 id : idsOf(filter.run(makePlane())))
  {
    kept += before.count(id);
  }
  check(kept > before.size() / 5, "points stay in a nearer view");
}

void testGlobalIds()
{
  Filter filter;
  vtkSmartPointer<vtkPolyData> plane = makePlane();
  const std::set<vtkTypeUInt64> without = idsOf(filter.run(plane));
  addGlobalIds(plane, 100);
  plane->Modified();
  const std::set<vtkTypeUInt64> with = idsOf(filter.run(plane));
  check(with != without, "global ids are read");

  vtkNew<vtkTransform> transform;
  transform->Translate(0.01, 0.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputData(plane);
  moved->SetTransform(transform);
  moved->Update();
  std::size_t same = 0;
  for (const vtkTypeUInt64 id : idsOf(filter.run(moved->GetOutput())))
  {
    same += with.count(id);
  }
  check(same > with.size() * 9 / 10, "points move with a surface that has global ids");
}

void testBlocks()
{
  Filter filter;
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto plane = makePlane();
  addGlobalIds(plane, 100);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.2);
  sphere->Update();
  blocks->SetBlock(1, plane);
  blocks->SetBlock(2, sphere->GetOutput());
  vtkPolyData* output = filter.run(blocks);
  const std::set<vtkTypeUInt64> all = idsOf(output);
  std::size_t ofPlane = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double block = value(output, "BlockIndex", i);
    check(block == 2.0 || block == 3.0, "flat index of the block");
    ofPlane += block == 2.0 ? 1 : 0;
  }
  const std::set<vtkTypeUInt64> alone = idsOf(filter.run(plane));
  check(alone.size() == ofPlane, "a block has the points that it has alone");
  check(std::includes(all.begin(), all.end(), alone.begin(), alone.end()), "and their ids");
  vtkNew<vtkPolyData> empty;
  check(filter.run(empty)->GetNumberOfPoints() == 0, "no surface, no kernels");
}

void testClassic()
{
  Filter filter;
  filter.points->ClassicOn();
  const auto count = filter.run(makePlane(300))->GetNumberOfPoints();
  check(count == 180000, "classic has a point for every triangle");
  filter.points->ClassicOff();
  check(filter.run(makePlane(300))->GetNumberOfPoints() < 20000, "the default has not");
}

void testWrongInput()
{
  Filter filter;
  filter.points->SetInputDataObject(makePlane());
  filter.points->SetCamera(nullptr);
  filter.points->Update();
  failures += filter.observer->CheckErrorMessage("No camera, expected one");

  Filter image;
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkImageData> wrong;
  blocks->SetBlock(0, wrong);
  image.points->SetInputDataObject(blocks);
  image.points->Update();
  failures += image.observer->CheckErrorMessage("Block 1 is a vtkImageData");

  Filter strange;
  const auto plane = makePlane();
  plane->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  strange.points->SetInputDataObject(plane);
  strange.points->Update();
  failures += strange.observer->CheckWarningMessage("1 input point(s) have a coordinate");
  check(strange.points->GetOutput()->GetNumberOfPoints() > 1000, "all other cells have kernels");
}
} // namespace

int TestNoiseKernelPoints(int, char*[])
{
  testPlaces();
  testLevels();
  testGlobalIds();
  testBlocks();
  testClassic();
  testWrongInput();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

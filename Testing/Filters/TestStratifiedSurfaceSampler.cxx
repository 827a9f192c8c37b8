// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Samples of all kinds of valid input: where they lie, what they refer to, which way they face.

#include "vtkStratifiedSurfaceSampler.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <iostream>

namespace
{
int failures = 0;

void check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "Failed: " << what << "\n";
    ++failures;
  }
}

/// Runs the filter; any error or warning is a failure.
vtkSmartPointer<vtkPolyData> sample(vtkDataObject* input, bool patchByBlock = false)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkStratifiedSurfaceSampler> sampler;
  sampler->AddObserver(vtkCommand::ErrorEvent, observer);
  sampler->AddObserver(vtkCommand::WarningEvent, observer);
  sampler->SetPatchByBlock(patchByBlock);
  sampler->SetInputDataObject(input);
  sampler->Update();
  check(!observer->GetError() && !observer->GetWarning(), "valid input is sampled silently");
  return sampler->GetOutput();
}

double component(vtkPolyData* samples, const char* name, vtkIdType i, int index = 0)
{
  return samples->GetPointData()->GetArray(name)->GetComponent(i, index);
}

double spacing(vtkPolyData* samples, int patch = 0)
{
  return samples->GetFieldData()->GetArray("PatchSpacing")->GetComponent(patch, 0);
}

/// Every sample is where its point ids and barycentric coordinates say, on the cell it names.
void checkReferences(vtkPolyData* samples, vtkPolyData* input)
{
  double largestError = 0.0;
  bool pointsOfCell = true;
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    double position[3];
    samples->GetPoint(i, position);
    vtkNew<vtkIdList> cellPoints;
    input->GetCellPoints(static_cast<vtkIdType>(component(samples, "CellId", i)), cellPoints);
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType id = static_cast<vtkIdType>(component(samples, "PointIds", i, corner));
      pointsOfCell = pointsOfCell && cellPoints->IsId(id) >= 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] -= component(samples, "Barycentrics", i, corner) * input->GetPoint(id)[axis];
      }
    }
    largestError = std::max(largestError, vtkMath::Norm(position));
  }
  check(samples->GetNumberOfPoints() > 400, "there are samples");
  check(samples->GetNumberOfVerts() == samples->GetNumberOfPoints(), "one vertex per sample");
  check(largestError < 1e-12, "position = barycentric sum of the points named");
  check(pointsOfCell, "the points named belong to the cell named");
}

/// Smallest component of the normals along the position: 1 for a sphere seen from outside.
double smallestOutward(vtkPolyData* samples)
{
  double smallest = 1.0;
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    double position[3];
    double normal[3];
    samples->GetPoint(i, position);
    samples->GetPointData()->GetNormals()->GetTuple(i, normal);
    smallest = std::min(smallest, vtkMath::Dot(position, normal) / vtkMath::Norm(position));
  }
  return smallest;
}

void testSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputConnection(sphere->GetOutputPort());
  for (vtkAlgorithm* source : std::initializer_list<vtkAlgorithm*>{ sphere, strips, reverse })
  {
    source->Update();
    vtkPolyData* input = vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
    const auto samples = sample(input);
    checkReferences(samples, input);
    check(smallestOutward(samples) > 0.99, "normals point outward");
    check(std::fabs(spacing(samples) - std::sqrt(vtkMath::Pi() / 500.0)) < 1e-3, "spacing");
  }
  check(strips->GetOutput()->GetNumberOfStrips() > 0, "the strips are strips");
}

void testBowlKeepsItsNormals()
{
  vtkNew<vtkSphereSource> bowl;
  bowl->SetStartPhi(90.0);
  vtkNew<vtkReverseSense> reverse; // seen from above, inside
  reverse->SetInputConnection(bowl->GetOutputPort());
  reverse->Update();
  check(smallestOutward(sample(reverse->GetOutput())) < -0.9, "an open surface is not turned over");
}

/// A concave polygon, after vertices, lines and a polygon without area.
vtkSmartPointer<vtkPolyData> makeMixed()
{
  const double corners[6][3] = { { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 0 }, { 2, 0, 0 },
    { 2, 1, 0 } }; // an L, first the inner corner
  const auto mixed = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const double* corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0, 1 });
  vertices->InsertNextCell({ 2 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2, 5 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 3, 3, 4 });
  polygons->InsertNextCell({ 5, 0, 1, 2, 3, 4 });
  mixed->SetPoints(points);
  mixed->SetVerts(vertices);
  mixed->SetLines(lines);
  mixed->SetPolys(polygons);
  return mixed;
}

void testMixedCells()
{
  const auto mixed = makeMixed();
  const auto samples = sample(mixed);
  checkReferences(samples, mixed);
  bool isInside = true;
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    const double* position = samples->GetPoint(i);
    isInside = isInside && !(position[0] > 1.0 && position[1] > 1.0);
    check(component(samples, "CellId", i) == 4.0, "vertices and lines count as cells");
  }
  check(isInside, "no sample in the notch of a concave polygon");
  check(std::fabs(spacing(samples) - std::sqrt(3.0 / 500.0)) < 1e-12, "area of the polygon");

  mixed->GetPolys()->InsertNextCell({ 0, 1 }); // not a polygon
  mixed->Modified();
  check(sample(mixed)->GetNumberOfPoints() == samples->GetNumberOfPoints(), "two corners");

  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(mixed->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(4, vtkDataSetAttributes::DUPLICATECELL);
  mixed->GetCellData()->AddArray(ghosts);
  check(sample(mixed)->GetNumberOfPoints() == 0, "ghost cells take no samples");
}

void testEmpty()
{
  vtkNew<vtkPolyData> empty;
  check(sample(empty)->GetNumberOfPoints() == 0, "no points, no samples");
  vtkNew<vtkLineSource> line;
  line->Update();
  check(sample(line->GetOutput())->GetNumberOfPoints() == 0, "a line has no samples");
  vtkNew<vtkMultiBlockDataSet> blocks;
  check(sample(blocks, true)->GetNumberOfPoints() == 0, "no blocks, no samples");
}

void testBlocks()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, cube->GetOutput());
  vtkNew<vtkMultiBlockDataSet> blocks; // flat indices: 1 null, 2 empty, 3 sphere, 4 inner, 5 cube
  blocks->SetNumberOfBlocks(4);
  blocks->SetBlock(1, empty);
  blocks->SetBlock(2, sphere->GetOutput());
  blocks->SetBlock(3, inner);

  const auto samples = sample(blocks, true);
  const auto alone = sample(cube->GetOutput());
  vtkIdType inCube = 0;
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    const double block = component(samples, "BlockIndex", i);
    check(block == 3.0 || block == 5.0, "flat index of the block");
    check(component(samples, "PatchId", i) == block, "the patch is the block");
    const double id = component(samples, "SampleId", i);
    check(std::floor(id / 500.0) == block, "the sample id names the patch");
    if (block == 5.0)
    {
      ++inCube;
      const vtkIdType point = static_cast<vtkIdType>(component(samples, "PointIds", i));
      check(point < cube->GetOutput()->GetNumberOfPoints(), "point ids count within the block");
    }
  }
  check(inCube > 480 && inCube <= 500, "samples per block");
  check(std::fabs(spacing(samples, 5) - spacing(alone)) < 1e-12, "spacing of a block");
  check(spacing(samples, 4) == 0.0, "spacing of no surface");
  check(sample(blocks)->GetNumberOfPoints() <= 500, "one patch over all blocks");
}
} // namespace

int TestStratifiedSurfaceSampler(int, char*[])
{
  testSphere();
  testBowlKeepsItsNormals();
  testMixedCells();
  testEmpty();
  testBlocks();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

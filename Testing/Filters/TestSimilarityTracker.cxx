// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSimilarityTracker.h"
#include "vtkStratifiedSurfaceSampler.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkVariant.h>

#include <cmath>
#include <cstdlib>
#include <functional>
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

bool near(double a, double b, double tolerance, const std::string& what)
{
  return require(
    std::abs(a - b) <= tolerance, what + " is " + std::to_string(a) + ", not " + std::to_string(b));
}

// A sphere off the centre of the picture, its samples, and two cameras that look at the origin.
struct Scene
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyData> samples;
  vtkNew<vtkCamera> before;
  vtkNew<vtkCamera> after;
  vtkNew<vtkSimilarityTracker> tracker;

  explicit Scene(bool insideOut = false)
  {
    this->sphere->SetCenter(0.4, 0.2, 0.0);
    this->sphere->SetThetaResolution(48);
    this->sphere->SetPhiResolution(24);
    vtkNew<vtkStratifiedSurfaceSampler> sampler;
    vtkNew<vtkReverseSense> reverse;
    reverse->SetInputConnection(this->sphere->GetOutputPort());
    sampler->SetInputConnection(
      insideOut ? reverse->GetOutputPort() : this->sphere->GetOutputPort());
    sampler->Update();
    this->samples->DeepCopy(sampler->GetOutput());
    this->before->SetPosition(0.0, 0.0, 8.0);
    this->after->SetPosition(0.0, 0.0, 8.0);
    this->tracker->SetInputData(0, this->samples);
    this->tracker->SetCameraBefore(this->before);
    this->tracker->SetCameraAfter(this->after);
  }

  double value(const char* name)
  {
    this->tracker->Update();
    return this->tracker->GetOutput()->GetValueByName(0, name).ToDouble();
  }

  std::string status()
  {
    this->tracker->Update();
    return this->tracker->GetOutput()->GetValueByName(0, "Status").ToString();
  }

  vtkSmartPointer<vtkPolyData> turnedSphere(double degrees)
  {
    vtkNew<vtkTransform> transform;
    transform->RotateY(degrees);
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetInputConnection(this->sphere->GetOutputPort());
    filter->SetTransform(transform);
    filter->Update();
    return filter->GetOutput();
  }
};

bool testCameras()
{
  Scene scene;
  bool good = near(scene.value("Scale"), 1.0, 1e-12, "Scale of equal cameras");
  good &= near(scene.value("UX"), 1.0, 1e-12, "UX of equal cameras");
  const double x = scene.value("OriginX") - 400.0;
  const double y = scene.value("OriginY") - 300.0;
  good &=
    require(x > 10.0 && y > 5.0, "the pattern begins at the sphere, right of and above centre");

  scene.after->Roll(90.0); // the image turns with the camera's angle, about the line of sight
  good &= near(scene.value("AngleDegrees"), 90.0, 1e-9, "AngleDegrees after a roll");
  good &= near(scene.value("OriginX") - 400.0, -y, 1e-9, "OriginX after a roll");
  good &= near(scene.value("OriginY") - 300.0, x, 1e-9, "OriginY after a roll");
  good &= near(scene.value("UY"), 1.0, 1e-12, "UY after a roll");
  good &= near(scene.value("VX"), -1.0, 1e-12, "VX after a roll");
  good &= near(scene.value("ZImaginary"), 1.0, 1e-12, "ZImaginary after a roll");

  scene.after->SetPosition(0.0, 0.0, -8.0);
  good &= require(scene.status() == "NoSamples", "nothing is in sight of both sides");
  good &= near(scene.value("Scale"), 1.0, 0.0, "Scale without samples");
  return good;
}

// Turning the mesh is turning the camera the other way, whatever the orientation of the triangles.
bool testMeshes(bool insideOut)
{
  Scene byCamera(insideOut), byMesh(insideOut);
  byCamera.after->Azimuth(-15.0);
  byMesh.tracker->SetInputData(2, byMesh.turnedSphere(15.0));
  bool good = true;
  for (const char* name : { "OriginX", "OriginY", "UX", "UY", "WeightSum", "Residual" })
  {
    const double expected = byCamera.value(name);
    good &= near(byMesh.value(name), expected, 1e-3 * std::abs(expected) + 1e-4, name);
  }
  byMesh.tracker->SetInputData(1, byMesh.turnedSphere(0.0));
  byMesh.tracker->SetInputData(2, byMesh.turnedSphere(180.0));
  good &= require(byMesh.status() == "NoSamples", "half a turn hides every sample");
  return good;
}

bool testEmpty()
{
  Scene scene;
  scene.tracker->SetInputData(0, vtkNew<vtkPolyData>());
  scene.tracker->Update();
  return require(scene.tracker->GetOutput()->GetNumberOfRows() == 0, "no samples, no rows");
}

// The filter must fail with a message that has `expected` in it.
bool refuses(const char* expected, const std::function<void(Scene&)>& spoil)
{
  Scene scene;
  vtkNew<vtkSphereSource> mesh;
  mesh->SetThetaResolution(48);
  mesh->SetPhiResolution(24);
  scene.tracker->SetInputConnection(1, mesh->GetOutputPort());
  spoil(scene);
  vtkNew<vtkTest::ErrorObserver> own, pipeline;
  scene.tracker->AddObserver(vtkCommand::ErrorEvent, own);
  scene.tracker->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  scene.tracker->Update();
  return require(own->GetError() && own->GetErrorMessage().find(expected) != std::string::npos,
    std::string("the message has: ") + expected + "\n  it is: " + own->GetErrorMessage());
}

bool testWrongInput()
{
  bool good = true;
  for (const char* name : { "Normals", "PointIds", "Barycentrics" })
  {
    good &= refuses((std::string("no point array '") + name + "'").c_str(),
      [&](Scene& scene) { scene.samples->GetPointData()->RemoveArray(name); });
  }
  good &= refuses("no field array 'PatchSpacing'",
    [](Scene& scene) { scene.samples->GetFieldData()->RemoveArray("PatchSpacing"); });
  good &= refuses("'PointIds' has float with 3 components, expected integers",
    [](Scene& scene)
    {
      vtkNew<vtkFloatArray> array;
      array->DeepCopy(scene.samples->GetPointData()->GetArray("PointIds"));
      scene.samples->GetPointData()->AddArray(array);
    });
  good &= refuses("'Barycentrics' has 7 tuples",
    [](Scene& scene)
    { scene.samples->GetPointData()->GetArray("Barycentrics")->SetNumberOfTuples(7); });
  good &= refuses("'PointIds' has 99999 at sample 3",
    [](Scene& scene)
    { scene.samples->GetPointData()->GetArray("PointIds")->SetComponent(3, 1, 99999); });
  good &= refuses("PatchId 7, expected 0 to 1 - 1",
    [](Scene& scene)
    { scene.samples->GetPointData()->GetArray("PatchId")->SetComponent(3, 0, 7); });
  good &= refuses("points before and",
    [](Scene& scene) { scene.tracker->SetInputData(2, vtkNew<vtkPolyData>()); });
  good &= refuses("No camera after", [](Scene& scene) { scene.tracker->SetCameraAfter(nullptr); });
  good &= refuses("positions[5] is not finite",
    [](Scene& scene)
    {
      scene.tracker->SetInputConnection(1, nullptr);
      scene.samples->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
    });
  return good;
}

} // namespace

int TestSimilarityTracker(int, char*[])
{
  bool good = testCameras();
  good &= testMeshes(false);
  good &= testMeshes(true);
  good &= testEmpty();
  good &= testWrongInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

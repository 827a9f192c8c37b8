// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTextureViewsInternals_h
#define vtkTextureViewsInternals_h

#include "TextureViewChecks.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"
#include "vtkTextureViews.h"
#include "vtkTimeStamp.h"

#include <array>
#include <string>
#include <vector>

struct vtkTextureViews::Image
{
  vtkSmartPointer<vtkImageData> data;
  std::string fileName;
};

struct vtkTextureViews::View
{
  using Vector = std::array<double, 3>;
  using FadePoint = std::array<double, 2>; // angle, share

  std::string name;
  Image picture;
  Image mask;
  Image depth;
  std::array<double, 2> depthRange{ 0.0, 0.0 };
  hachure::ViewCamera camera;
  vtkSmartPointer<vtkMatrix4x4> matrix; // takes the place of the camera unless it is null
  int kind = INDEPENDENT;
  std::vector<Vector> extremePoints;
  int fadeMode = CURVE;
  std::vector<FadePoint> fadePoints{ { 0.0, 1.0 }, { 0.5, 1.0 }, { 1.0, 0.0 } };
  vtkTimeStamp imageTime;
  vtkTimeStamp cameraTime;
  vtkTimeStamp rangeTime;
  // What the getters have given away.
  vtkSmartPointer<vtkCamera> shownCamera;
  vtkSmartPointer<vtkMatrix4x4> shownMatrix;

  bool sameCamera(const View& other) const;
  bool sameRange(const View& other) const;
  // Of a view that was copied from other views: what is equal in the view before stays.
  void becomeOwn(const View* before, bool deep);
  void takeImages(const View* before, bool deep);
};

struct vtkTextureViews::BlendPoint
{
  std::array<double, 3> position;
  std::array<double, 3> direction;
  double percentage;
};

struct vtkTextureViews::Internals
{
  std::vector<View> views;
  std::vector<BlendPoint> blendPoints;
};

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureViewActors_h
#define hachure_TextureViewActors_h

#include "TextureViewShapes.h"
#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTimeStamp.h"
#include "vtkViewDependentTexture.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkMatrix4x4;
class vtkTextureViews;

// The actors that draw views, the borders of their ranges and blend points. World coordinates.
namespace hachure
{

using MarkColor = std::array<double, 3>;

// How something is drawn.
struct MarkStyle
{
  MarkColor color{ 1.0, 1.0, 1.0 };
  bool selected = false;
};

// Text beside a place. Where no fonts are linked nothing is drawn.
class LabelMark
{
public:
  LabelMark();
  void place(const std::string& text, const glm::dvec3& at, const MarkStyle& style);
  vtkBillboardTextActor3D* prop() const { return this->actor; }

private:
  vtkNew<vtkBillboardTextActor3D> actor;
};

// Lines that are not lit.
class LinesMark
{
public:
  LinesMark();
  // lines: of every polyline the numbers of its points.
  void place(const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& lines,
    const MarkStyle& style);
  vtkActor* prop() const { return this->actor; }

private:
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

// A ball to be dragged.
class HandleMark
{
public:
  HandleMark();
  void place(const glm::dvec3& at, double ofRadius, const MarkStyle& style);
  vtkActor* prop() const { return this->actor; }

  glm::dvec3 position{ 0.0 };
  double radius = 0.0;

private:
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

// The outlines of what views cover of a surface.
class RegionsMark
{
public:
  RegionsMark();
  // Null: there are none. Whether it is another one.
  bool setSurface(vtkDataObject* surface);
  void place(vtkTextureViews* views, vtkMatrix4x4* modelToWorld);
  vtkActor* prop() const { return this->actor; }

private:
  vtkNew<vtkViewDependentTexture> filter;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

// A view: its camera as a pyramid, its picture, and its name.
class ViewMark
{
public:
  ViewMark();
  void place(const ViewPyramid& ofPyramid, const std::string& name, const MarkStyle& style);
  // null: none is drawn.
  void setPicture(vtkImageData* image);

  ViewPyramid pyramid;
  LinesMark lines;
  LabelMark label;
  vtkActor* picture() const { return this->pictureActor; }

  vtkMTimeType pictureTime = 0; // of the view whose picture was taken last

private:
  vtkNew<vtkPolyData> quad;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkTexture> texture;
  vtkNew<vtkActor> pictureActor;
};

// A blend point: a ball, an arrow for its direction, and its percentage.
class BlendMark
{
public:
  BlendMark();
  void place(const glm::dvec3& direction, double length, const MarkStyle& style);

  HandleMark handle; // to be placed first
  LabelMark label;
  vtkActor* arrow() const { return this->arrowActor; }

private:
  vtkNew<vtkArrowSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> arrowActor;
};

} // namespace hachure

#endif

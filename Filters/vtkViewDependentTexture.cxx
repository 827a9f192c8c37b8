// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewDependentTexture.h"

#include "CameraView.h"
#include "Core/NodePlaces.h"
#include "Core/SurfaceCharts.h"
#include "Core/ViewTexture.h"
#include "Core/ViewTextureSample.h"
#include "SurfaceTriangles.h"
#include "TextureViewInput.h"
#include "ViewTextureOutput.h"
#include "vtkTextureViews.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkViewDependentTexture);

namespace
{
using hachure::SurfaceTriangles;

constexpr int outputs = 3;

// Points of no triangle need not be finite.
void zeroOthers(std::vector<glm::dvec3>& points)
{
  std::replace_if(
    points.begin(), points.end(),
    [](const glm::dvec3& p) { return !std::isfinite(p.x + p.y + p.z); }, glm::dvec3(0.0));
}

glm::dvec3 centerOf(const std::vector<glm::dvec3>& points)
{
  vtkBoundingBox box;
  for (const glm::dvec3& point : points)
  {
    box.AddPoint(point.x, point.y, point.z);
  }
  glm::dvec3 center(0.0);
  if (box.IsValid())
  {
    box.GetCenter(&center.x);
  }
  return center;
}

void setViews(hachure::ViewTexture& texture, vtkTextureViews* views, const glm::dvec3& center)
{
  const int count = views->GetNumberOfViews();
  std::vector<hachure::TextureView> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    all.push_back(hachure::textureView(views, i, center));
  }
  texture.setViews(all);
  for (int i = 0; i < count; ++i)
  {
    const std::vector<glm::u8vec4> pixels = hachure::texturePixels(views, i);
    const int* const size = views->GetViewImage(i)->GetDimensions();
    texture.setImage(static_cast<std::size_t>(i), { size[0], size[1], pixels });
  }
}
} // namespace

// What the outputs are made of.
struct vtkViewDependentTexture::Parts
{
  SurfaceTriangles surface;
  glm::dvec3 center{ 0.0 };
  hachure::SurfaceCells cells;
  hachure::SurfaceFrames frames;
  std::unique_ptr<hachure::ViewTexture> texture;
  hachure::ViewTextureColors colors;
  std::vector<std::vector<float>> shares;
};

vtkViewDependentTexture::vtkViewDependentTexture()
  : Views(vtkSmartPointer<vtkTextureViews>::New())
{
  this->SetNumberOfOutputPorts(outputs);
}

vtkViewDependentTexture::~vtkViewDependentTexture() = default;

void vtkViewDependentTexture::SetViews(vtkTextureViews* views)
{
  if (!views)
  {
    vtkErrorMacro("SetViews: the views are null; expected a vtkTextureViews.");
    return;
  }
  if (this->Views != views)
  {
    this->Views = views;
    this->Modified();
  }
}

vtkTextureViews* vtkViewDependentTexture::GetViews()
{
  return this->Views;
}

void vtkViewDependentTexture::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkViewDependentTexture::GetCamera()
{
  return this->Camera;
}

void vtkViewDependentTexture::SetViewportSize(double width, double height)
{
  const double clamped[2] = { std::max(1.0, width), std::max(1.0, height) };
  if (this->ViewportSize[0] != clamped[0] || this->ViewportSize[1] != clamped[1])
  {
    std::copy(clamped, clamped + 2, this->ViewportSize);
    this->Modified();
  }
}

vtkMTimeType vtkViewDependentTexture::GetMTime()
{
  const vtkMTimeType time = std::max(this->Superclass::GetMTime(), this->Views->GetMTime());
  return this->Camera ? std::max(time, this->Camera->GetMTime()) : time;
}

int vtkViewDependentTexture::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkViewDependentTexture::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == outputs - 1 ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

vtkTypeBool vtkViewDependentTexture::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkInformation* info = outputVector->GetInformationObject(outputs - 1);
  vtkDataObject* output = vtkDataObject::GetData(info);
  if (input && (!output || !output->IsA(input->GetClassName())))
  {
    const auto made = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

// False if it was stopped.
bool vtkViewDependentTexture::Blend(vtkDataObject* input, Parts& parts)
{
  const auto part = [this](double begin, double end) -> hachure::ProgressFn
  {
    return [this, begin, end](double fraction)
    {
      this->UpdateProgress(begin + fraction * (end - begin));
      return !this->GetAbortExecute();
    };
  };
  parts.surface = hachure::extractSurfaceTriangles(input);
  if (parts.surface.nonFinitePoints > 0)
  {
    vtkWarningMacro(<< parts.surface.nonFinitePoints
                    << " input point(s) have a coordinate that is not finite; the cells that use "
                       "them are left out.");
  }
  zeroOthers(parts.surface.points);
  parts.center = centerOf(parts.surface.points);
  const hachure::TriangleMesh mesh = parts.surface.mesh();
  parts.cells = hachure::surfaceCells(
    mesh, hachure::surfaceCellOptions(this->Views, this->MemoryBudget), part(0.0, 0.3));
  if (this->GetAbortExecute())
  {
    return false;
  }
  parts.frames = hachure::surfaceFrames(mesh, parts.cells);
  parts.texture = std::make_unique<hachure::ViewTexture>(mesh, parts.cells, parts.frames,
    hachure::viewTextureOptions(this->Views, this->PropagateUp, this->ClassicShares));
  setViews(*parts.texture, this->Views, parts.center);
  parts.colors = parts.texture->colors(hachure::ViewTextureContent::Combined, part(0.3, 0.8));
  if (this->GetAbortExecute())
  {
    return false;
  }
  parts.shares = parts.texture->nodeShares(part(0.8, 0.95));
  return !this->GetAbortExecute();
}

void vtkViewDependentTexture::Attach(
  vtkDataObject* input, Parts& parts, vtkInformationVector* outputVector)
{
  const hachure::TriangleMesh mesh = parts.surface.mesh();
  const int finest = parts.cells.finestLevel;
  const hachure::CellLayer layer(
    parts.cells, this->Level < 0 ? finest : std::min(this->Level, finest));
  const hachure::CellMesh triangles =
    hachure::cellMesh(mesh, layer, hachure::nodePlaces(mesh, parts.cells));
  const hachure::ViewTextureCells cells = { layer, triangles, parts.colors, parts.shares };
  const std::vector<std::int32_t> views = hachure::mainViews(cells);
  hachure::attachCells(cells, this->Views, views, vtkPolyData::GetData(outputVector, 0));
  hachure::attachBorders(cells, views, vtkPolyData::GetData(outputVector, 1));
  if (this->Camera)
  {
    const hachure::ViewProjection view = hachure::cameraView(this->Camera, this->ViewportSize);
    hachure::ViewTextureCamera camera;
    camera.modelToClip = view.viewToClip * view.modelToView;
    camera.pictureSize = view.viewportSize;
    camera.independentShare =
      hachure::independentShare(this->Views, camera.modelToClip, parts.center);
    hachure::attachPointColors(input, parts.surface,
      hachure::viewTexturePointColors(mesh, parts.cells, parts.frames, parts.colors, camera),
      vtkDataObject::GetData(outputVector, outputs - 1));
  }
}

int vtkViewDependentTexture::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  const auto clear = [outputVector]
  {
    for (int port = 0; port < outputs; ++port)
    {
      vtkDataObject::GetData(outputVector, port)->Initialize();
    }
  };
  clear();
  try
  {
    Parts parts;
    if (this->Blend(input, parts))
    {
      this->Attach(input, parts, outputVector);
    }
  }
  catch (const std::invalid_argument& error)
  {
    clear();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkViewDependentTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Views: " << this->Views.Get() << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "PropagateUp: " << (this->PropagateUp ? "on" : "off") << "\n";
  os << indent << "ClassicShares: " << (this->ClassicShares ? "on" : "off") << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewInput.h"

#include "Core/BlendPoints.h"
#include "Core/ViewTextureSample.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTextureViews.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace hachure
{
namespace
{
glm::dmat4 matrixOf(vtkTextureViews* views, int view)
{
  vtkNew<vtkMatrix4x4> matrix;
  views->ComputeModelToClip(view, matrix);
  glm::dmat4 result;
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

// Along the middle of the picture, from the viewer on.
glm::dvec3 axisOf(const glm::dmat4& modelToClip, const glm::dvec4& eye)
{
  const glm::dmat4 toModel = glm::inverse(modelToClip);
  const glm::dvec4 inside = toModel * glm::dvec4(0.0, 0.0, 0.0, 1.0);
  const glm::dvec3 axis =
    eye.w > 0.0 ? glm::dvec3(inside) / inside.w - glm::dvec3(eye) : -glm::dvec3(eye);
  return glm::normalize(axis);
}

// Of a view without a camera.
void setEye(vtkTextureViews* views, int view, const glm::dvec3& center, TextureView& result)
{
  glm::dvec4 eye;
  views->ComputeEye(view, &eye[0]);
  const glm::dvec3 axis = axisOf(result.modelToClip, eye);
  result.parallel = !(eye.w > 0.0);
  if (result.parallel)
  {
    result.focus = center;
    result.eye = center - axis;
    return;
  }
  result.eye = glm::dvec3(eye);
  const double along = glm::dot(center - result.eye, axis);
  result.focus = result.eye + (along > 0.0 ? along : 1.0) * axis;
}

glm::u8vec4 pixelOf(const unsigned char* values, int components, unsigned char mask)
{
  const bool isGrey = components < 3;
  const bool hasAlpha = components == 2 || components == 4;
  constexpr int whole = 255;
  const int alpha = hasAlpha ? values[components - 1] : whole;
  return { values[0], values[isGrey ? 0 : 1], values[isGrey ? 0 : 2],
    static_cast<unsigned char>((alpha * mask + whole / 2) / whole) };
}

glm::dvec3 pointOf(const glm::dmat4& toModel, double depth)
{
  const glm::dvec4 point = toModel * glm::dvec4(0.0, 0.0, depth, 1.0);
  return glm::dvec3(point) / point.w;
}

std::vector<BlendPoint> blendPoints(vtkTextureViews* views)
{
  constexpr double percent = 0.01;
  std::vector<BlendPoint> points(static_cast<std::size_t>(views->GetNumberOfBlendPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const int index = static_cast<int>(i);
    views->GetBlendPointPosition(index, &points[i].position[0]);
    views->GetBlendPointDirection(index, &points[i].direction[0]);
    points[i].share = percent * views->GetBlendPointPercentage(index);
  }
  return points;
}
} // namespace

TextureView textureView(vtkTextureViews* views, int view, const glm::dvec3& center)
{
  TextureView result;
  result.modelToClip = matrixOf(views, view);
  if (vtkSmartPointer<vtkCamera> camera = views->GetViewCamera(view))
  {
    camera->GetPosition(&result.eye[0]);
    camera->GetFocalPoint(&result.focus[0]);
    result.parallel = camera->GetParallelProjection() != 0;
  }
  else
  {
    setEye(views, view, center, result);
  }
  const int* const size = views->GetViewImage(view)->GetDimensions();
  result.width = size[0];
  result.height = size[1];
  result.dependent = views->GetViewKind(view) == vtkTextureViews::DEPENDENT;
  result.extremes.resize(static_cast<std::size_t>(views->GetNumberOfExtremePoints(view)));
  for (std::size_t i = 0; i < result.extremes.size(); ++i)
  {
    views->GetExtremePoint(view, static_cast<int>(i), &result.extremes[i][0]);
  }
  const int curvePoints = views->GetNumberOfFadePoints(view);
  result.fadeCurve.assign(1, { 0.0, 1.0 }); // without points: all up to the border
  result.fadeCurve.resize(
    static_cast<std::size_t>(curvePoints > 0 ? curvePoints : 1), { 0.0, 1.0 });
  for (int i = 0; i < curvePoints; ++i)
  {
    views->GetFadePoint(view, i, &result.fadeCurve[static_cast<std::size_t>(i)][0]);
  }
  const FadeMode modes[] = { FadeMode::Curve, FadeMode::Middle, FadeMode::Even };
  result.fadeMode = modes[views->GetFadeMode(view)];
  return result;
}

std::vector<glm::u8vec4> texturePixels(vtkTextureViews* views, int view)
{
  vtkImageData* image = views->GetViewImage(view);
  vtkImageData* mask = views->GetViewMask(view);
  const int components = image->GetNumberOfScalarComponents();
  const int maskComponents = mask ? mask->GetNumberOfScalarComponents() : 0;
  const int* const extent = image->GetExtent();
  std::vector<glm::u8vec4> pixels;
  pixels.reserve(static_cast<std::size_t>(image->GetNumberOfPoints()));
  constexpr unsigned char whole = 255;
  const auto* values =
    static_cast<const unsigned char*>(image->GetScalarPointer(extent[0], extent[2], extent[4]));
  const auto* masks = mask
    ? static_cast<const unsigned char*>(mask->GetPointData()->GetScalars()->GetVoidPointer(0))
    : nullptr;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    pixels.push_back(
      pixelOf(values + i * components, components, masks ? masks[i * maskComponents] : whole));
  }
  return pixels;
}

SurfaceCellOptions surfaceCellOptions(vtkTextureViews* views, int memoryBudget)
{
  constexpr std::int64_t bytesPerMiB = 1 << 20;
  const std::int64_t directions =
    static_cast<std::int64_t>(views->GetHemisphere()) * views->GetHemisphere();
  const std::int64_t bytesPerNode = 4 * (directions + 1);
  SurfaceCellOptions options;
  options.baseCells = views->GetBaseCells();
  options.finestLevel = views->GetFinestLevel();
  options.mostNodes = memoryBudget * bytesPerMiB / bytesPerNode;
  return options;
}

ViewTextureOptions viewTextureOptions(vtkTextureViews* views, bool propagateUp, bool classicShares)
{
  ViewTextureOptions options;
  options.hemisphere = views->GetHemisphere();
  options.map = views->GetHemisphereMap() == vtkTextureViews::DISK ? HemisphereMap::Disk
                                                                   : HemisphereMap::Octahedral;
  options.propagateUp = propagateUp;
  options.classicShares = classicShares;
  return options;
}

double independentShare(
  vtkTextureViews* views, const glm::dmat4& modelToClip, const glm::dvec3& center)
{
  const std::vector<BlendPoint> points = blendPoints(views);
  if (points.empty())
  {
    return 0.0;
  }
  const glm::dmat4 toModel = glm::inverse(modelToClip);
  const glm::dvec4 eye = viewerOf(modelToClip);
  const glm::dvec3 near = pointOf(toModel, -1.0);
  return BlendFunction(points, center)
    .at(eye.w > 0.0 ? glm::dvec3(eye) : near, pointOf(toModel, 1.0) - near);
}

} // namespace hachure

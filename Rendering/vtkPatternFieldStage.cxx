// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternFieldStage.h"

#include "vtkPatternCompositor.h"
#include "vtkPatternSurface.h"
#include "vtkPatternTriangleIds.h"
#include "vtkPatternWindowResources.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using FieldScene = vtkPatternLayerPainter::FieldScene;

// Largest change of a coordinate of clip space, divided by w, over a unit of the model.
double Change(const glm::dmat4& modelToClip, const glm::dvec4& clip, int coordinate)
{
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec4& along = modelToClip[axis];
    gradient[axis] = (along[coordinate] - along.w * clip[coordinate] / clip.w) / clip.w;
  }
  return glm::length(gradient);
}

// Change of the window depth at this point of the model by moving away by the size of a pixel.
float DepthPerPixel(const glm::dmat4& modelToClip, const glm::dvec3& point, int width)
{
  const glm::dvec4 clip = modelToClip * glm::dvec4(point, 1.0);
  constexpr int depthAxis = 2;
  const double pixels = 0.5 * width * Change(modelToClip, clip, 0);
  const double depth = 0.5 * Change(modelToClip, clip, depthAxis);
  constexpr double least = 1e-7;
  const double change = depth / pixels;
  return static_cast<float>(std::isfinite(change) ? std::clamp(change, least, 1.0) : least);
}

std::vector<glm::dvec4> CornersInRectangle(const vtkPatternFieldStage& stage)
{
  const std::array<int, 4>& all = stage.Viewport;
  const std::array<int, 4>& part = stage.Rectangle;
  const glm::dvec2 size(all[2], all[3]);
  const glm::dvec2 partSize(part[2], part[3]);
  const glm::dvec2 scale = size / partSize;
  const glm::dvec2 shift =
    (size + 2.0 * glm::dvec2(all[0] - part[0], all[1] - part[1])) / partSize - 1.0;
  const hachure::TriangleMesh mesh = stage.Surface.Mesh();
  std::vector<glm::dvec4> corners;
  corners.reserve(mesh.points.size());
  for (const glm::dvec3& point : mesh.points)
  {
    const glm::dvec4 clip = stage.ModelToClip * glm::dvec4(point, 1.0);
    corners.emplace_back(scale * glm::dvec2(clip) + clip.w * shift, clip.z, clip.w);
  }
  return corners;
}

FieldScene::Seen LookAtTriangles(const vtkPatternFieldStage& stage)
{
  FieldScene::Seen seen;
  seen.Triangles = vtkPattern::DrawTriangleIds(stage.Window, CornersInRectangle(stage),
    stage.Surface.Mesh().triangles, { stage.Rectangle[2], stage.Rectangle[3] });
  const std::vector<std::int32_t>& objects = stage.Surface.Objects();
  seen.Objects.reserve(seen.Triangles.size());
  for (const std::int32_t triangle : seen.Triangles)
  {
    seen.Objects.push_back(triangle < 0 ? -1 : objects[static_cast<std::size_t>(triangle)]);
  }
  return seen;
}

float DepthPerPixel(const vtkPatternFieldStage& stage)
{
  return DepthPerPixel(stage.ModelToClip, stage.Center, stage.Viewport[2]);
}
} // namespace

std::string vtkPatternFieldStage::Draw(vtkPatternCompositor& compositor) const
{
  std::vector<float> depth;
  const auto lookAtDepth = [&]() -> const std::vector<float>&
  {
    if (depth.empty())
    {
      depth = this->Resources.ReadDepth(this->Window, this->Rectangle);
    }
    return depth;
  };
  FieldScene::Seen seen;
  const auto look = [&]() -> const FieldScene::Seen&
  {
    if (seen.Triangles.empty())
    {
      seen = LookAtTriangles(*this);
    }
    return seen;
  };
  const auto read = [&](vtkPatternAttributes::Image image)
  { return this->Resources.ReadBytes(this->Window, this->Rectangle, image); };
  std::vector<FieldScene::ToneImage> tones;
  const auto lookAtTones = [&]() -> const std::vector<FieldScene::ToneImage>&
  {
    if (tones.empty())
    {
      tones.push_back({ read(vtkPatternAttributes::TONE), {} });
    }
    return tones;
  };
  std::vector<std::uint8_t> colors;
  const auto lookAtColors = [&]() -> const std::vector<std::uint8_t>&
  {
    if (colors.empty())
    {
      colors = read(vtkPatternAttributes::COLOR);
    }
    return colors;
  };
  return compositor.DrawFields({ &this->Surface, &this->Steering, this->CarriesStipples,
    this->History, this->StippleHistory, this->LookOn, this->SecondEye, this->ModelToClip,
    this->Viewport, this->Rectangle, DepthPerPixel(*this), this->NoiseBackEnd, this->Frame,
    this->Resources.SurfaceDepth, lookAtDepth, look, lookAtTones, lookAtColors });
}

std::string vtkPatternFieldStage::DrawForward(vtkPatternCompositor& compositor) const
{
  const std::vector<FieldScene::ToneImage>* tones = nullptr;
  const auto lookAtTones = [&]() -> const std::vector<FieldScene::ToneImage>&
  {
    tones = tones ? tones : &this->PeelTones();
    return *tones;
  };
  return compositor.DrawForwardFields(
    { &this->Surface, &this->Steering, this->CarriesStipples, this->History, this->StippleHistory,
      this->LookOn, this->SecondEye, this->ModelToClip, this->Viewport, this->Rectangle,
      DepthPerPixel(*this), this->NoiseBackEnd, this->Frame, nullptr, {}, {}, lookAtTones, {} });
}

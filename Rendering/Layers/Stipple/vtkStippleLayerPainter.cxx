// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStippleLayerPainter.h"

#include "StippleLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternSurface.h"
#include "vtkPatternToneCurve.h"
#include "vtkShaderProgram.h"
#include "vtkStippleLayer.h"

#include <algorithm>
#include <cmath>

vtkStippleLayerPainter::vtkStippleLayerPainter(vtkStippleLayer* layer)
  : Layer(layer)
{
}

std::string vtkStippleLayerPainter::GetDeclarations(bool) const
{
  return StippleLayer;
}

bool vtkStippleLayerPainter::Update(vtkOpenGLRenderWindow* window, const Scene& scene, std::string&)
{
  this->Window = window;
  if (!this->Layer)
  {
    return false;
  }
  constexpr double millimetresPerInch = 25.4;
  const double unit = this->Layer->GetSizeUnit() == vtkPatternLayer::MILLIMETRES
    ? scene.DotsPerInch / millimetresPerInch
    : 1.0;
  this->Diameter = this->Layer->GetSize() * unit * scene.PixelsPerLogical;
  this->Rectangle = { 0, 0, 0, 0 };
  return true;
}

// Tones are read where they come from, and curved here.
void vtkStippleLayerPainter::SetTones(
  const FieldScene& scene, int channel, hachure::StippleScene& stipples) const
{
  vtkPatternTone* tone = this->Layer->GetTone();
  if (channel < 0)
  {
    stipples.toneOf.fill(static_cast<float>(vtkPattern::CurvedTone(tone, tone->GetConstant())));
    return;
  }
  const std::vector<std::uint8_t>& tones = scene.LookAtTones().front().Tones;
  constexpr int channels = 4;
  stipples.tones = hachure::Span<const std::uint8_t>(tones).subspan(
    static_cast<std::size_t>(channel), tones.size() - static_cast<std::size_t>(channel));
  stipples.toneStride = channels;
  constexpr double last = 255.0;
  for (std::size_t i = 0; i < stipples.toneOf.size(); ++i)
  {
    stipples.toneOf[i] =
      static_cast<float>(vtkPattern::CurvedTone(tone, static_cast<double>(i) / last));
  }
}

std::string vtkStippleLayerPainter::DrawField(const FieldScene& scene, int channel)
{
  const auto order = this->Layer->GetOrder() == vtkStippleLayer::CLASSIC
    ? hachure::StippleOrder::Classic
    : hachure::StippleOrder::Progressive;
  const std::shared_ptr<hachure::StippleTree> tree =
    scene.Surface->Stipples({ order, this->Layer->GetSeed(), this->Layer->GetNumberOfPoints() });
  hachure::StippleScene seen;
  seen.view.modelToClip = scene.ModelToClip;
  seen.view.viewportOrigin = { scene.Viewport[0], scene.Viewport[1] };
  seen.view.viewportSize = { scene.Viewport[2], scene.Viewport[3] };
  seen.rectangle = scene.Rectangle;
  seen.depth = scene.LookAtDepth();
  seen.depthPerPixel = scene.DepthPerPixel;
  this->SetTones(scene, channel, seen);
  hachure::StippleLook look;
  look.diameter = static_cast<float>(this->Diameter);
  look.growth = static_cast<float>(this->Layer->GetGrowth());
  look.toneBySize = this->Layer->GetCarrier() == vtkStippleLayer::SIZE;
  const hachure::StippleDrawing drawing(seen, look);
  const bool refines = this->Layer->GetRefinement();
  const bool enough = hachure::drawStipples(*tree, drawing, refines, this->Drawn);
  this->Note = enough || !refines ? std::string()
                                  : "stipples take all of the memory budget of " +
      std::to_string(this->Layer->GetMemoryBudget()) +
      " MiB; where more would be needed they are drawn larger";
  this->Discs.clear();
  this->Discs.reserve(this->Drawn.size());
  for (const hachure::DrawnStipple& stipple : this->Drawn)
  {
    this->Discs.push_back(stipple.disc);
  }
  this->Canvas.draw(this->Discs, scene.Rectangle[2], scene.Rectangle[3], this->Covered);
  this->Upload(scene.Rectangle);
  return {};
}

void vtkStippleLayerPainter::Upload(const std::array<int, 4>& rectangle)
{
  this->Texture->SetContext(this->Window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->Create2DFromRaw(static_cast<unsigned int>(rectangle[2]),
    static_cast<unsigned int>(rectangle[3]), 1, VTK_UNSIGNED_CHAR, this->Covered.data());
  this->Rectangle = rectangle;
}

void vtkStippleLayerPainter::SetUniforms(vtkShaderProgram* program, const std::string& number,
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart&)
{
  const bool drawn = this->Rectangle[2] > 0 && this->Texture->GetHandle();
  if (drawn)
  {
    program->SetUniformi(("hachureStipples" + number).c_str(), this->Texture->GetTextureUnit());
  }
  const float place[3] = { static_cast<float>(this->Rectangle[0]),
    static_cast<float>(this->Rectangle[1]), drawn ? 1.0f : 0.0f };
  program->SetUniform3f(("hachureStipplePlace" + number).c_str(), place);
}

std::array<glm::vec4, 2> vtkStippleLayerPainter::GetPlacement(
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart&) const
{
  return {}; // stipples are attached to points of the surface
}

void vtkStippleLayerPainter::Activate()
{
  if (this->Rectangle[2] > 0)
  {
    this->Texture->Activate();
  }
}

void vtkStippleLayerPainter::Deactivate()
{
  if (this->Rectangle[2] > 0)
  {
    this->Texture->Deactivate();
  }
}

void vtkStippleLayerPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Rectangle = { 0, 0, 0, 0 };
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStippleLayerPainter.h"

#include "Kernels.h"
#include "Parallel.h"
#include "StippleEdgeTest.h"
#include "StippleLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternShaderText.h"
#include "vtkPatternStippleHistory.h"
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
  return vtkPattern::ShaderSection(StippleLayer, "Ink") +
    vtkPattern::ShaderSection(StippleLayer, "Opaque");
}

std::string vtkStippleLayerPainter::GetForwardDeclarations(bool) const
{
  return vtkPattern::ShaderSection(StippleLayer, "Ink") +
    vtkPattern::ShaderSection(StippleLayer, "Forward");
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
  this->Forward = false;
  return true;
}

// Tones are read where they come from, and curved here.
void vtkStippleLayerPainter::SetTones(
  const FieldScene& scene, int channel, hachure::StippleScene& stipples)
{
  vtkPatternTone* tone = this->Layer->GetTone();
  if (tone->IsSeparation())
  {
    this->Separate(scene);
    stipples.tones = this->Separation;
  }
  else if (channel < 0)
  {
    stipples.toneOf.fill(static_cast<float>(vtkPattern::CurvedTone(tone, tone->GetConstant())));
    return;
  }
  else
  {
    const std::vector<std::uint8_t>& tones = scene.LookAtTones().front().Tones;
    constexpr int channels = 4;
    stipples.tones = hachure::Span<const std::uint8_t>(tones).subspan(
      static_cast<std::size_t>(channel), tones.size() - static_cast<std::size_t>(channel));
    stipples.toneStride = channels;
  }
  constexpr double last = 255.0;
  for (std::size_t i = 0; i < stipples.toneOf.size(); ++i)
  {
    stipples.toneOf[i] =
      static_cast<float>(vtkPattern::CurvedTone(tone, static_cast<double>(i) / last));
  }
}

// As processInks() in ToneExpression of the compositor.
void vtkStippleLayerPainter::Separate(const FieldScene& scene)
{
  vtkPatternTone* tone = this->Layer->GetTone();
  const auto blackGeneration = static_cast<float>(tone->GetBlackGeneration());
  const int ink = tone->GetSource() - vtkPatternTone::CYAN;
  const std::vector<std::uint8_t>& colors = scene.LookAtColors();
  this->Separation.resize(colors.size() / 4);
  hachure::parallelFor(static_cast<std::int64_t>(this->Separation.size()),
    [&](std::int64_t pixel)
    {
      const std::uint8_t* const bytes = colors.data() + 4 * pixel;
      constexpr float last = 255.0f;
      const glm::vec3 color = glm::vec3(bytes[0], bytes[1], bytes[2]) / last;
      const glm::vec4 inks =
        hachure::glsl::processInks(hachure::glsl::toLinear(color), blackGeneration);
      this->Separation[static_cast<std::size_t>(pixel)] =
        static_cast<std::uint8_t>(std::lround(last * inks[ink]));
    });
}

// Those drawn from `first` on, of points of the base, by their shares.
void vtkStippleLayerPainter::Fade(
  const hachure::StippleTree& tree, const std::vector<float>& shares, std::size_t first)
{
  for (std::size_t i = first; !shares.empty() && i < this->Drawn.size(); ++i)
  {
    hachure::DrawnStipple& stipple = this->Drawn[i];
    const std::uint64_t rank = tree.identity(stipple.node, stipple.index);
    if (rank < shares.size())
    {
      stipple.disc.radius *= std::sqrt(shares[rank]);
    }
  }
}

void vtkStippleLayerPainter::FindStipples(
  const FieldScene& scene, const hachure::StippleScene& seen, const hachure::StippleLook& look)
{
  const int life = scene.CarriesStipples ? this->Layer->GetLife() : 0;
  const std::shared_ptr<vtkPatternSurface::StippleSet> set =
    scene.Steering->Stipples({ hachure::StippleOrder::Progressive, this->Layer->GetSeed(),
      this->Layer->GetNumberOfPoints(), life });
  hachure::StippleTree& tree = set->Tree;
  const hachure::StippleDrawing drawing(seen, look);
  constexpr std::size_t bytesPerMiB = 1 << 20;
  tree.setBudget(static_cast<std::size_t>(this->Layer->GetMemoryBudget()) * bytesPerMiB);
  const bool refines = this->Layer->GetRefinement() && tree.canRefine();
  const bool enough = hachure::drawStipples(tree, drawing, refines, this->Drawn);
  this->Fade(tree, set->Living.shares, 0);
  const std::size_t staying = this->Drawn.size();
  if (!set->Living.leaving.empty())
  {
    std::vector<hachure::DrawnStipple> leaving;
    hachure::drawStipples(set->Leaving, drawing, false, leaving);
    this->Drawn.insert(this->Drawn.end(), leaving.begin(), leaving.end());
    this->Fade(set->Leaving, set->Living.leavingShares, staying);
  }
  this->Note = enough || !refines
    ? std::string()
    : "stipples that views asked for take all of the memory budget of " +
      std::to_string(this->Layer->GetMemoryBudget()) +
      " MiB; where more would be needed they are drawn larger";
}

void vtkStippleLayerPainter::FindClassicStipples(
  const FieldScene& scene, const hachure::StippleScene& seen, const hachure::StippleLook& look)
{
  const std::shared_ptr<hachure::StippleEdges> edges =
    scene.Steering->ClassicStipples({ hachure::StippleOrder::Classic, this->Layer->GetSeed(),
      this->Layer->GetNumberOfPoints(), 0 });
  const hachure::StippleEdgeTest test(seen, look);
  this->Note.clear();
  if (scene.StippleHistory && this->Layer->GetGrowthFrames() > 0)
  {
    scene.StippleHistory->Draw(
      this->Layer, edges, test, { scene.Frame, scene.LookOn || scene.SecondEye }, this->Drawn);
  }
  else
  {
    test.draw(*edges, this->Drawn);
  }
}

void vtkStippleLayerPainter::Draw(
  const FieldScene& scene, int channel, hachure::Span<const float> depth)
{
  hachure::StippleScene seen;
  seen.view.modelToClip = scene.ModelToClip;
  seen.view.viewportOrigin = { scene.Viewport[0], scene.Viewport[1] };
  seen.view.viewportSize = { scene.Viewport[2], scene.Viewport[3] };
  seen.rectangle = scene.Rectangle;
  seen.depth = depth;
  // The surface of a stand-in may be some pixels off.
  constexpr float standInTolerance = 10.0f;
  seen.depthPerPixel =
    (scene.Steering == scene.Surface ? 1.0f : standInTolerance) * scene.DepthPerPixel;
  this->SetTones(scene, channel, seen);
  hachure::StippleLook look;
  look.diameter = static_cast<float>(this->Diameter);
  look.growth = static_cast<float>(this->Layer->GetGrowth());
  look.toneBySize = this->Layer->GetCarrier() == vtkStippleLayer::SIZE;
  if (this->Layer->GetOrder() == vtkStippleLayer::CLASSIC)
  {
    this->FindClassicStipples(scene, seen, look);
  }
  else
  {
    this->FindStipples(scene, seen, look);
  }
  this->Discs.clear();
  this->Discs.reserve(this->Drawn.size());
  for (const hachure::DrawnStipple& stipple : this->Drawn)
  {
    this->Discs.push_back(stipple.disc);
  }
  this->Canvas.draw(this->Discs, scene.Rectangle[2], scene.Rectangle[3], this->Covered);
  this->Upload(scene.Rectangle);
}

std::string vtkStippleLayerPainter::DrawField(const FieldScene& scene, int channel)
{
  this->Draw(scene, channel, scene.LookAtDepth());
  return {};
}

bool vtkStippleLayerPainter::ForwardState::operator==(const ForwardState& other) const
{
  return this->ModelToClip == other.ModelToClip && this->Viewport == other.Viewport &&
    this->Rectangle == other.Rectangle && this->Diameter == other.Diameter &&
    this->SurfaceVersion == other.SurfaceVersion && this->LayerTime == other.LayerTime &&
    this->Frame == other.Frame;
}

std::string vtkStippleLayerPainter::DrawForwardField(const FieldScene& scene, int channel)
{
  this->Forward = true;
  const ForwardState state = { scene.ModelToClip, scene.Viewport, scene.Rectangle, this->Diameter,
    scene.Surface->GetVersion(), this->Layer->GetMTime(), scene.Frame };
  if (state == this->ForwardDrawn && this->Texture->GetHandle())
  {
    this->Rectangle = scene.Rectangle;
    return {};
  }
  this->ForwardDrawn = {};
  // Colours are known of opaque surfaces alone.
  if (this->Layer->GetTone()->IsSeparation() || scene.LookAtTones().empty())
  {
    this->Drawn.clear();
    return {};
  }
  const std::vector<float>& depth = scene.LookAtTones().front().Depth;
  this->Draw(scene, channel, depth);
  std::vector<float> texels(depth);
  this->FrontDepth->SetContext(this->Window);
  this->FrontDepth->SetMinificationFilter(vtkTextureObject::Nearest);
  this->FrontDepth->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->FrontDepth->Create2DFromRaw(static_cast<unsigned int>(scene.Rectangle[2]),
    static_cast<unsigned int>(scene.Rectangle[3]), 1, VTK_FLOAT, texels.data());
  this->ForwardDrawn = state;
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

// In the layer's own colour, whatever the surface's is.
void vtkStippleLayerPainter::CollectDiscs(std::vector<Disc>& discs) const
{
  const double* const color = this->Layer->GetColor();
  Disc disc;
  disc.Shape.color = glm::vec3(
    static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]));
  disc.Shape.opacity = static_cast<float>(this->Layer->GetOpacity());
  discs.reserve(discs.size() + this->Drawn.size());
  for (const hachure::DrawnStipple& stipple : this->Drawn)
  {
    disc.Shape.center = { this->Rectangle[0] + static_cast<double>(stipple.disc.x),
      this->Rectangle[1] + static_cast<double>(stipple.disc.y) };
    disc.Shape.radius = static_cast<double>(stipple.disc.radius);
    disc.Depth = stipple.nearest;
    discs.push_back(disc);
  }
}

void vtkStippleLayerPainter::SetUniforms(vtkShaderProgram* program, const std::string& number,
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart&)
{
  const bool drawn = this->Rectangle[2] > 0 && this->Texture->GetHandle();
  if (drawn)
  {
    program->SetUniformi(("hachureStipples" + number).c_str(), this->Texture->GetTextureUnit());
  }
  if (drawn && this->Forward)
  {
    program->SetUniformi(
      ("hachureStippleDepth" + number).c_str(), this->FrontDepth->GetTextureUnit());
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
    if (this->Forward)
    {
      this->FrontDepth->Activate();
    }
  }
}

void vtkStippleLayerPainter::Deactivate()
{
  if (this->Rectangle[2] > 0)
  {
    this->Texture->Deactivate();
    if (this->Forward)
    {
      this->FrontDepth->Deactivate();
    }
  }
}

void vtkStippleLayerPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->FrontDepth->ReleaseGraphicsResources(window);
  this->Forward = false;
  this->ForwardDrawn = {};
  this->Rectangle = { 0, 0, 0, 0 };
}

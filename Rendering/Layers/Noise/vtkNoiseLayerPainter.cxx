// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseLayerPainter.h"

#include "vtkHachureCompatibility.h"

#include "Kernels.h"
#include "NoiseForwardLayer.h"
#include "NoiseInkSums.h"
#include "NoiseLayer.h"
#include "NoiseOcclusion.h"
#include "NoiseVisibility.h"
#include "PatternImageFile.h"
#include "vtkNoiseControl.h"
#include "vtkNoiseLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternMapper.h"
#include "vtkPatternNoiseHistory.h"
#include "vtkPatternShaderText.h"
#include "vtkPatternSurface.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>

namespace
{
constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double rightAngle = 90.0;

// A fibre along x, in the square from -1 to 1.
hachure::NoiseSpot Fibre()
{
  constexpr int side = 33;
  constexpr double length = 0.8; // half of it, and of the width
  constexpr double width = 0.16;
  hachure::NoiseSpot spot{ side, side, {} };
  spot.values.reserve(static_cast<std::size_t>(side) * side);
  for (int row = 0; row < side; ++row)
  {
    for (int column = 0; column < side; ++column)
    {
      const double x = (2.0 * column / (side - 1) - 1.0) / length;
      const double y = (2.0 * row / (side - 1) - 1.0) / width;
      spot.values.push_back(static_cast<float>(std::exp(-x * x * x * x - y * y)));
    }
  }
  return spot;
}
} // namespace

vtkNoiseLayerPainter::vtkNoiseLayerPainter(vtkNoiseLayer* layer)
  : Layer(layer)
{
}

std::string vtkNoiseLayerPainter::GetDeclarations(bool) const
{
  return vtkPattern::ShaderSection(NoiseLayer, "Field") + this->InkText();
}

std::string vtkNoiseLayerPainter::InkText() const
{
  const bool image = this->Layer && this->Layer->GetThresholdImage();
  return vtkPattern::ShaderSection(NoiseLayer, image ? "ThresholdImage" : "Threshold");
}

bool vtkNoiseLayerPainter::Update(
  vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error)
{
  this->Window = window;
  if (!this->Layer || !this->UpdateSpot(error) || !this->UpdateInkSums(error))
  {
    return false;
  }
  constexpr double millimetresPerInch = 25.4;
  const double unit = this->Layer->GetSizeUnit() == vtkPatternLayer::MILLIMETRES
    ? scene.DotsPerInch / millimetresPerInch
    : 1.0;
  this->FinalQuality = scene.FinalQuality;
  this->Period = this->Layer->GetSize() * unit * scene.PixelsPerLogical;
  this->UpdateThresholds();
  this->Rectangle = { 0, 0, 0, 0 };
  this->Forward = false;
  return true;
}

bool vtkNoiseLayerPainter::UpdateSpot(std::string& error)
{
  vtkImageData* image = this->Layer->GetImage();
  const vtkMTimeType time = image ? image->GetMTime() : 0;
  const bool known = !this->Spot.values.empty() && this->SpotTime == time;
  if (this->Layer->GetKind() != vtkNoiseLayer::SPOT || known)
  {
    return true;
  }
  if (!image)
  {
    this->Spot = Fibre();
    this->SpotTime = time;
    return true;
  }
  try
  {
    hachure::GreyImage grey = hachure::greyImage(image, "noise SPOT");
    this->Spot = { grey.width, grey.height, std::move(grey.values) };
  }
  catch (const std::exception& problem)
  {
    error = problem.what();
    return false;
  }
  this->SpotTime = time;
  return true;
}

bool vtkNoiseLayerPainter::UpdateInkSums(std::string& error)
{
  vtkImageData* image = this->Layer->GetThresholdImage();
  if (!image || (this->InkSumsTime == image->GetMTime() && this->InkSums->GetHandle()))
  {
    return true;
  }
  try
  {
    hachure::NoiseInkSums sums = hachure::noiseInkSums(image);
    this->InkSums->ReleaseGraphicsResources(this->Window);
    this->InkSums->SetContext(this->Window);
    this->InkSums->SetWrapS(vtkTextureObject::ClampToEdge);
    this->InkSums->SetWrapT(vtkTextureObject::ClampToEdge);
    this->InkSums->SetMinificationFilter(vtkTextureObject::Linear);
    this->InkSums->SetMagnificationFilter(vtkTextureObject::Linear);
    this->InkSums->Create2DFromRaw(static_cast<unsigned int>(sums.columns),
      static_cast<unsigned int>(sums.rows), 1, VTK_FLOAT, sums.values.data());
  }
  catch (const std::exception& problem)
  {
    error = std::string("threshold ") + problem.what();
    return false;
  }
  this->InkSumsTime = image->GetMTime();
  return true;
}

hachure::NoiseFieldOptions vtkNoiseLayerPainter::FieldOptions() const
{
  hachure::NoiseFieldOptions options;
  options.overlap = this->Layer->GetOverlap();
  options.smoothness = this->Layer->GetSmoothness();
  switch (this->Layer->GetKind())
  {
    case vtkNoiseLayer::PHASOR:
      options.kind = hachure::NoiseKind::phasor;
      break;
    case vtkNoiseLayer::SPOT:
      options.kind = hachure::NoiseKind::spot;
      options.spot = &this->Spot;
      break;
    default:
      options.kind = hachure::NoiseKind::gabor;
  }
  return options;
}

hachure::NoiseKernelOptions vtkNoiseLayerPainter::KernelOptions() const
{
  hachure::NoiseKernelOptions options;
  options.overlap = this->Layer->GetOverlap();
  options.radius = this->Layer->GetRegularity() * this->Period;
  options.frequency = 1.0 / this->Period;
  // Strokes lie across the waves; a spot is turned itself.
  const bool waves = this->Layer->GetKind() != vtkNoiseLayer::SPOT;
  options.lineAngle = (waves ? rightAngle : 0.0) * radiansPerDegree;
  options.orientation = this->Layer->GetAngle() * radiansPerDegree + options.lineAngle;
  options.spread = this->Layer->GetSpread() * radiansPerDegree;
  options.fade = this->Layer->GetFade();
  options.turning = this->Layer->GetSpread() >= rightAngle;
  options.signs = this->Layer->GetDistribution() == vtkNoiseLayer::CLASSIC;
  return options;
}

void vtkNoiseLayerPainter::UpdateThresholds()
{
  const hachure::NoiseKernelOptions kernels = this->KernelOptions();
  hachure::NoiseThresholdOptions options;
  options.field = this->FieldOptions();
  options.frequency = kernels.frequency;
  options.radius = kernels.radius;
  options.spread = kernels.spread;
  options.seed = this->Layer->GetSeed();
  std::vector<float> thresholds =
    this->Layer->GetThresholdImage() ? std::vector<float>() : hachure::noiseThresholds(options);
  if (thresholds != this->Thresholds)
  {
    this->Thresholds = std::move(thresholds);
    ++this->TableVersion;
  }
}

std::vector<hachure::NoiseKernel> vtkNoiseLayerPainter::Kernels(
  const FieldScene& scene, const hachure::NoiseKernelOptions& options, bool isDepthAtHand) const
{
  vtkPatternSurface& surface = *scene.Surface;
  hachure::NoiseView view;
  view.modelToClip = scene.ModelToClip;
  view.viewportOrigin = { scene.Viewport[0], scene.Viewport[1] };
  view.viewportSize = { scene.Viewport[2], scene.Viewport[3] };
  const std::uint32_t seed = this->Layer->GetSeed();
  if (this->Layer->GetDistribution() == vtkNoiseLayer::CLASSIC)
  {
    return hachure::classicNoiseKernels(
      surface.Mesh(), surface.TriangleIds(), surface.Objects(), seed, view, options);
  }
  std::vector<hachure::NoiseKernel> kernels;
  const auto make = [&](const hachure::NoiseOcclusion* hidden)
  {
    if (scene.History)
    {
      scene.History->Kernels(this->Layer, surface, view, options, scene.LookOn, hidden, kernels);
    }
    else
    {
      surface.Points(seed)->kernels(view, options, kernels, nullptr, hidden);
    }
  };
  if (!isDepthAtHand)
  {
    make(nullptr);
    return kernels;
  }
  hachure::NoiseSurroundings around;
  around.rectangle = scene.Rectangle;
  around.depth = scene.LookAtDepth();
  around.depthTolerance = this->DepthTolerance(scene);
  around.depthTest = this->Layer->GetDepthTest();
  around.partialVisibility = this->Layer->GetPartialVisibility();
  const double largest = options.control ? 1.0 / options.bandwidthRange.x : 1.0;
  const hachure::NoiseOcclusion hidden(around, static_cast<float>(largest * options.radius));
  make(&hidden);
  return kernels;
}

float vtkNoiseLayerPainter::DepthTolerance(const FieldScene& scene) const
{
  const auto radius = static_cast<float>(this->Layer->GetRegularity() * this->Period);
  return hachure::noiseDepthToleranceFor(radius, scene.DepthPerPixel);
}

bool vtkNoiseLayerPainter::DrawWith(
  int type, const FieldScene& scene, hachure::Span<const hachure::NoiseKernel> kernels)
{
  std::unique_ptr<vtkNoiseBackEnd>& backEnd = this->BackEnds[type];
  if (!backEnd)
  {
    backEnd = vtkNoiseBackEnd::New(type);
  }
  vtkNoiseBackEnd::Task task = { kernels, scene.Rectangle, scene.DepthImage, scene.LookAtDepth, {},
    {}, this->DepthTolerance(scene), this->Layer->GetDepthTest(),
    this->Layer->GetPartialVisibility(), this->FinalQuality, this->FieldOptions() };
  const bool objects = this->Layer->GetObjectTest() && scene.Surface->HasSeveralBlocks();
  const bool triangles = this->Layer->GetTriangleTest();
  if (objects || triangles)
  {
    const FieldScene::Seen& seen = scene.LookAtTriangles();
    task.Objects = objects ? hachure::Span<const std::int32_t>(seen.Objects) : task.Objects;
    task.Triangles = triangles ? hachure::Span<const std::int32_t>(seen.Triangles) : task.Triangles;
  }
  return backEnd->Draw(this->Window, task, this->Texture);
}

std::string vtkNoiseLayerPainter::DrawField(const FieldScene& scene, int channel)
{
  const vtkNoiseControl control(this->Layer, scene, channel);
  hachure::NoiseKernelOptions options = this->KernelOptions();
  control.Apply(options);
  const int backEnd = this->FinalQuality ? int(vtkPatternMapper::CPU) : scene.NoiseBackEnd;
  // Reading depths back from a graphics card takes longer than kernels that are hidden.
  const std::vector<hachure::NoiseKernel> kernels =
    this->Kernels(scene, options, backEnd == vtkPatternMapper::CPU);
  // A graphics card may not take so many kernels; the processors always do.
  if (!this->DrawWith(backEnd, scene, kernels))
  {
    this->DrawWith(vtkPatternMapper::CPU, scene, kernels);
  }
  this->Rectangle = scene.Rectangle;
  return control.GetProblem();
}

std::string vtkNoiseLayerPainter::GetForwardDeclarations(bool) const
{
  std::string text = vtkNoiseKernelBuffers::Text(
    NoiseForwardLayer, vtkNoiseKernelBuffers::Stage::Forward, this->FieldOptions().kind);
  vtkShaderProgram::Substitute(
    text, "IDSHERE", this->NeedsPrimitiveIds() ? "hachureIdsHere" : "hachureNoIds@");
  return text + this->InkText();
}

bool vtkNoiseLayerPainter::NeedsPrimitiveIds() const
{
  return this->Forward && (this->ForwardObjects || this->Layer->GetTriangleTest());
}

bool vtkNoiseLayerPainter::ForwardState::operator==(const ForwardState& other) const
{
  return this->ModelToClip == other.ModelToClip && this->Viewport == other.Viewport &&
    this->Rectangle == other.Rectangle && this->Period == other.Period &&
    this->SurfaceVersion == other.SurfaceVersion && this->History == other.History &&
    this->LayerTime == other.LayerTime && this->Frame == other.Frame;
}

std::vector<hachure::NoiseKernel> vtkNoiseLayerPainter::ForwardKernelsOf(
  const FieldScene& scene, const vtkNoiseControl& control) const
{
  hachure::NoiseKernelOptions options = this->KernelOptions();
  control.Apply(options);
  std::vector<hachure::NoiseKernel> kernels = this->Kernels(scene, options, false);
  if (this->Layer->GetTriangleTest())
  {
    const std::vector<std::int32_t>& facets = scene.Surface->Facets();
    for (hachure::NoiseKernel& kernel : kernels)
    {
      kernel.triangle = facets[static_cast<std::size_t>(kernel.triangle)];
    }
  }
  return kernels;
}

std::string vtkNoiseLayerPainter::DrawForwardField(const FieldScene& scene, int channel)
{
  this->Forward = true;
  this->ForwardObjects = this->Layer->GetObjectTest() && scene.Surface->HasSeveralBlocks();
  const bool tones = channel >= 0 && this->Layer->GetControl() == vtkNoiseLayer::TONE;
  const ForwardState state = { scene.ModelToClip, scene.Viewport, scene.Rectangle, this->Period,
    scene.Surface->GetVersion(), scene.History, this->Layer->GetMTime(), tones ? scene.Frame : 0 };
  // Depth peeling draws the surface many times.
  if (state == this->ForwardDrawn && this->ForwardKernels.IsUsable())
  {
    return this->ForwardProblem;
  }
  const vtkNoiseControl control(this->Layer, scene, channel);
  std::string problem = control.GetProblem();
  vtkNoiseKernelBuffers::Content content = { {}, scene.Rectangle, this->DepthTolerance(scene),
    this->Layer->GetDepthTest(), false, this->ForwardObjects, this->Layer->GetTriangleTest(),
    this->FieldOptions() };
  const std::vector<hachure::NoiseKernel> kernels = this->ForwardKernelsOf(scene, control);
  content.Kernels = kernels;
  if (!this->ForwardKernels.Upload(this->Window, content))
  {
    content.Kernels = {};
    this->ForwardKernels.Upload(this->Window, content);
    problem = "the window's OpenGL cannot hold the kernels of translucent surfaces; they are drawn "
              "in even tones";
  }
  this->ForwardDrawn = state;
  this->ForwardProblem = problem;
  return problem;
}

void vtkNoiseLayerPainter::SetUniforms(vtkShaderProgram* program, const std::string& number,
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart& rows)
{
  if (this->Forward)
  {
    this->ForwardKernels.SetUniforms(program, number);
  }
  const bool drawn = this->Forward || (this->Rectangle[2] > 0 && this->Texture->GetHandle());
  if (drawn && !this->Forward)
  {
    program->SetUniformi(("hachureNoise" + number).c_str(), this->Texture->GetTextureUnit());
  }
  if (this->Layer->GetThresholdImage())
  {
    program->SetUniformi(("hachureInkSums" + number).c_str(), this->InkSums->GetTextureUnit());
  }
  constexpr double middle = 0.5; // of a row
  const float row = static_cast<float>(
    (static_cast<double>(rows.First) + middle) / static_cast<double>(rows.RowsOfAll));
  const float flat = hachure::glsl::flatShare(1.0f, 0.0f, static_cast<float>(this->Period));
  const float place[4] = { static_cast<float>(this->Rectangle[0]),
    static_cast<float>(this->Rectangle[1]), row, drawn ? flat : 1.0f };
  program->SetUniform4f(("hachureNoisePlace" + number).c_str(), place);
}

std::array<glm::vec4, 2> vtkNoiseLayerPainter::GetPlacement(
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart&) const
{
  return {}; // the kernels are attached to points of the surface
}

void vtkNoiseLayerPainter::Activate()
{
  if (this->Forward)
  {
    this->ForwardKernels.Activate();
  }
  else if (this->Rectangle[2] > 0)
  {
    this->Texture->Activate();
  }
  if (this->Layer && this->Layer->GetThresholdImage())
  {
    this->InkSums->Activate();
  }
}

void vtkNoiseLayerPainter::Deactivate()
{
  if (this->Forward)
  {
    this->ForwardKernels.Deactivate();
  }
  else if (this->Rectangle[2] > 0)
  {
    this->Texture->Deactivate();
  }
  if (this->Layer && this->Layer->GetThresholdImage())
  {
    this->InkSums->Deactivate();
  }
}

void vtkNoiseLayerPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& backEnd : this->BackEnds)
  {
    backEnd.second->ReleaseGraphicsResources(window);
  }
  this->BackEnds.clear();
  this->ForwardKernels.ReleaseGraphicsResources(window);
  this->Texture->ReleaseGraphicsResources(window);
  this->InkSums->ReleaseGraphicsResources(window);
  this->Rectangle = { 0, 0, 0, 0 };
  this->Forward = false;
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewTextureLayerPainter.h"

#include "Kernels.h"
#include "TextureViewInput.h"
#include "ViewTexture.h"
#include "ViewTextureLayer.h"
#include "ViewTextureLevel.h"
#include "ViewTextureSample.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureViews.h"
#include "vtkViewTextureLayer.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <exception>
#include <tuple>
#include <utility>

// The blended colours, and what they were made of.
struct vtkViewTextureLayerPainter::Texture
{
  // Of one surface and one choice of options.
  using Options = std::tuple<int, int, bool, bool>;
  Options MadeWith{ 0, 0, false, false };
  std::unique_ptr<hachure::ViewTexture> Blend;
  std::vector<std::pair<vtkMTimeType, vtkMTimeType>> Cameras; // with their ranges
  std::vector<vtkMTimeType> Images;
  int Content = -1;
  std::pair<bool, bool> Base; // whether there is one, and is painted below

  bool SetViews(vtkTextureViews* views, const glm::dvec3& center);
  bool SetImages(vtkTextureViews* views);
};

// Whether any has changed.
bool vtkViewTextureLayerPainter::Texture::SetViews(vtkTextureViews* views, const glm::dvec3& center)
{
  std::vector<std::pair<vtkMTimeType, vtkMTimeType>> times;
  times.reserve(static_cast<std::size_t>(views->GetNumberOfViews()));
  for (int i = 0; i < views->GetNumberOfViews(); ++i)
  {
    times.emplace_back(views->GetViewCameraMTime(i), views->GetViewRangeMTime(i));
  }
  if (times == this->Cameras)
  {
    return false;
  }
  std::vector<hachure::TextureView> all;
  all.reserve(times.size());
  for (int i = 0; i < views->GetNumberOfViews(); ++i)
  {
    all.push_back(hachure::textureView(views, i, center));
  }
  this->Blend->setViews(all);
  this->Cameras = times;
  return true;
}

bool vtkViewTextureLayerPainter::Texture::SetImages(vtkTextureViews* views)
{
  const auto count = static_cast<std::size_t>(views->GetNumberOfViews());
  bool any = this->Images.size() != count;
  this->Images.resize(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const int view = static_cast<int>(i);
    const vtkMTimeType time = views->GetViewImageMTime(view);
    if (time != this->Images[i])
    {
      const std::vector<glm::u8vec4> pixels = hachure::texturePixels(views, view);
      const int* const size = views->GetViewImage(view)->GetDimensions();
      this->Blend->setImage(i, { size[0], size[1], pixels });
      this->Images[i] = time;
      any = true;
    }
  }
  return any;
}

namespace
{
hachure::ViewTextureContent ContentOf(int display)
{
  switch (display)
  {
    case vtkViewTextureLayer::DEPENDENT_ONLY:
      return hachure::ViewTextureContent::DependentOnly;
    case vtkViewTextureLayer::INDEPENDENT_ONLY:
      return hachure::ViewTextureContent::IndependentOnly;
    case vtkViewTextureLayer::COVERAGE:
      return hachure::ViewTextureContent::Coverage;
    default:
      return hachure::ViewTextureContent::Combined;
  }
}
} // namespace

vtkViewTextureLayerPainter::vtkViewTextureLayerPainter(vtkViewTextureLayer* layer)
  : Layer(layer)
  , Colors(std::make_unique<Texture>())
{
}

vtkViewTextureLayerPainter::~vtkViewTextureLayerPainter() = default;

bool vtkViewTextureLayerPainter::Update(
  vtkOpenGLRenderWindow* window, const Scene& scene, std::string&)
{
  this->Window = window;
  this->CurrentScene = scene;
  return this->Layer != nullptr;
}

bool vtkViewTextureLayerPainter::HasDependent() const
{
  vtkTextureViews* views = this->Layer->GetViews();
  bool any = false;
  for (int i = 0; i < views->GetNumberOfViews(); ++i)
  {
    any = any || views->GetViewKind(i) == vtkTextureViews::DEPENDENT;
  }
  return any && this->Layer->GetDisplay() != vtkViewTextureLayer::INDEPENDENT_ONLY;
}

// Whether the base can be put below the dependent views once for all.
bool vtkViewTextureLayerPainter::IsPainted() const
{
  return this->HasBase() && this->HasDependent() &&
    this->Layer->GetViews()->GetNumberOfBlendPoints() == 0;
}

bool vtkViewTextureLayerPainter::HasIndependent() const
{
  return this->HasBase() && !this->IsPainted();
}

bool vtkViewTextureLayerPainter::HasBase() const
{
  return this->Layer->GetBase() == vtkViewTextureLayer::VIEWS &&
    this->Layer->GetDisplay() != vtkViewTextureLayer::DEPENDENT_ONLY;
}

std::string vtkViewTextureLayerPainter::GetDeclarations(bool) const
{
  const bool disk = this->Layer->GetViews()->GetHemisphereMap() == vtkTextureViews::DISK;
  std::string text = ViewTextureLayer;
  vtkShaderProgram::Substitute(text, "HEMISPHEREMAP", disk ? "hemisphereDisk" : "hemisphereSquare");
  vtkShaderProgram::Substitute(
    text, "HEMISPHERE", std::to_string(this->Layer->GetViews()->GetHemisphere()) + ".0");
  vtkShaderProgram::Substitute(text, "HASDEPENDENT", this->HasDependent() ? "1" : "0");
  vtkShaderProgram::Substitute(text, "HASINDEPENDENT", this->HasIndependent() ? "1" : "0");
  return text;
}

vtkPatternSurface::CellKey vtkViewTextureLayerPainter::CellKey() const
{
  const hachure::SurfaceCellOptions options =
    hachure::surfaceCellOptions(this->Layer->GetViews(), this->Layer->GetMemoryBudget());
  return { options.baseCells, options.finestLevel, options.mostNodes };
}

void vtkViewTextureLayerPainter::UpdateCells(vtkPatternSurface& surface)
{
  const std::shared_ptr<vtkPatternSurface::CellSet> cells = surface.Cells(this->CellKey());
  const bool others = cells != this->Cells || !this->Buffers.IsUsable();
  if (others)
  {
    this->Buffers.UploadCells(this->Window, surface.Runs(), cells->Cells, cells->First);
    this->Cells = cells;
    const int wanted = this->Layer->GetViews()->GetFinestLevel();
    this->Note = cells->Cells.finestLevel < wanted && !cells->Cells.charts.empty()
      ? "the colours of levels 0 to " + std::to_string(wanted) +
        " would take more than the memory budget of " +
        std::to_string(this->Layer->GetMemoryBudget()) + " MiB; the finest level is " +
        std::to_string(cells->Cells.finestLevel)
      : std::string();
    this->Colors->Blend.reset();
  }
  const glm::dvec3& origin = this->CurrentScene.PatchOrigin;
  if (others || this->SurfaceVersion != surface.GetVersion() || this->Origin != origin)
  {
    this->Buffers.UploadFrames(this->Window, cells->Frames, surface.Mesh().points, origin);
    this->SurfaceVersion = surface.GetVersion();
    if (this->Origin != origin)
    {
      this->Origin = origin;
      this->Colors->Cameras.clear(); // they are about the origin
    }
  }
}

void vtkViewTextureLayerPainter::UpdateColors(vtkPatternSurface& surface)
{
  vtkTextureViews* views = this->Layer->GetViews();
  Texture& texture = *this->Colors;
  const Texture::Options options(views->GetHemisphere(), views->GetHemisphereMap(),
    this->Layer->GetPropagateUp(), this->Layer->GetClassicShares());
  if (!texture.Blend || options != texture.MadeWith)
  {
    texture = {};
    texture.MadeWith = options;
    const std::vector<glm::dvec3> first = surface.FirstPositions();
    texture.Blend = std::make_unique<hachure::ViewTexture>(
      hachure::TriangleMesh{ first, surface.Mesh().triangles, {} }, this->Cells->Cells,
      this->Cells->First,
      hachure::viewTextureOptions(
        views, this->Layer->GetPropagateUp(), this->Layer->GetClassicShares()));
  }
  const bool otherViews = texture.SetViews(views, this->Origin);
  const bool otherImages = texture.SetImages(views);
  const int content = this->Layer->GetDisplay();
  const std::pair<bool, bool> base(this->HasBase(), this->IsPainted());
  if (otherViews || otherImages || content != texture.Content || base != texture.Base)
  {
    texture.Content = content;
    texture.Base = base;
    hachure::ViewTextureColors colors = texture.Blend->colors(ContentOf(content));
    if (base.first)
    {
      hachure::paintUnknown(colors);
    }
    if (base.second)
    {
      hachure::paintBelow(colors);
    }
    this->Buffers.UploadColors(this->Window, colors);
  }
}

void vtkViewTextureLayerPainter::UpdateView(const FieldScene& scene)
{
  const glm::dmat4 toClip = glm::translate(scene.ModelToClip, this->Origin);
  const double toLogical = 0.5 / this->CurrentScene.PixelsPerLogical;
  this->RowX = glm::vec4(toLogical * scene.Viewport[2] * glm::row(toClip, 0));
  this->RowY = glm::vec4(toLogical * scene.Viewport[3] * glm::row(toClip, 1));
  this->RowW = glm::vec4(glm::row(toClip, 3));
  this->Viewer = glm::vec4(hachure::viewerOf(toClip));
  const double cellArea = this->Cells->Cells.cellArea;
  const glm::dvec2 logicalSize =
    glm::dvec2(scene.Viewport[2], scene.Viewport[3]) / this->CurrentScene.PixelsPerLogical;
  const bool one = this->Layer->GetLevel() == vtkViewTextureLayer::ONE;
  const double level = one
    ? hachure::levelOfSurface(scene.Surface->Mesh(), scene.ModelToClip, logicalSize, cellArea)
    : 0.0;
  this->Shape = { static_cast<float>(cellArea), static_cast<float>(this->Cells->Cells.finestLevel),
    static_cast<float>(
      hachure::independentShare(this->Layer->GetViews(), scene.ModelToClip, this->Origin)),
    one ? 1.0f + static_cast<float>(std::max(level, 0.0)) : 0.0f };
}

std::string vtkViewTextureLayerPainter::DrawField(const FieldScene& scene, int)
{
  const std::pair<unsigned long, vtkMTimeType> state(
    scene.Surface->GetVersion(), this->Layer->GetMTime());
  // What could not be made of this is not tried again for every picture.
  if (!this->Problem.empty() && state == this->Failed)
  {
    return this->Problem;
  }
  this->Problem.clear();
  try
  {
    this->UpdateCells(*scene.Surface);
    this->UpdateColors(*scene.Surface);
    this->UpdateView(scene);
  }
  catch (const std::exception& error)
  {
    this->Problem = error.what();
    this->Failed = state;
  }
  if (!this->Problem.empty() || !this->Buffers.IsUsable())
  {
    this->DrawNothing();
  }
  return this->Problem;
}

void vtkViewTextureLayerPainter::DrawNothing()
{
  this->Cells.reset(); // all is made again
  this->Colors = std::make_unique<Texture>();
  this->Buffers.UploadNothing(this->Window);
  this->Shape.x = -1.0f;
}

std::string vtkViewTextureLayerPainter::DrawForwardField(const FieldScene& scene, int channel)
{
  return this->DrawField(scene, channel);
}

void vtkViewTextureLayerPainter::SetUniforms(vtkShaderProgram* program, const std::string& number,
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart&)
{
  this->Buffers.SetUniforms(program, number);
  const std::pair<const char*, const glm::vec4*> vectors[] = { { "hachureCellX", &this->RowX },
    { "hachureCellY", &this->RowY }, { "hachureCellW", &this->RowW },
    { "hachureViewer", &this->Viewer }, { "hachureCellShape", &this->Shape } };
  for (const auto& vector : vectors)
  {
    program->SetUniform4f((vector.first + number).c_str(), &vector.second->x);
  }
}

std::array<glm::vec4, 2> vtkViewTextureLayerPainter::GetPlacement(
  const hachure::PatternFrame&, const hachure::TimedOctave*, const TablePart&) const
{
  return {}; // attached to the surface
}

void vtkViewTextureLayerPainter::Activate()
{
  this->Buffers.Activate();
}

void vtkViewTextureLayerPainter::Deactivate()
{
  this->Buffers.Deactivate();
}

void vtkViewTextureLayerPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.Release(window);
  this->Cells.reset();
  this->Problem.clear();
  this->Colors = std::make_unique<Texture>();
}

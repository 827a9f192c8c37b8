// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewTextureLayerPainter.h"

#include "Kernels.h"
#include "ViewTextureLayer.h"
#include "ViewTextureLevel.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureViews.h"
#include "vtkViewTextureLayer.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>

struct vtkViewTextureLayerPainter::Texture
{
  hachure::ViewTextureColors Colors;
};

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

bool vtkViewTextureLayerPainter::HasIndependent() const
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
  vtkTextureViews* views = this->Layer->GetViews();
  constexpr std::int64_t bytesPerMiB = 1 << 20;
  const std::int64_t directions =
    static_cast<std::int64_t>(views->GetHemisphere()) * views->GetHemisphere();
  const std::int64_t bytesPerNode = 4 * (directions + 1);
  return { views->GetBaseCells(), views->GetFinestLevel(),
    this->Layer->GetMemoryBudget() * bytesPerMiB / bytesPerNode };
}

void vtkViewTextureLayerPainter::UpdateCells(vtkPatternSurface& surface)
{
  const std::shared_ptr<vtkPatternSurface::CellSet> cells = surface.Cells(this->CellKey());
  const bool others = cells != this->Cells || !this->Buffers.IsUsable();
  if (others)
  {
    this->Buffers.UploadCells(this->Window, surface.Runs(), cells->Cells, cells->First);
    this->Cells = cells;
    hachure::ViewTextureColors colors;
    std::vector<glm::u8vec4> all(static_cast<std::size_t>(cells->Cells.firstNode.back()));
    for (std::size_t chart = 0; chart < cells->Cells.charts.size(); ++chart)
    {
      for (int level = 0; level <= cells->Cells.finestLevel; ++level)
      {
        const auto first = hachure::firstNodeOf(cells->Cells, chart, level);
        const int m = hachure::subdivisionsOf(cells->Cells.charts[chart], level);
        for (int i = 0; i < hachure::glsl::chartNodes(m); ++i)
        {
          const glm::vec3 c(0.5f + 0.5f * std::sin(chart * 2.1f),
            0.5f + 0.5f * std::sin(chart * 1.3f + 1), i < (1 << (2 * m)) ? 0.9f : 0.1f);
          all[first + i] = glm::u8vec4(glm::u8vec3(255.0f * c), 255);
        }
      }
    }
    colors.independent = all;
    this->Buffers.UploadColors(this->Window, colors);
  }
  const glm::dvec3& origin = this->CurrentScene.PatchOrigin;
  if (others || this->SurfaceVersion != surface.GetVersion() || this->Origin != origin)
  {
    this->Buffers.UploadFrames(this->Window, cells->Frames, surface.Mesh().points, origin);
    this->SurfaceVersion = surface.GetVersion();
    this->Origin = origin;
  }
}

void vtkViewTextureLayerPainter::UpdateView(const FieldScene& scene)
{
  const glm::dmat4 toClip = glm::translate(scene.ModelToClip, this->Origin);
  const double toLogical = 0.5 / this->CurrentScene.PixelsPerLogical;
  this->RowX = glm::vec4(toLogical * scene.Viewport[2] * glm::row(toClip, 0));
  this->RowY = glm::vec4(toLogical * scene.Viewport[3] * glm::row(toClip, 1));
  this->RowW = glm::vec4(glm::row(toClip, 3));
  // What all of its depths are drawn to one point of the picture is the eye.
  const glm::dvec4 eye = glm::inverse(toClip) * glm::dvec4(0.0, 0.0, -1.0, 0.0);
  constexpr double farAway = 1e-9;
  const bool parallel = std::abs(eye.w) < farAway * glm::length(glm::dvec3(eye));
  this->Viewer = parallel ? glm::vec4(glm::vec3(eye), 0.0f)
                          : glm::vec4(glm::vec3(eye) / static_cast<float>(eye.w), 1.0f);
  const double cellArea = this->Cells->Cells.cellArea;
  const glm::dvec2 logicalSize =
    glm::dvec2(scene.Viewport[2], scene.Viewport[3]) / this->CurrentScene.PixelsPerLogical;
  const bool one = this->Layer->GetLevel() == vtkViewTextureLayer::ONE;
  const double level = one
    ? hachure::levelOfSurface(scene.Surface->Mesh(), scene.ModelToClip, logicalSize, cellArea)
    : 0.0;
  this->Shape = { static_cast<float>(cellArea), static_cast<float>(this->Cells->Cells.finestLevel),
    0.0f, one ? 1.0f + static_cast<float>(std::max(level, 0.0)) : 0.0f };
}

std::string vtkViewTextureLayerPainter::DrawField(const FieldScene& scene, int)
{
  this->UpdateCells(*scene.Surface);
  this->UpdateView(scene);
  return {};
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
}

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a vtkViewTextureLayer: brings the colours of the surface's cells up to date, which the
 * layer's text evaluates.
 */
#ifndef vtkViewTextureLayerPainter_h
#define vtkViewTextureLayerPainter_h

#include "ViewTextureBuffers.h"
#include "vtkPatternLayerPainter.h"
#include "vtkPatternSurface.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <utility>

class vtkViewTextureLayer;

class vtkViewTextureLayerPainter : public vtkPatternLayerPainter
{
public:
  explicit vtkViewTextureLayerPainter(vtkViewTextureLayer* layer);
  ~vtkViewTextureLayerPainter() override;

  bool Update(vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error) override;
  std::string GetNote() const override { return this->Note; }
  bool NeedsRuns() const override { return true; }
  std::string GetInkColor() const override { return "hachureViewColor@"; }
  bool NeedsField() const override { return true; }
  std::string DrawField(const FieldScene& scene, int channel) override;
  std::string DrawForwardField(const FieldScene& scene, int channel) override;
  std::string GetDeclarations(bool patches) const override;
  const std::vector<float>& GetTableRows() const override { return this->NoRows; }
  unsigned long GetTableVersion() const override { return 0; }
  void SetUniforms(vtkShaderProgram* program, const std::string& number,
    const hachure::PatternFrame& frame, const hachure::TimedOctave* octave,
    const TablePart& rows) override;
  std::array<glm::vec4, 2> GetPlacement(const hachure::PatternFrame& frame,
    const hachure::TimedOctave* octave, const TablePart& rows) const override;
  void Activate() override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  struct Texture;
  vtkPatternSurface::CellKey CellKey() const;
  bool HasDependent() const;
  bool HasIndependent() const;
  bool HasBase() const;
  bool IsPainted() const;
  void UpdateCells(vtkPatternSurface& surface);
  void UpdateColors(vtkPatternSurface& surface);
  void UpdateView(const FieldScene& scene);
  void DrawNothing();

  vtkWeakPointer<vtkViewTextureLayer> Layer;
  vtkOpenGLRenderWindow* Window = nullptr;
  Scene CurrentScene;
  std::string Note;
  std::vector<float> NoRows;
  ViewTextureBuffers Buffers;
  std::shared_ptr<vtkPatternSurface::CellSet> Cells; // uploaded
  unsigned long SurfaceVersion = 0;                  // whose frames are
  glm::dvec3 Origin{ 0.0 };                          // of these
  std::unique_ptr<Texture> Colors;
  std::string Problem;                           // empty: all could be made
  std::pair<unsigned long, vtkMTimeType> Failed; // versions of surface and layer that it is about

  // Uniforms.
  glm::vec4 RowX{ 0.0f };
  glm::vec4 RowY{ 0.0f };
  glm::vec4 RowW{ 0.0f };
  glm::vec4 Viewer{ 0.0f };
  glm::vec4 Shape{ 0.0f };
};

#endif
// VTK-HeaderTest-Exclude: vtkViewTextureLayerPainter.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a vtkImagePatternLayer: keeps its tile, mip chain and tone table as textures.
 */
#ifndef vtkImagePatternLayerPainter_h
#define vtkImagePatternLayerPainter_h

#include "ImagePatternTiles.h"
#include "PatternPlacement.h"
#include "PatternTile.h"
#include "ToneTable.h"
#include "vtkNew.h"
#include "vtkPatternLayerPainter.h"
#include "vtkTextureObject.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkImagePatternLayer;

class vtkImagePatternLayerPainter : public vtkPatternLayerPainter
{
public:
  explicit vtkImagePatternLayerPainter(vtkImagePatternLayer* layer);

  bool Update(vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error) override;
  std::string GetNote() const override;
  bool FollowsPatches() const override;
  std::string GetInkColor() const override;
  bool UsesResponses() const override { return this->Paper != nullptr; }
  std::string GetDeclarations(bool patches) const override;
  SurfaceNeed GetSurfaceNeed() const override;
  const std::vector<float>& GetTableRows() const override { return this->TableRows; }
  unsigned long GetTableVersion() const override { return this->TableVersion; }
  void SetUniforms(vtkShaderProgram* program, const std::string& number,
    const hachure::PatternFrame& frame, const hachure::TimedOctave* octave,
    const TablePart& rows) override;
  std::array<glm::vec4, 2> GetPlacement(const hachure::PatternFrame& frame,
    const hachure::TimedOctave* octave, const TablePart& rows) const override;
  void Activate() override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  using Mips = hachure::TileMips;
  bool UpdateTile(std::string& error);
  void UpdateTable(const Scene& scene);
  /// Tables, of a pattern on the surface for several footprints.
  void BuildTables(hachure::ToneTableOptions options, int blocks);
  hachure::ToneTableOptions TableOptions() const;
  hachure::LodTransition Transition() const;
  hachure::ToneCorrection Correction() const;
  bool BlendsScreens() const;
  hachure::PatternPlacement Place(
    const hachure::PatternFrame& frame, const hachure::TimedOctave* octave) const;
  bool OnSurface() const;
  double ReferencePeriod(double whole) const;
  void SetSurfaceUniforms(
    vtkShaderProgram* program, const std::string& number, double firstTableRow);
  void Upload(vtkOpenGLRenderWindow* window);
  std::vector<vtkTextureObject*> UsedTextures();
  void SetPaperUniforms(vtkShaderProgram* program, const std::string& number);
  void SetPaintUniforms(vtkShaderProgram* program, const std::string& number);
  /// Framebuffer pixels of a length of the layer.
  double InPixels(double length, int unit) const;

  vtkWeakPointer<vtkImagePatternLayer> Layer;
  Mips Tile;
  vtkMTimeType TileTime = 0;
  std::vector<std::shared_ptr<const hachure::ToneTable>> Tables;
  std::vector<float> TableRows;
  int TableBlocks = 0;
  unsigned long TableVersion = 0;
  Mips TableTile;
  double Period = 8.0; // pixels of the framebuffer per pattern period at LOD scale 1
  Scene CurrentScene;
  vtkNew<vtkTextureObject> Texture;
  Mips UploadedTile;
  bool UploadedBetweenLevels = false; // the texture filters between levels
  hachure::PaintMips Dabs;            // of paint, else null
  vtkNew<vtkTextureObject> DabsOnTop;
  vtkNew<vtkTextureObject> DabsBelow;
  hachure::PaintMips UploadedDabs;
  Mips Paper; // where it has contrast, else null
  vtkNew<vtkTextureObject> PaperTexture;
  Mips UploadedPaper;
};

#endif
// VTK-HeaderTest-Exclude: vtkImagePatternLayerPainter.h

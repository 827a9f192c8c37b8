// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a vtkStippleLayer: finds the stipples of a picture, and covers its pixels with them.
 */
#ifndef vtkStippleLayerPainter_h
#define vtkStippleLayerPainter_h

#include "StippleCanvas.h"
#include "StippleDrawing.h"
#include "vtkNew.h"
#include "vtkPatternLayerPainter.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

class vtkStippleLayer;

class vtkStippleLayerPainter : public vtkPatternLayerPainter
{
public:
  explicit vtkStippleLayerPainter(vtkStippleLayer* layer);

  bool Update(vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error) override;
  std::string GetNote() const override { return this->Note; }
  std::string GetDeclarations(bool patches) const override;
  std::string GetForwardDeclarations(bool patches) const override;
  const std::vector<float>& GetTableRows() const override { return this->NoRows; }
  unsigned long GetTableVersion() const override { return 0; }
  bool NeedsField() const override { return true; }
  std::string DrawField(const FieldScene& scene, int channel) override;
  std::string DrawForwardField(const FieldScene& scene, int channel) override;
  void CollectDiscs(std::vector<Disc>& discs) const override;
  void SetUniforms(vtkShaderProgram* program, const std::string& number,
    const hachure::PatternFrame& frame, const hachure::TimedOctave* octave,
    const TablePart& rows) override;
  std::array<glm::vec4, 2> GetPlacement(const hachure::PatternFrame& frame,
    const hachure::TimedOctave* octave, const TablePart& rows) const override;
  void Activate() override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  void SetTones(const FieldScene& scene, int channel, hachure::StippleScene& stipples);
  void Separate(const FieldScene& scene);
  void Draw(const FieldScene& scene, int channel, hachure::Span<const float> depth);
  void FindStipples(
    const FieldScene& scene, const hachure::StippleScene& seen, const hachure::StippleLook& look);
  void FindClassicStipples(
    const FieldScene& scene, const hachure::StippleScene& seen, const hachure::StippleLook& look);
  void Fade(const hachure::StippleTree& tree, const std::vector<float>& shares, std::size_t first);
  void Upload(const std::array<int, 4>& rectangle);

  vtkWeakPointer<vtkStippleLayer> Layer;
  vtkOpenGLRenderWindow* Window = nullptr;
  double Diameter = 2.4; // of a grown stipple, pixels of the framebuffer
  std::string Note;
  std::vector<float> NoRows;
  std::vector<hachure::DrawnStipple> Drawn;
  std::vector<hachure::StippleDisc> Discs;
  hachure::StippleCanvas Canvas;
  std::vector<std::uint8_t> Covered;
  std::vector<std::uint8_t> Separation; // tones of an ink
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkTextureObject> FrontDepth;           // of a translucent surface
  std::array<int, 4> Rectangle = { 0, 0, 0, 0 }; // that the textures are of; empty: of nothing

  // What the stipples of a translucent surface depend on. Depth peeling draws it many times.
  struct ForwardState
  {
    glm::dmat4 ModelToClip{ 0.0 };
    std::array<int, 4> Viewport;
    std::array<int, 4> Rectangle;
    double Diameter;
    unsigned long SurfaceVersion;
    vtkMTimeType LayerTime;
    unsigned long Frame;
    bool operator==(const ForwardState& other) const;
  };
  bool Forward = false; // such a surface is drawn now
  ForwardState ForwardDrawn{};
};

#endif
// VTK-HeaderTest-Exclude: vtkStippleLayerPainter.h

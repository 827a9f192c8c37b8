// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Turns a style into shader text, textures and uniforms for one window. The screen pass and the
 * forward shader use the same text.
 */
#ifndef vtkPatternCompositor_h
#define vtkPatternCompositor_h

#include "PatternTracker.h"
#include "vtkNew.h"
#include "vtkPatternAttributes.h"
#include "vtkPatternLayerPainter.h"
#include "vtkPatternNumberBuffer.h"
#include "vtkPatternToneChannels.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternLayer;
class vtkPatternPatches;
class vtkPatternStyle;
class vtkShaderProgram;
class vtkWindow;
struct vtkPatternViewport;

class vtkPatternCompositor
{
public:
  /// Brings layers up to date; layers that cannot be drawn are left out and named in `error`.
  void Update(vtkPatternStyle* style, const vtkPatternToneChannels& channels,
    const vtkPatternPatches& patches, vtkOpenGLRenderWindow* window,
    const vtkPatternLayerPainter::Scene& scene, std::string& error);

  /// What the user should know about layers that are drawn all the same; empty where all is well.
  std::string GetNote() const;

  /// What the layers must know of the surface.
  vtkPatternAttributes GetAttributes() const;

  /// Whether some layer's field is made for the pixels that are seen, and makes it.
  bool NeedsFields() const;
  /// Returns what is wrong with the data, empty where all is well.
  std::string DrawFields(const vtkPatternLayerPainter::FieldScene& scene);
  /// The same before a translucent surface is drawn.
  std::string DrawForwardFields(const vtkPatternLayerPainter::FieldScene& scene);

  /// Discs that the layers' fields are made of, in the order of the layers.
  void CollectDiscs(std::vector<vtkPatternLayerPainter::Disc>& discs) const;

  /// Which octave of a layer's pattern every patch draws, for the draws that follow; layers that
  /// are not there go by the scale.
  using Octaves = std::map<vtkSmartPointer<vtkPatternLayer>, std::vector<hachure::TimedOctave>>;
  void SetOctaves(const Octaves& octaves) { this->TimedOctaves = octaves; }

  /// Functions and uniforms; defines hachureCompose() and hachureLogicalPosition(). forward: for
  /// the shader of a translucent surface, which has no attribute images.
  std::string GetShaderText(bool forward) const;

  /// `frame`: where the pattern of the first patch lies, the same for every layer.
  void SetUniforms(vtkShaderProgram* program, vtkPatternStyle* style,
    const vtkPatternViewport& viewport, const double nanColor[3],
    const hachure::PatternFrame& frame);

  /// `frames`: where the pattern of each patch lies.
  void Activate(const std::vector<hachure::PatternFrame>& frames);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Drawn
  {
    vtkSmartPointer<vtkPatternLayer> Layer;
    vtkPatternLayerPainter* Painter = nullptr;
    int Channel = -1;
  };
  using FieldFunction = std::string (vtkPatternLayerPainter::*)(
    const vtkPatternLayerPainter::FieldScene&, int);
  std::string ForFields(FieldFunction draw, const vtkPatternLayerPainter::FieldScene& scene);
  void UpdateText(int paperSource);
  std::string Declarations(bool forward) const;
  std::string StackText(bool forward) const;
  void SetSurfaceUniforms(vtkShaderProgram* program, const vtkPatternViewport& viewport);
  void SetPlaceUniforms(vtkShaderProgram* program, const vtkPatternViewport& viewport);
  void UpdateTables(vtkOpenGLRenderWindow* window);
  const hachure::TimedOctave* OctaveOf(vtkPatternLayer* layer, std::size_t patch) const;
  void UploadPlacements(const std::vector<hachure::PatternFrame>& frames);

  std::map<vtkSmartPointer<vtkPatternLayer>, std::unique_ptr<vtkPatternLayerPainter>> Painters;
  std::vector<Drawn> Layers;
  Octaves TimedOctaves;
  std::string ShaderText;
  int PaperSource = 0; // as the style has it
  vtkNew<vtkTextureObject> Tables;
  std::vector<std::pair<vtkPatternLayerPainter*, unsigned long>> TableState;
  std::size_t TableRows = 0;
  vtkNew<vtkTextureObject> Responses; // the tables the other way round
  bool TableResponses = false;        // they are needed
  vtkPatternLayerPainter::Scene CurrentScene;
  int PatchCount = 1;
  bool Outline = false;
  bool Colors = false;               // the surface's own are part of the picture
  vtkPatternNumberBuffer Placements; // per patch and layer
  std::vector<glm::vec4> PlacementTexels;
  vtkOpenGLRenderWindow* Window = nullptr; // of the last update
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternCompositor.h

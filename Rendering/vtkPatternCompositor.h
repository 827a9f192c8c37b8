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
#include "vtkPatternLayerPainter.h"
#include "vtkPatternToneChannels.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternLayer;
class vtkPatternStyle;
class vtkShaderProgram;
class vtkWindow;
struct vtkPatternViewport;

class vtkPatternCompositor
{
public:
  /// Brings layers up to date; layers that cannot be drawn are left out and named in `error`.
  void Update(vtkPatternStyle* style, const vtkPatternToneChannels& channels,
    vtkOpenGLRenderWindow* window, const vtkPatternLayerPainter::Scene& scene, std::string& error);

  /// What the user should know about layers that are drawn all the same; empty where all is well.
  std::string GetNote() const;

  /// What the layers must know of the surface: the most that one of them needs.
  vtkPatternLayerPainter::SurfaceNeed GetSurfaceNeed() const;

  /// Functions and uniforms; defines hachureCompose() and hachureLogicalPosition().
  const std::string& GetShaderText() const { return this->ShaderText; }

  /// One pattern frame for every layer.
  void SetUniforms(vtkShaderProgram* program, vtkPatternStyle* style,
    const vtkPatternViewport& viewport, const double nanColor[3],
    const hachure::PatternFrame& frame);

  void Activate();
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Drawn
  {
    vtkSmartPointer<vtkPatternLayer> Layer;
    vtkPatternLayerPainter* Painter = nullptr;
    int Channel = -1;
  };
  void UpdateText();
  void SetSurfaceUniforms(vtkShaderProgram* program, const vtkPatternViewport& viewport);
  void UpdateTables(vtkOpenGLRenderWindow* window);

  std::map<vtkSmartPointer<vtkPatternLayer>, std::unique_ptr<vtkPatternLayerPainter>> Painters;
  std::vector<Drawn> Layers;
  std::string ShaderText;
  vtkNew<vtkTextureObject> Tables;
  std::vector<std::pair<vtkPatternLayerPainter*, unsigned long>> TableState;
  std::size_t TableRows = 0;
  vtkPatternLayerPainter::Scene CurrentScene;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternCompositor.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the parts of vtkPatternMapper's implementation share. Internal.
#ifndef vtkPatternMapperInternals_h
#define vtkPatternMapperInternals_h

#include "vtkNew.h"
#include "vtkPatternCompositor.h"
#include "vtkPatternLights.h"
#include "vtkPatternMapper.h"
#include "vtkPatternPatchRecords.h"
#include "vtkPatternPatches.h"
#include "vtkPatternScreenPass.h"
#include "vtkPatternShaderInjector.h"
#include "vtkPatternSurface.h"
#include "vtkPatternToneChannels.h"
#include "vtkPatternTonePeel.h"
#include "vtkPatternViewContext.h"
#include "vtkPatternViewport.h"
#include "vtkPatternWindowResources.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <glm/vec3.hpp>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

struct vtkPatternMapper::WindowPart
{
  vtkPatternCompositor Compositor;
  std::shared_ptr<vtkPatternWindowResources> Resources;
  vtkPatternScreenPass ScreenPass;
  vtkPatternTonePeel TonePeel;
  vtkPatternPatchRecordBuffers PatchRecords;
  unsigned long PatchVersion = 0; // of the records in the buffer
};

struct vtkPatternMapper::Internals
{
  vtkPatternToneChannels Channels;
  vtkPatternLights Lights; // of the renderer that draws now
  vtkPatternPatches Patches;
  vtkPatternPatchRecords PatchRecords;
  glm::dvec3 PatchOrigin{ 0.0 };
  bool PatchesBeginAnew = false; // their origin, too
  vtkPatternSurface Surface;
  vtkTimeStamp ChannelTime;
  bool UsesTextureCoordinates = false; // once needed, they stay in the vertex buffers
  bool UsesPrimitiveIds = false;       // the same
  unsigned long IdentifiedCells = 0;   // of the surface, whose ids the buffers hold
  std::vector<vtkSmartPointer<vtkPolyData>> Surroundings; // blocks that others draw
  double DrawnBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkDataObject* DrawnInput = nullptr; // that has these bounds
  vtkMTimeType DrawnTime = 0;
  bool UsesRuns = false; // the same
  unsigned long CellsOfRuns = 0;
  std::map<vtkWindow*, WindowPart> Windows;
  vtkNew<vtkPatternShaderInjector> AttributeInjector;
  vtkNew<vtkPatternShaderInjector> PeelInjector;
  vtkNew<vtkPatternShaderInjector> ForwardInjector;
  bool KeepsStipples = false;
  std::map<std::pair<vtkRenderer*, vtkActor*>, std::vector<vtkPatternLayerPainter::Disc>> Stipples;
  std::vector<double> KeyTimes;
  unsigned long AnchorVersion = 0;
  std::string ChannelError;
  std::string ReportedStyle;
  std::map<vtkRenderer*, std::string> ReportedLights; // renderers may have different ones
  std::string ReportedDevice;
  std::string ReportedNote;
  std::string ReportedProblem;
  std::string ReportedField;
  std::string ReportedBackEnd;
};

// All that one Render call hands from step to step.
struct vtkPatternMapper::Drawing
{
  vtkRenderer* Renderer;
  vtkActor* Actor;
  vtkOpenGLRenderWindow* Window;
  WindowPart& Part;
  vtkPatternViewport Viewport;
  vtkPatternViewContext::Track* Track;
  bool Measures; // the visibility of the samples belongs to this drawing
  // x, y, width, height in the framebuffer: of what is drawn here, and of the whole surface
  std::array<int, 4> Rectangle = { 0, 0, 0, 0 };
  std::array<int, 4> Whole = { 0, 0, 0, 0 };
  std::vector<vtkPatternTonePeel::Image> Tones = {}; // of a translucent surface
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternMapperInternals.h

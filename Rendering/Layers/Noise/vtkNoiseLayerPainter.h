// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a vtkNoiseLayer: sums its kernels up for the pixels that show the surface.
 */
#ifndef vtkNoiseLayerPainter_h
#define vtkNoiseLayerPainter_h

#include "NoiseField.h"
#include "NoiseSurface.h"
#include "vtkNew.h"
#include "vtkNoiseBackEnd.h"
#include "vtkNoiseKernelBuffers.h"
#include "vtkPatternLayerPainter.h"
#include "vtkTextureObject.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>

class vtkNoiseControl;
class vtkNoiseLayer;

class vtkNoiseLayerPainter : public vtkPatternLayerPainter
{
public:
  explicit vtkNoiseLayerPainter(vtkNoiseLayer* layer);

  bool Update(vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error) override;
  std::string GetDeclarations(bool patches) const override;
  std::string GetForwardDeclarations(bool patches) const override;
  const std::vector<float>& GetTableRows() const override { return this->Thresholds; }
  unsigned long GetTableVersion() const override { return this->TableVersion; }
  bool NeedsField() const override { return true; }
  bool NeedsPrimitiveIds() const override;
  std::string DrawField(const FieldScene& scene, int channel) override;
  std::string DrawForwardField(const FieldScene& scene, int channel) override;
  void SetUniforms(vtkShaderProgram* program, const std::string& number,
    const hachure::PatternFrame& frame, const hachure::TimedOctave* octave,
    const TablePart& rows) override;
  std::array<glm::vec4, 2> GetPlacement(const hachure::PatternFrame& frame,
    const hachure::TimedOctave* octave, const TablePart& rows) const override;
  void Activate() override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  bool UpdateSpot(std::string& error);
  bool UpdateInkSums(std::string& error);
  void UpdateThresholds();
  hachure::NoiseFieldOptions FieldOptions() const;
  hachure::NoiseKernelOptions KernelOptions() const;
  std::vector<hachure::NoiseKernel> ForwardKernelsOf(
    const FieldScene& scene, const vtkNoiseControl& control) const;
  // isDepthAtHand: kernels that the depth hides are left out.
  std::vector<hachure::NoiseKernel> Kernels(
    const FieldScene& scene, const hachure::NoiseKernelOptions& options, bool isDepthAtHand) const;
  std::string InkText() const;
  float DepthTolerance(const FieldScene& scene) const;
  bool DrawWith(
    int type, const FieldScene& scene, hachure::Span<const hachure::NoiseKernel> kernels);

  vtkWeakPointer<vtkNoiseLayer> Layer;
  vtkOpenGLRenderWindow* Window = nullptr;
  bool FinalQuality = false;
  double Period = 8.0; // pixels of the framebuffer per mark
  std::vector<float> Thresholds;
  hachure::NoiseThresholdOptions ThresholdOptions; // that they were measured with
  unsigned long TableVersion = 0;
  hachure::NoiseSpot Spot;
  vtkMTimeType SpotTime = 0;
  vtkNew<vtkTextureObject> InkSums; // of the layer's ThresholdImage
  vtkMTimeType InkSumsTime = 0;
  vtkNew<vtkTextureObject> Texture;
  std::array<int, 4> Rectangle = { 0, 0, 0, 0 }; // that the texture is of; empty: of nothing
  std::map<int, std::unique_ptr<vtkNoiseBackEnd>> BackEnds;

  // What the kernels of a translucent surface depend on.
  struct ForwardState
  {
    glm::dmat4 ModelToClip{ 0.0 };
    std::array<int, 4> Viewport;
    std::array<int, 4> Rectangle;
    double Period;
    unsigned long SurfaceVersion;
    const vtkPatternNoiseHistory* History;
    vtkMTimeType LayerTime;
    unsigned long Frame; // where they follow the tones of a frame
    bool operator==(const ForwardState& other) const;
  };
  bool Forward = false;        // such a surface is drawn now
  bool ForwardObjects = false; // and its blocks are told apart
  vtkNoiseKernelBuffers ForwardKernels;
  ForwardState ForwardDrawn{};
  std::string ForwardProblem;
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseLayerPainter.h

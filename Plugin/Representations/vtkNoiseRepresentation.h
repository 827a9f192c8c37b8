// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNoiseRepresentation
 * @brief ParaView's surface representation, drawn with a style of noise
 *
 * It draws as vtkPatternRepresentation does and has its properties; the style that it starts with
 * is made of noise, and further properties replace what a vtkNoiseLayer has, in all of them. They
 * start neutral as well, so that a new representation shows its style exactly. No setter executes
 * the pipeline of the surface.
 *
 * @sa vtkNoiseLayer
 */
#ifndef vtkNoiseRepresentation_h
#define vtkNoiseRepresentation_h

#include "vtkNoiseLayer.h" // For the ranges of the setters
#include "vtkPatternRepresentation.h"

class HACHUREREPRESENTATIONS_EXPORT vtkNoiseRepresentation : public vtkPatternRepresentation
{
public:
  static vtkNoiseRepresentation* New();
  vtkTypeMacro(vtkNoiseRepresentation, vtkPatternRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Kind of the noise: AS_IN_STYLE, or vtkNoiseLayer's GABOR (0), PHASOR (1) or SPOT (2). Default
   * AS_IN_STYLE. */
  void SetNoiseKind(int choice) { this->Choose(this->NoiseKind, choice, vtkNoiseLayer::SPOT); }
  vtkGetMacro(NoiseKind, int);
  ///@}

  ///@{
  /** Picture file of the spot for noise of the kind SPOT; every process reads it. Default empty:
   * layers then keep their spots, as they do after the error of a file that cannot be read. */
  void SetNoiseSpotImage(const char* fileName);
  const char* GetNoiseSpotImage();
  ///@}

  ///@{
  /** Added to the spread of directions, in degrees: 90 makes marks run in all directions, -90 in
   * one. Range -90 to 90, default 0. */
  void SetNoiseSpread(double difference)
  {
    this->Change(this->NoiseSpread, std::clamp(difference, -90.0, 90.0));
  }
  vtkGetMacro(NoiseSpread, double);
  ///@}

  ///@{
  /** Factor on the regularity of the marks. Range 0.01 to 100, default 1. */
  void SetNoiseRegularity(double factor)
  {
    this->Change(this->NoiseRegularity, std::clamp(factor, 0.01, 100.0));
  }
  vtkGetMacro(NoiseRegularity, double);
  ///@}

  ///@{
  /** Added to the smoothness of the marks: 1 makes any of them a smooth grey, -1 sharp. Range -1 to
   * 1, default 0. */
  void SetNoiseSmoothness(double difference)
  {
    this->Change(this->NoiseSmoothness, std::clamp(difference, -1.0, 1.0));
  }
  vtkGetMacro(NoiseSmoothness, double);
  ///@}

  ///@{
  /** Mean number of kernels that overlap in a pixel: 0 as in the style, else up to 256; the layer
   * takes what is below 4 as 4. Default 0. */
  void SetNoiseOverlap(double kernels)
  {
    this->Change(this->NoiseOverlap, std::clamp(kernels, 0.0, 256.0));
  }
  vtkGetMacro(NoiseOverlap, double);
  ///@}

  ///@{
  /** Octaves of density over which a kernel fades in: 0 as in the style, else up to 4; the layer
   * takes what is below 0.1 as 0.1. Default 0. */
  void SetNoiseFade(double octaves)
  {
    this->Change(this->NoiseFade, std::clamp(octaves, 0.0, 4.0));
  }
  vtkGetMacro(NoiseFade, double);
  ///@}

  ///@{
  /** Changes of a surface's cells that a mark lives for, -1 (default) to 1000. -1: as in the style;
   * 0: every surface has marks of its own at once. */
  void SetNoiseLife(int changes) { this->Change(this->NoiseLife, std::clamp(changes, -1, 1000)); }
  vtkGetMacro(NoiseLife, int);
  ///@}

  ///@{
  /** Point or cell array of the strokes' direction, see vtkNoiseLayer::SetDirectionArrayName();
   * "None", the default, leaves it to the style. */
  void SetNoiseDirectionArray(const char* name);
  const char* GetNoiseDirectionArray();
  ///@}

  ///@{
  /** What changes the marks from place to place: AS_IN_STYLE, or vtkNoiseLayer's NO_CONTROL (0),
   * TONE (1) or ARRAY (2, NoiseControlArray). Default AS_IN_STYLE. */
  void SetNoiseControl(int choice)
  {
    this->Choose(this->NoiseControl, choice, vtkNoiseLayer::ARRAY);
  }
  vtkGetMacro(NoiseControl, int);
  ///@}

  ///@{
  /** Array for the control ARRAY, as vtkAlgorithm names arrays; only the name counts: a point or
   * else cell array of one component. Default: none, which changes nothing. */
  void SetNoiseControlArray(int index, int port, int connection, int association, const char* name);
  const char* GetNoiseControlArrayName();
  ///@}

  ///@{
  /** Values of that array that count as lowest and as highest. Default (0, 1). */
  void SetNoiseControlRange(double lowest, double highest)
  {
    this->ChangePair(this->NoiseControlRange, lowest, highest);
  }
  vtkGetVector2Macro(NoiseControlRange, double);
  ///@}

  ///@{
  /** Where NoiseControl is not AS_IN_STYLE: factors on the size, and on the regularity, of the
   * marks where the control is lowest and where it is highest. Range 0.25 to 4, defaults (0.5, 2)
   * and (1, 1). */
  void SetNoiseSizeFactors(double lowest, double highest)
  {
    this->ChangePair(
      this->NoiseSizeFactors, std::clamp(lowest, 0.25, 4.0), std::clamp(highest, 0.25, 4.0));
  }
  vtkGetVector2Macro(NoiseSizeFactors, double);
  void SetNoiseRegularityFactors(double lowest, double highest)
  {
    this->ChangePair(
      this->NoiseRegularityFactors, std::clamp(lowest, 0.25, 4.0), std::clamp(highest, 0.25, 4.0));
  }
  vtkGetVector2Macro(NoiseRegularityFactors, double);
  ///@}

  ///@{
  /** Where the kernels' points come from: AS_IN_STYLE, or vtkNoiseLayer's EVEN (0) or CLASSIC (1).
   * Default AS_IN_STYLE. */
  void SetNoiseDistribution(int choice)
  {
    this->Choose(this->NoiseDistribution, choice, vtkNoiseLayer::CLASSIC);
  }
  vtkGetMacro(NoiseDistribution, int);
  ///@}

  ///@{
  /** What trims a kernel, see vtkNoiseLayer::SetObjectTest(): AS_IN_STYLE, 0 (no) or 1 (yes) each.
   * Default AS_IN_STYLE. */
  void SetNoiseObjectTest(int choice) { this->Choose(this->NoiseObjectTest, choice, 1); }
  vtkGetMacro(NoiseObjectTest, int);
  void SetNoiseTriangleTest(int choice) { this->Choose(this->NoiseTriangleTest, choice, 1); }
  vtkGetMacro(NoiseTriangleTest, int);
  void SetNoiseDepthTest(int choice) { this->Choose(this->NoiseDepthTest, choice, 1); }
  vtkGetMacro(NoiseDepthTest, int);
  void SetNoisePartialVisibility(int choice)
  {
    this->Choose(this->NoisePartialVisibility, choice, 1);
  }
  vtkGetMacro(NoisePartialVisibility, int);
  ///@}

protected:
  vtkNoiseRepresentation();
  ~vtkNoiseRepresentation() override;

  void AdjustStyle(vtkPatternStyle* style) override;

private:
  vtkNoiseRepresentation(const vtkNoiseRepresentation&) = delete;
  void operator=(const vtkNoiseRepresentation&) = delete;

  void AdjustKind(vtkNoiseLayer* layer, vtkImageData* spot);
  void AdjustNumbers(vtkNoiseLayer* layer);
  void AdjustControl(vtkNoiseLayer* layer);
  void AdjustKernels(vtkNoiseLayer* layer);
  vtkSmartPointer<vtkImageData> ReadSpot();

  int NoiseKind = AS_IN_STYLE;
  std::string NoiseSpotImage;
  vtkSmartPointer<vtkImageData> Spot;
  std::unique_ptr<RepresentationFile> SpotFile;
  double NoiseSpread = 0.0;
  double NoiseRegularity = 1.0;
  double NoiseSmoothness = 0.0;
  double NoiseOverlap = 0.0;
  double NoiseFade = 0.0;
  int NoiseLife = -1;

  std::string NoiseDirectionArray = "None";
  int NoiseControl = AS_IN_STYLE;
  std::string NoiseControlArrayName;
  double NoiseControlRange[2] = { 0.0, 1.0 };
  double NoiseSizeFactors[2] = { 0.5, 2.0 };
  double NoiseRegularityFactors[2] = { 1.0, 1.0 };

  int NoiseDistribution = AS_IN_STYLE;
  int NoiseObjectTest = AS_IN_STYLE;
  int NoiseTriangleTest = AS_IN_STYLE;
  int NoiseDepthTest = AS_IN_STYLE;
  int NoisePartialVisibility = AS_IN_STYLE;
};

#endif

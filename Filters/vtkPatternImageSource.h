// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatternImageSource
 * @brief   tileable images of hatching, dots, brush strokes, paper or a picture, ready to be inked
 *
 * The output says at which tone every texel takes ink: where its scalars are below the tone. Their
 * values are uniformly distributed in [0, 1], so that the share of inked texels is the tone. It
 * repeats without a seam, its lower left texel comes first, and it is a function of the properties
 * alone, whatever the number of threads.
 *
 * The output has as point data
 * - Screen (float, the scalars): the tone at which the texel takes ink;
 * - Gradient (float): the change of Screen from one texel to the next, for anti-aliasing; see
 *   hachure::PatternTile for its value at ridges and in flat areas;
 * with PAINT also
 * - DabOffset (float, 2 components): from the texel to the centre of the dab on top of it, in tile
 *   widths; the dab takes its colour there;
 * - DabAlpha (float): opacity of that dab at the texel, 0 to 1;
 * - DabIndex (int): the number of that dab;
 * - LowerDabOffset, LowerDabAlpha, LowerDabIndex: the same for the dab below it, for blending;
 * - PaintHeight (float): thickness of the paint for lighting, 0 to 1;
 * and as field data
 * - Periods (int): pattern periods across the width;
 * - Levels (int): distinct values before they were made uniform.
 */

#ifndef vtkPatternImageSource_h
#define vtkPatternImageSource_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

class HACHUREFILTERS_EXPORT vtkPatternImageSource : public vtkImageAlgorithm
{
public:
  static vtkPatternImageSource* New();
  vtkTypeMacro(vtkPatternImageSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PatternType
  {
    HATCH = 0,
    CROSS_HATCH = 1,
    HALFTONE = 2,
    IMAGE = 3,
    STIPPLE = 4,
    PAINT = 5,
    PAPER = 6
  };

  ///@{
  /**
   * What to draw: strokes along +x; strokes in two directions; clustered dots; the picture at the
   * optional input; dots of one size placed one by one; overlapping dabs of paint; or paper, whose
   * Screen is its height from the lowest to the highest points. Of a picture the point scalars
   * count, dark being inked first: one component is grey, two are grey and opacity, three or four
   * are red, green, blue (and opacity), of which the luma is taken; opacity is ignored. Default
   * HATCH.
   */
  vtkSetClampMacro(Pattern, int, HATCH, PAPER);
  vtkGetMacro(Pattern, int);
  void SetPatternToHatch() { this->SetPattern(HATCH); }
  void SetPatternToCrossHatch() { this->SetPattern(CROSS_HATCH); }
  void SetPatternToHalftone() { this->SetPattern(HALFTONE); }
  void SetPatternToImage() { this->SetPattern(IMAGE); }
  void SetPatternToStipple() { this->SetPattern(STIPPLE); }
  void SetPatternToPaint() { this->SetPattern(PAINT); }
  void SetPatternToPaper() { this->SetPattern(PAPER); }
  ///@}

  ///@{
  /**
   * Width and height in texels. Range 8 to 4096, default 256. A picture keeps its own size.
   */
  vtkSetClampMacro(Size, int, 8, 4096);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /**
   * Lines, dots, dabs or grains of paper across the width. Range 1 to 1024, default 8; more than
   * Size / 4, or more than 256 of STIPPLE, PAINT and PAPER, is an error. More periods, with a
   * larger size, repeat less visibly. For a picture only a note: how many periods it shows.
   */
  vtkSetClampMacro(Periods, int, 1, 1024);
  vtkGetMacro(Periods, int);
  ///@}

  ///@{
  /**
   * From 0, ruled, to 1, drawn by a loose hand: finite strokes that taper, waver and press
   * unevenly, dots of uneven place and size. Of HATCH, CROSS_HATCH, HALFTONE and STIPPLE. Default
   * 0.
   */
  vtkSetClampMacro(Irregularity, double, 0.0, 1.0);
  vtkGetMacro(Irregularity, double);
  ///@}

  ///@{
  /**
   * Seed of all random choices. Any value, default 1.
   */
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  ///@{
  /**
   * Angle from the first to the second direction of CROSS_HATCH in degrees, counter-clockwise. The
   * nearest one that closes on the tile is taken. Range 5 to 175, default 90.
   */
  vtkSetClampMacro(CrossingAngle, double, 5.0, 175.0);
  vtkGetMacro(CrossingAngle, double);
  ///@}

  ///@{
  /**
   * Tone at which the second direction of CROSS_HATCH sets in. Range 0 to 0.95, default 0.3.
   */
  vtkSetClampMacro(CrossingDelay, double, 0.0, 0.95);
  vtkGetMacro(CrossingDelay, double);
  ///@}

  ///@{
  /**
   * Densities of strokes of HATCH and CROSS_HATCH, as of tonal art maps (Praun et al. 2001). With 1
   * the strokes grow wider with the tone. With more they keep nearly one width: Periods sparse
   * lines come first, as many between them next, then twice as many, each at about twice the tone
   * of the one before; only the darkest tones widen them. Range 1 to 4, default 1; Periods times
   * 2^(Densities - 1) above Size / 4 is an error.
   */
  vtkSetClampMacro(Densities, int, 1, 4);
  vtkGetMacro(Densities, int);
  ///@}

  ///@{
  /**
   * Mean number of dabs of PAINT over a point; there are Periods x Periods dabs, which grow with
   * it. Up to about 2 some ground shows. Range 0.5 to 8, default 3.
   */
  vtkSetClampMacro(DabDensity, double, 0.5, 8.0);
  vtkGetMacro(DabDensity, double);
  ///@}

  ///@{
  /**
   * Length of a dab over its width. Range 1 to 8, default 2.6.
   */
  vtkSetClampMacro(DabAspect, double, 1.0, 8.0);
  vtkGetMacro(DabAspect, double);
  ///@}

  ///@{
  /**
   * Standard deviation of the dabs' directions from +x in degrees. Range 0 to 180, default 18.
   */
  vtkSetClampMacro(DabAngleJitter, double, 0.0, 180.0);
  vtkGetMacro(DabAngleJitter, double);
  ///@}

  ///@{
  /**
   * Largest relative deviation of a dab's size. Range 0 to 0.8, default 0.3.
   */
  vtkSetClampMacro(DabSizeVariation, double, 0.0, 0.8);
  vtkGetMacro(DabSizeVariation, double);
  ///@}

  ///@{
  /**
   * From 0, a soft brush, to 1, stiff bristles: streaks, and a ragged end that runs dry. Default
   * 0.6.
   */
  vtkSetClampMacro(Bristles, double, 0.0, 1.0);
  vtkGetMacro(Bristles, double);
  ///@}

  ///@{
  /**
   * Shares of what makes the height of PAPER: rounded grains of one size, fine bent fibres, the
   * ribs and chain lines of a laid mould, and woven threads as of canvas. All of them 0 is an
   * error. Range 0 to 1 each; default 1, 0.5, 0 and 0.
   */
  vtkSetClampMacro(Grain, double, 0.0, 1.0);
  vtkGetMacro(Grain, double);
  vtkSetClampMacro(Fibres, double, 0.0, 1.0);
  vtkGetMacro(Fibres, double);
  vtkSetClampMacro(Laid, double, 0.0, 1.0);
  vtkGetMacro(Laid, double);
  vtkSetClampMacro(Weave, double, 0.0, 1.0);
  vtkGetMacro(Weave, double);
  ///@}

  /**
   * Number of distinct values of the last output before they were made uniform. A picture with
   * fewer than 16 has visible steps of tone: it gives one warning.
   */
  vtkGetMacro(NumberOfLevels, int);

protected:
  vtkPatternImageSource();
  ~vtkPatternImageSource() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Pattern = HATCH;
  int Size = 256;
  int Periods = 8;
  double Irregularity = 0.0;
  unsigned int Seed = 1;
  double CrossingAngle = 90.0;
  double CrossingDelay = 0.3;
  int Densities = 1;
  double DabDensity = 3.0;
  double DabAspect = 2.6;
  double DabAngleJitter = 18.0;
  double DabSizeVariation = 0.3;
  double Bristles = 0.6;
  double Grain = 1.0;
  double Fibres = 0.5;
  double Laid = 0.0;
  double Weave = 0.0;
  int NumberOfLevels = 0;

private:
  // Fills the output; throws std::invalid_argument.
  void Draw(vtkInformationVector** inputVector, vtkImageData* output);
  void DrawPaint(vtkImageData* output);
  void DrawPaper(vtkImageData* output);
  void DrawStrokesOrDots(vtkImageData* output);

  vtkPatternImageSource(const vtkPatternImageSource&) = delete;
  void operator=(const vtkPatternImageSource&) = delete;
};

#endif

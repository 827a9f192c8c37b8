// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkToneCorrectionTable
 * @brief   thresholds that make the ink of a pattern, as drawn, equal the tone
 *
 * The input is a pattern image with the point arrays Screen and Gradient, as vtkPatternImageSource
 * makes it. Drawing it filters it, softens its edges by a pixel and mixes it with its half-size
 * copy while it is scaled; all of this changes how much is inked at a threshold. This filter draws
 * the pattern at many steps of scale, measures the ink and inverts the measurement (Breslav et al.
 * 2007, section 3.5).
 *
 * The output is an image of 256 x 96 floats, 256 x 48 unless screens blend, Threshold: x is the
 * tone, 0 to 1, y the step of scale. With BLEND_SCREENS the scale goes from 1 at the bottom to 2 at
 * the top, more densely between LodStart and LodEnd; otherwise the table is that of one of the two
 * octaves that are drawn, each with its own scale, from 1/2 to 2 by equal factors. Between its
 * points the table is to be interpolated linearly. tableColumn, tableRow and octaveRow in
 * Core/Kernels/PatternField.glsl give the place of a tone and a scale. Its field data repeats
 * TexelsPerPixel, LodStart and LodEnd.
 */

#ifndef vtkToneCorrectionTable_h
#define vtkToneCorrectionTable_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

class HACHUREFILTERS_EXPORT vtkToneCorrectionTable : public vtkImageAlgorithm
{
public:
  static vtkToneCorrectionTable* New();
  vtkTypeMacro(vtkToneCorrectionTable, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Pixels of the drawing per period of the pattern at scale 1. The pattern image says in its field
   * array Periods how many there are across its width; without that array one is assumed, with a
   * warning. Range 0.01 to 100000, default 8.
   */
  vtkSetClampMacro(PeriodInPixels, double, 0.01, 100000.0);
  vtkGetMacro(PeriodInPixels, double);
  ///@}

  ///@{
  /**
   * Scales between which the half-size copy takes over. Range 1 to 2, defaults 1.3 and 1.7. An end
   * before the start is an error.
   */
  vtkSetClampMacro(LodStart, double, 1.0, 2.0);
  vtkGetMacro(LodStart, double);
  vtkSetClampMacro(LodEnd, double, 1.0, 2.0);
  vtkGetMacro(LodEnd, double);
  ///@}

  ///@{
  /**
   * How the half-size copy takes over. NO_TRANSITION: it does not. CROSS_FADE: the inks of both are
   * mixed, so that marks keep their shape. BLEND_SCREENS (the default): their screens are mixed, so
   * that marks change it.
   */
  enum TransitionType
  {
    NO_TRANSITION = 0,
    CROSS_FADE = 1,
    BLEND_SCREENS = 2
  };
  vtkSetClampMacro(Transition, int, NO_TRANSITION, BLEND_SCREENS);
  vtkGetMacro(Transition, int);
  ///@}

  ///@{
  /**
   * How the weight of the half-size copy grows with the scale. EVEN (the default): the picture
   * changes equally much with every part of the growth. CLASSIC: in proportion to the scale. The
   * rows of blended screens go by the weight, so that their scales follow the pace.
   */
  enum PaceType
  {
    EVEN = 0,
    CLASSIC = 1
  };
  vtkSetClampMacro(Pace, int, EVEN, CLASSIC);
  vtkGetMacro(Pace, int);
  ///@}

  ///@{
  /**
   * Which difference between tone and ink is removed. FULL_CORRECTION (the default): all, mean ink
   * is the tone. TRANSITION_ONLY: what changes with the scale; ink stays what the screen itself
   * gives at scale 1. NO_CORRECTION: none, the threshold is the tone.
   */
  enum ToneCorrectionType
  {
    FULL_CORRECTION = 0,
    TRANSITION_ONLY = 1,
    NO_CORRECTION = 2
  };
  vtkSetClampMacro(ToneCorrection, int, FULL_CORRECTION, NO_CORRECTION);
  vtkGetMacro(ToneCorrection, int);
  ///@}

protected:
  vtkToneCorrectionTable() = default;
  ~vtkToneCorrectionTable() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double PeriodInPixels = 8.0;
  double LodStart = 1.3;
  double LodEnd = 1.7;
  int Transition = BLEND_SCREENS;
  int Pace = EVEN;
  int ToneCorrection = FULL_CORRECTION;

private:
  vtkToneCorrectionTable(const vtkToneCorrectionTable&) = delete;
  void operator=(const vtkToneCorrectionTable&) = delete;
};

#endif

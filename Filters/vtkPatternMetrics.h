// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatternMetrics
 * @brief   numbers for the quality of moving patterns and of stipples
 *
 * Measures how a pattern moves against the surface that it is drawn on, whether it stays the same
 * pattern, whether it looks flat, and whether there is as much ink as there should be; and for
 * points in the plane how evenly they are spread. Metrics whose inputs are missing are left out.
 *
 * Inputs, as data (AddFrame and so on) or connections:
 * - port 0, frames: images of one component, the linear ink of every frame, 0 = paper, 1 = full
 * ink.
 * - port 1, motions: for every step from a frame to the next an image with the components u and v
 *   (pixels, to the right and up), visible (1 where the point is seen in both frames), and, if
 * there are so many, facing (n.v) and distance from the eye (scene units); as vtkPatternMotion
 * makes them. A last one for the last frame may follow, whose u and v are not read.
 * - port 2, stipples: polydata whose points lie in a plane; z is not read. Several sets are either
 *   samples of one kind, over which metrics are averaged, or steps of a sequence, for Nesting.
 * - port 3, cells: for every frame an image of one component, the cell of the object seen at each
 *   pixel, the same number in all frames; 0 and below: none.
 * - port 4, tones: the tone that was wanted, one image for each frame or one for all of them;
 *   negative or NaN where nothing is drawn. With tones but no motions only tones are measured.
 * - port 5, reference: an image of one component, the pattern as drawn flat on paper in the tone
 *   and size that the frames should have, at least three wavelengths and a border wide and high;
 * for Contrast and CooccurrenceError.
 *
 * Output 0 has a row for each metric, with the columns Metric and Value. NaN: not defined, such as
 * the SlideRatio of a still scene.
 * - SlideRatio: mean slide of the pattern against the surface / mean motion. 0 = on the surface,
 *   1 = fixed in the image (shower door). NormalSlideRatio: across the strokes alone, for hatching.
 * - Coherence: mean correlation of a frame with the next, moved back. MeanSlide, MeanMotion and
 *   LargestMotion (of a block): pixels per frame.
 * - BoilMedian, BoilLargest: over steps, 1 - correlation after the best slide. Pop: largest boil /
 *   median boil, which counts as at least .001.
 * - Contrast: mean deviation of the ink / that of the reference, or of the first frame without one.
 * - ToneFlicker: deviation over time of the mean ink of a cell, mean over cells.
 * - FacingSlope (beta), DistanceSlope (gamma): how the logarithm of the frequency of the pattern
 *   grows with that of 1/(n.v) and of the distance; 0 = flat. See FlatnessWindow.
 * - CooccurrenceError: how far what is seen is from the reference as a texture, 0 = the same, also
 *   where it is shifted or turned, 1 = nothing in common: the mean distance between grey-level
 *   co-occurrence matrices (Haralick 1973) up to one wavelength. For frames of even tone.
 * - ToneError: largest difference of ink and tone over windows of deviation 1.5 wavelengths.
 *   ToneDrop: how much ink falls where tone grows, at most; 0 = monotone.
 * - ClarkEvans (R), RelativeRadius (rho), LowFrequencyPower (LF), MeanPower, AnisotropyDecibels:
 *   see Core/PatternMetricsStipples.h. Nesting: points that a set shares with the next, by exact
 *   position, / the size of the smaller one; the least of all.
 *
 * Output 1 has a row for each frame with a motion: Frame, Coherence, Boil, Slide, Motion,
 * NormalSlide, NormalMotion, Blocks, Contrast, Frequency (periods per pixel), CooccurrenceError.
 * Output 2 has the spectrum of the stipples: Frequency (in units of the root of the density), Power
 * (1 = white noise), AnisotropyDecibels, Count.
 *
 * Definitions: Core/PatternMetricsMotion.h and its neighbours.
 *
 * @sa vtkPatternMotion
 */

#ifndef vtkPatternMetrics_h
#define vtkPatternMetrics_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

class vtkImageData;
class vtkPolyData;

class HACHUREFILTERS_EXPORT vtkPatternMetrics : public vtkTableAlgorithm
{
public:
  static vtkPatternMetrics* New();
  vtkTypeMacro(vtkPatternMetrics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Port
  {
    FRAMES = 0,
    MOTIONS = 1,
    STIPPLES = 2,
    CELLS = 3,
    TONES = 4,
    REFERENCE = 5
  };

  ///@{
  /**
   * Append to an input, in the order of time.
   */
  void AddFrame(vtkImageData* ink);
  void AddMotion(vtkImageData* motion);
  void AddStipples(vtkPolyData* points);
  void AddCells(vtkImageData* cells);
  void AddTone(vtkImageData* tone);
  ///@}
  /** The pattern as drawn flat on paper; null: none. */
  void SetReference(vtkImageData* ink);
  /** Forgets all inputs, to measure another clip. */
  void RemoveAllInputs();

  ///@{
  /**
   * Wavelength of the pattern in pixels: the distance of its strokes or dots. Blocks are two of
   * them wide, slides are looked for below half of one. Range 3 to 1000, default 8.
   */
  vtkSetClampMacro(Wavelength, double, 3.0, 1000.0);
  vtkGetMacro(Wavelength, double);
  ///@}

  ///@{
  /**
   * Surface with a smaller n.v is left out. Range 0.01 to 1, default 0.3.
   */
  vtkSetClampMacro(MinimumFacing, double, 0.01, 1.0);
  vtkGetMacro(MinimumFacing, double);
  ///@}

  ///@{
  /**
   * Deviation in pixels of the Gaussian before any correlation; hard ink that is compared between
   * pixels has a boil of its own without it. Range 0 to 10, default 1.
   */
  vtkSetClampMacro(Smoothing, double, 0.0, 10.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /**
   * Side in pixels of the windows for FacingSlope and DistanceSlope. Fast with factors of 2, 3 and
   * 5. Range 16 to 1024, default 64.
   */
  vtkSetClampMacro(FlatnessWindow, int, 16, 1024);
  vtkGetMacro(FlatnessWindow, int);
  ///@}

  ///@{
  /**
   * Cells that cover fewer pixels in a frame do not count there. Range from 1, default 16.
   */
  vtkSetClampMacro(MinimumCellPixels, int, 1, VTK_INT_MAX);
  vtkGetMacro(MinimumCellPixels, int);
  ///@}

  ///@{
  /**
   * The rectangle in which stipples were placed, as xMin, xMax, yMin, yMax. Empty (xMin > xMax):
   * the bounds of all sets, which are a little too small. Default empty.
   */
  vtkSetVector4Macro(StippleWindow, double);
  vtkGetVector4Macro(StippleWindow, double);
  ///@}

  ///@{
  /**
   * Whether the window repeats, so that stipples at one edge have neighbours at the other;
   * otherwise ClarkEvans is corrected for the edge. Default off.
   */
  vtkSetMacro(PeriodicStipples, bool);
  vtkGetMacro(PeriodicStipples, bool);
  vtkBooleanMacro(PeriodicStipples, bool);
  ///@}

protected:
  vtkPatternMetrics();
  ~vtkPatternMetrics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Wavelength = 8.0;
  double MinimumFacing = 0.3;
  double Smoothing = 1.0;
  int FlatnessWindow = 64;
  int MinimumCellPixels = 16;
  double StippleWindow[4] = { 1.0, -1.0, 1.0, -1.0 };
  bool PeriodicStipples = false;

private:
  vtkPatternMetrics(const vtkPatternMetrics&) = delete;
  void operator=(const vtkPatternMetrics&) = delete;
};

#endif

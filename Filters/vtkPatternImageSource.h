// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatternImageSource
 * @brief   tileable images of hatching, halftone dots or a picture, ready to be inked
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
    IMAGE = 3
  };

  ///@{
  /**
   * What to draw: strokes along +x, strokes in two directions, clustered dots, or the picture at
   * the optional input. Of a picture the point scalars count, dark being inked first: one component
   * is grey, two are grey and opacity, three or four are red, green, blue (and opacity), of which
   * the luma is taken; opacity is ignored. Default HATCH.
   */
  vtkSetClampMacro(Pattern, int, HATCH, IMAGE);
  vtkGetMacro(Pattern, int);
  void SetPatternToHatch() { this->SetPattern(HATCH); }
  void SetPatternToCrossHatch() { this->SetPattern(CROSS_HATCH); }
  void SetPatternToHalftone() { this->SetPattern(HALFTONE); }
  void SetPatternToImage() { this->SetPattern(IMAGE); }
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
   * Lines or dots across the width. Range 1 to 1024, default 8; more than Size / 4 is an error.
   * More periods, with a larger size, repeat less visibly. For a picture only a note: how many
   * periods it shows.
   */
  vtkSetClampMacro(Periods, int, 1, 1024);
  vtkGetMacro(Periods, int);
  ///@}

  ///@{
  /**
   * From 0, ruled, to 1, drawn by a loose hand: finite strokes that taper, waver and press
   * unevenly, dots of uneven place and size. Default 0.
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
  int NumberOfLevels = 0;

private:
  vtkPatternImageSource(const vtkPatternImageSource&) = delete;
  void operator=(const vtkPatternImageSource&) = delete;
};

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkImagePatternLayer
 * @brief a layer whose field is a tileable image: hatching, a halftone screen, any picture
 *
 * The image lies in the image plane and follows the surface patch by patch with a similarity of
 * the plane (Breslav et al. 2007), or stays fixed in the image, or it lies on the surface itself,
 * as a texture or as a dynamic solid texture (Benard, Bousseau, Thollot 2009). While the
 * similarity's scale s, wrapped into [1,2), goes from LodStart to LodEnd, the image at half the
 * size takes over, so that the size of the marks stays near Size at every zoom. Thresholds measured
 * on the pattern as it is drawn keep the tone meanwhile.
 */

#ifndef vtkImagePatternLayer_h
#define vtkImagePatternLayer_h

#include "vtkImageData.h" // For the user's image
#include "vtkPatternLayer.h"

#include <string>

class HACHURERENDERING_EXPORT vtkImagePatternLayer : public vtkPatternLayer
{
public:
  static vtkImagePatternLayer* New();
  vtkTypeMacro(vtkImagePatternLayer, vtkPatternLayer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * HATCH: parallel strokes. CROSS_HATCH: a second, perpendicular set comes in with darker tones.
   * HALFTONE: a square grid of growing dots. IMAGE: the picture given by Image. STIPPLE: dots of
   * one size, the more the darker, evenly spread. PAINT: overlapping dabs of a brush; with
   * ColorSource SURFACE every dab has the colour of the surface at its middle. PAPER: the grain of
   * rough paper, its valleys first.
   */
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

  /**
   * SIMILARITY: the pattern follows the surface. FIXED_IN_IMAGE: it stays where it is.
   *
   * TEXTURE: it lies on the surface by the active texture coordinates of the points, elsewhere
   * projected along the three axes of the model and mixed near their diagonals. DYNAMIC_SOLID: it
   * is projected in the same way, and doubles or halves with the distance, octave by octave
   * between LodStart and LodEnd, so that the marks stay near Size.
   *
   * With the last two, the ink of an even tone is exact for ruled lines at any tilt, and for other
   * patterns where the surface faces the viewer; under 2 pixels per period it is an even grey.
   */
  enum MotionType
  {
    SIMILARITY = 0,
    FIXED_IN_IMAGE = 1,
    TEXTURE = 2,
    DYNAMIC_SOLID = 3
  };

  /**
   * How the image at half the size takes over. CROSS_FADE: by ink, the old strokes fade out and the
   * new ones in. BLEND_SCREENS: by screen, the marks change their shape. AUTOMATIC_TRANSITION:
   * screens (HALFTONE, STIPPLE, PAPER) blend; strokes (HATCH, CROSS_HATCH, PAINT) and an IMAGE
   * cross-fade: a drawing blended with its own copy would have shapes that it never had.
   */
  enum TransitionType
  {
    AUTOMATIC_TRANSITION = 0,
    CROSS_FADE = 1,
    BLEND_SCREENS = 2
  };

  /**
   * How fast it takes over while the scale s goes from s0 = LodStart to s1 = LodEnd; t is its
   * weight. EVEN: the picture changes equally much with every part of the growth,
   * t = sin(a) / (sin(a) + c cos(a)) with a = x pi / 2, x = log(s / s0) / log(s1 / s0).
   * Uncorrelated pictures, mixed by 1 - t and t, turn by the angle a from the one to the other,
   * where c is the contrast of the second over that of the first: 1 for blended screens; for inks,
   * of which the finer ones look paler, it is measured half way. CLASSIC: t = (s - s0) / (s1 - s0)
   * (Breslav et al. 2007, section 3.4), which changes the picture twice as fast half way as at the
   * ends.
   */
  enum PaceType
  {
    EVEN = 0,
    CLASSIC = 1
  };

  /**
   * FULL_CORRECTION: the mean ink is the tone. TRANSITION_ONLY: it stays what the screen itself
   * gives at scale 1, where filtered edges make light tones darker and dark tones lighter; without
   * a transition (FIXED_IN_IMAGE, TEXTURE) nothing is corrected. NO_CORRECTION: it changes with
   * the scale as well.
   */
  enum ToneCorrectionType
  {
    FULL_CORRECTION = 0,
    TRANSITION_ONLY = 1,
    NO_CORRECTION = 2
  };

  const char* GetTypeName() override { return "image"; }

  ///@{
  /** Pattern of the field, one of PatternType; default HATCH. */
  vtkSetClampMacro(Pattern, int, HATCH, PAPER);
  vtkGetMacro(Pattern, int);
  ///@}

  ///@{
  /** Picture for the pattern IMAGE, repeated in both directions; dark is inked first. One slice
   * with scalars; default null, which is an error when drawn. Setting another one clears
   * ImageFileName. */
  virtual void SetImage(vtkImageData* image);
  virtual vtkImageData* GetImage();
  ///@}

  /**
   * Reads Image from any picture file that vtkImageReader2Factory knows and remembers its name.
   * Returns false, after an error that says why, and changes nothing when that fails.
   */
  virtual bool ReadImage(const std::string& fileName);

  ///@{
  /** File that style files name as the source of Image. ReadImage sets it; set it by hand after
   * SetImage when the picture has been saved. Default empty. */
  virtual void SetImageFileName(const char* fileName);
  virtual const char* GetImageFileName();
  ///@}

  ///@{
  /** Period of the pattern, or the width of the tile for IMAGE, in SizeUnit. Range 0.01 to 10000,
   * default 8. Under two pixels per period the ink is an even grey. */
  vtkSetClampMacro(Size, double, 0.01, 10000.0);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /** Unit of Size, PIXELS or MILLIMETRES; default PIXELS. */
  vtkSetClampMacro(SizeUnit, int, PIXELS, MILLIMETRES);
  vtkGetMacro(SizeUnit, int);
  ///@}

  ///@{
  /** Direction of the strokes, of the screen's rows or of the picture's x axis: degrees
   * counter-clockwise from +x with y up. Range -360 to 360, default 45. */
  vtkSetClampMacro(Angle, double, -360.0, 360.0);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /** How far the marks wander from a ruled pattern, 0 (ruled) to 1 (sketched); default 0. No
   * effect on IMAGE, STIPPLE, PAINT and PAPER. */
  vtkSetClampMacro(Irregularity, double, 0.0, 1.0);
  vtkGetMacro(Irregularity, double);
  ///@}

  ///@{
  /** Densities of strokes of HATCH and CROSS_HATCH. With 1, the default, strokes grow wider with
   * the tone; with more they keep their width, and the number of them doubles from density to
   * density, until the distance of the densest ones is Size. Range 1 to 4. */
  vtkSetClampMacro(Densities, int, 1, 4);
  vtkGetMacro(Densities, int);
  ///@}

  ///@{
  /** Shape of the dabs of PAINT. DabLength: over their width, 1 to 8, default 2.6. DabJitter:
   * standard deviation of their direction in degrees, 0 to 180, default 18. DabDensity: dabs over
   * a point, 0.5 to 8, default 3. Bristles: 0, a soft brush, to 1, stiff bristles, default 0.6. */
  vtkSetClampMacro(DabLength, double, 1.0, 8.0);
  vtkGetMacro(DabLength, double);
  vtkSetClampMacro(DabJitter, double, 0.0, 180.0);
  vtkGetMacro(DabJitter, double);
  vtkSetClampMacro(DabDensity, double, 0.5, 8.0);
  vtkGetMacro(DabDensity, double);
  vtkSetClampMacro(Bristles, double, 0.0, 1.0);
  vtkGetMacro(Bristles, double);
  ///@}

  ///@{
  /** Look of the paint of PAINT. Bump: relief of the paint in light from the upper left, 0 (flat,
   * the default) to 1. ColorVariation: largest relative difference in brightness between dabs, 0 to
   * 1, default 0. */
  vtkSetClampMacro(Bump, double, 0.0, 1.0);
  vtkGetMacro(Bump, double);
  vtkSetClampMacro(ColorVariation, double, 0.0, 1.0);
  vtkGetMacro(ColorVariation, double);
  ///@}

  ///@{
  /** Texture of the paper below the marks, which moves with them: PaperContrast is the part that
   * the grain has in deciding where ink goes first, 0 (smooth, the default) to 1 (the grain
   * alone); the tone stays exact. PaperSize is the size of a grain in PaperSizeUnit, 0.01 to
   * 10000, default 4 pixels. No effect with TEXTURE and DYNAMIC_SOLID. */
  vtkSetClampMacro(PaperContrast, double, 0.0, 1.0);
  vtkGetMacro(PaperContrast, double);
  vtkSetClampMacro(PaperSize, double, 0.01, 10000.0);
  vtkGetMacro(PaperSize, double);
  vtkSetClampMacro(PaperSizeUnit, int, PIXELS, MILLIMETRES);
  vtkGetMacro(PaperSizeUnit, int);
  ///@}

  ///@{
  /** How the pattern moves, one of MotionType; default SIMILARITY. */
  vtkSetClampMacro(Motion, int, SIMILARITY, DYNAMIC_SOLID);
  vtkGetMacro(Motion, int);
  ///@}

  ///@{
  /** Period of the pattern on the surface with TEXTURE and DYNAMIC_SOLID, or the width of the tile
   * for IMAGE: in model units, with texture coordinates in theirs. Not below 0; default 0: the
   * diagonal of the input's bounds, or 1 in texture coordinates, counts as 512 pixels of Size. Data
   * that changes its bounds needs a period that is set, or the pattern grows with them. */
  vtkSetClampMacro(SurfacePeriod, double, 0.0, 1e30);
  vtkGetMacro(SurfacePeriod, double);
  ///@}

  ///@{
  /** Scales at which the pattern of half the size begins to show and has taken over. Range 1 to
   * 2; defaults 1.3 and 1.7. When LodEnd is not above LodStart it takes over at once at
   * LodStart. */
  vtkSetClampMacro(LodStart, double, 1.0, 2.0);
  vtkGetMacro(LodStart, double);
  vtkSetClampMacro(LodEnd, double, 1.0, 2.0);
  vtkGetMacro(LodEnd, double);
  ///@}

  ///@{
  /**
   * Power to which the weights of patches are raised where they blend (Breslav et al. 2007, section
   * 3.6). Range 0.1 to 1. 1 (the default): ink equals the tone across borders. Below it there is
   * more ink near borders; the paper often uses 0.5, as its halftones lose ink there. Screens are
   * then mixed as inks.
   */
  vtkSetClampMacro(PatchPower, double, 0.1, 1.0);
  vtkGetMacro(PatchPower, double);
  ///@}

  ///@{
  /** How the pattern of half the size takes over, one of TransitionType; default
   * AUTOMATIC_TRANSITION. No effect where Motion is FIXED_IN_IMAGE or TEXTURE. */
  vtkSetClampMacro(Transition, int, AUTOMATIC_TRANSITION, BLEND_SCREENS);
  vtkGetMacro(Transition, int);
  ///@}

  ///@{
  /** Pace at which the pattern of half the size takes over, one of PaceType; default EVEN. */
  vtkSetClampMacro(Pace, int, EVEN, CLASSIC);
  vtkGetMacro(Pace, int);
  ///@}

  ///@{
  /**
   * How long the pattern of half the size takes to take over, in units of time of the animation
   * (vtkPatternMapper::SetAnimationTime, or the time of the data where they have one), as a rule
   * seconds. Range 0 to 1000, default 0: by the scale. Above 0 with the motion SIMILARITY, a
   * transition begins when the size drawn, as a factor of Size, leaves [LodStart/2, LodEnd), and
   * runs for this time at the Pace, with growth replaced by time; it turns where the pattern
   * shrinks below LodStart meanwhile, and ends at once where the size drawn would leave [1/2, 2),
   * and where a view changes without a time that goes on. With LodStart 1 and LodEnd 2 there is no
   * room for one. Timed transitions cross-fade, whatever
   * Transition says. The tracking mode ANCHORED remembers nothing: its transitions go by the scale.
   */
  vtkSetClampMacro(TransitionTime, double, 0.0, 1000.0);
  vtkGetMacro(TransitionTime, double);
  ///@}

  ///@{
  /** Which difference between tone and ink is removed (Breslav et al. 2007, section 3.5), one of
   * ToneCorrectionType; default FULL_CORRECTION. */
  vtkSetClampMacro(ToneCorrection, int, FULL_CORRECTION, NO_CORRECTION);
  vtkGetMacro(ToneCorrection, int);
  ///@}

  /** Latest change of the layer, its tone or its image. */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  void DescribeField(hachure::StyleArchive& archive) override;
#endif

protected:
  vtkImagePatternLayer() = default;
  ~vtkImagePatternLayer() override = default;

private:
  vtkImagePatternLayer(const vtkImagePatternLayer&) = delete;
  void operator=(const vtkImagePatternLayer&) = delete;

  int Pattern = HATCH;
  vtkSmartPointer<vtkImageData> Image;
  std::string ImageFileName;
  double Size = 8.0;
  int SizeUnit = PIXELS;
  double Angle = 45.0;
  double Irregularity = 0.0;
  int Densities = 1;
  double DabLength = 2.6;
  double DabJitter = 18.0;
  double DabDensity = 3.0;
  double Bristles = 0.6;
  double Bump = 0.0;
  double ColorVariation = 0.0;
  double PaperContrast = 0.0;
  double PaperSize = 4.0;
  int PaperSizeUnit = PIXELS;
  int Motion = SIMILARITY;
  double SurfacePeriod = 0.0;
  double LodStart = 1.3;
  double LodEnd = 1.7;
  double PatchPower = 1.0;
  int Transition = AUTOMATIC_TRANSITION;
  int Pace = EVEN;
  double TransitionTime = 0.0;
  int ToneCorrection = FULL_CORRECTION;
};

#endif

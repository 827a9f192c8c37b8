// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNoiseLayer
 * @brief a layer whose field is a noise that moves with the surface and looks flat
 *
 * The field is a sum of kernels (Benard et al. 2010, A Dynamic Noise Primitive for Coherent
 * Stylization). Size, shape and direction of the kernels are those of the picture, so that the
 * noise looks drawn on paper; their centres are points of the surface, so that it moves with the
 * surface. While the picture zooms in, more points fade in, and their number in the picture stays.
 * It follows pixels, not triangles.
 *
 * The sum is divided by its expected deviation, and mapped through its distribution to [0,1], so
 * that ink equals the tone, as for every other layer. The noise of a frame depends on surface,
 * camera and parameters alone, not on the frames before, as long as the surface keeps its cells.
 *
 * Where it has other cells than in the last frame (an isosurface whose value changes, a time
 * series) its kernels go to the closest points of the new surface and keep their look. One in Life
 * fades out, over Life / 2 such changes, and points of the new surface fade in, so that the noise
 * does not pop. Cells with global ids that both surfaces have, and equal triangles, keep their
 * points. Parts of a surface that were not near the last one begin with points of their own, and so
 * does all of it in the first frame, where time goes backwards, where the mapper's input comes from
 * elsewhere, after vtkPatternMapper::Reanchor(), and in the mode ANCHORED of vtkPatternStyle. Every
 * renderer remembers for itself; between changes nothing fades.
 *
 * On translucent surfaces every fragment sums up kernels, those on its own plane with DepthTest, so
 * that front and back have their own noise. ObjectTest and TriangleTest trim them there as on
 * opaque ones, but polygons of five corners or more, and those that are bent in, count as one
 * triangle. PartialVisibility changes nothing: all sides are seen. For the control TONE every point
 * has the tone of its own side: before such a surface is drawn, its tones are, layer by layer from
 * the front. Of what lies behind the eighth layer the tone is that of the layer next to it.
 *
 * @sa vtkNoiseKernelPoints vtkImagePatternLayer
 */

#ifndef vtkNoiseLayer_h
#define vtkNoiseLayer_h

#include "vtkImageData.h" // For the user's spot
#include "vtkPatternLayer.h"

#include <string>

class HACHURERENDERING_EXPORT vtkNoiseLayer : public vtkPatternLayer
{
public:
  static vtkNoiseLayer* New();
  vtkTypeMacro(vtkNoiseLayer, vtkPatternLayer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * GABOR: waves under a Gaussian (section 3.1); with a tone, stipples or loose hatches. PHASOR:
   * the phase of the sum of such waves (Tricard et al. 2019, Procedural Phasor Noise): lines of
   * even contrast, as wide as the tone. SPOT: a picture, Image, in place of the wave (van Wijk
   * 1991, Spot Noise).
   */
  enum KindType
  {
    GABOR = 0,
    PHASOR = 1,
    SPOT = 2
  };

  /**
   * EVEN: as many points as the picture needs, whatever the triangles. CLASSIC: points on every
   * triangle, at least one (section 3.3, equations 2 to 4), for comparison: the noise loses
   * contrast where triangles are smaller than pixels, and costs time per triangle.
   */
  enum DistributionType
  {
    EVEN = 0,
    CLASSIC = 1
  };

  /**
   * What changes size and regularity of the marks from place to place. TONE: the layer's own tone,
   * as it is drawn where a kernel's point is. ARRAY: ControlArrayName.
   */
  enum ControlType
  {
    NO_CONTROL = 0,
    TONE = 1,
    ARRAY = 2
  };

  const char* GetTypeName() override { return "noise"; }

  ///@{
  /** Kind of the noise, one of KindType; default GABOR. */
  vtkSetClampMacro(Kind, int, GABOR, SPOT);
  vtkGetMacro(Kind, int);
  ///@}

  ///@{
  /** Mean distance of marks, 1 / F0, in SizeUnit; of SPOT the diameter of the spot, where
   * Regularity is 0.5. Range 0.01 to 10000, default 8. Under two pixels the ink is an even grey. */
  vtkSetClampMacro(Size, double, 0.01, 10000.0);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /** Unit of Size, PIXELS or MILLIMETRES; default PIXELS. */
  vtkSetClampMacro(SizeUnit, int, PIXELS, MILLIMETRES);
  vtkGetMacro(SizeUnit, int);
  ///@}

  ///@{
  /** How regular the marks are: radius of the kernels over Size. It sets the bandwidth
   * a = sqrt(-ln .05 / pi) / radius, where the kernel's envelope has fallen to 5 %. Range 0.25
   * (loose) to 8 (ruled), default 1. */
  vtkSetClampMacro(Regularity, double, 0.25, 8.0);
  vtkGetMacro(Regularity, double);
  ///@}

  ///@{
  /** Direction of the strokes: degrees counter-clockwise from +x with y up, across the wave vector
   * of the kernels. Range -360 to 360, default 45. */
  vtkSetClampMacro(Angle, double, -360.0, 360.0);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /** How far the directions of kernels are spread to both sides of Angle, in degrees. Range 0 (all
   * alike: anisotropic noise, hatches) to 90 (isotropic noise, stipples); default 0. */
  vtkSetClampMacro(Spread, double, 0.0, 90.0);
  vtkGetMacro(Spread, double);
  ///@}

  ///@{
  /** Point or cell array of three numbers that gives the strokes' direction on the surface,
   * whatever its sign and length, as vtkSurfaceDirectionField does; a spread is about it. Where it
   * is 0 the strokes have Angle. Default empty: all have. An error names an array that is missing
   * or has other components; the strokes then have Angle. */
  virtual void SetDirectionArrayName(const char* name);
  virtual const char* GetDirectionArrayName();
  ///@}

  ///@{
  /**
   * What changes the marks from place to place, one of ControlType; default NO_CONTROL.
   * SizeFactors: factors of Size where it is lowest and highest, range 0.25 to 4, default 1 and 1;
   * between them the factor grows evenly in its logarithm. RegularityFactors: the same for
   * Regularity. Where the control has no number, both are 1.
   */
  vtkSetClampMacro(Control, int, NO_CONTROL, ARRAY);
  vtkGetMacro(Control, int);
  virtual void SetSizeFactors(double lowest, double highest);
  vtkGetVector2Macro(SizeFactors, double);
  virtual void SetRegularityFactors(double lowest, double highest);
  vtkGetVector2Macro(RegularityFactors, double);
  ///@}

  ///@{
  /** Point or cell array of one number for the control ARRAY, and its values that count as lowest
   * and highest; default 0 and 1. An error names an array that is missing or has other components,
   * which then changes nothing. */
  virtual void SetControlArrayName(const char* name);
  virtual const char* GetControlArrayName();
  vtkSetVector2Macro(ControlRange, double);
  vtkGetVector2Macro(ControlRange, double);
  ///@}

  ///@{
  /** How softly marks end, as the part of all tones over which a point of the paper goes from bare
   * to full ink. Range 0 (sharp, but for anti-aliasing) to 1 (a smooth grey), default 0. The tone
   * stays exact. */
  vtkSetClampMacro(Smoothness, double, 0.0, 1.0);
  vtkGetMacro(Smoothness, double);
  ///@}

  ///@{
  /**
   * Which ink the noise makes of a tone (the X-toon texture of section 4), in place of thresholds
   * that keep ink equal to the tone: one slice with scalars, black for full ink, white for none,
   * grey evenly between. Columns divide the noise's values, which come equally often, from the
   * left; rows are tones, from 0 at the bottom to 1 at the top. Numbers that are not whole count
   * from 0 (black) to 1. At most 4096 columns and rows. Default null: thresholds. Setting another
   * one clears ThresholdImageFileName.
   */
  virtual void SetThresholdImage(vtkImageData* image);
  virtual vtkImageData* GetThresholdImage();
  ///@}

  /** Reads ThresholdImage, as ReadImage does Image. */
  virtual bool ReadThresholdImage(const std::string& fileName);

  ///@{
  /** File that style files name as the source of ThresholdImage, as ImageFileName. */
  virtual void SetThresholdImageFileName(const char* fileName);
  virtual const char* GetThresholdImageFileName();
  ///@}

  ///@{
  /** Mean number N' of kernels that overlap in a pixel; quality against time. Range 4 to 256,
   * default 32; the paper uses 16 to 128. */
  vtkSetClampMacro(Overlap, double, 4.0, 256.0);
  vtkGetMacro(Overlap, double);
  ///@}

  ///@{
  /** Octaves of density, doublings of the surface's area in the picture, over which a kernel fades
   * in, evenly; range 0.1 to 4, default 1. No effect on CLASSIC. */
  vtkSetClampMacro(Fade, double, 0.1, 4.0);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /** Changes of a surface's cells that a kernel lives for. Short lives tell more of the surface
   * that is there, long ones boil less. Range 0 (every surface has noise of its own at once) to
   * 1000, default 16. No effect on CLASSIC. */
  vtkSetClampMacro(Life, int, 0, 1000);
  vtkGetMacro(Life, int);
  ///@}

  ///@{
  /** Where the kernels' points come from, one of DistributionType; default EVEN. */
  vtkSetClampMacro(Distribution, int, EVEN, CLASSIC);
  vtkGetMacro(Distribution, int);
  ///@}

  ///@{
  /**
   * What trims a kernel (section 3.4). ObjectTest: pixels of other blocks are not drawn to; default
   * on. TriangleTest: nor pixels of other triangles; default off. DepthTest: nor pixels that lie
   * off the kernel's plane, softly; default on. PartialVisibility: a kernel counts by the share of
   * it that is seen, so that it fades where it is hidden, and with less than a tenth it is not
   * drawn; default on. The first two draw the surface once more, where it has several blocks or
   * TriangleTest is on; of a translucent one they take 8 bytes of the graphics card for every
   * triangle instead.
   */
  vtkSetMacro(ObjectTest, bool);
  vtkGetMacro(ObjectTest, bool);
  vtkBooleanMacro(ObjectTest, bool);
  vtkSetMacro(TriangleTest, bool);
  vtkGetMacro(TriangleTest, bool);
  vtkBooleanMacro(TriangleTest, bool);
  vtkSetMacro(DepthTest, bool);
  vtkGetMacro(DepthTest, bool);
  vtkBooleanMacro(DepthTest, bool);
  vtkSetMacro(PartialVisibility, bool);
  vtkGetMacro(PartialVisibility, bool);
  vtkBooleanMacro(PartialVisibility, bool);
  ///@}

  ///@{
  /** Picture of the spot for SPOT: one slice with scalars; what differs from their mean counts.
   * Default null: a fibre, as in paper. Setting another one clears ImageFileName. */
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

  /** Latest change of the layer, its tone or its images. */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  double GetReach(double dotsPerInch) override;
  void DescribeField(hachure::StyleArchive& archive) override;
#endif

protected:
  vtkNoiseLayer() = default;
  ~vtkNoiseLayer() override = default;

private:
  vtkNoiseLayer(const vtkNoiseLayer&) = delete;
  void operator=(const vtkNoiseLayer&) = delete;

  int Kind = GABOR;
  double Size = 8.0;
  int SizeUnit = PIXELS;
  double Regularity = 1.0;
  double Angle = 45.0;
  double Spread = 0.0;
  std::string DirectionArrayName;
  int Control = NO_CONTROL;
  double SizeFactors[2] = { 1.0, 1.0 };
  double RegularityFactors[2] = { 1.0, 1.0 };
  std::string ControlArrayName;
  double ControlRange[2] = { 0.0, 1.0 };
  double Smoothness = 0.0;
  vtkSmartPointer<vtkImageData> ThresholdImage;
  std::string ThresholdImageFileName;
  double Overlap = 32.0;
  double Fade = 1.0;
  int Life = 16;
  int Distribution = EVEN;
  bool ObjectTest = true;
  bool TriangleTest = false;
  bool DepthTest = true;
  bool PartialVisibility = true;
  vtkSmartPointer<vtkImageData> Image;
  std::string ImageFileName;
};

#endif

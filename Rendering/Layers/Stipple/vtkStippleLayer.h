// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkStippleLayer
 * @brief a layer of dots that sit on the surface
 *
 * Stipples (Meruvia Pastor and Strothotte 2002, Frame-Coherent Stippling): round dots of one size,
 * the more of them the darker the tone. Each is tied to a point of the surface and moves with it;
 * on paper it is a flat disc, however the surface is tilted. All stipples have an order, such that
 * the first of them are spread evenly, whatever their number: where the picture zooms in or gets
 * darker, stipples grow in between those that are there, and where it zooms out or gets lighter the
 * last ones shrink away. The picture is a function of surface, camera and parameters alone.
 *
 * A stipple takes the tone at its centre. Ink equals the tone: how many stipples make a tone has
 * been measured, with their growing, their overlap, and how they crowd on tilted surfaces. Stipples
 * whose centre is hidden, or on the side of a closed surface that is turned away, are not drawn.
 *
 * NumberOfPoints are made when the surface is first drawn (some 8 seconds a million; see
 * vtkStippleHierarchy). Where a view comes so near that they do not suffice, more are made of the
 * part that is seen, while Refinement is on, until they take MemoryBudget; then a warning says so,
 * and stipples are larger instead, so that the ink stays.
 *
 * Stipples stay on a surface that deforms. Where it has other cells than in the last frame (an
 * isosurface whose value changes, a time series), those of the progressive order go to the closest
 * points of the new surface; the ones that still fit stay, gaps are filled, and what comes and goes
 * grows and shrinks over Life such changes. A surface has its own ones in the first frame, where
 * time goes backwards, where the mapper's input comes from elsewhere, and in the mode ANCHORED of
 * vtkPatternStyle.
 *
 * CLASSIC is the paper's way: edge collapses and splits order the points, and one is drawn where
 * the pictures of all edges to its relevant neighbours, which have been there when it was added,
 * are longer than a threshold (section 2.3.3). The paper leaves open how the threshold depends on
 * the tone; here it has been measured, so that the ink is the tone. Stipples grow and shrink from
 * frame to frame (GrowthFrames): what is drawn depends on the frames before, but a still picture
 * comes to rest. There are NumberOfPoints, and no refinement: where they do not suffice, stipples
 * are larger.
 *
 * Translucent surfaces have stipples where they are seen first, and an even tone behind.
 *
 * @sa vtkStippleHierarchy vtkPatternStyle
 */

#ifndef vtkStippleLayer_h
#define vtkStippleLayer_h

#include "vtkPatternLayer.h"

class HACHURERENDERING_EXPORT vtkStippleLayer : public vtkPatternLayer
{
public:
  static vtkStippleLayer* New();
  vtkTypeMacro(vtkStippleLayer, vtkPatternLayer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What a darker tone has: DENSITY, more stipples of the same size; SIZE, larger ones, at most of
   * Size, and everywhere as many as tone 1 needs of those.
   */
  enum CarrierType
  {
    DENSITY = 0,
    SIZE = 1
  };

  /** Order of the stipples, as that of vtkStippleHierarchy. */
  enum OrderType
  {
    PROGRESSIVE = 0,
    CLASSIC = 1
  };

  const char* GetTypeName() override { return "stipple"; }

  ///@{
  /** Diameter of a grown stipple, in SizeUnit. Range 0.01 to 10000, default 2.4 (section 2.5). */
  vtkSetClampMacro(Size, double, 0.01, 10000.0);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /** Unit of Size, PIXELS or MILLIMETRES; default PIXELS. */
  vtkSetClampMacro(SizeUnit, int, PIXELS, MILLIMETRES);
  vtkGetMacro(SizeUnit, int);
  ///@}

  ///@{
  /** What carries the tone, one of CarrierType; default DENSITY. */
  vtkSetClampMacro(Carrier, int, DENSITY, SIZE);
  vtkGetMacro(Carrier, int);
  ///@}

  ///@{
  /** How slowly stipples grow: they are grown where stipples are by this share closer than where
   * they come in. Range 0.01 (at once) to 4 (all sizes at any time), default 0.25. CLASSIC: where
   * their shortest edge is by this share longer than the threshold, with GrowthFrames 0. */
  vtkSetClampMacro(Growth, double, 0.01, 4.0);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Frames in which a CLASSIC stipple grows to its full size when it is set, and shrinks to nothing
   * when it is unset (section 2.5). Every renderer has its own count. Only frames that are drawn as
   * a whole count: no tiles, second eyes or stand-ins of lower detail. Stipples that come into view
   * have grown, as all have in the first picture, and on a surface of other cells. 0: no frame
   * counts, and the size is a function of the picture alone, by Growth; so are all pictures of a
   * style in mode ANCHORED. Range 0 to 1000, default 8.
   */
  vtkSetClampMacro(GrowthFrames, int, 0, 1000);
  vtkGetMacro(GrowthFrames, int);
  ///@}

  ///@{
  /** Order of the stipples, one of OrderType; default PROGRESSIVE. */
  vtkSetClampMacro(Order, int, PROGRESSIVE, CLASSIC);
  vtkGetMacro(Order, int);
  ///@}

  ///@{
  /** Stipples that are made at first. Range 0 to 134217728, default 100000. */
  vtkSetClampMacro(NumberOfPoints, int, 0, 134217728);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /** Whether more are made where a view needs them; default on. */
  vtkSetMacro(Refinement, bool);
  vtkGetMacro(Refinement, bool);
  vtkBooleanMacro(Refinement, bool);
  ///@}

  ///@{
  /** Memory that the stipples of a surface which Refinement makes may take, MiB. Where other views
   * have spent most of it, those of that part are made anew, the same ones, when they are seen
   * again. Range 0 to 1048576, default 256. */
  vtkSetClampMacro(MemoryBudget, int, 0, 1048576);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /** Where the surface has other cells than before, the number of such changes over which stipples
   * grow that were not there, and shrink that do not fit any more. 0: every surface has stipples of
   * its own. Range 0 to 1000, default 8. */
  vtkSetClampMacro(Life, int, 0, 1000);
  vtkGetMacro(Life, int);
  ///@}

#ifndef __VTK_WRAP__
  double GetReach(double dotsPerInch) override;
  void DescribeField(hachure::StyleArchive& archive) override;
#endif

protected:
  vtkStippleLayer() = default;
  ~vtkStippleLayer() override = default;

private:
  vtkStippleLayer(const vtkStippleLayer&) = delete;
  void operator=(const vtkStippleLayer&) = delete;

  double Size = 2.4;
  int SizeUnit = PIXELS;
  int Carrier = DENSITY;
  double Growth = 0.25;
  int GrowthFrames = 8;
  int Order = PROGRESSIVE;
  int NumberOfPoints = 100000;
  bool Refinement = true;
  int MemoryBudget = 256;
  int Life = 8;
};

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkStippleRepresentation
 * @brief ParaView's surface representation, drawn with a style of stipples
 *
 * It draws as vtkPatternRepresentation does and has its properties; the style that it starts with
 * is made of stipples, and further properties replace what a vtkStippleLayer has, in all of them.
 * They start neutral as well, so that a new representation shows its style exactly. No setter
 * executes the pipeline of the surface.
 *
 * @sa vtkStippleLayer
 */
#ifndef vtkStippleRepresentation_h
#define vtkStippleRepresentation_h

#include "vtkPatternRepresentation.h"
#include "vtkStippleLayer.h" // For the ranges of the setters

class HACHUREREPRESENTATIONS_EXPORT vtkStippleRepresentation : public vtkPatternRepresentation
{
public:
  static vtkStippleRepresentation* New();
  vtkTypeMacro(vtkStippleRepresentation, vtkPatternRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Diameter of a grown stipple in pixels, before PatternScale: 0 as in the style, else up to
   * 10000; the layer takes what is below 0.01 as 0.01. Default 0. */
  void SetStippleSize(double pixels)
  {
    this->Change(this->StippleSize, std::clamp(pixels, 0.0, 10000.0));
  }
  vtkGetMacro(StippleSize, double);
  ///@}

  ///@{
  /** What carries the tone: AS_IN_STYLE, or vtkStippleLayer's DENSITY (0) or SIZE (1). Default
   * AS_IN_STYLE. */
  void SetStippleCarrier(int choice)
  {
    this->Choose(this->StippleCarrier, choice, vtkStippleLayer::SIZE);
  }
  vtkGetMacro(StippleCarrier, int);
  ///@}

  ///@{
  /** How slowly stipples grow, see vtkStippleLayer::SetGrowth(): 0 as in the style, else up to 4;
   * the layer takes what is below 0.01 as 0.01. Default 0. */
  void SetStippleGrowth(double share)
  {
    this->Change(this->StippleGrowth, std::clamp(share, 0.0, 4.0));
  }
  vtkGetMacro(StippleGrowth, double);
  ///@}

  ///@{
  /** Pictures in which a stipple of the order CLASSIC grows, see
   * vtkStippleLayer::SetGrowthFrames(), and changes of a surface's cells over which stipples come
   * and go, see vtkStippleLayer::SetLife(): -1 (default) as in the style, else up to 1000. */
  void SetStippleGrowthFrames(int frames)
  {
    this->Change(this->StippleGrowthFrames, std::clamp(frames, -1, 1000));
  }
  vtkGetMacro(StippleGrowthFrames, int);
  void SetStippleLife(int changes)
  {
    this->Change(this->StippleLife, std::clamp(changes, -1, 1000));
  }
  vtkGetMacro(StippleLife, int);
  ///@}

  ///@{
  /** Order of the stipples: AS_IN_STYLE, or vtkStippleLayer's PROGRESSIVE (0) or CLASSIC (1).
   * Default AS_IN_STYLE. */
  void SetStippleOrder(int choice)
  {
    this->Choose(this->StippleOrder, choice, vtkStippleLayer::CLASSIC);
  }
  vtkGetMacro(StippleOrder, int);
  ///@}

  ///@{
  /** Stipples that are made at first: 0 as in the style, else up to 134217728. Default 0. */
  void SetStippleNumberOfPoints(int count)
  {
    this->Change(this->StippleNumberOfPoints, std::clamp(count, 0, 134217728));
  }
  vtkGetMacro(StippleNumberOfPoints, int);
  ///@}

  ///@{
  /** Whether more are made where a view needs them: AS_IN_STYLE, 0 (no) or 1 (yes). Default
   * AS_IN_STYLE. */
  void SetStippleRefinement(int choice) { this->Choose(this->StippleRefinement, choice, 1); }
  vtkGetMacro(StippleRefinement, int);
  ///@}

  ///@{
  /** Memory that all stipples of a surface may take, MiB: 0 as in the style, else up to 1048576.
   * Default 0. */
  void SetStippleMemoryBudget(int mebibytes)
  {
    this->Change(this->StippleMemoryBudget, std::clamp(mebibytes, 0, 1048576));
  }
  vtkGetMacro(StippleMemoryBudget, int);
  ///@}

protected:
  vtkStippleRepresentation();
  ~vtkStippleRepresentation() override;

  void AdjustStyle(vtkPatternStyle* style) override;

private:
  vtkStippleRepresentation(const vtkStippleRepresentation&) = delete;
  void operator=(const vtkStippleRepresentation&) = delete;

  void AdjustDots(vtkStippleLayer* layer);
  void AdjustPoints(vtkStippleLayer* layer);

  double StippleSize = 0.0;
  int StippleCarrier = AS_IN_STYLE;
  double StippleGrowth = 0.0;
  int StippleGrowthFrames = -1;
  int StippleLife = -1;
  int StippleOrder = AS_IN_STYLE;
  int StippleNumberOfPoints = 0;
  int StippleRefinement = AS_IN_STYLE;
  int StippleMemoryBudget = 0;
};

#endif

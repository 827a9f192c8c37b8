// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternTone
 * @brief how dark a layer is at every pixel
 *
 * Tone 0 leaves the paper bare, tone 1 covers it with ink. The value comes from the light, from a
 * data array or from a constant t in [0,1], and is then shaped: Invert replaces t by 1 - t, after
 * which Gamma replaces t by t^Gamma.
 *
 * Setters clamp to the range they state; constants are members of this class.
 *
 * @sa vtkPatternLayer
 */

#ifndef vtkPatternTone_h
#define vtkPatternTone_h

#include "HachureRenderingModule.h"
#include "vtkObject.h"

#include <string>

class HACHURERENDERING_EXPORT vtkPatternTone : public vtkObject
{
public:
  static vtkPatternTone* New();
  vtkTypeMacro(vtkPatternTone, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Where the tone comes from.
   *
   * LIT: 1 - luma of the display-referred ambient and diffuse light on a white surface.
   * LIT_COLOR: the same with the surface's own colours.
   * ARRAY: a data array mapped by Range; NaN is drawn in the NaN colour.
   * CONSTANT: the same tone everywhere.
   */
  enum SourceType
  {
    LIT = 0,
    LIT_COLOR = 1,
    ARRAY = 2,
    CONSTANT = 3
  };

  /** Where an array is looked for. */
  enum AssociationType
  {
    POINTS_THEN_CELLS = 0,
    POINTS = 1,
    CELLS = 2
  };

  ///@{
  /** Source of the tone, one of SourceType; default LIT. */
  vtkSetClampMacro(Source, int, LIT, CONSTANT);
  vtkGetMacro(Source, int);
  ///@}

  ///@{
  /** Name of the data array that ARRAY reads; default empty, which is an error when drawn. */
  virtual void SetArrayName(const char* name);
  virtual const char* GetArrayName();
  ///@}

  ///@{
  /** Attributes that are searched for the array, one of AssociationType; default
   * POINTS_THEN_CELLS, which takes the cell array only where no point array has the name. */
  vtkSetClampMacro(ArrayAssociation, int, POINTS_THEN_CELLS, CELLS);
  vtkGetMacro(ArrayAssociation, int);
  ///@}

  ///@{
  /** Component of the array, counted from 0; -1 is the magnitude of the tuple. Range -1 to
   * VTK_INT_MAX, default 0. A component that the array lacks is an error when drawn. */
  vtkSetClampMacro(Component, int, -1, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /** Array values, in the array's unit, that map to tone 0 and to tone 1; values outside are
   * clamped. Default (0, 1). The first may be the larger one; equal ends are an error when drawn.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /** Tone of the source CONSTANT, 0 to 1, default 0.5. */
  vtkSetClampMacro(Constant, double, 0.0, 1.0);
  vtkGetMacro(Constant, double);
  ///@}

  ///@{
  /** Exponent applied to the tone: above 1 lightens, below 1 darkens. Range 0.01 to 100,
   * default 1. */
  vtkSetClampMacro(Gamma, double, 0.01, 100.0);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /** Whether the tone t is replaced by 1 - t before Gamma is applied; default off. */
  vtkSetMacro(Invert, bool);
  vtkGetMacro(Invert, bool);
  vtkBooleanMacro(Invert, bool);
  ///@}

protected:
  vtkPatternTone() = default;
  ~vtkPatternTone() override = default;

private:
  vtkPatternTone(const vtkPatternTone&) = delete;
  void operator=(const vtkPatternTone&) = delete;

  int Source = LIT;
  std::string ArrayName;
  int ArrayAssociation = POINTS_THEN_CELLS;
  int Component = 0;
  double Range[2] = { 0.0, 1.0 };
  double Constant = 0.5;
  double Gamma = 1.0;
  bool Invert = false;
};

#endif

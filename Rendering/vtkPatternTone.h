// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternTone
 * @brief how dark a layer is at every pixel
 *
 * Tone 0 leaves the paper bare, tone 1 covers it with ink. The value t in [0,1] comes from light,
 * from the surface's colour, from a data array or from a constant, and is then shaped: Invert
 * replaces t by 1 - t, after which Gamma replaces t by t^Gamma, after which Remap may step it.
 *
 * The layers of a style may use four different tones besides constants and separations.
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
   * LIGHT: as LIT, from the light LightIndex alone; switched off, it gives none.
   * HIGHLIGHT: how strong the mirrored light is, 0 where nothing shines, of a white surface whose
   * shininess is HighlightPower; a layer goes where the surface shines.
   * LUMINANCE: 1 - luma of the display-referred colour of the surface without light or texture.
   * CYAN, MAGENTA, YELLOW, BLACK: separation of the surface's colour in linear light, lit or, on
   * paper of the kind FLAT, unlit. Layers of these four tones, inked "#00ffff", "#ff00ff",
   * "#ffff00" and "#000000" and multiplied on white paper, print the colour.
   */
  enum SourceType
  {
    LIT = 0,
    LIT_COLOR = 1,
    ARRAY = 2,
    CONSTANT = 3,
    LIGHT = 4,
    HIGHLIGHT = 5,
    LUMINANCE = 6,
    CYAN = 7,
    MAGENTA = 8,
    YELLOW = 9,
    BLACK = 10
  };

  /** What follows Invert and Gamma. */
  enum RemapType
  {
    NONE = 0,
    STEPS = 1,
    SMOOTHSTEP = 2
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
  vtkSetClampMacro(Source, int, LIT, BLACK);
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

  ///@{
  /** What is made of the tone after Invert and Gamma, one of RemapType; default NONE. STEPS: one
   * of Steps flat tones, each for an equal share of the tones. SMOOTHSTEP: a smooth step over
   * RemapRange. */
  vtkSetClampMacro(Remap, int, NONE, SMOOTHSTEP);
  vtkGetMacro(Remap, int);
  ///@}

  ///@{
  /** Number of flat tones of the remap STEPS, bare paper and full ink among them. Range 2 to 16,
   * default 3. */
  vtkSetClampMacro(Steps, int, 2, 16);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /** Tones where the remap SMOOTHSTEP begins, with 0, and ends, with 1. Default (0.25, 0.75). The
   * first may be the larger one; equal ends make a hard step. */
  vtkSetVector2Macro(RemapRange, double);
  vtkGetVector2Macro(RemapRange, double);
  ///@}

  ///@{
  /** Light that LIGHT and HIGHLIGHT follow, counted from 0 in the renderer's order, those that are
   * switched off too; -1: all together. Range -1 to VTK_INT_MAX, default -1. A light that the
   * renderer lacks is an error when drawn, and gives no light. */
  vtkSetClampMacro(LightIndex, int, -1, VTK_INT_MAX);
  vtkGetMacro(LightIndex, int);
  ///@}

  ///@{
  /** Exponent of Phong's highlights for HIGHLIGHT: larger ones are smaller. Range 0 to 1000,
   * default 0, which is the SpecularPower of the surface's property. */
  vtkSetClampMacro(HighlightPower, double, 0.0, 1000.0);
  vtkGetMacro(HighlightPower, double);
  ///@}

  ///@{
  /** How much of a colour's darkness the separations leave to black ink; at 0 there is none. Range
   * 0 to 1, default 1. Must be equal in all layers of a separation. */
  vtkSetClampMacro(BlackGeneration, double, 0.0, 1.0);
  vtkGetMacro(BlackGeneration, double);
  ///@}

  /** Whether the source is CYAN, MAGENTA, YELLOW or BLACK. */
  bool IsSeparation() const { return this->Source >= CYAN; }

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
  int Remap = NONE;
  int Steps = 3;
  double RemapRange[2] = { 0.25, 0.75 };
  int LightIndex = -1;
  double HighlightPower = 0.0;
  double BlackGeneration = 1.0;
};

#endif

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternRepresentation
 * @brief ParaView's surface representation, drawn with a vtkPatternStyle
 *
 * The mappers for full and for low detail are vtkPatternMapper and share one style; the one for low
 * detail looks on, so that interaction never moves the patterns of the next full picture. Backfaces
 * that are given a representation of their own are drawn as ParaView draws them.
 *
 * What is drawn is made of a style, a preset or a file, and of what the other properties replace in
 * all of its layers. They start neutral: a property of the type Choice at AS_IN_STYLE leaves the
 * style as it is, as do PatternScale 1 and PatternAngle 0, and a colour, an array, a range or a
 * width counts only when the choice that it belongs to asks for it. A new representation therefore
 * shows its style exactly.
 *
 * No setter executes the pipeline again: the style is made anew before the next picture.
 *
 * @sa vtkPatternMapper vtkPatternStyle
 */
#ifndef vtkPatternRepresentation_h
#define vtkPatternRepresentation_h

#include "HachureRepresentationsModule.h"
#include "vtkGeometryRepresentationWithFaces.h"

#include <string>

class vtkPatternLayer;
class vtkPatternStyle;

class HACHUREREPRESENTATIONS_EXPORT vtkPatternRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkPatternRepresentation* New();
  vtkTypeMacro(vtkPatternRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** First value of every choice. */
  static constexpr int AS_IN_STYLE = -1;

  ///@{
  /** Name of the built-in style that is drawn, unless there is a PatternStyleFile. An unknown one
   * is an error that lists the names, and changes nothing. Default "cross-hatch". */
  void SetPatternStyle(const char* name);
  const char* GetPatternStyle();
  ///@}

  ///@{
  /** Style file (JSON) that is drawn instead of PatternStyle; every process reads it. One that
   * cannot be read is an error with its reason, and changes nothing. Default empty: none. */
  void SetPatternStyleFile(const char* fileName);
  const char* GetPatternStyleFile();
  ///@}

  ///@{
  /** Source of the tone of all layers: AS_IN_STYLE, or vtkPatternTone's LIT (0), LIT_COLOR (1) or
   * ARRAY (2). Default AS_IN_STYLE. */
  void SetPatternTone(int source);
  vtkGetMacro(PatternTone, int);
  ///@}

  ///@{
  /** Array for the tone source ARRAY, as vtkAlgorithm names arrays; only the association
   * (vtkDataObject::FIELD_ASSOCIATION_POINTS or _CELLS) and the name count. Default: none, which
   * is an error when drawn. */
  void SetPatternToneArray(int index, int port, int connection, int association, const char* name);
  const char* GetPatternToneArrayName();
  vtkGetMacro(PatternToneAssociation, int);
  ///@}

  ///@{
  /** Component of the array, counted from 0; -1 is the magnitude. Default 0. */
  void SetPatternToneComponent(int component);
  vtkGetMacro(PatternToneComponent, int);
  ///@}

  ///@{
  /** Array values that map to tone 0 and to tone 1, in the unit of the array; where they are equal,
   * that value is tone 0. Default (0, 1). */
  void SetPatternToneRange(double paper, double ink);
  vtkGetVector2Macro(PatternToneRange, double);
  ///@}

  ///@{
  /** Factor on the size of the patterns. Range 0.01 to 100, default 1. */
  void SetPatternScale(double scale);
  vtkGetMacro(PatternScale, double);
  ///@}

  ///@{
  /** Turn of the patterns in degrees, counter-clockwise. Range -360 to 360, default 0. */
  void SetPatternAngle(double angle);
  vtkGetMacro(PatternAngle, double);
  ///@}

  ///@{
  /** Ink of all layers and of the outline: AS_IN_STYLE, or 0 for PatternInkColor. Default
   * AS_IN_STYLE. */
  void SetPatternInk(int choice);
  vtkGetMacro(PatternInk, int);
  ///@}

  ///@{
  /** Ink where PatternInk asks for it, sRGB components 0 to 1; default black. */
  void SetPatternInkColor(double red, double green, double blue);
  vtkGetVector3Macro(PatternInkColor, double);
  ///@}

  ///@{
  /** What the paper shows: AS_IN_STYLE, or vtkPatternStyle's CONSTANT (0, PatternPaperColor),
   * SURFACE (1) or FLAT (2). Default AS_IN_STYLE. */
  void SetPatternPaper(int choice);
  vtkGetMacro(PatternPaper, int);
  ///@}

  ///@{
  /** Paper where PatternPaper asks for it, sRGB components 0 to 1; default white. */
  void SetPatternPaperColor(double red, double green, double blue);
  vtkGetVector3Macro(PatternPaperColor, double);
  ///@}

  ///@{
  /** Whether contours are drawn: AS_IN_STYLE, 0 (no) or 1 (yes, PatternOutlineWidth wide). Default
   * AS_IN_STYLE. */
  void SetPatternOutline(int choice);
  vtkGetMacro(PatternOutline, int);
  ///@}

  ///@{
  /** Width of the contours in logical pixels where PatternOutline is 1. Range 0 to 100, default
   * 1.5. */
  void SetPatternOutlineWidth(double width);
  vtkGetMacro(PatternOutlineWidth, double);
  ///@}

  ///@{
  /** How patterns remember the pictures before: AS_IN_STYLE, or vtkPatternStyle's TRACKED (0) or
   * ANCHORED (1). Default AS_IN_STYLE. */
  void SetPatternTracking(int choice);
  vtkGetMacro(PatternTracking, int);
  ///@}

protected:
  vtkPatternRepresentation();
  ~vtkPatternRepresentation() override = default;

  void UpdateColoringParameters() override;

private:
  vtkPatternRepresentation(const vtkPatternRepresentation&) = delete;
  void operator=(const vtkPatternRepresentation&) = delete;

  template <class T>
  void Change(T& member, const T& value);
  void UpdateStyle();
  bool LoadStyle(vtkPatternStyle* style);
  void AdjustStyle(vtkPatternStyle* style);
  void AdjustLayer(vtkPatternLayer* layer);

  bool StyleChanged = true;
  std::string PatternStyle;
  std::string PatternStyleFile;
  int PatternTone = AS_IN_STYLE;
  std::string PatternToneArrayName;
  int PatternToneAssociation = 0;
  int PatternToneComponent = 0;
  double PatternToneRange[2] = { 0.0, 1.0 };
  double PatternScale = 1.0;
  double PatternAngle = 0.0;
  int PatternInk = AS_IN_STYLE;
  double PatternInkColor[3] = { 0.0, 0.0, 0.0 };
  int PatternPaper = AS_IN_STYLE;
  double PatternPaperColor[3] = { 1.0, 1.0, 1.0 };
  int PatternOutline = AS_IN_STYLE;
  double PatternOutlineWidth = 1.5;
  int PatternTracking = AS_IN_STYLE;
};

#endif

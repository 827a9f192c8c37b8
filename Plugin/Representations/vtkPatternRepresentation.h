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
 * Patches are made of the surface that is drawn, between the filter that extracts it and the
 * mappers, so that pictures of low detail have the same ones. Each process divides the part of the
 * surface that it holds.
 *
 * What is drawn is made of a style, a preset or a file, and of what the other properties replace in
 * all of its layers. They start neutral: a property of the type Choice at AS_IN_STYLE leaves the
 * style as it is, as do PatternScale 1 and PatternAngle 0, and a colour, an array, a range or a
 * width counts only when the choice that it belongs to asks for it. A new representation therefore
 * shows its style exactly.
 *
 * Setters of patches execute the pipeline of the surface again. No other one does: the style is
 * made anew before the next picture.
 *
 * @sa vtkPatternMapper vtkPatternStyle
 */
#ifndef vtkPatternRepresentation_h
#define vtkPatternRepresentation_h

#include "HachureRepresentationsModule.h"
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkSmartPointer.h" // For the patches

#include <string>

class vtkImagePatternLayer;
class vtkPatternLayer;
class vtkPatternStyle;
class vtkRepresentationPatches;

class HACHUREREPRESENTATIONS_EXPORT vtkPatternRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkPatternRepresentation* New();
  vtkTypeMacro(vtkPatternRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** First value of every choice. */
  static constexpr int AS_IN_STYLE = -1;

  /** Where patches, each of which moves its own pattern, come from. */
  enum PatchesType
  {
    AS_IN_DATA = -1, //!< the cell array PatchId of the data, one patch where there is none
    NONE = 0,        //!< one patch, whatever the data say
    ARRAY = 1,       //!< a patch for every value of PatternPatchArray
    CONNECTED = 2,   //!< a patch for every region that hangs together
    BLOCKS = 3,      //!< a patch for every block
    CREASES = 4,     //!< regions between edges sharper than PatternCreaseAngle
    AUTOMATIC = 5    //!< PatternNumberOfPatches compact patches
  };

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

  ///@{
  /** Densities of strokes of hatching in all layers: 0 as in the style, 1 for strokes that grow
   * wider with the tone, 2 to 4 for that many densities of strokes of one width. Default 0. */
  void SetPatternDensities(int densities);
  vtkGetMacro(PatternDensities, int);
  ///@}

  ///@{
  /** Whether the grain of paper shows in the marks of all layers: AS_IN_STYLE, 0 (no) or 1 (yes, by
   * PatternPaperContrast). Default AS_IN_STYLE. */
  void SetPatternPaperGrain(int choice);
  vtkGetMacro(PatternPaperGrain, int);
  ///@}

  ///@{
  /** Part of the grain in deciding where ink goes first, where PatternPaperGrain is 1: 0 (smooth)
   * to 1 (the grain alone). Default 0.5. */
  void SetPatternPaperContrast(double contrast);
  vtkGetMacro(PatternPaperContrast, double);
  ///@}

  ///@{
  /** How the marks of half the size take over while zooming: AS_IN_STYLE, or vtkImagePatternLayer's
   * AUTOMATIC_TRANSITION (0), CROSS_FADE (1) or BLEND_SCREENS (2). Default AS_IN_STYLE. */
  void SetPatternTransition(int choice);
  vtkGetMacro(PatternTransition, int);
  ///@}

  ///@{
  /** Which difference between tone and ink is removed: AS_IN_STYLE, or vtkImagePatternLayer's
   * FULL_CORRECTION (0), TRANSITION_ONLY (1) or NO_CORRECTION (2). Default AS_IN_STYLE. */
  void SetPatternToneCorrection(int choice);
  vtkGetMacro(PatternToneCorrection, int);
  ///@}

  ///@{
  /** How the patterns of all layers move: AS_IN_STYLE, or vtkImagePatternLayer's SIMILARITY (0),
   * FIXED_IN_IMAGE (1), TEXTURE (2) or DYNAMIC_SOLID (3). Default AS_IN_STYLE. */
  void SetPatternMotion(int choice);
  vtkGetMacro(PatternMotion, int);
  ///@}

  ///@{
  /** Period of the patterns on the surface where PatternMotion is TEXTURE or DYNAMIC_SOLID, in the
   * units of the data, or of the texture coordinates if there are some. Not below 0; 0 derives it
   * from the bounds. Default 0. */
  void SetPatternSurfacePeriod(double period);
  vtkGetMacro(PatternSurfacePeriod, double);
  ///@}

  ///@{
  /** Whether patterns keep their direction, or their size, in the image, while they still follow
   * the surface's place: AS_IN_STYLE, 0 (no) or 1 (yes). Default AS_IN_STYLE. */
  void SetPatternLockRotation(int choice);
  vtkGetMacro(PatternLockRotation, int);
  void SetPatternLockScale(int choice);
  vtkGetMacro(PatternLockScale, int);
  ///@}

  ///@{
  /** Which parts of the surface count most for the motion: AS_IN_STYLE, or vtkPatternStyle's
   * SYMMETRIC (0), CLASSIC (1), UNWEIGHTED (2) or PERCEPTUAL (3). Default AS_IN_STYLE. */
  void SetPatternWeights(int choice);
  vtkGetMacro(PatternWeights, int);
  ///@}

  ///@{
  /** Features that count where PatternWeights is PERCEPTUAL: vtkPatternStyle's CURVATURE (0), TONE
   * (1) or ARRAY (2, PatternFeatureArray). Default CURVATURE. */
  void SetPatternFeatures(int source);
  vtkGetMacro(PatternFeatures, int);
  ///@}

  ///@{
  /** Array for the features ARRAY, as vtkAlgorithm names arrays; only the name counts: a point or
   * else cell array of one component, not below 0. Default: none, which is an error with ARRAY. */
  void SetPatternFeatureArray(
    int index, int port, int connection, int association, const char* name);
  const char* GetPatternFeatureArrayName();
  ///@}

  ///@{
  /** Point array with the velocity of the surface, see vtkPatternMapper::SetVelocityArrayName();
   * "None" for none, the default. */
  void SetPatternVelocityArray(const char* name);
  const char* GetPatternVelocityArray();
  ///@}

  ///@{
  /** Where patches come from, one of PatchesType; default AS_IN_DATA. What cannot be had, as an
   * array of fractions, is an error; the surface is then drawn with the patches of its data. */
  void SetPatternPatches(int patches);
  vtkGetMacro(PatternPatches, int);
  ///@}

  ///@{
  /** Array for ARRAY, as vtkAlgorithm names arrays; only the name counts: a cell array or, where
   * none has this name, a point array, of whole numbers or strings. Default: none, which is an
   * error with ARRAY. */
  void SetPatternPatchArray(int index, int port, int connection, int association, const char* name);
  const char* GetPatternPatchArrayName();
  ///@}

  ///@{
  /** Number of patches for AUTOMATIC, at least 1. Default 16. */
  void SetPatternNumberOfPatches(int count);
  vtkGetMacro(PatternNumberOfPatches, int);
  ///@}

  ///@{
  /** Largest angle between cells that stay together for CREASES, in degrees. Range 0 to 180,
   * default 30. */
  void SetPatternCreaseAngle(double angle);
  vtkGetMacro(PatternCreaseAngle, double);
  ///@}

  ///@{
  /** Rings of points, on each side of a border, over which the patterns of two patches fade into
   * each other; 0 for sharp borders. Patches as in the data have the weights of the data instead.
   * Not below 0, default 2. */
  void SetPatternPatchBlend(int rings);
  vtkGetMacro(PatternPatchBlend, int);
  ///@}

protected:
  vtkPatternRepresentation();
  ~vtkPatternRepresentation() override;

  void UpdateColoringParameters() override;

private:
  vtkPatternRepresentation(const vtkPatternRepresentation&) = delete;
  void operator=(const vtkPatternRepresentation&) = delete;

  template <class T>
  void Change(T& member, const T& value);
  template <class T>
  void ChangePatches(T& member, const T& value);
  void UpdatePatches();
  void UpdateStyle();
  bool LoadStyle(vtkPatternStyle* style);
  void AdjustStyle(vtkPatternStyle* style);
  void AdjustMotion(vtkPatternStyle* style);
  void AdjustLayer(vtkPatternLayer* layer);
  void AdjustImageLayer(vtkImagePatternLayer* layer);
  void AdjustTone(vtkPatternLayer* layer);

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
  int PatternDensities = 0;
  int PatternPaperGrain = AS_IN_STYLE;
  double PatternPaperContrast = 0.5;
  int PatternTransition = AS_IN_STYLE;
  int PatternToneCorrection = AS_IN_STYLE;
  int PatternMotion = AS_IN_STYLE;
  double PatternSurfacePeriod = 0.0;
  int PatternLockRotation = AS_IN_STYLE;
  int PatternLockScale = AS_IN_STYLE;
  int PatternWeights = AS_IN_STYLE;
  int PatternFeatures = 0;
  std::string PatternFeatureArrayName;
  std::string PatternVelocityArray = "None";
  vtkSmartPointer<vtkRepresentationPatches> Patches;
  int PatternPatches = AS_IN_DATA;
  std::string PatternPatchArrayName;
  int PatternNumberOfPatches = 16;
  double PatternCreaseAngle = 30.0;
  int PatternPatchBlend = 2;
};

#endif

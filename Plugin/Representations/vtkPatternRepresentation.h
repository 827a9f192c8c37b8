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
 * mappers, so that pictures of low detail have the same ones. Where several processes hold parts of
 * the surface, each knows all of it (vtkWholeSurface), makes the same patterns, and draws its part
 * with them.
 *
 * What is drawn is made of a style, a preset or a file, and of what the other properties replace in
 * all of its layers. They start neutral: a property of the type Choice at AS_IN_STYLE leaves the
 * style as it is, as do factors of 1 and numbers of 0 that are added, and a colour, an array, a
 * range or a width counts only when the choice that it belongs to asks for it. A new representation
 * therefore shows its style exactly.
 *
 * Setters clamp to the range they state. Those of patches execute the pipeline of the surface
 * again. No other one does: the style is made anew before the next picture.
 *
 * @sa vtkPatternMapper vtkPatternStyle
 */
#ifndef vtkPatternRepresentation_h
#define vtkPatternRepresentation_h

#include "HachureRepresentationsModule.h"
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkImagePatternLayer.h" // For the ranges of the setters
#include "vtkPatchBlendWeights.h" // For the ranges of the setters
#include "vtkPatternStyle.h"      // For the ranges of the setters
#include "vtkPatternTone.h"       // For the ranges of the setters
#include "vtkSmartPointer.h"      // For the patches

#include <algorithm> // For the ranges of the setters
#include <memory>    // For the files and the legend
#include <string>

class PatternLegendPlace;
class RepresentationFile;
class vtkImageData;
class vtkMultiBlockDataSet;
class vtkNoiseLayer;
class vtkPatternLegendActor;
class vtkRepresentationPatches;
class vtkWholeSurface;

class HACHUREREPRESENTATIONS_EXPORT vtkPatternRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkPatternRepresentation* New();
  vtkTypeMacro(vtkPatternRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** First value of every choice. */
  static constexpr int AS_IN_STYLE = -1;

  /** Values of PatternInk. */
  enum InkType
  {
    INK_COLOR = 0,     //!< PatternInkColor, for the outline too
    SURFACE_COLORS = 1 //!< the colours of the lit surface below the marks
  };

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
  /** The style file that SavePatternStyle() writes. Default empty: none. */
  void SetPatternStyleSaveName(const char* fileName);
  const char* GetPatternStyleSaveName();
  ///@}

  /** Writes the style that is drawn, with all that the properties replace in it, so that a new
   * representation with this PatternStyleFile draws the same; patches, velocities and back ends are
   * none of a style's. Of several processes the first one of the server writes. An error without a
   * file name, where it cannot be written, and where a layer has a picture or views that are in no
   * file. */
  void SavePatternStyle();

  ///@{
  /** Factor on the size of the patterns. Range 0.01 to 100, default 1. */
  void SetPatternScale(double scale)
  {
    this->Change(this->PatternScale, std::clamp(scale, 0.01, 100.0));
  }
  vtkGetMacro(PatternScale, double);
  ///@}

  ///@{
  /** Turn of the patterns in degrees, counter-clockwise. Range -360 to 360, default 0. */
  void SetPatternAngle(double angle)
  {
    this->Change(this->PatternAngle, std::clamp(angle, -360.0, 360.0));
  }
  vtkGetMacro(PatternAngle, double);
  ///@}

  ///@{
  /** Ink of all layers: AS_IN_STYLE or one of InkType. Default AS_IN_STYLE. */
  void SetPatternInk(int choice) { this->Choose(this->PatternInk, choice, SURFACE_COLORS); }
  vtkGetMacro(PatternInk, int);
  ///@}

  ///@{
  /** Ink where PatternInk asks for it, sRGB components 0 to 1; default black. */
  void SetPatternInkColor(double red, double green, double blue)
  {
    this->ChangeColor(this->PatternInkColor, red, green, blue);
  }
  vtkGetVector3Macro(PatternInkColor, double);
  ///@}

  ///@{
  /** Factor on the opacity of the ink of all layers. Range 0 to 1, default 1. */
  void SetPatternInkOpacity(double factor)
  {
    this->Change(this->PatternInkOpacity, std::clamp(factor, 0.0, 1.0));
  }
  vtkGetMacro(PatternInkOpacity, double);
  ///@}

  ///@{
  /** How the ink of all layers mixes with what lies below: AS_IN_STYLE, or vtkPatternLayer's OVER
   * (0), MULTIPLY (1), OVERLAY (2) or SCREEN (3). Default AS_IN_STYLE. */
  void SetPatternBlendMode(int choice)
  {
    this->Choose(this->PatternBlendMode, choice, vtkPatternLayer::SCREEN);
  }
  vtkGetMacro(PatternBlendMode, int);
  ///@}

  ///@{
  /** What the paper shows: AS_IN_STYLE, or vtkPatternStyle's CONSTANT (0, PatternPaperColor),
   * SURFACE (1), FLAT (2) or NO_PAPER (3). Default AS_IN_STYLE. */
  void SetPatternPaper(int choice)
  {
    this->Choose(this->PatternPaper, choice, vtkPatternStyle::NO_PAPER);
  }
  vtkGetMacro(PatternPaper, int);
  ///@}

  ///@{
  /** Paper where PatternPaper asks for it, sRGB components 0 to 1; default white. */
  void SetPatternPaperColor(double red, double green, double blue)
  {
    this->ChangeColor(this->PatternPaperColor, red, green, blue);
  }
  vtkGetVector3Macro(PatternPaperColor, double);
  ///@}

  ///@{
  /** Source of the tone of all layers: AS_IN_STYLE, or vtkPatternTone's LIT (0), LIT_COLOR (1),
   * ARRAY (2), CONSTANT (3), LIGHT (4), HIGHLIGHT (5) or LUMINANCE (6). Default AS_IN_STYLE. */
  void SetPatternTone(int source)
  {
    this->Choose(this->PatternTone, source, vtkPatternTone::LUMINANCE);
  }
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
  void SetPatternToneComponent(int component)
  {
    this->Change(this->PatternToneComponent, std::max(component, -1));
  }
  vtkGetMacro(PatternToneComponent, int);
  ///@}

  ///@{
  /** Array values that map to tone 0 and to tone 1, in the unit of the array; where they are equal,
   * that value is tone 0. Default (0, 1). */
  void SetPatternToneRange(double paper, double ink)
  {
    this->ChangePair(this->PatternToneRange, paper, ink);
  }
  vtkGetVector2Macro(PatternToneRange, double);
  ///@}

  ///@{
  /** Tone of the source CONSTANT. Range 0 to 1, default 0.5. */
  void SetPatternToneConstant(double tone)
  {
    this->Change(this->PatternToneConstant, std::clamp(tone, 0.0, 1.0));
  }
  vtkGetMacro(PatternToneConstant, double);
  ///@}

  ///@{
  /** Light of the tone source LIGHT, counted from 0 in the order of the view; ParaView's light kit
   * is the head light, the key light, the fill light and two back lights. One that the view lacks
   * is an error when drawn. Default 0. */
  void SetPatternToneLight(int index) { this->Change(this->PatternToneLight, std::max(index, 0)); }
  vtkGetMacro(PatternToneLight, int);
  ///@}

  ///@{
  /** Light of the tone source HIGHLIGHT, counted as PatternToneLight; -1 is all of them. Default
   * -1. */
  void SetPatternHighlightLight(int index)
  {
    this->Change(this->PatternHighlightLight, std::max(index, -1));
  }
  vtkGetMacro(PatternHighlightLight, int);
  ///@}

  ///@{
  /** Exponent of the highlights of the tone source HIGHLIGHT: larger ones are smaller. Range 0 to
   * 1000, default 0, which is the SpecularPower of the representation. */
  void SetPatternHighlightPower(double power)
  {
    this->Change(this->PatternHighlightPower, std::clamp(power, 0.0, 1000.0));
  }
  vtkGetMacro(PatternHighlightPower, double);
  ///@}

  ///@{
  /** Whether the tone of all layers is inverted, so that what was paper is inked: AS_IN_STYLE, 0
   * (no) or 1 (yes). Default AS_IN_STYLE. */
  void SetPatternToneInvert(int choice) { this->Choose(this->PatternToneInvert, choice, 1); }
  vtkGetMacro(PatternToneInvert, int);
  ///@}

  ///@{
  /** Factor on the exponent of the tone of all layers: above 1 lightens middle tones, below 1
   * darkens them. Range 0.01 to 100, default 1. */
  void SetPatternToneGamma(double factor)
  {
    this->Change(this->PatternToneGamma, std::clamp(factor, 0.01, 100.0));
  }
  vtkGetMacro(PatternToneGamma, double);
  ///@}

  ///@{
  /** What is made of the tone of all layers after that: AS_IN_STYLE, or vtkPatternTone's NONE (0),
   * STEPS (1, PatternToneSteps of them) or SMOOTHSTEP (2, over PatternToneRemapRange). Default
   * AS_IN_STYLE. */
  void SetPatternToneRemap(int choice)
  {
    this->Choose(this->PatternToneRemap, choice, vtkPatternTone::SMOOTHSTEP);
  }
  vtkGetMacro(PatternToneRemap, int);
  ///@}

  ///@{
  /** Number of flat tones where PatternToneRemap is STEPS. Range 2 to 16, default 3. */
  void SetPatternToneSteps(int steps)
  {
    this->Change(this->PatternToneSteps, std::clamp(steps, 2, 16));
  }
  vtkGetMacro(PatternToneSteps, int);
  ///@}

  ///@{
  /** Tones where the step begins and ends where PatternToneRemap is SMOOTHSTEP. Default (0.25,
   * 0.75). */
  void SetPatternToneRemapRange(double paper, double ink)
  {
    this->ChangePair(this->PatternToneRemapRange, paper, ink);
  }
  vtkGetVector2Macro(PatternToneRemapRange, double);
  ///@}

  ///@{
  /** Factor on how much of a colour's darkness the layers of a print leave to black ink. Range 0 to
   * 1, default 1. */
  void SetPatternBlackGeneration(double factor)
  {
    this->Change(this->PatternBlackGeneration, std::clamp(factor, 0.0, 1.0));
  }
  vtkGetMacro(PatternBlackGeneration, double);
  ///@}

  ///@{
  /** Which difference between tone and ink is removed: AS_IN_STYLE, or vtkImagePatternLayer's
   * FULL_CORRECTION (0), TRANSITION_ONLY (1) or NO_CORRECTION (2). Default AS_IN_STYLE. */
  void SetPatternToneCorrection(int choice)
  {
    this->Choose(this->PatternToneCorrection, choice, vtkImagePatternLayer::NO_CORRECTION);
  }
  vtkGetMacro(PatternToneCorrection, int);
  ///@}

  ///@{
  /** Pattern of all layers: AS_IN_STYLE, or vtkImagePatternLayer's HATCH (0), CROSS_HATCH (1),
   * HALFTONE (2), IMAGE (3, PatternImageFile), STIPPLE (4), PAINT (5) or PAPER (6). Default
   * AS_IN_STYLE. */
  void SetPatternKind(int choice)
  {
    this->Choose(this->PatternKind, choice, vtkImagePatternLayer::PAPER);
  }
  vtkGetMacro(PatternKind, int);
  ///@}

  ///@{
  /** Picture file where PatternKind is IMAGE; every process reads it. It is drawn upright and at
   * its own size, a pixel for a logical pixel, but for PatternScale and PatternAngle. Default
   * empty: layers then keep their patterns, as they do after the error of a file that cannot be
   * read. */
  void SetPatternImageFile(const char* fileName);
  const char* GetPatternImageFile();
  ///@}

  ///@{
  /** Added to the irregularity of all layers: 1 makes any marks sketched, -1 any marks ruled. Range
   * -1 to 1, default 0. */
  void SetPatternIrregularity(double difference)
  {
    this->Change(this->PatternIrregularity, std::clamp(difference, -1.0, 1.0));
  }
  vtkGetMacro(PatternIrregularity, double);
  ///@}

  ///@{
  /** Densities of strokes of hatching in all layers: 0 as in the style, 1 for strokes that grow
   * wider with the tone, 2 to 4 for that many densities of strokes of one width. Default 0. */
  void SetPatternDensities(int densities)
  {
    this->Change(this->PatternDensities, std::clamp(densities, 0, 4));
  }
  vtkGetMacro(PatternDensities, int);
  ///@}

  ///@{
  /** Whether the brush of the pattern PAINT is replaced in all layers: AS_IN_STYLE, or 0 for the
   * six numbers below. Default AS_IN_STYLE. */
  void SetPatternBrush(int choice) { this->Choose(this->PatternBrush, choice, 0); }
  vtkGetMacro(PatternBrush, int);
  ///@}

  ///@{
  /** Dabs where PatternBrush is 0, see vtkImagePatternLayer. PatternDabLength: over their width, 1
   * to 8, default 2.6. PatternDabJitter: deviation of their direction in degrees, 0 to 180, default
   * 18. PatternDabDensity: dabs over a point, 0.5 to 8, default 3. PatternBristles: 0 (soft) to 1
   * (stiff), default 0.6. */
  void SetPatternDabLength(double length)
  {
    this->Change(this->PatternDabLength, std::clamp(length, 1.0, 8.0));
  }
  vtkGetMacro(PatternDabLength, double);
  void SetPatternDabJitter(double degrees)
  {
    this->Change(this->PatternDabJitter, std::clamp(degrees, 0.0, 180.0));
  }
  vtkGetMacro(PatternDabJitter, double);
  void SetPatternDabDensity(double density)
  {
    this->Change(this->PatternDabDensity, std::clamp(density, 0.5, 8.0));
  }
  vtkGetMacro(PatternDabDensity, double);
  void SetPatternBristles(double stiffness)
  {
    this->Change(this->PatternBristles, std::clamp(stiffness, 0.0, 1.0));
  }
  vtkGetMacro(PatternBristles, double);
  ///@}

  ///@{
  /** Look of the paint where PatternBrush is 0, 0 to 1 each: relief of the dabs, and their largest
   * relative difference in brightness. Defaults 0.5 and 0.15, as in the style "painterly". */
  void SetPatternBump(double relief)
  {
    this->Change(this->PatternBump, std::clamp(relief, 0.0, 1.0));
  }
  vtkGetMacro(PatternBump, double);
  void SetPatternColorVariation(double variation)
  {
    this->Change(this->PatternColorVariation, std::clamp(variation, 0.0, 1.0));
  }
  vtkGetMacro(PatternColorVariation, double);
  ///@}

  ///@{
  /** Whether the grain of paper shows in the marks of all layers: AS_IN_STYLE, 0 (no) or 1 (yes, by
   * PatternPaperContrast). Default AS_IN_STYLE. */
  void SetPatternPaperGrain(int choice) { this->Choose(this->PatternPaperGrain, choice, 1); }
  vtkGetMacro(PatternPaperGrain, int);
  ///@}

  ///@{
  /** Part of the grain in deciding where ink goes first, where PatternPaperGrain is 1: 0 (smooth)
   * to 1 (the grain alone). Default 0.5. */
  void SetPatternPaperContrast(double contrast)
  {
    this->Change(this->PatternPaperContrast, std::clamp(contrast, 0.0, 1.0));
  }
  vtkGetMacro(PatternPaperContrast, double);
  ///@}

  ///@{
  /** Factor on the size of the grain. Range 0.01 to 100, default 1. */
  void SetPatternPaperScale(double scale)
  {
    this->Change(this->PatternPaperScale, std::clamp(scale, 0.01, 100.0));
  }
  vtkGetMacro(PatternPaperScale, double);
  ///@}

  ///@{
  /** Added to the seed of all layers: other numbers place marks otherwise. Not below 0, default 0.
   */
  void SetPatternSeed(int seed) { this->Change(this->PatternSeed, std::max(seed, 0)); }
  vtkGetMacro(PatternSeed, int);
  ///@}

  ///@{
  /** Whether contours are drawn: AS_IN_STYLE, 0 (no) or 1 (yes, with the width and of the kinds
   * below). Default AS_IN_STYLE. */
  void SetPatternOutline(int choice) { this->Choose(this->PatternOutline, choice, 1); }
  vtkGetMacro(PatternOutline, int);
  ///@}

  ///@{
  /** Width of the contours in logical pixels where PatternOutline is 1. Range 0 to 100, default
   * 1.5. */
  void SetPatternOutlineWidth(double width)
  {
    this->Change(this->PatternOutlineWidth, std::clamp(width, 0.0, 100.0));
  }
  vtkGetMacro(PatternOutlineWidth, double);
  ///@}

  ///@{
  /** Which contours there are where PatternOutline is 1, 0 (no) or 1 (yes) each: where the surface
   * turns away, where it bends by more than PatternOutlineCreaseAngle, and at open edges. All 1 by
   * default. */
  void SetPatternOutlineSilhouette(int shown)
  {
    this->Change(this->PatternOutlineSilhouette, std::clamp(shown, 0, 1));
  }
  vtkGetMacro(PatternOutlineSilhouette, int);
  void SetPatternOutlineCreases(int shown)
  {
    this->Change(this->PatternOutlineCreases, std::clamp(shown, 0, 1));
  }
  vtkGetMacro(PatternOutlineCreases, int);
  void SetPatternOutlineBorders(int shown)
  {
    this->Change(this->PatternOutlineBorders, std::clamp(shown, 0, 1));
  }
  vtkGetMacro(PatternOutlineBorders, int);
  ///@}

  ///@{
  /** Angle from which a bend is a crease where PatternOutlineCreases is 1, in degrees. Range 0 to
   * 180, default 40. */
  void SetPatternOutlineCreaseAngle(double angle)
  {
    this->Change(this->PatternOutlineCreaseAngle, std::clamp(angle, 0.0, 180.0));
  }
  vtkGetMacro(PatternOutlineCreaseAngle, double);
  ///@}

  ///@{
  /** Ink of the contours: AS_IN_STYLE, which follows a PatternInkColor, or 0 for
   * PatternOutlineColor. Default AS_IN_STYLE. */
  void SetPatternOutlineInk(int choice) { this->Choose(this->PatternOutlineInk, choice, 0); }
  vtkGetMacro(PatternOutlineInk, int);
  ///@}

  ///@{
  /** Contours where PatternOutlineInk asks for it, sRGB components 0 to 1; default black. */
  void SetPatternOutlineColor(double red, double green, double blue)
  {
    this->ChangeColor(this->PatternOutlineColor, red, green, blue);
  }
  vtkGetVector3Macro(PatternOutlineColor, double);
  ///@}

  ///@{
  /** Where patches come from, one of PatchesType; default AS_IN_DATA. What cannot be had, as an
   * array of fractions, is an error; the surface is then drawn with the patches of its data. */
  void SetPatternPatches(int patches)
  {
    this->ChangePatches(this->PatternPatches, std::clamp<int>(patches, AS_IN_DATA, AUTOMATIC));
  }
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
  void SetPatternNumberOfPatches(int count)
  {
    this->ChangePatches(this->PatternNumberOfPatches, std::max(count, 1));
  }
  vtkGetMacro(PatternNumberOfPatches, int);
  ///@}

  ///@{
  /** How much the turn of the surface counts against distance for AUTOMATIC, see
   * vtkSurfacePatches. Range 0 to 1e6, default 0.1. */
  void SetPatternNormalWeight(double weight)
  {
    this->ChangePatches(this->PatternNormalWeight, std::clamp(weight, 0.0, 1e6));
  }
  vtkGetMacro(PatternNormalWeight, double);
  ///@}

  ///@{
  /** Largest angle between cells that stay together for CREASES, in degrees. Range 0 to 180,
   * default 30. */
  void SetPatternCreaseAngle(double angle)
  {
    this->ChangePatches(this->PatternCreaseAngle, std::clamp(angle, 0.0, 180.0));
  }
  vtkGetMacro(PatternCreaseAngle, double);
  ///@}

  ///@{
  /** Whether blocks whose points coincide are one surface, for patches and for their blending: 0
   * (no) or 1 (yes). Default 1. */
  void SetPatternJoinBlocks(int join)
  {
    this->ChangePatches(this->PatternJoinBlocks, std::clamp(join, 0, 1));
  }
  vtkGetMacro(PatternJoinBlocks, int);
  ///@}

  ///@{
  /** How the width over which the patterns of two patches fade into each other is given:
   * vtkPatchBlendWeights' RINGS (0, PatternPatchBlend) or DISTANCE (1, PatternPatchBlendDistance).
   * Patches as in the data have the weights of the data instead. Default RINGS. */
  void SetPatternPatchBlendMode(int mode)
  {
    this->ChangePatches(this->PatternPatchBlendMode,
      std::clamp<int>(mode, vtkPatchBlendWeights::RINGS, vtkPatchBlendWeights::DISTANCE));
  }
  vtkGetMacro(PatternPatchBlendMode, int);
  ///@}

  ///@{
  /** Rings of points, on each side of a border, over which patterns fade with RINGS; 0 for sharp
   * borders. Not below 0, default 2. */
  void SetPatternPatchBlend(int rings)
  {
    this->ChangePatches(this->PatternPatchBlend, std::max(rings, 0));
  }
  vtkGetMacro(PatternPatchBlend, int);
  ///@}

  ///@{
  /** Power of the weights of patches in all layers, see vtkImagePatternLayer::SetPatchPower(): 1,
   * the default, as in the style. Range 0.1 to 1. */
  void SetPatternPatchPower(double power)
  {
    this->Change(this->PatternPatchPower, std::clamp(power, 0.1, 1.0));
  }
  vtkGetMacro(PatternPatchPower, double);
  ///@}

  ///@{
  /** Distance along the surface, on each side of a border, over which patterns fade with DISTANCE,
   * in the units of the data; 0 for sharp borders. Not below 0, default 1. */
  void SetPatternPatchBlendDistance(double distance)
  {
    this->ChangePatches(this->PatternPatchBlendDistance, std::max(distance, 0.0));
  }
  vtkGetMacro(PatternPatchBlendDistance, double);
  ///@}

  ///@{
  /** Weights on a border before they are smoothed with RINGS: vtkPatchBlendWeights' EQUAL (0) or
   * FACES (1). Default EQUAL. */
  void SetPatternBorderWeights(int weights)
  {
    this->ChangePatches(this->PatternBorderWeights,
      std::clamp<int>(weights, vtkPatchBlendWeights::EQUAL, vtkPatchBlendWeights::FACES));
  }
  vtkGetMacro(PatternBorderWeights, int);
  ///@}

  ///@{
  /** How the patterns of all layers move: AS_IN_STYLE, or vtkImagePatternLayer's SIMILARITY (0),
   * FIXED_IN_IMAGE (1), TEXTURE (2) or DYNAMIC_SOLID (3). Default AS_IN_STYLE. */
  void SetPatternMotion(int choice)
  {
    this->Choose(this->PatternMotion, choice, vtkImagePatternLayer::DYNAMIC_SOLID);
  }
  vtkGetMacro(PatternMotion, int);
  ///@}

  ///@{
  /** Period of the patterns on the surface where PatternMotion is TEXTURE or DYNAMIC_SOLID, in the
   * units of the data, or of the texture coordinates if there are some. Not below 0; 0 derives it
   * from the bounds. Default 0. */
  void SetPatternSurfacePeriod(double period)
  {
    this->Change(this->PatternSurfacePeriod, std::max(period, 0.0));
  }
  vtkGetMacro(PatternSurfacePeriod, double);
  ///@}

  ///@{
  /** How patterns remember the pictures before: AS_IN_STYLE, or vtkPatternStyle's TRACKED (0) or
   * ANCHORED (1). Default AS_IN_STYLE. */
  void SetPatternTracking(int choice)
  {
    this->Choose(this->PatternTracking, choice, vtkPatternStyle::ANCHORED);
  }
  vtkGetMacro(PatternTracking, int);
  ///@}

  /** The next picture is drawn as if it were the first one, see vtkPatternMapper::Reanchor(). */
  void Reanchor();

  /** Tells the mappers, too: time of what fades, and of whether patterns begin anew. */
  void SetUpdateTime(double time) override;

  ///@{
  /** Whether patterns keep their direction, or their size, in the image, while they still follow
   * the surface's place: AS_IN_STYLE, 0 (no) or 1 (yes). Default AS_IN_STYLE. */
  void SetPatternLockRotation(int choice) { this->Choose(this->PatternLockRotation, choice, 1); }
  vtkGetMacro(PatternLockRotation, int);
  void SetPatternLockScale(int choice) { this->Choose(this->PatternLockScale, choice, 1); }
  vtkGetMacro(PatternLockScale, int);
  ///@}

  ///@{
  /** How the marks of half the size take over while zooming: AS_IN_STYLE, or vtkImagePatternLayer's
   * AUTOMATIC_TRANSITION (0), CROSS_FADE (1) or BLEND_SCREENS (2). Default AS_IN_STYLE. */
  void SetPatternTransition(int choice)
  {
    this->Choose(this->PatternTransition, choice, vtkImagePatternLayer::BLEND_SCREENS);
  }
  vtkGetMacro(PatternTransition, int);
  ///@}

  ///@{
  /** At which pace they do so: AS_IN_STYLE, or vtkImagePatternLayer's EVEN (0) or CLASSIC (1).
   * Default AS_IN_STYLE. */
  void SetPatternPace(int choice)
  {
    this->Choose(this->PatternPace, choice, vtkImagePatternLayer::CLASSIC);
  }
  vtkGetMacro(PatternPace, int);
  ///@}

  ///@{
  /** Time that they take in all layers, in units of the data's time: 0, the default, as in the
   * style, which is by scale unless the style says otherwise. Range 0 to 1000. */
  void SetPatternTransitionTime(double time)
  {
    this->Change(this->PatternTransitionTime, std::clamp(time, 0.0, 1000.0));
  }
  vtkGetMacro(PatternTransitionTime, double);
  ///@}

  ///@{
  /** At which scales they do so in all layers: AS_IN_STYLE, or 0 for PatternTransitionRange.
   * Default AS_IN_STYLE. */
  void SetPatternTransitionScales(int choice)
  {
    this->Choose(this->PatternTransitionScales, choice, 0);
  }
  vtkGetMacro(PatternTransitionScales, int);
  ///@}

  ///@{
  /** Scales of the marks at which those of half the size begin to show and have taken over where
   * PatternTransitionScales is 0. Range 1 to 2, default (1.3, 1.7). */
  void SetPatternTransitionRange(double start, double end)
  {
    this->ChangePair(
      this->PatternTransitionRange, std::clamp(start, 1.0, 2.0), std::clamp(end, 1.0, 2.0));
  }
  vtkGetVector2Macro(PatternTransitionRange, double);
  ///@}

  ///@{
  /** Which parts of the surface count most for the motion: AS_IN_STYLE, or vtkPatternStyle's
   * SYMMETRIC (0), CLASSIC (1), UNWEIGHTED (2) or PERCEPTUAL (3). Default AS_IN_STYLE. */
  void SetPatternWeights(int choice)
  {
    this->Choose(this->PatternWeights, choice, vtkPatternStyle::PERCEPTUAL);
  }
  vtkGetMacro(PatternWeights, int);
  ///@}

  ///@{
  /** Features that count where PatternWeights is PERCEPTUAL: vtkPatternStyle's CURVATURE (0), TONE
   * (1) or ARRAY (2, PatternFeatureArray). Default CURVATURE. */
  void SetPatternFeatures(int source)
  {
    this->Change(this->PatternFeatures,
      std::clamp<int>(source, vtkPatternStyle::CURVATURE, vtkPatternStyle::ARRAY));
  }
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
  /** Samples of every patch that the motion is fitted to: 0 as in the style, else 2 to 100000.
   * Default 0. */
  void SetPatternSamplesPerPatch(int samples)
  {
    this->Change(this->PatternSamplesPerPatch, std::clamp(samples, 0, 100000));
  }
  vtkGetMacro(PatternSamplesPerPatch, int);
  ///@}

  ///@{
  /** Point array with the velocity of the surface, see vtkPatternMapper::SetVelocityArrayName();
   * "None" for none, the default. */
  void SetPatternVelocityArray(const char* name);
  const char* GetPatternVelocityArray();
  ///@}

  ///@{
  /** What sums up the noise of styles that have some: vtkPatternMapper's AUTOMATIC (0), CPU (1),
   * GATHER (2), COMPUTE (3) or SPLAT (4), in pictures of full and of low detail. Default AUTOMATIC.
   */
  void SetPatternBackEnd(int backEnd);
  int GetPatternBackEnd();
  ///@}

  ///@{
  /** Whether the view has a legend of the patterns, see vtkPatternLegendActor; default 0. */
  void SetPatternLegend(int shown);
  int GetPatternLegend();
  ///@}

  ///@{
  /** Lower left corner and size of the legend, as parts of the view; the mouse changes them, too.
   * Defaults (0.82, 0.2) and (0.16, 0.6). */
  void SetPatternLegendPosition(double x, double y);
  double* GetPatternLegendPosition() VTK_SIZEHINT(2);
  void SetPatternLegendSize(double width, double height);
  double* GetPatternLegendSize() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /** Title of the legend; empty, the default: the name of the array of the tone. */
  void SetPatternLegendTitle(const char* title);
  const char* GetPatternLegendTitle();
  ///@}

  ///@{
  /** vtkPatternLegendActor's HORIZONTAL (0) or VERTICAL (1, the default); its modes, AUTOMATIC (0,
   * the default) to CATEGORIES (3); number of even swatches, 0 to 64, 0 (default): those of the
   * tone. */
  void SetPatternLegendOrientation(int orientation);
  int GetPatternLegendOrientation();
  void SetPatternLegendMode(int mode);
  int GetPatternLegendMode();
  void SetPatternLegendSteps(int steps);
  int GetPatternLegendSteps();
  ///@}

  ///@{
  /** How many numbers there are at most beside a continuous swatch, 0 to 64, default 5; and their
   * format, as printf takes it for one double, default "%.4g". */
  void SetPatternLegendLabels(int labels);
  int GetPatternLegendLabels();
  void SetPatternLegendLabelFormat(const char* format);
  const char* GetPatternLegendLabelFormat();
  ///@}

  ///@{
  /** Whether there is a swatch for data that is not a number; default 0. */
  void SetPatternLegendNan(int shown);
  int GetPatternLegendNan();
  ///@}

  ///@{
  /** Size of swatches across their row, pixels, 4 to 1000, default 36; sizes of the fonts, points,
   * 4 to 200, default 14 and 12. */
  void SetPatternLegendThickness(int pixels);
  int GetPatternLegendThickness();
  void SetPatternLegendTitleFontSize(int points);
  int GetPatternLegendTitleFontSize();
  void SetPatternLegendLabelFontSize(int points);
  int GetPatternLegendLabelFontSize();
  ///@}

  void SetVisibility(bool visible) override;

protected:
  vtkPatternRepresentation();
  ~vtkPatternRepresentation() override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void UpdateColoringParameters() override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  /** Replaces in a style what the properties ask for. */
  virtual void AdjustStyle(vtkPatternStyle* style);

  /** Makes the style anew if a property was changed; otherwise that is done before the next
   * picture. */
  void UpdateStyle();

  /** The style that is drawn, as the last UpdateStyle() has left it; always the same object. */
  vtkPatternStyle* GetStyle();

  /** What must be saved before the style that is drawn can be, in a sentence; empty where all is in
   * files. */
  virtual std::string GetUnsaved() { return {}; }

  // Calls the function with every layer of a type.
  template <class Layer, class Function>
  static void ForEachLayer(vtkPatternStyle* style, const Function& function)
  {
    for (int i = 0; i < style->GetNumberOfLayers(); ++i)
    {
      if (auto* layer = Layer::SafeDownCast(style->GetLayer(i)))
      {
        function(layer);
      }
    }
  }

  // What setters of the style have in common.
  template <class T>
  void Change(T& member, const T& value)
  {
    if (member != value)
    {
      member = value;
      this->StyleChanged = true;
    }
  }
  void Choose(int& member, int choice, int last)
  {
    this->Change(member, std::clamp<int>(choice, AS_IN_STYLE, last));
  }
  void ChangePair(double member[2], double first, double second)
  {
    this->Change(member[0], first);
    this->Change(member[1], second);
  }
  void ChangeColor(double member[3], double red, double green, double blue)
  {
    this->Change(member[0], std::clamp(red, 0.0, 1.0));
    this->Change(member[1], std::clamp(green, 0.0, 1.0));
    this->Change(member[2], std::clamp(blue, 0.0, 1.0));
  }

private:
  vtkPatternRepresentation(const vtkPatternRepresentation&) = delete;
  void operator=(const vtkPatternRepresentation&) = delete;

  template <class T>
  void ChangePatches(T& member, const T& value)
  {
    if (member != value)
    {
      member = value;
      this->UpdatePatches();
      this->MarkModified();
    }
  }

  void UpdatePatches();
  void SendWhole(vtkInformation* inInfo);
  vtkDataObject* FindWhole(vtkInformation* inInfo);
  void UpdateController();
  void LoadStyle();
  void AdjustOutline(vtkPatternStyle* style);
  void AdjustMotion(vtkPatternStyle* style);
  void AdjustInk(vtkPatternLayer* layer);
  void AdjustTone(vtkPatternTone* tone);
  void AdjustSource(vtkPatternTone* tone);
  void AdjustMarks(vtkImagePatternLayer* layer, vtkImageData* picture);
  void AdjustKind(vtkImagePatternLayer* layer, vtkImageData* picture);
  void AdjustBrush(vtkImagePatternLayer* layer);
  void AdjustPaperGrain(vtkImagePatternLayer* layer);
  void AdjustMarksMotion(vtkImagePatternLayer* layer);
  void AdjustNoise(vtkNoiseLayer* layer);
  vtkSmartPointer<vtkImageData> ReadPicture();
  std::unique_ptr<PatternLegendPlace> MakeLegend();
  vtkPatternLegendActor* GetLegend();

  bool StyleChanged = true;
  vtkSmartPointer<vtkPatternStyle> Loaded; // as it is without the properties
  std::string LoadedName;
  std::unique_ptr<RepresentationFile> LoadedFile;
  vtkSmartPointer<vtkImageData> Picture;
  std::unique_ptr<RepresentationFile> PictureFile;
  std::string PatternStyle;
  std::string PatternStyleFile;
  std::string PatternStyleSaveName;
  double PatternScale = 1.0;
  double PatternAngle = 0.0;
  int PatternInk = AS_IN_STYLE;
  double PatternInkColor[3] = { 0.0, 0.0, 0.0 };
  double PatternInkOpacity = 1.0;
  int PatternBlendMode = AS_IN_STYLE;
  int PatternPaper = AS_IN_STYLE;
  double PatternPaperColor[3] = { 1.0, 1.0, 1.0 };

  int PatternTone = AS_IN_STYLE;
  std::string PatternToneArrayName;
  int PatternToneAssociation = 0;
  int PatternToneComponent = 0;
  double PatternToneRange[2] = { 0.0, 1.0 };
  double PatternToneConstant = 0.5;
  int PatternToneLight = 0;
  int PatternHighlightLight = -1;
  double PatternHighlightPower = 0.0;
  int PatternToneInvert = AS_IN_STYLE;
  double PatternToneGamma = 1.0;
  int PatternToneRemap = AS_IN_STYLE;
  int PatternToneSteps = 3;
  double PatternToneRemapRange[2] = { 0.25, 0.75 };
  double PatternBlackGeneration = 1.0;
  int PatternToneCorrection = AS_IN_STYLE;

  int PatternKind = AS_IN_STYLE;
  std::string PatternImageFile;
  double PatternIrregularity = 0.0;
  int PatternDensities = 0;
  int PatternBrush = AS_IN_STYLE;
  double PatternDabLength = 2.6;
  double PatternDabJitter = 18.0;
  double PatternDabDensity = 3.0;
  double PatternBristles = 0.6;
  double PatternBump = 0.5;
  double PatternColorVariation = 0.15;
  int PatternPaperGrain = AS_IN_STYLE;
  double PatternPaperContrast = 0.5;
  double PatternPaperScale = 1.0;
  int PatternSeed = 0;

  int PatternOutline = AS_IN_STYLE;
  double PatternOutlineWidth = 1.5;
  int PatternOutlineSilhouette = 1;
  int PatternOutlineCreases = 1;
  int PatternOutlineBorders = 1;
  double PatternOutlineCreaseAngle = 40.0;
  int PatternOutlineInk = AS_IN_STYLE;
  double PatternOutlineColor[3] = { 0.0, 0.0, 0.0 };

  vtkSmartPointer<vtkWholeSurface> Whole;
  vtkSmartPointer<vtkMultiBlockDataSet> SentWhole;
  vtkMTimeType SentTime = 0;
  vtkSmartPointer<vtkRepresentationPatches> Patches;
  int PatternPatches = AS_IN_DATA;
  std::string PatternPatchArrayName;
  int PatternNumberOfPatches = 16;
  double PatternNormalWeight = 0.1;
  double PatternCreaseAngle = 30.0;
  int PatternJoinBlocks = 1;
  int PatternPatchBlendMode = vtkPatchBlendWeights::RINGS;
  int PatternPatchBlend = 2;
  double PatternPatchPower = 1.0;
  double PatternPatchBlendDistance = 1.0;
  int PatternBorderWeights = vtkPatchBlendWeights::EQUAL;

  int PatternMotion = AS_IN_STYLE;
  double PatternSurfacePeriod = 0.0;
  int PatternTracking = AS_IN_STYLE;
  int PatternLockRotation = AS_IN_STYLE;
  int PatternLockScale = AS_IN_STYLE;
  int PatternTransition = AS_IN_STYLE;
  int PatternPace = AS_IN_STYLE;
  double PatternTransitionTime = 0.0;
  int PatternTransitionScales = AS_IN_STYLE;
  double PatternTransitionRange[2] = { 1.3, 1.7 };
  int PatternWeights = AS_IN_STYLE;
  int PatternFeatures = vtkPatternStyle::CURVATURE;
  std::string PatternFeatureArrayName;
  int PatternSamplesPerPatch = 0;
  std::string PatternVelocityArray = "None";

  std::unique_ptr<PatternLegendPlace> Legend;
  std::string LegendText; // that a getter hands out
};

#endif

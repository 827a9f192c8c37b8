// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternStyle
 * @brief what a surface is drawn with: paper, a stack of layers and an outline
 *
 * A style holds parameters alone and can serve any number of mappers. A new one is bare paper;
 * LoadPreset, LoadFile and FromJson fill it, replacing everything but PixelScale and FinalQuality.
 *
 * A style as JSON: {"hachure": 1, "paper": {...}, "outline": {...}, "tracking": {...}, "layers":
 * [{"type": "image", "enabled": true, "seed": 1, "field": {...}, "tone": {...}, "ink": {...}}]}.
 * Keys are the names of the setters without the name of their group: PaperColor is "color" in
 * "paper". Absent keys mean the defaults; unknown ones are errors. Values of enumerations are
 * their names ("crossHatch"); colours are "#rrggbb", or [r, g, b] from 0 to 1 where 8 bits do not
 * suffice; lengths are {"px": 8} or {"mm": 0.6, "dpi": 300}, with one dpi in the whole style,
 * which "dotsPerInch" in "paper" states too.
 *
 * Setters clamp to the range they state; constants are members of this class.
 *
 * @sa vtkPatternMapper vtkPatternLayer
 */

#ifndef vtkPatternStyle_h
#define vtkPatternStyle_h

#include "HachureRenderingModule.h"
#include "vtkObject.h"
#include "vtkPatternLayer.h" // For the layers
#include "vtkSmartPointer.h" // For the layers

#include <string>
#include <vector>

class HACHURERENDERING_EXPORT vtkPatternStyle : public vtkObject
{
public:
  static vtkPatternStyle* New();
  vtkTypeMacro(vtkPatternStyle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What the paper shows: one colour, the lit surface, or the surface's colours without light.
   * NO_PAPER: marks and outline alone are drawn, and hide what is behind them; between them one
   * sees what was drawn before, and what the surface hides of itself stays hidden. Inks mix with
   * the background in display-referred colours there. */
  enum PaperSourceType
  {
    CONSTANT = 0,
    SURFACE = 1,
    FLAT = 2,
    NO_PAPER = 3
  };

  /** TRACKED: patterns follow from frame to frame, by what was visible. ANCHORED: a frame depends
   * on mesh, camera and style alone, whatever was drawn before. */
  enum TrackingModeType
  {
    TRACKED = 0,
    ANCHORED = 1
  };

  /** Weights of the samples in the fit of a step. SYMMETRIC: geometric mean of both frames, exact
   * there and back. CLASSIC: those of the current frame (Breslav et al. 2007). UNWEIGHTED: 1.
   * PERCEPTUAL: as SYMMETRIC, times the strength of the features around the sample, so that the
   * pattern slides least where sliding is noticed. */
  enum WeightSchemeType
  {
    SYMMETRIC = 0,
    CLASSIC = 1,
    UNWEIGHTED = 2,
    PERCEPTUAL = 3
  };

  /** Features of PERCEPTUAL weights, relative to the mean of the patch; every sample counts at
   * least 1 % of that. CURVATURE: how much the normals around the sample vary, when samples are
   * made. TONE: how much the light's tone varies around it, by the directions of the lights that
   * are on, without their cones and attenuation. ARRAY: FeatureArrayName. */
  enum FeatureSourceType
  {
    CURVATURE = 0,
    TONE = 1,
    ARRAY = 2
  };

  ///@{
  /** The layers, drawn in the order of their index, 0 first. A layer can be in a style once; null,
   * a layer that is there already and an index outside 0 to GetNumberOfLayers() are refused with
   * an error. GetLayer gives null, after an error, for an index that does not exist. */
  virtual void AddLayer(vtkPatternLayer* layer);
  virtual void InsertLayer(int index, vtkPatternLayer* layer);
  virtual void RemoveLayer(vtkPatternLayer* layer);
  virtual void RemoveAllLayers();
  virtual vtkPatternLayer* GetLayer(int index);
  virtual int GetNumberOfLayers();
  ///@}

  ///@{
  /** What the paper shows, one of PaperSourceType; default CONSTANT. */
  vtkSetClampMacro(PaperSource, int, CONSTANT, NO_PAPER);
  vtkGetMacro(PaperSource, int);
  ///@}

  ///@{
  /** Colour of the paper for CONSTANT, sRGB components 0 to 1; default white. */
  virtual void SetPaperColor(double red, double green, double blue);
  virtual void SetPaperColor(const double color[3]);
  vtkGetVector3Macro(PaperColor, double);
  ///@}

  ///@{
  /** Logical pixels per inch that turn millimetres into pixels. Range 1 to 10000, default 96. */
  vtkSetClampMacro(DotsPerInch, double, 1.0, 10000.0);
  vtkGetMacro(DotsPerInch, double);
  ///@}

  /** A length in logical pixels; unit is one of vtkPatternLayer::LengthUnit. */
  virtual double GetLengthInPixels(double length, int unit);

  ///@{
  /** Whether lines are drawn where the surface ends or bends; default off. */
  vtkSetMacro(Outline, bool);
  vtkGetMacro(Outline, bool);
  vtkBooleanMacro(Outline, bool);
  ///@}

  ///@{
  /** Colour of the outline, sRGB components 0 to 1; default black. */
  virtual void SetOutlineColor(double red, double green, double blue);
  virtual void SetOutlineColor(const double color[3]);
  vtkGetVector3Macro(OutlineColor, double);
  ///@}

  ///@{
  /** Width of the outline in OutlineWidthUnit. Range 0 to 100, default 1.5. */
  vtkSetClampMacro(OutlineWidth, double, 0.0, 100.0);
  vtkGetMacro(OutlineWidth, double);
  ///@}

  ///@{
  /** Unit of OutlineWidth, vtkPatternLayer::PIXELS or MILLIMETRES; default PIXELS. */
  vtkSetClampMacro(OutlineWidthUnit, int, vtkPatternLayer::PIXELS, vtkPatternLayer::MILLIMETRES);
  vtkGetMacro(OutlineWidthUnit, int);
  ///@}

  ///@{
  /** Which lines the outline has: where the surface turns away, where it bends by more than
   * OutlineCreaseAngle, and where it has an open edge. All on by default. */
  vtkSetMacro(OutlineSilhouette, bool);
  vtkGetMacro(OutlineSilhouette, bool);
  vtkBooleanMacro(OutlineSilhouette, bool);
  vtkSetMacro(OutlineCreases, bool);
  vtkGetMacro(OutlineCreases, bool);
  vtkBooleanMacro(OutlineCreases, bool);
  vtkSetMacro(OutlineBorders, bool);
  vtkGetMacro(OutlineBorders, bool);
  vtkBooleanMacro(OutlineBorders, bool);
  ///@}

  ///@{
  /** Angle between the normals on both sides from which a bend is a crease, in degrees. Range 0 to
   * 180, default 40. */
  vtkSetClampMacro(OutlineCreaseAngle, double, 0.0, 180.0);
  vtkGetMacro(OutlineCreaseAngle, double);
  ///@}

  ///@{
  /** How patterns remember the frames before, one of TrackingModeType; default TRACKED. */
  vtkSetClampMacro(TrackingMode, int, TRACKED, ANCHORED);
  vtkGetMacro(TrackingMode, int);
  ///@}

  ///@{
  /** Weights of the samples, one of WeightSchemeType; default SYMMETRIC. */
  vtkSetClampMacro(WeightScheme, int, SYMMETRIC, PERCEPTUAL);
  vtkGetMacro(WeightScheme, int);
  ///@}

  ///@{
  /** Features for PERCEPTUAL, one of FeatureSourceType; default CURVATURE. */
  vtkSetClampMacro(FeatureSource, int, CURVATURE, ARRAY);
  vtkGetMacro(FeatureSource, int);
  ///@}

  ///@{
  /** Point or else cell array with one component for ARRAY: finite numbers of 0 or more, in any
   * unit. An error names an array that is not so; weights are then SYMMETRIC. Default empty. */
  virtual void SetFeatureArrayName(const std::string& name);
  virtual std::string GetFeatureArrayName();
  ///@}

  ///@{
  /** Whether the pattern keeps its direction in the image, its size in the image, whatever the
   * surface does; it still follows the surface's place. Both off by default. */
  vtkSetMacro(LockRotation, bool);
  vtkGetMacro(LockRotation, bool);
  vtkBooleanMacro(LockRotation, bool);
  vtkSetMacro(LockScale, bool);
  vtkGetMacro(LockScale, bool);
  vtkBooleanMacro(LockScale, bool);
  ///@}

  ///@{
  /** Surface samples per patch that the motion is fitted to. Range 2 to 100000, default 500. */
  vtkSetClampMacro(SamplesPerPatch, int, 2, 100000);
  vtkGetMacro(SamplesPerPatch, int);
  ///@}

  ///@{
  /** Framebuffer pixels per logical pixel, for supersampled or high-resolution output. It belongs
   * to the output, so that no style file holds it. Range 0.125 to 64, default 1. */
  vtkSetClampMacro(PixelScale, double, 0.125, 64.0);
  vtkGetMacro(PixelScale, double);
  ///@}

  ///@{
  /** Whether to draw for a picture that lasts rather than for interaction: the kernels of noises
   * are hidden by every pixel that hides a part of them, not by samples. Belongs to the output as
   * PixelScale, which a final picture should raise as well. Default off. */
  vtkSetMacro(FinalQuality, bool);
  vtkGetMacro(FinalQuality, bool);
  vtkBooleanMacro(FinalQuality, bool);
  ///@}

  ///@{
  /** The built-in styles, in their stable order; Presets/README.md tells what they look like. The
   * name is null for an index that does not exist. */
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  ///@}

  /** Name of the preset that programs start with: "cross-hatch". */
  static const char* GetDefaultPresetName();

  /** Turns this style into a preset. Returns false, after an error that lists the names, when
   * there is none of that name; the style is then unchanged. */
  virtual bool LoadPreset(const std::string& name);

  ///@{
  /** Reads the style from JSON. Returns false, after an error with the path in the JSON and the
   * reason, when anything is wrong with it; the style is then unchanged. Files of images are
   * looked for relative to the style file, or to the working directory for FromJson. */
  virtual bool FromJson(const std::string& json);
  virtual bool LoadFile(const std::string& fileName);
  ///@}

  /** Becomes what another style is, but for PixelScale and FinalQuality. Layers stay the objects
   * that they are where the other style has one of the same type in their place, and nothing is
   * modified that is equal already, so that what was made of the rest is kept: noise and stipples
   * of earlier pictures, the state of transitions, the colours of views. Images and views are
   * shared. Null is refused with an error. */
  virtual void CopyFrom(vtkPatternStyle* other);

  ///@{
  /** Writes every parameter but PixelScale and FinalQuality as JSON that reads back to the same
   * values. The text is empty, or false is returned, after an error, when an image has no file or
   * the file cannot be written. SaveFile names files of images relative to the style file. */
  virtual std::string ToJson();
  virtual bool SaveFile(const std::string& fileName);
  ///@}

  /** Latest change of the style, its layers or anything that they refer to. */
  vtkMTimeType GetMTime() override;

protected:
  vtkPatternStyle();
  ~vtkPatternStyle() override;

private:
  vtkPatternStyle(const vtkPatternStyle&) = delete;
  void operator=(const vtkPatternStyle&) = delete;

  std::vector<vtkSmartPointer<vtkPatternLayer>> Layers;
  int PaperSource = CONSTANT;
  double PaperColor[3] = { 1.0, 1.0, 1.0 };
  double DotsPerInch = 96.0;
  bool Outline = false;
  double OutlineColor[3] = { 0.0, 0.0, 0.0 };
  double OutlineWidth = 1.5;
  int OutlineWidthUnit = vtkPatternLayer::PIXELS;
  bool OutlineSilhouette = true;
  bool OutlineCreases = true;
  bool OutlineBorders = true;
  double OutlineCreaseAngle = 40.0;
  int TrackingMode = TRACKED;
  int WeightScheme = SYMMETRIC;
  int FeatureSource = CURVATURE;
  std::string FeatureArrayName;
  bool LockRotation = false;
  bool LockScale = false;
  int SamplesPerPatch = 500;
  double PixelScale = 1.0;
  bool FinalQuality = false;
};

#endif

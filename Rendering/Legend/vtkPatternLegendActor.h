// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternLegendActor
 * @brief tells which tone of a style stands for which value, as vtkScalarBarActor does for colours
 *
 * A row of swatches in the marks of a style, with labels and a title, in the box of Position and
 * Position2 (lower left corner and size, normalised viewport coordinates; default (0.82, 0.1) and
 * (0.16, 0.8)). Swatches are drawn by vtkPatternMapper itself: the same layers, paper and inks, the
 * tones of the same values by the same range and curve, marks of the same size as on a surface that
 * faces the viewer, with as many pixels for each. They have no outline.
 *
 * With SetSurface, style and colours are those of an actor that a vtkPatternMapper draws, also when
 * they change; else SetStyle, SetLookupTable and SetSurfaceColor tell them.
 *
 * What the values are is up to the tone that is shown. Array: the array's values, over the range of
 * the tone, or of all tones of the array together. Colour (luminance, and the separations of a
 * print): the values of the lookup table; without one, as light. Light: from 0, fully lit, to 1,
 * dark; ends are labelled LowLabel and HighLabel. Layers of other tones are drawn as on a fully lit
 * surface without highlights, those of other arrays as at the beginning of their range. Layers of
 * views are left out, since their colours have no value. Motion on the surface with a period in
 * units of the model has the size of the layer here.
 *
 * Errors, each reported once until it changes: neither style nor surface; no layer with a tone that
 * can be shown; an empty range; a format that takes no number. Where the box has no room for
 * swatches there are none.
 *
 * Setters clamp to the range they state; constants are members of this class.
 *
 * @sa vtkPatternLegendRepresentation vtkPatternMapper
 */
#ifndef vtkPatternLegendActor_h
#define vtkPatternLegendActor_h

#include "HachureRenderingModule.h"
#include "vtkActor2D.h"
#include "vtkSmartPointer.h" // For what is owned

#include <memory> // For the hidden parts
#include <string> // For texts

#ifndef __VTK_WRAP__
namespace hachure
{
struct LegendSurface;
}
#endif

class vtkActor;
class vtkPatternStyle;
class vtkScalarsToColors;
class vtkTextProperty;

class HACHURERENDERING_EXPORT vtkPatternLegendActor : public vtkActor2D
{
public:
  static vtkPatternLegendActor* New();
  vtkTypeMacro(vtkPatternLegendActor, vtkActor2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** An actor whose mapper is a vtkPatternMapper: style, colours and lookup table are taken from
   * it where they are not set here. Default null. */
  virtual void SetSurface(vtkActor* surface);
  virtual vtkActor* GetSurface();
  ///@}

  ///@{
  /** The style that is shown. Default null: that of the surface. */
  virtual void SetStyle(vtkPatternStyle* style);
  virtual vtkPatternStyle* GetStyle();
  ///@}

  ///@{
  /** Colours of the surface by the values that are shown, for paper, inks and tones that take them,
   * with the colour where data has no number. Default null: those of the surface, if the array of
   * the tone is the one that colours it; otherwise there is one colour. */
  virtual void SetLookupTable(vtkScalarsToColors* table);
  virtual vtkScalarsToColors* GetLookupTable();
  ///@}

  ///@{
  /** Colour of a surface without lookup table, sRGB components 0 to 1; default white. Where there
   * is a surface, its own colour is taken. */
  virtual void SetSurfaceColor(double red, double green, double blue);
  vtkGetVector3Macro(SurfaceColor, double);
  ///@}

  ///@{
  /** The layer of the style whose tone is shown, counted from 0. Default -1: the first one with a
   * tone from an array; where there is none, from colours, light, highlights. One that does not
   * exist is an error when drawn. */
  vtkSetClampMacro(Layer, int, -1, VTK_INT_MAX);
  vtkGetMacro(Layer, int);
  ///@}

  /** CONTINUOUS: one swatch that goes through all values. STEPS: even ones, side by side.
   * CATEGORIES: even ones with names, apart. AUTOMATIC: categories where they are added here or the
   * lookup table has annotations and IndexedLookup; steps where the tone has the remap STEPS;
   * otherwise continuous. */
  enum ModeType
  {
    AUTOMATIC = 0,
    CONTINUOUS = 1,
    STEPS = 2,
    CATEGORIES = 3
  };

  ///@{
  /** One of ModeType; default AUTOMATIC. */
  vtkSetClampMacro(Mode, int, AUTOMATIC, CATEGORIES);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /** Number of even swatches of STEPS, each labelled with its value, the ends of the range among
   * them. Range 0 to 64; default 0: the steps of the tone, labelled where they meet, or 5 where it
   * has none. */
  vtkSetClampMacro(NumberOfSteps, int, 0, 64);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /** Values of the first and last swatch, of CONTINUOUS and STEPS. Default (0, 0): equal ends mean
   * the range of the tone. */
  vtkSetVector2Macro(ValueRange, double);
  vtkGetVector2Macro(ValueRange, double);
  ///@}

  ///@{
  /** Categories, in the order of their swatches: a value and its name. */
  virtual void AddCategory(double value, const std::string& name);
  virtual void RemoveAllCategories();
  virtual int GetNumberOfCategories();
  ///@}

  ///@{
  /** Whether there is a swatch for data that is not a number, apart from the others, and its label;
   * default off, "NaN". Tones of light have none. */
  vtkSetMacro(DrawNanSwatch, bool);
  vtkGetMacro(DrawNanSwatch, bool);
  vtkBooleanMacro(DrawNanSwatch, bool);
  vtkSetMacro(NanLabel, std::string);
  vtkGetMacro(NanLabel, std::string);
  ///@}

  enum OrientationType
  {
    HORIZONTAL = 0,
    VERTICAL = 1
  };

  ///@{
  /** One of OrientationType; default VERTICAL: high values are above, labels to the right. */
  vtkSetClampMacro(Orientation, int, HORIZONTAL, VERTICAL);
  vtkGetMacro(Orientation, int);
  ///@}

  ///@{
  /** Size of swatches across their row, logical pixels; not more than the box has. Range 4 to 1000,
   * default 36. */
  vtkSetClampMacro(SwatchThickness, int, 4, 1000);
  vtkGetMacro(SwatchThickness, int);
  ///@}

  ///@{
  /** Whether swatches have a thin frame; default on. */
  vtkSetMacro(DrawFrame, bool);
  vtkGetMacro(DrawFrame, bool);
  vtkBooleanMacro(DrawFrame, bool);
  ///@}

  ///@{
  /** Title above the swatches. Default empty: the name of the array, if one is shown. DrawTitle:
   * whether there is one; default on. */
  vtkSetMacro(Title, std::string);
  vtkGetMacro(Title, std::string);
  vtkSetMacro(DrawTitle, bool);
  vtkGetMacro(DrawTitle, bool);
  vtkBooleanMacro(DrawTitle, bool);
  ///@}

  ///@{
  /** Labels where light or highlights begin (0) and end (1). Default empty: "light" and "dark", or
   * "dull" and "shining". */
  vtkSetMacro(LowLabel, std::string);
  vtkGetMacro(LowLabel, std::string);
  vtkSetMacro(HighLabel, std::string);
  vtkGetMacro(HighLabel, std::string);
  ///@}

  ///@{
  /** How many numbers there are at most beside a continuous swatch; fewer where there is no room.
   * Range 0 to 64, default 5. RoundLabels: whether they stand at round values; otherwise they are
   * at equal distances from the first value to the last. Default on. */
  vtkSetClampMacro(NumberOfLabels, int, 0, 64);
  vtkGetMacro(NumberOfLabels, int);
  vtkSetMacro(RoundLabels, bool);
  vtkGetMacro(RoundLabels, bool);
  vtkBooleanMacro(RoundLabels, bool);
  ///@}

  ///@{
  /** Format of numbers, as printf takes it for one double. Default "%.4g". */
  vtkSetMacro(LabelFormat, std::string);
  vtkGetMacro(LabelFormat, std::string);
  ///@}

  ///@{
  /** Fonts of the title (default bold, 14 points) and the labels (12 points). Their colours count
   * while AutomaticColor is off. */
  virtual void SetTitleTextProperty(vtkTextProperty* property);
  virtual vtkTextProperty* GetTitleTextProperty();
  virtual void SetLabelTextProperty(vtkTextProperty* property);
  virtual vtkTextProperty* GetLabelTextProperty();
  ///@}

  ///@{
  /** Whether texts and frames are black or white, whichever is seen better on the renderer's
   * background; default on. Frames have the colour of labels. */
  vtkSetMacro(AutomaticColor, bool);
  vtkGetMacro(AutomaticColor, bool);
  vtkBooleanMacro(AutomaticColor, bool);
  ///@}

  ///@{
  /** The swatches of the last picture: their number; of each the first and last value, and x, y,
   * width and height in pixels of the viewport, y up. False where there is none of that index. */
  virtual int GetNumberOfSwatches();
  virtual bool GetSwatch(int index, double values[2], int rectangle[4]);
  ///@}

  ///@{
  /** The labels of the last picture: their number, the text of each, and where it stands along the
   * row of swatches, from 0 to 1. Empty and 0 where there is none of that index. */
  virtual int GetNumberOfShownLabels();
  virtual std::string GetShownLabel(int index);
  virtual double GetShownLabelPlace(int index);
  ///@}

  /** The tone, from 0 to 1, that the layer which is shown draws at a value; -1, after an error,
   * where no layer can be shown. */
  virtual double GetToneAt(double value);

  int RenderOverlay(vtkViewport* viewport) override;
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkPatternLegendActor();
  ~vtkPatternLegendActor() override;

private:
  vtkPatternLegendActor(const vtkPatternLegendActor&) = delete;
  void operator=(const vtkPatternLegendActor&) = delete;

  struct Internals;
  struct Drawing;
  hachure::LegendSurface SurfaceToShow();
  void Report(const std::string& error);
  void CollectSwatches(Drawing& drawing);
  void CollectLabels(Drawing& drawing);
  void LabelValues(Drawing& drawing);
  void LabelEnds(Drawing& drawing);
  void LabelSwatches(Drawing& drawing);
  void LayOut(Drawing& drawing);
  bool DrawSwatches(Drawing& drawing);
  void DrawLines(Drawing& drawing);
  void DrawTexts(Drawing& drawing);
  std::string TitleText(const Drawing& drawing);
  std::string Number(double value);

  vtkSmartPointer<vtkActor> Surface;
  vtkSmartPointer<vtkPatternStyle> Style;
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  double SurfaceColor[3] = { 1.0, 1.0, 1.0 };
  int Layer = -1;
  int Mode = AUTOMATIC;
  int NumberOfSteps = 0;
  double ValueRange[2] = { 0.0, 0.0 };
  bool DrawNanSwatch = false;
  std::string NanLabel = "NaN";
  int Orientation = VERTICAL;
  int SwatchThickness = 36;
  bool DrawFrame = true;
  std::string Title;
  bool DrawTitle = true;
  std::string LowLabel;
  std::string HighLabel;
  int NumberOfLabels = 5;
  bool RoundLabels = true;
  std::string LabelFormat = "%.4g";
  vtkSmartPointer<vtkTextProperty> TitleTextProperty;
  vtkSmartPointer<vtkTextProperty> LabelTextProperty;
  bool AutomaticColor = true;
  std::unique_ptr<Internals> Internal;
};

#endif

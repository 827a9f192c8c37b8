// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a legend says of a style: the values that its swatches stand for, and their labels.
 */
#ifndef hachure_PatternLegendKey_h
#define hachure_PatternLegendKey_h

#include <array>
#include <string>
#include <vector>

class vtkPatternLayer;
class vtkPatternStyle;
class vtkPatternTone;
class vtkScalarsToColors;

namespace hachure
{

/// What the values of a legend are: those of the array of a tone; those that the colours of the
/// surface stand for; how dark it is, or how much it shines, from 0 to 1; nothing.
enum class LegendAxis
{
  Array,
  Color,
  Light,
  Highlight,
  Even
};

/// A surface with a style.
struct LegendSurface
{
  vtkPatternStyle* style = nullptr;
  int layer = -1;                       // whose tone is shown; -1: of the first that has one
  vtkScalarsToColors* colors = nullptr; // null: color everywhere
  bool colorsAnyArray = true;           // of the tone; else that of this name alone
  std::string colorArray;
  std::array<double, 3> color = { 1.0, 1.0, 1.0 };
  std::array<double, 2> range = { 0.0, 0.0 }; // of values; equal: that of the style
};

/// A swatch goes from one value to another, which are the same for an even one.
struct LegendSwatch
{
  double first = 0.0;
  double last = 0.0;
  std::string name; // of a category
};

/// A text beside the swatches, at a place from 0 to 1 along all of them.
struct LegendLabel
{
  double place = 0.0;
  std::string text;
};

class PatternLegendKey
{
public:
  /// Throws std::invalid_argument where the style has nothing to show, and says why.
  explicit PatternLegendKey(const LegendSurface& surface);

  LegendAxis axis() const { return this->Axis; }
  /// Ascending.
  const std::array<double, 2>& range() const { return this->Range; }
  /// The layers that a legend draws: all but those of views, whose colours have no value.
  std::vector<vtkPatternLayer*> layers() const;
  /// Of the surface; null: one colour.
  vtkScalarsToColors* colors() const { return this->Surface.colors; }
  /// Whether they change with the values.
  bool colorsFollow() const;
  /// Name of the array whose values are shown, empty where it is none.
  std::string arrayName() const;

  /// Colour of the surface at a value, sRGB, as it is lit; not lit under flat paper.
  std::array<double, 3> colorAt(double value) const;
  /// What the array that stands in for a tone (vtkPatternToneChannels) has at a value.
  double standInAt(vtkPatternTone* tone, double value) const;
  /// The tone of the layer that is shown, after its curve.
  double toneAt(double value) const;

  /// Whether the surface has colours of categories with names, which the style shows.
  bool hasColorCategories() const;
  std::vector<LegendSwatch> colorCategories() const;
  /// Values where the tone, remapped to flat steps, steps, and both ends of the range; empty where
  /// it is not.
  std::vector<double> toneSteps() const;

private:
  bool ShowsColors() const;
  double LightAt(double value) const;
  void ChooseLayer();
  void ChooseRange();

  LegendSurface Surface;
  vtkPatternLayer* Layer = nullptr;
  LegendAxis Axis = LegendAxis::Even;
  std::array<double, 2> Range = { 0.0, 1.0 };
};

/// About `count` round values within a range, ascending; none where count is below 1.
std::vector<double> roundValues(const std::array<double, 2>& range, int count);
/// `count` values at equal distances, ends included.
std::vector<double> evenValues(const std::array<double, 2>& range, int count);

/// Whether printf takes a format for one double and nothing else.
bool isNumberFormat(const std::string& format);
std::string numberText(const std::string& format, double value);

} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: PatternLegendKey.h

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternLegendKey.h"

#include "vtkPatternLayer.h"
#include "vtkPatternStyle.h"
#include "vtkPatternTone.h"
#include "vtkPatternToneCurve.h"
#include "vtkScalarsToColors.h"
#include "vtkVariant.h"
#include "vtkViewTextureLayer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace hachure
{
namespace
{
// Colours of categories are seen in this light, where marks neither vanish nor hide them.
constexpr double halfLight = 0.5;

bool isLight(int source)
{
  return source == vtkPatternTone::LIT || source == vtkPatternTone::LIT_COLOR ||
    source == vtkPatternTone::LIGHT;
}

bool isOfColors(vtkPatternTone* tone)
{
  return tone->IsSeparation() || tone->GetSource() == vtkPatternTone::LUMINANCE;
}

LegendAxis axisOf(vtkPatternTone* tone, bool colored)
{
  if (isOfColors(tone))
  {
    return colored ? LegendAxis::Color : LegendAxis::Light;
  }
  switch (tone->GetSource())
  {
    case vtkPatternTone::ARRAY:
      return LegendAxis::Array;
    case vtkPatternTone::HIGHLIGHT:
      return LegendAxis::Highlight;
    case vtkPatternTone::CONSTANT:
      return LegendAxis::Even;
    default:
      return LegendAxis::Light;
  }
}

bool sameArray(vtkPatternTone* a, vtkPatternTone* b)
{
  return a->GetSource() == vtkPatternTone::ARRAY && b->GetSource() == vtkPatternTone::ARRAY &&
    std::string(a->GetArrayName()) == b->GetArrayName() && a->GetComponent() == b->GetComponent();
}

double luma(const std::array<double, 3>& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

std::string rangeError(vtkPatternTone* tone)
{
  std::ostringstream text;
  text << "tone range of array '" << tone->GetArrayName() << "' is [" << tone->GetRange()[0] << ", "
       << tone->GetRange()[1] << "]; expected two different finite numbers";
  return text.str();
}
} // namespace

PatternLegendKey::PatternLegendKey(const LegendSurface& surface)
  : Surface(surface)
{
  if (!surface.style)
  {
    throw std::invalid_argument("no style to show; expected SetStyle, or SetSurface with an actor "
                                "that a vtkPatternMapper draws");
  }
  this->ChooseLayer();
  this->Axis = axisOf(this->Layer->GetTone(), surface.colors != nullptr);
  this->ChooseRange();
}

std::vector<vtkPatternLayer*> PatternLegendKey::layers() const
{
  std::vector<vtkPatternLayer*> drawn;
  for (int i = 0; i < this->Surface.style->GetNumberOfLayers(); ++i)
  {
    vtkPatternLayer* layer = this->Surface.style->GetLayer(i);
    if (layer->GetEnabled() && !vtkViewTextureLayer::SafeDownCast(layer))
    {
      drawn.push_back(layer);
    }
  }
  return drawn;
}

// Data say more than light, and light more than what is even.
void PatternLegendKey::ChooseLayer()
{
  const std::vector<vtkPatternLayer*> drawn = this->layers();
  if (drawn.empty())
  {
    throw std::invalid_argument(
      "the style has no layer with a tone that could be shown; expected at least one that is "
      "enabled and not made of views");
  }
  if (this->Surface.layer >= 0)
  {
    const bool exists = this->Surface.layer < this->Surface.style->GetNumberOfLayers();
    this->Layer = exists ? this->Surface.style->GetLayer(this->Surface.layer) : nullptr;
    if (std::find(drawn.begin(), drawn.end(), this->Layer) == drawn.end())
    {
      throw std::invalid_argument("the style has no layer " + std::to_string(this->Surface.layer) +
        " that could be shown; expected one that is enabled and not made of views, counted from 0");
    }
    return;
  }
  const auto rank = [this](vtkPatternLayer* layer)
  { return static_cast<int>(axisOf(layer->GetTone(), this->Surface.colors != nullptr)); };
  this->Layer = *std::min_element(drawn.begin(), drawn.end(),
    [&rank](vtkPatternLayer* a, vtkPatternLayer* b) { return rank(a) < rank(b); });
}

void PatternLegendKey::ChooseRange()
{
  if (this->Axis == LegendAxis::Array)
  {
    this->Range = { HUGE_VAL, -HUGE_VAL };
    for (vtkPatternLayer* layer : this->layers())
    {
      if (sameArray(layer->GetTone(), this->Layer->GetTone()))
      {
        const double* own = layer->GetTone()->GetRange();
        if (!std::isfinite(own[0]) || !std::isfinite(own[1]) || own[0] == own[1])
        {
          throw std::invalid_argument(rangeError(layer->GetTone()));
        }
        this->Range[0] = std::min({ this->Range[0], own[0], own[1] });
        this->Range[1] = std::max({ this->Range[1], own[0], own[1] });
      }
    }
  }
  else if (this->Axis == LegendAxis::Color)
  {
    const double* own = this->Surface.colors->GetRange();
    this->Range = { own[0], own[1] };
  }
  const std::array<double, 2>& asked = this->Surface.range;
  if (std::isfinite(asked[0]) && std::isfinite(asked[1]) && asked[0] != asked[1])
  {
    this->Range = { std::min(asked[0], asked[1]), std::max(asked[0], asked[1]) };
  }
}

std::string PatternLegendKey::arrayName() const
{
  return this->Axis == LegendAxis::Array ? this->Layer->GetTone()->GetArrayName() : std::string();
}

// Whether the colours of the surface are another look of the same values.
bool PatternLegendKey::colorsFollow() const
{
  const bool same = this->Surface.colorsAnyArray || this->Surface.colorArray == this->arrayName();
  return this->Surface.colors &&
    (this->Axis == LegendAxis::Color || (this->Axis == LegendAxis::Array && same) ||
      (this->Axis == LegendAxis::Light && this->hasColorCategories()));
}

double PatternLegendKey::LightAt(double value) const
{
  if (this->Axis != LegendAxis::Light)
  {
    return 1.0;
  }
  return this->hasColorCategories() ? halfLight : 1.0 - value;
}

std::array<double, 3> PatternLegendKey::colorAt(double value) const
{
  std::array<double, 3> color = this->Surface.color;
  if (this->colorsFollow())
  {
    double own[4] = { 1.0, 1.0, 1.0, 1.0 };
    if (this->Surface.colors->GetIndexedLookup() != 0)
    {
      this->Surface.colors->GetAnnotationColor(vtkVariant(value), own);
    }
    else
    {
      this->Surface.colors->GetColor(value, own);
    }
    color = { own[0], own[1], own[2] };
  }
  if (this->Surface.style->GetPaperSource() != vtkPatternStyle::FLAT)
  {
    for (double& component : color)
    {
      component *= this->LightAt(value);
    }
  }
  return color;
}

double PatternLegendKey::standInAt(vtkPatternTone* tone, double value) const
{
  if (tone->GetSource() == vtkPatternTone::ARRAY)
  {
    return sameArray(tone, this->Layer->GetTone()) ? value : tone->GetRange()[0];
  }
  if (tone->GetSource() == vtkPatternTone::LUMINANCE)
  {
    return 1.0 - luma(this->colorAt(value));
  }
  if (tone->GetSource() == vtkPatternTone::HIGHLIGHT)
  {
    return this->Axis == LegendAxis::Highlight ? value : 0.0;
  }
  return isLight(tone->GetSource()) ? 1.0 - this->LightAt(value) : 0.0;
}

double PatternLegendKey::toneAt(double value) const
{
  vtkPatternTone* tone = this->Layer->GetTone();
  if (tone->GetSource() == vtkPatternTone::CONSTANT)
  {
    return vtkPattern::CurvedTone(tone, tone->GetConstant());
  }
  double source = this->standInAt(tone, value);
  if (tone->GetSource() == vtkPatternTone::ARRAY)
  {
    source = (source - tone->GetRange()[0]) / (tone->GetRange()[1] - tone->GetRange()[0]);
  }
  return vtkPattern::CurvedTone(tone, std::clamp(source, 0.0, 1.0));
}

bool PatternLegendKey::ShowsColors() const
{
  const int paper = this->Surface.style->GetPaperSource();
  const std::vector<vtkPatternLayer*> drawn = this->layers();
  return paper == vtkPatternStyle::SURFACE || paper == vtkPatternStyle::FLAT ||
    std::any_of(drawn.begin(), drawn.end(),
      [](vtkPatternLayer* layer) {
        return layer->GetColorSource() == vtkPatternLayer::SURFACE || isOfColors(layer->GetTone());
      });
}

bool PatternLegendKey::hasColorCategories() const
{
  vtkScalarsToColors* colors = this->Surface.colors;
  const bool same = this->Surface.colorsAnyArray || this->Surface.colorArray == this->arrayName();
  const bool shown = this->Axis == LegendAxis::Array ? same : this->ShowsColors();
  return colors && colors->GetIndexedLookup() != 0 && colors->GetNumberOfAnnotatedValues() > 0 &&
    shown;
}

std::vector<LegendSwatch> PatternLegendKey::colorCategories() const
{
  std::vector<LegendSwatch> categories;
  for (vtkIdType i = 0; i < this->Surface.colors->GetNumberOfAnnotatedValues(); ++i)
  {
    const double value = this->Surface.colors->GetAnnotatedValue(i).ToDouble();
    categories.push_back({ value, value, this->Surface.colors->GetAnnotation(i) });
  }
  return categories;
}

std::vector<double> PatternLegendKey::toneSteps() const
{
  vtkPatternTone* tone = this->Layer->GetTone();
  std::vector<double> values;
  if (tone->GetRemap() != vtkPatternTone::STEPS || this->Axis == LegendAxis::Even ||
    isOfColors(tone))
  {
    return values;
  }
  values = { this->Range[0], this->Range[1] };
  for (int i = 1; i < tone->GetSteps(); ++i)
  {
    const double curved =
      std::pow(static_cast<double>(i) / tone->GetSteps(), 1.0 / tone->GetGamma());
    const double source = tone->GetInvert() ? 1.0 - curved : curved;
    const double* ends = tone->GetRange();
    const double value =
      this->Axis == LegendAxis::Array ? ends[0] + source * (ends[1] - ends[0]) : source;
    if (value > this->Range[0] && value < this->Range[1])
    {
      values.push_back(value);
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> roundValues(const std::array<double, 2>& range, int count)
{
  std::vector<double> values;
  const double extent = range[1] - range[0];
  if (count < 1 || !(extent > 0.0) || !std::isfinite(extent))
  {
    return values;
  }
  // A little that is lost in rounding does not count.
  const double slack = 1e-6;
  double power = std::pow(10.0, std::floor(std::log10(extent / count)) - 1.0);
  for (;; power *= 10.0)
  {
    for (const double digit : { 1.0, 2.0, 2.5, 5.0 })
    {
      const double step = digit * power;
      const double first = std::ceil(range[0] / step - slack);
      const double last = std::floor(range[1] / step + slack);
      if (last - first + 1.0 <= count)
      {
        for (double i = first; i <= last; ++i)
        {
          values.push_back(i * step + 0.0); // not -0
        }
        return values.empty() ? evenValues(range, 1) : values;
      }
    }
  }
}

std::vector<double> evenValues(const std::array<double, 2>& range, int count)
{
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
    values.push_back(range[0] + share * (range[1] - range[0]));
  }
  return values;
}

bool isNumberFormat(const std::string& format)
{
  const std::size_t begin = format.find('%');
  if (begin == std::string::npos || format.find('%', begin + 1) != std::string::npos)
  {
    return false;
  }
  const std::size_t end = format.find_first_not_of("-+ #0123456789.", begin + 1);
  const std::string between = format.substr(begin + 1, end - begin - 1);
  constexpr std::size_t longest = 8; // of flags, width and precision
  return end != std::string::npos && between.size() <= longest &&
    std::string("eEfFgG").find(format[end]) != std::string::npos;
}

std::string numberText(const std::string& format, double value)
{
  char text[512] = "";
  std::snprintf(text, sizeof(text), format.c_str(), value); // isNumberFormat() has seen it
  return text;
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ToneTable.h"

#include "Kernels.h"
#include "Parallel.h"
#include "TileChecks.h"

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{

// Places at which the drawn screen is measured: a lattice of Fibonacci numbers over the tile, which
// misses areas by far less than random places do. An odd lattice is its own image under the doubled
// coordinates of the half-size copy, so that both octaves are measured alike.
constexpr std::int64_t measuredPlaces = 28657;
constexpr std::int64_t placeStep = 17711;
// Bins of the threshold axis. Kinks are split between bins, so that the response is exact at their
// borders.
constexpr int responseBins = 2048;

// Texture filter at one mip level: bilinear, repeating. u and v in tile widths and heights, 0 to 1.
glm::vec2 bilinear(const PatternTile& tile, double u, double v)
{
  const double x =
    u * tile.width + tile.width - 0.5; // one width more, so that truncation rounds down
  const double y = v * tile.height + tile.height - 0.5;
  const int cellX = static_cast<int>(x);
  const int cellY = static_cast<int>(y);
  const float fx = static_cast<float>(x - cellX);
  const float fy = static_cast<float>(y - cellY);
  const int left = cellX % tile.width;
  const int right = left + 1 == tile.width ? 0 : left + 1;
  const std::size_t low = static_cast<std::size_t>(cellY % tile.height) * tile.width;
  const std::size_t high = static_cast<std::size_t>((cellY + 1) % tile.height) * tile.width;
  const auto filter = [&](const std::vector<float>& values)
  {
    const float below = values[low + left] + fx * (values[low + right] - values[low + left]);
    const float above = values[high + left] + fx * (values[high + right] - values[high + left]);
    return below + fy * (above - below);
  };
  return { filter(tile.screen), filter(tile.gradient) };
}

// textureLod with linear filtering between levels.
glm::vec2 trilinear(Span<const PatternTile> mips, double u, double v, float level)
{
  const float last = static_cast<float>(mips.size() - 1);
  const float clamped = std::clamp(level, 0.0f, last);
  const std::size_t lower = static_cast<std::size_t>(clamped);
  const float fraction = clamped - static_cast<float>(lower);
  const double wrappedU = u - std::floor(u);
  const double wrappedV = v - std::floor(v);
  const glm::vec2 near = bilinear(mips[lower], wrappedU, wrappedV);
  if (fraction <= 0.0f)
  {
    return near;
  }
  return glm::mix(near, bilinear(mips[lower + 1], wrappedU, wrappedV), fraction);
}

bool blendsScreens(const ToneTableOptions& options)
{
  return options.transition == LodTransition::blendScreens;
}

float blendAt(const ToneTableOptions& options, float contrast, float scale)
{
  return options.transition == LodTransition::none
    ? 0.0f
    : glsl::lodBlend(
        scale, static_cast<float>(options.lodStart), static_cast<float>(options.lodEnd), contrast);
}

// Of blended screens it does not depend on the pattern.
float screenContrast(const ToneTableOptions& options)
{
  return options.pace == LodPace::even ? 1.0f : 0.0f;
}

float transitionContrast(Span<const PatternTile> mips, const ToneTableOptions& options)
{
  if (options.pace != LodPace::even || options.transition != LodTransition::crossFade)
  {
    return screenContrast(options);
  }
  const double seen =
    options.seenTexelsPerPixel > 0.0 ? options.seenTexelsPerPixel : options.texelsPerPixelAtScale1;
  const double middle = std::sqrt(options.lodStart * options.lodEnd);
  return static_cast<float>(octaveContrast(mips, seen / middle));
}

// The levels of a tile, and which one is drawn from.
struct DrawnTile
{
  Span<const PatternTile> mips;
  float fixedLevel;

  DrawnTile(Span<const PatternTile> levels, const ToneTableOptions& options)
    : mips(levels)
    , fixedLevel(static_cast<float>(options.fixedLevel))
  {
  }
  float level(float texelsPerPixel) const
  {
    return this->fixedLevel >= 0.0f ? this->fixedLevel : glsl::tileLevel(texelsPerPixel);
  }
};

// Screen and width at a footprint, with `blend` of the half-size copy.
glm::vec2 fieldAt(const DrawnTile& tile, float texelsPerPixel, float blend, double u, double v)
{
  const glm::vec2 first =
    blend < 1.0f ? trilinear(tile.mips, u, v, tile.level(texelsPerPixel)) : glm::vec2(0.0f);
  const glm::vec2 second = blend > 0.0f
    ? trilinear(tile.mips, 2.0 * u, 2.0 * v, tile.level(2.0f * texelsPerPixel))
    : glm::vec2(0.0f);
  return glsl::patternField(first, second, blend, texelsPerPixel);
}

std::vector<glm::vec2> measureFields(const DrawnTile& tile, float texelsPerPixel, float blend)
{
  std::vector<glm::vec2> fields;
  fields.reserve(measuredPlaces);
  for (std::int64_t i = 0; i < measuredPlaces; ++i)
  {
    constexpr double share = 1.0 / measuredPlaces;
    const double u = share * static_cast<double>(i);
    const double v = share * static_cast<double>(i * placeStep % measuredPlaces);
    fields.push_back(fieldAt(tile, texelsPerPixel, blend, u, v));
  }
  return fields;
}

// Mean inkCoverage as a function of the threshold, at the borders of equal bins from `low` on.
struct Response
{
  double low = 0.0;
  double bin = 0.0;
  std::vector<double> ink;
};

// Coverage rises from 0 at screen - w/2 to 1 at screen + w/2. Such ramps add up through their
// second differences: two kinks each, whatever their length.
Response measureResponse(const std::vector<glm::vec2>& fields)
{
  constexpr double leastWidth = 1.0e-6; // as in inkCoverage
  double low = fields.front().x;
  double high = low;
  for (const glm::vec2& field : fields)
  {
    const double half = 0.5 * std::max<double>(field.y, leastWidth);
    low = std::min(low, field.x - half);
    high = std::max(high, field.x + half);
  }
  Response response{ low, (high - low) / responseBins, std::vector<double>(responseBins + 2) };
  const auto kink = [&response](double threshold, double slope)
  {
    const double at = (threshold - response.low) / response.bin;
    const int below = std::clamp(static_cast<int>(at), 0, responseBins);
    const double part = at - below;
    response.ink[below] += slope * (1.0 - part);
    response.ink[below + 1] += slope * part;
  };
  for (const glm::vec2& field : fields)
  {
    const double width = std::max<double>(field.y, leastWidth);
    kink(field.x - 0.5 * width, 1.0 / width);
    kink(field.x + 0.5 * width, -1.0 / width);
  }
  const double share = response.bin / static_cast<double>(fields.size());
  double slope = 0.0;
  double ink = 0.0;
  for (double& value : response.ink)
  {
    const double change = value;
    value = ink * share;
    slope += change;
    ink += slope;
  }
  return response;
}

// Ink at a threshold; 0 below and 1 above what was measured.
double inkAt(const Response& response, double threshold)
{
  const double at = std::clamp<double>((threshold - response.low) / response.bin, 0, responseBins);
  const int bin = std::min(static_cast<int>(at), responseBins - 1);
  return response.ink[bin] + (at - bin) * (response.ink[bin + 1] - response.ink[bin]);
}

// Thresholds that give these inks, which must ascend.
void invertResponse(const Response& response, const std::vector<double>& inks, float* threshold)
{
  int bin = 0;
  for (std::size_t i = 0; i < inks.size(); ++i)
  {
    while (bin + 1 < responseBins && response.ink[bin + 1] <= inks[i])
    {
      ++bin;
    }
    const double step = response.ink[bin + 1] - response.ink[bin];
    const double part =
      step > 0.0 ? std::clamp((inks[i] - response.ink[bin]) / step, 0.0, 1.0) : 0.0;
    threshold[i] = static_cast<float>(response.low + (bin + part) * response.bin);
  }
  // No rounding may leave ink at tone 0 or paper at tone 1.
  constexpr double margin = 1.0e-5;
  if (inks.front() <= 0.0)
  {
    threshold[0] = static_cast<float>(response.low - margin);
  }
  if (inks.back() >= 1.0)
  {
    threshold[inks.size() - 1] =
      static_cast<float>(response.low + responseBins * response.bin + margin);
  }
}

// Mean ink that each tone is to have; the tones themselves unless the look at scale 1 is kept.
std::vector<double> wantedInks(
  Span<const PatternTile> mips, const ToneTableOptions& options, int tones)
{
  std::vector<double> inks(tones);
  for (int i = 0; i < tones; ++i)
  {
    inks[i] = static_cast<double>(i) / (tones - 1);
  }
  if (options.correction == ToneCorrection::transitionOnly)
  {
    const double footprint = options.referenceTexelsPerPixel > 0.0 ? options.referenceTexelsPerPixel
                                                                   : options.texelsPerPixelAtScale1;
    const Response look =
      measureResponse(measureFields(DrawnTile(mips, options), static_cast<float>(footprint), 0.0f));
    for (double& ink : inks)
    {
      ink = inkAt(look, ink);
    }
  }
  return inks;
}

void measureRow(
  Span<const PatternTile> mips, const std::vector<double>& inks, int step, ToneTable& table)
{
  const ToneTableOptions& options = table.options;
  const auto row = static_cast<float>(step);
  const float scale = blendsScreens(options)
    ? glsl::tableScale(row, static_cast<float>(options.lodStart),
        static_cast<float>(options.lodEnd), screenContrast(options))
    : glsl::octaveScale(row);
  const float blend =
    blendsScreens(options) ? blendAt(options, screenContrast(options), scale) : 0.0f;
  const float footprint = static_cast<float>(options.texelsPerPixelAtScale1) / scale;
  invertResponse(measureResponse(measureFields(DrawnTile(mips, options), footprint, blend)), inks,
    &table.threshold[static_cast<std::size_t>(step) * table.tones]);
}

void checkArguments(
  const char* function, Span<const PatternTile> mips, const ToneTableOptions& options)
{
  if (mips.empty())
  {
    check::fail(function, "mips", "no level given");
  }
  for (const PatternTile& tile : mips)
  {
    check::tile(function, tile);
  }
  const double footprint = options.texelsPerPixelAtScale1;
  if (!(footprint > 0.0) || !std::isfinite(footprint))
  {
    check::fail(function, "texelsPerPixelAtScale1",
      std::to_string(footprint) + ", expected a positive number");
  }
  if (!(options.referenceTexelsPerPixel >= 0.0) || !std::isfinite(options.referenceTexelsPerPixel))
  {
    check::fail(function, "referenceTexelsPerPixel",
      std::to_string(options.referenceTexelsPerPixel) + ", expected a positive number or 0");
  }
  if (!(options.seenTexelsPerPixel >= 0.0) || !std::isfinite(options.seenTexelsPerPixel))
  {
    check::fail(function, "seenTexelsPerPixel",
      std::to_string(options.seenTexelsPerPixel) + ", expected a positive number or 0");
  }
  if (!std::isfinite(options.fixedLevel))
  {
    check::fail(
      function, "fixedLevel", std::to_string(options.fixedLevel) + ", expected a finite number");
  }
  check::inRange(function, "lodStart", options.lodStart, 1.0, 2.0);
  check::inRange(function, "lodEnd", options.lodEnd, options.lodStart, 2.0);
}

} // namespace

int tableRows(LodTransition transition)
{
  const bool blends = transition == LodTransition::blendScreens;
  return static_cast<int>(blends ? glsl::tableSteps : glsl::octaveSteps);
}

bool operator==(const ToneTableOptions& a, const ToneTableOptions& b)
{
  return a.texelsPerPixelAtScale1 == b.texelsPerPixelAtScale1 && a.lodStart == b.lodStart &&
    a.lodEnd == b.lodEnd && a.transition == b.transition && a.pace == b.pace &&
    a.correction == b.correction && a.referenceTexelsPerPixel == b.referenceTexelsPerPixel &&
    a.seenTexelsPerPixel == b.seenTexelsPerPixel && a.fixedLevel == b.fixedLevel;
}

ToneTable buildToneTable(Span<const PatternTile> mips, const ToneTableOptions& options)
{
  checkArguments("buildToneTable", mips, options);
  ToneTable table;
  table.options = options;
  table.steps = tableRows(options.transition);
  table.contrast = transitionContrast(mips, options);
  table.threshold.resize(static_cast<std::size_t>(table.tones) * table.steps);
  if (options.correction == ToneCorrection::off)
  {
    for (std::size_t i = 0; i < table.threshold.size(); ++i)
    {
      const auto tone = static_cast<int>(i % table.tones);
      table.threshold[i] = static_cast<float>(tone) / static_cast<float>(table.tones - 1);
    }
    return table;
  }
  const std::vector<double> inks = wantedInks(mips, options, table.tones);
  // At scale 2 the half-size copy alone is drawn, as large as the pattern at scale 1: that row is
  // the first once more, so that nothing jumps where the scale wraps.
  const int measured = blendsScreens(options) ? table.steps - 1 : table.steps;
  parallelForRanges(measured, 1,
    [&](std::int64_t step, std::int64_t)
    { measureRow(mips, inks, static_cast<int>(step), table); });
  if (blendsScreens(options))
  {
    std::copy_n(table.threshold.begin(), table.tones, table.threshold.end() - table.tones);
  }
  return table;
}

double toneThreshold(const ToneTable& table, double tone, double scale)
{
  const float column = glsl::tableColumn(static_cast<float>(tone)) * table.tones - 0.5f;
  const float along = blendsScreens(table.options)
    ? glsl::tableRow(static_cast<float>(scale), static_cast<float>(table.options.lodStart),
        static_cast<float>(table.options.lodEnd), table.contrast)
    : glsl::octaveRow(static_cast<float>(scale));
  const float row = along * table.steps - 0.5f;
  const int left = std::clamp(static_cast<int>(column), 0, table.tones - 2);
  const int low = std::clamp(static_cast<int>(row), 0, table.steps - 2);
  const double fx = std::clamp(column - left, 0.0f, 1.0f);
  const double fy = std::clamp(row - low, 0.0f, 1.0f);
  const float* below = &table.threshold[static_cast<std::size_t>(low) * table.tones + left];
  const float* above = below + table.tones;
  const double first = below[0] + fx * (below[1] - below[0]);
  const double second = above[0] + fx * (above[1] - above[0]);
  return first + fy * (second - first);
}

DrawnField drawnField(
  Span<const PatternTile> mips, const ToneTableOptions& options, double u, double v, double scale)
{
  checkArguments("drawnField", mips, options);
  const auto s = static_cast<float>(scale);
  const float blend = blendsScreens(options) ? blendAt(options, screenContrast(options), s) : 0.0f;
  const float footprint = static_cast<float>(options.texelsPerPixelAtScale1) / s;
  const glm::vec2 field = fieldAt(DrawnTile(mips, options), footprint, blend, u, v);
  return { field.x, field.y };
}

double drawnInk(Span<const PatternTile> mips, const ToneTable& table, double tone, double u,
  double v, double scale)
{
  checkArguments("drawnInk", mips, table.options);
  const auto s = static_cast<float>(scale);
  const float footprint = static_cast<float>(table.options.texelsPerPixelAtScale1) / s;
  const auto period = static_cast<float>(
    mips[0].width / (static_cast<double>(mips[0].periods) * table.options.texelsPerPixelAtScale1));
  const DrawnTile tile(mips, table.options);
  const auto ink = [&](float blend, double tableScale)
  {
    return glsl::patternInk(static_cast<float>(tone),
      static_cast<float>(toneThreshold(table, tone, tableScale)),
      fieldAt(tile, footprint, blend, u, v), glsl::flatShare(s, blend, period));
  };
  const float blend = blendAt(table.options, table.contrast, s);
  if (blendsScreens(table.options))
  {
    return ink(blend, scale);
  }
  const float first = blend < 1.0f ? ink(0.0f, scale) : 0.0f;
  const float second = blend > 0.0f ? ink(1.0f, 0.5 * scale) : 0.0f;
  return glm::mix(first, second, blend);
}

} // namespace hachure

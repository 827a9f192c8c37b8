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

// Places at which the drawn screen is measured, spread over the tile by a golden-ratio sequence
// (Roberts' R2), which misses areas by far less than random places do.
constexpr int measuredPlaces = 12000;
constexpr double placeStepU = 0.7548776662466927;
constexpr double placeStepV = 0.5698402909980532;
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

float blendAt(const ToneTableOptions& options, float scale)
{
  return options.lodBlending ? glsl::lodBlend(scale, static_cast<float>(options.lodStart),
                                 static_cast<float>(options.lodEnd))
                             : 0.0f;
}

glm::vec2 fieldAt(
  Span<const PatternTile> mips, const ToneTableOptions& options, double u, double v, float scale)
{
  const float footprint = static_cast<float>(options.texelsPerPixelAtScale1) / scale;
  const float blend = blendAt(options, scale);
  const glm::vec2 first =
    blend < 1.0f ? trilinear(mips, u, v, glsl::tileLevel(footprint)) : glm::vec2(0.0f);
  const glm::vec2 second = blend > 0.0f
    ? trilinear(mips, 2.0 * u, 2.0 * v, glsl::tileLevel(2.0f * footprint))
    : glm::vec2(0.0f);
  return glsl::patternField(first, second, blend, footprint);
}

std::vector<glm::vec2> measureFields(
  Span<const PatternTile> mips, const ToneTableOptions& options, float scale)
{
  std::vector<glm::vec2> fields;
  fields.reserve(measuredPlaces);
  for (int i = 0; i < measuredPlaces; ++i)
  {
    fields.push_back(fieldAt(mips, options, i * placeStepU, i * placeStepV, scale));
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

void invertResponse(const Response& response, float* threshold, int tones)
{
  const int last = responseBins;
  int bin = 0;
  for (int i = 0; i < tones; ++i)
  {
    const double tone = static_cast<double>(i) / (tones - 1);
    while (bin + 1 < last && response.ink[bin + 1] <= tone)
    {
      ++bin;
    }
    const double step = response.ink[bin + 1] - response.ink[bin];
    const double part = step > 0.0 ? std::clamp((tone - response.ink[bin]) / step, 0.0, 1.0) : 0.0;
    threshold[i] = static_cast<float>(response.low + (bin + part) * response.bin);
  }
  // No rounding may leave ink at tone 0 or paper at tone 1.
  const double margin = 1.0e-5;
  threshold[0] = static_cast<float>(response.low - margin);
  threshold[tones - 1] = static_cast<float>(response.low + last * response.bin + margin);
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
  check::inRange(function, "lodStart", options.lodStart, 1.0, 2.0);
  check::inRange(function, "lodEnd", options.lodEnd, options.lodStart, 2.0);
}

} // namespace

ToneTable buildToneTable(Span<const PatternTile> mips, const ToneTableOptions& options)
{
  checkArguments("buildToneTable", mips, options);
  ToneTable table;
  table.options = options;
  table.threshold.resize(static_cast<std::size_t>(table.tones) * table.steps);
  parallelForRanges(table.steps, 1,
    [&](std::int64_t step, std::int64_t)
    {
      const float scale = glsl::tableScale(static_cast<float>(step),
        static_cast<float>(options.lodStart), static_cast<float>(options.lodEnd));
      invertResponse(measureResponse(measureFields(mips, options, scale)),
        &table.threshold[step * table.tones], table.tones);
    });
  return table;
}

double toneThreshold(const ToneTable& table, double tone, double scale)
{
  const float column = glsl::tableColumn(static_cast<float>(tone)) * table.tones - 0.5f;
  const float row =
    glsl::tableRow(static_cast<float>(scale), static_cast<float>(table.options.lodStart),
      static_cast<float>(table.options.lodEnd)) *
      table.steps -
    0.5f;
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
  const glm::vec2 field = fieldAt(mips, options, u, v, static_cast<float>(scale));
  return { field.x, field.y };
}

double drawnInk(Span<const PatternTile> mips, const ToneTable& table, double tone, double u,
  double v, double scale)
{
  const DrawnField field = drawnField(mips, table.options, u, v, scale);
  const float s = static_cast<float>(scale);
  const double period =
    mips[0].width / (static_cast<double>(mips[0].periods) * table.options.texelsPerPixelAtScale1);
  const float flat = glsl::flatShare(s, blendAt(table.options, s), static_cast<float>(period));
  return glsl::patternInk(static_cast<float>(tone),
    static_cast<float>(toneThreshold(table, tone, scale)), glm::vec2(field.screen, field.width),
    flat);
}

} // namespace hachure

// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPlacement.h"

#include "Kernels.h"
#include "TileChecks.h"

#include <cmath>

namespace hachure
{
namespace
{

void requirePositive(const char* argument, double value)
{
  if (!(value > 0.0) || !std::isfinite(value))
  {
    check::fail(
      "placePattern", argument, std::to_string(value) + ", expected a positive finite number");
  }
}

// Rotated by -angle and divided by the size; whole tiles are dropped, which change nothing but cost
// digits.
glm::vec3 tileCoordinate(const glm::dvec2& axis, double size, const glm::dvec2& origin)
{
  const glm::dvec2 scaled = axis / size;
  const double offset = -glm::dot(scaled, origin);
  return { static_cast<float>(scaled.x), static_cast<float>(scaled.y),
    static_cast<float>(offset - std::floor(offset)) };
}

} // namespace

PatternPlacement placePattern(
  const PatternFrame& frame, const PlacementOptions& options, const TimedOctave* timed)
{
  requirePositive("tileSize.x", options.tileSize.x);
  requirePositive("tileSize.y", options.tileSize.y);
  const ToneTableOptions& table = options.table;
  const bool follows = table.transition != LodTransition::none;
  const PatternFrame placed = follows ? frame : PatternFrame();
  const auto start = static_cast<float>(table.lodStart);
  const auto end = static_cast<float>(table.lodEnd);
  const double length = glm::length(placed.u);
  const bool lasts = timed && table.transition == LodTransition::crossFade;
  const DrawnOctave drawn = lasts ? drawnOctave(*timed, length) : DrawnOctave();
  const float scale =
    lasts ? static_cast<float>(drawn.scale) : glsl::wrapScale(static_cast<float>(length));

  PatternPlacement placement;
  const glm::dvec2 upright = length > 0.0 ? placed.u / length : glm::dvec2(1.0, 0.0);
  const glm::dvec2 direction =
    complexProduct(upright, { std::cos(options.angle), std::sin(options.angle) });
  placement.right = tileCoordinate(direction, scale * options.tileSize.x, placed.origin);
  placement.up =
    tileCoordinate({ -direction.y, direction.x }, scale * options.tileSize.y, placed.origin);
  placement.texelsPerPixel = static_cast<float>(table.texelsPerPixelAtScale1) / scale;
  placement.blend = follows ? glsl::lodBlend(scale, start, end, options.contrast) : 0.0f;
  if (lasts)
  {
    // At the pace of the layer, of time in place of growth.
    const auto share = static_cast<float>(drawn.share);
    placement.blend = options.contrast > 0.0f ? glsl::evenBlend(share, options.contrast) : share;
  }
  if (table.transition == LodTransition::blendScreens)
  {
    placement.row = glm::vec2(glsl::tableRow(scale, start, end, options.contrast));
  }
  else
  {
    placement.row = { glsl::octaveRow(scale), glsl::octaveRow(0.5f * scale) };
  }
  placement.row *= static_cast<float>(tableRows(table.transition));
  return placement;
}

} // namespace hachure

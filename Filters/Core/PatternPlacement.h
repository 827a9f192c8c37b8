// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatternPlacement_h
#define hachure_PatternPlacement_h

#include "Similarity.h"
#include "ToneTable.h"

#include "TimedOctave.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Where a tiled pattern lies in the picture, and how its two octaves mix there: all that a pixel
// must know besides its tone (Breslav et al. 2007, sections 3.3 and 3.4).
namespace hachure
{

struct PlacementOptions
{
  // Tile at LOD scale 1, in logical pixels; > 0.
  glm::dvec2 tileSize{ 64.0, 64.0 };
  // Of the pattern in the frame, radians counter-clockwise.
  double angle = 0.0;
  // The table that thresholds are taken from. With the transition `none` the pattern stays fixed in
  // the image, whatever the frame.
  ToneTableOptions table;
  // Of that table.
  float contrast = 1.0f;
};

// Two octaves: the pattern, and its half-size copy at twice the tile coordinates.
struct PatternPlacement
{
  // Tile coordinates of a position (x, y) in logical pixels: dot(right, (x, y, 1)) and dot(up,
  // ...). They are at right angles in the picture.
  glm::vec3 right{ 0.0f, 0.0f, 0.0f };
  glm::vec3 up{ 0.0f, 0.0f, 0.0f };
  // Texels of level 0 per pixel of the framebuffer.
  float texelsPerPixel = 1.0f;
  // Weight of the second octave.
  float blend = 0.0f;
  // Where the thresholds of each octave are in the table, counted in rows from its lower edge.
  // Blended screens have one threshold: both are equal.
  glm::vec2 row{ 0.5f, 0.5f };
};

// timed: which octaves are drawn, where transitions take a time and do not go by the scale. Screens
// do not blend then. Throws std::invalid_argument where a size is not positive.
PatternPlacement placePattern(
  const PatternFrame& frame, const PlacementOptions& options, const TimedOctave* timed = nullptr);

} // namespace hachure

#endif

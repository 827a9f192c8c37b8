// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StipplePicture_h
#define hachure_StipplePicture_h

#include "NoiseSurface.h"
#include "Span.h"
#include "StippleCanvas.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace hachure
{

// How stipples look.
struct StippleLook
{
  float diameter = 2.4f; // of a grown disc, pixels; > 0
  // Stipples grow while their distances shrink by 1 + growth; > 0. See stippleGrowth.
  float growth = 0.25f;
  // Tone by the size of discs, as many as tone 1 needs of those of the diameter; otherwise by the
  // number of discs of the diameter.
  bool toneBySize = false;
};

// Throws std::invalid_argument naming what is out of its range.
void checkStippleLook(const StippleLook& look);

// What is seen of the surface in a rectangle of the framebuffer. Arrays go row by row from the
// bottom.
struct StippleScene
{
  NoiseView view;
  std::array<int, 4> rectangle{ 0, 0, 0, 0 }; // x, y, width, height
  Span<const float> depth;     // window depth, 1: nothing is there; empty: all stipples are seen
  float depthPerPixel = 1e-6f; // change of the window depth by moving away by the size of a pixel
  // Tone of every pixel, as an index of toneOf, every `toneStride` bytes; empty: the first one.
  Span<const std::uint8_t> tones;
  int toneStride = 1;
  std::array<float, 256> toneOf{}; // 0 to 1
};

struct DrawnStipple
{
  StippleDisc disc;       // pixels from the rectangle's corner
  std::int32_t node = -1; // of the tree; -1: of no tree
  std::int32_t index = 0; // of the node's points; of no tree, the rank
  float nearest = 0.0f;   // window depth: what is seen before it hides the stipple
};

// A scene, and where stipples are in it.
class StipplePicture
{
public:
  // Smaller discs are not drawn. Pixels: less than a quarter of a place of the canvas.
  static constexpr float leastRadius = 0.03f;

  // Throws std::invalid_argument naming what is out of its range. What the spans hold must stay.
  explicit StipplePicture(const StippleScene& someScene);

  // Of the matrix to clip space, for places from an origin. The picture of a small piece of surface
  // of normal n at p is n . (toViewer + turn p) / w^3 large, where the vector points to the viewer:
  // see SampleProjection.
  struct Rows
  {
    glm::vec4 x, y, z, w;
    glm::vec3 toViewer;
    float turn;
  };
  Rows rowsAt(const glm::dvec3& origin) const;

  // Of a stipple in the picture.
  struct Place
  {
    float x, y;     // pixels from the rectangle's corner
    float z;        // of clip space, over w; -1 to 1
    float facing;   // cosine of the angle of sight
    float perPixel; // area of surface; infinite where it is seen from the side
    bool isFront;
    float depth;     // window depth
    glm::vec2 slope; // of depth
    float tolerance; // of depth
  };
  // Of a point from the rows' origin; all but the depth. False before the near and behind the far
  // plane.
  static bool locate(
    const Rows& rows, const glm::vec3& from, const glm::vec3& normal, Place& place);
  // Its depth on the stipple's plane.
  void setDepth(const Rows& rows, const glm::vec3& normal, Place& place) const;

  // Index of toneOf; of the nearest pixel.
  std::size_t toneAt(float x, float y) const;
  // 0 to 1, of the four pixels around the stipple, as near as they are: where an edge passes over
  // it, it shrinks instead of going out at once.
  float visibleShare(const Place& place) const;

protected:
  StippleScene scene;
  glm::dvec4 rowX, rowY, rowZ, rowW; // to clip space; x and y in pixels from the rectangle's corner

private:
  bool isHiddenAt(int column, int row, const Place& place) const;

  double towardViewer = 1.0; // sign
};

} // namespace hachure

#endif

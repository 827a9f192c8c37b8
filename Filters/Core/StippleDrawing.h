// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleDrawing_h
#define hachure_StippleDrawing_h

#include "NoiseProjection.h"
#include "Span.h"
#include "StippleCanvas.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

// Which stipples of a surface a picture shows, and how large. All is a function of the picture
// alone, not of those before.
namespace hachure
{

// How stipples look.
struct StippleLook
{
  float diameter = 2.4f; // of a grown disc, pixels; > 0
  // Stipples grow while their distances shrink by 1 + growth; > 0. See stippleGrowth.
  float growth = 0.25f;
  // Tone by the size of discs, as many as the darkest tone needs, up to the diameter; otherwise by
  // the number of discs of that diameter.
  bool toneBySize = false;
};

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

// Stipples next to each other. A stipple comes in where so many per unit of area are wanted.
struct StippleBlock
{
  glm::dvec3 origin{ 0.0 };
  const float *x = nullptr, *y = nullptr, *z = nullptr;                   // from the origin
  const float *normalX = nullptr, *normalY = nullptr, *normalZ = nullptr; // of unit length
  const float* density = nullptr;                                         // infinite: never
  std::int32_t count = 0; // arrays go on to a multiple of 8, with infinite densities
  float held = 0.0f;      // all stipples around that come in at densities up to this are there
  bool fronts = true, backs = true; // sides of the surface that show stipples
};

struct DrawnStipple
{
  StippleDisc disc;       // pixels from the rectangle's corner
  std::int32_t index = 0; // in its block
};

class StippleDrawing
{
public:
  // Throws std::invalid_argument naming what is out of its range. What the spans hold must stay.
  StippleDrawing(const StippleScene& someScene, const StippleLook& someLook);
  StippleDrawing(const StippleDrawing&) = delete;
  StippleDrawing& operator=(const StippleDrawing&) = delete;

  // Appends the stipples that are drawn.
  void draw(const StippleBlock& block, std::vector<DrawnStipple>& drawn) const;

  // No point within the sphere wants a higher density than this; 0 where none is in the picture.
  double mostWanted(const NoiseSphere& sphere) const;

private:
  struct Rows; // what depends on a block's origin
  struct Place;
  Rows rowsAt(const glm::dvec3& origin) const;
  void tabulateCrowds();
  std::uint32_t candidates(const Rows& rows, const StippleBlock& block, std::int32_t first) const;
  bool finish(
    const Rows& rows, const StippleBlock& block, std::int32_t index, DrawnStipple& stipple) const;
  float crowdAt(std::size_t tone, float facing) const;
  std::size_t toneAt(float x, float y) const;
  float visibleShare(const Place& place) const;
  bool isHiddenAt(int column, int row, const Place& place) const;

  StippleScene scene;
  StippleLook look;
  NoiseKernelOptions reach; // of the discs, for the projection
  NoiseProjection projection;
  glm::dvec4 rowX, rowY, rowZ, rowW; // to clip space; x and y in pixels from the rectangle's corner
  double towardViewer = 1.0;         // sign
  std::size_t darkest = 0;           // of toneOf
  std::vector<float> crowds;         // stipples per pixel: of every tone, for every facing
};

} // namespace hachure

#endif

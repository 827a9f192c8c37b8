// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleDrawing_h
#define hachure_StippleDrawing_h

#include "NoiseProjection.h"
#include "Span.h"
#include "StippleCanvas.h"
#include "StippleTree.h"

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
  // Tone by the size of discs, as many as tone 1 needs of those of the diameter; otherwise by the
  // number of discs of the diameter.
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

struct DrawnStipple
{
  StippleDisc disc;       // pixels from the rectangle's corner
  std::int32_t node = 0;  // of the tree
  std::int32_t index = 0; // of the node's points
};

class StippleDrawing
{
public:
  // Throws std::invalid_argument naming what is out of its range. What the spans hold must stay.
  StippleDrawing(const StippleScene& someScene, const StippleLook& someLook);
  StippleDrawing(const StippleDrawing&) = delete;
  StippleDrawing& operator=(const StippleDrawing&) = delete;

  // No point within the sphere wants a higher density than this; 0 where none is in the picture.
  double mostWanted(const NoiseSphere& sphere) const;

  // What to draw of a node.
  struct Task
  {
    std::int32_t node = 0;
    double wanted = 0.0; // no point of it wants a higher density
    bool lacks = false;  // in places there are not as many stipples as are wanted
  };
  // Appends the stipples of a node that are drawn.
  void draw(const StippleTree& tree, const Task& task, std::vector<DrawnStipple>& drawn) const;

private:
  struct Rows; // what depends on a node's origin
  struct Place;
  Rows rowsAt(const glm::dvec3& origin) const;
  void tabulateCrowds();
  void findCellCrowds();
  float mostCrowd(const NoiseSphere& sphere) const;
  std::uint32_t candidates(const Rows& rows, const StippleNode& node, std::int32_t first) const;
  bool finish(
    const Rows& rows, const StippleTree& tree, const Task& task, DrawnStipple& stipple) const;
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
  std::size_t darkest = 0;           // row of the crowds that is most
  std::vector<float> crowds; // stipples per pixel: of every tone and of tone 1, for every facing
  // The most in every cell of the rectangle, of a surface that faces the viewer; empty: the same
  // everywhere.
  std::vector<float> cellCrowds;
  int cellColumns = 0, cellRows = 0;
};

// All stipples of the tree that are drawn, in an order that is the same for any number of threads.
// refines: makes those that are not there yet. Returns whether there were as many as wanted;
// otherwise discs are larger.
bool drawStipples(
  StippleTree& tree, const StippleDrawing& drawing, bool refines, std::vector<DrawnStipple>& drawn);

} // namespace hachure

#endif

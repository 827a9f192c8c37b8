// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleDrawing_h
#define hachure_StippleDrawing_h

#include "NoiseProjection.h"
#include "StippleCanvas.h"
#include "StipplePicture.h"
#include "StippleTree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// Which stipples of a surface a picture shows, and how large. All is a function of the picture
// alone, not of those before.
namespace hachure
{

class StippleDrawing : private StipplePicture
{
public:
  // Throws std::invalid_argument naming what is out of its range. What the spans hold must stay.
  StippleDrawing(const StippleScene& someScene, const StippleLook& someLook);
  StippleDrawing(const StippleDrawing&) = delete;
  StippleDrawing& operator=(const StippleDrawing&) = delete;

  // No point within the bounds that is seen wants a higher density than this; 0 where none is in
  // the picture, or all is hidden.
  double mostWanted(const StippleBounds& bounds) const;

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
  void tabulateCrowds();
  void findCells();
  float mostCrowd(const NoiseSphere& sphere) const;
  float nearestDepth(const NoiseSphere& sphere) const;
  double mostFacing(const StippleBounds& bounds) const;
  std::uint32_t candidates(const Rows& rows, const StippleNode& node, std::int32_t first) const;
  bool finish(
    const Rows& rows, const StippleTree& tree, const Task& task, DrawnStipple& stipple) const;
  float crowdAt(std::size_t tone, float facing) const;

  StippleLook look;
  NoiseKernelOptions reach; // of the discs, for the projection
  NoiseProjection projection;
  std::size_t darkest = 0;   // row of the crowds that is most
  std::vector<float> crowds; // stipples per pixel: of every tone and of tone 1, for every facing
  // Squares of the rectangle, row by row.
  struct Cell
  {
    float crowd = 0.0f;    // the most of a surface that faces the viewer
    float farthest = 0.0f; // window depth that is seen of the surface
  };
  std::vector<Cell> cells; // empty: the same everywhere
  int cellColumns = 0, cellRows = 0;
};

// All stipples of the tree that are drawn, in an order that is the same for any number of threads.
// refines: makes those that are not there yet. Returns whether there were as many as wanted;
// otherwise discs are larger.
bool drawStipples(
  StippleTree& tree, const StippleDrawing& drawing, bool refines, std::vector<DrawnStipple>& drawn);

} // namespace hachure

#endif
